//! Waits for the end of a motion: pauses, and answers to queries of an earlier time.

use std::sync::Arc;
use std::time::Duration;

use jaka_robot::motion::JointMove;
use jaka_robot::{Cause, Phase, Rest, Robot, RobotConfig};
use jaka_sim::{Delays, Fault, Habit};
use jaka_tests::simulated::beside;
use jaka_tests::{Arm, Configured as _, LONG};
use serde_json::Value;

use super::{FAR, Hooked, PERIOD, arm, names, refusal, to};

/// Sets what packets show of a pause, whatever the arm does.
fn show(arm: &Arm, paused: bool, in_position: bool) {
    arm.set_status([("paused".to_owned(), Value::from(paused)), ("inpos".to_owned(), Value::from(in_position))]);
}

/// An arm that is paused is in position, and its joints stand still: packets and answers show all that rest does.
#[test]
fn a_pause_is_no_rest() {
    let (arm, mut robot) = arm().with_robot();
    robot.start(&to(FAR)).expect("it is accepted");
    arm.clock().sleep(Duration::from_secs(1));
    arm.set_state(|state| state.rapid_rate = 0.0);
    show(&arm, true, true);
    let asked = names(&arm).len();
    let end = robot.wait(Duration::from_secs(5));
    assert!(end.cause() == Cause::Deadline, "{:?}", end.cause());
    assert!(arm.state().joint_position.0[0] < FAR / 2.0, "it is paused");
    assert_eq!(names(&arm).len(), asked, "nobody asks a paused arm where it is");
    arm.set_state(|state| state.rapid_rate = 1.0);
    show(&arm, false, false);
    arm.when(|state| state.at_rest, |controller| controller.set_status([("inpos".to_owned(), true.into())]))
        .expect("a thread starts");
    let end = robot.wait(LONG);
    assert!(end.cause() == Cause::Reached, "{:?}", end.cause());
    assert!((arm.state().joint_position.0[0] - FAR).abs() < 0.1);
}

/// It goes on from somewhere else once it is resumed: where it stands is not where the motion begins.
#[test]
fn a_motion_by_an_offset_of_an_arm_that_is_paused_has_no_known_target() {
    let (arm, mut robot) = arm().with_robot();
    show(&arm, true, true);
    arm.clock().sleep(Duration::from_millis(100));
    robot.start(&JointMove::relative([5.0, 0.0, 0.0, 0.0, 0.0, 0.0], 25.0)).expect("it is accepted");
    assert_eq!(names(&arm), ["joint_move"]);
    show(&arm, false, true);
    let end = robot.wait(LONG);
    assert!(end.cause() == Cause::AtRest, "{:?}", end.cause());
}

/// Leaves a query outstanding, which was sent where the arm is at this angle, and nothing to wait for.
fn leave_a_query(arm: &Arm, robot: &mut Robot, angle: f64) {
    arm.inject_for("get_joint_pos", Fault::Hold);
    let end = robot.run(&to(angle), Duration::from_secs(10)).expect("it is accepted");
    assert_eq!((end.cause(), end.phase()), (Cause::Unanswered, Phase::MayStillMove), "{end}");
    robot.acknowledge();
}

/// It would begin the time for which the arm must be seen at rest with an answer of before the motion.
#[test]
fn an_answer_to_a_query_of_before_the_motion_says_nothing_of_its_end() {
    let (arm, mut robot) = arm().with_robot();
    leave_a_query(&arm, &mut robot, 20.0);
    // A motion without length: it ends once the arm has been seen at rest for the grace. The answer comes with the
    // reply to it.
    let mut waited = || {
        let end = robot.run(&to(20.0), LONG).expect("it is accepted");
        assert!(end.cause() == Cause::Reached, "{:?}", end.cause());
        end.report.waited
    };
    let (with_old_answer, without) = (waited(), waited());
    // It would be 200 ms less.
    assert!(with_old_answer + 5 * PERIOD >= without, "{with_old_answer:?}, {without:?}");
}

#[test]
fn where_a_motion_by_an_offset_begins_is_asked_anew() {
    let (arm, mut robot) = arm().with_robot();
    leave_a_query(&arm, &mut robot, 20.0);
    // The answer that is on its way says 20 deg.
    arm.set_state(|state| state.joint_position.0[0] = 0.0);
    arm.clock().sleep(Duration::from_millis(100));
    arm.release();
    let offset = JointMove::relative([5.0, 0.0, 0.0, 0.0, 0.0, 0.0], 25.0);
    let end = robot.run(&offset, LONG).expect("it is accepted");
    assert!(end.cause() == Cause::Reached, "{:?}", end.cause());
    assert!((arm.state().joint_position.0[0] - 5.0).abs() < 0.1);
}

