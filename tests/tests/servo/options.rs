//! Options with values that they do not take: the error names the option, and nothing that moves the arm is sent.

use std::fmt::Debug;
use std::time::Duration;

use jaka_robot::jaka_motion::{Checker, Dynamics, Frames, Preset, Trajectory};
use jaka_robot::motion::MoveL;
use jaka_robot::types::JointPosition;
use jaka_robot::{
    Cause, Error, ErrorKind, FollowConfig, ForceComponent, ForceLimit, Guard, MotionExt as _, Numbering, RobotConfig,
    ServoConfig, ServoSession, SessionConfig, Stream, StreamConfig, TcpBox,
};
use jaka_tests::{Arm, Configured as _, LONG};

use crate::received::names;
use crate::stream::{START, arm, limits};

fn text<T: Debug>(result: Result<T, Error>) -> String {
    let error = result.expect_err("the option does not take this");
    assert!(matches!(error.kind(), ErrorKind::InvalidOption { .. }), "{error:?}");
    assert!(error.is_invalid_argument() && !error.may_have_run() && error.cause() == Cause::Failed, "{error:?}");
    error.to_string()
}

/// Servo mode is on where a stream's dynamics are compared with the limits, from where the arm is.
fn assert_not_moved(arm: &Arm) {
    let sent = names(arm);
    assert!(!sent.iter().any(|name| ["servo_j", "servo_p", "moveL"].contains(&name.as_str())), "{sent:?}");
}

#[test]
fn an_option_leaves_the_others_as_they_are() {
    let config = ServoConfig::new().step_count(4);
    let waits = config.clone().busy_wait(Duration::from_micros(200));
    assert_eq!(waits.period(), Duration::from_millis(32));
    assert_ne!(waits, config);
}

#[test]
fn an_option_of_a_servo_session_is_named() {
    let (arm, mut robot) = arm().with_robot();
    let (servo, config) = (ServoConfig::new, SessionConfig::new);
    for (config, expected) in [
        (
            config().servo(servo().step_count(99)),
            "option `step_count` of `ServoConfig` is 99, expected 1 to 12: a period of at most 96ms",
        ),
        (
            config().max_joint_acceleration(0.0),
            "option `max_joint_acceleration` of `SessionConfig` is 0, expected a number of at least 0.001 deg/s²",
        ),
        (
            config().max_tcp_speed(-1.0),
            "option `max_tcp_speed` of `SessionConfig` is -1, expected a number of at least 0.001 mm/s",
        ),
        (
            config().max_tcp_acceleration(f64::NAN),
            "option `max_tcp_acceleration` of `SessionConfig` is NaN, expected a number of at least 0.001 mm/s²",
        ),
        (
            config().servo(servo().realtime_priority(100)),
            "option `realtime_priority` of `ServoConfig` is 100, expected 1 to 99",
        ),
    ] {
        assert_eq!(text(robot.enter_servo_mode(&config)), expected);
    }
    assert_not_moved(&arm);
}

#[test]
fn an_option_of_a_stream_is_named() {
    let (arm, robot) = arm().with_robot();
    let mut robot = robot.configured(&RobotConfig::new().limits(limits())).expect("it is this arm");
    let slow = Dynamics::of(&limits()).with_speeds([500.0; 6]).expect("numbers above 0");
    for (config, expected) in [
        (
            StreamConfig::new().max_departure(0.0),
            "option `max_departure` of `StreamConfig` is 0, expected a number of at least 0.001 deg",
        ),
        (
            StreamConfig::new().dynamics(slow),
            "option `dynamics` of `StreamConfig` is a speed of joint 1 of 500 deg/s, expected at most 180 deg/s, the arm's limit",
        ),
    ] {
        assert_eq!(text(robot.stream(&config)), expected);
    }
    assert_not_moved(&arm);
}

#[test]
fn an_option_of_a_trajectory_is_named() {
    let (arm, robot) = arm().with_robot();
    let mut robot = robot.configured(&RobotConfig::new().limits(limits())).expect("it is this arm");
    let trajectory = crate::follow::made(&crate::follow::to_and_fro());
    for (config, expected) in [
        (FollowConfig::new().speed_scale(1.5), "option `speed_scale` of `FollowConfig` is 1.5, expected 0 to 1"),
        (
            FollowConfig::new().approach(0.0),
            "option `approach` of `FollowConfig` is 0, expected a number of at least 0.001 deg/s",
        ),
        (
            FollowConfig::new().max_departure(-1.0),
            "option `max_departure` of `FollowConfig` is -1, expected a number of at least 0.001 deg",
        ),
    ] {
        assert_eq!(text(robot.start_follow(&trajectory, &config)), expected);
    }
    assert_not_moved(&arm);
}

