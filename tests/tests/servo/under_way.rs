//! Frames and the rapid rate that somebody changes while the arm moves, in each way of moving.
//!
//! The witness is the wire: what the controller received, read as JSON. By simulated clocks.

use std::time::Duration;

use jaka_robot::jaka_motion::{Limits, Point, Region, RegionFrame, TcpVelocity, Trajectory, VelocityFrame, Via};
use jaka_robot::motion::{JointMove, MoveL};
use jaka_robot::types::Pose;
use jaka_robot::{
    Cause, End, Error, ErrorKind, FollowConfig, Guard, MotionExt as _, Numbering, Robot, RobotConfig, Run, ServoConfig,
    StreamConfig, StreamHandle, TcpBox,
};
use jaka_sim::State;
use jaka_tests::simulated::beside;
use jaka_tests::{Arm, Configured as _, LONG};
use serde_json::Value;

use crate::follow::{self, START};
use crate::received::{names, positions};

const CYCLES: u32 = 4;
const SERVO_PERIOD: Duration = Duration::from_millis(32);
const STATUS_PERIOD: Duration = Duration::from_millis(10);

/// Time from the call that moves the arm to the change of the frames. The motion takes some seconds.
const AFTER: Duration = Duration::from_millis(900);

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Way {
    Joints,
    Line,
    SessionJoints,
    SessionPoses,
    StreamJoints,
    StreamPose,
    StreamTcpVelocity,
    TrajectoryJoints,
    TrajectoryLines,
    /// Of joint positions, without the statement that it is.
    TrajectoryUnknown,
}

/// Each way, and whether it depends on frames by itself.
const WAYS: [(Way, bool); 10] = [
    (Way::Joints, false),
    (Way::Line, true),
    (Way::SessionJoints, false),
    (Way::SessionPoses, true),
    (Way::StreamJoints, false),
    (Way::StreamPose, true),
    (Way::StreamTcpVelocity, true),
    (Way::TrajectoryJoints, false),
    (Way::TrajectoryLines, true),
    (Way::TrajectoryUnknown, true),
];

/// Guard or limit on the motion, besides limits of joints.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Under {
    Nothing,
    Input,
    /// Left by the packet that shows the other frame.
    Box,
    Question,
    TcpRegion,
    UserRegion,
    ElbowRegion,
    TcpSpeed,
}

/// Each of these, and whether it depends on frames.
const UNDER: [(Under, bool); 8] = [
    (Under::Nothing, false),
    (Under::Input, false),
    (Under::Box, true),
    (Under::Question, true),
    (Under::TcpRegion, true),
    (Under::UserRegion, true),
    (Under::ElbowRegion, false),
    (Under::TcpSpeed, true),
];

#[derive(Debug, Clone, Copy)]
enum Frame {
    Tool,
    User,
}

impl Frame {
    fn select(self, state: &mut State) {
        match self {
            Self::Tool => state.tool_frame_id = 1,
            Self::User => state.user_frame_id = 1,
        }
    }
}

impl Way {
    fn is_planned(self) -> bool {
        matches!(self, Self::Joints | Self::Line)
    }

    /// Sessions have no guard.
    fn can_be(self, under: Under) -> bool {
        let is_guard = matches!(under, Under::Input | Under::Box | Under::Question);
        !(is_guard && matches!(self, Self::SessionJoints | Self::SessionPoses))
    }
}

impl Under {
    fn guard(self, at: Pose) -> Option<Guard> {
        match self {
            Self::Input => Some(Numbering::FromOne.cabinet(3).is_high().into()),
            Self::Box => {
                let corner = |by: f64| [at.x + 5.0 * by, at.y + 5.0 * by, at.z + by];
                Some(TcpBox::from_corners(corner(-100.0), corner(100.0)).is_left())
            }
            Self::Question => Some(Guard::when("never", |_| false)),
            Self::Nothing | Self::TcpRegion | Self::UserRegion | Self::ElbowRegion | Self::TcpSpeed => None,
        }
    }

    fn limits(self) -> Limits {
        let around = || Region::inside_box("cell", [-2000.0; 3], [2000.0; 3]).expect("a region");
        let region = match self {
            Self::TcpRegion => around().seen_from(RegionFrame::ArmBase),
            Self::UserRegion => around().of(Point::Elbow),
            Self::ElbowRegion => around().of(Point::Elbow).seen_from(RegionFrame::ArmBase),
            Self::TcpSpeed => return follow::limits().with_tcp_speed(500.0).expect("above 0"),
            Self::Nothing | Self::Input | Self::Box | Self::Question => return follow::limits(),
        };
        follow::limits().with_region(region).expect("it has a name of its own")
    }
}

