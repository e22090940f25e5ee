//! Commands that a robot with limits sends or refuses. The witness is the list of requests that the simulated
//! controller received.

mod holes;
mod simulated;
mod ways;
mod wire;

use jaka_motion::{Frames, Limits, Model, Region, RegionFrame};
use jaka_robot::force::StartTorqSensorPayloadIdentify;
use jaka_robot::frames::SetToolOffsets;
use jaka_robot::motion::{EndMove, JointMove, MoveC, MoveL};
use jaka_robot::types::Pose;
use jaka_robot::{Cause, ErrorKind, Robot, RobotConfig, ServoConfig, Unchecked};
use jaka_tests::{Arm, Configured as _, LONG};

const START: [f64; 6] = [10.0, 100.0, 80.0, 90.0, -90.0, 0.0];

fn model() -> &'static Model {
    Model::named("Zu 5").expect("a published arm")
}

/// A tool at the flange's end, and the arm at rest away from singularities; with its robot.
fn with_limits(limits: Limits) -> (Arm, Robot) {
    let arm = with_tool();
    let robot = arm.robot().configured(&RobotConfig::new().limits(limits)).expect("it is this arm");
    (arm, robot)
}

fn with_tool() -> Arm {
    let arm = Arm::simulated().at(START).start();
    arm.set_state(|state| {
        state.tool_frames[1].offset = Pose::from_millimetres_degrees([0.0, 0.0, 120.0], [0.0; 3]);
        state.tool_frame_id = 1;
    });
    arm
}

fn limits() -> Limits {
    Limits::of(model())
}

/// A half-space seen from the arm's base.
fn wall(name: &str, point: [f64; 3], inward: [f64; 3]) -> Region {
    Region::half_space(name, point, inward).expect("a plane").seen_from(RegionFrame::ArmBase)
}

fn within(region: Region) -> Limits {
    limits().with_region(region).expect("the only one")
}

/// Pose of the tool at the start.
fn start_pose() -> Pose {
    let tool = Pose::from_millimetres_degrees([0.0, 0.0, 120.0], [0.0; 3]);
    Frames::new().with_tool(tool).pose(model().forward(START))
}

/// The requests that move the arm.
fn motions(arm: &Arm) -> Vec<String> {
    let moves = |request: &String| {
        ["joint_move", "end_move", "moveL", "movc", "servo_j", "servo_p"]
            .iter()
            .any(|name| request.contains(&format!("\"{name}\"")))
    };
    arm.requests().into_iter().filter(moves).collect()
}

fn turn(joint: usize, by: f64) -> JointMove {
    let mut offset = [0.0; 6];
    offset[joint - 1] = by;
    JointMove::relative(offset, 30.0).acceleration(60.0)
}

#[test]
fn a_motion_within_limits_is_sent_and_ends() {
    let (arm, mut robot) = with_limits(limits());
    robot.run(&turn(6, 5.0), LONG).expect("it is accepted").reached().expect("it ends there");
    let up = MoveL::relative([0.0, 0.0, 30.0, 0.0, 0.0, 0.0], 100.0);
    robot.run(&up, LONG).expect("it is accepted").reached().expect("it ends there");
    let pose = start_pose();
    let along = EndMove::new(Pose { x: pose.x + 20.0, ..pose }, 30.0).acceleration(60.0);
    robot.run(&along, LONG).expect("it is accepted").reached().expect("it ends there");
    assert_eq!(motions(&arm).len(), 3);
}

