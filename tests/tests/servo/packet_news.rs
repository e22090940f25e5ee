//! States of the robot that packets show while the controller accepts set-points, or that the refusal of a set-point
//! shows first: one outcome in each way of moving. Witnesses are the requests on the wire and the simulator's state. By
//! simulated clocks.

use std::time::Duration;

use jaka_robot::jaka_motion::{Trajectory, Via};
use jaka_robot::motion::JointMove;
use jaka_robot::{
    Cause, End, Error, ErrorKind, FollowConfig, Guard, MotionExt as _, Numbering, Robot, RobotConfig, ServoConfig,
    StreamConfig,
};
use jaka_sim::{Fault, StatusFault};
use jaka_tests::rig::Random;
use jaka_tests::simulated::{beside, until};
use jaka_tests::{Arm, CYCLE, Configured as _, LONG};
use serde_json::{Value, json};

use crate::follow;
use crate::received::{names, requests};

/// Runs of each cell, at other moments. The long form is `JAKA_CAUSES=50`.
fn runs() -> u32 {
    std::env::var("JAKA_CAUSES").ok().and_then(|runs| runs.parse().ok()).unwrap_or(1)
}

const START: [f64; 6] = [10.0, 100.0, 80.0, 90.0, -90.0, -340.0];

/// Least step of a set-point at speed, in degrees: 50 deg/s.
const STEP: f64 = 0.4;

/// State that packets show.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Shown {
    NoPower,
    /// Only by `task_state`.
    PoweredOff,
    NotEnabled,
    DragMode,
    Error,
    SoftLimit,
    EmergencyStop,
}

const SHOWN: [(Shown, Cause); 7] = [
    (Shown::NoPower, Cause::NotPowered),
    (Shown::PoweredOff, Cause::NotPowered),
    (Shown::NotEnabled, Cause::NotEnabled),
    (Shown::DragMode, Cause::DragMode),
    (Shown::Error, Cause::ControllerError),
    (Shown::SoftLimit, Cause::SoftLimit),
    (Shown::EmergencyStop, Cause::EmergencyStop),
];

impl Shown {
    /// Key of packets, with its value and the usual one.
    fn key(self) -> (&'static str, Value, Value) {
        match self {
            Self::NoPower => ("powered_on", 0.into(), 1.into()),
            Self::PoweredOff => ("task_state", 1.into(), 4.into()),
            Self::NotEnabled => ("enabled", false.into(), true.into()),
            Self::DragMode => ("drag_status", true.into(), false.into()),
            Self::Error => ("errcode", "0xF0034".into(), "0x0".into()),
            Self::SoftLimit => ("on_soft_limit", 1.into(), 0.into()),
            Self::EmergencyStop => ("emergency_stop", 1.into(), 0.into()),
        }
    }

    /// Shows it by packets alone: the controller refuses nothing.
    fn show(self, arm: &Arm) {
        let (key, shown, _) = self.key();
        arm.set_status([(key.to_owned(), shown)]);
        arm.publish();
    }

