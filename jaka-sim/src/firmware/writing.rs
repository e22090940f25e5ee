//! Forms in which a firmware writes what it says.

use jaka_proto::wire::Value;
use jaka_proto::{ControllerEvent, ErrorCode};

use crate::State;
use crate::json_text::Separators;

/// A key that nobody knows, as newer firmware may add one.
const UNKNOWN: &str = r#""oddity":[null,{"a":[]}]"#;

/// Forms in which a firmware writes what it says, on both ports.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Writing {
    /// As the document prints it, and as short as may be.
    Document,
    /// As captures have it: numbers that may have a fraction with one, positions with few decimals.
    Capture,
    /// Form of captures, with the controller's event, and with truth values in replies as in packets: `"True"` and
    /// `"False"` where the document has words as `robot_enabled`.
    AsPackets,
    /// In the other forms that were seen, all at once.
    Odd,
}

impl Writing {
    /// Separators between the parts.
    pub(crate) fn separators(self) -> Separators {
        if self == Self::Document { Separators::Compact } else { Separators::Spaced }
    }

    /// The controller's event as `get_robot_state` answers it; none where it does not.
    ///
    /// The vendor's SDK 2.1.14 reads no other form than a number.
    pub(crate) fn event(self, state: &State) -> Option<Value> {
        match self {
            Self::Document | Self::Capture => None,
            Self::AsPackets => {
                let event = ControllerEvent::from_text(&state.error_code).ok().flatten();
                Some(event.map_or(0, ControllerEvent::code).into())
            }
            Self::Odd => Some(state.error_code.as_str().into()),
        }
    }

    /// A key that nobody knows and its value, where there is one.
    pub(crate) fn unknown_key(self) -> Option<&'static str> {
        (self == Self::Odd).then_some(UNKNOWN)
    }

    /// An error code that is not written as the document does. Of negative codes no hexadecimal form is known.
    pub(super) fn code(self, code: ErrorCode) -> Option<Value> {
        match self {
            Self::Document | Self::Capture | Self::AsPackets => None,
            Self::Odd if code.0 > 0 => Some(format!("{:#x}", code.0).into()),
            Self::Odd => Some(code.0.into()),
        }
    }
}
