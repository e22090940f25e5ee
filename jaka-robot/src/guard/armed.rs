//! A guard that judges packets.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, Mutex};
use std::time::Duration;

use jaka_clock::lock;
use jaka_proto::wire::DecodeError;
use jaka_sync::layer::WrittenStop;

use super::Guard;
use super::condition::Judging;
use crate::arm::{ArmState, GuardProgress, PacketObserver};
use crate::{Error, GuardTrip, RobotStop, Snapshot, StatusProblem};

/// A guard that judges each packet as it comes, on the monitor's thread, until it is dropped. The owner of a motion
/// asks it, and never waits for a judgement.
///
/// A clone is the same guard.
#[derive(Debug, Clone)]
pub(crate) struct Armed(Arc<SharedGuard>);

/// [`ArmState`] has the order of locks.
#[derive(Debug)]
struct SharedGuard {
    state: Arc<ArmState>,
    /// Number of the guard in the state of the arm, which has its progress.
    number: u64,
    /// Locked during the evaluation of a packet, which runs the user's condition.
    judging: Mutex<Judging>,
    /// Locked while the stop is written.
    early: Mutex<Early>,
}

/// Stop with which the monitor's thread stops the arm at once, without another thread.
#[derive(Debug, Default)]
struct Early {
    /// None before the motion, and once it was used, or may be no more.
    stop: Option<RobotStop>,
    /// The stop that was written.
    written: Option<WrittenStop>,
}

impl Armed {
    /// Arms a guard: it has judged the newest packet, which is fresh, when this returns. If none has come lately, waits
    /// a little for one.
    pub(crate) fn new(guard: &Guard, state: &Arc<ArmState>, timeout: Duration) -> Result<Self, StatusProblem> {
        state.status_within(timeout)?;
        let shared = Arc::new(SharedGuard {
            state: Arc::clone(state),
            number: state.guard_number(),
            judging: Mutex::new(Judging::of(&guard.conditions)),
            early: Mutex::default(),
        });
        // Locked until the newest packet is judged: those that come meanwhile wait for it.
        let mut judging = lock(&shared.judging);
        let observer: Arc<dyn PacketObserver> = Arc::<SharedGuard>::clone(&shared);
        state.arm_guard(shared.number, Arc::downgrade(&observer));
        drop(observer);
        let trip = judging.judge(&state.fresh_status()?);
        shared.state.progress(shared.number, |progress| progress.take(Ok(trip)));
        drop(judging);
        Ok(Self(shared))
    }

    /// Makes the monitor's thread write this stop for a packet that calls for one, without a wait. The caller takes the
    /// result.
    pub(crate) fn stop_by(&self, stop: RobotStop) {
        lock(&self.0.early).stop = Some(stop);
    }

    /// The stop that the monitor's thread has written, if it has. It writes none any more.
    pub(crate) fn take_written(&self) -> Option<WrittenStop> {
        let mut early = lock(&self.0.early);
        early.stop = None;
        early.written.take()
    }

    /// Reason why a packet could not be judged, if one could not.
    pub(crate) fn broken(&self) -> Option<StatusProblem> {
        self.0.state.progress(self.0.number, |progress| progress.broken())
    }

    /// Trip of the guard, if it has tripped.
    pub(crate) fn trip(&self) -> Option<GuardTrip> {
        self.0.state.progress(self.0.number, |progress| progress.trip().cloned())
    }

    /// Lets the motion out, unless the guard has tripped: from here on, a trip calls for a stop. Blocks nothing and
    /// uses no connection, as a gate must.
    pub(crate) fn let_out(&self) -> Result<(), Error> {
        self.0.state.progress(self.0.number, GuardProgress::let_out)
    }

    /// Does not let the motion out any more, and says whether it was. `blind` is why the status is not known, where
    /// that is the reason.
    pub(crate) fn shut(&self, blind: Option<StatusProblem>) -> bool {
        self.0.state.progress(self.0.number, |progress| progress.shut(blind))
    }

    /// Nobody watches the guard any more: does not let the motion out, and says whether it was.
    pub(crate) fn abandon(&self) -> bool {
        self.0.state.progress(self.0.number, GuardProgress::abandon)
    }

    /// True if the motion was let out.
    pub(crate) fn has_begun(&self) -> bool {
        self.0.state.progress(self.0.number, |progress| progress.has_begun())
    }
}

impl SharedGuard {
    /// Judges a packet, unless that cannot be done.
    fn judgement(&self, packet: &Arc<Snapshot>) -> Result<Option<GuardTrip>, DecodeError> {
        match packet.panicked() {
            Some(source) => Err(source.clone()),
            None => catch_unwind(AssertUnwindSafe(|| lock(&self.judging).judge(packet)))
                .map_err(|_| DecodeError::unfit("a packet that can be judged", "a panic")),
        }
    }
}

impl PacketObserver for SharedGuard {
    /// Stops the arm after the first judgement that calls for it. Whoever learns of it waits for `early` to learn
    /// whether the stop was written.
    fn observe(&self, packet: &Arc<Snapshot>) {
        let judged = self.judgement(packet);
        if matches!(judged, Ok(None)) {
            return;
        }
        let mut early = lock(&self.early);
        let is_first = self.state.progress(self.number, |progress| progress.take(judged));
        if let Some(stop) = early.stop.take_if(|_| is_first) {
            early.written = stop.write_now();
        }
    }
}

impl Drop for SharedGuard {
    fn drop(&mut self) {
        self.state.disarm(self.number);
    }
}