#[test]
fn an_option_of_a_robot_is_named() {
    let (arm, mut robot) = arm().with_robot();
    for value in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let expected = format!("option `rest_speed` of `RobotConfig` is {value}, expected a number above 0 deg/s");
        assert_eq!(text(robot.configure(&RobotConfig::new().rest_speed(value))), expected);
    }
    assert_not_moved(&arm);
}

#[test]
fn an_option_of_a_guard_is_named() {
    let (arm, mut robot) = arm().with_robot();
    let limit = |change| ForceLimit::new(ForceComponent::Fz, change);
    let inputs = Numbering::FromOne;
    let guards: [(Guard, &str); 7] = [
        (limit(0.0).into(), "option `change` of `ForceLimit` is 0, expected a number above 0"),
        (limit(1.0).braking(-1.0).into(), "option `braking` of `ForceLimit` is -1, expected a number above 0"),
        (limit(1.0).overtravel(2000.0).into(), "option `overtravel` of `ForceLimit` is 2000, expected at most 1000 mm"),
        (
            limit(1.0).reaction(Duration::from_secs(61)).into(),
            "option `reaction` of `ForceLimit` is 61s, expected at most one minute",
        ),
        (
            TcpBox::from_corners([0.0; 3], [1.0, f64::INFINITY, 1.0]).is_left(),
            "option `corner` of `TcpBox` is inf, expected a finite number of mm",
        ),
        (
            inputs.tool_analog(1).is_above(f64::NAN).into(),
            "option `threshold` of `AnalogCondition` is NaN, expected a finite number",
        ),
        (
            inputs.cabinet(0).is_high().into(),
            "option `number` of `Numbering` is 0, expected at least 1, since inputs are counted from 1",
        ),
    ];
    let down = MoveL::relative([0.0, 0.0, -1.0, 0.0, 0.0, 0.0], 1.0).acceleration(100.0);
    for (guard, expected) in guards {
        assert_eq!(text(robot.run(&down.guard(guard.clone()), LONG)), expected);
        let robot = &mut robot;
        assert_eq!(text(robot.stream(&StreamConfig::new().guard(guard))), expected);
    }
    assert_not_moved(&arm);
    assert_eq!(arm.state().joint_position, JointPosition::from(START));
}

/// A preset that is not gentle wants the payload to be read, and collision detection to be on.
#[test]
fn a_preset_wants_the_payload_and_collision_detection_or_a_waiver() {
    let (arm, mut robot) = arm().with_robot();
    let asked = |robot: &mut jaka_robot::Robot, config: &RobotConfig| {
        let before = names(&arm).len();
        let result = robot.configure(config);
        let sent = names(&arm).split_off(before);
        let count = |name: &str| sent.iter().filter(|sent| *sent == name).count();
        (result, [count("get_payload"), count("get_clsn_sensitivity")])
    };
    let usual = || RobotConfig::new().limits(limits().with_preset(Preset::Usual));
    arm.set_state(|state| state.collision_level = 0);
    let (refused, sent) = asked(&mut robot, &usual());
    assert_eq!(
        text(refused),
        "option `limits` of `RobotConfig` is the preset `usual` with the collision level 0, expected a level above 0 \
         (`set_clsn_sensitivity`), or `RobotConfig::without_collision_detection`"
    );
    assert_eq!(sent, [1, 1]);
    assert!(robot.limits().is_none(), "nothing has changed");
    let (waived, sent) = asked(&mut robot, &usual().without_collision_detection().without_payload());
    assert_eq!((waived.is_ok(), sent), (true, [0, 0]));
    assert_eq!(robot.limits().expect("it has some").limits().preset(), Preset::Usual);
    let (gentle, sent) = asked(&mut robot, &RobotConfig::new().limits(limits()));
    assert_eq!((gentle.is_ok(), sent), (true, [0, 0]));
    arm.set_state(|state| state.collision_level = 3);
    let (taken, sent) = asked(&mut robot, &usual());
    assert_eq!((taken.is_ok(), sent), (true, [1, 1]));
}

/// Numbers that nobody would give.
const ODD: [f64; 16] = [
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    1e308,
    -1e308,
    1e30,
    1e7,
    1e4,
    1.0,
    0.01,
    9.99e-4,
    1e-154,
    f64::MIN_POSITIVE,
    5e-324,
    0.0,
    -1.0,
];

/// An option that takes a number does its work; another number is refused by the option's name, with what is expected.
#[track_caller]
fn taken_or_named<T: Debug>(option: &str, of: &str, odd: f64, makes_sense: bool, result: Result<T, Error>) {
    match result {
        Ok(_) => assert!(makes_sense, "option `{option}` of `{of}` takes {odd:e}"),
        Err(error) => {
            assert!(!makes_sense, "option `{option}` of `{of}` takes no {odd:e}: {error}");
            let found = text(Err::<(), _>(error));
            assert!(found.starts_with(&format!("option `{option}` of `{of}` is {odd}, expected ")), "{found}");
        }
    }
}

