//! Watching a guard and the status.

use std::sync::Arc;
use std::time::Duration;

use jaka_sync::layer::MonitorParts as _;

use super::MotionStatus;
use super::guard::Armed;
use super::readiness::fresh_status;
use crate::{GuardTrip, Monitor, Snapshot, StatusProblem};

/// How long after the newest packet has become stale that is seen, if no other comes.
const JUST_AFTER: Duration = Duration::from_millis(1);

/// What a vigil has ended with.
#[derive(Debug)]
pub(super) enum Vigil {
    /// The guard has tripped.
    Tripped(GuardTrip),
    /// The status is not known any more.
    Blind(StatusProblem),
    /// It was called off, or the time is over; with the newest packet.
    Over(Arc<Snapshot>),
}

/// Waits until the guard trips, the status is no longer known or older than `fresh_for`, the time is over, or the vigil is called off, which takes a
/// wake-up of the monitor.
pub(super) fn keep<S: MotionStatus>(
    monitor: &Monitor<S>,
    armed: &Armed,
    (timeout, fresh_for): (Duration, Duration),
    is_called_off: impl Fn() -> bool,
) -> Vigil {
    let since = monitor.clock().stopwatch();
    loop {
        if let Some(trip) = armed.trip() {
            return Vigil::Tripped(trip);
        }
        if let Some(problem) = armed.broken() {
            return Vigil::Blind(problem);
        }
        let newest = match fresh_status(monitor) {
            Ok(newest) => newest,
            Err(problem) => return Vigil::Blind(problem),
        };
        let age = newest.age();
        if age > fresh_for {
            return Vigil::Blind(StatusProblem::Stale { age });
        }
        let left = since.left_of(timeout);
        if left.is_zero() || is_called_off() {
            return Vigil::Over(newest);
        }
        let fresh = monitor.stale_after().min(fresh_for).saturating_sub(age).saturating_add(JUST_AFTER);
        let is_news =
            || armed.trip().is_some() || armed.broken().is_some() || is_called_off() || fresh_status(monitor).is_err();
        // What it found is seen above.
        let _ = monitor.watch(left.min(fresh), |_| is_news().then_some(()));
    }
}