/// An arm whose frames 1 are 300 mm from frames 0.
fn arm() -> Arm {
    let arm = Arm::simulated().at(START).status_period(STATUS_PERIOD).start();
    arm.set_state(|state| {
        let offset = Pose::from_millimetres_degrees([0.0, 0.0, 300.0], [0.0; 3]);
        (state.tool_frames[1].offset, state.user_frames[1].offset) = (offset, offset);
    });
    arm
}

fn servo() -> ServoConfig {
    ServoConfig::new().step_count(CYCLES)
}

fn up(pose: Pose, by: f64) -> Pose {
    Pose { z: pose.z + by, ..pose }
}

/// Steps of 80 set-points that begin and end slowly, as a share of the longest.
fn step(cycle: u32) -> f64 {
    f64::from(cycle.min(80 - cycle).min(10)) / 10.0
}

fn give_goals(way: Way, stream: &StreamHandle, arm: &Arm, pose: Pose) -> Result<(), Error> {
    let velocity = TcpVelocity::new(VelocityFrame::User).with_linear([0.0, 0.0, 15.0]);
    for _ in 0..20 {
        match way {
            Way::StreamPose => stream.set_pose(up(pose, 40.0))?,
            Way::StreamTcpVelocity => stream.set_tcp_velocity(velocity, Duration::from_millis(300))?,
            _ => stream.set_joint_velocity([0.0, 0.0, 0.0, 0.0, 0.0, 15.0], Duration::from_millis(300))?,
        }
        arm.clock().sleep(Duration::from_millis(100));
    }
    Ok(())
}

fn ran(robot: &mut Robot, motion: &impl Run) -> Result<End, Error> {
    robot.run(motion, LONG)
}

/// Moves the arm in this way for some seconds, until it ends.
fn act(way: Way, robot: &mut Robot, arm: &Arm, guard: Option<Guard>) -> Result<End, Error> {
    let pose = arm.state().tcp_pose;
    let turn = JointMove::relative([0.0, 0.0, 0.0, 0.0, 0.0, 60.0], 20.0).acceleration(100.0);
    let line = MoveL::absolute(up(pose, 40.0), 15.0).acceleration(100.0);
    match (way, guard) {
        (Way::Joints, Some(guard)) => ran(robot, &turn.guard(guard)),
        (Way::Joints, None) => ran(robot, &turn),
        (Way::Line, Some(guard)) => ran(robot, &line.guard(guard)),
        (Way::Line, None) => ran(robot, &line),
        (Way::SessionJoints, _) => {
            let mut session = robot.enter_servo_mode(servo())?;
            let mut joints = START;
            for cycle in 0..80 {
                joints[5] += step(cycle) * 0.4;
                session.send_joints(joints)?;
            }
            session.land()
        }
        (Way::SessionPoses, _) => {
            let mut session = robot.enter_servo_mode(servo())?;
            let mut height = 0.0;
            for cycle in 0..80 {
                height += step(cycle) * 0.5;
                session.send_pose(up(pose, height))?;
            }
            session.land()
        }
        (Way::StreamJoints | Way::StreamPose | Way::StreamTcpVelocity, guard) => {
            let config = guard.into_iter().fold(StreamConfig::new().servo(servo()), StreamConfig::guard);
            let stream = robot.stream(&config)?;
            // The goals fail once it lands, and `land` says why.
            let _ = give_goals(way, &stream.handle(), arm, pose);
            stream.land()
        }
        (Way::TrajectoryJoints | Way::TrajectoryUnknown | Way::TrajectoryLines, guard) => {
            let checker = robot.limits().expect("it has some").clone();
            let points = [Via::from(START), Via::from(up(pose, 40.0))];
            let trajectory = match way {
                Way::TrajectoryLines => Trajectory::through(points).tcp_speed(15.0).build(&checker),
                _ => follow::trajectory(&follow::to_and_fro(), &checker),
            };
            let config = FollowConfig::new().servo(servo());
            let config = if way == Way::TrajectoryJoints { config.in_joints() } else { config };
            let config = guard.into_iter().fold(config, FollowConfig::guard);
            Ok(robot.start_follow(&trajectory.expect("within the limits"), &config)?.wait())
        }
    }
}

/// Number of matching commands that the controller received.
fn count(arm: &Arm, is_told: impl Fn(&str) -> bool) -> usize {
    names(arm).iter().filter(|name| is_told(name)).count()
}

fn set_points(arm: &Arm) -> usize {
    count(arm, |name| name.starts_with("servo_") && name != "servo_move")
}

fn stops(arm: &Arm) -> usize {
    count(arm, |name| name == "stop_program")
}

