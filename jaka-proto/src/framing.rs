//! Frames in a byte stream that is cut anywhere.
//!
//! Neither port delimits its messages: JSON objects follow one another, coalesced or in pieces, so the only
//! mark of an end is the brace that closes the object. [`Framer`] finds it and visits each byte once, however
//! the stream is cut. It checks nothing else: whether a frame is valid JSON, or UTF-8, is for its reader to say.

use std::error::Error;
use std::fmt;
use std::ops::Range;

use memchr::{memchr, memchr2, memchr3};

/// The longest frame, in bytes, that [`Framer::default`] lets pass: 1 MiB, some seventy times the longest seen.
pub const DEFAULT_MAX_FRAME: usize = 1 << 20;

/// The least room, in bytes, that [`Framer::spare`] offers.
const ROOM: usize = 8 << 10;

/// The most bytes that an [`Excerpt`] holds.
const EXCERPT: usize = 64;

/// Cuts a byte stream into frames.
///
/// A frame is a JSON object, from `{` to the matching `}`, or a Python tuple, from `(` to the matching `)`:
/// such is the reply of `get_extio_status` where no module is fitted (4.34). White space between frames is
/// skipped; any other byte there is an error.
///
/// Take frames until there is none before you read again: then memory stays below twice the longest frame
/// plus the room offered, and time is linear in the bytes received. After an error, resync or stop reading.
///
/// ```
/// use jaka_proto::framing::Framer;
///
/// let mut framer = Framer::default();
/// framer.push(br#"{"errorCode": "0"} {"errorCo"#);
/// assert_eq!(framer.next_frame()?, Some(br#"{"errorCode": "0"}"#.as_slice()));
/// assert_eq!(framer.next_frame()?, None);
///
/// framer.push(br#"de": "1"}"#);
/// assert_eq!(framer.next_frame()?, Some(br#"{"errorCode": "1"}"#.as_slice()));
/// # Ok::<(), jaka_proto::framing::FrameError>(())
/// ```
pub struct Framer {
    /// Bytes taken and given: `..start` is consumed, `start..scan` visited, `scan..end` received, `end..` room.
    buffer: Vec<u8>,
    start: usize,
    scan: usize,
    end: usize,
    state: State,
    error: Option<FrameError>,
    max_frame: usize,
    visited: u64,
}

impl Framer {
    /// Makes a framer that refuses frames longer than `max_frame` bytes.
    pub fn new(max_frame: usize) -> Self {
        Self { buffer: Vec::new(), start: 0, scan: 0, end: 0, state: State::Gap, error: None, max_frame, visited: 0 }
    }

    /// Room to read a socket into, at least 8 KiB; [`filled`](Self::filled) then says how much was read.
    pub fn spare(&mut self) -> &mut [u8] {
        self.make_room(ROOM);
        &mut self.buffer[self.end..]
    }

    /// Takes the first `n` bytes of the room that [`spare`](Self::spare) gave; more than the room counts as all of it.
    pub fn filled(&mut self, n: usize) {
        self.end = self.end.saturating_add(n).min(self.buffer.len());
    }

    /// Takes a copy of `bytes`, for callers that have received them elsewhere.
    #[inline]
    pub fn push(&mut self, bytes: &[u8]) {
        self.make_room(bytes.len());
        self.buffer[self.end..][..bytes.len()].copy_from_slice(bytes);
        self.end += bytes.len();
    }

    /// Takes the next complete frame, or says with `None` that it needs more bytes.
    ///
    /// After an error each call returns the same error, until [`resync`](Self::resync): the stream cannot be
    /// trusted any more. Frames that were complete before the error are delivered first.
    #[inline]
    pub fn next_frame(&mut self) -> Result<Option<&[u8]>, FrameError> {
        if self.error.is_none() {
            if let Some(frame) = self.find_frame() {
                return Ok(Some(&self.buffer[frame]));
            }
        }
        self.error.clone().map_or(Ok(None), Err)
    }

