//! The way to the next packet, after bytes that belong to none and after a packet that was cut.

use memchr::memmem;

use super::error::{EXCERPT, Excerpt, FrameError};
use super::nesting::{Form, Nesting};
use super::{Framer, State, is_white};

/// What comes on a stream.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Stream {
    Replies,
    Status,
}

impl Stream {
    /// How the frame begins that ends a search.
    pub(super) fn beginning(self) -> &'static [u8] {
        match self {
            Self::Replies => b"{",
            Self::Status => b"{\"len\"",
        }
    }
}

impl Framer {
    /// Leaves the error state for the next `{` after the error, and returns how many bytes it dropped at once.
    ///
    /// For streams that are only read, such as port 10000. Garbage is dropped as a whole; of a frame that is
    /// too long, all that was visited; of one that was cut, what comes before the next. Where the next `{` is still to come,
    /// what precedes it will be dropped as it comes: [`lost`](Self::lost) has it. A framer
    /// [for status packets](Self::for_status) goes on at `{"len"`; the frame that another one finds may be an object inside
    /// a broken one: its reader must expect any keys. Without an error, nothing is dropped.
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

    /// The bytes received that the next call of [`next_frame`](Self::next_frame) drops, while the next packet is searched for.
    pub fn lost(&self) -> &[u8] {
        let len = if matches!(self.state, State::Lost) { self.lost_len() } else { 0 };
        &self.partial()[..len]
    }

    /// How many of the bytes that wait come before the next frame, or before what may be its beginning.
    pub(super) fn lost_len(&self) -> usize {
        let (waiting, beginning) = (self.partial(), self.stream.beginning());
        memmem::find(waiting, beginning).unwrap_or_else(|| {
            let is_begun = |len: &usize| waiting.ends_with(&beginning[..*len]);
            waiting.len() - (1..beginning.len()).rev().find(is_begun).unwrap_or(0)
        })
    }

    /// The last bytes before the frame that begins inside this one.
    pub(super) fn cut(&self) -> FrameError {
        let is_inside = matches!(self.state, State::Frame(Nesting { quote: Some(_), .. }));
        let end = self.scan - usize::from(is_inside);
        FrameError::Cut { excerpt: Excerpt::of(&self.buffer[self.start.max(end.saturating_sub(EXCERPT))..end]) }
    }
}

impl Nesting {
    /// Whether another packet begins where no JSON has an object: `None` where the next bytes must tell.
    #[inline]
    pub(super) fn is_cut(&self, frame: &[u8], at: usize) -> Option<bool> {
        match frame[at] {
            b'{' if self.quote.is_none() && !may_have_value(&frame[..at]) => begins_with(&frame[at + 1..], b"\"len\""),
            // In a string that has not ended, the packet's first quote seems to end it.
            b'"' if self.quote.is_some() && !self.escaped && frame[at - 1] == b'{' => {
                begins_with(&frame[at + 1..], b"len\"")
            }
            _ => Some(false),
        }
    }
}

/// Whether a value can follow in JSON.
fn may_have_value(before: &[u8]) -> bool {
    before.iter().rfind(|byte| !is_white(**byte)).is_some_and(|byte| b":,[".contains(byte))
}

/// Whether `bytes` begin so; `None` if they are too few to tell.
fn begins_with(bytes: &[u8], beginning: &[u8]) -> Option<bool> {
    let len = bytes.len().min(beginning.len());
    let begins = bytes[..len] == beginning[..len];
    (!begins || len == beginning.len()).then_some(begins)
}
