//! Packets as lines of CSV and of JSON.

use std::iter::once;

use jaka_sync::proto::text::visible_json;
use serde_json::Value;

use super::packets::Packet;
use crate::packets::event;
use crate::packets::fields::Field;
use crate::text::csv::{cell, row};

/// Columns: those of the first packet, since there is only one header.
#[derive(Debug)]
pub(super) enum LineColumns {
    /// Requested fields.
    Wanted(Vec<Field>),
    /// Requested fields, divided into their parts.
    Found(Vec<Field>),
}

impl LineColumns {
    pub(super) fn new(fields: Vec<Field>) -> Self {
        Self::Wanted(fields)
    }

    /// Returns a packet's line, with the header before the first. The cell of a missing value is empty.
    pub(super) fn lines(&mut self, packet: &Packet) -> String {
        let mut text = String::new();
        if let Self::Wanted(fields) = self {
            let columns: Vec<_> = fields.drain(..).flat_map(|field| field.leaves(&packet.tree)).collect();
            text = row(once("time_s".to_owned()).chain(columns.iter().map(|column| column.name.clone())));
            *self = Self::Found(columns);
        }
        let (Self::Wanted(columns) | Self::Found(columns)) = self;
        let cells = columns.iter().map(|column| cell(column.named_value(&packet.tree)));
        text + &row(once(format!("{:.3}", packet.time)).chain(cells))
    }
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
