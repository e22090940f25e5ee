//! Conditions on status packets, as typed by people: `in_position && !protective_stop`.

mod parse;

use std::cmp::Ordering;
use std::fmt;
use std::str::FromStr;

use itertools::Itertools as _;
use jaka_dynamic::Node;
use serde_json::Value;

use crate::packets::fields::Field;
use crate::terminal::output::ABSENT;

/// Condition on a status packet.
#[derive(Debug, Clone)]
pub(crate) struct Condition {
    text: String,
    root: Expression,
}

/// Part of a condition, with kinds checked by the parser.
#[derive(Debug, Clone)]
enum Expression {
    Literal(Value),
    Field(Box<Field>),
    Not(Box<Expression>),
    And(Box<Expression>, Box<Expression>),
    Or(Box<Expression>, Box<Expression>),
    Compare(fn(Ordering) -> bool, Box<Expression>, Box<Expression>),
}

impl Condition {
    /// Whether the packet shows that the condition holds. A condition on a missing field does not hold, and neither
    /// does its negation.
    pub(crate) fn holds(&self, packet: &Node<'_>) -> bool {
        self.root.truth(packet) == Some(true)
    }

    /// Returns its fields with their values in a packet, such as `in_position false`.
    pub(crate) fn describe(&self, packet: &Node<'_>) -> String {
        let mut fields = Vec::new();
        self.root.fields(&mut fields);
        let text = |field: &&Field| {
            let value = field.named_value(packet).map_or_else(|| ABSENT.to_owned(), |value| value.to_string());
            format!("{} {value}", field.name)
        };
        fields.iter().map(text).dedup().join(", ")
    }
}

impl Expression {
    fn value(&self, packet: &Node<'_>) -> Option<Value> {
        match self {
            Self::Literal(value) => Some(value.clone()),
            Self::Field(field) => field.named_value(packet),
            _ => self.truth(packet).map(Value::from),
        }
    }

    fn truth(&self, packet: &Node<'_>) -> Option<bool> {
        match self {
            Self::Literal(_) | Self::Field(_) => self.value(packet)?.as_bool(),
            Self::Not(part) => part.truth(packet).map(|truth| !truth),
            // One of them is sufficient, regardless of the other.
            Self::And(one, other) => match (one.truth(packet), other.truth(packet)) {
                (Some(false), _) | (_, Some(false)) => Some(false),
                (one, other) => Some(one? && other?),
            },
            Self::Or(one, other) => match (one.truth(packet), other.truth(packet)) {
                (Some(true), _) | (_, Some(true)) => Some(true),
                (one, other) => Some(one? || other?),
            },
            Self::Compare(holds, one, other) => ordering(&one.value(packet)?, &other.value(packet)?).map(holds),
        }
    }

    fn fields<'e>(&'e self, found: &mut Vec<&'e Field>) {
        match self {
            Self::Literal(_) => {}
            Self::Field(field) => found.push(field),
            Self::Not(part) => part.fields(found),
            Self::And(one, other) | Self::Or(one, other) | Self::Compare(_, one, other) => {
                one.fields(found);
                other.fields(found);
            }
        }
    }
}

/// Returns `None` for values of different kinds, which the parser excludes.
fn ordering(one: &Value, other: &Value) -> Option<Ordering> {
    match (one, other) {
        (Value::Bool(one), Value::Bool(other)) => Some(one.cmp(other)),
        _ => one.as_f64()?.partial_cmp(&other.as_f64()?),
    }
}

impl FromStr for Condition {
    type Err = String;

    /// Reads a condition.
    ///
    /// # Errors
    /// The text is not a condition: the message points at the column.
    fn from_str(text: &str) -> Result<Self, String> {
        let root = parse::condition(text).map_err(|error| error.under(text))?;
        Ok(Self { text: text.to_owned(), root })
    }
}

impl fmt::Display for Condition {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

/// Error in a condition, and its position.
#[derive(Debug)]
struct Misread {
    /// Column, from 0.
    column: usize,
    text: String,
}

impl Misread {
    fn new(column: usize, text: impl Into<String>) -> Self {
        Self { column, text: text.into() }
    }

    /// Returns the message, with the condition and a mark under the position.
    fn under(&self, condition: &str) -> String {
        let Self { column, text } = self;
        if condition.trim().is_empty() {
            return text.clone();
        }
        let line = condition.replace(char::is_control, " ");
        format!("column {}: {text}\n  {line}\n  {:column$}^", column + 1, "")
    }
}

#[cfg(test)]
mod tests {
    use expect_test::{Expect, expect};
    use serde_json::json;

