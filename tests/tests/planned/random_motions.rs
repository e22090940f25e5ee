//! Random motions of all kinds, with stalls and delays of the links, the habits of real controllers, stops from three
//! threads and by others: `Reached` only where the arm is at its target and at rest; what an error says has not run
//! does not run; and after a servo session has ended, no joint moves by more than the set-points that were not
//! answered.
//!
//! The arm is the witness: the simulator says where it is. 200 motions, or as many as `JAKA_MOTIONS` says.

use std::thread;
use std::time::Duration;

use jaka_robot::jaka_sync::ErrorKind as Failure;
use jaka_robot::motion::{EndMove, JointMove, LineMode, MoveC, MoveL};
use jaka_robot::types::{JointPosition, MoveMode, Pose};
use jaka_robot::{
    Cause, Command, Error, ErrorKind, Robot, RobotConfig, RobotStop, ServoConfig, ServoSession, SessionConfig,
    StopHandle,
};
use jaka_sim::{Delays, Habit, Port, State};
use jaka_tests::simulated::{beside, until};
use jaka_tests::{Arm, Configured as _, failure};
use proptest::prelude::RngCore;
use proptest::test_runner::{RngAlgorithm, TestRng};

/// Number of arms, each with habits of its own.
const RIGS: u32 = 20;

/// Longer than any motion, with what goes wrong.
const LONG: Duration = Duration::from_secs(20);

/// The most that a joint may move in a set-point of this test, in degrees.
const STEP: f64 = 0.12;

/// Largest distance of the arm from a reached target, in degrees and in millimetres.
const CLOSE: (f64, f64) = (0.1, 0.5);

struct Random(TestRng);

impl Random {
    fn new(seed: u32) -> Self {
        let mut bytes = [0; 32];
        bytes[..4].copy_from_slice(&seed.to_le_bytes());
        Self(TestRng::from_seed(RngAlgorithm::ChaCha, &bytes))
    }

    fn below(&mut self, limit: u32) -> u32 {
        self.0.next_u32() % limit
    }

    fn one_in(&mut self, times: u32) -> bool {
        self.below(times) == 0
    }

    /// From `-most` to `most`.
    fn offset(&mut self, most: f64) -> f64 {
        (f64::from(self.below(2001)) / 1000.0 - 1.0) * most
    }

    fn time(&mut self, from_ms: u32, to_ms: u32) -> Duration {
        Duration::from_millis((from_ms + self.below(to_ms - from_ms)).into())
    }
}

/// A simulated arm with habits, and the robot that moves it.
struct Rig {
    arm: Arm,
    robot: Robot,
    random: Random,
    tally: Tally,
}

/// Number of motions and sessions with each outcome: a test without events proves nothing.
#[derive(Debug, Default, Clone, Copy)]
struct Tally {
    reached: u32,
    at_rest: u32,
    stopped: u32,
    refused: u32,
    sessions: u32,
    sessions_ended: u32,
}

impl Tally {
    fn add(self, other: Self) -> Self {
        Self {
            reached: self.reached + other.reached,
            at_rest: self.at_rest + other.at_rest,
            stopped: self.stopped + other.stopped,
            refused: self.refused + other.refused,
            sessions: self.sessions + other.sessions,
            sessions_ended: self.sessions_ended + other.sessions_ended,
        }
    }
}

fn connect(arm: &Arm) -> Robot {
    arm.robot().configured(&RobotConfig::new().start_grace(Duration::from_millis(300), 3)).expect("it has no limits")
}

impl Rig {
    fn new(seed: u32) -> Self {
        let mut random = Random::new(seed);
        let mut habits = Habit::one_of_each();
        habits.retain(|_| random.one_in(2));
        let delays = if random.one_in(2) { in_position_late() } else { Delays::NONE };
        let period = random.time(10, 60);
        let habits = habits.into_iter().collect::<jaka_sim::Habits>();
        let arm = Arm::simulated().controller(|controller| controller.delays(delays).habits(habits));
        let patience = Duration::from_secs(2);
        let arm =
            arm.status_period(period).config(|config| config.stale_after(patience).reply_timeout(patience)).start();
        let robot = connect(&arm);
        Self { arm, robot, random, tally: Tally::default() }
    }

