//! Packets of the status port.

use std::collections::BTreeSet;

use jaka_dynamic::{Node, Reading};
use jaka_proto::framing;
use jaka_proto::messages::status::RobotStatus;
use jaka_proto::wire::{Decode, DecodeError, Encode, Reader, Value, Writer};

use crate::builtin::SPEC;

/// Each line is a packet, read afresh and over the one before, with the same outcome. A packet that was read can be
/// written and read again, and comes back if no key appears twice. The model calls unreadable just what is left out.
///
/// # Panics
/// One of these is not so.
pub fn status(data: &[u8]) {
    let text = framing::text(data);
    let (mut status, mut any) = (RobotStatus::default(), Value::Null);
    for line in text.split('\n') {
        over(&mut status, line);
        over(&mut any, line);
        if let Ok((packet, _)) = read::<RobotStatus>(line) {
            again(&packet);
        }
        if let Ok(value) = serde_json::from_str(line) {
            by_the_model(&value);
        }
    }
}

/// Reads a packet, and what was left out of it.
fn read<T: Decode>(text: &str) -> Result<(T, Vec<DecodeError>), DecodeError> {
    let mut reader = Reader::new(text);
    let packet = T::decode(&mut reader)?;
    reader.end()?;
    Ok((packet, reader.take_unfit()))
}

/// Reads a value over an earlier one.
fn over<T: Decode + Clone + PartialEq + std::fmt::Debug>(value: &mut T, text: &str) {
    let mut reader = Reader::new(text);
    let found = value.decode_into(&mut reader).and_then(|()| reader.end());
    let found = found.map(|()| (value.clone(), reader.take_unfit()));
    let afresh = read::<T>(text);
    // How JSON is broken may be told in another place, of a value whose shape is not known.
    let both_fail = found.is_err() && afresh.is_err();
    assert!(both_fail || found == afresh, "{found:?} over an earlier value, {afresh:?} afresh, of {text}");
}

fn by_the_model(value: &Value) {
    let text = value.to_string();
    let packet = read::<RobotStatus>(&text);
    let unreadable = Node::status(&SPEC, value.clone())
        .departures()
        .into_iter()
        .filter(|found| found.reading == Reading::Unreadable);
    let unreadable: BTreeSet<_> = unreadable.map(|departure| rust_name(&departure.field)).collect();
    let Ok((packet, unfit)) = packet else {
        assert!(!value.is_object(), "{text}");
        return;
    };
    assert_eq!(again(&packet), packet, "{value}");
    // The model reads what nests deeper than the codec does.
    let unfit = unfit.iter().filter(|error| !error.to_string().contains("levels of nesting"));
    let unfit: BTreeSet<_> = unfit.map(|error| outermost(error.field()).to_owned()).collect();
    assert_eq!(unfit, unreadable, "{text}");
}

fn outermost(path: &str) -> &str {
    path.split(['.', '[']).next().unwrap_or_default()
}

/// The Rust name of the field with which a path on the wire begins.
fn rust_name(path: &str) -> String {
    let field = SPEC.status_fields().iter().find(|field| field.wire == outermost(path));
    field.map_or_else(|| path.to_owned(), |field| field.name.clone())
}

/// Writes a packet and reads it again.
fn again(packet: &RobotStatus) -> RobotStatus {
    let mut out = Writer::new();
    packet.encode(&mut out);
    match read(out.as_str()) {
        Ok((packet, unfit)) if unfit.is_empty() => packet,
        other => panic!("{other:?}: {}", out.as_str()),
    }
}