    use super::*;
    use crate::tests::packet;

    fn holds(condition: &str) -> bool {
        let packet = packet(json!({
            "enabled": true, "protective_stop": 0, "inpos": true, "rapidrate": 0.5, "task_state": 4,
            "joint_actual_position": [1.5, -20, 3, 4, 5, 6], "din": [0, 1],
        }));
        condition.parse::<Condition>().unwrap_or_else(|error| panic!("{error}")).holds(&packet)
    }

    #[test]
    fn conditions_hold_as_they_are_read() {
        for condition in [
            "in_position && !protective_stop",
            "inpos",
            "joint_actual_position[0] > 1 && joint_actual_position[1] <= -20",
            "task_state == 4",
            "rapid_rate >= 0.5 && rapid_rate != 1e0",
            "false || enabled && true",
            "!(protective_stop || !enabled)",
            "!!digital_inputs[1]",
            "protective_stop == false",
            "enabled != protective_stop",
            "(task_state == 3) == false",
            "1<2",
            // The known fields are sufficient.
            "enabled || emergency_stop",
        ] {
            assert!(holds(condition), "{condition}");
        }
        for condition in [
            "protective_stop",
            "task_state != 4",
            "enabled && rapid_rate > 0.5",
            "true && false || false",
            "digital_inputs[0]",
        ] {
            assert!(!holds(condition), "{condition}");
        }
    }

    #[test]
    fn what_a_packet_does_not_have_holds_in_no_way() {
        for condition in ["emergency_stop", "!emergency_stop", "tcp_speed < 1", "tcp_speed >= 1", "digital_inputs[7]"] {
            assert!(!holds(condition), "{condition}");
        }
    }

    fn check(text: &str, expected: &Expect) {
        expected.assert_eq(&text.parse::<Condition>().expect_err("it is not a condition"));
    }

    #[test]
    fn errors_point_at_the_column() {
        check(
            "enabled && in_positon",
            &expect![[r"
            column 12: there is no status field `in_positon`; similar names: `in_position`
              enabled && in_positon
                         ^"]],
        );
        check(
            "enabled & in_position",
            &expect![[r#"
            column 9: `&&` stands for "and"
              enabled & in_position
                      ^"#]],
        );
        check(
            "rapid_rate = 1",
            &expect![[r"
            column 12: `==` compares
              rapid_rate = 1
                         ^"]],
        );
        check(
            "enabled > 1",
            &expect![[r"
            column 9: a truth value and a number cannot be compared
              enabled > 1
                      ^"]],
        );
        check(
            "enabled < in_position",
            &expect![[r"
            column 9: truth values can only be compared with `==` and `!=`
              enabled < in_position
                      ^"]],
        );
        check(
            "rapid_rate",
            &expect![[r"
            column 1: this is a number: compare it, as in `rapid_rate > 0.5`
              rapid_rate
              ^"]],
        );
        check(
            "!rapid_rate",
            &expect![[r"
            column 2: this is a number: compare it, as in `rapid_rate > 0.5`
              !rapid_rate
               ^"]],
        );
        check(
            "actual_position == 1",
            &expect![[r"
            column 1: the status field `actual_position` is neither a truth value nor a number
              actual_position == 1
              ^"]],
        );
    }

    #[test]
    fn errors_of_form_do_too() {
        check(
            "(enabled",
            &expect![[r"
            column 9: expected `)`
              (enabled
                      ^"]],
        );
        check(
            "enabled)",
            &expect![[r"
            column 8: expected `&&`, `||` or the end
              enabled)
                     ^"]],
        );
        check(
            "enabled and in_position",
            &expect![[r"
            column 9: expected `&&`, `||` or the end
              enabled and in_position
                      ^"]],
        );
        check(
            "rapid_rate == 1.5.14",
            &expect![[r"
            column 15: `1.5.14` is not a number
              rapid_rate == 1.5.14
                            ^"]],
        );
        check(
            "1 < rapid_rate < 2",
            &expect![[r"
            column 16: compare two values at a time, and join comparisons with `&&`
              1 < rapid_rate < 2
                             ^"]],
        );
        check("", &expect!["expected a field, a number, `!` or `(`"]);
        check(
            "enabled §",
            &expect![[r"
            column 9: `§` is not expected here
              enabled §
                      ^"]],
        );
        let deep = "(".repeat(1000).parse::<Condition>().expect_err("it is not a condition");
        assert!(deep.starts_with("column 51: too many nested parts"), "{deep}");
    }
}
