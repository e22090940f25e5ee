//! Frames in a byte stream that is cut anywhere.
//!
//! Neither port delimits its messages: JSON objects follow one another, coalesced or in pieces, so the only
//! mark of an end is the brace that closes the object. [`Framer`] finds it and visits each byte once, however
//! the stream is cut. It checks nothing else: whether a frame is valid JSON, or UTF-8, is for its reader to say.

mod error;
mod nesting;
#[cfg(test)]
mod tests;
mod text;

use std::fmt;
use std::ops::Range;

use memchr::{memchr, memmem};

use self::error::EXCERPT;
pub use self::error::{Excerpt, FrameError};
use self::nesting::{Form, Nesting, Scanned};
pub use self::text::text;

/// The longest frame, in bytes, that [`Framer::default`] lets pass: 1 MiB, some seventy times the longest seen.
pub const DEFAULT_MAX_FRAME: usize = 1 << 20;
/// The least room, in bytes, that [`Framer::spare`] offers.
const ROOM: usize = 8 << 10;

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
    stream: Stream,
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

/// Kind of messages that a stream carries.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Stream {
    Replies,
    Status,
}

impl Framer {
    /// Makes a framer that refuses frames longer than `max_frame` bytes.
    pub fn new(max_frame: usize) -> Self {
        Self::with_stream(max_frame, Stream::Replies)
    }

    /// Makes a framer for status packets, which finds the next one after a packet that was cut.
    ///
    /// A cut packet does not end: whatever follows would stand inside it. So `{"len"`, with which each packet begins,
    /// is a [`Cut`](FrameError::Cut) where no JSON has it: inside a string, or after something that no object can
    /// follow. [`resync`](Self::resync) then goes on there. An object inside a packet that begins so is left in peace;
    /// a packet after one that was cut where an object may stand is lost with it. Text in a packet is not taken for it,
    /// since quotes are escaped there.
    ///
    /// ```
    /// use jaka_proto::framing::{FrameError, Framer};
    ///
    /// let mut framer = Framer::for_status(1000);
    /// framer.push(br#"{"len": 40, "errmsg": "cut he{"len": 27, "enabled": true}"#);
    /// assert!(matches!(framer.next_frame(), Err(FrameError::Cut { .. })));
    /// assert_eq!(framer.resync(), 29);
    /// assert_eq!(framer.next_frame()?, Some(br#"{"len": 27, "enabled": true}"#.as_slice()));
    /// # Ok::<(), FrameError>(())
    /// ```
    pub fn for_status(max_frame: usize) -> Self {
        Self::with_stream(max_frame, Stream::Status)
    }