    fn state(&self) -> State {
        self.arm.state()
    }

    /// Links as they should be, the arm at rest, and a robot that may move it.
    fn settle(&mut self) {
        self.arm.links().release();
        until(self.arm.clock(), || self.arm.state().at_rest);
        if self.robot.client().disconnect_cause().is_some() || self.robot.monitor().disconnect_cause().is_some() {
            self.robot = connect(&self.arm);
        }
        self.robot.acknowledge();
        self.robot.monitor().next_packet().expect("packets come");
        // A motion that has not been waited for has ended by now.
        let _ = self.robot.wait(Duration::ZERO);
        self.robot.acknowledge();
    }
}

fn in_position_late() -> Delays {
    let mut delays = Delays::NONE;
    delays.in_position = Delays::REAL.in_position;
    delays
}

/// Something that goes wrong with the links while a motion runs, for the whole of it or a part.
#[derive(Debug, Clone, Copy)]
enum Trouble {
    None,
    Held { port: Port, after: Duration, time: Duration },
    Delayed(Duration),
}

impl Trouble {
    fn any(random: &mut Random) -> Self {
        match random.below(6) {
            0 | 1 => Self::None,
            2 => Self::Delayed(random.time(50, 900)),
            3 => Self::Held { port: Port::Command, after: random.time(0, 400), time: random.time(50, 500) },
            _ => Self::Held { port: Port::Status, after: random.time(0, 400), time: random.time(50, 1200) },
        }
    }

    /// Applies a delay before the motion begins, so that older packets come after it.
    fn strike(self, arm: &Arm) {
        if let Self::Delayed(time) = self {
            arm.link(Port::Status).to_client().delay(time);
            arm.clock().sleep(time + Duration::from_millis(60));
        }
    }

    fn run(self, arm: &Arm) {
        if let Self::Held { port, after, time } = self {
            arm.clock().sleep(after);
            arm.link(port).hold();
            arm.clock().sleep(time);
            arm.link(port).release();
        }
    }
}

/// Origin of a stop, and its time after the start.
#[derive(Debug, Clone, Copy)]
enum Stop {
    Own(Duration),
    /// By a handle of which the robot knows nothing, as another program would.
    Foreign(Duration),
}

fn any_stops(random: &mut Random) -> Vec<Stop> {
    if !random.one_in(3) {
        return Vec::new();
    }
    if random.one_in(3) {
        return vec![Stop::Foreign(random.time(0, 600))];
    }
    (0..=random.below(3)).map(|_| Stop::Own(random.time(0, 600))).collect()
}

impl Stop {
    fn run(self, arm: &Arm, own: &RobotStop, foreign: &StopHandle) {
        // Where the link is held, a stop may come too late or not at all: the outcome must still be true.
        match self {
            Self::Own(after) => {
                arm.clock().sleep(after);
                drop(own.stop());
            }
            Self::Foreign(after) => {
                arm.clock().sleep(after);
                drop(foreign.stop());
            }
        }
    }
}

/// A motion, and where the arm is when it has ended as it should, if that is known.
#[derive(Debug, Clone, Copy)]
enum Move {
    Joint(JointMove),
    Line(MoveL),
    Arc(MoveC),
    End(EndMove),
}

#[derive(Debug, Clone, Copy)]
enum End {
    Joints(JointPosition),
    Pose(Pose),
    /// The request does not tell it: `Reached` would be a guess.
    Unknown,
}

