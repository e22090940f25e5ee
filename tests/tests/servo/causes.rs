//! One event has one cause, whatever the arm was doing. Events come at random moments of each way of moving, by
//! simulated clocks.

use std::error::Error as StdError;
use std::iter;
use std::time::Duration;

use jaka_robot::jaka_motion::{Checker, Frames};
use jaka_robot::motion::JointMove;
use jaka_robot::{
    Cause, Error, FollowConfig, Guard, MotionExt as _, Numbering, Robot, RobotConfig, ServoConfig, StopHandle,
    StreamConfig,
};
use jaka_sim::{Fault, Port, StatusFault};
use jaka_tests::rig::Random;
use jaka_tests::simulated::beside;
use jaka_tests::{Arm, Configured as _, LONG};

use crate::follow;

/// Runs of each cell, at other moments. The long form is `JAKA_CAUSES=50`.
fn runs() -> u32 {
    std::env::var("JAKA_CAUSES").ok().and_then(|runs| runs.parse().ok()).unwrap_or(2)
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Event {
    PowerCut,
    EmergencyStop,
    ProtectiveStop,
    Collision,
    ControllerError,
    DisabledByAnother,
    SeatLost,
    StatusClosed,
    BothClosed,
    CommandsSilent,
    StatusSilent,
    BothSilent,
    Unreadable,
    DragMode,
    ForeignStop,
    OwnStop,
    RefusedSetPoint,
    LateSetPoint,
    GuardTrip,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Way {
    Run,
    GuardedRun,
    Session,
    Stream,
    Trajectory,
    Wait,
}

const WAYS: [Way; 6] = [Way::Run, Way::GuardedRun, Way::Session, Way::Stream, Way::Trajectory, Way::Wait];

/// The cause of each event, and the ways in which it cannot be, or does not end the way.
const EVENTS: [(Event, Cause, &[Way]); 19] = [
    (Event::PowerCut, Cause::NotPowered, &[]),
    (Event::EmergencyStop, Cause::EmergencyStop, &[]),
    (Event::ProtectiveStop, Cause::ProtectiveStop, &[]),
    (Event::Collision, Cause::ProtectiveStop, &[]),
    (Event::ControllerError, Cause::ControllerError, &[]),
    (Event::DisabledByAnother, Cause::NotEnabled, &[]),
    // The controller closes the command port.
    (Event::SeatLost, Cause::CommandsLost, &[]),
    (Event::StatusClosed, Cause::StatusLost, &[]),
    (Event::BothClosed, Cause::CommandsLost, &[]),
    // Nothing is sent.
    (Event::CommandsSilent, Cause::Unanswered, &[Way::Wait]),
    (Event::StatusSilent, Cause::StatusLost, &[]),
    (Event::BothSilent, Cause::Unanswered, &[Way::Wait]),
    (Event::Unreadable, Cause::StatusLost, &[]),
    // A hand that leads the arm may press the button that is waited for.
    (Event::DragMode, Cause::DragMode, &[Way::Wait]),
    (Event::ForeignStop, Cause::Stopped, &[]),
    (Event::OwnStop, Cause::Stopped, &[]),
    // No set-points are sent.
    (Event::RefusedSetPoint, Cause::Refused, &[Way::Run, Way::GuardedRun, Way::Wait]),
    // No set-points are sent; the threads of streams and trajectories are held up by the tests of `held_up`.
    (Event::LateSetPoint, Cause::SetPointLate, &[Way::Run, Way::GuardedRun, Way::Stream, Way::Trajectory, Way::Wait]),
    // There is no guard.
    (Event::GuardTrip, Cause::Guard, &[Way::Run, Way::Session, Way::Wait]),
];

const IO: Numbering = Numbering::FromOne;

fn guard() -> Guard {
    IO.cabinet(3).is_high().into()
}

impl Event {
    fn happen(self, arm: &Arm, own: &jaka_robot::RobotStop, foreign: &StopHandle) {
        match self {
            Self::PowerCut => arm.cut_power(),
            Self::EmergencyStop => arm.press_emergency_stop(),
            Self::ProtectiveStop => arm.set_state(|state| state.protective_stop = true),
            Self::Collision => arm.collide(),
            Self::ControllerError => arm.set_state(|state| {
                "0xF0034".clone_into(&mut state.error_code);
                state.servo_mode = false;
            }),
            Self::DisabledByAnother => arm.set_state(|state| state.enabled = false),
            Self::SeatLost => arm.take_over().expect("it listens"),
            Self::StatusClosed => arm.status_fault(StatusFault::CloseAfter(0)),
            Self::BothClosed => arm.disconnect(),
            Self::CommandsSilent => arm.link(Port::Command).to_client().hold(),
            Self::StatusSilent => arm.link(Port::Status).to_client().hold(),
            Self::BothSilent => arm.links().to_client().hold(),
            Self::Unreadable => arm.status_fault(StatusFault::Instead(br#"{"emergency_stop": "maybe"}"#.to_vec())),
            Self::DragMode => arm.set_state(|state| state.drag_mode = true),
            Self::ForeignStop => drop(foreign.stop()),
            Self::OwnStop => drop(own.stop()),
            Self::RefusedSetPoint => {
                let refusal = br#"{"errorCode": "2", "errorMsg": "call servo_j failed", "cmdName": "servo_j"}"#;
                arm.inject_for("servo_j", Fault::Instead(refusal.to_vec()));
            }
            // The caller of the session is held up: see `act`.
            Self::LateSetPoint => {}
            Self::GuardTrip => arm.set_state(|state| state.digital_inputs[2] = true),
        }
    }
}

fn servo() -> ServoConfig {
    ServoConfig::new().step_count(4)
}

/// Text of an error and of its sources, in one line.
fn line(error: &Error) -> String {
    let first: &dyn StdError = error;
    let texts: Vec<_> = iter::successors(Some(first), |&error| error.source()).map(ToString::to_string).collect();
    texts.join(": ")
}

/// Text that a line repeats: the fact of its cause, or another clause.
fn repeated(cause: Cause, line: &str) -> Option<String> {
    let fact = cause.to_string();
    if line.matches(&fact).count() > 1 {
        return Some(fact);
    }
    let mut clauses: Vec<_> = line.split([';', ':', ',']).map(str::trim).filter(|clause| clause.len() >= 25).collect();
    clauses.sort_unstable();
    clauses.windows(2).find(|pair| pair[0] == pair[1]).map(|pair| pair[0].to_owned())
}

/// Moves the arm in this way until it ends: the cause, and what is told of it.
fn act(way: Way, robot: &mut Robot, arm: &Arm, late_after: Option<Duration>) -> (Cause, String) {
    let of = |error: Error| (error.cause(), line(&error));
    let motion = JointMove::relative([0.0, 0.0, 0.0, 0.0, 0.0, 300.0], 20.0).acceleration(100.0);
    let motion_end =
        |end: jaka_robot::End| (end.cause(), end.reached().map_or_else(|error| line(&error), |()| String::new()));
    match way {
        Way::Run => robot.run(&motion, LONG).map_or_else(of, motion_end),
        Way::GuardedRun => robot.run(&motion.guard(guard()), LONG).map_or_else(of, motion_end),
        Way::Session => {
            let mut session = match robot.enter_servo_mode(servo()) {
                Ok(session) => session,
                Err(error) => return of(error),
            };
            let mut late_at = late_after.map(|after| arm.clock().elapsed() + after);
            for cycle in 0..300 {
                if late_at.take_if(|at| arm.clock().elapsed() >= *at).is_some() {
                    arm.clock().sleep(servo().period() * 4);
                }
                if let Err(error) =
                    session.send_joint_offset([0.0, 0.0, 0.0, 0.0, 0.0, f64::from(cycle.min(10)) * 0.06])
                {
                    return of(error);
                }
            }
            drop(session.land());
            (Cause::Reached, "nothing ended it".to_owned())
        }
        Way::Stream => {
            let stream = match robot.stream(&StreamConfig::new().servo(servo()).guard(guard())) {
                Ok(stream) => stream,
                Err(error) => return of(error),
            };
            for _ in 0..100 {
                let velocity = [0.0, 0.0, 0.0, 0.0, 0.0, 15.0];
                if stream.handle().set_joint_velocity(velocity, Duration::from_millis(300)).is_err() {
                    break;
                }
                arm.clock().sleep(Duration::from_millis(100));
            }
            stream.land().map_or_else(of, |_| (Cause::Reached, "nothing ended it".to_owned()))
        }
        Way::Trajectory => {
            let checker = Checker::new(follow::limits(), Frames::new());
            let trajectory = follow::trajectory(&follow::to_and_fro(), &checker).expect("within the limits");
            match robot.start_follow(&trajectory, &FollowConfig::new().servo(servo()).guard(guard())) {
                Ok(run) => motion_end(run.wait()),
                Err(error) => of(error),
            }
        }
        Way::Wait => {
            robot.wait_for_input(IO.cabinet(5).is_high(), LONG).map_or_else(of, |_| (Cause::Reached, String::new()))
        }
    }
}

/// The cause that is told where this happens so long after the way has begun.
fn cell(event: Event, way: Way, after: Duration) -> (Cause, String) {
    let config = |config: jaka_robot::Config| config.reply_timeout(Duration::from_secs(2));
    let (arm, robot) =
        Arm::simulated().at(follow::START).status_period(Duration::from_millis(30)).config(config).with_robot();
    let mut robot = robot.configured(&RobotConfig::new().limits(follow::limits())).expect("it is this arm");
    let (own, foreign) = (robot.stop_handle(), robot.client().stop_handle());
    let happens = || {
        arm.clock().sleep(after);
        event.happen(&arm, &own, &foreign);
    };
    let late_after = (event == Event::LateSetPoint).then_some(after);
    beside(arm.clock(), happens, || act(way, &mut robot, &arm, late_after))
}

#[test]
fn an_event_has_the_same_cause_in_each_way_of_moving_and_is_told_once() {
    let mut random = Random::new(29);
    let mut wrong = Vec::new();
    for (event, cause, impossible) in EVENTS {
        for way in WAYS {
            if impossible.contains(&way) {
                continue;
            }
            for _ in 0..runs() {
                let after = Duration::from_micros(u64::from(random.below(1_500_000)) + 500_000);
                let (found, text) = cell(event, way, after);
                let has_text = text.contains(&cause.to_string());
                if found != cause || !has_text {
                    wrong.push(format!("{event:?} in {way:?} after {after:?}: {found:?}, not {cause:?}: {text}"));
                }
                if let Some(clause) = repeated(cause, &text) {
                    wrong.push(format!("{event:?} in {way:?} after {after:?}: `{clause}` twice: {text}"));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{} cells:\n{}", wrong.len(), wrong.join("\n"));
}
