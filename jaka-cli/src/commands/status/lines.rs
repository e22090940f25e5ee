//! Packets as lines of CSV and of JSON.

use std::iter::once;

use jaka_sync::proto::text::visible_json;
use serde_json::Value;

use super::packets::Packet;
use crate::packets::event;
use crate::packets::fields::Field;
use crate::text::csv::{cell, row};

/// Returns a packet's line, with the header before the first. The cell of a missing value is empty.
///
/// The columns are the parts of the requested fields in the first packet, since there is only one header.
pub(super) fn csv(fields: &[Field], columns: &mut Option<Vec<Field>>, packet: &Packet) -> String {
    let mut header = String::new();
    let columns = columns.get_or_insert_with(|| {
        let parts: Vec<_> = fields.iter().cloned().flat_map(|field| field.leaves(&packet.tree)).collect();
        header = row(once("time_s".to_owned()).chain(parts.iter().map(|part| part.name.clone())));
        parts
    });
    let cells = columns.iter().map(|column| cell(column.named_value(&packet.tree)));
    header + &row(once(format!("{:.3}", packet.time)).chain(cells))
}

/// Returns a packet as one line, with its fields in the requested order. A missing field is null.
///
/// Severity, meaning, cause and remedy follow the code of an event; unknown ones are null.
pub(super) fn json(fields: &[Field], packet: &Packet) -> String {
    let time = format!("\"time_s\":{}", packet.time);
    let mut entries = vec![time];
    for field in fields {
        let value = field.named_value(&packet.tree);
        let code = (field.name == event::CODE).then(|| event::read(value.as_ref()));
        entries.push(entry(&field.name, value));
        if let Some(event) = code {
            entries.push(entry("event_severity", event::severity(&event).map(|severity| severity.to_string().into())));
            entries.push(entry("event_meaning", event::meaning(&event).map(Value::from)));
            entries.push(entry("event_cause", event::cause(&event).map(|cause| cause.to_string().into())));
            entries.push(entry("event_remedy", event::remedy(&event).map(|remedy| remedy.to_string().into())));
        }
    }
    visible_json(&format!("{{{}}}\n", entries.join(","))).into_owned()
}

fn entry(name: &str, value: Option<Value>) -> String {
    format!("{}:{}", Value::from(name), value.unwrap_or_default())
}