    /// Leaves the error state for the next `{` behind the error, and returns how many bytes it dropped at once.
    ///
    /// For streams that are only read, such as port 10000. Garbage is dropped as a whole; of a frame that is
    /// too long, all that was visited. Where the next `{` is still to come, what precedes it will be dropped
    /// as it comes. The frame found may be an object inside a broken one: its reader must expect any keys.
    /// Without an error, nothing is dropped.
    pub fn resync(&mut self) -> usize {
        if self.error.take().is_none() {
            return 0;
        }
        let dropped = self.start;
        self.start = self.scan;
        self.state = State::Lost;
        self.skip_gap();
        self.start - dropped
    }

    /// The bytes received that are not part of a frame taken yet.
    pub fn partial(&self) -> &[u8] {
        &self.buffer[self.start..self.end]
    }

    /// Whether nothing but white space was received since the last frame taken.
    pub fn is_idle(&self) -> bool {
        self.partial().iter().copied().all(is_white)
    }

    /// The number of bytes the scanner has visited so far; never more than were received.
    pub fn visited(&self) -> u64 {
        self.visited
    }

    /// Visits what was received, up to the end of the next frame or to an error, which it notes.
    fn find_frame(&mut self) -> Option<Range<usize>> {
        if !matches!(self.state, State::Frame(_)) {
            self.begin_frame();
        }
        let State::Frame(nesting) = &mut self.state else { return None };
        // Nothing is visited behind the limit, so that the outcome is the same however the stream was cut.
        let limit = self.start.saturating_add(self.max_frame);
        let window = &self.buffer[self.scan..self.end.min(limit).max(self.scan)];
        let (all, end) = (window.len(), nesting.find_end(window));
        self.visit(end.unwrap_or(all));
        if end.is_some() {
            let frame = self.start..self.scan;
            self.start = self.scan;
            self.state = State::Gap;
            return Some(frame);
        }
        if self.end > limit {
            self.error = Some(self.too_long());
        }
        None
    }

    /// Skips the gap and visits the first byte of a frame, if it has come.
    fn begin_frame(&mut self) {
        self.skip_gap();
        let form = match self.partial().first() {
            None => return,
            Some(b'{') => Form::Json,
            Some(b'(') => Form::Python,
            Some(_) => {
                self.error = Some(self.garbage());
                return;
            }
        };
        self.state = State::Frame(Nesting { form, depth: 1, quote: None, escaped: false });
        self.visit(1);
    }

    fn skip_gap(&mut self) {
        let waiting = self.partial();
        let gap = match self.state {
            State::Lost => memchr(b'{', waiting),
            State::Gap | State::Frame(_) => waiting.iter().position(|&byte| !is_white(byte)),
        };
        self.visit(gap.unwrap_or(waiting.len()));
        self.start = self.scan;
    }

    fn visit(&mut self, n: usize) {
        self.scan += n;
        self.visited += n as u64;
    }

    fn garbage(&self) -> FrameError {
        let excerpt = Excerpt::of(self.partial());
        let len = memchr(b'{', excerpt.bytes()).unwrap_or(EXCERPT);
        FrameError::Garbage { excerpt: excerpt.first(len) }
    }

    fn too_long(&self) -> FrameError {
        let limit = self.max_frame;
        // The first byte too many has been received, the next ones perhaps not.
        FrameError::TooLong { limit, excerpt: Excerpt::of(self.partial()).first(limit.saturating_add(1)) }
    }

    /// Sees to it that `room` bytes are free at the end.
    ///
    /// The rest is moved only over as many consumed bytes or more, so that moving costs linear time in all.
    #[inline]
    fn make_room(&mut self, room: usize) {
        let rest = self.end - self.start;
        let too_small = self.buffer.len() - self.end < room;
        if rest == 0 || (too_small && rest <= self.start) {
            self.buffer.copy_within(self.start..self.end, 0);
            self.scan -= self.start;
            (self.start, self.end) = (0, rest);
        }
        let needed = self.end + room;
        if self.buffer.len() < needed {
            self.grow(needed);
        }
    }

    fn grow(&mut self, needed: usize) {
        let bound = self.max_frame.saturating_mul(2).saturating_add(ROOM);
        let doubled = needed.max(self.buffer.len().saturating_mul(2));
        // Past the bound only where frames are not taken, or pushed in larger pieces than the room.
        let len = if needed <= bound { doubled.min(bound) } else { doubled };
        self.buffer.reserve_exact(len - self.buffer.len());
        self.buffer.resize(len, 0);
    }
}

