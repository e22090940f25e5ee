//! Random motions and set-points of every kind through a robot with limits: what is on the wire is within them by a
//! witness, and what is within them by the witness is on the wire.
//!
//! 400 of them, or as many as `JAKA_LIMITS` says.

use std::thread;
use std::time::Duration;

use jaka_robot::motion::{EndMove, JointMove, MoveC, MoveL};
use jaka_robot::types::{JointPosition, Pose};
use jaka_robot::{Cause, Client, Config, Error, Monitor, Motion, Robot, RobotConfig, ServoConfig};
use jaka_sim::SimulatedClock;
use jaka_tests::Configured as _;
use jaka_tests::LONG;
use jaka_tests::witness::way::{Excess, Path, Steps, inverted};
use jaka_tests::witness::{inverse, product};
use serde_json::Value;

use jaka_tests::plain_controller::{PlainController, six};
use jaka_tests::rig::{AMOUNTS, Random, Rig, WITHIN, frame};

const RIGS: u32 = 20;
const PERIOD: f64 = 0.008;
const STEPS: Steps = Steps { degrees: 0.1, millimetres: 0.3 };
const FINE: Steps = Steps { degrees: 0.002, millimetres: 0.006 };

/// Counts of the outcomes of motions and set-points.
#[derive(Debug, Default, Clone, Copy)]
struct Tally {
    sent: u32,
    refused: u32,
    either: u32,
    set_points: u32,
    set_points_refused: u32,
}

/// A motion, as the witness judges it.
struct Judged {
    excess: Excess,
    /// Joint position of the arm afterwards, in degrees, if the witness can tell.
    end: Option<[f64; 6]>,
    /// Its way, its speed and its tolerance, if it is one of the tool centre point.
    way: Option<(Path, f64, f64)>,
}

/// A robot with limits, at a controller of plain sockets.
struct Cell {
    seed: u32,
    random: Random,
    rig: Rig,
    controller: PlainController,
    robot: Robot,
    at: [f64; 6],
    tally: Tally,
}

impl Cell {
    fn new(seed: u32) -> Option<Self> {
        let mut random = Random::new(seed);
        let rig = Rig::new(&mut random);
        let at = rig.place(&mut random)?;
        let clock = SimulatedClock::new();
        let controller = PlainController::by_clock(&clock, rig.bounds.clone(), at);
        let config = Config::new().clock(&clock);
        let monitor: Monitor = Monitor::connect_with(&config, controller.status).expect("it listens");
        let client = Client::connect_with(&config, controller.commands).expect("it listens");
        monitor.wait_until(|status| status.enabled == Some(true), LONG).expect("packets come");
        let options = RobotConfig::new().start_grace(Duration::from_millis(1), 1).limits(rig.limits.clone());
        let robot = Robot::new(client, monitor)
            .expect("it is the only robot")
            .configured(&options)
            .expect("the controller computes as the model does");
        Some(Self { seed, random, rig, controller, robot, at, tally: Tally::default() })
    }

    /// Several motions in a queue, and their end.
    fn queue(&mut self) {
        for _ in 0..=self.random.below(8) {
            match self.random.below(6) {
                0 | 1 => self.joint_move(),
                2 => self.end_move(),
                // What starts too near to a singularity may stay as near, which is for the checker's own tests.
                _ if !is_clear(&self.rig, self.at) => {}
                3 | 4 => self.line(),
                _ => self.arc(),
            }
        }
        let cause = self.robot.wait(LONG).cause();
        assert!(matches!(cause, Cause::Reached | Cause::AtRest | Cause::NoMotion | Cause::Stopped), "{cause}");
        self.controller.motions();
        self.robot.acknowledge();
    }

    fn joint_move(&mut self) {
        let most = self.random.mostly_small(200.0);
        let by = self.random.offsets::<6>(most);
        let to: [f64; 6] = std::array::from_fn(|joint| self.at[joint] + by[joint]);
        let speed = self.random.mostly_small(200.0);
        let acceleration = self.rig.bounds.accelerations[0] * self.random.between(0.2, 1.1);
        let excess = self.rig.bounds.joint_way(self.at, to, speed, acceleration, STEPS);
        let motion =
            if self.random.one_in(2) { JointMove::relative(by, speed) } else { JointMove::absolute(to, speed) };
        if self.random.one_in(20) {
            let error = self.robot.start(&motion).expect_err("without an acceleration");
            assert!(error.to_string().contains("acceleration") || excess.is_beyond(WITHIN), "{error}");
            return;
        }
        self.send(&motion.acceleration(acceleration), &Judged { excess, end: Some(to), way: None }, |sent| {
            assert_eq!(sent["cmdName"], "joint_move");
            assert_eq!(
                JointPosition(six(&sent["jointPosition"])),
                JointPosition(if sent["relFlag"] == 1 { by } else { to })
            );
        });
    }

