//! Columns of a table of packets, and its lines.

use std::time::Duration;

use itertools::Itertools as _;
use jaka_dynamic::Node;
use jaka_robot::proto::text::visible_json;
use serde_json::Value;

use crate::packets::fields::Field;
use crate::text::csv::{cell, row};

/// First columns, before those of the fields, with their units.
const FIRST: [&str; 3] = ["time (s)", "unix_time (s)", "connection"];

/// Parts of the fields, each a column with its own name.
#[derive(Debug)]
pub(super) struct Columns(Vec<(String, Field)>);

impl Columns {
    /// Creates the columns of these fields, as many as the widest packet needs.
    pub(super) fn new(fields: Vec<Field>, widest: &Node<'_>) -> Self {
        Self(fields.into_iter().flat_map(|field| field.leaves(widest)).map(|leaf| (titled(&leaf), leaf)).collect())
    }

    /// Returns the header of CSV.
    pub(super) fn header(&self) -> String {
        row(FIRST
            .map(str::to_owned)
            .into_iter()
            .chain(self.0.iter().map(|(title, _)| cell(Some(title.as_str().into())))))
    }

    /// Returns a packet as a line of CSV, after its first cells.
    pub(super) fn csv(&self, first: [String; 3], packet: &Node<'_>) -> String {
        let cells = self.0.iter().map(|(_, field)| cell(field.named_value(packet)));
        row(first.into_iter().chain(cells))
    }

    /// Returns a packet as a line of JSON.
    pub(super) fn json(&self, first: [String; 3], packet: &Node<'_>) -> String {
        let first = FIRST.into_iter().zip(first).map(|(title, text)| format!("\"{title}\":{text}"));
        let fields = self.0.iter().map(|(title, field)| {
            let value = field.named_value(packet).unwrap_or_default();
            format!("{}:{value}", Value::from(title.as_str()))
        });
        visible_json(&format!("{{{}}}\n", first.chain(fields).format(","))).into_owned()
    }
}

fn titled(field: &Field) -> String {
    match field.unit() {
        Some(unit) => format!("{} ({unit})", field.name),
        None => field.name.clone(),
    }
}

/// Formats a time with all digits of a recording.
pub(super) fn seconds(time: Duration) -> String {
    format!("{}.{:06}", time.as_secs(), time.subsec_micros())
}

/// Returns a value with the parts of both. If one of them has no parts, neither has the result: it is written as a
/// whole, so that no value is lost.
pub(super) fn wider(one: Value, other: Value) -> Value {
    match (one, other) {
        (Value::Null, value) | (value, Value::Null) => value,
        (Value::Object(mut one), Value::Object(other)) => {
            for (key, value) in other {
                let before = one.remove(&key).unwrap_or_default();
                one.insert(key, wider(before, value));
            }
            Value::Object(one)
        }
        (Value::Array(one), Value::Array(other)) => {
            let (mut longer, shorter) = if one.len() < other.len() { (other, one) } else { (one, other) };
            for (value, other) in longer.iter_mut().zip(shorter) {
                *value = wider(value.take(), other);
            }
            Value::Array(longer)
        }
        (Value::Object(_) | Value::Array(_), whole) | (whole, _) => whole,
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn the_widest_has_all_parts() {
        let packets =
            [json!({"a": [1]}), json!({"a": [1, 2], "b": {"c": 1}}), json!({"b": {"d": null, "e": 2}, "f": null})];
        let widest = packets.into_iter().fold(Value::Null, wider);
        assert_eq!(widest, json!({"a": [1, 2], "b": {"c": 1, "d": null, "e": 2}, "f": null}));
    }

    #[test]
    fn what_has_no_parts_once_is_written_as_a_whole() {
        for packets in [[json!("none"), json!([1, 2])], [json!([1, 2]), json!("none")]] {
            assert_eq!(packets.into_iter().fold(Value::Null, wider), json!("none"));
        }
    }
}