fn any_move(random: &mut Random, state: &State, is_alone: bool) -> (Move, End) {
    let at = state.tcp_pose;
    // Some are short and slow: an arm that hardly moves is not at rest.
    let scale = if is_alone && random.one_in(5) { 0.05 } else { 1.0 };
    let by = [random.offset(12.0) * scale, random.offset(12.0) * scale, random.offset(12.0) * scale];
    let there = Pose { x: at.x + by[0], y: at.y + by[1], z: at.z + by[2], ..at };
    let speed = scale * (20.0 + f64::from(random.below(80)));
    let joint_speed = scale * (10.0 + f64::from(random.below(60)));
    let tolerance = if random.one_in(4) { 4.0 } else { 0.0 };
    let line = |mode, pose| MoveL::new(mode, pose, speed).acceleration(800.0).tolerance(tolerance);
    let joint = |mode, joints: [f64; 6]| JointMove::new(mode, joints, joint_speed).acceleration(400.0);
    let zero = random.one_in(8);
    let turn: [f64; 6] = std::array::from_fn(|_| if zero { 0.0 } else { random.offset(4.0) * scale });
    let joints: [f64; 6] = std::array::from_fn(|i| state.joint_position.0[i] + turn[i]);
    let relative = |end: End| if is_alone { end } else { End::Unknown };
    match random.below(if is_alone { 8 } else { 5 }) {
        0 | 1 => (Move::Joint(joint(MoveMode::Absolute, joints)), End::Joints(joints.into())),
        2 => (Move::Line(line(LineMode::Absolute, there)), End::Pose(there)),
        3 => (Move::Joint(joint(MoveMode::Relative, turn)), relative(End::Joints(joints.into()))),
        4 => {
            let offset = Pose { x: by[0], y: by[1], z: by[2], rx: 0.0, ry: 0.0, rz: 0.0 };
            (Move::Line(line(LineMode::Relative, offset)), relative(End::Pose(there)))
        }
        5 => {
            let turned = Pose { x: by[0], y: by[1], z: by[2], rx: 0.0, ry: 0.0, rz: 2.0 };
            (Move::Line(line(LineMode::Relative, turned)), End::Unknown)
        }
        6 => {
            let mid_pose =
                Pose { x: at.x + by[0] / 2.0 + 4.0, y: at.y + by[1] / 2.0 - 3.0, z: at.z + by[2] / 2.0 + 4.0, ..at };
            let arc = MoveC::absolute(mid_pose, there, speed / scale, 800.0, tolerance);
            (Move::Arc(arc), End::Pose(there))
        }
        _ => {
            let end = EndMove::new(there, joint_speed).acceleration(400.0);
            (Move::End(end), End::Pose(there))
        }
    }
}

fn start(robot: &mut Robot, motion: &Move) -> Result<(), Error> {
    match motion {
        Move::Joint(motion) => robot.start(motion),
        Move::Line(motion) => robot.start(motion),
        Move::Arc(motion) => robot.start(motion),
        Move::End(motion) => robot.start(motion),
    }
}

fn is_there(state: &State, end: &End) -> bool {
    match end {
        End::Joints(joints) => state.joint_position.max_distance(joints) <= CLOSE.0,
        End::Unknown => false,
        End::Pose(pose) => state.tcp_pose.distance_mm(pose) <= CLOSE.1 && state.tcp_pose.angle_deg(pose) <= CLOSE.0,
    }
}

