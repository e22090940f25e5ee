//! Time from news that must brake or stop an arm at speed until the first request that shows it. A proxy between the
//! client and the controller keeps each message with its simulated time, and reads JSON by itself.

use std::time::Duration;

use jaka_robot::jaka_motion::{Trajectory, Via};
use jaka_robot::motion::JointMove;
use jaka_robot::{
    Client, FollowConfig, Guard, MotionExt as _, Numbering, Robot, RobotConfig, ServoConfig, StreamConfig,
};
use jaka_sim::{Fault, Port, StatusFault};
use jaka_tests::rig::Random;
use jaka_tests::simulated::{CommandWire, TimedMessage, beside};
use jaka_tests::{Arm, CYCLE, Configured as _, LONG};
use serde_json::Value;

use crate::follow;

/// Runs of each cell, at other moments. The long form is `JAKA_BRAKING=24`.
fn runs() -> u32 {
    std::env::var("JAKA_BRAKING").ok().and_then(|runs| runs.parse().ok()).unwrap_or(2)
}

const START: [f64; 6] = [10.0, 100.0, 80.0, 90.0, -90.0, -340.0];

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Event {
    EmergencyStop,
    ProtectiveStop,
    ControllerError,
    PowerCut,
    DisabledByAnother,
    RefusedSetPoint,
    StatusSilent,
    StatusClosed,
    Unreadable,
    GuardTrip,
    DragMode,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Way {
    Session,
    Stream,
    Trajectory,
    GuardedRun,
}

const WAYS: [Way; 4] = [Way::Session, Way::Stream, Way::Trajectory, Way::GuardedRun];

/// First request that shows the reaction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Reaction {
    /// A set-point that is slower than the last one before the news.
    Brakes,
    /// `stop_program`.
    Stops,
    /// The last set-point, at speed: no other follows.
    Ends,
    /// No request that concerns the motion.
    Nothing,
}

const EVENTS: [Event; 11] = [
    Event::EmergencyStop,
    Event::ProtectiveStop,
    Event::ControllerError,
    Event::PowerCut,
    Event::DisabledByAnother,
    Event::RefusedSetPoint,
    Event::StatusSilent,
    Event::StatusClosed,
    Event::Unreadable,
    Event::GuardTrip,
    Event::DragMode,
];

const IO: Numbering = Numbering::FromOne;

fn guard() -> Guard {
    IO.cabinet(3).is_high().into()
}

impl Event {
    /// Reaction in this way, and the most cycles until it; `None` if the event cannot be, or where no source says what
    /// it does to a motion.
    fn expected(self, way: Way) -> Option<(Reaction, u32)> {
        let (in_servo_mode, under_guard) = match self {
            // The controller follows no set-points then.
            Self::EmergencyStop | Self::ProtectiveStop => ((Reaction::Ends, 0), Some((Reaction::Nothing, 0))),
            // The next set-point is refused, and the one after it brakes.
            Self::PowerCut | Self::DisabledByAnother => ((Reaction::Brakes, 2), Some((Reaction::Nothing, 0))),
            Self::ControllerError => ((Reaction::Brakes, 1), Some((Reaction::Stops, 0))),
            Self::RefusedSetPoint => ((Reaction::Brakes, 1), None),
            // Packets are stale after 500 ms, which are 62.5 cycles.
            Self::StatusSilent => ((Reaction::Brakes, 64), Some((Reaction::Stops, 63))),
            Self::StatusClosed | Self::Unreadable | Self::GuardTrip | Self::DragMode => {
                ((Reaction::Brakes, 1), Some((Reaction::Stops, 0)))
            }
        };
        match way {
            Way::GuardedRun => under_guard,
            // It has no guard.
            Way::Session if self == Self::GuardTrip => None,
            Way::Session | Way::Stream | Way::Trajectory => Some(in_servo_mode),
        }
    }

