//! Causes with the evidence for them.

use std::error::Error as StdError;
use std::fmt;
use std::sync::Arc;

use jaka_proto::messages::status::RobotStatus;
use jaka_proto::wire::DecodeError;
use jaka_proto::{ControllerEvent, ErrorCode, Refusal, Request, Requirement, Severity};
use jaka_sync::layer::seat_hint;

use super::consequence::Consequence;
use super::remedy::Remedy;
use super::servo_mode::ServoModeState;
use super::table::Cause;
use super::trip::GuardTrip;
#[cfg(feature = "serde")]
use crate::form;
use crate::{Disconnect, FrameChange};

/// Cause of the end of a motion, or of its refusal, with the evidence for it.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Occurrence {
    /// Cause.
    pub cause: Cause,
    /// Evidence for the cause.
    pub evidence: Evidence,
}

/// Evidence for a [`Cause`], besides packets and errors.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(tag = "kind", rename_all = "snake_case"))]
#[non_exhaustive]
pub enum Evidence {
    /// None besides the cause itself: a packet, an answer of the controller or this program shows it.
    None,
    /// Event of the controller that was not reported before; or, of an arm at rest but not at its target, a code that
    /// no table has. Warnings and information do not end a motion.
    Event {
        /// The code as the controller writes it, such as `0x0F0034`.
        code: String,
        /// The event with its severity and, if it is known, its meaning; none for a code that cannot be read.
        #[cfg_attr(feature = "serde", serde(serialize_with = "form::event"))]
        event: Option<ControllerEvent>,
        /// The controller's message.
        message: String,
    },
    /// Trip of a guard: the arm was stopped, or nothing was sent.
    Trip(Arc<GuardTrip>),
    /// Change of the selected frames, by a status packet.
    Frames(FrameChange),
    /// State of servo mode, which is not the one that is needed.
    ServoMode {
        /// The state.
        state: ServoModeState,
    },
    /// End of the command connection. Another client may have taken it over, or the controller has shut down. Nothing
    /// reconnects by itself.
    Commands {
        /// Address of the connection, with the port.
        address: String,
        /// Cause of its end.
        #[cfg_attr(feature = "serde", serde(serialize_with = "form::text"))]
        cause: Arc<Disconnect>,
    },
    /// Loss of status packets that can be read.
    Status {
        /// Cause of the end of the connection; none if it is open.
        #[cfg_attr(feature = "serde", serde(serialize_with = "form::some_text"))]
        cause: Option<Arc<Disconnect>>,
        /// Error of a packet that cannot be read; none if no packets come.
        #[cfg_attr(feature = "serde", serde(serialize_with = "form::some_text"))]
        unreadable: Option<DecodeError>,
    },
}

impl From<ServoModeState> for Occurrence {
    fn from(state: ServoModeState) -> Self {
        Self { cause: Cause::ServoMode, evidence: Evidence::ServoMode { state } }
    }
}

impl From<Cause> for Occurrence {
    fn from(cause: Cause) -> Self {
        Self { cause, evidence: Evidence::None }
    }
}

impl Occurrence {
    /// Occurrence of a cause with its evidence.
    pub fn new(cause: Cause, evidence: Evidence) -> Self {
        Self { cause, evidence }
    }

    /// Reason of a refusal, by the refusal itself and by the robot's status; `None` if neither shows it.
    ///
    /// [`Robot`](crate::Robot) finds it for its motions. The status is the newest one after the refusal.
    pub fn of_refusal(refusal: &Refusal, status: Option<&RobotStatus>) -> Option<Self> {
        if refusal.code == ErrorCode::PERMISSION_DENIED {
            return Some(Cause::NoRemoteControl.into());
        }
        let info = Request::COMMANDS.iter().find(|info| info.name == refusal.command)?;
        let needs = |requirement| info.requires.contains(&requirement);
        let status = status.filter(|_| needs(Requirement::Powered))?;
        // An error of a drive ends servo mode.
        let event = status.event().ok().flatten().filter(|event| event.severity() == Severity::Error);
        let is_off = refusal.code == ErrorCode::REJECTED && needs(Requirement::ServoMode);
        let if_so = |is_so: bool, cause: Cause| is_so.then(|| Self::from(cause));
        let reasons = [
            if_so(status.emergency_stop == Some(true), Cause::EmergencyStop),
            if_so(status.powered_on == Some(false), Cause::NotPowered),
            if_so(status.protective_stop == Some(true), Cause::ProtectiveStop),
            if_so(status.drag_status == Some(true), Cause::DragMode),
            if_so(status.enabled == Some(false) && needs(Requirement::Enabled), Cause::NotEnabled),
            event.map(|event| Self::event(&format!("{:#08x}", event.code()), Some(event), String::new())),
            is_off.then(|| ServoModeState::Off.into()),
            if_so(status.on_soft_limit == Some(1), Cause::SoftLimit),
        ];
        reasons.into_iter().flatten().next()
    }

