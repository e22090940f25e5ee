//! Error for a byte stream that has no next frame.

use std::error::Error;
use std::fmt;

/// The most bytes that an [`Excerpt`] holds.
pub(super) const EXCERPT: usize = 64;

crate::worded! {
    /// Error for a byte stream that has no next frame.
    #[derive(Debug, Clone, PartialEq, Eq)]
    #[non_exhaustive]
    pub enum FrameError {
        /// Bytes between frames that begin none.
        Garbage {
            /// The first of them, as far as received.
            excerpt: Excerpt,
        } => "bytes that do not begin a frame: `{excerpt}`",
        /// A frame that has not ended at the limit.
        TooLong {
            /// The limit, in bytes.
            limit: usize,
            /// Beginning of the frame.
            excerpt: Excerpt,
        } => "frame longer than {limit} bytes: `{excerpt}`",
        /// A status packet inside of which the next one begins.
        Cut {
            /// Last bytes of the packet before the next one begins.
            excerpt: Excerpt,
        } => "packet that breaks off at `{excerpt}`",
    }
}

impl Error for FrameError {}

/// Up to 64 bytes of a stream, for an error to show.
///
/// Displays printable ASCII as it is and every other byte as `\xNN`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Excerpt(pub(super) Vec<u8>);

impl Excerpt {
    /// The bytes as received.
    pub fn bytes(&self) -> &[u8] {
        &self.0
    }

    pub(super) fn of(bytes: &[u8]) -> Self {
        Self(bytes[..bytes.len().min(EXCERPT)].to_vec())
    }

    pub(super) fn first(mut self, len: usize) -> Self {
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
