//! Messages in the forms of a firmware.

use std::collections::BTreeSet;

use jaka_proto::FirmwareVersion;
use jaka_proto::check::AdvisoryRanges;
use jaka_proto::wire::{Decode as _, DecodeError, Reader};
use jaka_spec::{Spec, Versions};
use serde_json::{Map, Value};

use crate::encode;
use crate::firmware::firmware_range;
use crate::translation::{Lost, Message, Translated, Translation, fields};
use crate::tree::Node;

/// Translation of messages between the forms of a firmware and the spec's own.
///
/// If the firmware is not known, a message is read in the forms that it fits best; a value whose forms differ by the
/// version alone is lost.
#[derive(Debug)]
pub struct Forms {
    own: Spec,
    /// The spec in the forms of the firmware; for an unknown firmware, in each combination of forms that some firmware
    /// has.
    of_firmware: Vec<Spec>,
    is_known: bool,
}

impl Forms {
    /// Creates the forms of a firmware; `None` if the spec has the same ones for all firmware.
    pub fn of(spec: &Spec, firmware: Option<FirmwareVersion>) -> Option<Self> {
        let bounds: BTreeSet<_> = ranges(spec).flat_map(bounds).collect();
        if bounds.is_empty() {
            return None;
        }
        let versions = firmware.map_or(bounds, |firmware| BTreeSet::from([firmware]));
        let mut of_firmware: Vec<Spec> = Vec::new();
        for version in versions {
            let spec = spec.of_firmware(|versions| firmware_range(versions).contains(version));
            if !of_firmware.contains(&spec) {
                of_firmware.push(spec);
            }
        }
        Some(Self { own: spec.clone(), of_firmware, is_known: firmware.is_some() })
    }

    /// Translates the members of a message into the spec's own forms. A field that the message has under two of its
    /// keys is lost. So is a field whose forms differ by the version alone, if the version is not known.
    pub fn read(&self, message: Message<'_>, members: &Map<String, Value>) -> Translated {
        let known = fields(&self.own, message, members);
        let Some(spec) = self.fitting(message, members) else { return Translated::default() };
        let mut read = Translation::new(spec, &self.own).message(message, members);
        for field in known {
            let mut values = field.keys().filter_map(|key| members.get(key)).filter(|value| !value.is_null());
            let Some(value) = values.next() else { continue };
            let is_told = self.is_known || !self.own.is_told_by_version(field);
            let is_lost = read.lost.iter().any(|lost| lost.name == field.name);
            if !is_lost && (!is_told || values.next().is_some()) {
                read.members.remove(&field.wire);
                read.lost.push(Lost { name: field.name.clone(), value: value.clone() });
            }
        }
        read
    }

    /// Returns the combination of forms that a message fits best: the one with the fewest unknown keys and unreadable
    /// values; the first of equal ones.
    fn fitting(&self, message: Message<'_>, members: &Map<String, Value>) -> Option<&Spec> {
        if let [spec] = &*self.of_firmware {
            return Some(spec);
        }
        self.of_firmware.iter().min_by_key(|spec| {
            let fields = fields(spec, message, members);
            let is_misfit = |(key, value): &(&String, &Value)| {
                let field = fields.iter().find(|field| field.wire == **key);
                field.is_none_or(|field| !value.is_null() && !Node::field(spec, field, (*value).clone()).is_readable())
            };
            members.iter().filter(is_misfit).count()
        })
    }

    /// Translates the members of a message of the spec's own forms into those of the firmware; `None` if the firmware
    /// is not known. A value without a form stays as it is.
    pub fn written(&self, message: Message<'_>, members: &Map<String, Value>) -> Option<Map<String, Value>> {
        let spec = self.of_firmware.first().filter(|_| self.is_known)?;
        let Translated { members: mut written, lost, .. } = Translation::new(&self.own, spec).message(message, members);
        for Lost { name, value } in lost {
            let field = fields(spec, message, members).iter().find(|field| field.name == name);
            written.extend(field.map(|field| (field.wire.clone(), value)));
        }
        Some(written)
    }

    /// Returns the text of a message in the spec's own forms.
    ///
    /// # Errors
    /// The text is no JSON object, a key is repeated, or a value is in no form of the firmware.
    pub fn own_text(&self, message: Message<'_>, text: &str) -> Result<String, DecodeError> {
        let mut reader = Reader::new(text);
        let value = Value::decode(&mut reader)?;
        reader.end()?;
        let Value::Object(members) = value else { return Err(DecodeError::unfit("an object", text)) };
        let read = self.read(message, &members);
        match read.lost.into_iter().next() {
            Some(Lost { name, value }) => {
                Err(DecodeError::unfit("a value in a form of the firmware", &value.to_string()).in_field(&name))
            }
            None => Ok(Value::from(read.members).to_string()),
        }
    }

    /// Returns a request in the forms of the firmware, byte for byte as the generated code writes it; `None` if the
    /// firmware is not known, or has no form of a value. `request` is a result of [`request`](crate::request).
    pub fn request(&self, name: &str, request: &str) -> Option<String> {
        let spec = self.of_firmware.first().filter(|_| self.is_known)?;
        let mut members: Map<_, _> = serde_json::from_str(request).ok()?;
        members.remove(jaka_spec::COMMAND_NAME);
        let translated = Translation::new(&self.own, spec).message(Message::Request(name), &members);
        let members = Some(translated.members).filter(|_| translated.lost.is_empty())?;
        encode::request(spec, spec.command(name)?, &members, AdvisoryRanges::Ignored).ok()
    }
}

/// Returns the ranges of firmware of all forms.
fn ranges(spec: &Spec) -> impl Iterator<Item = &Versions> {
    let in_commands = spec.commands().flat_map(jaka_spec::Command::fields);
    let in_types = spec.types().flat_map(|(_, def)| def.kind.fields());
    let forms = in_commands.chain(in_types).flat_map(|field| &field.forms).map(|form| &form.versions);
    forms.chain(spec.types().flat_map(|(_, def)| &def.forms).map(|form| &form.versions))
}

/// Returns the first versions inside and after a range, and the lowest version.
fn bounds(versions: &Versions) -> impl Iterator<Item = FirmwareVersion> {
    let range = firmware_range(versions);
    let after = range.until.and_then(|until| {
        let (last, first) = until.numbers().split_last()?;
        FirmwareVersion::of(&[first, &[last.saturating_add(1)]].concat())
    });
    [Some(FirmwareVersion::new([0])), range.since, after].into_iter().flatten()
}
