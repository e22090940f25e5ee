//! Logging through the `log` facade, by the threads that call.

use std::cell::RefCell;
use std::sync::Once;
use std::time::Duration;

use jaka_sim::{Delays, Fault};
use jaka_sync::collision::ClearError;
use jaka_tests::{Arm, LONG};
use log::{LevelFilter, Log, Metadata, Record};

thread_local! {
    /// Lines of this thread, from the SDK.
    static KEPT: RefCell<Vec<String>> = const { RefCell::new(Vec::new()) };
}

struct Keeper;

impl Log for Keeper {
    fn enabled(&self, metadata: &Metadata<'_>) -> bool {
        ["jaka_sync", "jaka_robot"].iter().any(|target| metadata.target().starts_with(target))
    }

    fn log(&self, record: &Record<'_>) {
        if self.enabled(record.metadata()) {
            KEPT.with_borrow_mut(|kept| kept.push(format!("{} {}", record.level(), record.args())));
        }
    }

    fn flush(&self) {}
}

/// Keeps the lines of this thread from now on.
fn keep() {
    static LOGGER: Once = Once::new();
    LOGGER.call_once(|| {
        log::set_logger(&Keeper).expect("it is the only one");
        log::set_max_level(LevelFilter::Trace);
    });
    KEPT.take();
}

#[test]
fn each_message_is_logged_and_each_late_reply() {
    let (controller, mut client) = Arm::simulated().with_client();
    keep();
    controller.inject(Fault::Hold);
    assert!(client.call_within(&ClearError::new(), Duration::from_millis(50)).is_err_and(|error| error.is_timeout()));
    client.set_rapid_rate(0.5).expect("it answers");
    assert_eq!(
        KEPT.take(),
        [
            r#"TRACE -> {"cmdName":"clear_error"}"#,
            r#"TRACE -> {"cmdName":"rapid_rate","rate_value":0.5}"#,
            r#"TRACE <- {"errorCode": "0", "errorMsg": "", "cmdName": "clear_error"}"#,
            "DEBUG late reply to `clear_error` dropped",
            r#"TRACE <- {"errorCode": "0", "errorMsg": "", "cmdName": "rapid_rate"}"#,
        ]
    );
}

#[test]
fn each_step_of_powering_up_is_logged_before_it_is_sent_and_when_it_is_done() {
    let slow = Arm::simulated().without_power().controller(|controller| controller.delays(Delays::REAL));
    let (_arm, mut robot) = slow.with_robot();
    keep();
    robot.power_up(LONG).expect("nothing is in its way");
    let of_steps =
        |line: &String| line.starts_with("INFO") || line.contains("-> ") && !line.contains("get_robot_state");
    let steps: Vec<_> = KEPT.take().into_iter().filter(of_steps).collect();
    assert_eq!(
        steps,
        [
            "INFO power_on is sent next",
            r#"TRACE -> {"cmdName":"power_on"}"#,
            "INFO power_on is done, after 8.0s",
            "INFO enable_robot is sent next",
            r#"TRACE -> {"cmdName":"enable_robot"}"#,
            "INFO enable_robot is done, after 3.5s",
        ]
    );
}
