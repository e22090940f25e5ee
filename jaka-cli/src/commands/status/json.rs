//! Packets as lines of JSON.

use jaka_sync::Snapshot;
use serde_json::Value;

use super::packets::unix_time;
use crate::fields::Field;

/// A packet as one line, its fields in the order in which they are asked for. A field that it does not have is null.
pub(super) fn line<S>(fields: &[Field], packet: &Snapshot<S>, json: &Value) -> String {
    let time = format!("\"time_s\":{}", unix_time(packet));
    let value = |field: &Field| field.named_value(json).unwrap_or_default();
    let entries = fields.iter().map(|field| format!("{}:{}", Value::from(&*field.name), value(field)));
    let entries: Vec<_> = std::iter::once(time).chain(entries).collect();
    format!("{{{}}}\n", entries.join(","))
}
