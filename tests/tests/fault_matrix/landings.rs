//! Sessions and streams that land at speed during a fault, judged by the requests that the controller receives.
//!
//! These are not cells of the table, because the end of such a landing depends on the moment. The tests assert the
//! properties that hold for each landing.

use std::time::Duration;

use jaka_robot::jaka_motion::{Limits, Model};
use jaka_robot::{Error, ErrorKind, Robot, RobotConfig, ServoConfig, StreamConfig};
use jaka_sim::{Controller, StatusFault};
use jaka_tests::Arm;
use jaka_tests::Configured as _;
use jaka_tests::simulated::beside;
use serde_json::Value;

use crate::cell::LIMIT;
use crate::each;
use crate::troubles::Trouble;

/// Motion until the landing.
#[derive(Debug, Clone, Copy)]
enum Way {
    Session,
    Stream,
}

/// Cycles of a set-point.
pub(crate) const CYCLES: u32 = 4;
pub(crate) const PERIOD: f64 = 0.032;
/// Permitted acceleration, and acceleration of the ramps, in deg/s².
pub(crate) const MOST: f64 = 720.0;
const ASKED: f64 = 600.0;
pub(crate) const START: [f64; 6] = [10.0, 100.0, 80.0, 90.0, -90.0, 0.0];

/// Each trouble with each way; fails with all that is wrong.
pub(crate) fn go_through(troubles: &[Trouble]) {
    let tasks: Vec<_> =
        troubles.iter().flat_map(|trouble| [Way::Session, Way::Stream].map(|way| (trouble, way))).collect();
    each(&tasks, |(trouble, way)| format!("{trouble}, {way:?}"), |(trouble, way)| land(trouble, *way));
}

fn land(trouble: &Trouble, way: Way) {
    let arm = Arm::simulated().status_period(Duration::from_millis(10)).at(START);
    let (arm, mut robot) = arm.config(|config| config.reply_timeout(Duration::from_secs(1))).with_robot();
    let ended = match way {
        Way::Session => session(trouble, &arm, &mut robot),
        Way::Stream => stream(trouble, &arm, robot),
    };
    lift(trouble, &arm);
    judge(trouble, way, &arm, &ended);
}

fn session(trouble: &Trouble, arm: &Arm, robot: &mut Robot) -> Result<(), Error> {
    let config = ServoConfig::new().step_count(CYCLES).rest_timeout(LIMIT / 30);
    let mut session = robot.enter_servo_mode(&config).expect("nothing is wrong yet");
    let step = ASKED * PERIOD * PERIOD;
    for n in 1..=5 {
        session.send_joint_offset([0.0, 0.0, f64::from(n) * step, 0.0, 0.0, 0.0]).expect("nothing is wrong yet");
    }
    struck(trouble, arm, || session.land().map(drop))
}

fn stream(trouble: &Trouble, arm: &Arm, robot: Robot) -> Result<(), Error> {
    let limits = Limits::of(Model::named("Zu 5").expect("a published arm"));
    let limits = limits.with_joint_accelerations([MOST; 6]).expect("above 0");
    let mut robot = robot.configured(&RobotConfig::new().limits(limits)).expect("it is this arm");
    let servo = ServoConfig::new().step_count(CYCLES).rest_timeout(LIMIT / 30);
    let stream = robot.stream(&StreamConfig::new().servo(servo).max_gap(LIMIT)).expect("nothing is wrong yet");
    let since = arm.clock().elapsed();
    while stream.handle().joints()[2] - START[2] < 5.0 {
        let velocity = [0.0, 0.0, 60.0, 0.0, 0.0, 0.0];
        stream.handle().set_joint_velocity(velocity, Duration::from_millis(500)).expect("nothing is wrong yet");
        assert!(arm.clock().elapsed().saturating_sub(since) < LIMIT, "{trouble}: it does not move");
        arm.clock().sleep(Duration::from_millis(5));
    }
    struck(trouble, arm, || stream.land().map(drop))
}

/// Lands while it goes wrong.
fn struck(trouble: &Trouble, arm: &Arm, land: impl FnOnce() -> Result<(), Error>) -> Result<(), Error> {
    if let Some(fault) = trouble.fault("servo_j") {
        arm.inject_for("servo_j", fault);
    }
    arm.status_fault(trouble.status());
    let Trouble::Link(link) = trouble else { return land() };
    link.strike(arm);
    let Some(lasting) = link.lasting else { return land() };
    let release = || {
        arm.clock().sleep(lasting);
        arm.links().release();
    };
    beside(arm.clock(), release, land)
}

/// Clears the status fault, releases the links, and waits 500 ms for held or late bytes.
fn lift(trouble: &Trouble, arm: &Arm) {
    arm.status_fault(StatusFault::None);
    if matches!(trouble, Trouble::Link(_)) {
        arm.links().release();
    }
    arm.clock().sleep(Duration::from_millis(500));
}

fn judge(trouble: &Trouble, way: Way, arm: &Arm, ended: &Result<(), Error>) {
    let requests = parsed(arm);
    let steps = steps(&requests);
    let what = || format!("{trouble}, {way:?}: {ended:?}: {steps:?}");
    let jumps = steps.windows(2).any(|two| (two[1] - two[0]).abs() > MOST * PERIOD * PERIOD * (1.0 + 1e-6));
    assert!(!jumps, "{}", what());
    let off = requests.iter().position(|request| request["cmdName"] == "servo_move" && request["relFlag"] == 0);
    let after = off.map_or(&[][..], |off| &requests[off..]);
    assert!(after.iter().all(|request| request["cmdName"] != "servo_j"), "a set-point after the end: {}", what());
    let rests = steps.last() == Some(&0.0);
    match ended {
        Ok(()) => {
            let state = arm.state();
            assert!(rests && off.is_some() && !state.servo_mode, "{state:?}: {}", what());
            let moved: f64 = steps.iter().sum();
            assert!((state.joint_position.0[2] - START[2] - moved).abs() < 1e-6, "{state:?}: {}", what());
        }
        // What is not at rest is said, or the connection is gone.
        Err(error) if !rests => assert!(
            error.is_disconnected()
                || matches!(
                    error.kind(),
                    ErrorKind::SetPointsUnanswered { .. }
                        | ErrorKind::ServoModeNotLeft { .. }
                        | ErrorKind::NotLanded { .. }
                ),
            "{}",
            what()
        ),
        Err(_) => {}
    }
}

/// The requests that have come.
pub(crate) fn parsed(controller: &Controller) -> Vec<Value> {
    controller.requests().iter().map(|text| serde_json::from_str(text).expect("requests are JSON")).collect()
}

/// Travel of joint 3 with each set-point, in degrees.
pub(crate) fn steps(requests: &[Value]) -> Vec<f64> {
    let mut at = START[2];
    let set_points = requests.iter().filter(|request| request["cmdName"] == "servo_j");
    let step = |request: &Value| {
        let joint = request["jointPosition"][2].as_f64().expect("a number");
        let step = if request["relFlag"] == 1 { joint } else { joint - at };
        at += step;
        if step.abs() < 1e-9 { 0.0 } else { step }
    };
    set_points.map(step).collect()
}
