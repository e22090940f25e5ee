//! Packets as a table.

use std::io::{IsTerminal, stdout};
use std::time::Duration;

use itertools::Itertools as _;
use jaka_robot::proto::text::visible;
use serde_json::Value;

use super::packets::{Overdue, Packet};
use crate::event;
use crate::fields::{Field, Shape};
use crate::number::fixed;
use crate::output::{self, ABSENT};
use crate::utc;

/// Lists with more values than this are abbreviated.
const SHORT: usize = 8;

/// A table of these fields.
#[derive(Debug)]
pub(super) struct StatusTable {
    fields: Vec<Field>,
    /// What comes before and after each of several tables; none if there is only one.
    around: Option<(&'static str, &'static str)>,
}

impl StatusTable {
    /// Several tables have their times. On a terminal, each replaces the one before it.
    pub(super) fn new(fields: Vec<Field>, repeats: bool) -> Self {
        let around = match (repeats, stdout().is_terminal()) {
            (false, _) => None,
            (true, true) => Some(("\x1b[H\x1b[J", "")),
            (true, false) => Some(("", "\n")),
        };
        Self { fields, around }
    }

    /// The table of a packet.
    pub(super) fn text(&self, packet: &Packet) -> String {
        let table = self.rows(&packet.json);
        let Some((before, after)) = self.around else { return table };
        format!("{before}{}\n{table}{after}", utc::date_and_time(Duration::from_secs_f64(packet.time)))
    }

    /// What takes the place of a table where no packet is there that tells the present.
    pub(super) fn without_packet(&self, overdue: &Overdue) -> String {
        let (before, after) = self.around.unwrap_or_default();
        format!("{before}{}\n{overdue}\n{after}", utc::date_and_time(Duration::from_secs_f64(overdue.time)))
    }

    fn rows(&self, packet: &Value) -> String {
        let mut rows = Vec::new();
        for field in &self.fields {
            add(field, packet, &mut rows);
        }
        output::aligned(&rows)
    }
}

/// Adds a row for the field, or for each of its parts.
fn add(field: &Field, packet: &Value, rows: &mut Vec<(String, String)>) {
    let parts = field.parts(packet);
    let single = field.value(packet).is_none() || field.is_other(packet) || parts.is_empty();
    if single || field.shape() != Shape::Nested {
        rows.push((field.name.clone(), visible(&with_unit(field, packet)).into_owned()));
        return;
    }
    for part in &parts {
        add(part, packet, rows);
    }
}

fn with_unit(field: &Field, packet: &Value) -> String {
    let text = text(field, packet);
    match &field.unit {
        Some(unit) if text != ABSENT => format!("{text} {unit}"),
        _ => text,
    }
}

fn text(field: &Field, packet: &Value) -> String {
    match (field.named_value(packet), field.shape()) {
        (None, _) => ABSENT.to_owned(),
        (Some(Value::Array(values)), Shape::List) if values.len() > SHORT || values.iter().all(Value::is_boolean) => {
            in_short(&values)
        }
        (Some(Value::Array(_)), Shape::List) => field.parts(packet).iter().map(|part| text(part, packet)).join("  "),
        (Some(value), _) if field.name == event::CODE => with_severity(single(field, &value), &value),
        (Some(value), _) => single(field, &value),
    }
}

/// The code of an event with its severity and meaning.
fn with_severity(text: String, code: &Value) -> String {
    match event::describe(&event::read(Some(code))) {
        Some(description) => format!("{text} ({description})"),
        None => text,
    }
}

fn single(field: &Field, value: &Value) -> String {
    match value {
        Value::Number(number) if field.is_float() => {
            number.as_f64().map_or_else(|| number.to_string(), |number| fixed(number, 3))
        }
        Value::String(text) => output::cell(text).into_owned(),
        _ => field.value_name(value).map_or_else(|| value.to_string(), |name| format!("{name} ({value})")),
    }
}

/// An abbreviated list: its values that are not zero.
fn in_short(values: &[Value]) -> String {
    let count = values.len();
    if count == 0 {
        return "none".to_owned();
    }
    if values.iter().all(Value::is_boolean) {
        let on = values.iter().positions(|value| *value == Value::Bool(true)).join(" ");
        return if on.is_empty() { format!("{count}, all off") } else { format!("{count}, on: {on}") };
    }
    let other = values.iter().enumerate().filter(|(_, value)| value.as_f64() != Some(0.0));
    let other = other.map(|(index, value)| format!("[{index}] {value}")).join(" ");
    if other.is_empty() { format!("{count}, all 0") } else { format!("{count}, not 0: {other}") }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;
    use serde_json::json;

    use super::*;

    #[test]
    fn what_a_packet_does_not_have_is_not_a_zero() {
        let packet = json!({
            "din": [0, 1, 0, 1], "dout": [], "ain": [0, 0, 0, 0, 0, 0, 0, 0, 2.5], "errmsg": "a\u{1b}b",
            "torqsensor": 5, "curr_tcp_trans_vel": -0.0001, "task_mode": 9,
        });
        let names = ["din", "dout", "ain", "aout", "errmsg", "torqsensor", "enabled", "tcp_speed", "task_mode"];
        let fields = names.map(|name| Field::find(name).unwrap()).to_vec();
        expect![[r#"
            digital_inputs   4, on: 1 3
            digital_outputs  none
            analog_inputs    9, not 0: [8] 2.5
            analog_outputs   –
            error_message    "a\u{1b}b"
            torque_sensor    5
            enabled          –
            tcp_speed        0.000 mm/s
            task_mode        9
        "#]]
        .assert_eq(&StatusTable::new(fields, false).rows(&packet));
    }
}
