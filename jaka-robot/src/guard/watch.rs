//! Waits for the trip of a guard, or for the loss of the status.

use std::sync::Arc;
use std::time::Duration;

use super::armed::Armed;
use crate::arm::ArmState;
use crate::{GuardTrip, Snapshot, StatusProblem};

/// Delay until a stale packet is seen as stale, if no other comes.
const JUST_AFTER: Duration = Duration::from_millis(1);

/// End of a wait under a guard.
#[derive(Debug)]
pub(crate) enum Watched {
    /// The guard has tripped.
    Tripped(GuardTrip),
    /// The status is not known any more.
    Blind(StatusProblem),
    /// It was called off, or the time is over; with the newest packet.
    Over(Arc<Snapshot>),
}

/// Waits until the guard trips, the status is unknown or older than `fresh_for`, the time is over, or the wait is
/// called off, which needs a wake-up of the state.
pub(crate) fn watch(
    state: &ArmState,
    armed: &Armed,
    (timeout, fresh_for): (Duration, Duration),
    is_called_off: impl Fn() -> bool,
) -> Watched {
    let since = state.clock().stopwatch();
    loop {
        if let Some(trip) = armed.trip() {
            return Watched::Tripped(trip);
        }
        if let Some(problem) = armed.broken() {
            return Watched::Blind(problem);
        }
        let newest = match state.fresh_status() {
            Ok(newest) => newest,
            Err(problem) => return Watched::Blind(problem),
        };
        let age = newest.age();
        if age > fresh_for {
            return Watched::Blind(StatusProblem::Stale { age });
        }
        let left = since.left_of(timeout);
        if left.is_zero() || is_called_off() {
            return Watched::Over(newest);
        }
        let fresh = state.stale_after().min(fresh_for).saturating_sub(age).saturating_add(JUST_AFTER);
        let is_news =
            || armed.trip().is_some() || armed.broken().is_some() || is_called_off() || state.fresh_status().is_err();
        // The result of the wait is seen above.
        let _ = state.watch(left.min(fresh), |_| is_news().then_some(()));
    }
}
