//! Stops by each handle of a connection, in each way of moving, for each reaction of the controller, at random moments.
//! By simulated clocks.
//!
//! Witnesses are the requests that the controller received and the joints of its arm; of what the library says, only
//! the cause of the end counts. `JAKA_STOPS=50 cargo test --release -p jaka-tests --test servo stop_matrix::` is the
//! long form.

use std::fmt;
use std::ops::Range;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use jaka_robot::jaka_motion::{Checker, Frames, Limits, Model, Trajectory, Via};
use jaka_robot::motion::JointMove;
use jaka_robot::program::StopProgram;
use jaka_robot::{
    Cause, Client, End, Error, FollowConfig, MotionExt as _, Numbering, Robot, RobotConfig, RobotStop, ServoConfig,
    StopHandle, StreamConfig, jaka_sync,
};
use jaka_sim::{SimulatedClock, State, StopInServo};
use jaka_tests::rig::Random;
use jaka_tests::simulated::beside;
use jaka_tests::{Arm, Configured as _, LONG};
use serde_json::{Value, json};

use crate::follow::START;
use crate::received::requests;

/// Moments of each cell. The long form is `JAKA_STOPS=50`.
fn moments() -> u32 {
    std::env::var("JAKA_STOPS").ok().and_then(|moments| moments.parse().ok()).unwrap_or(1)
}

/// Handle by which a stop is requested.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    RobotStop,
    StopHandle,
    TypedOfClone,
    RawOfClone,
    PipelineOfClone,
    RobotStopNow,
    StopHandleNow,
}

const KINDS: [Kind; 7] = [
    Kind::RobotStop,
    Kind::StopHandle,
    Kind::TypedOfClone,
    Kind::RawOfClone,
    Kind::PipelineOfClone,
    Kind::RobotStopNow,
    Kind::StopHandleNow,
];

impl Kind {
    fn brakes_first(self) -> bool {
        match self {
            Self::RobotStop | Self::StopHandle | Self::TypedOfClone | Self::RawOfClone | Self::PipelineOfClone => true,
            Self::RobotStopNow | Self::StopHandleNow => false,
        }
    }
}

/// Handles of one connection.
struct Handles {
    robot_stop: RobotStop,
    stop: StopHandle,
    clone: Client,
}