/// One motion or several in a queue, waited for while things go wrong.
fn one_batch(rig: &mut Rig, number: u32) {
    let count = if rig.random.one_in(3) { 2 + rig.random.below(2) } else { 1 };
    let state = rig.state();
    let mut batch: Vec<_> = (0..count).map(|_| any_move(&mut rig.random, &state, count == 1)).collect();
    if count > 1 && rig.random.one_in(3) {
        // Out and back.
        let home = JointMove::absolute(state.joint_position, 40.0).acceleration(400.0);
        batch.push((Move::Joint(home), End::Joints(state.joint_position)));
    }
    let (trouble, stops) = (Trouble::any(&mut rig.random), any_stops(&mut rig.random));
    let what = format!("seed {number}: {batch:?} with {trouble:?} and {stops:?}, by {:?}", *rig.arm);
    trouble.strike(&rig.arm);
    let (own, foreign) = (rig.robot.stop_handle(), rig.robot.client().stop_handle());
    let before = motions(&rig.arm);
    let Rig { arm, robot, .. } = rig;
    let run = || {
        let started: Vec<_> = batch.iter().map(|(motion, _)| start(robot, motion)).take_while_ok();
        let end = robot.wait(LONG);
        if end.cause() == Cause::Reached && started.iter().all(Result::is_ok) {
            check_reached(&arm.state(), batch.last().map(|(_, end)| end), &what);
        }
        (started, end)
    };
    let (started, end) = beside(arm.clock(), || trouble.run(arm), || stopped_by(&stops, arm, (&own, &foreign), run));
    check_end(&end, !stops.is_empty(), &what);
    rig.tally.reached += u32::from(end.cause() == Cause::Reached);
    rig.tally.at_rest += u32::from(end.cause() == Cause::AtRest);
    rig.tally.stopped += u32::from(end.cause() == Cause::Stopped);
    rig.settle();
    check_sent(rig, &started, before, &what);
}

/// Runs something while each of these stops the arm, in a thread of its own.
fn stopped_by<T>(stops: &[Stop], arm: &Arm, (own, foreign): (&RobotStop, &StopHandle), run: impl FnOnce() -> T) -> T {
    match stops {
        [] => run(),
        [stop, others @ ..] => {
            let run_beside_others = || stopped_by(others, arm, (own, foreign), run);
            beside(arm.clock(), || stop.run(arm, own, foreign), run_beside_others)
        }
    }
}

/// Results up to the first error, and that one.
trait TakeWhileOk {
    fn take_while_ok(self) -> Vec<Result<(), Error>>;
}

impl<I: Iterator<Item = Result<(), Error>>> TakeWhileOk for I {
    fn take_while_ok(mut self) -> Vec<Result<(), Error>> {
        let mut results = Vec::new();
        while results.last().is_none_or(Result::is_ok) {
            let Some(next) = self.next() else { break };
            results.push(next);
        }
        results
    }
}

/// Number of motions that the controller has received.
fn motions(arm: &Arm) -> usize {
    let names = [JointMove::INFO.name, MoveL::INFO.name, MoveC::INFO.name, EndMove::INFO.name];
    let is_motion = |request: &&String| names.iter().any(|name| request.contains(&format!("\"cmdName\":\"{name}\"")));
    arm.requests().iter().filter(is_motion).count()
}

/// Checks that no motion was sent that its error excludes, also after the links have released their held bytes.
fn check_sent(rig: &mut Rig, started: &[Result<(), Error>], before: usize, what: &str) {
    let accepted = started.iter().filter(|result| result.is_ok()).count();
    let failed = started.last().and_then(|result| result.as_ref().err());
    let (mut least, mut most) = (accepted, accepted);
    if let Some(error) = failed {
        let allowed = matches!(error.kind(), ErrorKind::NotAcknowledged { .. } | ErrorKind::StatusUnknown { .. })
            || error.is_disconnected()
            || matches!(failure(error), Some(Failure::Timeout { .. }));
        assert!(allowed || error.is_refused(), "{what}: {error:?}");
        rig.tally.refused += 1;
        most += usize::from(error.may_have_run() || error.is_refused());
        least += usize::from(error.is_refused());
    }
    let sent = motions(&rig.arm) - before;
    assert!((least..=most).contains(&sent), "{what}: {sent} motions came, of {started:?}");
}

fn check_reached(state: &State, end: Option<&End>, what: &str) {
    let end = end.expect("there is a motion");
    assert!(state.at_rest, "{what}: it moves at {:?}", state.joint_position);
    assert!(is_there(state, end), "{what}: it is at {:?}, {:?}", state.joint_position, state.tcp_pose);
}