#[test]
fn what_is_beyond_a_limit_is_not_sent_and_the_error_says_which() {
    let floor = wall("floor", [0.0, 0.0, 100.0], [0.0, 0.0, 1.0]);
    let (arm, mut robot) = with_limits(within(floor).with_tcp_speed(250.0).expect("a speed"));
    let pose = start_pose();
    let line = |to: Pose| MoveL::absolute(to, 100.0);
    let refused = |error: jaka_robot::Error, says: &str| {
        assert!(matches!(error.kind(), ErrorKind::BeyondLimit { .. }) && !error.may_have_run(), "{error:?}");
        assert!(error.to_string().contains(says), "{error}");
    };
    let three = JointMove::absolute([10.0, 100.0, 181.2, 90.0, -90.0, 0.0], 30.0).acceleration(60.0);
    refused(robot.start(&three).expect_err("beyond the range"), "joint 3 would be at 181.2 deg; limit 175 (Zu 5)");
    refused(robot.start(&turn(3, 101.2)).expect_err("beyond the range"), "joint 3 would be at 181.2 deg; limit 175");
    let fast = JointMove::relative([1.0, 0.0, 0.0, 0.0, 0.0, 0.0], 181.0).acceleration(60.0);
    refused(robot.start(&fast).expect_err("too fast"), "joint 1");
    let sudden = JointMove::relative([1.0, 0.0, 0.0, 0.0, 0.0, 0.0], 20.0).acceleration(100.0);
    refused(robot.start(&sudden).expect_err("too sudden"), "deg/s²");
    let no_acceleration = JointMove::relative([1.0, 0.0, 0.0, 0.0, 0.0, 0.0], 20.0);
    refused(robot.start(&no_acceleration).expect_err("of no acceleration"), "acceleration");
    refused(robot.start(&line(Pose { x: 2000.0, ..pose })).expect_err("out of reach"), "out of reach");
    refused(robot.start(&line(Pose { z: 90.0, ..pose })).expect_err("in the floor"), "`floor`");
    refused(robot.start(&MoveL::absolute(Pose { z: pose.z + 1.0, ..pose }, 251.0)).expect_err("too fast"), "mm/s");
    let end = EndMove::new(Pose { z: 90.0, ..pose }, 10.0).acceleration(60.0);
    refused(robot.start(&end).expect_err("in the floor"), "`floor`");
    let low = Pose { x: pose.x + 50.0, z: 80.0, ..pose };
    let arc = MoveC::absolute(low, Pose { x: pose.x + 100.0, ..pose }, 50.0, 100.0, 0.0);
    refused(robot.start(&arc).expect_err("through the floor"), "`floor`");
    assert_eq!(motions(&arm), Vec::<String>::new());
    // The robot is as it was.
    robot.run(&turn(6, 5.0), LONG).expect("it is accepted").reached().expect("it ends there");
}

#[test]
fn a_queued_motion_is_checked_from_where_the_one_before_ends() {
    let (arm, mut robot) = with_limits(limits());
    robot.start(&turn(3, 60.0)).expect("to 140 deg");
    let error = robot.start(&turn(3, 40.0)).expect_err("to 180 deg");
    assert!(error.to_string().contains("joint 3 would be at 180 deg; limit 175"), "{error}");
    robot.start(&turn(3, 30.0)).expect("to 170 deg");
    robot.wait(LONG).at_rest().expect("nothing stops it");
    assert!((arm.state().joint_position.0[2] - 170.0).abs() < 1e-6);
    assert_eq!(motions(&arm).len(), 2);
}

#[test]
fn a_motion_that_cannot_be_checked_is_not_sent() {
    let (arm, mut robot) = with_limits(limits());
    let reason = |error: jaka_robot::Error| match error.into_kind() {
        ErrorKind::NotChecked { reason, .. } => reason,
        kind => panic!("{kind:?}"),
    };
    let rotated = MoveL::relative([0.0, 0.0, 5.0, 0.0, 0.0, 5.0], 50.0);
    assert_eq!(reason(robot.start(&rotated).expect_err("how it rotates is not known")), Unchecked::Target);
    let identify = StartTorqSensorPayloadIdentify::new(START);
    assert_eq!(reason(robot.start(&identify).expect_err("the way is not known")), Unchecked::Path);
    assert_eq!(motions(&arm), Vec::<String>::new());
    // Where the controller chose the branch by itself, the end of the queue is not known.
    robot.start(&turn(6, 5.0)).expect("it is accepted");
    robot.client().set_tool_id(0).expect("it is accepted");
    let queued = reason(robot.start(&turn(6, 5.0)).expect_err("the frame has changed"));
    assert!(matches!(queued, Unchecked::FramesInQueue), "{queued:?}");
    robot.wait(LONG).at_rest().expect("nothing stops it");
    robot.run(&turn(6, 5.0), LONG).expect("it is accepted").reached().expect("it ends there");
}

