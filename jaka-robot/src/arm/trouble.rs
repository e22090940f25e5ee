//! Events and states in status packets that end a motion.

use jaka_proto::messages::status::{RobotStatus, TaskState};

use crate::{Cause, ControllerEvent, Occurrence, Severity};

/// A state in a packet that keeps the arm from moving until it has been acknowledged.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Stop {
    Emergency,
    Protective,
    /// Drag mode, in which a person may have a hand on the arm.
    Drag,
}

impl Stop {
    /// All, by precedence.
    const ALL: [Self; 3] = [Self::Emergency, Self::Protective, Self::Drag];

    fn is_in(self, status: &RobotStatus) -> bool {
        let shown = match self {
            Self::Emergency => status.emergency_stop,
            Self::Protective => status.protective_stop,
            Self::Drag => status.drag_status,
        };
        shown == Some(true)
    }

    /// True if set-points may brake the arm meanwhile.
    pub(super) fn lets_brake(self) -> bool {
        match self {
            Self::Emergency | Self::Protective => false,
            Self::Drag => true,
        }
    }

    pub(crate) fn cause(self) -> Cause {
        match self {
            Self::Emergency => Cause::EmergencyStop,
            Self::Protective => Cause::ProtectiveStop,
            Self::Drag => Cause::DragMode,
        }
    }
}

/// First state by precedence that keeps the arm from moving until it has been acknowledged.
pub(crate) fn stop(status: &RobotStatus) -> Option<Stop> {
    Stop::ALL.into_iter().find(|stop| stop.is_in(status))
}

/// Numbers of the packets after which news counts.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Since {
    /// An event or a soft limit counts if a later packet is the first to show it.
    pub(crate) events: u64,
    /// A state counts if later packets show it.
    pub(crate) states: u64,
}

impl Since {
    /// All news after this packet.
    pub(crate) fn packet(number: u64) -> Self {
        Self { events: number, states: number }
    }
}

/// News of all packets so far, each with the number of its packet.
#[derive(Debug, Default)]
pub(super) struct PacketNews {
    /// Of each state of [`Stop::ALL`], the latest packet that shows it; 0 for none.
    stops: [u64; 3],
    /// The latest error that the packet before did not show.
    error: Option<(Occurrence, u64)>,
    /// As `error`, of a code that is in no table.
    unknown: Option<(Occurrence, u64)>,
    /// Lost power or enabling, with the number of the first of the two latest packets that show it one after the other.
    lost: Option<(Cause, u64)>,
    /// Packet that is the first to show the latest soft limit.
    soft_limit: Option<u64>,
    /// Code in the newest packet that has one.
    code: Option<String>,
    is_at_soft_limit: bool,
    /// The newest packet that tells of power or enabling, if it shows that they are lost.
    shown_lost: Option<u64>,
}

impl PacketNews {
    /// Takes the status in the next packet, and the number of the packet.
    pub(super) fn take(&mut self, status: &RobotStatus, number: u64) {
        for (stop, latest) in Stop::ALL.iter().zip(&mut self.stops) {
            if stop.is_in(status) {
                *latest = number;
            }
        }
        if status.error_code.is_some() && status.error_code != self.code {
            self.code.clone_from(&status.error_code);
            self.take_event(status, number);
        }
        if let Some(flag) = status.on_soft_limit {
            let was_there = std::mem::replace(&mut self.is_at_soft_limit, flag == 1);
            if self.is_at_soft_limit && !was_there {
                self.soft_limit = Some(number);
            }
        }
        let is_told = status.powered_on.is_some() || status.enabled.is_some() || status.task_state.is_some();
        match (lost(status), self.shown_lost) {
            (Some(cause), before) => {
                self.shown_lost = Some(number);
                self.lost = before.map(|first| (cause, first)).or_else(|| self.lost.take());
            }
            (None, _) if is_told => self.shown_lost = None,
            (None, _) => {}
        }
    }

    fn take_event(&mut self, status: &RobotStatus, number: u64) {
        let Some((severity, occurrence)) = event(status) else { return };
        match severity {
            Severity::Error => self.error = Some((occurrence, number)),
            Severity::Warning | Severity::Information => {}
            // A severity that this version does not know is none that it can rely on.
            _ => self.unknown = Some((occurrence, number)),
        }
    }

    /// News by precedence.
    pub(super) fn after(&self, since: Since) -> impl Iterator<Item = Occurrence> {
        let stops = Stop::ALL.into_iter().zip(self.stops).filter(move |(_, latest)| *latest > since.states);
        let error = self.error.iter().filter(move |(_, number)| *number > since.events);
        let lost = self.lost.into_iter().filter(move |(_, first)| *first > since.states);
        let soft_limit = self.soft_limit.into_iter().filter(move |number| *number > since.events);
        stops
            .map(|(stop, _)| stop.cause().into())
            .chain(error.map(|(occurrence, _)| occurrence.clone()))
            .chain(lost.map(|(cause, _)| cause.into()))
            .chain(soft_limit.map(|_| Cause::SoftLimit.into()))
    }