    fn end_move(&mut self) {
        let near = self.near(60.0);
        let to = self.rig.pose(near);
        let target = product(product(inverted(self.rig.bounds.base), frame(to)), inverted(self.rig.bounds.tool));
        let Some(end) = inverse(&self.rig.bounds.arm, target, self.at) else {
            return;
        };
        let speed = self.random.mostly_small(200.0);
        let acceleration = self.rig.bounds.accelerations[0] * self.random.between(0.2, 1.1);
        let excess = self.rig.bounds.joint_way(self.at, end, speed, acceleration, STEPS);
        self.send(
            &EndMove::new(to, speed).acceleration(acceleration),
            &Judged { excess, end: Some(end), way: None },
            |sent| {
                assert_eq!(Pose::from(six(&sent["endPosition"])), to);
            },
        );
    }

    fn line(&mut self) {
        let tolerance = if self.random.one_in(2) { 0.0 } else { self.random.between(0.0, 20.0) };
        let (most, speed) = (self.random.mostly_small(60.0), self.random.mostly_small(500.0));
        let near = self.near(most);
        let here = self.rig.pose(self.at);
        let (motion, to) = if self.random.one_in(2) {
            let [x, y, z] = self.random.offsets::<3>(most * 5.0);
            (
                MoveL::relative([x, y, z, 0.0, 0.0, 0.0], speed),
                Pose { x: here.x + x, y: here.y + y, z: here.z + z, ..here },
            )
        } else {
            let to = self.rig.pose(near);
            (MoveL::absolute(to, speed), to)
        };
        let path = Path::Line(product(inverted(self.rig.bounds.base), frame(to)));
        let judged = self.judged_way(path, speed, tolerance, STEPS);
        self.send(&motion.acceleration(200.0).tolerance(tolerance), &judged, |sent| {
            assert_eq!(sent["cmdName"], "moveL");
            assert_eq!(sent["speed"], speed);
        });
    }

    fn arc(&mut self) {
        let (most, speed) = (self.random.mostly_small(40.0), self.random.mostly_small(500.0));
        let (mid, to) = (self.near(most), self.near(most));
        let (mid, to) = (self.rig.pose(mid), self.rig.pose(to));
        let in_base = |pose: Pose| product(inverted(self.rig.bounds.base), frame(pose));
        let path = Path::Arc(in_base(mid), in_base(to));
        let judged = self.judged_way(path, speed, 0.0, STEPS);
        self.send(&MoveC::absolute(mid, to, speed, 200.0, 0.0), &judged, |sent| {
            assert_eq!(Pose::from(six(&sent["pos_end"])), to);
        });
    }

    fn judged_way(&self, path: Path, speed: f64, tolerance: f64, steps: Steps) -> Judged {
        let (excess, end) = self.rig.bounds.tcp_way(self.at, path, speed, tolerance, steps);
        Judged { excess, end, way: Some((path, speed, tolerance)) }
    }

    fn near(&mut self, most: f64) -> [f64; 6] {
        let by = self.random.offsets::<6>(most);
        std::array::from_fn(|joint| self.at[joint] + by[joint])
    }

    /// Starts a motion, and compares what was sent with what the witness says.
    fn send<M: Motion + std::fmt::Debug>(&mut self, motion: &M, judged: &Judged, is_sent: impl Fn(&Value)) {
        let result = self.robot.start(motion);
        let sent = self.controller.motions();
        let Judged { mut excess, end, way } = *judged;
        if let (true, Some((path, speed, tolerance))) = (result.is_err() && !excess.is_beyond(WITHIN), way) {
            // Near a singularity joints are fastest for less than a step of the witness.
            excess = self.judged_way(path, speed, tolerance, FINE).excess;
        }
        let what = || format!("seed {}: from {:?}: {motion:?}, {excess:?}", self.seed, self.at);
        match &result {
            Ok(()) => {
                assert!(!excess.is_beyond(AMOUNTS), "sent although beyond\n{}", what());
                assert_eq!(sent.len(), 1, "{}", what());
                is_sent(&sent[0]);
                self.tally.sent += 1;
                self.at = end.unwrap_or_else(|| panic!("the way leads somewhere\n{}", what()));
                self.controller.put(self.at);
            }
            Err(error) => {
                assert!(excess.is_beyond(WITHIN), "refused although within: {error}\n{}", what());
                assert_eq!(sent, Vec::<Value>::new(), "{}", what());
                *if excess.is_beyond(AMOUNTS) { &mut self.tally.refused } else { &mut self.tally.either } += 1;
            }
        }
    }

