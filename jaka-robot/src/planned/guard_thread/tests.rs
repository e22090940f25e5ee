//! The threads of a guard: its own and the monitor's.

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
        let armed = Armed::new(&Guard::when("never", |_| false), &robot.arm.state, LONG).expect("the packet is fresh");
        let thread = GuardThread::new(&robot.arm, armed, Duration::MAX);
        if has_begun {
            thread.armed.let_out().expect("the guard has not tripped");
        }
        let unwound = catch_unwind(AssertUnwindSafe(|| {
            let _on_watch = OnWatch(&thread);
            resume_unwind(Box::new("as it should"));
        }));
        assert!(unwound.is_err());
        let stops: &[&str] = if has_begun { &[r#"{"cmdName":"stop_program"}"#] } else { &[] };
        assert_eq!(controller.requests(), stops);
        let error = thread.armed.let_out().expect_err("nobody watches the guard");
        assert!(!error.may_have_run(), "{error:?}");
    }
}
