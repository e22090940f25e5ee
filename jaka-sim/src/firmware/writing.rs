//! Forms in which a firmware writes messages.

use jaka_proto::wire::Value;
use jaka_proto::{ControllerEvent, ErrorCode};

use crate::State;
use crate::json_text::Separators;

/// Unknown key, as newer firmware may add one.
const UNKNOWN: &str = r#""oddity":[null,{"a":[]}]"#;

/// Form in which a firmware writes messages on both ports.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Writing {
    /// Form of the document, as short as possible.
    Document,
    /// Form of captures: numbers that may have a fraction have one, and positions have few decimals.
    Capture,
    /// Form of captures, with the controller's event, and with truth values in replies as in packets: `"True"` and
    /// `"False"` instead of the document's words such as `robot_enabled`.
    AsPackets,
    /// All other known forms at once.
    Odd,
}

impl Writing {
    /// Returns the separators between the parts.
    pub(crate) fn separators(self) -> Separators {
        if self == Self::Document { Separators::Compact } else { Separators::Spaced }
    }

    /// Returns the controller's event in the reply to `get_robot_state`; `None` if the reply has none.
    ///
    /// The vendor's SDK 2.1.14 reads only a number.
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

    /// Returns an unknown key and its value, if this form has one.
    pub(crate) fn unknown_key(self) -> Option<&'static str> {
        (self == Self::Odd).then_some(UNKNOWN)
    }

    /// Returns an error code in a form other than the document's, if there is one. No hexadecimal form of negative
    /// codes is known.
    pub(super) fn code(self, code: ErrorCode) -> Option<Value> {
        match self {
            Self::Document | Self::Capture | Self::AsPackets => None,
            Self::Odd if code.0 > 0 => Some(format!("{:#x}", code.0).into()),
            Self::Odd => Some(code.0.into()),
        }
    }
}