impl Handles {
    fn stop(&mut self, kind: Kind) -> Result<(), String> {
        let clone = &mut self.clone;
        let told = |error: jaka_sync::Error| error.to_string();
        match kind {
            Kind::RobotStop => self.robot_stop.stop().map_err(|error| error.to_string()),
            Kind::StopHandle => self.stop.stop().map_err(told),
            Kind::RobotStopNow => self.robot_stop.stop_now().map_err(|error| error.to_string()),
            Kind::StopHandleNow => self.stop.stop_now().map_err(told),
            Kind::TypedOfClone => clone.call(&StopProgram::new()).map_err(told),
            Kind::RawOfClone => clone.call_raw("stop_program", &json!({})).map(drop).map_err(told),
            Kind::PipelineOfClone => {
                let mut pipeline = clone.pipeline(8);
                pipeline.send(&StopProgram::new()).and_then(|()| pipeline.finish()).map(drop).map_err(told)
            }
        }
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Way {
    Run,
    GuardedRun,
    SessionOffsets,
    SessionJoints,
    Stream,
    Trajectory,
    Approach,
}

const LAGS: [Duration; 3] = [Duration::ZERO, Duration::from_millis(54), Duration::from_millis(100)];

/// Speed of joint 6, which alone moves, in deg/s: behind by 4 deg at the longest lag, and no departure.
const SPEED: f64 = 40.0;
/// Travel of joint 6 if nothing stops it, in degrees. It is under way for 4 s.
const TRAVEL: f64 = 160.0;
const PERIOD: f64 = 0.032;
/// First and last moment of a stop after the arm has begun to move, in seconds. It is not slowing down by then.
const MOMENTS: [f64; 2] = [0.05, 2.2];
/// Longest time from the call of a stop to the stop on the wire: 3 s for the braking.
const ON_WIRE: Duration = Duration::from_millis(3200);
/// Time in which each arm comes to rest, at each lag.
const TO_REST: Duration = Duration::from_secs(2);

/// Difference of positions that are the same, in degrees.
const SAME: f64 = 1e-6;
/// Tolerance of the growth of a step, in degrees: 0.6 deg/s.
const GROWTH: f64 = 0.02;
/// Longest step with which a braking ends, in degrees: with the jerk of stops, 5700 deg/s³, it has no more left for its
/// last period.
const LAST_STEP: f64 = 5700.0 * PERIOD * PERIOD * PERIOD / 6.0;
/// Travel in 100 ms below which the arm rests, in degrees: 0.5 deg/s.
const AT_REST: f64 = 0.05;
/// Greatest change of the answers that show rest, in degrees: 0.5 deg/s over 200 ms.
const ANSWERS_AT_REST: f64 = 0.1;
/// Acceleration of joint 6, with which the controller stops it, in deg/s².
const ACCELERATION: f64 = 70.0;

fn limits() -> Limits {
    Limits::of(Model::named("Zu 5").expect("a published arm"))
}

fn servo() -> ServoConfig {
    ServoConfig::new().step_count(4)
}

fn at(joint_6: f64) -> [f64; 6] {
    let mut joints = START;
    joints[5] += joint_6;
    joints
}

fn by(joint_6: f64) -> [f64; 6] {
    [0.0, 0.0, 0.0, 0.0, 0.0, joint_6]
}

/// Step of a session's set-points: 68 deg/s² up to the speed.
fn step(cycle: u32) -> f64 {
    (f64::from(cycle) * 0.07).min(SPEED * PERIOD)
}

fn turn() -> JointMove {
    JointMove::relative(by(-3.0), 20.0).acceleration(ACCELERATION)
}

impl Way {
    fn is_planned(self) -> bool {
        matches!(self, Self::Run | Self::GuardedRun)
    }

    /// Moves joint 6 until something ends that.
    fn act(self, robot: &mut Robot, arm: &Arm) -> Result<End, Error> {
        let motion = JointMove::relative(by(TRAVEL), SPEED).acceleration(ACCELERATION);
        match self {
            Self::Run => robot.run(&motion, LONG),
            Self::GuardedRun => robot.run(&motion.guard(Numbering::FromOne.cabinet(3).is_high()), LONG),
            Self::SessionOffsets => {
                let mut session = robot.enter_servo_mode(servo())?;
                (1..125).try_for_each(|cycle| session.send_joint_offset(by(step(cycle))))?;
                session.land()
            }
            Self::SessionJoints => {
                let mut session = robot.enter_servo_mode(servo())?;
                let mut joint_6 = 0.0;
                (1..125).try_for_each(|cycle| {
                    joint_6 += step(cycle);
                    session.send_joints(at(joint_6))
                })?;
                session.land()
            }
            Self::Stream => {
                let stream = robot.stream(&StreamConfig::new().servo(servo()))?;
                for _ in 0..40 {
                    // Fails once the stream lands, and `land` says why.
                    if stream.handle().set_joint_velocity(by(SPEED), Duration::from_millis(300)).is_err() {
                        break;
                    }
                    arm.clock().sleep(Duration::from_millis(100));
                }
                stream.land()
            }
            Self::Trajectory => {
                // Straight, so that braking along it slows down each joint.
                let config = FollowConfig::new().servo(servo());
                Ok(robot.start_follow(&straight(START, at(TRAVEL)), &config)?.wait())
            }
            Self::Approach => {
                let config = FollowConfig::new().servo(servo()).approach(SPEED);
                Ok(robot.start_follow(&straight(at(TRAVEL), at(TRAVEL + 5.0)), &config)?.wait())
            }
        }
    }
}

fn straight(from: [f64; 6], to: [f64; 6]) -> Trajectory {
    let checker = Checker::new(limits(), Frames::new());
    let points = [Via::joints(from), Via::joints(to)];
    Trajectory::through(points).joint_speeds([SPEED; 6]).build(&checker).expect("within the limits")
}

#[derive(Debug, Clone, Copy)]
struct Cell {
    kind: Kind,
    way: Way,
    answer: StopInServo,
    lag: Duration,
    seed: u32,
}

impl fmt::Display for Cell {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { kind, way, answer, lag, seed } = self;
        write!(f, "{kind:?} in {way:?}, {answer}, lag {lag:?}, seed {seed}")
    }
}

/// Place of the arm at a time, in seconds.
#[derive(Debug, Clone, Copy)]
struct Place {
    time_s: f64,
    joints: [f64; 6],
}

/// Places of the arm in each cycle in which something moves.
#[derive(Debug, Clone, Default)]
struct Places(Arc<Mutex<Vec<Place>>>);

impl Places {
    fn of(arm: &Arm) -> Self {
        let places = Self::default();
        let (theirs, clock) = (places.clone(), arm.clock().clone());
        let see = move |state: &State| {
            let place = Place { time_s: clock.elapsed().as_secs_f64(), joints: state.joint_position.0 };
            theirs.0.lock().unwrap_or_else(PoisonError::into_inner).push(place);
            false
        };
        arm.when(see, |_| ()).expect("a thread starts");
        places
    }