impl Default for Framer {
    /// Makes a framer for frames of up to [`DEFAULT_MAX_FRAME`] bytes.
    fn default() -> Self {
        Self::new(DEFAULT_MAX_FRAME)
    }
}

impl fmt::Debug for Framer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Framer")
            .field("state", &self.state)
            .field("partial", &self.partial().len())
            .field("visited", &self.visited)
            .field("error", &self.error)
            .finish_non_exhaustive()
    }
}

/// Why a byte stream has no next frame.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum FrameError {
    /// Bytes between frames that begin none.
    Garbage {
        /// The first of them, as far as received.
        excerpt: Excerpt,
    },
    /// A frame that has not ended at the limit.
    TooLong {
        /// The limit, in bytes.
        limit: usize,
        /// How the frame begins.
        excerpt: Excerpt,
    },
}

impl fmt::Display for FrameError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Garbage { excerpt } => write!(f, "bytes that begin no frame: `{excerpt}`"),
            Self::TooLong { limit, excerpt } => write!(f, "frame longer than {limit} bytes: `{excerpt}`"),
        }
    }
}

impl Error for FrameError {}

/// Up to 64 bytes of a stream, for an error to show.
///
/// Displays printable ASCII as it is and every other byte as `\xNN`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Excerpt(Vec<u8>);

impl Excerpt {
    /// The bytes as received.
    pub fn bytes(&self) -> &[u8] {
        &self.0
    }

    fn of(bytes: &[u8]) -> Self {
        Self(bytes[..bytes.len().min(EXCERPT)].to_vec())
    }

    fn first(mut self, len: usize) -> Self {
        self.0.truncate(len);
        self
    }
}

impl fmt::Display for Excerpt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|&byte| match byte {
            b' '..=b'~' => write!(f, "{}", char::from(byte)),
            _ => write!(f, "\\x{byte:02x}"),
        })
    }
}

/// Where the scanner stands.
#[derive(Debug)]
enum State {
    /// Between frames.
    Gap,
    /// Behind an error, on the way to the next `{`.
    Lost,
    /// Behind the first byte of a frame.
    Frame(Nesting),
}

/// What the scanner remembers of the frame it is in.
#[derive(Debug)]
struct Nesting {
    form: Form,
    /// Brackets open; 0 when the frame has ended.
    depth: usize,
    /// The quote that ends the string it is in.
    quote: Option<u8>,
    /// Whether the last byte was a backslash that escapes the next.
    escaped: bool,
}

#[derive(Debug, Clone, Copy)]
enum Form {
    Json,
    Python,
}

impl Nesting {
    /// Visits the bytes that follow, up to the end of the frame: the count up to there, or `None` if all are inside.
    fn find_end(&mut self, bytes: &[u8]) -> Option<usize> {
        let mut at = 0;
        while at < bytes.len() {
            let rest = &bytes[at..];
            at += match self.quote {
                None => self.skip_structure(rest),
                Some(quote) => self.skip_string(quote, rest),
            };
            if self.depth == 0 {
                return Some(at);
            }
        }
        None
    }

    /// Visits the bytes up to the next quote or bracket, and that one.
    fn skip_structure(&mut self, bytes: &[u8]) -> usize {
        let found = match self.form {
            Form::Json => memchr3(b'"', b'{', b'}', bytes),
            Form::Python => bytes.iter().position(|byte| matches!(byte, b'"' | b'\'' | b'(' | b')')),
        };
        let Some(at) = found else { return bytes.len() };
        match bytes[at] {
            b'{' | b'(' => self.depth += 1,
            b'}' | b')' => self.depth -= 1,
            quote => self.quote = Some(quote),
        }
        at + 1
    }

    /// Visits the bytes of a string up to its end, or up to an escape and that one.
    fn skip_string(&mut self, quote: u8, bytes: &[u8]) -> usize {
        if self.escaped {
            self.escaped = false;
            return 1;
        }
        let Some(at) = memchr2(quote, b'\\', bytes) else { return bytes.len() };
        if bytes[at] == quote {
            self.quote = None;
        } else {
            self.escaped = true;
        }
        at + 1
    }
}

