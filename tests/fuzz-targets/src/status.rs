//! Packets of the status port.

use jaka_proto::messages::status::RobotStatus;
use jaka_proto::wire::{Decode, DecodeError, Encode, Reader, Writer};
use jaka_spec::json::{Reading, status_departures};
use serde_json::Value;

use crate::builtin::SPEC;

/// A packet that was read can be written and read again, and comes back if no key appears twice. The model says of a packet
/// that it is unreadable where it does not decode.
///
/// # Panics
/// One of these is not so.
pub fn status(data: &[u8]) {
    let Ok(text) = std::str::from_utf8(data) else { return };
    if let Ok(packet) = read(text) {
        again(&packet);
    }
    let Ok(value) = serde_json::from_str::<Value>(text) else { return };
    let packet = read(&value.to_string());
    if let Ok(packet) = &packet {
        assert_eq!(&again(packet), packet, "{value}");
    }
    let departures = status_departures(&SPEC, &value);
    let is_readable = departures.iter().all(|departure| departure.reading == Reading::Lenient);
    assert_eq!(is_readable, packet.is_ok(), "{departures:?} {packet:?}");
}

fn read(text: &str) -> Result<RobotStatus, DecodeError> {
    RobotStatus::decode(&mut Reader::new(text))
}

/// Writes a packet and reads it again.
fn again(packet: &RobotStatus) -> RobotStatus {
    let mut out = Writer::new();
    packet.encode(&mut out);
    read(out.as_str()).unwrap_or_else(|error| panic!("{error}: {}", out.as_str()))
}