    fn end(self, arm: &Arm) {
        let (key, _, usual) = self.key();
        arm.set_status([(key.to_owned(), usual)]);
        arm.publish();
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Way {
    Run,
    GuardedRun,
    Session,
    Stream,
    Trajectory,
}

impl Way {
    fn has_set_points(self) -> bool {
        match self {
            Self::Run | Self::GuardedRun => false,
            Self::Session | Self::Stream | Self::Trajectory => true,
        }
    }
}

const WAYS: [Way; 5] = [Way::Run, Way::GuardedRun, Way::Session, Way::Stream, Way::Trajectory];

/// The first news.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum First {
    Packet,
    Refusal,
}

fn guard() -> Guard {
    Numbering::FromOne.cabinet(3).is_high().into()
}

fn refuse_set_point(arm: &Arm) {
    let refusal = br#"{"errorCode": "2", "errorMsg": "call servo_j failed", "cmdName": "servo_j"}"#;
    arm.inject_for("servo_j", Fault::Instead(refusal.to_vec()));
}

fn ready() -> (Arm, Robot) {
    let (arm, robot) = Arm::simulated().at(START).status_period(Duration::from_millis(30)).with_robot();
    let robot = robot.configured(&RobotConfig::new().limits(follow::limits())).expect("it is this arm");
    (arm, robot)
}

fn of_error(error: &Error) -> (Cause, String) {
    (error.cause(), error.kind().to_string())
}

fn of_end(end: &End) -> (Cause, String) {
    end.error.as_ref().map_or_else(|| (end.cause(), end.to_string()), of_error)
}

/// Moves joint 6 until something ends it: the cause, and the fact.
fn act(way: Way, robot: &mut Robot) -> (Cause, String) {
    let servo = ServoConfig::new();
    let mut target = START;
    target[5] = 340.0;
    let motion = JointMove::relative([0.0, 0.0, 0.0, 0.0, 0.0, 600.0], 50.0).acceleration(200.0);
    match way {
        Way::Run => of_end(&robot.run(&motion, LONG).expect("it is accepted")),
        Way::GuardedRun => of_end(&robot.run(&motion.guard(guard()), LONG).expect("it is accepted")),
        Way::Session => {
            let mut session = robot.enter_servo_mode(&servo).expect("the arm is ready");
            for cycle in 1..800 {
                let offset = f64::from(cycle.min(40)) * STEP / 40.0;
                if let Err(error) = session.send_joint_offset([0.0, 0.0, 0.0, 0.0, 0.0, offset]) {
                    return of_error(&error);
                }
            }
            drop(session.land());
            (Cause::Landed, String::new())
        }
        Way::Stream => {
            let stream = robot.stream(&StreamConfig::new().servo(servo).guard(guard())).expect("the arm is ready");
            stream.handle().set_joints(target).expect("within its range");
            let _ = stream.handle().wait_for_rest(LONG);
            stream.land().map_or_else(|error| of_error(&error), |end| of_end(&end))
        }
        Way::Trajectory => {
            let checker = robot.limits().expect("it has some");
            let points = [Via::joints(START), Via::joints(target)];
            let trajectory = Trajectory::through(points).joint_speeds([50.0; 6]).build(checker).expect("within them");
            let config = FollowConfig::new().servo(servo).guard(guard());
            of_end(&robot.start_follow(&trajectory, &config).expect("the arm is ready").wait())
        }
    }
}

/// Steps of joint 6 of all set-points, in degrees.
fn steps(arm: &Arm) -> Vec<f64> {
    let mut at = START[5];
    let set_points = requests(arm).into_iter().filter(|request| request["cmdName"] == "servo_j");
    let step = |request: Value| {
        let joint = request["jointPosition"][5].as_f64().expect("a number");
        let next = if request["relFlag"] == 1 { at + joint } else { joint };
        next - std::mem::replace(&mut at, next)
    };
    set_points.map(step).collect()
}

/// Requests that move or stop the arm after the news.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Reaction {
    /// Set-points that brake it, and then hold it.
    Lands,
    /// Set-points that brake it.
    Brakes,
    /// No set-point.
    Nothing,
    /// `stop_program`.
    Stops,
    /// Something else, by the steps of the set-points.
    Other,
}

fn reaction(arm: &Arm, way: Way, sent_before: usize) -> Reaction {
    if !way.has_set_points() {
        let stops = names(arm).contains(&"stop_program".to_owned());
        return if stops { Reaction::Stops } else { Reaction::Nothing };
    }
    let steps = steps(arm);
    let at_speed = steps[sent_before - 1];
    assert!(at_speed > STEP - 1e-3, "at speed: {steps:?}");
    // Set-points of the cycles before the second packet, or before the reply.
    let (before, after) = steps[sent_before..].split_at((steps.len() - sent_before).min(8));
    let slower = |steps: &[f64]| steps.windows(2).all(|two| two[1] <= two[0] + 1e-4 && two[1] >= -1e-9);
    let held = steps.iter().rev().take_while(|step| step.abs() < 1e-6).count();
    let moving = steps.len() - held;
    let is_braked = slower(&steps[sent_before - 1..]) && steps[moving - 1] < at_speed / 4.0;
    match (is_braked, held) {
        (true, 2..) => Reaction::Lands,
        (true, _) => Reaction::Brakes,
        (false, _) if after.is_empty() && before.len() <= 1 => Reaction::Nothing,
        (false, _) => Reaction::Other,
    }
}