    /// Places from the last one before a time on.
    fn since(&self, time_s: f64) -> Vec<Place> {
        let places = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let first = places.partition_point(|place| place.time_s < time_s).saturating_sub(1);
        places[first..].to_vec()
    }

    /// Travel of the joint that turned furthest in the last 100 ms.
    fn latest_travel(&self, clock: &SimulatedClock) -> f64 {
        let places = self.since(clock.elapsed().as_secs_f64() - 0.1);
        let [Some(first), Some(last)] = [places.first(), places.last()] else { return 0.0 };
        furthest(&first.joints, &last.joints)
    }

    /// Greatest speed of a joint since a time, from cycle to cycle.
    fn greatest_speed(&self, since: Duration) -> f64 {
        let places = self.since(since.as_secs_f64());
        let speeds = places.windows(2).map(|two| {
            let time_s = two[1].time_s - two[0].time_s;
            // Changes of the state are seen within a cycle, too.
            if time_s > 0.0079 { furthest(&two[0].joints, &two[1].joints) / time_s } else { 0.0 }
        });
        speeds.fold(0.0, f64::max)
    }
}

fn furthest(from: &[f64; 6], to: &[f64; 6]) -> f64 {
    from.iter().zip(to).map(|(from, to)| (to - from).abs()).fold(0.0, f64::max)
}

/// Travel in the last 100 ms before three answers have shown rest, which only the lag has left, in degrees. Answers are
/// commanded positions: at the first one these still brake, unseen. An arm that lags is behind by this at their end,
/// and the rest shrinks exponentially.
fn lags_behind(lag: Duration) -> f64 {
    let lag_s = lag.as_secs_f64();
    let behind = ACCELERATION * lag_s * lag_s;
    let unseen_s = f64::sqrt(2.0 * ANSWERS_AT_REST / ACCELERATION);
    behind * (f64::exp((unseen_s - 0.1) / lag_s) - f64::exp((unseen_s - 0.2) / lag_s))
}

/// Call of a stop.
#[derive(Debug)]
struct Stopping {
    time: Duration,
    /// Number of requests that the controller had received.
    requests: usize,
    result: Result<(), String>,
    /// Time at which the stop was on the wire.
    on_wire: Option<Duration>,
}

fn is(request: &Value, command: &str) -> bool {
    request["cmdName"] == command
}

fn moves(request: &Value) -> bool {
    let is_entry = is(request, "servo_move") && request["relFlag"] == 1;
    is_entry || ["joint_move", "servo_j", "servo_p"].iter().any(|command| is(request, command))
}

/// Steps of the set-points among some requests, absolute ones and offsets alike, with the numbers of their requests.
fn steps(requests: &[Value]) -> Vec<(usize, [f64; 6])> {
    let mut last = START;
    let set_points = requests.iter().enumerate().filter(|(_, request)| is(request, "servo_j"));
    let step = set_points.map(|(number, request)| {
        let from = if request["relFlag"] == 1 { last } else { [0.0; 6] };
        let joint = |joint: usize| from[joint] + request["jointPosition"][joint].as_f64().expect("a number");
        let to = std::array::from_fn(joint);
        let step = std::array::from_fn(|joint| to[joint] - last[joint]);
        last = to;
        (number, step)
    });
    step.collect()
}

/// Set-points from the call of a stop on, `after` being those after `stop_program`.
///
/// The first set-point after the call begins to brake. Its step is longer than the last one before the call at most by
/// as much as that one was longer than its predecessor: within its period the acceleration ends, and a step is a mean
/// speed. Each later step is shorter than the one before it, none goes back, no other joint turns, and the last one
/// before `stop_program` is none or ends the braking. After `stop_program` no step is left: a set-point can only hold
/// the arm in the same place.
fn judge_set_points(before: &[[f64; 6]], braking: &[[f64; 6]], after: &[[f64; 6]]) -> Vec<String> {
    let mut found = Vec::new();
    let speed = |step: f64| format!("{:.2} deg/s", step / PERIOD);
    let mut last = before.last().map_or(0.0, |step| step[5]);
    let gain = before.len().checked_sub(2).map_or(0.0, |number| (last - before[number][5]).max(0.0));
    for (number, step) in braking.iter().map(|step| step[5]).enumerate() {
        let is_faster = number == 0 && step - last > gain + GROWTH;
        let is_as_fast = number > 0 && step > SAME && step >= last;
        if is_faster || is_as_fast || step < -SAME {
            found.push(format!("set-point {number} after the call goes at {}, after {}", speed(step), speed(last)));
            break;
        }
        last = step;
    }
    if braking.iter().chain(after).any(|step| step[..5].iter().any(|step| step.abs() > SAME)) {
        found.push("set-points after the call turn another joint".to_owned());
    }
    let last = braking.last().map_or(last, |step| step[5]);
    if last.abs() > LAST_STEP + SAME {
        let count = braking.len();
        found.push(format!("`stop_program` goes out at {}, after {count} set-points", speed(last)));
    }
    let going_on: Vec<_> = after.iter().map(|step| step[5]).filter(|step| step.abs() > SAME).collect();
    if let Some(first) = going_on.first() {
        let (count, first) = (going_on.len(), speed(*first));
        found.push(format!("{count} set-points after `stop_program` move the arm, the first at {first}"));
    }
    found
}

/// One arm, one stop of it, and what follows.
struct Run {
    robot: Robot,
    bystander: Client,
    arm: Arm,
    places: Places,
    /// Travel in 100 ms below which the arm rests, in degrees.
    at_rest: f64,
    found: Vec<String>,
}

impl Run {
    fn new(cell: &Cell) -> (Self, Handles) {
        let arm = Arm::simulated().at(START).status_period(Duration::from_millis(30));
        let (arm, robot) = arm.controller(|arm| arm.lag(cell.lag).stop_in_servo(cell.answer)).with_robot();
        let mut robot = robot.configured(&RobotConfig::new().limits(limits())).expect("it is this arm");
        let robot_stop = robot.stop_handle();
        let mut clone = || robot.client().try_clone().expect("the connection is there");
        let (bystander, clone) = (clone(), clone());
        let handles = Handles { robot_stop, stop: clone.stop_handle(), clone };
        let at_rest = AT_REST + lags_behind(cell.lag);
        (Self { places: Places::of(&arm), arm, robot, bystander, at_rest, found: Vec::new() }, handles)
    }

