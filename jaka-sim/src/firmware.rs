//! Firmware, by what its messages look like.

mod reply_style;
mod restyle;
mod shape;
mod values;

use std::fmt;
use std::time::Duration;

pub use self::reply_style::{CodeStyle, KeyOrder, NumberStyle, ReplyStyle, TruthStyle};
pub(crate) use self::restyle::restyle;
pub(crate) use self::shape::{PacketKeys, Shape};
use crate::json_text::Separators;

/// Makes the enum of a table of firmwares, a row each: a firmware without a [`Shape`] does not compile.
macro_rules! firmwares {
    (
        $(#[$meta:meta])*
        pub enum $Firmware:ident;
        $( $(#[$row_meta:meta])* $Name:ident => $shape:expr; )*
    ) => {
        $(#[$meta])*
        pub enum $Firmware {
            $( $(#[$row_meta])* $Name ),*
        }

        impl $Firmware {
            /// All of them.
            pub const ALL: &'static [Self] = &[$(Self::$Name),*];

            pub(crate) const fn shape(self) -> Shape {
                match self {
                    $(Self::$Name => $shape),*
                }
            }
        }
    };
}

firmwares! {
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
    /// | blanks after commas and colons | yes | no | yes |
    /// | time between packets | 30 ms | 50 ms | 50 ms |
    /// | packet, to begin with | 2.4 KB | 2.0 KB | 6.4 KB |
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
    #[non_exhaustive]
    pub enum Firmware;

    /// Firmware 1.5.14, as field notes have it.
    ///
    /// The separators, the period and the missing key are certain. The lengths of arrays are among those that have been
    /// seen; which of them belong to this version is not known.
    V1_5_14 => Shape {
        name: "1.5.14",
        status_period: Duration::from_millis(30),
        separators: Separators::Spaced,
        reply_style: ReplyStyle::DOCUMENT.separators(Separators::Spaced),
        packet_keys: PacketKeys::WithoutExtio,
        digital: 136,
        analog: 64,
        tool_digital: 8,
        tool_analog: 1,
        functions: 13,
    };

    /// What the document prints, version 2.0.4.
    #[default]
    Document => Shape {
        name: "document",
        status_period: Duration::from_millis(50),
        separators: Separators::Compact,
        reply_style: ReplyStyle::DOCUMENT,
        packet_keys: PacketKeys::Document,
        digital: 144,
        analog: 66,
        tool_digital: 8,
        tool_analog: 1,
        functions: 15,
    };

    /// Firmware that is newer than the document, with packets of more than the 5000 bytes that the document allows.
    ///
    /// Packets have all keys of the spec, with the lengths that one such controller sends. `get_robot_state` answers as
    /// packets do, and reports the controller's error.
    Newer => Shape {
        name: "newer",
        status_period: Duration::from_millis(50),
        separators: Separators::Spaced,
        reply_style: ReplyStyle::DOCUMENT
            .separators(Separators::Spaced)
            .truth_values(TruthStyle::Packet)
            .with_robot_error(),
        packet_keys: PacketKeys::All,
        digital: 200,
        analog: 128,
        tool_digital: 8,
        tool_analog: 2,
        functions: 15,
    };
}

impl Firmware {
    /// A name to be typed: `1.5.14`, `document` or `newer`.
    pub fn name(self) -> &'static str {
        self.shape().name
    }

    /// The time between two of its status packets.
    pub fn status_period(self) -> Duration {
        self.shape().status_period
    }

    /// How its replies are written.
    pub fn reply_style(self) -> ReplyStyle {
        self.shape().reply_style
    }
}

/// Its [`name`](Firmware::name).
impl fmt::Display for Firmware {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
