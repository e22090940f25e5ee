//! Waits for inputs.

use std::cell::RefCell;
use std::sync::Arc;
use std::time::Duration;

use crate::arm::{self, Arm, SETTLING};
use crate::guard::{Armed, Guard, Watched, watch};
use crate::{Cause, Error, ErrorKind, Occurrence, Snapshot, StatusProblem, TripReason};

/// Events of the robot during a wait. A state that was there before does not end it: a program may wait for the button
/// that powers the arm.
struct WaitEvents {
    /// Cause that the packets have shown since the wait began.
    shown: Option<Cause>,
    code: Option<String>,
    stops: u64,
    /// Occurrence that ends the wait, once there is one.
    found: Option<Occurrence>,
}

impl WaitEvents {
    fn since(arm: &Arm) -> Self {
        let newest = arm.state.newest_packet();
        let code = newest.as_ref().and_then(|newest| arm::code(&newest.status)).map(str::to_owned);
        let mut news = Self { shown: None, code, stops: arm.stops().accepted(), found: None };
        news.shown = newest.and_then(|newest| news.of(&newest)).map(|occurrence| occurrence.cause);
        news
    }

    fn of(&self, packet: &Snapshot) -> Option<Occurrence> {
        match arm::news(&packet.status, self.code.as_deref())? {
            arm::News::Ends(occurrence) => Some(occurrence),
            arm::News::AtRest(_) => None,
        }
    }

    /// True once something has happened.
    fn have_come(&mut self, arm: &Arm) -> bool {
        if self.found.is_none() && arm.stops().accepted() > self.stops {
            self.found = Some(Cause::Stopped.into());
        }
        if let (None, Ok(newest)) = (&self.found, arm.state.fresh_packet()) {
            let shown = self.of(&newest);
            let cause = shown.as_ref().map(|occurrence| occurrence.cause);
            self.found = shown.filter(|_| cause != self.shown);
            self.shown = cause;
        }
        self.found.is_some()
    }
}

/// Waits until a condition of an input holds: the packet that shows it.
pub(crate) fn wait_for(arm: &Arm, guard: &Guard, timeout: Duration) -> Result<Arc<Snapshot>, Error> {
    guard.check()?;
    let since = arm.clock().stopwatch();
    let what = guard.to_string();
    let attach = |kind: ErrorKind| arm.attach(kind);
    let blind = |problem: StatusProblem| attach(ErrorKind::WaitEnded { what: what.clone(), problem });
    let before = arm.statistics().packets;
    let armed = Armed::new(guard, &arm.state, timeout).map_err(blind)?;
    let (left, link) = (since.left_of(timeout), arm.link());
    let commands_lost = |cause| attach(ErrorKind::CommandsLost { address: link.address(), what: what.clone(), cause });
    let news = RefCell::new(WaitEvents::since(arm));
    let is_over = || link.lost().is_some() || news.borrow_mut().have_come(arm);
    let trip = match watch(&arm.state, &armed, (left, Duration::MAX), is_over) {
        Watched::Tripped(trip) => trip,
        // A controller that has gone takes both connections with it.
        Watched::Blind(problem @ StatusProblem::Ended { .. }) => {
            return Err(link.lost_within(SETTLING).map_or_else(|| blind(problem), commands_lost));
        }
        Watched::Blind(problem) => return Err(blind(problem)),
        Watched::Over(newest) => {
            if let Some(cause) = link.broken() {
                return Err(commands_lost(cause));
            }
            if let Some(occurrence) = news.into_inner().found {
                return Err(attach(ErrorKind::WaitBroken { what, occurrence }));
            }
            let packets = arm.statistics().packets.saturating_sub(before);
            let says = guard.conditions.iter().find_map(|condition| condition.says(&newest));
            let kind = jaka_sync::ErrorKind::StateTimeout { after: timeout, packets, says };
            return Err(arm.attach(kind));
        }
    };
    match trip.reason {
        TripReason::NotShown(reason) => Err(match trip.packet.unreadable() {
            Some(source) => blind(StatusProblem::Unreadable { source }),
            None => attach(ErrorKind::NotShown { what, reason }),
        }),
        TripReason::Holds if trip.packet.follows_silence => Err(blind(StatusProblem::Resuming)),
        TripReason::Holds | TripReason::Panicked => Ok(trip.packet),
    }
}