    fn find(&mut self, what: impl Into<String>) {
        self.found.push(what.into());
    }

    /// Moves the arm, and stops it at this time after it has begun to move.
    fn stop(&mut self, cell: &Cell, after: Duration, mut handles: Handles) {
        let (arm, mut stopping) = (&self.arm, None);
        let stops = || {
            let clock = arm.clock();
            // An arm that does not move within a second is not moved at all, and the end says why.
            let trigger = arm.when(|state| !state.at_rest, |_| ()).expect("a thread starts");
            trigger.wait(Duration::from_secs(1));
            clock.sleep(after);
            let (time, before) = (clock.elapsed(), arm.requests().len());
            let result = handles.stop(cell.kind);
            let is_on_wire = || requests(arm)[before..].iter().any(|request| is(request, "stop_program"));
            while !is_on_wire() && clock.elapsed() <= time + ON_WIRE {
                clock.sleep(Duration::from_millis(8));
            }
            let on_wire = is_on_wire().then(|| clock.elapsed());
            stopping = Some(Stopping { time, requests: before, result, on_wire });
        };
        let robot = &mut self.robot;
        let ended = beside(arm.clock(), stops, || cell.way.act(robot, arm));
        let stopping = stopping.expect("the stop was called");
        let (cause, text) = match &ended {
            Ok(end) => (end.cause(), end.to_string()),
            Err(error) => (error.cause(), error.to_string()),
        };
        if cause != Cause::Stopped {
            self.find(format!("the cause is {cause:?}: {text}"));
        }
        self.judge(cell, &stopping);
    }