/// By this program, and by somebody at the pendant.
#[test]
fn limits_follow_the_frames_that_are_selected() {
    let pose = start_pose();
    let floor = pose.z - 100.0;
    let region = wall("floor", [0.0, 0.0, floor], [0.0, 0.0, 1.0]);
    let (arm, mut robot) = with_limits(within(region));
    let down = |by: f64| MoveL::relative([0.0, 0.0, -by, 0.0, 0.0, 0.0], 200.0);
    robot.run(&down(50.0), LONG).expect("above the floor").reached().expect("it ends there");
    // Fifty millimetres of air below a tool that is sixty longer.
    let long = Pose::from_millimetres_degrees([0.0, 0.0, 180.0], [0.0; 3]);
    robot.client().set_tool_offsets(&SetToolOffsets::new(long, 2, "long")).expect("it is set");
    robot.client().set_tool_id(2).expect("it is selected");
    let error = robot.start(&down(45.0)).expect_err("the long tool is below the floor");
    assert!(error.to_string().contains("`floor`"), "{error}");
    arm.set_state(|state| state.tool_frame_id = 1);
    robot.run(&down(45.0), LONG).expect("above the floor").reached().expect("it ends there");
    arm.set_state(|state| state.tool_frame_id = 2);
    let error = robot.start(&down(4.0)).expect_err("the long tool is below the floor");
    assert!(error.to_string().contains("`floor`"), "{error}");
}

#[test]
fn limits_of_another_arm_are_refused() {
    let arm = with_tool();
    let other = Limits::of(Model::named("Zu 7").expect("a published arm"));
    let error =
        arm.robot().configured(&RobotConfig::new().limits(other)).expect_err("the controller computes other poses");
    assert!(matches!(error.kind(), ErrorKind::ModelMismatch { .. }), "{error:?}");
}

#[test]
fn a_set_point_beyond_a_limit_ends_the_session() {
    let (arm, mut robot) = with_limits(limits().with_joint_range(6, -1.0, 1.0).expect("a range"));
    let mut session = robot.enter_servo_mode(ServoConfig::new()).expect("the arm is enabled");
    let mut sent = 0;
    let error = loop {
        match session.send_joint_offset([0.0, 0.0, 0.0, 0.0, 0.0, 0.004]) {
            Ok(()) => sent += 1,
            Err(error) => break error,
        }
        assert!(sent < 1000);
    };
    assert!(error.to_string().contains("joint 6 would be at 1.00"), "{error}");
    assert_eq!(sent, 250);
    assert!(matches!(
        session.send_joint_offset([0.0; 6]).map_err(jaka_robot::Error::into_kind),
        Err(ErrorKind::SessionEnded { .. })
    ));
    drop(session);
    assert!(!arm.state().servo_mode);
    // What follows holds the arm.
    let (moving, holding): (Vec<_>, Vec<_>) = motions(&arm).into_iter().partition(|request| request.contains("0.004"));
    assert_eq!(moving.len(), 250);
    assert!(holding.iter().all(|request| request.contains("[0,0,0,0,0,0]")), "{holding:?}");
}

#[test]
fn poses_of_a_session_are_checked_and_offsets_of_a_pose_are_not_sent() {
    let pose = start_pose();
    let wall = wall("wall", [pose.x + 1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]);
    let (arm, mut robot) = with_limits(within(wall));
    let config = ServoConfig::new();
    let mut session = robot.enter_servo_mode(&config).expect("the arm is enabled");
    let mut x = 0.0;
    let error = loop {
        x += 0.01;
        if let Err(error) = session.send_pose(Pose { x: pose.x + x, ..pose }) {
            break error;
        }
        assert!(x < 2.0);
    };
    assert!(error.to_string().contains("`wall`"), "{error}");
    assert!((1.0..1.02).contains(&x), "{x}");
    drop(session);
    let mut session = robot.enter_servo_mode(&config).expect("the arm is enabled");
    let error = session.send_pose_offset([0.01, 0.0, 0.0, 0.0, 0.0, 0.0]).expect_err("its axes are not known");
    assert!(matches!(error.kind(), ErrorKind::NotChecked { reason: Unchecked::Target, .. }), "{error:?}");
    assert!(!motions(&arm).iter().any(|request| request.contains("\"relFlag\":1") && request.contains("servo_p")));
}

#[test]
fn without_limits_nothing_is_checked() {
    let (arm, robot) = with_limits(limits());
    let mut robot = robot.configured(&RobotConfig::new()).expect("it has no limits any more");
    let before = arm.requests().len();
    let end =
        robot.run(&JointMove::absolute([10.0, 100.0, 80.0, 90.0, -90.0, 5.0], 30.0), LONG).expect("it is accepted");
    assert!(end.cause() == Cause::Reached);
    let queries = arm.requests().len() - before - 1;
    assert!(queries <= 5, "{queries} queries");
}
