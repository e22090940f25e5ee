//! Stops of the program's own that are on their way while the robot waits, or is acknowledged.

use std::time::Duration;

use jaka_robot::{Cause, ErrorKind, Occurrence, Robot, RobotConfig, RobotStop, Target};
use jaka_sim::{Controller, Delays, Fault, Port};
use jaka_tests::simulated::beside;
use jaka_tests::{Arm, Configured as _, LONG};

use super::{FAR, Hooked, arm, assert_moves, assert_stopped_on_the_way, changes, names, refusal, to};

/// Calls `act` while a stop has been received by the controller and is not answered; then lets the reply pass.
fn while_a_stop_is_on_its_way<T>(arm: &Arm, stop: &RobotStop, is_taken: bool, act: impl FnOnce() -> T) -> T {
    let received = arm.requests().len() + 1;
    arm.link(Port::Command).to_client().hold();
    let stops = || assert_eq!(stop.stop().is_ok(), is_taken);
    beside(arm.clock(), stops, || {
        assert!(arm.wait_for_requests(received, LONG));
        let done = act();
        arm.link(Port::Command).to_client().release();
        done
    })
}

fn assert_kept_back(robot: &mut Robot) {
    let error = robot.start(&to(FAR)).expect_err("a stop was asked for");
    assert!(
        matches!(error.kind(), ErrorKind::NotAcknowledged { occurrence: Occurrence { cause: Cause::Stopped, .. } }),
        "{error:?}"
    );
}

#[test]
fn a_stop_on_its_way_keeps_motions_back_also_when_it_was_acknowledged_meanwhile() {
    let (arm, mut robot) = arm().with_robot();
    let stop = robot.stop_handle();
    while_a_stop_is_on_its_way(&arm, &stop, true, || {
        robot.acknowledge();
        assert!(robot.unacknowledged().is_some_and(|found| found.cause == Cause::Stopped));
        assert_kept_back(&mut robot);
    });
    assert_eq!(names(&arm), ["stop_program"]);
    // It was acknowledged, and has been accepted.
    assert_moves(&mut robot);
}

#[test]
fn a_stop_that_fails_after_it_was_acknowledged_keeps_motions_back() {
    let (arm, mut robot) = arm().with_robot();
    let stop = robot.stop_handle();
    arm.inject_for("stop_program", refusal("stop_program"));
    while_a_stop_is_on_its_way(&arm, &stop, false, || robot.acknowledge());
    assert_kept_back(&mut robot);
    assert_eq!(names(&arm), ["stop_program"]);
    robot.acknowledge();
    assert_moves(&mut robot);
}

/// Queries are not answered, so that packets alone show rest; the target is not known, so that rest alone says nothing
/// of a stop.
#[test]
fn rest_by_a_stop_that_is_not_answered_yet_is_told_as_a_stop() {
    // Packets say for a while that the arm has not left, and so it is asked for its position.
    let (arm, robot) = arm().controller(|controller| controller.delays(Delays::REAL)).with_robot();
    let mut robot =
        robot.configured(&RobotConfig::new().start_grace(Duration::from_millis(100), 3)).expect("it has no limits");
    let stop = robot.stop_handle();
    for _ in 0..10 {
        arm.inject_for("get_joint_pos", refusal("get_joint_pos"));
    }
    let stops = move |controller: &Controller| {
        controller.link(Port::Command).to_client().hold();
        stop.stop().expect("the controller takes the stop");
    };
    let stopping = arm.when(|state| state.joint_position.0[0] > 5.0, stops).expect("a thread starts");
    let end = robot.run(&Hooked { target: Target::Unknown, ..Hooked::default() }, LONG).expect("it is accepted");
    assert!(end.cause() == Cause::Stopped, "{:?}", end.cause());
    assert!(end.report.waited < Duration::from_secs(2), "its reply was not waited for: {:?}", end.report.waited);
    assert_stopped_on_the_way(&arm);
    arm.link(Port::Command).to_client().release();
    assert!(stopping.wait(LONG));
}

#[test]
fn a_stop_that_a_packet_shows_takes_the_place_of_a_lost_status() {
    let (arm, robot) = arm().with_robot();
    let mut robot =
        robot.configured(&RobotConfig::new().status_silence(Duration::from_secs(1))).expect("it has no limits");
    robot.start(&to(FAR)).expect("it is accepted");
    let link = || arm.link(Port::Status).to_client();
    link().hold();
    let end = robot.wait(LONG);
    assert!(end.cause() == Cause::StatusLost, "{:?}", end.cause());
    arm.collide();
    link().release();
    arm.clock().sleep(Duration::from_secs(1));
    assert!(
        robot.unacknowledged().is_some_and(|found| found.cause == Cause::ProtectiveStop),
        "{:?}",
        robot.unacknowledged()
    );
}

#[test]
fn a_motion_that_was_acknowledged_is_not_waited_for() {
    let (arm, mut robot) = arm().with_robot();
    robot.start(&to(FAR)).expect("it is accepted");
    robot.stop_handle().stop().expect("the controller takes the stop");
    robot.acknowledge();
    let end = robot.wait(LONG);
    assert!(end.cause() == Cause::NoMotion, "{:?}", end.cause());
    assert_eq!(changes(&arm), ["joint_move", "stop_program"]);
}

#[test]
fn a_motion_whose_reply_was_lost_is_waited_for() {
    let (arm, mut robot) = arm().with_robot();
    arm.inject_for("joint_move", Fault::Drop);
    let error = robot.run(&to(FAR), Duration::from_secs(1)).expect_err("no reply comes");
    assert!(error.may_have_run(), "{error:?}");
    let end = robot.wait(LONG);
    // Which motion that was is not known.
    assert!(end.cause() == Cause::AtRest, "{:?}", end.cause());
    assert!((arm.state().joint_position.0[0] - FAR).abs() < 0.1);
}