    /// Judges the requests and the joints up to the end of the way of moving.
    fn judge(&mut self, cell: &Cell, stop: &Stopping) {
        if let Err(error) = &stop.result {
            self.find(format!("the stop fails: {error}"));
        }
        if stop.on_wire.is_none_or(|time| time > stop.time + ON_WIRE) {
            self.find(format!("`stop_program` is not on the wire within {ON_WIRE:?}"));
        }
        let requests = requests(&self.arm);
        let sent = requests[stop.requests..].iter().position(|request| is(request, "stop_program"));
        let sent = sent.map_or(requests.len(), |sent| stop.requests + sent);
        let steps = steps(&requests);
        let among = |numbers: Range<usize>| -> Vec<[f64; 6]> {
            steps.iter().filter(|(number, _)| numbers.contains(number)).map(|(_, step)| *step).collect()
        };
        let before = among(0..stop.requests);
        let [braking, after] = [stop.requests..sent, sent..requests.len()].map(among);
        if cell.way.is_planned() {
            if !steps.is_empty() {
                self.find("set-points of a planned motion");
            }
        } else if cell.kind.brakes_first() {
            self.found.extend(judge_set_points(&before, &braking, &after));
        } else if !braking.is_empty() || !after.is_empty() {
            self.find("set-points after a stop that goes out at once");
        }
        // An arm that lags is no faster than its set-points were, and a discarded queue makes none jump.
        let fastest = before.iter().map(|step| step[5] / PERIOD).fold(0.0, f64::max);
        let most = if cell.way.is_planned() { SPEED } else { fastest };
        let is = self.places.greatest_speed(stop.time);
        if is > most + 2.0 {
            self.find(format!("the arm turns at {is:.1} deg/s after the stop, and at {most:.1} deg/s before"));
        }
    }

    /// Nothing that moves the arm goes out.
    fn assert_refused(&mut self, when: &str) {
        let before = self.arm.requests().len();
        let went_out = [
            ("a motion", self.robot.start(&turn()).is_ok()),
            ("an entry into servo mode", self.robot.enter_servo_mode(servo()).is_ok()),
            ("a clone's motion", self.bystander.call(&turn()).is_ok()),
        ];
        for (what, _) in went_out.iter().filter(|(_, is_ok)| *is_ok) {
            self.find(format!("{what} is accepted {when}"));
        }
        let sent = requests(&self.arm)[before..].iter().filter(|request| moves(request)).count();
        if sent > 0 {
            self.find(format!("{sent} requests that move the arm are on the wire {when}"));
        }
    }

    /// Acknowledges the stop and starts a motion, which goes out at rest alone.
    fn go_on(&mut self, who: Who) -> Result<(), String> {
        self.robot.acknowledge();
        let before = self.arm.requests().len();
        let started = match who {
            Who::Robot => self.robot.start(&turn()).map_err(|error| error.to_string()),
            Who::Clone => self.bystander.call(&turn()).map_err(|error| error.to_string()),
        };
        let travel = self.places.latest_travel(self.arm.clock());
        let is_sent = requests(&self.arm)[before..].iter().any(moves);
        if is_sent && travel > self.at_rest {
            self.find(format!(
                "{who:?}: a motion after `acknowledge` goes out while the arm turns {travel:.2} deg in 100 ms"
            ));
        }
        if is_sent != started.is_ok() {
            self.find(format!("{who:?}: a motion after `acknowledge`: sent: {is_sent}, {started:?}"));
        }
        started
    }
}

/// Handle that moves the arm after a stop.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Who {
    Robot,
    Clone,
}

/// Time of the acknowledgement.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Acknowledged {
    /// At the end of the way of moving, when the arm may still turn. A motion waits for rest, or is refused.
    AtOnce(Who),
    AtRest,
}

/// Violations in a cell.
fn violations(cell: &Cell) -> Vec<String> {
    let mut random = Random::new(cell.seed);
    let after = Duration::from_secs_f64(random.between(MOMENTS[0], MOMENTS[1]));
    let acknowledged = match random.below(4) {
        // An error of the controller is cleared at rest.
        _ if cell.answer == StopInServo::Fault => Acknowledged::AtRest,
        0 => Acknowledged::AtOnce(Who::Robot),
        1 => Acknowledged::AtOnce(Who::Clone),
        _ => Acknowledged::AtRest,
    };
    let (mut run, handles) = Run::new(cell);
    run.stop(cell, after, handles);
    run.assert_refused("before `acknowledge`");
    if let Acknowledged::AtOnce(who) = acknowledged
        && run.go_on(who).is_ok()
        && who == Who::Robot
    {
        drop(run.robot.wait(LONG));
    }
    run.arm.clock().sleep(TO_REST);
    let travel = run.places.latest_travel(run.arm.clock());
    if travel > AT_REST {
        run.find(format!("the arm still turns: {travel:.2} deg in 100 ms"));
    }
    if acknowledged == Acknowledged::AtRest {
        run.assert_refused("at rest, before `acknowledge`");
    }
    if cell.answer == StopInServo::Fault {
        run.bystander.clear_error().unwrap_or_else(|error| panic!("{cell}: {error}"));
        run.arm.clock().sleep(Duration::from_millis(100));
    }
    if let Err(error) = run.go_on(Who::Robot) {
        run.find(format!("no motion goes out after `acknowledge` and rest: {error}"));
    }
    run.found.into_iter().map(|found| format!("{cell}, {after:?} after the arm has begun to move: {found}")).collect()
}

