//! A panic on the guard's own thread. No code of a program runs there but a logger, so the test unwinds by itself.

use std::panic::resume_unwind;

use jaka_sim::{Controller, Delays};

use super::*;
use crate::{Config, Guard};

/// Far longer than anything takes.
const LONG: Duration = Duration::from_secs(60);

#[test]
fn a_panic_of_the_guards_own_thread_stops_a_motion_that_has_begun_and_keeps_back_one_that_has_not() {
    for has_begun in [false, true] {
        let controller = Controller::builder().delays(Delays::NONE).start().expect("loopback has free ports");
        let config = Config::new().stale_after(LONG).reply_timeout(LONG);
        let robot = config.connect_robot_at(controller.command_addr(), controller.status_addr());
        let robot = robot.expect("the controller listens");
        robot.monitor().wait_until(|_| true, LONG).expect("a packet comes on connecting");
        let armed = robot.arm(&Guard::when("never", |_| false), LONG).expect("the packet is fresh");
        let sentry = Sentry::new(&robot, armed, Duration::MAX);
        if has_begun {
            sentry.armed.let_out().expect("the guard has not tripped");
        }
        let unwound = catch_unwind(AssertUnwindSafe(|| {
            let _on_watch = OnWatch(&sentry);
            resume_unwind(Box::new("as it should"));
        }));
        assert!(unwound.is_err());
        let stops: &[&str] = if has_begun { &[r#"{"cmdName":"stop_program"}"#] } else { &[] };
        assert_eq!(controller.requests(), stops);
        let error = sentry.armed.let_out().expect_err("nobody watches the guard");
        assert!(!error.may_have_run(), "{error:?}");
    }
}
