//! Streams under a guard.

use std::time::Duration;

use jaka_robot::jaka_motion::{TimedPoint, Trajectory};
use jaka_robot::servo::{IsInServomove, ServoJ, SetServoMode};
use jaka_robot::types::JointPosition;
use jaka_robot::{Cause, Command, ErrorKind, FollowConfig, ForceComponent, ForceLimit, NotShown, Robot, StreamConfig};
use jaka_sim::{Fault, StatusFault};
use jaka_tests::Configured as _;
use jaka_tests::LONG;
use jaka_tests::simulated::{beside, until};

use super::{IO, arm_limits, count, limited, names, ready, wait_for_motion};

#[test]
fn a_guard_lands_a_stream() {
    let (arm, robot) = ready();
    let mut robot = limited(robot);
    let stream = robot.stream(&StreamConfig::new().guard(IO.cabinet(1).is_high())).expect("the input is low");
    let mut target = stream.handle().joints();
    target[0] += 170.0;
    stream.handle().set_joints(target).expect("it is within limits");
    wait_for_motion(&arm);
    arm.set_state(|state| state.digital_inputs[0] = true);
    let handle = stream.handle();
    let mut because = String::new();
    until(arm.clock(), || handle.set_joints(target).map_err(|error| because = error.to_string()).is_err());
    assert!(
        because.contains("the guard tripped: digital input 1 of the cabinet (counted from 1) is high"),
        "{because}"
    );
    let error = stream.land().expect_err("the guard has ended it");
    let ErrorKind::GuardTripped { trip } = error.kind() else { panic!("{error:?}") };
    assert!(error.may_have_run() && !trip.is_before_start && trip.reaction.is_none());
    assert_eq!(trip.packet.status.digital_inputs.as_ref().and_then(|inputs| inputs.first()), Some(&true));
    let at = arm.state().joint_position.0[0];
    assert!(arm.state().at_rest && !arm.state().servo_mode && at < 165.0, "it is at {at}");
    let all = names(&arm);
    let last = all.iter().rposition(|name| name == ServoJ::INFO.name).expect("set-points came");
    assert_eq!(all[last + 1], SetServoMode::INFO.name, "{:?}", &all[last..]);
    assert!(all[last + 2..].iter().all(|name| name == IsInServomove::INFO.name), "{:?}", &all[last..]);

    // The input is still high: servo mode is not asked for.
    let entered = count(&arm, SetServoMode::INFO.name);
    let error = robot.stream(&StreamConfig::new().guard(IO.cabinet(1).is_high())).expect_err("the input is high");
    assert!(matches!(error.kind(), ErrorKind::GuardTripped { trip } if trip.is_before_start), "{error:?}");
    assert!(!error.may_have_run());
    let error =
        robot.stream(&StreamConfig::new().guard(IO.cabinet(1000).is_high())).expect_err("there is no such input");
    assert!(matches!(error.kind(), ErrorKind::NotShown { reason: NotShown::TooShort { .. }, .. }), "{error:?}");
    let error = robot
        .stream(&StreamConfig::new().guard(ForceLimit::new(ForceComponent::Fz, 1.0)))
        .expect_err("it does not work");
    assert!(matches!(error.kind(), ErrorKind::NotShown { reason: NotShown::SensorOff, .. }), "{error:?}");
    assert_eq!(count(&arm, SetServoMode::INFO.name), entered);
}

/// The arm says where it is only after the input has gone high.
#[test]
fn a_guard_that_trips_before_servo_mode_is_entered_keeps_the_arm_out_of_it() {
    let (arm, robot) = ready();
    let mut robot = limited(robot);
    let start = arm.state().joint_position;
    let points = [TimedPoint::new(0.0, start), TimedPoint::new(4.0, start)];
    let trajectory = Trajectory::timed(&points, robot.limits().expect("it has some")).expect("it is within them");
    arm.inject_for("get_joint_pos", Fault::Delay(Duration::from_millis(500)));
    let goes_high = || {
        arm.clock().sleep(Duration::from_millis(200));
        arm.set_state(|state| state.digital_inputs[0] = true);
    };
    let guard = IO.cabinet(1).rises();
    let started = beside(arm.clock(), goes_high, || robot.start_follow(&trajectory, &FollowConfig::new().guard(guard)));
    let error = started.expect_err("the input went high");
    assert!(matches!(error.kind(), ErrorKind::GuardTripped { trip } if trip.is_before_start), "{error:?}");
    assert!(!error.may_have_run());
    assert_eq!(count(&arm, SetServoMode::INFO.name), 0);
}

#[test]
fn without_a_known_status_a_stream_and_a_trajectory_land_whatever_is_allowed() {
    let start = |robot: Robot| robot.configured(&arm_limits().allow_motion_without_status()).expect("it is this arm");
    let (arm, robot) = ready();
    let mut robot = start(robot);
    let stream = robot.stream(&StreamConfig::new().guard(IO.cabinet(1).is_high())).expect("the input is low");
    let mut target = stream.handle().joints();
    target[0] += 170.0;
    stream.handle().set_joints(target).expect("it is within limits");
    wait_for_motion(&arm);
    arm.status_fault(StatusFault::Silent);
    let error = stream.handle().wait_for_rest(LONG).expect_err("nobody judges the guard");
    assert!(error.to_string().contains("the last status packet came"), "{error}");
    assert!(stream.land().is_err() && arm.state().joint_position.0[0] < 165.0);

    let (arm, robot) = ready();
    let mut robot = start(robot);
    let at = arm.state().joint_position;
    let far = JointPosition(std::array::from_fn(|joint| at.0[joint] + if joint == 0 { 100.0 } else { 0.0 }));
    let points = [TimedPoint::new(0.0, at), TimedPoint::new(20.0, far)];
    let trajectory = Trajectory::timed(&points, robot.limits().expect("it has some")).expect("it is slow");
    let run =
        robot.start_follow(&trajectory, &FollowConfig::new().guard(IO.cabinet(1).is_high())).expect("the input is low");
    wait_for_motion(&arm);
    arm.status_fault(StatusFault::Silent);
    let end = run.wait();
    assert!(matches!(end.cause(), Cause::StatusLost), "{end:?}");
    assert!(arm.state().joint_position.0[0] < 90.0);
}
