//! Forms in which a firmware writes messages.

use jaka_proto::ControllerEvent;
use jaka_proto::wire::Value;

use crate::State;

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
}

impl Writing {
    /// Returns what stands after each comma and colon.
    pub(crate) fn blank(self) -> &'static str {
        if self == Self::Document { "" } else { " " }
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
        }
    }
}
