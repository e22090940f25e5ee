//! Status packet.

mod extio;
mod keys;
mod values;

use std::collections::BTreeMap;

use jaka_dynamic::counterpart;
use jaka_proto::wire::{Encode, Writer};
use jaka_spec::Field;
use serde_json::{Map, Value};

use crate::firmware::Values;
use crate::json_text::{members, respace};
use crate::spec_index::SpecIndex;
use crate::{Firmware, State};

/// Key and value in the last packet. Most are unchanged in the next packet, and writing them is most of the
/// controller's work.
#[derive(Debug, Default)]
pub(crate) struct Part {
    shown: Option<Shown>,
    text: String,
}

/// Value of a key in a packet.
#[derive(Debug, PartialEq)]
enum Shown {
    /// Value set by the user, unchanged.
    Set(Value),
    /// Value of the state, in JSON.
    State(String),
}

/// Returns the packet for a state: the keys of the firmware, and those of packs. A key set by the user has the user's
/// value.
pub(crate) fn packet(
    state: &State,
    firmware: Firmware,
    spec_index: &SpecIndex,
    set: &Map<String, Value>,
    parts: &mut Vec<Part>,
) -> String {
    let shape = firmware.shape();
    let (values, blank) = (Values::of_packets(&spec_index.spec, shape), shape.writing.blank());
    let own = json(&values::status(state, shape, spec_index.extio_report.as_ref()));
    let own = members(&own).unwrap_or_default().into_iter().collect();
    let fields = fields(spec_index, &own);
    let Some((length, fields)) = fields.split_first() else { return String::new() };
    parts.resize_with(fields.len(), Part::default);
    let mut tail = String::new();
    for (field, part) in fields.iter().zip(parts) {
        let shown = match set.get(&field.wire) {
            Some(value) => Shown::Set(value.clone()),
            None => Shown::State(shown(field, &own, spec_index)),
        };
        if part.shown.as_ref() != Some(&shown) {
            part.text = respace(&written(field, &shown, values), blank);
            part.shown = Some(shown);
        }
        tail.push_str(&part.text);
    }
    tail.push('}');
    with_length(&respace(&format!("{{{}:", json(&length.wire)), blank), &tail)
}

/// Returns the fields that the firmware sends, `own` by the built-in spec, and those added by packs last. Packs may
/// have renamed them.
fn fields<'s>(spec_index: &'s SpecIndex, own: &BTreeMap<String, &str>) -> Vec<&'s Field> {
    let is_sent = |field: &&Field| own.contains_key(&field.wire);
    let fields = spec_index.spec.status_fields();
    let Some(built_in) = spec_index.without_packs() else {
        return keys::in_order(&spec_index.spec).filter(is_sent).collect();
    };
    let sent = keys::in_order(built_in).filter(is_sent);
    let known = sent.filter_map(|field| counterpart(field, built_in.status_fields(), fields));
    let is_added = |field: &&Field| counterpart(field, fields, built_in.status_fields()).is_none();
    known.chain(fields.iter().filter(is_added)).collect()
}

/// Returns a key and its value, after a comma.
fn written(field: &Field, shown: &Shown, values: Values<'_>) -> String {
    let mut out = Writer::new();
    match shown {
        Shown::Set(value) => out.json(value),
        Shown::State(json) => values.field(field, json, &mut out),
    }
    format!(",{}:{}", json(&field.wire), out.as_str())
}

/// Returns the value of the state for a key of packets, in JSON; `own` has the values of all keys by the built-in spec.
fn shown(field: &Field, own: &BTreeMap<String, &str>, spec_index: &SpecIndex) -> String {
    let value = spec_index.status_value(field, |wire| own.get(wire).copied());
    value.unwrap_or_else(|| jaka_dynamic::sample_value(&spec_index.spec, field).to_string())
}

/// Returns the packet's text, with its own length between its parts.
fn with_length(head: &str, tail: &str) -> String {
    let rest = head.len() + tail.len();
    let mut length = rest;
    // The length counts its own digits. It never shrinks here, so the loop ends.
    while rest + length.to_string().len() != length {
        length = rest + length.to_string().len();
    }
    format!("{head}{length}{tail}")
}

fn json(value: &impl Encode) -> String {
    let mut out = Writer::new();
    value.encode(&mut out);
    out.into_string()
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn newer_firmware_sends_each_key_of_the_spec_once() {
        let spec_index = SpecIndex::open(&[]).expect("the spec is correct");
        let state = State::initial(&spec_index, &jaka_motion::Model::default()).expect("the spec has examples");
        let packet = packet(&state, Firmware::Newer, &spec_index, &Map::new(), &mut Vec::new());
        let sent: Vec<_> = members(&packet).expect("it is an object").into_iter().map(|(key, _)| key).collect();
        let known: BTreeSet<_> = spec_index.spec.status_fields().iter().map(|field| field.wire.clone()).collect();
        assert_eq!((sent.iter().cloned().collect::<BTreeSet<_>>(), sent.len()), (known.clone(), known.len()));
    }

    #[test]
    fn the_length_counts_itself() {
        // Lengths around those at which the length has another digit, and so counts one more.
        for padding in (0..120).chain(900..1020).chain(9_900..10_020) {
            let text = with_length("{\"len\":", &format!(",\"errmsg\":\"{}\"}}", "x".repeat(padding)));
            assert!(text.starts_with(&format!("{{\"len\":{},", text.len())), "{padding}: {text}");
        }
    }
}
