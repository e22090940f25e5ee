//! Values into JSON.

use jaka_proto::check::AdvisoryRanges;
use jaka_spec::{EnumValue, Shape, Type};
use serde_json::Value;

use super::{Encoder, Outer, is_value};
use crate::names::same;
use crate::problem::element;
use crate::scalar;
use crate::slot::Slot;

impl Encoder<'_> {
    pub(super) fn value(&mut self, slot: &Slot<'_>, value: &Value) {
        match slot.shape {
            Shape::Scalar(scalar) => {
                let written = scalar::write(scalar, &slot.limits, self.ranges, value, &mut self.out);
                written.unwrap_or_else(|advisory| {
                    self.forbidden(slot, value);
                    self.mark(advisory);
                });
            }
            Shape::Python(_) => match value.as_str().filter(|text| slot.limits.allow_text(text)) {
                Some(text) => self.out.text(text),
                None => self.forbidden(slot, value),
            },
            Shape::List(element, len) => self.list(slot, element, value, len),
            Shape::Object(fields) => match value.as_object() {
                Some(given) => {
                    self.out.raw("{");
                    self.object(Outer::of(slot), fields, given, "");
                    self.out.raw("}");
                }
                None => self.forbidden(slot, value),
            },
            Shape::Tuple { fields, .. } => self.tuple(slot, fields, value),
            Shape::IntEnum(values) => {
                let listed = values.iter().find(|listed| is_value(value, listed.wire, &listed.name));
                if let Some(listed) = self.listed(slot, value, listed) {
                    self.out.int(listed.wire);
                }
            }
            Shape::TextEnum(values) => {
                let text = value.as_str().unwrap_or_default();
                let listed = values.iter().find(|listed| listed.wire == text);
                let listed = listed.or_else(|| values.iter().find(|listed| same(&listed.name, text)));
                if let Some(listed) = self.listed(slot, value, listed) {
                    self.out.text(&listed.wire);
                }
            }
            Shape::Choice(choice) => self.array_choice(slot, choice, value),
        }
    }
}

/// Arrays, and what is checked of a value before it is written.
impl Encoder<'_> {
    fn list(&mut self, slot: &Slot<'_>, ty: &Type, value: &Value, len: Option<usize>) {
        let Some(items) = value.as_array().filter(|items| len.is_none_or(|len| items.len() == len)) else {
            return self.forbidden(slot, value);
        };
        self.out.raw("[");
        for (index, item) in items.iter().enumerate() {
            self.out.comma();
            let place = element(slot.place, index);
            self.value(&slot.inner(&place, ty), item);
        }
        self.out.raw("]");
    }

    /// The listed value, if it may be sent.
    fn listed<'v, T>(
        &mut self,
        slot: &Slot<'_>,
        value: &Value,
        listed: Option<&'v EnumValue<T>>,
    ) -> Option<&'v EnumValue<T>> {
        let allowed = listed.filter(|listed| !listed.advisory || self.ranges == AdvisoryRanges::Ignored);
        if allowed.is_none() {
            self.forbidden(slot, value);
            self.mark(listed.is_some());
        }
        allowed
    }
}