fn is_white(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b'\r' | b'\n')
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use serde_json::{Map, Value};

    use super::*;

    /// Documents with all that a scanner can trip over.
    const DOCUMENTS: [&[u8]; 9] = [
        b"{}",
        br#"{"errorCode": "0", "errorMsg": "", "cmdName": "get_joint_pos", "joint_pos": [1.5, -2, 0, 0, 0, 0]}"#,
        br#"{"brace": "}{", "quote": "\"}", "backslash": "\\", "both": "\\\"}\\\\"}"#,
        br#"{"a": {"b": [{"c": {}}, {}]}, "tuple": "(1, [{'a': (0, 0)}])"}"#,
        b"(0, [], {'state': 0})",
        br#"('it\'s ) "', "it's ) \" \\", (1, (')',)), {'(': "'"})"#,
        b"{\"not utf-8\": \"\xff\xfe\xc3\", \"nul\": \"\0\"}",
        "{\"错误\": \"机器人}\"}".as_bytes(),
        b"()",
    ];

    impl Framer {
        fn capacity(&self) -> usize {
            self.buffer.capacity()
        }
    }

    /// Pushes the pieces; all frames up to the first error, and the error.
    fn run<'a>(
        framer: &mut Framer,
        pieces: impl IntoIterator<Item = &'a [u8]>,
    ) -> (Vec<Vec<u8>>, Result<(), FrameError>) {
        let mut found = Vec::new();
        for piece in pieces {
            framer.push(piece);
            loop {
                match framer.next_frame() {
                    Ok(Some(frame)) => found.push(frame.to_vec()),
                    Ok(None) => break,
                    Err(error) => return (found, Err(error)),
                }
            }
        }
        (found, Ok(()))
    }

    fn split_at(stream: &[u8], at: usize) -> [&[u8]; 2] {
        [&stream[..at], &stream[at..]]
    }

    fn garbage(excerpt: &[u8]) -> FrameError {
        FrameError::Garbage { excerpt: Excerpt(excerpt.to_vec()) }
    }

    fn too_long(limit: usize, excerpt: &[u8]) -> FrameError {
        FrameError::TooLong { limit, excerpt: Excerpt(excerpt.to_vec()) }
    }

    #[test]
    fn documents_are_found_at_every_split() {
        for gap in ["", " ", "\r\n\t "] {
            let stream = [DOCUMENTS.join(gap.as_bytes()), gap.into()].concat();
            for at in 0..=stream.len() {
                let mut framer = Framer::default();
                assert_eq!(run(&mut framer, split_at(&stream, at)), (DOCUMENTS.map(Vec::from).into(), Ok(())), "{at}");
                assert!(framer.is_idle());
            }
        }
    }

    #[test]
    fn bytes_one_by_one_are_visited_once() {
        let stream = DOCUMENTS.join(b"\n".as_slice());
        let mut framer = Framer::default();
        assert_eq!(run(&mut framer, stream.chunks(1)), (DOCUMENTS.map(Vec::from).into(), Ok(())));
        assert_eq!(framer.visited(), stream.len() as u64);
    }

    #[test]
    fn a_frame_in_the_making_is_partial() {
        let mut framer = Framer::default();
        assert!(framer.is_idle());
        framer.push(b"{} {\"a\"");
        assert_eq!(framer.next_frame(), Ok(Some(b"{}".as_slice())));
        assert!(!framer.is_idle());
        assert_eq!(framer.next_frame(), Ok(None));
        assert_eq!(framer.partial(), b"{\"a\"");
        framer.push(b": 1}\n");
        assert_eq!(framer.next_frame(), Ok(Some(b"{\"a\": 1}".as_slice())));
        assert_eq!(framer.partial(), b"\n");
        assert!(framer.is_idle());
    }

    #[test]
    fn room_is_read_into_and_clamped() {
        let mut framer = Framer::default();
        assert!(framer.spare().len() >= ROOM);
        framer.spare()[..4].copy_from_slice(b"{}{}");
        framer.filled(2);
        assert_eq!(framer.next_frame(), Ok(Some(b"{}".as_slice())));
        framer.filled(2);
        assert_eq!(framer.next_frame(), Ok(Some(b"{}".as_slice())));
        framer.spare().fill(b' ');
        framer.filled(usize::MAX);
        assert_eq!(framer.next_frame(), Ok(None));
        assert!(framer.is_idle());
    }

    #[test]
    fn garbage_is_an_error_that_stays() {
        let cases: [(&[u8], &[u8]); 7] = [
            (b"\0{}", b"\0"),
            (b"}", b"}"),
            (b"[1, 2]", b"[1, 2]"),
            (b"joint_actual_position:(1,2)\n", b"joint_actual_position:(1,2)\n"),
            (b"\xef\xbb\xbf{\"a\": 1}", b"\xef\xbb\xbf"),
            (b") {} x", b") "),
            (&[b'x'; 65], &[b'x'; 64]),
        ];
        for (bytes, excerpt) in cases {
            let mut framer = Framer::default();
            let outcome = run(&mut framer, [[b"{\"first\": 1} ", bytes].concat().as_slice()]);
            assert_eq!(outcome, (vec![b"{\"first\": 1}".to_vec()], Err(garbage(excerpt))));
            framer.push(b"{}");
            assert_eq!(framer.next_frame(), Err(garbage(excerpt)));
            assert!(!framer.is_idle());
        }
    }

    #[test]
    fn errors_show_what_they_met() {
        assert_eq!(garbage(b"\0a`~\x7f\xff\n").to_string(), r"bytes that begin no frame: `\x00a`~\x7f\xff\x0a`");
        assert_eq!(too_long(9, b"{\"a\": [1,").to_string(), "frame longer than 9 bytes: `{\"a\": [1,`");
    }

    #[test]
    fn the_limit_is_the_same_at_every_split() {
        for document in DOCUMENTS.into_iter().filter(|document| document.len() > 2) {
            let len = document.len();
            let stream = [b"{} ", document, b" {}"].concat();
            for (at, limit) in (0..=stream.len()).flat_map(|at| [len - 1, len, len + 1].map(|limit| (at, limit))) {
                let (found, end) = run(&mut Framer::new(limit), split_at(&stream, at));
                if limit < len {
                    let error = too_long(limit, &document[..len.min(EXCERPT)]);
                    assert_eq!((found.len(), end), (1, Err(error)), "{at}");
                } else {
                    assert_eq!((found.len(), end), (3, Ok(())), "{at}");
                }
            }
        }
    }

    #[test]
    fn a_frame_that_does_not_end_is_too_long() {
        for limit in 0..4 {
            let mut framer = Framer::new(limit);
            let (found, end) = run(&mut framer, b"{\"aaaaaa".chunks(1));
            assert_eq!((found.len(), end), (0, Err(too_long(limit, &b"{\"aa"[..=limit]))));
            assert!(framer.visited() <= framer.partial().len() as u64);
        }
    }

    #[test]
    fn resync_goes_on_at_the_next_object() {
        let stream = b"{\"a\": 1} ?? (x) {\"b\": 2}";
        for at in 0..=stream.len() {
            let mut framer = Framer::default();
            let (mut found, mut dropped) = (Vec::new(), 0);
            for piece in split_at(stream, at) {
                let (more, end) = run(&mut framer, [piece]);
                found.extend(more);
                if end.is_err() {
                    dropped += framer.resync();
                    found.extend(run(&mut framer, [b"".as_slice()]).0);
                }
            }
            assert_eq!(found, [b"{\"a\": 1}", b"{\"b\": 2}"], "{at}");
            assert!((1..=7).contains(&dropped), "{at}");
            assert_eq!(framer.visited(), stream.len() as u64, "{at}");
            assert_eq!(framer.resync(), 0);
        }
    }

    #[test]
    fn resync_skips_a_frame_too_long() {
        for limit in [0, 1, 9, 14] {
            let mut framer = Framer::new(limit);
            let stream = b"{\"a\": \"0123456\"}{}";
            framer.push(stream);
            assert_eq!(framer.next_frame(), Err(too_long(limit, &stream[..=limit])));
            assert_eq!(framer.resync(), 16);
            assert_eq!(framer.partial(), b"{}");
            assert_eq!(framer.next_frame().is_ok(), limit >= 2);
        }
    }

    #[test]
    fn memory_is_bounded_and_time_linear() {
        const TOTAL: usize = 100_000_000;
        let max_frame = 16 << 10;
        let filler = "0, ".repeat(3_044);
        let packet = format!("{{\"len\": 9183, \"name\": \"a \\\"b\\\" {{\", \"din\": [{filler}0]}}");
        let stream = packet.repeat(2 * 1460);
        let mut framer = Framer::new(max_frame);
        let (mut sent, mut found) = (0, 0);
        for chunk in stream.as_bytes().chunks(1460).cycle().take(TOTAL / 1460) {
            framer.push(chunk);
            while framer.next_frame().expect("frames only").is_some() {
                found += 1;
            }
            sent += chunk.len();
            assert!(framer.capacity() <= 2 * max_frame + ROOM);
        }
        assert_eq!(found, sent / packet.len());
        assert_eq!(framer.visited(), sent as u64);
    }

    #[test]
    fn memory_is_bounded_when_reads_fill_the_room() {
        for max_frame in [2_usize, 100, 5_000, 70_000] {
            let packet = [b"{".as_slice(), &vec![b' '; max_frame - 2], b"}"].concat();
            let mut bytes = packet.iter().cycle();
            let mut framer = Framer::new(max_frame);
            for _ in 0..200 {
                let room = framer.spare();
                assert!(room.len() >= ROOM);
                room.fill_with(|| *bytes.next().expect("endless"));
                framer.filled(usize::MAX);
                while framer.next_frame().expect("frames only").is_some() {}
                assert!(framer.capacity() <= 2 * max_frame + ROOM);
            }
        }
    }

    fn nasty_string() -> impl Strategy<Value = String> {
        let nasty = prop::sample::select(r#"{}()[]"'\/,: u0n"#.chars().chain(['\0', '\n', '机']).collect::<Vec<_>>());
        let any = prop_oneof![4 => nasty, 1 => any::<char>()];
        prop::collection::vec(any, 0..12).prop_map(String::from_iter)
    }

    fn object() -> impl Strategy<Value = Value> {
        let leaf = prop_oneof![any::<i64>().prop_map(Value::from), nasty_string().prop_map(Value::from)];
        let value = leaf.prop_recursive(4, 24, 6, |inner| {
            prop_oneof![
                prop::collection::vec(inner.clone(), 0..6).prop_map(Value::from),
                prop::collection::vec((nasty_string(), inner), 0..6).prop_map(|entries| entries.into_iter().collect()),
            ]
        });
        prop::collection::vec((nasty_string(), value), 0..6).prop_map(|entries| Value::Object(Map::from_iter(entries)))
    }

    proptest! {
        #[test]
        fn any_objects_are_found_at_any_split(
            objects in prop::collection::vec((object(), prop::sample::select(vec!["", " ", "\r\n", "\t "])), 0..6),
            cuts in prop::collection::vec(1..40_usize, 1..20),
        ) {
            let wanted: Vec<_> = objects.iter().map(|(object, _)| object.to_string().into_bytes()).collect();
            let stream: String = objects.iter().flat_map(|(object, gap)| [gap.to_string(), object.to_string()]).collect();
            let mut rest = stream.as_bytes();
            let pieces = cuts.iter().cycle().map_while(|&cut| {
                let (piece, more) = rest.split_at(cut.min(rest.len()));
                rest = more;
                (!piece.is_empty()).then_some(piece)
            });
            let mut framer = Framer::default();
            prop_assert_eq!(run(&mut framer, pieces), (wanted, Ok(())));
            prop_assert_eq!(framer.visited(), stream.len() as u64);
        }

        #[test]
        fn any_bytes_are_visited_at_most_once(
            bytes in prop::collection::vec(prop::sample::select(b"{}()\"'\\ x\0".to_vec()), 0..200),
            cut in 1..9_usize,
        ) {
            let mut framer = Framer::new(20);
            for piece in bytes.chunks(cut) {
                framer.push(piece);
                while framer.next_frame() != Ok(None) {
                    framer.resync();
                }
            }
            prop_assert_eq!(framer.visited(), bytes.len() as u64);
        }
    }
}