/// The newest packet when the motion is accepted shows an arm that is not enabled. It came before the motion, and after
/// an earlier one.
#[test]
fn a_packet_of_before_the_motion_says_nothing_of_its_end() {
    for is_after_another in [false, true] {
        let (arm, mut robot) = arm().with_robot();
        let monitor = Arc::clone(robot.monitor());
        if is_after_another {
            robot.start(&to(5.0)).expect("it is accepted");
            arm.clock().sleep(Duration::from_secs(1));
        }
        let shows = |enabled: bool| arm.set_status([("enabled".to_owned(), enabled.into())]);
        let disabled_for_a_packet = || {
            shows(false);
            while monitor.last_known_packet().is_none_or(|newest| newest.status.enabled != Some(false)) {
                arm.clock().sleep(Duration::from_millis(1));
            }
            // Time stands still until the motion is accepted.
            shows(true);
        };
        let motion = Hooked { before_sending: &disabled_for_a_packet, ..Hooked::default() };
        let end = robot.run(&motion, LONG).expect("it is accepted");
        assert!(end.cause() == Cause::Reached, "after another: {is_after_another}, {:?}", end.cause());
    }
}

/// With a second one of the same name it would not be known which of them a reply answers.
#[test]
fn no_query_is_sent_while_another_is_outstanding() {
    let (arm, mut robot) = arm().with_robot();
    leave_a_query(&arm, &mut robot, 20.0);
    let asked = names(&arm);
    let offset = JointMove::relative([5.0, 0.0, 0.0, 0.0, 0.0, 0.0], 25.0);
    let error = robot.run(&offset, Duration::from_secs(1)).expect_err("the answer does not come");
    assert!(error.is_timeout(), "{error:?}");
    assert_eq!(names(&arm), asked);
}

/// Number of position queries before a motion by an offset, which then ends.
fn questions_before_an_offset(arm: &Arm, robot: &mut Robot) -> usize {
    let before = names(arm).len();
    robot.start(&JointMove::relative([1.0, 0.0, 0.0, 0.0, 0.0, 0.0], 25.0)).expect("it is accepted");
    let questions = names(arm)[before..].iter().take_while(|name| *name == "get_joint_pos").count();
    robot.wait(LONG).at_rest().expect("nothing stops it");
    questions
}

#[test]
fn where_a_motion_by_an_offset_begins_takes_three_answers_unless_rest_was_seen() {
    let (arm, mut robot) = arm().with_robot();
    assert_eq!(questions_before_an_offset(&arm, &mut robot), 3, "nothing is known of the arm");
    assert_eq!(questions_before_an_offset(&arm, &mut robot), 1, "the wait has seen it at rest");
    robot.client().get_version().expect("it answers");
    assert_eq!(questions_before_an_offset(&arm, &mut robot), 3, "the program may have sent a motion");
    for _ in 0..20 {
        arm.inject_for("get_joint_pos", refusal("get_joint_pos"));
    }
    let end = robot.run(&to(20.0), LONG).expect("it is accepted");
    assert!(end.rest == Rest::Packets && end.error.is_some(), "{end}");
    end.at_rest().expect("nothing shows that it is elsewhere");
    arm.clear_faults();
    assert_eq!(questions_before_an_offset(&arm, &mut robot), 3, "packets alone have shown rest");
}

/// The arm pauses between two motions where the last one ends.
#[test]
fn an_answer_at_the_target_of_a_queue_is_not_its_end() {
    let pause = Habit::Pause(Duration::from_millis(200));
    let (arm, mut robot) = arm().controller(|controller| controller.habits([pause])).with_robot();
    for angle in [20.0, 40.0, 20.0] {
        robot.start(&to(angle)).expect("it is accepted");
    }
    let end = robot.wait(LONG);
    assert!(end.cause() == Cause::Reached && arm.state().at_rest, "{:?}", end.cause());
    // Sixty degrees at 25 deg/s.
    assert!(end.report.waited > Duration::from_millis(2400), "{:?}", end.report.waited);
}

/// Packets say that it is in position while it has not begun to move, and come seldom.
#[test]
fn an_arm_that_begins_late_is_not_at_rest_before_enough_packets_have_said_so() {
    let mut delays = Delays::NONE;
    delays.in_position = Duration::from_secs(1);
    let slow = arm().status_period(Duration::from_millis(100)).controller(|controller| controller.delays(delays));
    let (arm, robot) = slow.with_robot();
    let mut robot =
        robot.configured(&RobotConfig::new().start_grace(Duration::from_millis(50), 5)).expect("it has no limits");
    arm.set_state(|state| state.rapid_rate = 0.0);
    let begins = || {
        arm.clock().sleep(Duration::from_millis(350));
        arm.set_state(|state| state.rapid_rate = 1.0);
    };
    let end = beside(arm.clock(), begins, || robot.run(&to(20.0), LONG)).expect("it is accepted");
    assert!(end.cause() == Cause::Reached, "{:?}", end.cause());
}