    /// Makes it happen, and shows it by a packet at once.
    fn happen(self, arm: &Arm) {
        match self {
            // By the packet alone: the controller refuses nothing.
            Self::EmergencyStop => arm.set_status([("emergency_stop".to_owned(), 1.into())]),
            Self::ProtectiveStop => arm.set_status([("protective_stop".to_owned(), 1.into())]),
            Self::ControllerError => arm.set_state(|state| {
                "0xF0034".clone_into(&mut state.error_code);
                state.servo_mode = false;
            }),
            Self::PowerCut => arm.cut_power(),
            Self::DisabledByAnother => arm.set_state(|state| state.enabled = false),
            Self::RefusedSetPoint => {
                let refusal = br#"{"errorCode": "2", "errorMsg": "call servo_j failed", "cmdName": "servo_j"}"#;
                arm.inject_for("servo_j", Fault::Instead(refusal.to_vec()));
                return;
            }
            Self::StatusSilent => {
                arm.publish();
                arm.link(Port::Status).to_client().hold();
                return;
            }
            Self::StatusClosed => arm.status_fault(StatusFault::CloseAfter(0)),
            Self::Unreadable => arm.status_fault(StatusFault::Instead(br#"{"emergency_stop": "maybe"}"#.to_vec())),
            Self::GuardTrip => arm.set_state(|state| state.digital_inputs[2] = true),
            Self::DragMode => arm.set_state(|state| state.drag_mode = true),
        }
        arm.publish();
    }
}

/// Moves joint 6 until something ends it.
fn act(way: Way, robot: &mut Robot) {
    let servo = ServoConfig::new();
    let mut end = START;
    end[5] = 340.0;
    match way {
        Way::Session => {
            let mut session = robot.enter_servo_mode(&servo).expect("the arm is ready");
            for cycle in 1..500 {
                let offset = f64::from(cycle.min(40)) * 0.01;
                if session.send_joint_offset([0.0, 0.0, 0.0, 0.0, 0.0, offset]).is_err() {
                    return;
                }
            }
        }
        Way::Stream => {
            let stream = robot.stream(&StreamConfig::new().servo(servo).guard(guard())).expect("the arm is ready");
            stream.handle().set_joints(end).expect("within its range");
            let _ = stream.handle().wait_for_rest(LONG);
        }
        Way::Trajectory => {
            let points = [Via::joints(START), Via::joints(end)];
            let checker = robot.limits().expect("it has some");
            let trajectory = Trajectory::through(points).joint_speeds([100.0; 6]).build(checker).expect("within them");
            let config = FollowConfig::new().servo(servo);
            drop(robot.start_follow(&trajectory, &config.clone().guard(guard())).expect("the arm is ready").wait());
        }
        Way::GuardedRun => {
            let motion = JointMove::relative([0.0, 0.0, 0.0, 0.0, 0.0, 600.0], 60.0).acceleration(200.0);
            drop(robot.run(&motion.guard(guard()), LONG));
        }
    }
}

/// Reaction to an event that happens so long after the way has begun, and the time from the news to it. Replies have
/// this lag where the news is one of them.
fn cell(event: Event, way: Way, after: Duration, lag: Duration) -> (Reaction, Duration) {
    let arm = Arm::simulated().at(START).status_period(Duration::from_millis(20)).start();
    let wire = CommandWire::watch(arm.clock(), arm.command_addr());
    let client = Client::connect_with(&arm.config(), wire.address()).expect("the proxy listens");
    let robot = Robot::new(client, arm.monitor()).expect("it is the only robot");
    let mut robot = robot.configured(&RobotConfig::new().limits(follow::limits())).expect("it is this arm");
    if event == Event::RefusedSetPoint {
        arm.link(Port::Command).to_client().delay(lag);
    }
    let happens = || {
        arm.clock().sleep(after);
        let at = arm.clock().elapsed();
        event.happen(&arm);
        at
    };
    let mut at = Duration::ZERO;
    beside(arm.clock(), || at = happens(), || act(way, &mut robot));
    if event == Event::RefusedSetPoint {
        let refusals = wire.replies().into_iter().filter(|(_, reply)| reply["errorCode"] == "2");
        at = refusals.map(|(at, _)| at).next().expect("one was refused");
    }
    reaction(&wire.requests(), way, at)
}

/// Reaction that requests show, and the time from the news to it.
fn reaction(requests: &[TimedMessage], way: Way, news: Duration) -> (Reaction, Duration) {
    let (before, after): (Vec<_>, Vec<_>) = requests.iter().partition(|(at, _)| *at < news);
    let (mut position, mut step, mut change) = (START[5], 0.0, 0.0);
    let mut step_to = |request: &Value| {
        let joint = request["jointPosition"][5].as_f64().expect("a number");
        let next = if request["relFlag"] == 1 { position + joint } else { joint };
        (next - std::mem::replace(&mut position, next)).abs()
    };
    for (_, request) in before.iter().filter(|(_, request)| request["cmdName"] == "servo_j") {
        let next = step_to(request);
        change = (next - step).abs();
        step = next;
    }
    if way == Way::GuardedRun {
        assert!(before.iter().any(|(_, request)| request["cmdName"] == "joint_move"), "it moves");
    } else {
        assert!(step > 0.3 && change < 1e-4, "it is at speed: {step}, {change}");
    }
    let mut last = None;
    for (at, request) in after {
        let delay = at.saturating_sub(news);
        match request["cmdName"].as_str() {
            Some("stop_program") => return (Reaction::Stops, delay),
            Some("servo_j") if step_to(request) < step - 1e-4 => return (Reaction::Brakes, delay),
            Some("servo_j") => last = Some(delay),
            _ => {}
        }
    }
    let ends = if way == Way::GuardedRun { Reaction::Nothing } else { Reaction::Ends };
    (ends, last.unwrap_or_default())
}

#[test]
fn the_first_request_after_news_brakes_or_stops_the_arm() {
    let mut random = Random::new(31);
    // No set-point goes out at the same microsecond.
    let mut within = |ms| Duration::from_micros((random.below(ms) * 1000 + 1 + random.below(998)).into());
    let mut wrong = Vec::new();
    for event in EVENTS {
        for way in WAYS {
            let Some((expected, cycles)) = event.expected(way) else { continue };
            let mut delays = Vec::new();
            for _ in 0..runs() {
                let (after, lag) = (Duration::from_secs(1) + within(300), within(8));
                let (found, delay) = cell(event, way, after, lag);
                if found != expected || delay > CYCLE * cycles {
                    wrong.push(format!("{event:?} in {way:?} after {after:?}: {found:?} after {delay:?}"));
                }
                delays.push(delay);
            }
            delays.sort();
            let (p50, most) = (delays[delays.len() / 2], delays[delays.len() - 1]);
            println!("{event:?} in {way:?}: {expected:?}, p50 {p50:?}, most {most:?}");
        }
    }
    assert!(wrong.is_empty(), "{} runs:\n{}", wrong.len(), wrong.join("\n"));
}
