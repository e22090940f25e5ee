//! Frames in any stream, however it is cut.

use jaka_proto::framing::{FrameError, Framer};

/// Part of a stream, as the framer finds it.
#[derive(Debug, PartialEq, Eq)]
enum Item {
    Frame(Vec<u8>),
    Garbage,
    TooLong,
    Cut,
}

/// The first byte gives the longest frame, the second how the rest, the stream, is cut. The frames are the same as
/// those of the uncut stream, each byte is visited at most once, and no more is kept than the longest frame and what
/// was read last. The same holds for status packets, of which the complete ones are found after any that breaks off.
///
/// # Panics
/// One of these is not so.
pub fn framing(data: &[u8]) {
    let [limit, cut, stream @ ..] = data else { return };
    let max_frame = 1 << (limit % 16);
    for new in [Framer::new, Framer::for_status] {
        let whole = cut_up(new(max_frame), max_frame, [stream]);
        let pieces = Pieces { rest: stream, state: u32::from(*cut) };
        assert_eq!(cut_up(new(max_frame), max_frame, pieces), whole, "in pieces");
        assert_eq!(read_in(new(max_frame), max_frame, stream, usize::from(*cut) + 1), whole, "as off a socket");
    }
    behind_a_cut(stream);
}

/// Two packets after any bytes: the second is found, and the first too unless a value may stand where the bytes end.
fn behind_a_cut(before: &[u8]) {
    const PACKETS: [&[u8]; 2] = [br#"{"len": 30, "first": "\"{\\"}"#, br#"{"len": 17, "n": 2}"#];
    let mut framer = Framer::for_status(1 << 20);
    framer.push(before);
    take(&mut framer, &mut Vec::new());
    let mut items = Vec::new();
    for packet in PACKETS {
        framer.push(packet);
        take(&mut framer, &mut items);
    }
    let found = |packet: &[u8]| items.iter().any(|item| matches!(item, Item::Frame(frame) if frame == packet));
    assert!(found(PACKETS[1]), "{items:?}");
    let may_follow = before.trim_ascii_end().last().is_some_and(|last| b":,[".contains(last));
    assert!(found(PACKETS[0]) || may_follow, "{items:?}");
}

/// Pieces of changing length, which the state gives.
struct Pieces<'s> {
    rest: &'s [u8],
    state: u32,
}

impl<'s> Iterator for Pieces<'s> {
    type Item = &'s [u8];

    fn next(&mut self) -> Option<&'s [u8]> {
        if self.rest.is_empty() {
            return None;
        }
        self.state = self.state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let len = (self.state >> 24) as usize % 23;
        let (piece, rest) = self.rest.split_at(len.min(self.rest.len()));
        self.rest = rest;
        Some(piece)
    }
}

/// Pushes the pieces.
fn cut_up<'s>(mut framer: Framer, max_frame: usize, pieces: impl IntoIterator<Item = &'s [u8]>) -> Vec<Item> {
    let (mut items, mut pushed) = (Vec::new(), 0);
    for piece in pieces {
        framer.push(piece);
        pushed += piece.len() as u64;
        take(&mut framer, &mut items);
        // What may be the beginning of a packet is kept too.
        assert!(framer.partial().len() <= max_frame.max(5), "more is kept than the longest frame");
        assert!(framer.visited() <= pushed, "bytes are visited twice");
    }
    items
}

/// Reads the stream as a socket is read: into the framer's room.
fn read_in(mut framer: Framer, max_frame: usize, stream: &[u8], most: usize) -> Vec<Item> {
    let mut items = Vec::new();
    for piece in stream.chunks(most) {
        let room = framer.spare();
        let room_len = room.len();
        room[..piece.len()].copy_from_slice(piece);
        assert!(room_len <= 2 * max_frame.max(5) + (16 << 10), "the room has grown to {room_len}");
        framer.filled(piece.len());
        take(&mut framer, &mut items);
    }
    items
}

/// Takes all frames, and continues after errors.
fn take(framer: &mut Framer, items: &mut Vec<Item>) {
    loop {
        let item = match framer.next_frame() {
            Ok(Some(frame)) => Item::Frame(frame.to_vec()),
            Ok(None) => return,
            Err(FrameError::TooLong { .. }) => Item::TooLong,
            Err(FrameError::Cut { .. }) => Item::Cut,
            Err(_) => Item::Garbage,
        };
        if !matches!(item, Item::Frame(_)) {
            framer.resync();
            assert_eq!(framer.resync(), 0, "there is no error any more");
        }
        items.push(item);
    }
}