/// Outcome of a cell: the cause and the fact, the reaction, and the occurrence that is latched.
type Outcome = (Cause, String, Reaction, Option<Cause>);

fn cell(shown: Shown, way: Way, first: First, after: Duration) -> Outcome {
    let (arm, mut robot) = ready();
    let mut sent_before = 0;
    let happens = || {
        arm.clock().sleep(after);
        sent_before = steps(&arm).len();
        if first == First::Refusal {
            refuse_set_point(&arm);
            until(arm.clock(), || steps(&arm).len() > sent_before);
            arm.clock().sleep(CYCLE / 4);
        }
        shown.show(&arm);
    };
    let (cause, fact) = beside(arm.clock(), happens, || act(way, &mut robot));
    assert!(!arm.state().servo_mode, "servo mode was left");
    if way == Way::Run && cause == Cause::DragMode {
        assert!(arm.state().at_rest, "the arm was stopped");
    }
    let reaction = reaction(&arm, way, sent_before);
    shown.end(&arm);
    arm.clock().sleep(CYCLE * 10);
    let latched = robot.unacknowledged().map(|occurrence| occurrence.cause);
    let sent = names(&arm).len();
    if latched.is_some() {
        let error = robot.start(&JointMove::relative([1.0; 6], 5.0)).expect_err("nothing has been acknowledged");
        assert!(matches!(error.kind(), ErrorKind::NotAcknowledged { .. }), "{error:?}");
        robot.enter_servo_mode(ServoConfig::new()).expect_err("nothing has been acknowledged");
        assert_eq!(names(&arm)[sent..], [] as [&str; 0]);
    }
    // Without one, a motion that the controller plans goes on.
    robot.stop_handle().stop().expect("it is accepted");
    robot.acknowledge();
    drop(robot.enter_servo_mode(ServoConfig::new()).expect("nothing keeps it back").land().expect("it rests"));
    (cause, fact, reaction, latched)
}

#[test]
fn a_state_in_packets_has_one_outcome_in_each_way_of_moving_whichever_news_is_first() {
    let mut random = Random::new(37);
    let mut wrong = Vec::new();
    for (shown, cause) in SHOWN {
        let latched = matches!(shown, Shown::DragMode | Shown::EmergencyStop).then_some(cause);
        let mut facts = Vec::new();
        for (way, first) in WAYS.into_iter().flat_map(|way| [(way, First::Packet), (way, First::Refusal)]) {
            if first == First::Refusal && !way.has_set_points() {
                continue;
            }
            let expected = match (way, shown) {
                // Nobody would judge the guard while the arm may move.
                (Way::GuardedRun, Shown::Error | Shown::SoftLimit) | (Way::Run | Way::GuardedRun, Shown::DragMode) => {
                    Some(Reaction::Stops)
                }
                // Braking begins with the refusal.
                (_, Shown::EmergencyStop) if first == First::Refusal => None,
                (Way::Run | Way::GuardedRun, _) | (_, Shown::EmergencyStop) => Some(Reaction::Nothing),
                (_, Shown::DragMode) => Some(Reaction::Brakes),
                _ => Some(Reaction::Lands),
            };
            for _ in 0..runs() {
                let after = Duration::from_micros(u64::from(random.below(1_000_000)) + 1_200_000);
                let (found, fact, reaction, is_latched) = cell(shown, way, first, after);
                if found != cause || expected.is_some_and(|expected| expected != reaction) || is_latched != latched {
                    let cell = format!("{shown:?} in {way:?}, first {first:?}, after {after:?}");
                    wrong.push(format!("{cell}: {found:?}, {reaction:?}, latched {is_latched:?}: {fact}"));
                }
                if way.has_set_points() {
                    facts.push(fact);
                }
            }
        }
        facts.dedup();
        if facts.len() != 1 {
            wrong.push(format!("{shown:?} is told in several ways: {facts:?}"));
        }
    }
    assert!(wrong.is_empty(), "{} cells:\n{}", wrong.len(), wrong.join("\n"));
}