    /// Latest code after `since` that is in no table: it counts only once the arm is at rest.
    pub(super) fn unknown_after(&self, since: Since) -> Option<Occurrence> {
        let unknown = self.unknown.as_ref().filter(|(_, number)| *number > since.events);
        unknown.map(|(occurrence, _)| occurrence.clone())
    }

    /// True if the next packet may confirm a loss of power or enabling.
    pub(super) fn is_unconfirmed(&self) -> bool {
        self.shown_lost.is_some()
    }
}

/// Lost power or enabling in a packet, which an old packet may show, too.
pub(crate) fn lost(status: &RobotStatus) -> Option<Cause> {
    if status.powered_on == Some(false) || status.task_state == Some(TaskState::PoweredOff) {
        return Some(Cause::NotPowered);
    }
    (status.enabled == Some(false)).then_some(Cause::NotEnabled)
}

/// Event with its severity, if the status has one; a code that cannot be read is unknown.
fn event(status: &RobotStatus) -> Option<(Severity, Occurrence)> {
    let event = status.event();
    if matches!(event, Ok(None)) {
        return None;
    }
    let code = status.error_code.as_deref()?;
    let event = event.ok().flatten();
    let severity = event.map_or(Severity::Unknown, ControllerEvent::severity);
    let message = status.error_message.clone().unwrap_or_default();
    Some((severity, Occurrence::event(code, event, message)))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Takes packets that differ from the usual one by this, numbered from 1.
    fn taken(changes: &[fn(&mut RobotStatus)]) -> PacketNews {
        let mut news = PacketNews::default();
        for (number, change) in (1..).zip(changes) {
            let mut status = RobotStatus::default();
            (status.powered_on, status.enabled) = (Some(true), Some(true));
            (status.error_code, status.on_soft_limit) = (Some("0x0".to_owned()), Some(0));
            change(&mut status);
            news.take(&status, number);
        }
        news
    }

    fn causes(news: &PacketNews, packet: u64) -> Vec<Cause> {
        news.after(Since::packet(packet)).map(|occurrence| occurrence.cause).collect()
    }

    fn usual(_: &mut RobotStatus) {}

    fn unpowered(status: &mut RobotStatus) {
        status.powered_on = Some(false);
    }

    fn disabled(status: &mut RobotStatus) {
        status.enabled = Some(false);
    }

    /// A packet that tells nothing of power and enabling.
    fn untold(status: &mut RobotStatus) {
        (status.powered_on, status.enabled) = (None, None);
    }

    fn error(status: &mut RobotStatus) {
        status.error_code = Some("0xF0034".to_owned());
    }

    fn at_soft_limit(status: &mut RobotStatus) {
        status.on_soft_limit = Some(1);
    }

    fn led_by_hand(status: &mut RobotStatus) {
        status.drag_status = Some(true);
    }

    #[test]
    fn lost_power_and_enabling_take_two_packets_in_a_row_after_the_beginning() {
        assert_eq!(causes(&taken(&[unpowered, usual, unpowered]), 0), []);
        assert_eq!(causes(&taken(&[unpowered, unpowered]), 0), [Cause::NotPowered]);
        assert_eq!(causes(&taken(&[disabled, unpowered]), 0), [Cause::NotPowered]);
        assert_eq!(causes(&taken(&[disabled, untold, disabled]), 0), [Cause::NotEnabled]);
        // Power that has come back since was lost all the same.
        let news = taken(&[usual, disabled, disabled, usual, disabled]);
        assert_eq!((causes(&news, 1), causes(&news, 2)), (vec![Cause::NotEnabled], vec![]));
        assert!(news.is_unconfirmed() && !taken(&[disabled, usual]).is_unconfirmed());
    }

    #[test]
    fn an_event_or_a_soft_limit_counts_from_the_first_packet_that_shows_it() {
        let news = taken(&[error, error, at_soft_limit, at_soft_limit]);
        assert_eq!(causes(&news, 0), [Cause::ControllerError, Cause::SoftLimit]);
        assert_eq!((causes(&news, 1), causes(&news, 3)), (vec![Cause::SoftLimit], vec![]));
        // Once more.
        let news = taken(&[error, at_soft_limit, error, at_soft_limit]);
        assert_eq!((causes(&news, 2), causes(&news, 3)), (causes(&news, 0), vec![Cause::SoftLimit]));
    }

    #[test]
    fn a_state_that_must_be_acknowledged_counts_in_each_packet_and_first() {
        let news = taken(&[led_by_hand, error, led_by_hand, unpowered]);
        assert_eq!(causes(&news, 0), [Cause::DragMode, Cause::ControllerError]);
        assert_eq!((causes(&news, 2), causes(&news, 3)), (vec![Cause::DragMode], vec![]));
    }
}
