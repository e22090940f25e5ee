//! A thread that stops a motion under a guard.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Duration;

use jaka_sync::layer::OnDrop;

use crate::arm::{Arm, ArmState, Sent};
use crate::cause::Occurrence;
use crate::guard::{Armed, Watched, watch};
use crate::{Error, GuardTrip, RobotStop, StatusProblem};

/// Stops the arm if the guard trips, or the status is unknown.
#[derive(Debug)]
pub(super) struct GuardThread {
    state: Arc<ArmState>,
    pub(super) stop: RobotStop,
    pub(super) armed: Armed,
    /// With an older packet the arm is stopped.
    fresh_for: Duration,
    /// Nobody waits for the motion any more.
    is_relieved: AtomicBool,
    /// The stop was not accepted.
    has_failed: AtomicBool,
}

impl GuardThread {
    pub(super) fn new(arm: &Arm, armed: Armed, fresh_for: Duration) -> Self {
        let (state, stop) = (Arc::clone(&arm.state), arm.stop_handle());
        armed.stop_by(stop.clone());
        let (is_relieved, has_failed) = (AtomicBool::default(), AtomicBool::default());
        Self { state, stop, armed, fresh_for, is_relieved, has_failed }
    }

    /// Watches until it is relieved, or has stopped the arm. Where the motion has not gone out, the gate keeps it back.
    pub(super) fn run(&self) -> Option<Stopped> {
        // A packet's type may panic on this thread.
        let _stops = OnDrop(|| self.stop_in_panic());
        let is_relieved = || self.is_relieved.load(Ordering::SeqCst);
        let (why, blind) = match watch(&self.state, &self.armed, (Duration::MAX, self.fresh_for), is_relieved) {
            Watched::Tripped(trip) => (Why::Trip(trip), None),
            Watched::Blind(problem) => (Why::Blind(problem.clone()), Some(problem)),
            Watched::Over(_) => return None,
        };
        if !self.armed.shut(blind) || is_relieved() {
            return None;
        }
        let stopped = self.written().unwrap_or_else(|| Stopped::new(&self.stop, Some(why)));
        self.took(&stopped.stop.accepted);
        Some(stopped)
    }

    /// The stop that the monitor's thread has written, if it has; it writes none any more. It was written because the
    /// guard had tripped, or a packet could not be judged, whatever was seen since.
    pub(super) fn written(&self) -> Option<Stopped> {
        let written = self.armed.take_written()?;
        let why = self.armed.trip().map(Why::Trip).or_else(|| self.armed.broken().map(Why::Blind));
        Some(Stopped { why, stop: self.stop.finish(written) })
    }

    /// A stop that was not accepted ends the wait.
    fn took(&self, accepted: &Result<(), Error>) {
        if accepted.is_err() {
            self.has_failed.store(true, Ordering::SeqCst);
            self.state.wake();
        }
    }

    /// Relieves the guard's thread. If a panic calls this, the arm is stopped.
    pub(super) fn relieve(&self) {
        self.is_relieved.store(true, Ordering::SeqCst);
        self.state.wake();
        self.stop_in_panic();
    }

    /// Stops the arm after a panic of the thread, or keeps the motion back. The program learns of the panic, or of the
    /// stop of the motion.
    fn stop_in_panic(&self) {
        if thread::panicking() && self.armed.abandon() {
            // A logger that panics again would end the process here.
            if let Ok(accepted) = catch_unwind(AssertUnwindSafe(|| self.stop.stop())) {
                self.took(&accepted);
            }
        }
    }

    pub(super) fn has_failed(&self) -> bool {
        self.has_failed.load(Ordering::SeqCst)
    }
}

/// A stop because of a guard.
#[derive(Debug)]
pub(super) struct Stopped {
    /// None where only the end of the wait called for it.
    pub(super) why: Option<Why>,
    pub(super) stop: Sent,
}

#[derive(Debug, Clone)]
pub(super) enum Why {
    Trip(GuardTrip),
    Blind(StatusProblem),
}

impl Stopped {
    pub(super) fn new(stop: &RobotStop, why: Option<Why>) -> Self {
        Self { why, stop: stop.end_motion() }
    }
}

/// End of a motion with an unknown status.
pub(super) fn lost(problem: &StatusProblem) -> Occurrence {
    let cause = if let StatusProblem::Ended { cause } = problem { Some(Arc::clone(cause)) } else { None };
    let unreadable = if let StatusProblem::Unreadable { source } = problem { Some(source.clone()) } else { None };
    Occurrence::status_lost(cause, unreadable)
}

#[cfg(test)]
mod tests {
    use std::panic::resume_unwind;
    use std::sync::Arc;
    use std::sync::atomic::{AtomicBool, Ordering};

    use jaka_sim::{Controller, Delays};

    use super::*;
    use crate::{Config, Guard, Robot};

    /// Far longer than anything takes.
    const LONG: Duration = Duration::from_secs(60);

    fn connected() -> (Controller, Robot) {
        let controller = Controller::builder().delays(Delays::NONE).start().expect("loopback has free ports");
        let config = Config::new().stale_after(LONG).reply_timeout(LONG);
        let robot = Robot::connect_at(&config, controller.command_addr(), controller.status_addr());
        let robot = robot.expect("the controller listens");
        robot.monitor().wait_until(|_| true, LONG).expect("a packet comes on connecting");
        (controller, robot)
    }

    /// The guard's own thread would write the stop later, after it was woken.
    #[test]
    fn the_monitors_thread_writes_the_stop_itself() {
        let (controller, robot) = connected();
        let trips = Arc::new(AtomicBool::new(false));
        let asked = Arc::clone(&trips);
        let guard = Guard::when("asked", move |_| asked.load(Ordering::Relaxed));
        let armed = Armed::new(&guard, &robot.arm.state, LONG).expect("the packet is fresh");
        armed.stop_by(robot.stop_handle());
        armed.let_out().expect("the guard has not tripped");
        trips.store(true, Ordering::Relaxed);
        assert!(controller.wait_for_requests(1, LONG), "nobody else watches the guard");
        assert_eq!(controller.requests(), [r#"{"cmdName":"stop_program"}"#]);
    }

    /// No code of a program runs on the guard's own thread but a logger, so the test unwinds by itself.
    #[test]
    fn a_panic_of_the_guards_own_thread_stops_a_motion_that_has_begun_and_keeps_back_one_that_has_not() {
        for has_begun in [false, true] {
            let (controller, robot) = connected();
            let armed =
                Armed::new(&Guard::when("never", |_| false), &robot.arm.state, LONG).expect("the packet is fresh");
            let thread = GuardThread::new(&robot.arm, armed, Duration::MAX);
            if has_begun {
                thread.armed.let_out().expect("the guard has not tripped");
            }
            let unwound = catch_unwind(AssertUnwindSafe(|| {
                let _stops = OnDrop(|| thread.stop_in_panic());
                resume_unwind(Box::new("as it should"));
            }));
            assert!(unwound.is_err());
            let stops: &[&str] = if has_begun { &[r#"{"cmdName":"stop_program"}"#] } else { &[] };
            assert_eq!(controller.requests(), stops);
            let error = thread.armed.let_out().expect_err("nobody watches the guard");
            assert!(!error.may_have_run(), "{error:?}");
        }
    }
}