#[test]
fn power_and_enabling_are_lost_by_two_packets_in_a_row_and_by_no_one_alone() {
    for shown in [Shown::NoPower, Shown::PoweredOff, Shown::NotEnabled] {
        for way in WAYS {
            let (arm, mut robot) = ready();
            // One packet after the other, while others tell the contrary.
            let happens = || {
                for _ in 0..5 {
                    // Not at the same moment as a packet of the controller's own.
                    arm.clock().sleep(Duration::from_micros(107_300));
                    shown.show(&arm);
                    shown.end(&arm);
                }
                arm.set_state(|state| state.digital_inputs[2] = true);
                arm.set_state(|state| state.error_code = "0xF0034".to_owned());
            };
            let (cause, fact) = beside(arm.clock(), happens, || act(way, &mut robot));
            let is_other = matches!(cause, Cause::ControllerError | Cause::Guard);
            assert!(is_other, "{shown:?} in {way:?}: {cause:?}: {fact}");
        }
    }
}

/// The second packet comes before the next cycle.
#[test]
fn two_packets_between_two_cycles_count_as_two() {
    for way in WAYS {
        let (arm, mut robot) = ready();
        let happens = || {
            arm.clock().sleep(Duration::from_millis(1200));
            Shown::NoPower.show(&arm);
            arm.publish();
            Shown::NoPower.end(&arm);
        };
        let (cause, fact) = beside(arm.clock(), happens, || act(way, &mut robot));
        assert_eq!(cause, Cause::NotPowered, "{way:?}: {fact}");
    }
}

/// The joints are elsewhere by the packet that shows drag mode.
#[test]
fn in_drag_mode_no_set_point_brakes_an_arm_that_does_not_follow() {
    for way in [Way::Session, Way::Stream, Way::Trajectory] {
        let (arm, mut robot) = ready();
        let mut sent_before = 0;
        let happens = || {
            arm.clock().sleep(Duration::from_millis(1500));
            arm.set_status([("joint_actual_position".to_owned(), json!([10.0, 90.0, 80.0, 90.0, -90.0, -300.0]))]);
            sent_before = steps(&arm).len();
            Shown::DragMode.show(&arm);
        };
        let (cause, fact) = beside(arm.clock(), happens, || act(way, &mut robot));
        assert_eq!(cause, Cause::DragMode, "{way:?}: {fact}");
        assert_eq!(steps(&arm).len(), sent_before, "{way:?}");
        assert!(!arm.state().servo_mode);
    }
}

#[test]
fn in_drag_mode_nothing_begins_before_it_has_ended_and_is_acknowledged() {
    let (arm, mut robot) = ready();
    Shown::DragMode.show(&arm);
    arm.clock().sleep(CYCLE);
    let motion = JointMove::relative([1.0; 6], 5.0).acceleration(20.0);
    let sent = names(&arm).len();
    let refusals = |robot: &mut Robot| {
        let entered = robot.enter_servo_mode(ServoConfig::new()).map(drop);
        [robot.start(&motion), robot.run(&motion.guard(guard()), LONG).map(drop), entered].map(Result::unwrap_err)
    };
    for error in refusals(&mut robot) {
        assert!(matches!(error.kind(), ErrorKind::NotAcknowledged { .. }), "{error:?}");
        assert_eq!(error.cause(), Cause::DragMode, "{error}");
    }
    robot.acknowledge();
    let error = robot.start(&motion).expect_err("packets show drag mode");
    assert!(
        matches!(error.kind(), ErrorKind::NotReady { occurrence } if occurrence.cause == Cause::DragMode),
        "{error:?}"
    );
    assert!(names(&arm)[sent..].iter().all(|name| name.starts_with("get_") || name.starts_with("kine")), "{sent}");
    Shown::DragMode.end(&arm);
    arm.clock().sleep(CYCLE);
    robot.acknowledge();
    assert!(robot.start(&motion).is_ok());
}

