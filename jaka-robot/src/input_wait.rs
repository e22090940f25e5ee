//! Waits for inputs.

use std::cell::RefCell;
use std::sync::Arc;
use std::time::Duration;

use crate::arm::{self, Arm, SETTLING, Since};
use crate::guard::{Armed, Guard, Watched, watch};
use crate::{Cause, Error, ErrorKind, Occurrence, Snapshot, StatusProblem, TripReason};

/// Events of the robot during a wait. A state that was there before does not end it: a program may wait for the button
/// that powers the arm.
struct WaitEvents {
    /// State that packets have shown since before the wait.
    before: Option<Cause>,
    since: Since,
    stops: u64,
    /// Occurrence that ends the wait, once there is one.
    found: Option<Occurrence>,
}

impl WaitEvents {
    fn since(arm: &Arm) -> Self {
        let before = arm.state.newest_packet().and_then(|newest| shown(&newest));
        Self { before, since: arm.state.now_on(), stops: arm.stops().accepted(), found: None }
    }

    /// True once something has happened.
    fn have_come(&mut self, arm: &Arm) -> bool {
        if self.found.is_none() && arm.stops().accepted() > self.stops {
            self.found = Some(Cause::Stopped.into());
        }
        if let (None, Ok(newest)) = (&self.found, arm.state.fresh_packet()) {
            self.before = self.before.filter(|before| shown(&newest) == Some(*before));
            if self.before.is_some() {
                self.since.states = newest.number;
            }
            self.found = arm.state.news(self.since, ends_wait);
        }
        self.found.is_some()
    }
}

/// State of the arm in a packet that ends a wait.
fn shown(packet: &Snapshot) -> Option<Cause> {
    let stop = arm::stop(&packet.status).map(arm::Stop::cause);
    stop.or_else(|| arm::lost(&packet.status)).filter(|cause| ends_wait(*cause))
}

/// True for news that ends a wait. A person who leads the arm by hand may press the button that is waited for, and lead
/// it to a limit.
fn ends_wait(cause: Cause) -> bool {
    cause != Cause::DragMode && cause != Cause::SoftLimit
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