    pub(crate) fn event(code: &str, event: Option<ControllerEvent>, message: String) -> Self {
        Self { cause: Cause::ControllerError, evidence: Evidence::Event { code: code.to_owned(), event, message } }
    }

    pub(crate) fn trip(trip: GuardTrip) -> Self {
        Self { cause: trip.cause(), evidence: Evidence::Trip(Arc::new(trip)) }
    }

    pub(crate) fn frames_changed(change: FrameChange) -> Self {
        Self { cause: Cause::FramesChanged, evidence: Evidence::Frames(change) }
    }

    pub(crate) fn commands_lost(address: String, cause: Arc<Disconnect>) -> Self {
        Self { cause: Cause::CommandsLost, evidence: Evidence::Commands { address, cause } }
    }

    pub(crate) fn status_lost(cause: Option<Arc<Disconnect>>, unreadable: Option<DecodeError>) -> Self {
        Self { cause: Cause::StatusLost, evidence: Evidence::Status { cause, unreadable } }
    }

    /// Source below the error whose text is part of this one's.
    pub(crate) fn source(&self) -> Option<&(dyn StdError + 'static)> {
        match &self.evidence {
            Evidence::Commands { cause, .. } | Evidence::Status { cause: Some(cause), .. } => cause.source(),
            Evidence::None
            | Evidence::Event { .. }
            | Evidence::Trip(_)
            | Evidence::Frames(_)
            | Evidence::ServoMode { .. }
            | Evidence::Status { cause: None, .. } => None,
        }
    }

    /// Remedy: the cause's, or the one of the controller's event or of the guard's trip.
    pub fn remedy(&self) -> Remedy {
        match &self.evidence {
            Evidence::Trip(trip) => trip.remedy(),
            Evidence::Event { event, .. } => Remedy::for_event(*event),
            Evidence::None
            | Evidence::Frames(_)
            | Evidence::ServoMode { .. }
            | Evidence::Commands { .. }
            | Evidence::Status { .. } => self.cause.remedy(),
        }
    }

    /// Consequence for the motions. A guard stops the arm itself for any trip.
    pub(crate) fn consequence(&self) -> Consequence {
        match &self.evidence {
            Evidence::Trip(_) => Consequence::Over,
            Evidence::None
            | Evidence::Event { .. }
            | Evidence::Frames(_)
            | Evidence::ServoMode { .. }
            | Evidence::Commands { .. }
            | Evidence::Status { .. } => self.cause.consequence(),
        }
    }
}

/// The fact of the cause, and the evidence.
impl fmt::Display for Occurrence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let fact = self.cause;
        let text = match &self.evidence {
            Evidence::None => fact.to_string(),
            Evidence::Status { cause: None, unreadable: None } => format!("{fact}: no status packets come"),
            Evidence::Event { event: Some(event), message, .. } if message.is_empty() => format!("{fact}: {event}"),
            Evidence::Event { event: Some(event), message, .. } => format!("{fact}: {event}: {message}"),
            Evidence::Event { event: None, code, message } => format!("{fact}: code {code}: {message}"),
            Evidence::Trip(trip) => format!("{fact}: {trip}"),
            Evidence::Frames(change) => format!("{fact}: {change}"),
            Evidence::ServoMode { state } => format!("{fact}: {state}"),
            Evidence::Commands { address, cause } => format!("{fact} ({address}{}): {cause}", seat_hint(cause)),
            Evidence::Status { cause: None, unreadable: Some(source) } => format!("{fact}: {source}"),
            Evidence::Status { cause: Some(cause), .. } => format!("{fact}: the status connection ended: {cause}"),
        };
        // Parts of it come from outside.
        f.pad(&jaka_proto::text::visible(&text))
    }
}