/// Packets show the joints elsewhere.
#[test]
fn joints_that_depart_from_their_set_points_are_braked_and_not_held() {
    for way in [Way::Stream, Way::Trajectory] {
        let (arm, mut robot) = ready();
        let mut sent_before = 0;
        let happens = || {
            arm.clock().sleep(Duration::from_millis(1500));
            sent_before = steps(&arm).len();
            arm.set_status([("joint_actual_position".to_owned(), json!([10.0, 90.0, 80.0, 90.0, -90.0, -300.0]))]);
            arm.publish();
        };
        let (cause, fact) = beside(arm.clock(), happens, || act(way, &mut robot));
        assert_eq!(cause, Cause::Departed, "{way:?}: {fact}");
        assert_eq!(reaction(&arm, way, sent_before), Reaction::Brakes, "{way:?}: {:?}", steps(&arm));
    }
}

/// Drag mode comes while the arm is held at its last set-point.
#[test]
fn drag_mode_ends_the_holding_of_a_landing() {
    // Packets never show rest at the last set-point.
    let (arm, mut robot) = ready();
    let mut session = robot.enter_servo_mode(ServoConfig::new()).expect("the arm is ready");
    for _ in 0..5 {
        session.send_joint_offset([0.0, 0.0, 0.0, 0.0, 0.0, 0.01]).expect("it is slow");
    }
    let joints = json!([10.0, 100.0, 80.0, 90.0, -90.0, -338.0]);
    arm.set_status([("joint_actual_position".to_owned(), joints)]);
    let mut sent_before = 0;
    let happens = || {
        arm.clock().sleep(Duration::from_millis(200));
        sent_before = steps(&arm).len();
        Shown::DragMode.show(&arm);
    };
    let error = beside(arm.clock(), happens, || session.land()).expect_err("a hand may be on the arm");
    assert_eq!(error.cause(), Cause::DragMode, "{error}");
    assert!(sent_before > 20, "it was held: {sent_before}");
    assert_eq!(steps(&arm).len(), sent_before);
    assert!(!arm.state().servo_mode);
}

#[test]
fn of_what_must_be_acknowledged_the_first_by_precedence_stays() {
    let unacknowledged = |robot: &Robot| robot.unacknowledged().map(|occurrence| occurrence.cause);
    let (arm, robot) = ready();
    Shown::DragMode.show(&arm);
    arm.clock().sleep(CYCLE);
    assert_eq!(unacknowledged(&robot), Some(Cause::DragMode));
    Shown::EmergencyStop.show(&arm);
    arm.clock().sleep(CYCLE);
    assert_eq!(unacknowledged(&robot), Some(Cause::EmergencyStop));
    // Drag mode and a lost status follow.
    Shown::EmergencyStop.end(&arm);
    let mut robot = robot;
    arm.status_fault(StatusFault::Instead(br#"{"emergency_stop": "maybe"}"#.to_vec()));
    arm.publish();
    arm.status_fault(StatusFault::CloseAfter(0));
    drop(robot.wait(LONG));
    arm.clock().sleep(Duration::from_secs(1));
    assert_eq!(unacknowledged(&robot), Some(Cause::EmergencyStop));
    robot.acknowledge();
    assert_eq!(unacknowledged(&robot), None);
}
