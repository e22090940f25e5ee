//! Packets as CSV.

use jaka_sync::proto::text::{visible, visible_json};
use serde_json::Value;

use super::packets::Packet;
use crate::fields::Field;

/// The columns: those of the first packet, since there is only one header.
#[derive(Debug)]
pub(super) enum Columns {
    /// The fields that are asked for.
    Wanted(Vec<Field>),
    /// Each of them, divided into its parts.
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

/// Invisible characters are escaped, so that each packet is one line. A spreadsheet would take text that begins like a
/// formula for one, and run it.
fn cell(value: Option<Value>) -> String {
    let text = match value {
        None => return String::new(),
        Some(Value::String(text)) if is_formula(&text) => format!("'{}", visible(&text)),
        Some(Value::String(text)) => visible(&text).into_owned(),
        Some(value) => visible_json(&value.to_string()).into_owned(),
    };
    if text.contains([',', '"', '\n', '\r']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text }
}

fn is_formula(text: &str) -> bool {
    text.trim_start().starts_with(['=', '+', '-', '@']) && text.parse::<f64>().is_err()
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

    #[test]
    fn text_is_neither_a_formula_nor_a_line_and_numbers_stay_numbers() {
        for (text, expected) in [
            ("=cmd|' /C calc'!A0", "'=cmd|' /C calc'!A0"),
            ("@SUM(1,2)", "\"'@SUM(1,2)\""),
            (" +1+1", "' +1+1"),
            ("-", "'-"),
            ("-5.5", "-5.5"),
            ("+1e3", "+1e3"),
            ("0x10", "0x10"),
            ("a\r\n=1\u{1b}\u{202e}", r"a\r\n=1\u{1b}\u{202e}"),
        ] {
            assert_eq!(cell(Some(json!(text))), expected);
        }
        assert_eq!(cell(Some(json!(-5.5))), "-5.5");
        assert_eq!(cell(Some(json!(["\u{202e}"]))), "\"[\"\"\\u202e\"\"]\"");
    }
}
