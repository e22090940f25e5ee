//! Replies and requests as tables: fields by their names in Rust, with units.

use itertools::Itertools as _;
use jaka_dynamic::Node;
use jaka_spec::{Command, Shape, Spec};
use jaka_sync::proto::text::visible;
use jaka_sync::proto::wire::{Decode, Reader};
use serde_json::Value;

use crate::packets::fields::{leaf_text, plain};
use crate::packets::value_rows::Row;
use crate::terminal::output;
use crate::text::number::fixed;

/// Reads a reply's JSON; returns its text as a JSON string if it is not JSON, such as a bare Python tuple, or has a
/// duplicate key.
pub(crate) fn json(text: &str) -> Value {
    let mut reader = Reader::new(text);
    let value = Value::decode(&mut reader).and_then(|value| reader.end().map(|()| value));
    value.unwrap_or_else(|_| text.trim().into())
}

/// Returns a row for each field of the reply; `accepted` if it has none.
pub(super) fn table(reply: &Node<'_>) -> String {
    if reply.is_leaf() {
        return aligned(&[("reply".to_owned(), plain(&reply.found()))]);
    }
    let rows = rows(reply);
    if rows.is_empty() { "accepted\n".to_owned() } else { aligned(&rows) }
}

/// Returns a row for each field of a request.
pub(super) fn of_request(spec: &Spec, command: &Command, text: &str) -> String {
    let Value::Object(request) = json(text) else { return String::new() };
    aligned(&rows(&Node::request(spec, command, request)))
}

fn aligned(rows: &[Row]) -> String {
    // Names may come from the controller, too.
    let rows: Vec<_> = rows.iter().map(|(name, value)| (visible(name), visible(value))).collect();
    output::aligned(&rows)
}

fn rows(message: &Node<'_>) -> Vec<Row> {
    let mut rows = Vec::new();
    add_parts("", message, &mut rows);
    rows
}

/// Adds the parts, with those without a description last.
fn add_parts(place: &str, node: &Node<'_>, rows: &mut Vec<Row>) {
    let (described, others): (Vec<_>, Vec<_>) = node.parts().iter().partition(|part| part.is_described());
    for part in described.into_iter().chain(others).filter(|part| !part.is_absent()) {
        add(part.label().path(place), part, rows);
    }
}

fn add(place: String, node: &Node<'_>, rows: &mut Vec<Row>) {
    let text = match node.shape() {
        _ if !node.is_described() => format!("{} (not in the spec)", plain(&node.found())),
        Some(Shape::List(..)) if !node.is_leaf() && node.parts().is_empty() => "none".to_owned(),
        Some(Shape::List(..)) if node.parts().iter().any(|part| !part.is_nested()) => {
            with_unit(node.parts().iter().map(text).join(", "), node.unit())
        }
        _ if !node.is_leaf() => return add_parts(&place, node, rows),
        // Only numbers have units; a word in place of a list has none.
        Some(Shape::Scalar(scalar)) if scalar.is_number() => with_unit(text(node), node.unit()),
        _ => text(node),
    };
    rows.push((place, text));
}

/// Formats a single value in the spec's form, for any form of the controller; a number with up to six decimals.
fn text(node: &Node<'_>) -> String {
    leaf_text(node, |number| {
        let text = fixed(number, 6);
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    })
}

fn with_unit(text: String, unit: Option<&str>) -> String {
    match unit {
        Some(unit) => text + " " + unit,
        None => text,
    }
}
