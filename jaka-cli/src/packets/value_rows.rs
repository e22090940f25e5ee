//! Values of status packets as rows of a table.

use itertools::Itertools as _;
use jaka_dynamic::Node;
use jaka_robot::proto::text::visible;
use jaka_spec::Shape;
use jaka_sync::Severity;
use serde_json::Value;

use crate::packets::event;
use crate::packets::fields::leaf_text;
use crate::terminal::output::ABSENT;
use crate::text::number::fixed;

/// Greatest length of lists that are not abbreviated.
const SHORT: usize = 8;

/// Name and text of a value.
pub(crate) type Row = (String, String);

/// Returns a row for a value at a path, or one for each of its parts.
pub(crate) fn value_rows(path: &str, node: &Node<'_>) -> Vec<Row> {
    if has_rows(node) {
        let parts = node.parts().iter().filter(|part| part.is_described());
        return parts.flat_map(|part| value_rows(&part.label().path(path), part)).collect();
    }
    let text = text(path, node);
    let mut rows = Vec::new();
    if path == event::CODE {
        rows = explanation(&node.named());
    }
    let unit = node.unit().filter(|_| text != ABSENT).map(|unit| format!(" {unit}"));
    rows.insert(0, (path.to_owned(), visible(&(text + &unit.unwrap_or_default())).into_owned()));
    rows
}

/// Returns rows with the cause and the remedy of an event that is more than information.
fn explanation(code: &Value) -> Vec<Row> {
    let event = event::read(Some(code));
    if matches!(event::severity(&event), None | Some(Severity::Information)) {
        return Vec::new();
    }
    let rows = [("cause", event::cause(&event)), ("remedy", event::remedy(&event))];
    rows.into_iter().filter_map(|(name, note)| Some((format!("  {name}"), note?.to_string()))).collect()
}

/// Whether the parts of a value have their own rows: they have names, or parts themselves.
fn has_rows(node: &Node<'_>) -> bool {
    let has_parts =
        |node: &Node<'_>| matches!(node.shape(), Some(Shape::Object(_) | Shape::Tuple { .. } | Shape::List(..)));
    match node.shape() {
        Some(Shape::List(..)) => node.parts().iter().any(has_parts),
        _ => has_parts(node) && !node.is_leaf(),
    }
}

fn text(name: &str, node: &Node<'_>) -> String {
    let is_list = matches!(node.shape(), Some(Shape::List(..))) && !node.is_leaf();
    match node.named() {
        Value::Null => ABSENT.to_owned(),
        Value::Array(values) if is_list && (values.len() > SHORT || values.iter().all(Value::is_boolean)) => {
            in_short(&values)
        }
        _ if is_list => node.parts().iter().map(|part| text("", part)).join("  "),
        value if name == event::CODE => with_severity(single(node), &value),
        _ => single(node),
    }
}

fn single(node: &Node<'_>) -> String {
    leaf_text(node, |number| fixed(number, 3))
}

/// Adds severity and meaning to the code of an event.
fn with_severity(text: String, code: &Value) -> String {
    match event::describe(&event::read(Some(code))) {
        Some(description) => format!("{text} ({description})"),
        None => text,
    }
}

/// Returns an abbreviated list: its nonzero values.
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
