//! Packets as a table.

use std::io::{IsTerminal, stdout};
use std::time::Duration;

use jaka_dynamic::Node;

use super::packets::{Overdue, Packet};
use crate::packets::fields::Field;
use crate::packets::value_rows::value_rows;
use crate::terminal::output;
use crate::terminal::output::ABSENT;
use crate::text::utc;

/// Table of these fields.
#[derive(Debug)]
pub(super) struct StatusTable {
    fields: Vec<Field>,
    /// Text before and after each of several tables; `None` for a single one.
    around: Option<(&'static str, &'static str)>,
}

impl StatusTable {
    /// Creates the table. Repeated tables have their times. On a terminal, each replaces the previous one.
    pub(super) fn new(fields: Vec<Field>, repeats: bool) -> Self {
        let around = match (repeats, stdout().is_terminal()) {
            (false, _) => None,
            (true, true) => Some(("\x1b[H\x1b[J", "")),
            (true, false) => Some(("", "\n")),
        };
        Self { fields, around }
    }

    /// Returns the table of a packet.
    pub(super) fn text(&self, packet: &Packet) -> String {
        let table = self.rows(&packet.tree);
        let Some((before, after)) = self.around else { return table };
        format!("{before}{}\n{table}{after}", utc::date_and_time(Duration::from_secs_f64(packet.time)))
    }

    /// Returns the text shown in place of a table while no packet is current.
    pub(super) fn without_packet(&self, overdue: &Overdue) -> String {
        let (before, after) = self.around.unwrap_or_default();
        format!("{before}{}\n{overdue}\n{after}", utc::date_and_time(Duration::from_secs_f64(overdue.time)))
    }

    fn rows(&self, packet: &Node<'_>) -> String {
        let mut rows = Vec::new();
        for field in &self.fields {
            match field.value(packet) {
                Some(value) => rows.extend(value_rows(&field.name, value)),
                None => rows.push((field.name.clone(), ABSENT.to_owned())),
            }
        }
        output::aligned(&rows)
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;
    use serde_json::json;

    use super::*;
    use crate::tests::packet;

    #[test]
    fn what_a_packet_does_not_have_is_not_a_zero() {
        let packet = packet(json!({
            "din": [0, 1, 0, 1], "dout": [], "ain": [0, 0, 0, 0, 0, 0, 0, 0, 2.5], "errmsg": "a\u{1b}b",
            "torqsensor": 5, "curr_tcp_trans_vel": -0.0001, "task_mode": 9,
        }));
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
