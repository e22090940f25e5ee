//! The status packet.

mod extio;
mod keys;
mod last;
mod values;

use jaka_proto::wire::{Encode, Writer};
use jaka_spec::Field;
use serde_json::{Map, Value};

use crate::firmware::{Shape, Values};
use crate::json_text::{Separators, respace};
use crate::spec_index::SpecIndex;
use crate::{Firmware, ReplyStyle, State};

pub(crate) use self::last::LastPacket;

/// The packet that shows a state: the keys of the firmware, and those that packs add. A key that a user has set has the user's value.
pub(crate) fn packet(state: &State, firmware: Firmware, spec_index: &SpecIndex, set: &Map<String, Value>) -> String {
    let shape = firmware.shape();
    let values = Values::new(&spec_index.spec, ReplyStyle::of(Firmware::Document).numbers(shape.packet_numbers));
    let mut fields = keys::fields(&spec_index.spec, shape);
    let Some(length) = fields.next() else { return String::new() };
    let mut out = Writer::new();
    for field in fields {
        out.raw(",");
        out.raw(&json(&field.wire));
        out.raw(":");
        match set.get(&field.wire) {
            Some(value) => out.json(value),
            None => values.field(field, &shown(field, state, shape, spec_index), &mut out),
        }
    }
    out.raw("}");
    with_length(&format!("{{{}:", json(&length.wire)), out.as_str(), shape.separators)
}

/// What a packet shows of the state at a key, in JSON.
fn shown(field: &Field, state: &State, shape: &Shape, spec_index: &SpecIndex) -> String {
    if field.name == "extio" {
        return extio::report(&spec_index.spec, field, &state.extio, shape.extio_module_id);
    }
    let value = values::value(&field.name, state, shape).filter(|value| spec_index.fits(field, value));
    value.unwrap_or_else(|| jaka_dynamic::sample_value(&spec_index.spec, field)).to_string()
}

/// The packet's text, with its own length between its parts.
fn with_length(head: &str, tail: &str, separators: Separators) -> String {
    let [head, tail] = [head, tail].map(|part| respace(part, separators));
    let rest = head.len() + tail.len();
    let mut length = rest;
    // The length counts its own digits. It never shrinks here, so this ends.
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
    use super::*;

    #[test]
    fn the_length_counts_itself() {
        // Lengths around those at which it gets another digit, and so counts one more.
        for padding in (0..120).chain(900..1020).chain(9_900..10_020) {
            let tail = format!(",\"errmsg\":\"{}\"}}", "x".repeat(padding));
            let text = with_length("{\"len\":", &tail, Separators::Compact);
            assert!(text.starts_with(&format!("{{\"len\":{},", text.len())), "{padding}: {text}");
            let text = with_length("{\"len\":", &tail, Separators::Spaced);
            assert!(text.starts_with(&format!("{{\"len\": {}, ", text.len())), "{padding}: {text}");
        }
    }
}
