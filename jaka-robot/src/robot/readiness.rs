//! Whether the robot's state is known well enough to move it: an unknown state counts as a bad one.

use std::sync::Arc;
use std::time::Duration;

use jaka_sync::layer::{ClientParts as _, MonitorParts as _};

use super::{MotionStatus, Robot, trouble};
use crate::error::Attach as _;
use crate::{Cause, Error, ErrorKind, Monitor, Snapshot, StatusProblem};

impl<S: MotionStatus> Robot<S> {
    /// The newest packet, if it is fresh and can be read. If none has come lately, waits a little for one.
    pub(super) fn status_now(&self, timeout: Duration) -> Result<Arc<Snapshot>, StatusProblem> {
        let now = self.monitor.fresh_packet();
        if !matches!(now, Err(StatusProblem::Missing { .. } | StatusProblem::Stale { .. } | StatusProblem::Resuming)) {
            return readable::<S>(now);
        }
        let patience = self.monitor.stale_after().min(timeout);
        // Its result is what `fresh_packet` says next.
        let _ = self.monitor.watch(patience, |_| self.monitor.fresh_packet().ok());
        readable::<S>(self.monitor.fresh_packet())
    }

    /// The same for what must not be done without it; `None` if the program has allowed motion without it.
    pub(crate) fn known_status(&self, timeout: Duration) -> Result<Option<Arc<Snapshot>>, Error> {
        match self.status_now(timeout) {
            Ok(snapshot) => Ok(Some(snapshot)),
            Err(_) if self.moves_without_status => Ok(None),
            Err(problem) => Err(self.client.link().attach(unknown(problem))),
        }
    }

    /// Blocks what would move the arm after a stop, or while the robot's state is not known. A stop that has begun by the time of the
    /// write is on the wire before it, or will be sent after it.
    pub(crate) fn gate(&self) -> impl Fn() -> Result<(), Error> + use<S> {
        let latch = self.latch.clone();
        let monitor = (!self.moves_without_status).then(|| Arc::clone(&self.monitor));
        move || {
            if let Some(monitor) = &monitor {
                let newest = readable(monitor.fresh_packet()).map_err(unknown)?;
                check_stops(&newest)?;
            }
            latch.check()
        }
    }

    /// Lets set-points pass that brake the arm, also where the status is no longer known, and before a stop of the program's own goes out: only that and
    /// a protective or an emergency stop block them.
    pub(crate) fn braking_gate(&self) -> impl Fn() -> Result<(), Error> + use<S> {
        let (latch, monitor) = (self.latch.clone(), Arc::clone(&self.monitor));
        move || {
            if let Ok(newest) = readable(monitor.fresh_packet()) {
                check_stops(&newest)?;
            }
            match latch.unacknowledged_stop() {
                None => Ok(()),
                Some(found) if found.cause == Cause::Stopped && !latch.has_sent_stop() => Ok(()),
                Some(occurrence) => Err(ErrorKind::NotAcknowledged { occurrence }.into()),
            }
        }
    }

    /// Lets set-points pass that hold the arm: those that brake it pass, and no stop has begun.
    pub(crate) fn holding_gate(&self) -> impl Fn() -> Result<(), Error> + use<S> {
        let (latch, braking) = (self.latch.clone(), self.braking_gate());
        move || {
            braking()?;
            let stop = latch.unacknowledged_stop();
            stop.map_or(Ok(()), |occurrence| Err(ErrorKind::NotAcknowledged { occurrence }.into()))
        }
    }
}

/// The newest packet, if it is fresh and can be read.
pub(in crate::robot) fn fresh_status<S: MotionStatus>(monitor: &Monitor<S>) -> Result<Arc<Snapshot>, StatusProblem> {
    readable(monitor.fresh_packet())
}

fn readable<S: MotionStatus>(
    snapshot: Result<Arc<Snapshot<S>>, StatusProblem>,
) -> Result<Arc<Snapshot>, StatusProblem> {
    let snapshot = S::snapshot(&snapshot?);
    match snapshot.unreadable() {
        Some(source) => Err(StatusProblem::Unreadable { source }),
        None => Ok(snapshot),
    }
}

/// The newest packet counts, even if what earlier packets showed has been acknowledged.
fn check_stops(newest: &Snapshot) -> Result<(), Error> {
    let stop = trouble::stop(&newest.status);
    stop.map_or(Ok(()), |stop| Err(ErrorKind::NotReady { explanation: stop.explanation() }.into()))
}

pub(super) fn unknown(problem: StatusProblem) -> Error {
    ErrorKind::StatusUnknown { problem }.into()
}
