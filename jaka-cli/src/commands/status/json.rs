//! Packets as lines of JSON.

use serde_json::Value;

use super::packets::Packet;
use crate::fields::Field;

/// A packet as one line, its fields in the order in which they are asked for. A field that it does not have is null.
pub(super) fn line(fields: &[Field], packet: &Packet) -> String {
    let time = format!("\"time_s\":{}", packet.time);
    let value = |field: &Field| field.named_value(&packet.json).unwrap_or_default();
    let entries = fields.iter().map(|field| format!("{}:{}", Value::from(&*field.name), value(field)));
    let entries: Vec<_> = std::iter::once(time).chain(entries).collect();
    format!("{{{}}}\n", entries.join(","))
}
