//! Frames in any stream, however it is cut.

use jaka_proto::framing::{FrameError, Framer};

/// What a stream was cut into.
#[derive(Debug, PartialEq, Eq)]
enum Item {
    Frame(Vec<u8>),
    Garbage,
    TooLong,
}

/// The first byte gives the longest frame, the second how the rest, the stream, is cut. The frames are the same as those of the
/// uncut stream, each byte is visited at most once, and no more is kept than the longest frame and what was read last.
///
/// # Panics
/// One of these is not so.
pub fn framing(data: &[u8]) {
    let [limit, cut, stream @ ..] = data else { return };
    let max_frame = 1 << (limit % 16);
    let whole = cut_up(max_frame, [stream]);
    let mut pieces = Pieces { rest: stream, state: u32::from(*cut) };
    assert_eq!(cut_up(max_frame, &mut pieces), whole, "in pieces");
    assert_eq!(read_in(max_frame, stream, usize::from(*cut) + 1), whole, "as off a socket");
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
fn cut_up<'s>(max_frame: usize, pieces: impl IntoIterator<Item = &'s [u8]>) -> Vec<Item> {
    let (mut framer, mut items, mut pushed) = (Framer::new(max_frame), Vec::new(), 0);
    for piece in pieces {
        framer.push(piece);
        pushed += piece.len() as u64;
        take(&mut framer, &mut items);
        assert!(framer.partial().len() <= max_frame, "more is kept than the longest frame");
        assert!(framer.visited() <= pushed, "bytes are visited twice");
    }
    items
}

/// Reads the stream as a socket is read: into the framer's room.
fn read_in(max_frame: usize, stream: &[u8], most: usize) -> Vec<Item> {
    let (mut framer, mut items) = (Framer::new(max_frame), Vec::new());
    for piece in stream.chunks(most) {
        let room = framer.spare();
        let room_len = room.len();
        room[..piece.len()].copy_from_slice(piece);
        assert!(room_len <= 2 * max_frame + (16 << 10), "the room has grown to {room_len}");
        framer.filled(piece.len());
        take(&mut framer, &mut items);
    }
    items
}

/// Takes all frames, and goes on behind errors.
fn take(framer: &mut Framer, items: &mut Vec<Item>) {
    loop {
        let item = match framer.next_frame() {
            Ok(Some(frame)) => Item::Frame(frame.to_vec()),
            Ok(None) => return,
            Err(FrameError::TooLong { .. }) => Item::TooLong,
            Err(_) => Item::Garbage,
        };
        if !matches!(item, Item::Frame(_)) {
            framer.resync();
            assert_eq!(framer.resync(), 0, "there is no error any more");
        }
        items.push(item);
    }
}
