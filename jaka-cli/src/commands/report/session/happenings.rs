//! Events at one time of a recording.

use std::time::Duration;

use jaka_sync::proto::{CommandInfo, Role};
use jaka_sync::recording::{Ending, Entry, Event, Message, MotionStep, Port};

use crate::recordings::recorded::command_of;

/// Event in a recording.
#[derive(Debug)]
pub(in crate::commands::report) struct Happening {
    pub(in crate::commands::report) time: Duration,
    pub(in crate::commands::report) kind: HappeningKind,
    /// Description of the event.
    pub(in crate::commands::report) what: String,
    pub(in crate::commands::report) is_wrong: bool,
}

/// Kind of an event.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::commands::report) enum HappeningKind {
    Connection,
    Refused,
    Unanswered,
    Error,
    Motion,
    State,
    ControllerEvent,
    Packets,
}

impl HappeningKind {
    pub(in crate::commands::report) const ALL: [(Self, &'static str); 8] = [
        (Self::Connection, "connections"),
        (Self::Refused, "refused"),
        (Self::Unanswered, "without reply"),
        (Self::Error, "errors of the program"),
        (Self::Motion, "motions of the program"),
        (Self::State, "state of the robot"),
        (Self::ControllerEvent, "events of the controller"),
        (Self::Packets, "packets, entries missing"),
    ];
}

impl Happening {
    /// Creates an event that is not a problem.
    pub(super) fn usual(time: Duration, kind: HappeningKind, what: impl Into<String>) -> Self {
        Self { time, kind, what: what.into(), is_wrong: false }
    }

    /// Creates an event that is a problem.
    pub(super) fn wrong(time: Duration, kind: HappeningKind, what: impl Into<String>) -> Self {
        Self { time, kind, what: what.into(), is_wrong: true }
    }
}

/// Returns the event that an entry reports of its connection; `None` for other entries.
pub(super) fn of_connection(entry: &Entry) -> Option<Happening> {
    let Entry { time, port, connection, event, .. } = entry;
    let time = *time;
    Some(match event {
        Event::Connected { address } => Happening::usual(
            time,
            HappeningKind::Connection,
            format!("connection {connection} to {address}, the {port} port"),
        ),
        Event::Closed { by: Ending::Client, why } => Happening::usual(
            time,
            HappeningKind::Connection,
            format!("connection {connection} closed by the program: {why}"),
        ),
        Event::Closed { by, why } => {
            let by = if *by == Ending::Controller { "closed by the controller" } else { "lost" };
            Happening::wrong(time, HappeningKind::Connection, format!("connection {connection} {by}: {why}"))
        }
        Event::Sent(message) if *port == Port::Command && stop(message).is_some() => {
            let name = stop(message).unwrap_or_default();
            Happening::wrong(time, HappeningKind::Motion, format!("the program stops the arm (`{name}`)"))
        }
        Event::Motion { step: MotionStep::Done, text } => Happening::usual(time, HappeningKind::Motion, text.as_str()),
        Event::Motion { text, .. } => Happening::wrong(time, HappeningKind::Motion, text.as_str()),
        Event::Error { text } => Happening::wrong(time, HappeningKind::Error, text.as_str()),
        Event::Dropped { count: dropped } => {
            let entries = if *dropped == 1 { "1 entry".to_owned() } else { format!("{dropped} entries") };
            let what = format!("{entries} of connection {connection} missing: the file could not be written as fast");
            Happening::wrong(time, HappeningKind::Packets, what)
        }
        _ => return None,
    })
}

/// Returns the name of the built-in stop in a message, if it is one.
fn stop(message: &Message) -> Option<&'static str> {
    let info = CommandInfo::of(&command_of(message)?)?;
    (info.role == Some(Role::Stop)).then_some(info.name)
}
