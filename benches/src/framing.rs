//! Finding the ends of messages in a stream that is cut anywhere.

use std::hint::black_box;

use jaka_proto::framing::Framer;

use crate::PACKET_OF_NEWER;
use crate::measure::{Contender, Work};

/// A packet in pieces as Ethernet brings them, and in single bytes.
pub fn works() -> Vec<Work<'static>> {
    let dense = Box::leak(dense().into_boxed_str());
    vec![
        work("framing 9 KB in pieces of 1460 bytes", PACKET_OF_NEWER, 1460),
        work("framing 9 KB of short keys, in pieces of 1460 bytes", dense, 1460),
        work("framing 9 KB in single bytes", PACKET_OF_NEWER, 1),
    ]
}

/// A message of nothing but keys and small numbers: the most structure that a message can have.
fn dense() -> String {
    let keys: Vec<_> = (0..600).map(|at| format!("\"key_{at:03}\":{}", at * 7 % 1000)).collect();
    format!("{{{}}}", keys.join(","))
}

fn work(name: &'static str, packet: &'static str, piece: usize) -> Work<'static> {
    let mut framer = Framer::default();
    let ours = move || ours(&mut framer, black_box(packet.as_bytes()), piece);
    Work { name, contenders: vec![Contender::new("ours", ours)], targets: Vec::new() }
}

/// Number of frames that the framer finds.
///
/// # Panics
/// The stream has bytes between its frames.
pub fn ours(framer: &mut Framer, stream: &[u8], piece: usize) -> usize {
    let mut found = 0;
    for piece in stream.chunks(piece) {
        framer.push(piece);
        while let Some(frame) = framer.next_frame().expect("frames only") {
            black_box(frame);
            found += 1;
        }
    }
    found
}
