//! Powering up: what ends the wait between two steps.

use std::time::Duration;

use jaka_robot::jaka_sync::ErrorKind as Failure;
use jaka_robot::{Cause, ErrorKind};
use jaka_sim::{Delays, Firmware, Port};
use jaka_tests::simulated::beside;
use jaka_tests::{Arm, LONG};

use super::changes;

/// Time between two queries of the state, and a little more.
const SOON: Duration = Duration::from_millis(110);

const BEFORE: Duration = Duration::from_secs(2);

/// An arm whose controller acknowledges each step at once.
fn without_power() -> Arm {
    let slow = |controller: jaka_sim::Builder| controller.firmware(Firmware::Newer).delays(Delays::REAL);
    Arm::simulated().status_period(Duration::from_millis(100)).without_power().controller(slow).start()
}

/// Powering up takes 8 s, which the controller says it has not done when the stop comes.
#[test]
fn a_stop_ends_the_wait_for_a_step_and_not_only_the_next_step() {
    let arm = without_power();
    let mut robot = arm.robot();
    let (clock, stop) = (arm.clock(), robot.stop_handle());
    let stops = || {
        clock.sleep(BEFORE);
        stop.stop().expect("the controller takes the stop");
    };
    let since = clock.elapsed();
    let error = beside(clock, stops, || robot.power_up(LONG)).expect_err("it was stopped");
    let took = clock.elapsed().saturating_sub(since);
    let ErrorKind::Stopped { accepted, not_sent } = error.kind() else { panic!("{error:?}") };
    assert_eq!((&accepted[..], &not_sent[..]), (&["power_on".to_owned()][..], &["enable_robot".to_owned()][..]));
    assert!((BEFORE..BEFORE + SOON).contains(&took), "{took:?}");
    assert_eq!(changes(&arm), ["power_on", "stop_program"]);
}

#[test]
fn an_emergency_stop_ends_the_wait_for_a_step() {
    let arm = without_power();
    let mut robot = arm.robot();
    let clock = arm.clock();
    let presses = || {
        clock.sleep(BEFORE);
        arm.press_emergency_stop();
    };
    let since = clock.elapsed();
    let error = beside(clock, presses, || robot.power_up(LONG)).expect_err("the emergency stop is pressed");
    let took = clock.elapsed().saturating_sub(since);
    assert!(
        matches!(error.kind(), ErrorKind::NotReady { occurrence } if occurrence.cause == Cause::EmergencyStop),
        "{error:?}"
    );
    assert!((BEFORE..BEFORE + SOON).contains(&took), "{took:?}");
    assert_eq!(changes(&arm), ["power_on"]);
}

/// The controller has done the last step, and packets that show it are late.
#[test]
fn a_stop_after_the_last_step_is_told() {
    let arm = without_power();
    let mut robot = arm.robot();
    let (clock, stop) = (arm.clock(), robot.stop_handle());
    let stops = || {
        // Power takes 8 s, and enabling 3.5 s.
        clock.sleep(Duration::from_secs(11));
        arm.link(Port::Status).to_client().delay(Duration::from_secs(2));
        clock.sleep(Duration::from_secs(1));
        assert!(arm.state().enabled);
        stop.stop().expect("the controller takes the stop");
    };
    let error = beside(clock, stops, || robot.power_up(LONG)).expect_err("it was stopped");
    let ErrorKind::Stopped { accepted, not_sent } = error.kind() else { panic!("{error:?}") };
    assert!(accepted.len() == 2 && not_sent.is_empty(), "{error}");
    assert_eq!(changes(&arm), ["power_on", "enable_robot", "stop_program"]);
}

#[test]
fn powering_up_ends_at_its_deadline_and_not_with_the_next_query() {
    let arm = without_power();
    let mut robot = arm.robot();
    let (since, deadline) = (arm.clock().elapsed(), Duration::from_millis(250));
    let error = robot.power_up(deadline).expect_err("it takes seconds");
    assert!(matches!(jaka_tests::failure(&error), Some(Failure::StateTimeout { .. })), "{error:?}");
    assert_eq!(arm.clock().elapsed().saturating_sub(since), deadline);
}
