//! Whether the robot's state is known well enough to move it: an unknown state counts as a bad one.

use std::error::Error as StdError;
use std::sync::Arc;
use std::time::Duration;

use jaka_proto::wire::DecodeError;

use super::{Explanation, MotionStatus, Outcome, Robot, trouble};
use crate::worded::worded;
use crate::{Disconnect, Error, ErrorKind, Monitor, Snapshot};

worded! {
    /// Why the state of a robot is not known.
    #[derive(Debug, Clone)]
    #[non_exhaustive]
    pub enum StatusProblem {
        /// No status packet has come since the monitor connected.
        Missing {
            /// Where it is connected to, with the port.
            address: String,
        } =>
            "no status packet has come from {address}; check that this is the status port, 10000, and that the controller has started",
        /// No status packet has come for longer than [`Config::stale_after`](crate::Config::stale_after).
        Stale {
            /// How long ago the last one came.
            age: Duration,
        } => "the last status packet came {age:.1?} ago; check the network, and wait until packets come again",
        /// Packets have just resumed after a silence; the first may be old ones that the network had held back.
        Resuming => "status packets have just resumed after a silence, and may be old; try again in a moment",
        /// The status connection has ended for good.
        Ended {
            /// Why.
            cause: Arc<Disconnect>,
        } => "the status connection has ended ({cause}); make a new `Robot`, or set `Config::reconnect`",
        /// The status connection was lost, and the monitor is connecting again.
        Reconnecting =>
            "the status connection was lost, and the monitor is reconnecting; wait until packets come again",
        /// The newest packet cannot be read, or does not show whether the arm is stopped.
        Unreadable {
            /// Which field, and why.
            source: DecodeError,
        } => "the newest status packet does not show whether the arm is stopped: {source}",
    }
}

/// The cause of [`Ended`](Self::Ended) is part of this one's text: its source is the source of that.
impl StdError for StatusProblem {
    fn source(&self) -> Option<&(dyn StdError + 'static)> {
        if let Self::Ended { cause } = self { cause.source() } else { None }
    }
}

impl<S: MotionStatus> Robot<S> {
    /// The newest packet, if it is fresh and can be read. If none has come lately, waits a little for one.
    pub(super) fn status_now(&self, timeout: Duration) -> Result<Arc<Snapshot>, StatusProblem> {
        let now = self.monitor.fresh_packet();
        if !matches!(now, Err(StatusProblem::Missing { .. } | StatusProblem::Stale { .. } | StatusProblem::Resuming)) {
            return readable::<S>(now);
        }
        let patience = self.monitor.stale_after.min(timeout);
        // Its result is what `fresh_packet` says next.
        let _ = self.monitor.watch(patience, |_| self.monitor.fresh_packet().ok());
        readable::<S>(self.monitor.fresh_packet())
    }

    /// The same for what must not be done without it; `None` if the program has allowed motion without it.
    pub(crate) fn known_status(&self, timeout: Duration) -> Result<Option<Arc<Snapshot>>, Error> {
        match self.status_now(timeout) {
            Ok(snapshot) => Ok(Some(snapshot)),
            Err(_) if self.moves_without_status => Ok(None),
            Err(problem) => Err(self.client.link.attach(unknown(problem))),
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
                Some(Outcome::Stopped) if !latch.has_sent_stop() => Ok(()),
                Some(outcome) => Err(ErrorKind::NotAcknowledged { outcome }.into()),
            }
        }
    }

    /// Lets set-points pass that hold the arm: those that brake it pass, and no stop has begun.
    pub(crate) fn holding_gate(&self) -> impl Fn() -> Result<(), Error> + use<S> {
        let (latch, braking) = (self.latch.clone(), self.braking_gate());
        move || {
            braking()?;
            latch.unacknowledged_stop().map_or(Ok(()), |outcome| Err(ErrorKind::NotAcknowledged { outcome }.into()))
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
    match trouble::unreadable(&snapshot) {
        Some(source) => Err(StatusProblem::Unreadable { source }),
        None => Ok(snapshot),
    }
}

/// The newest packet counts, even if what earlier packets showed has been acknowledged.
fn check_stops(newest: &Snapshot) -> Result<(), Error> {
    let explanation = match trouble::stop(&newest.status) {
        None => return Ok(()),
        Some(Outcome::EmergencyStop) => Explanation::EmergencyStop,
        Some(_) => Explanation::ProtectiveStop,
    };
    Err(ErrorKind::NotReady { explanation }.into())
}

pub(super) fn unknown(problem: StatusProblem) -> Error {
    ErrorKind::StatusUnknown { problem }.into()
}
