//! Firmware, by what its messages look like.

mod json;
mod reply_style;
mod restyle;
mod shape;
mod values;

use std::fmt;
use std::time::Duration;

pub(crate) use self::json::respace;
pub use self::reply_style::{CodeStyle, KeyOrder, NumberStyle, ReplyStyle, Separators, TruthStyle};
pub(crate) use self::restyle::restyle;
pub(crate) use self::shape::Shape;

/// The firmware that a controller looks like.
///
/// It decides the shape of status packets and the time between them, how many inputs and outputs there are, and how
/// replies are written; [`Builder::status_period`](crate::Builder::status_period) and
/// [`Builder::reply_style`](crate::Builder::reply_style) come before it. What commands do is the same with all of them,
/// and so is the version in the [`State`](crate::State).
///
/// | | `V1_5_14` | `Document` | `Newer` |
/// |---|---|---|---|
/// | digital inputs, digital outputs | 136 | 144 | 200 |
/// | analog inputs, analog outputs | 64 | 66 | 128 |
/// | analog inputs of the tool | 1 | 1 | 2 |
/// | functions with an input | 13 | 15 | 15 |
/// | values for each joint in the monitor data | 10 | 10 | 11 |
/// | extension I/O modules in packets | no | yes | yes |
/// | blanks behind commas and colons | yes | no | yes |
/// | time between packets | 30 ms | 50 ms | 50 ms |
/// | packet, to begin with | 2.4 KB | 2.0 KB | 6.4 KB |
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[non_exhaustive]
pub enum Firmware {
    /// Firmware 1.5.14, as field notes have it.
    ///
    /// The separators, the period and the missing key are certain. The lengths of arrays are among those that have been
    /// seen; which of them belong to this version is not known.
    V1_5_14,
    /// What the document prints, version 2.0.4.
    #[default]
    Document,
    /// Firmware that is newer than the document, with packets of more than the 5000 bytes that the document allows.
    ///
    /// Packets have all keys of the spec, with the lengths that one such controller sends. `get_robot_state` answers as
    /// packets do, and tells the controller's error.
    Newer,
}

impl Firmware {
    /// All of them.
    pub const ALL: &'static [Self] = &[Self::V1_5_14, Self::Document, Self::Newer];

    /// A name to be typed: `1.5.14`, `document` or `newer`.
    pub fn name(self) -> &'static str {
        match self {
            Self::V1_5_14 => "1.5.14",
            Self::Document => "document",
            Self::Newer => "newer",
        }
    }

    /// The time between two of its status packets.
    pub fn status_period(self) -> Duration {
        match self {
            Self::V1_5_14 => Duration::from_millis(30),
            Self::Document | Self::Newer => Duration::from_millis(50),
        }
    }

    /// How its replies are written.
    pub fn reply_style(self) -> ReplyStyle {
        ReplyStyle::of(self)
    }

    /// What stands between the parts of its status packets.
    pub(crate) fn separators(self) -> Separators {
        match self {
            Self::V1_5_14 | Self::Newer => Separators::Spaced,
            Self::Document => Separators::Compact,
        }
    }
}

/// Its [`name`](Firmware::name).
impl fmt::Display for Firmware {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
