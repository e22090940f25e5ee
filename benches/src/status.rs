//! Status packets: all of one, and one field of it.

use std::hint::black_box;

use jaka_proto::framing::Framer;
use jaka_proto::messages::status::RobotStatus;
use jaka_proto::wire::{Decode, Reader};
use serde_json::Value;

use crate::measure::{Contender, Target, Work};
use crate::{PACKET_OF_DOCUMENT, PACKET_OF_NEWER, peers};

/// Both packets: decoded in full, and for one field.
pub fn works() -> Vec<Work<'static>> {
    vec![
        full("status packet of 3.5 KB", PACKET_OF_DOCUMENT),
        full("status packet of 9 KB", PACKET_OF_NEWER),
        field("joint positions out of 3.5 KB, with framing", PACKET_OF_DOCUMENT),
        field("joint positions out of 9 KB, with framing", PACKET_OF_NEWER),
    ]
}

fn full(name: &'static str, packet: &'static str) -> Work<'static> {
    let mut status = RobotStatus::default();
    let ours = move || ours(black_box(packet), &mut status);
    Work {
        name,
        contenders: vec![
            Contender::new("ours", ours),
            Contender::new("serde, typed", || by_serde(black_box(packet))),
            Contender::new("Value, from_value", || by_value(black_box(packet))),
        ],
        targets: vec![Target::AtLeast("Value, from_value", 3.0, "ours")],
    }
}

/// Decodes a packet into the value of the one before.
///
/// # Panics
/// The packet does not fit.
pub fn ours(packet: &str, status: &mut RobotStatus) {
    status.decode_into(&mut Reader::new(packet)).expect("the packet fits");
    black_box(status);
}

fn by_serde(packet: &str) -> peers::Status {
    serde_json::from_str(packet).expect("the packet fits")
}

fn by_value(packet: &str) -> peers::Status {
    let value: Value = serde_json::from_str(packet).expect("the packet is JSON");
    serde_json::from_value(value).expect("the packet fits")
}

jaka_sync::status_subset! {
    /// A user's own choice of fields.
    pub struct Joints { joint_actual_position }
}

fn field(name: &'static str, packet: &'static str) -> Work<'static> {
    let [mut framer, mut framer_of_full, mut framer_of_serde] = [(); 3].map(|()| Framer::default());
    let ours = move || framed::<Joints>(black_box(packet), &mut framer);
    let mut status = RobotStatus::default();
    let full = move || self::ours(next(&mut framer_of_full, black_box(packet)), &mut status);
    let by_serde = move || {
        let frame = next(&mut framer_of_serde, black_box(packet));
        let joints: peers::Joints = serde_json::from_str(frame).expect("the packet fits");
        black_box(joints);
    };
    Work {
        name,
        contenders: vec![
            Contender::new("ours", ours),
            Contender::new("ours, full packet", full),
            Contender::new("serde, typed", by_serde),
        ],
        targets: vec![Target::AtMost("ours", 0.25, "ours, full packet")],
    }
}

/// The joint positions out of a packet, as it is cut out of a stream.
///
/// # Panics
/// The packet is none.
pub fn joints(packet: &str, framer: &mut Framer) -> Joints {
    framed(packet, framer)
}

fn framed<T: Decode>(packet: &str, framer: &mut Framer) -> T {
    T::decode(&mut Reader::new(next(framer, packet))).expect("the packet fits")
}

/// The packet's text, as it is cut out of a stream.
fn next<'f>(framer: &'f mut Framer, packet: &str) -> &'f str {
    framer.push(packet.as_bytes());
    let frame = framer.next_frame().expect("frames only").expect("a whole frame");
    std::str::from_utf8(frame).expect("the packet is UTF-8")
}
