//! Lines of CSV.

use itertools::Itertools as _;
use jaka_robot::proto::text::{visible, visible_json};
use serde_json::Value;

/// Returns a line of these cells.
pub(crate) fn row(cells: impl IntoIterator<Item = String>) -> String {
    cells.into_iter().join(",") + "\n"
}

/// Returns a value as a cell. Invisible characters are escaped, so that each packet is one line. Text that a
/// spreadsheet would run as a formula gets an apostrophe.
pub(crate) fn cell(value: Option<Value>) -> String {
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