fn check_end(end: &jaka_robot::End, was_stopped: bool, what: &str) {
    match end.cause() {
        Cause::Reached | Cause::AtRest | Cause::NoMotion | Cause::StatusLost | Cause::Deadline => {}
        Cause::Stopped => assert!(was_stopped, "{what}: nobody has stopped it"),
        other => panic!("{what}: {other:?}"),
    }
}

/// A servo session that a stalled link ends, or that goes to its end.
fn one_session(rig: &mut Rig, number: u32) {
    let trouble = match rig.random.below(3) {
        0 => Trouble::None,
        1 => Trouble::Held { port: Port::Command, after: rig.random.time(50, 400), time: rig.random.time(50, 1500) },
        _ => Trouble::Held { port: Port::Status, after: rig.random.time(50, 400), time: rig.random.time(50, 1500) },
    };
    let what = format!("seed {number}: a session with {trouble:?}");
    let bound = Duration::from_millis(200);
    let Rig { arm, robot, random, tally } = rig;
    let (count, clock) = (40 + random.below(100), arm.clock());
    beside(
        clock,
        || trouble.run(arm),
        || {
            let result = robot
                .enter_servo_mode(SessionConfig::new().servo(ServoConfig::new().max_unanswered(bound)).unchecked())
                .and_then(|session| go(session, count));
            tally.sessions += 1;
            tally.sessions_ended += u32::from(result.is_err());
            let most = if result.is_ok() { 1.0 } else { bound.as_secs_f64() / 0.008 + 1.0 };
            let (from, since) = (arm.state().joint_position, clock.elapsed());
            let passed = || clock.elapsed().saturating_sub(since);
            while passed() < Duration::from_secs(2) && !(arm.state().at_rest && passed() > bound * 3) {
                let moved = arm.state().joint_position.max_distance(&from);
                assert!(moved <= most * STEP + 1e-6, "{what}: after {result:?} it has moved on by {moved}");
                clock.sleep(Duration::from_millis(5));
            }
        },
    );
}

fn go(mut session: ServoSession<'_>, count: u32) -> Result<(), Error> {
    for at in 0..count {
        let step = if at / 20 % 2 == 0 { STEP } else { -STEP };
        session.send_joint_offset([step, 0.0, 0.0, 0.0, 0.0, step / 2.0])?;
    }
    session.land().map(drop)
}

/// Number of motions of one controller, before the next with other habits. A controller keeps only the last of its
/// requests.
const A_RIG: u32 = 100;

fn run(seed: u32, count: u32) -> Tally {
    let mut tally = Tally::default();
    for first in (0..count).step_by(A_RIG as usize) {
        let mut rig = Rig::new(seed + first);
        for number in first..count.min(first + A_RIG) {
            rig.settle();
            if rig.random.one_in(5) {
                one_session(&mut rig, seed + number);
            } else {
                one_batch(&mut rig, seed + number);
            }
        }
        tally = tally.add(rig.tally);
    }
    tally
}

#[test]
fn random_motions_end_as_they_should() {
    let count: u32 = std::env::var("JAKA_MOTIONS").ok().and_then(|count| count.parse().ok()).unwrap_or(200);
    let tally = thread::scope(|scope| {
        let rigs: Vec<_> = (0..RIGS).map(|rig| scope.spawn(move || run(rig * 100_000, count / RIGS))).collect();
        let tallies = rigs.into_iter().map(|rig| rig.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)));
        tallies.fold(Tally::default(), Tally::add)
    });
    println!("{tally:?}");
    assert!(tally.reached > count / 5 && tally.stopped > 0 && tally.at_rest > 0, "{tally:?}");
    assert!(tally.sessions_ended > 0 && tally.sessions_ended < tally.sessions, "{tally:?}");
}
