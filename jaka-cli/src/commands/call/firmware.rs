//! The check of a request against the controller's firmware.

use std::fmt::Display;

use jaka_spec::{Command, EnumValue, Field, Request as Body, Shape, Spec, Type, Versions};
use jaka_sync::{Client, Error, FirmwareRange, FirmwareVersion, NotInFirmware};
use serde_json::Value;

use super::request::Request;
use crate::failure::Failure;

/// Asks the controller for its version, and refuses what that firmware does not have.
pub(super) fn check(client: &mut Client, spec: &Spec, request: &Request<'_>) -> Result<(), Failure> {
    let firmware = client.check_firmware()?;
    let Some(command) = request.command else { return Ok(()) };
    match missing(spec, command, &request.text, firmware) {
        Some(missing) => Err(Error::from(missing).into()),
        None => Ok(()),
    }
}

fn missing(spec: &Spec, command: &Command, request: &str, firmware: FirmwareVersion) -> Option<NotInFirmware> {
    let own = range(&command.versions);
    if !own.contains(firmware) {
        return Some(NotInFirmware::new(&command.wire, None, firmware, own));
    }
    let body: Value = serde_json::from_str(request).unwrap_or_default();
    let given: Vec<_> = match &command.request {
        Body::Fields(fields) => keyed(fields, &body).collect(),
        Body::Choice(choice) => {
            let tag = body.get(&choice.tag).and_then(Value::as_i64);
            let variant = choice.variants.iter().find(|variant| Some(variant.wire) == tag);
            variant.iter().flat_map(|variant| keyed(&variant.fields, &body)).collect()
        }
    };
    let check = FirmwareCheck { spec, command, firmware };
    given.into_iter().find_map(|(field, value)| check.field("", field, value))
}

fn range(versions: &Versions) -> FirmwareRange {
    let version =
        |version: &Option<jaka_spec::Version>| version.as_ref().and_then(|version| version.to_string().parse().ok());
    FirmwareRange { since: version(&versions.since), until: version(&versions.until) }
}

/// The fields that an object has, with their values.
fn keyed<'v>(fields: &'v [Field], object: &'v Value) -> impl Iterator<Item = (&'v Field, &'v Value)> {
    fields.iter().filter_map(|field| Some((field, object.get(&field.wire)?)))
}

struct FirmwareCheck<'s> {
    spec: &'s Spec,
    command: &'s Command,
    firmware: FirmwareVersion,
}

impl FirmwareCheck<'_> {
    /// The first field that the firmware does not have: this one, or one inside it.
    fn field(&self, outer: &str, field: &Field, value: &Value) -> Option<NotInFirmware> {
        let place = if outer.is_empty() { field.name.clone() } else { format!("{outer}.{}", field.name) };
        let range = range(&field.versions);
        if !range.contains(self.firmware) {
            return Some(NotInFirmware::new(&self.command.wire, Some(place), self.firmware, range));
        }
        self.value(&place, &field.ty, value)
    }

    fn value(&self, place: &str, ty: &Type, value: &Value) -> Option<NotInFirmware> {
        match self.spec.shape(ty) {
            Shape::List(element, _) => {
                let mut elements = value.as_array()?.iter().enumerate();
                elements.find_map(|(index, value)| self.value(&format!("{place}[{index}]"), element, value))
            }
            Shape::Object(fields) => keyed(fields, value).find_map(|(field, value)| self.field(place, field, value)),
            Shape::Tuple { fields, .. } => {
                fields.iter().zip(value.as_array()?).find_map(|(field, value)| self.field(place, field, value))
            }
            Shape::IntEnum(values) => self.listed(place, values, |wire| Some(*wire) == value.as_i64()),
            Shape::TextEnum(values) => self.listed(place, values, |wire| Some(wire.as_str()) == value.as_str()),
            Shape::Scalar(_) | Shape::Python(_) | Shape::Choice(_) => None,
        }
    }

    /// The value of an enum, if the firmware does not have it.
    fn listed<T: Display>(
        &self,
        place: &str,
        values: &[EnumValue<T>],
        is_it: impl Fn(&T) -> bool,
    ) -> Option<NotInFirmware> {
        let listed = values.iter().find(|listed| is_it(&listed.wire))?;
        let range = Some(range(&listed.versions)).filter(|range| !range.contains(self.firmware))?;
        let missing = NotInFirmware::new(&self.command.wire, Some(place.to_owned()), self.firmware, range);
        Some(missing.with_value(listed.wire.to_string()))
    }
}