/// Nothing moves the arm any more, and what moved it was smooth.
fn assert_landed(arm: &Arm, way: Way, what: &str) {
    let sent = set_points(arm);
    arm.clock().sleep(Duration::from_secs(2));
    assert_eq!(set_points(arm), sent, "{what}: set-points after the landing");
    let state = arm.state();
    assert!(state.at_rest && !state.servo_mode, "{what}: {state:?}");
    if !way.is_planned() {
        let names = names(arm);
        let last = |wanted: &str| names.iter().rposition(|name| name == wanted);
        assert!(last("servo_p") < last("servo_j"), "{what}: a pose in other frames brakes no arm");
        if way != Way::SessionPoses {
            let (set_points, _) = positions(arm, CYCLES);
            assert_eq!(follow::jump(START, &set_points), None, "{what}");
        }
    }
}

/// The end of this way of moving, whose frames are changed meanwhile.
fn cell(way: Way, under: Under, frame: Frame) -> (Arm, Result<End, Error>) {
    let arm = arm();
    let mut robot = arm.robot().configured(&RobotConfig::new().limits(under.limits())).expect("it is this arm");
    let guard = under.guard(arm.state().tcp_pose);
    let change = || {
        arm.clock().sleep(AFTER);
        arm.set_state(|state| frame.select(state));
    };
    let ended = beside(arm.clock(), change, || act(way, &mut robot, &arm, guard));
    drop(robot);
    (arm, ended)
}

#[test]
fn another_frame_ends_what_depends_on_it_by_one_cause_and_nothing_else() {
    for (way, is_in_poses) in WAYS {
        for (under, is_in_space) in UNDER.into_iter().filter(|(under, _)| way.can_be(*under)) {
            for frame in [Frame::Tool, Frame::User] {
                let what = format!("{way:?} under {under:?}, {frame:?}");
                let (arm, ended) = cell(way, under, frame);
                if !(is_in_poses || is_in_space) {
                    let end = ended.unwrap_or_else(|error| panic!("{what}: {error}"));
                    assert!(matches!(end.cause(), Cause::Reached | Cause::Landed), "{what}: {end}");
                    assert_eq!((end.report.frames.tool, end.report.frames.user), (Some(0), Some(0)), "{what}");
                    assert_eq!(stops(&arm), 0, "{what}");
                    continue;
                }
                let (cause, text, is_at_rest) = match &ended {
                    Ok(end) => (end.cause(), end.to_string(), end.rest.was_seen()),
                    // One that did not land would tell of it.
                    Err(error) => {
                        (error.cause(), error.to_string(), matches!(error.kind(), ErrorKind::RobotState { .. }))
                    }
                };
                assert_eq!(cause, Cause::FramesChanged, "{what}: {text}");
                let said = match frame {
                    Frame::Tool => "tool frame 1, 0 before",
                    Frame::User => "user frame 1, 0 before",
                };
                assert!(text.contains(said) && text.contains(&cause.to_string()), "{what}: {text}");
                assert!(is_at_rest, "{what}: {text}");
                assert_eq!(stops(&arm), usize::from(way.is_planned()), "{what}");
                assert_landed(&arm, way, &what);
            }
        }
    }
}

#[test]
fn another_rapid_rate_ends_nothing_and_is_told() {
    for way in [Way::Joints, Way::Line, Way::SessionJoints, Way::StreamPose, Way::TrajectoryLines] {
        let arm = arm();
        let mut robot = arm.robot().configured(&RobotConfig::new().limits(follow::limits())).expect("it is this arm");
        let change = || {
            arm.clock().sleep(AFTER);
            arm.set_state(|state| state.rapid_rate = 0.5);
            arm.clock().sleep(SERVO_PERIOD * 3);
            arm.set_state(|state| state.rapid_rate = 0.9);
        };
        let ended = beside(arm.clock(), change, || act(way, &mut robot, &arm, None));
        let end = ended.unwrap_or_else(|error| panic!("{way:?}: {error}"));
        assert!(matches!(end.cause(), Cause::Reached | Cause::Landed), "{way:?}: {end}");
        assert_eq!(end.report.rapid_rate, Some(0.5), "{way:?}");
        assert_eq!(stops(&arm), 0, "{way:?}");
    }
}

#[test]
fn where_packets_do_not_show_the_frames_none_is_compared_and_the_report_says_so() {
    for way in [Way::Line, Way::SessionPoses, Way::StreamPose, Way::TrajectoryLines] {
        let arm = arm();
        arm.set_status(["current_tool_id", "current_user_id"].map(|key| (key.to_owned(), Value::Null)));
        let mut robot = arm.robot().configured(&RobotConfig::new().limits(follow::limits())).expect("it is this arm");
        let end = act(way, &mut robot, &arm, None).unwrap_or_else(|error| panic!("{way:?}: {error}"));
        assert!(matches!(end.cause(), Cause::Reached | Cause::Landed | Cause::AtRest), "{way:?}: {end}");
        assert_eq!((end.report.frames.tool, end.report.frames.user), (None, None), "{way:?}");
    }
}