fn assert_stops_hold(way: Way) {
    let mut cells = Vec::new();
    for _ in 0..moments() {
        for kind in KINDS {
            for answer in StopInServo::ALL {
                for lag in LAGS {
                    // Each has a moment of its own.
                    let seed = u32::try_from(cells.len()).expect("fewer");
                    cells.push(Cell { kind, way, answer, lag, seed });
                }
            }
        }
    }
    let found: Vec<_> = cells.iter().map(violations).filter(|found| !found.is_empty()).collect();
    let (wrong, all) = (found.len(), cells.len());
    assert!(found.is_empty(), "{wrong} of {all} cells:\n{}", found.concat().join("\n"));
}

#[test]
fn a_stop_of_a_motion_holds() {
    assert_stops_hold(Way::Run);
}

#[test]
fn a_stop_of_a_motion_under_a_guard_holds() {
    assert_stops_hold(Way::GuardedRun);
}

#[test]
fn a_stop_of_a_session_of_offsets_holds() {
    assert_stops_hold(Way::SessionOffsets);
}

#[test]
fn a_stop_of_a_session_of_joint_positions_holds() {
    assert_stops_hold(Way::SessionJoints);
}

#[test]
fn a_stop_of_a_stream_holds() {
    assert_stops_hold(Way::Stream);
}

#[test]
fn a_stop_of_a_trajectory_holds() {
    assert_stops_hold(Way::Trajectory);
}

#[test]
fn a_stop_of_an_approach_holds() {
    assert_stops_hold(Way::Approach);
}

#[test]
fn set_points_that_do_not_brake_or_move_the_arm_after_the_stop_are_noticed() {
    let judge = |before: &[f64], braking: &[f64], after: &[f64]| {
        let [before, braking, after] =
            [before, braking, after].map(|steps| steps.iter().copied().map(by).collect::<Vec<_>>());
        judge_set_points(&before, &braking, &after).len()
    };
    let fast = [1.0, 1.0];
    let brakes = [0.9, 0.5, 0.1, 0.0, 0.0];
    assert_eq!(judge(&fast, &brakes, &[0.0, 0.0]), 0);
    // It was gaining speed.
    assert_eq!(judge(&[0.9, 1.0], &[1.1, 0.5, 0.0], &[]), 0);
    assert_eq!(judge(&[0.9, 1.0], &[1.15, 0.5, 0.0], &[]), 1);
    let wrong: [(&[f64], &[f64]); 7] = [
        (&[1.1, 0.5, 0.0], &[]),
        (&[1.0, 1.0, 0.5, 0.0], &[]),
        (&[0.9, 0.5, 0.6, 0.0], &[]),
        (&[0.9, 0.1, 0.0, -0.1, 0.0], &[]),
        (&[0.9, 0.5], &[]),
        (&[], &[]),
        (&brakes, &[0.0, 0.1]),
    ];
    for (braking, after) in wrong {
        assert_eq!(judge(&fast, braking, after), 1, "{braking:?}, {after:?}");
    }
    let other = [[0.1, 0.0, 0.0, 0.0, 0.0, 0.0]];
    assert_eq!(judge_set_points(&[], &other, &[]).len(), 1);
    let offset = |by: [f64; 6]| json!({"cmdName": "servo_j", "relFlag": 1, "jointPosition": by});
    let place = |to: [f64; 6]| json!({"cmdName": "servo_j", "relFlag": 0, "jointPosition": to});
    let steps: Vec<_> = steps(&[offset(by(1.0)), json!({"cmdName": "stop_program"}), place(at(1.5)), offset(by(0.25))])
        .into_iter()
        .map(|(number, step)| (number, step[5].to_string()))
        .collect();
    assert_eq!(steps, [(0, "1".to_owned()), (2, "0.5".to_owned()), (3, "0.25".to_owned())]);
}
