//! Packets as CSV.

use serde_json::Value;

use super::packets::Packet;
use crate::fields::Field;

/// The columns: those of the first packet, since a header comes but once.
#[derive(Debug)]
pub(super) enum Columns {
    /// The fields that are asked for.
    Wanted(Vec<Field>),
    /// Each of them in its parts.
    Found(Vec<Field>),
}

impl Columns {
    pub(super) fn new(fields: Vec<Field>) -> Self {
        Self::Wanted(fields)
    }

    /// A packet's line, with the header before the first. A cell is empty where the packet says nothing.
    pub(super) fn lines(&mut self, packet: &Packet) -> String {
        let mut text = String::new();
        if let Self::Wanted(fields) = self {
            let columns: Vec<_> = fields.drain(..).flat_map(|field| field.leaves(&packet.json)).collect();
            text = row("time_s".to_owned(), columns.iter().map(|column| column.name.clone()));
            *self = Self::Found(columns);
        }
        let (Self::Wanted(columns) | Self::Found(columns)) = self;
        text + &row(format!("{:.3}", packet.time), columns.iter().map(|column| cell(column.named_value(&packet.json))))
    }
}

fn row(first: String, rest: impl Iterator<Item = String>) -> String {
    let cells: Vec<_> = std::iter::once(first).chain(rest).collect();
    cells.join(",") + "\n"
}

fn cell(value: Option<Value>) -> String {
    let text = match value {
        None => return String::new(),
        Some(Value::String(text)) => text,
        Some(value) => value.to_string(),
    };
    if text.contains([',', '"', '\n', '\r']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn cells_are_quoted_where_they_must_be() {
        assert_eq!(cell(Some(json!("a,\"b\""))), "\"a,\"\"b\"\"\"");
        assert_eq!(cell(Some(json!([1, 2]))), "\"[1,2]\"");
        assert_eq!(cell(Some(json!(true))), "true");
        assert_eq!(cell(None), "");
    }
}
