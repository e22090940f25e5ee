//! A guard that judges packets.

use std::io;
use std::ops::ControlFlow;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, Mutex};
use std::time::Duration;

use jaka_proto::wire::DecodeError;
use jaka_sync::layer::{MonitorParts as _, lock};

use super::Guard;
use super::condition::Judge;
use crate::robot::readiness::{fresh_status, unknown};
use crate::robot::stops::Written;
use crate::robot::{MotionStatus, RobotStop};
use crate::{Error, ErrorKind, GuardTrip, Monitor, Robot, Snapshot, StatusProblem};

/// A guard that judges each packet as it comes, on the monitor's thread, until it is dropped. The owner of a motion asks it, and never
/// waits for a judgement.
///
/// A clone is the same guard.
#[derive(Debug, Clone)]
pub(crate) struct Armed(Arc<Shared>);

#[derive(Debug)]
struct Shared {
    /// Locked while a packet is judged, which may take as long as the user's question does. The monitor's board and `progress` may be
    /// locked under it.
    judging: Mutex<Judging>,
    /// Nothing is locked under it.
    progress: Mutex<Progress>,
    /// Locked while the stop is written, for which the link's state is locked.
    early: Mutex<Early>,
}

/// What the monitor's thread stops the arm by, at once, without another thread.
#[derive(Debug, Default)]
struct Early {
    /// None before the motion, and once it was used, or may be no more.
    stop: Option<RobotStop>,
    /// The stop that was written.
    written: Option<Written>,
}

#[derive(Debug)]
struct Judging {
    judges: Vec<Judge>,
    /// The number of the last packet that was judged.
    last: u64,
}

#[derive(Debug, Default)]
struct Progress {
    trip: Option<GuardTrip>,
    /// Why the status was not known before the motion was let out, if that was so: then it is not any more.
    blind: Option<StatusProblem>,
    /// True once the motion was let out.
    has_begun: bool,
    /// Why a packet could not be judged, if one could not: as a rule, its own type has panicked.
    broken: Option<DecodeError>,
    /// True once nobody watches the guard any more.
    is_abandoned: bool,
}

impl Armed {
    /// A guard that has judged the newest packet, and judges all that follow.
    fn new<S: MotionStatus>(
        guard: &Guard,
        monitor: &Monitor<S>,
        newest: impl FnOnce() -> Result<Arc<Snapshot>, StatusProblem>,
    ) -> Result<Self, StatusProblem> {
        let judging = Judging { judges: guard.conditions.iter().cloned().map(Judge::new).collect(), last: 0 };
        let shared =
            Arc::new(Shared { judging: Mutex::new(judging), progress: Mutex::default(), early: Mutex::default() });
        // Locked until the newest packet is judged: those that come meanwhile wait for it.
        let mut judging = lock(&shared.judging);
        let (weak, waker) = (Arc::downgrade(&shared), monitor.waker());
        monitor.observe_first(move |snapshot| {
            let Some(shared) = weak.upgrade() else { return ControlFlow::Break(()) };
            if shared.act_on(shared.judge(&S::snapshot(snapshot))) {
                // At once: the user's observers, which may take their time, come before the monitor itself wakes anybody.
                waker.wake();
            }
            ControlFlow::Continue(())
        });
        let trip = judging.judge(&newest()?);
        shared.take(Ok(trip));
        drop(judging);
        Ok(Self(shared))
    }

    /// Has the monitor's thread write this stop where a packet calls for one and nothing has to be waited for. Whoever gave it takes what was written.
    pub(in crate::robot) fn stop_by(&self, stop: RobotStop) {
        lock(&self.0.early).stop = Some(stop);
    }

    /// The stop that the monitor's thread has written, if it has. It writes none any more.
    pub(in crate::robot) fn take_written(&self) -> Option<Written> {
        let mut early = lock(&self.0.early);
        early.stop = None;
        early.written.take()
    }

    /// Why a packet could not be judged, if one could not.
    pub(crate) fn broken(&self) -> Option<StatusProblem> {
        lock(&self.0.progress).broken()
    }

    /// Why the guard has tripped, if it has.
    pub(crate) fn trip(&self) -> Option<GuardTrip> {
        lock(&self.0.progress).trip.clone()
    }

    /// Lets the motion out, unless the guard has tripped: from here on, a trip calls for a stop. Blocks nothing and uses no connection, as
    /// a gate must.
    pub(crate) fn let_out(&self) -> Result<(), Error> {
        let mut progress = lock(&self.0.progress);
        if let Some(trip) = progress.trip.clone() {
            return Err(trip.before_start().into_error());
        }
        if let Some(problem) = progress.blind.clone().or_else(|| progress.broken()) {
            return Err(unknown(problem));
        }
        if progress.is_abandoned {
            let source = io::Error::other("the thread that watches the guard has panicked");
            return Err(ErrorKind::Thread { source }.into());
        }
        progress.has_begun = true;
        Ok(())
    }