/// A turn of joint 6 from where the arm is.
fn turn() -> Trajectory {
    let points = [START, [START[0], START[1], START[2], START[3], START[4], START[5] + 5.0]];
    Trajectory::through(points).build(&Checker::new(limits(), Frames::new())).expect("it is within the limits")
}

#[test]
fn odd_numbers_are_taken_or_named() {
    let (arm, robot) = arm().with_robot();
    let mut unlimited = robot;
    let rate = |odd: f64| odd.is_finite() && odd >= 0.001;
    for odd in ODD {
        let session = SessionConfig::new;
        for (option, config) in [
            ("max_joint_acceleration", session().max_joint_acceleration(odd)),
            ("max_tcp_speed", session().max_tcp_speed(odd)),
            ("max_tcp_acceleration", session().max_tcp_acceleration(odd)),
        ] {
            let ended = unlimited.enter_servo_mode(&config).and_then(ServoSession::land);
            taken_or_named(option, "SessionConfig", odd, rate(odd), ended);
        }
    }
    let mut robot = unlimited.configured(&RobotConfig::new().limits(limits())).expect("it is this arm");
    let trajectory = turn();
    for odd in ODD {
        let landed = robot.stream(&StreamConfig::new().max_departure(odd)).and_then(Stream::land);
        taken_or_named("max_departure", "StreamConfig", odd, rate(odd), landed);
        let follow = FollowConfig::new;
        for (option, makes_sense, config) in [
            ("speed_scale", (0.0..=1.0).contains(&odd), follow().speed_scale(odd)),
            ("approach", rate(odd), follow().approach(odd)),
            ("max_departure", rate(odd), follow().max_departure(odd)),
        ] {
            arm.set_state(|state| state.joint_position = START.into());
            let run = robot.start_follow(&trajectory, &config).map(|run| {
                run.handle().stop().expect("it follows");
                let _ = run.wait();
            });
            taken_or_named(option, "FollowConfig", odd, makes_sense, run);
        }
        let limit = |change| ForceLimit::new(ForceComponent::Fz, change);
        let above_zero = |odd: f64| odd > 0.0 && odd <= 1e6;
        for (option, of, makes_sense, guard) in [
            ("change", "ForceLimit", above_zero(odd), Guard::from(limit(odd))),
            ("overtravel", "ForceLimit", odd > 0.0 && odd <= 1000.0, limit(1.0).overtravel(odd).into()),
            ("braking", "ForceLimit", above_zero(odd), limit(1.0).braking(odd).into()),
            ("corner", "TcpBox", odd.is_finite(), TcpBox::from_corners([odd; 3], [1.0; 3]).is_left()),
            ("threshold", "AnalogCondition", odd.is_finite(), Numbering::FromOne.tool_analog(1).is_above(odd).into()),
        ] {
            let down = MoveL::relative([0.0, 0.0, -1.0, 0.0, 0.0, 0.0], 0.1).acceleration(100.0).guard(guard);
            let refused = match robot.run(&down, LONG) {
                // The arm has no such sensor, or is too fast for the limit.
                Err(error) if makes_sense && !matches!(error.kind(), ErrorKind::InvalidOption { .. }) => Ok(()),
                result => result.map(drop),
            };
            taken_or_named(option, of, odd, makes_sense, refused);
        }
    }
}

/// No time is too short or too long for a computation: the session ends, as it does with the usual ones.
#[test]
fn odd_times_do_no_harm() {
    let (_arm, robot) = arm().with_robot();
    let mut robot = robot.configured(&RobotConfig::new().limits(limits())).expect("it is this arm");
    let trajectory = turn();
    for odd in [Duration::ZERO, Duration::from_nanos(1), Duration::from_secs(u64::MAX), Duration::MAX] {
        let servo = ServoConfig::new;
        for servo in
            [servo().busy_wait(odd), servo().max_unanswered(odd), servo().rest_timeout(odd), servo().enter_timeout(odd)]
        {
            let _ = robot.enter_servo_mode(SessionConfig::new().servo(servo.clone())).and_then(ServoSession::land);
            let _ = robot.stream(&StreamConfig::new().servo(servo)).and_then(Stream::land);
        }
        let _ = robot.stream(&StreamConfig::new().max_gap(odd)).and_then(Stream::land);
        for config in [FollowConfig::new().deadline(odd), FollowConfig::new().max_gap(odd)] {
            if let Ok(run) = robot.start_follow(&trajectory, &config) {
                let _ = run.handle().stop();
                let _ = run.wait();
            }
        }
        let limit = ForceLimit::new(ForceComponent::Fz, 1.0).reaction(odd);
        let _ = robot.stream(&StreamConfig::new().guard(limit)).and_then(Stream::land);
        for config in [RobotConfig::new().start_grace(odd, u32::MAX), RobotConfig::new().status_silence(odd)] {
            let _ = robot.configure(&config.limits(limits()));
        }
        let _ = robot.configure(&RobotConfig::new().limits(limits()));
    }
}
