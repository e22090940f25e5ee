//! Messages in the forms of a firmware.

use std::collections::BTreeSet;

use jaka_proto::FirmwareVersion;
use jaka_proto::check::AdvisoryRanges;
use jaka_spec::{Spec, Version, Versions};
use serde_json::{Map, Value};

use crate::encode;
use crate::translation::{Lost, Message, Translated, Translation};

/// Messages of a firmware in the spec's own forms, and back.
///
/// Of a firmware that is not known, a message is read in the forms that it fits; a value that means one thing in one of
/// these and another in another is lost.
#[derive(Debug)]
pub struct Forms {
    own: Spec,
    /// The spec in the forms of the firmware; of a firmware that is not known, in each combination of forms that some
    /// firmware has.
    of_firmware: Vec<Spec>,
    is_known: bool,
}

impl Forms {
    /// Forms of a firmware; none where the spec has the same ones for all firmware.
    pub fn of(spec: &Spec, firmware: Option<FirmwareVersion>) -> Option<Self> {
        let bounds: BTreeSet<Vec<u32>> = ranges(spec).flat_map(bounds).collect();
        if bounds.is_empty() {
            return None;
        }
        let versions: Vec<_> = match firmware {
            Some(firmware) => Version::new(firmware.numbers()).into_iter().collect(),
            None => bounds.iter().filter_map(|numbers| Version::new(numbers)).collect(),
        };
        let mut of_firmware: Vec<Spec> = Vec::new();
        for version in versions {
            let spec = spec.of_firmware(&version);
            if !of_firmware.contains(&spec) {
                of_firmware.push(spec);
            }
        }
        Some(Self { own: spec.clone(), of_firmware, is_known: firmware.is_some() })
    }

    /// Translates the members of a message into the spec's own forms.
    pub fn read(&self, message: Message<'_>, members: &Map<String, Value>) -> Translated {
        let read = |spec| Translation::new(spec, &self.own).message(message, members);
        let mut readings: Vec<_> = self.of_firmware.iter().map(read).collect();
        let known = Translation::new(&self.own, &self.own).fields(message, members);
        let misfits = |reading: &Translated| {
            let is_unknown = |key: &&String| known.iter().all(|field| field.wire != **key);
            reading.lost.len() + reading.members.keys().filter(is_unknown).count()
        };
        let least = readings.iter().map(misfits).min().unwrap_or_default();
        readings.retain(|reading| misfits(reading) == least);
        let mut readings = readings.into_iter();
        let mut agreed = readings.next().unwrap_or_default();
        for other in readings {
            for field in known {
                let is_lost = agreed.lost.iter().any(|lost| lost.name == field.name);
                let differs = !is_lost && agreed.members.get(&field.wire) != other.members.get(&field.wire);
                if differs {
                    let value = agreed.members.remove(&field.wire).unwrap_or_default();
                    agreed.lost.push(Lost { name: field.name.clone(), value });
                }
            }
        }
        agreed
    }

    /// Translates the members of a message of the spec's own forms; none where the firmware is not known, or has no form
    /// of a value.
    pub fn written(&self, message: Message<'_>, members: &Map<String, Value>) -> Option<Map<String, Value>> {
        let spec = self.of_firmware.first().filter(|_| self.is_known)?;
        let translated = Translation::new(&self.own, spec).message(message, members);
        translated.lost.is_empty().then_some(translated.members)
    }

    /// The text of a reply in the spec's own forms; as it is where it is no JSON object. A value without one stays as it
    /// came.
    pub fn reply(&self, name: &str, text: &str) -> String {
        let Ok(members) = serde_json::from_str::<Map<_, _>>(text) else { return text.to_owned() };
        let Translated { mut members, lost } = self.read(Message::Reply(name), &members);
        let fields = self.own.command(name).map_or(&[][..], |command| self.own.reply_fields(command));
        for Lost { name, value } in lost {
            let field = fields.iter().find(|field| field.name == name);
            members.extend(field.map(|field| (field.wire.clone(), value)));
        }
        Value::from(members).to_string()
    }

    /// A request in the forms of the firmware, byte for byte as the generated code writes it; none where the firmware is
    /// not known, or has no form of a value. `request` is what [`request`](crate::request) has made.
    pub fn request(&self, name: &str, request: &str) -> Option<String> {
        let spec = self.of_firmware.first().filter(|_| self.is_known)?;
        let mut members: Map<_, _> = serde_json::from_str(request).ok()?;
        members.remove(jaka_spec::COMMAND_NAME);
        let members = self.written(Message::Request(name), &members)?;
        encode::request(spec, spec.command(name)?, &members, AdvisoryRanges::Ignored).ok()
    }
}

/// Firmware of all forms.
fn ranges(spec: &Spec) -> impl Iterator<Item = &Versions> {
    let in_commands = spec.commands().flat_map(jaka_spec::Command::fields);
    let in_types = spec.types().flat_map(|(_, def)| def.kind.fields());
    let forms = in_commands.chain(in_types).flat_map(|field| &field.forms).map(|form| &form.versions);
    forms.chain(spec.types().flat_map(|(_, def)| &def.forms).map(|form| &form.versions))
}

/// Numbers of versions on both sides of each end of a range.
fn bounds(versions: &Versions) -> Vec<Vec<u32>> {
    let mut bounds = vec![vec![0]];
    if let Some(since) = &versions.since {
        bounds.push(since.numbers().to_vec());
        bounds.extend(before(since.numbers()));
    }
    if let Some(until) = &versions.until {
        bounds.push(until.numbers().to_vec());
        let mut after = until.numbers().to_vec();
        if let Some(last) = after.last_mut() {
            *last = last.saturating_add(1);
        }
        bounds.push(after);
    }
    bounds
}

/// A version just before the one with these numbers.
fn before(numbers: &[u32]) -> Option<Vec<u32>> {
    let at = numbers.iter().rposition(|number| *number > 0)?;
    let mut before = numbers[..=at].to_vec();
    before[at] -= 1;
    // The greatest number that a version may have stands for all that follow.
    if before.len() < 4 {
        before.push(u32::MAX);
    }
    Some(before)
}