    /// Does not let the motion out any more, and says whether it was. `blind` is why the status is not known, where that is the reason.
    pub(crate) fn shut(&self, blind: Option<StatusProblem>) -> bool {
        let mut progress = lock(&self.0.progress);
        progress.blind = blind;
        progress.has_begun
    }

    /// Nobody watches the guard any more: does not let the motion out, and says whether it was.
    pub(crate) fn abandon(&self) -> bool {
        let mut progress = lock(&self.0.progress);
        progress.is_abandoned = true;
        progress.has_begun
    }

    /// True if the motion was let out.
    pub(crate) fn has_begun(&self) -> bool {
        lock(&self.0.progress).has_begun
    }
}

impl Shared {
    /// Judges a packet, unless that cannot be done.
    fn judge(&self, packet: &Arc<Snapshot>) -> Result<Option<GuardTrip>, DecodeError> {
        match packet.panicked() {
            Some(source) => Err(source.clone()),
            None => catch_unwind(AssertUnwindSafe(|| lock(&self.judging).judge(packet)))
                .map_err(|_| DecodeError::unfit("a packet that can be judged", "a panic")),
        }
    }

    /// Takes a judgement, and stops the arm after the first one that calls for it: true if it is news. Whoever learns of it waits for `early` to learn whether the
    /// stop was written.
    fn act_on(&self, judged: Result<Option<GuardTrip>, DecodeError>) -> bool {
        if matches!(judged, Ok(None)) {
            return false;
        }
        let mut early = lock(&self.early);
        let is_first = lock(&self.progress).calls_for_first_stop();
        let is_news = self.take(judged);
        if let Some(stop) = early.stop.take_if(|_| is_first) {
            early.written = stop.write_now();
        }
        is_news
    }

    /// Takes a judgement: true if it is news.
    fn take(&self, result: Result<Option<GuardTrip>, DecodeError>) -> bool {
        let mut progress = lock(&self.progress);
        match result {
            Ok(None) => return false,
            Ok(Some(_)) if progress.trip.is_some() => return false,
            Ok(trip) => progress.trip = trip,
            Err(source) => progress.broken = Some(source),
        }
        true
    }
}

impl Progress {
    /// True if the next judgement is the first for which the arm is stopped.
    fn calls_for_first_stop(&self) -> bool {
        self.has_begun && self.trip.is_none() && self.broken.is_none()
    }

    fn broken(&self) -> Option<StatusProblem> {
        self.broken.clone().map(|source| StatusProblem::Unreadable { source })
    }
}

impl Judging {
    /// Judges a packet: the first condition that trips, if one does.
    fn judge(&mut self, packet: &Arc<Snapshot>) -> Option<GuardTrip> {
        if packet.number <= self.last {
            return None;
        }
        self.last = packet.number;
        let (condition, reason, text) = self.judges.iter_mut().enumerate().find_map(|(condition, judge)| {
            let reason = judge.judge(packet)?;
            Some((condition, reason, judge.condition.to_string()))
        })?;
        let packet = Arc::clone(packet);
        Some(GuardTrip {
            condition,
            text,
            reason,
            packet,
            reaction: None,
            is_before_start: false,
            is_at_rest: false,
            lag: None,
        })
    }
}

impl<S: MotionStatus> Robot<S> {
    /// Arms a guard: it has judged the newest packet, which is fresh, when this returns. If none has come lately, waits a little for one.
    pub(crate) fn arm(&self, guard: &Guard, timeout: Duration) -> Result<Armed, StatusProblem> {
        self.status_now(timeout)?;
        Armed::new(guard, self.monitor(), || fresh_status(self.monitor()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn armed() -> Armed {
        let judging = Mutex::new(Judging { judges: Vec::new(), last: 0 });
        Armed(Arc::new(Shared { judging, progress: Mutex::default(), early: Mutex::default() }))
    }

    #[test]
    fn what_nobody_watches_is_not_let_out() {
        let watched = armed();
        assert!(watched.let_out().is_ok() && watched.abandon(), "it is out");
        let abandoned = armed();
        assert!(!abandoned.abandon());
        let error = abandoned.let_out().expect_err("nobody watches it");
        assert!(matches!(error.kind(), ErrorKind::Thread { .. }) && !error.may_have_run(), "{error:?}");
        assert!(!abandoned.has_begun());
    }
}