    /// Buffer to read a socket into, at least 8 KiB; [`filled`](Self::filled) then takes the number of bytes read.
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
        let fits = self.end != self.start && self.buffer.len() - self.end >= bytes.len();
        if !fits {
            self.make_room(bytes.len());
        }
        self.buffer[self.end..][..bytes.len()].copy_from_slice(bytes);
        self.end += bytes.len();
    }

    /// Takes the next complete frame, or says with `None` that it needs more bytes.
    ///
    /// After an error each call returns the same error, until [`resync`](Self::resync): the stream cannot be
    /// trusted any more. Frames that were complete before the error are delivered first.
    #[inline]
    pub fn next_frame(&mut self) -> Result<Option<&[u8]>, FrameError> {
        if self.is_inside_after_one_byte() {
            return Ok(None);
        }
        if self.error.is_none() {
            if let Some(frame) = self.find_frame() {
                return Ok(Some(&self.buffer[frame]));
            }
        }
        match &self.error {
            None => Ok(None),
            Some(error) => Err(error.clone()),
        }
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

    /// Leaves the error state for the next `{` after the error, and returns the number of bytes dropped at once.
    ///
    /// For streams that are only read, such as port 10000. Drops garbage as a whole; of a frame that is too long, all
    /// visited bytes; of a cut frame, the bytes before the next one. If the next `{` is still to come, the bytes before
    /// it will be dropped on arrival: [`lost`](Self::lost) has their number. A framer [for status
    /// packets](Self::for_status) continues at `{"len"`; the frame of another framer may be an object inside a broken
    /// one, so its reader must expect any keys. Without an error, nothing is dropped.
    pub fn resync(&mut self) -> usize {
        let Some(error) = self.error.take() else { return 0 };
        let dropped = self.start;
        self.start = self.scan;
        self.state = match (error, &self.state) {
            // Its brace was taken for a part of a string that did not end.
            (FrameError::Cut { .. }, State::Frame(Nesting { quote: Some(_), .. })) => {
                self.start -= 1;
                State::Frame(Nesting::new(Form::Status))
            }
            (FrameError::Cut { .. }, _) => State::Gap,
            _ => State::Lost,
        };
        if matches!(self.state, State::Lost) {
            self.skip_gap();
        }
        self.start - dropped
    }

    /// The bytes received that the next call of [`next_frame`](Self::next_frame) drops, while the next packet is
    /// searched for.
    pub fn lost(&self) -> &[u8] {
        let len = if matches!(self.state, State::Lost) { self.lost_len() } else { 0 };
        &self.partial()[..len]
    }

    fn with_stream(max_frame: usize, stream: Stream) -> Self {
        let state = State::Gap;
        Self { stream, buffer: Vec::new(), start: 0, scan: 0, end: 0, state, error: None, max_frame, visited: 0 }
    }

    /// Visits the one byte that has come, if it is one and changes nothing: so it is for most where bytes come one by
    /// one.
    #[inline]
    fn is_inside_after_one_byte(&mut self) -> bool {
        let State::Frame(nesting) = &self.state else { return false };
        let is_one = self.end - self.scan == 1 && self.end - self.start <= self.max_frame;
        if !is_one || nesting.is_mark(self.buffer[self.scan]) {
            return false;
        }
        self.visit(1);
        true
    }

    /// Visits received bytes, up to the end of the next frame or to an error, which it notes.
    fn find_frame(&mut self) -> Option<Range<usize>> {
        if !matches!(self.state, State::Frame(_)) {
            self.begin_frame();
        }
        let State::Frame(nesting) = &mut self.state else { return None };
        // Nothing is visited beyond the limit, so that the outcome is the same however the stream was cut.
        let limit = self.start.saturating_add(self.max_frame);
        let frame = &self.buffer[self.start..self.end.min(limit).max(self.scan)];
        let (visited, found) = nesting.find_end(frame, self.scan - self.start);
        self.visit(visited);
        match found {
            Scanned::Frame => {
                let frame = self.start..self.scan;
                self.start = self.scan;
                self.state = State::Gap;
                return Some(frame);
            }
            Scanned::Cut => self.error = Some(self.cut()),
            Scanned::All if self.end > limit => self.error = Some(self.too_long()),
            Scanned::All => {}
        }
        None
    }

    /// Skips the gap and visits the first byte of a frame, if it has come.
    fn begin_frame(&mut self) {
        self.skip_gap();
        if matches!(self.state, State::Lost) && !self.partial().starts_with(self.stream.beginning()) {
            return;
        }
        let form = match (self.partial().first(), self.stream) {
            (None, _) => return,
            (Some(b'{'), Stream::Replies) => Form::Json,
            (Some(b'{'), Stream::Status) => Form::Status,
            (Some(b'('), Stream::Replies) => Form::Python,
            (Some(_), _) => {
                self.error = Some(self.garbage());
                return;
            }
        };
        self.state = State::Frame(Nesting::new(form));
        self.visit(1);
    }

    fn skip_gap(&mut self) {
        let waiting = self.partial();
        let gap = match self.state {
            State::Lost => self.lost_len(),
            State::Gap | State::Frame(_) => waiting.iter().position(|&byte| !is_white(byte)).unwrap_or(waiting.len()),
        };
        self.visit(gap);
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

    /// Counts the waiting bytes before the next frame, or before its possible beginning at the end of them.
    fn lost_len(&self) -> usize {
        let (waiting, beginning) = (self.partial(), self.stream.beginning());
        memmem::find(waiting, beginning).unwrap_or_else(|| {
            let is_begun = |len: &usize| waiting.ends_with(&beginning[..*len]);
            waiting.len() - (1..beginning.len()).rev().find(is_begun).unwrap_or(0)
        })
    }

    /// The last bytes before the frame that begins inside this one.
    fn cut(&self) -> FrameError {
        let is_inside = matches!(self.state, State::Frame(Nesting { quote: Some(_), .. }));
        let end = self.scan - usize::from(is_inside);
        FrameError::Cut { excerpt: Excerpt::of(&self.buffer[self.start.max(end.saturating_sub(EXCERPT))..end]) }
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

impl Stream {
    /// Beginning of a frame that ends a search.
    fn beginning(self) -> &'static [u8] {
        match self {
            Self::Replies => b"{",
            Self::Status => b"{\"len\"",
        }
    }
}

/// State of the scanner.
#[derive(Debug)]
enum State {
    /// Between frames.
    Gap,
    /// After an error, in search of the next `{`.
    Lost,
    /// After the first byte of a frame.
    Frame(Nesting),
}

fn is_white(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b'\r' | b'\n')
}