    /// A servo session until a set-point is refused, or for a while.
    fn session(&mut self) {
        let (count, size) = (self.random.below(20) + 1, self.random.mostly_small(0.5));
        let starting_speed = self.rig.bounds.accelerations[0] * PERIOD * PERIOD;
        let mut session = self.robot.enter_servo_mode(ServoConfig::new()).expect("the arm is ready");
        let (mut before, mut refusal) = ([self.at; 2], None::<(Error, Excess)>);
        for _ in 0..count {
            let [earlier, last] = before;
            // Mostly as fast as before and a little more; sometimes a leap.
            let change = if self.random.one_in(8) { size } else { starting_speed * 0.9 };
            let change = self.random.offsets::<6>(change);
            let target: [f64; 6] =
                std::array::from_fn(|joint| last[joint] + (last[joint] - earlier[joint]) + change[joint]);
            let mut is_pose = false;
            let result = match self.random.below(if is_clear(&self.rig, last) { 3 } else { 2 }) {
                0 => session.send_joints(target),
                1 => session.send_joint_offset(JointPosition(std::array::from_fn(|joint| target[joint] - last[joint]))),
                _ => {
                    is_pose = true;
                    session.send_pose(self.rig.pose(target))
                }
            };
            let mut excess = self.rig.bounds.set_point(before, target, PERIOD, STEPS);
            if is_pose {
                excess.singularity = self.rig.bounds.least - self.rig.bounds.nearest_singularity(target);
            }
            match result {
                Ok(()) => {
                    assert!(
                        !excess.is_beyond(AMOUNTS),
                        "sent although beyond\nseed {}: {before:?}, {target:?}, {excess:?}",
                        self.seed
                    );
                    self.tally.set_points += 1;
                    before = [last, target];
                }
                Err(error) => {
                    refusal = Some((error, excess));
                    break;
                }
            }
        }
        match refusal {
            None => drop(session.land().expect("all were accepted")),
            Some((error, excess)) => {
                assert!(
                    excess.is_beyond(WITHIN),
                    "refused although within: {error}\nseed {}: {before:?}, {excess:?}",
                    self.seed
                );
                drop(session);
                self.tally.set_points_refused += 1;
            }
        }
        drop(self.controller.motions());
        self.at = self.controller.joints();
    }
}

/// Whether joint positions keep the least distance from singularities.
fn is_clear(rig: &Rig, joints: [f64; 6]) -> bool {
    rig.bounds.nearest_singularity(joints) > rig.bounds.least
}

fn items() -> u32 {
    std::env::var("JAKA_LIMITS").ok().and_then(|items| items.parse().ok()).unwrap_or(400)
}

fn run(first: u32, items: u32) -> Tally {
    let (mut seed, mut all) = (first, Tally::default());
    let count = |tally: &Tally| tally.sent + tally.refused + tally.either + tally.set_points + tally.set_points_refused;
    while count(&all) < items {
        seed += 1;
        let Some(mut cell) = Cell::new(seed) else { continue };
        for _ in 0..6 {
            if cell.random.one_in(2) { cell.queue() } else { cell.session() }
        }
        let tally = cell.tally;
        all = Tally {
            sent: all.sent + tally.sent,
            refused: all.refused + tally.refused,
            either: all.either + tally.either,
            set_points: all.set_points + tally.set_points,
            set_points_refused: all.set_points_refused + tally.set_points_refused,
        };
    }
    all
}

#[test]
fn nothing_beyond_a_limit_is_sent_and_nothing_within_is_refused() {
    let each = items().div_ceil(RIGS);
    let runs: Vec<_> = (0..RIGS).map(|rig| thread::spawn(move || run(10_000_000 + rig * 100_000, each))).collect();
    let tallies: Vec<Tally> = runs.into_iter().map(|run| run.join().expect("the promise is kept")).collect();
    let sum = |of: fn(&Tally) -> u32| tallies.iter().map(of).sum::<u32>();
    let (sent, refused, either) = (sum(|tally| tally.sent), sum(|tally| tally.refused), sum(|tally| tally.either));
    let (points, points_refused) = (sum(|tally| tally.set_points), sum(|tally| tally.set_points_refused));
    println!(
        "{sent} motions sent, {refused} refused, {either} either; {points} set-points sent, {points_refused} refused"
    );
    assert!(sent > 0 && refused > 0 && points > 0 && points_refused > 0);
}
