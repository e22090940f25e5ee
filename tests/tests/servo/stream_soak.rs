//! Many arms on streams at once, for long: the set-points on the wire, read by plain sockets, are within the limits.
//!
//! By simulated clocks no set-point is late or missing. With `JAKA_STREAM_SECONDS` the test measures the machine in
//! real time: streams lose no more cycles than bare loops that run at the same time, and memory does not grow.
//! `JAKA_STREAM_ARMS=20 JAKA_STREAM_SECONDS=3600 cargo test --release -p jaka-tests --test servo stream_soak:: --
//! --nocapture` is the long form.

mod bare;
mod wire;

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use jaka_motion::Goal;
use jaka_robot::{
    Client, Config, Error, ErrorKind, Monitor, Robot, RobotConfig, ServoConfig, StreamConfig, StreamHandle,
};
use jaka_sim::SimulatedClock;
use jaka_tests::Configured as _;
use jaka_tests::resources::resident;

use self::bare::BareLoops;
use self::wire::Wire;
use crate::generator::judge::{Judge, Moves};
use crate::generator::{goals::some_goal, some_dynamics};
use jaka_tests::plain_controller::PlainController;
use jaka_tests::rig::{Random, Rig};

const LONG: Duration = Duration::from_secs(600);
const PERIOD: Duration = Duration::from_millis(8);
/// Length of streams in real time.
const STREAM: Duration = Duration::from_secs(60);
/// Lengths of a run and of a stream in simulated time.
const SIMULATED: [Duration; 2] = [Duration::from_secs(30), Duration::from_secs(7)];

/// Counts of the events of one arm.
#[derive(Debug, Default, Clone, Copy)]
struct Tally {
    goals: u64,
    refused: u64,
    streams: u64,
    set_points: u64,
    /// Times in which set-points came too late, as the wire shows and as reports say.
    stood: u64,
    gaps: u64,
    lost: f64,
}

impl std::ops::Add for Tally {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            goals: self.goals + other.goals,
            refused: self.refused + other.refused,
            streams: self.streams + other.streams,
            set_points: self.set_points + other.set_points,
            stood: self.stood + other.stood,
            gaps: self.gaps + other.gaps,
            lost: self.lost + other.lost,
        }
    }
}

fn number(name: &str) -> Option<u32> {
    std::env::var(name).ok()?.parse().ok()
}

#[test]
fn arms_on_streams_move_as_promised() {
    let arms = number("JAKA_STREAM_ARMS").unwrap_or(3);
    match number("JAKA_STREAM_SECONDS") {
        None => in_simulated_time(arms),
        Some(seconds) => in_real_time(arms, Duration::from_secs(seconds.into())),
    }
}

fn in_simulated_time(arms: u32) {
    let run = |arm| {
        thread::spawn(move || {
            let clock = SimulatedClock::new();
            let [all, stream] = SIMULATED;
            run(arm, Some(&clock), stream, || clock.elapsed() >= all)
        })
    };
    let arms: Vec<_> = (0..arms).map(run).collect();
    for arm in arms {
        let tally = arm.join().expect("the promise is kept");
        println!("{tally:?}");
        assert!(tally.set_points > 1000 && tally.goals > 0, "{tally:?}");
        assert_eq!((tally.stood, tally.gaps, tally.lost), (0, 0, 0.0), "{tally:?}");
    }
}

fn in_real_time(arms: u32, time: Duration) {
    let over = Arc::new(AtomicBool::new(false));
    let bare = BareLoops::start(arms, PERIOD, &over);
    let streams: Vec<_> = (0..arms)
        .map(|arm| {
            let over = Arc::clone(&over);
            thread::spawn(move || run(arm, None, STREAM, || over.load(Ordering::Relaxed)))
        })
        .collect();
    let (since, mut warm) = (Instant::now(), None);
    while since.elapsed() < time && !streams.iter().any(thread::JoinHandle::is_finished) {
        thread::sleep(Duration::from_millis(100));
        if warm.is_none() && since.elapsed() > time / 2 {
            warm = Some(resident());
        }
    }
    let (warm, end) = (warm.unwrap_or_default(), resident());
    over.store(true, Ordering::Relaxed);
    let tallies = streams.into_iter().map(|arm| arm.join().expect("the promise is kept"));
    let all = tallies.fold(Tally::default(), |all, one| all + one);
    let (written, lost) = bare.join();
    println!(
        "{arms} arms, {time:?}: {all:?}; bare loops: {written} written, {lost:.0} lost; memory {warm} KiB at half the time, {end} at the end"
    );
    assert!(all.set_points > 0 && all.goals > 0);
    // Where set-points were late, the reports say so.
    assert!(all.stood <= all.gaps, "{all:?}");
    assert!(time < STREAM || end < warm + warm / 20 + 1024, "memory grew from {warm} to {end} KiB");
}

/// One arm with its limits, until it is over, in simulated time if it has a clock. Each stream of every second arm
/// lasts so long; those of the others last to the end.
fn run(arm: u32, clock: Option<&SimulatedClock>, stream_lasts: Duration, is_over: impl Fn() -> bool) -> Tally {
    let (mut random, mut rig, start) = (0..)
        .find_map(|seed| {
            let mut random = Random::new(77_000_000 + arm * 1000 + seed);
            let rig = Rig::new(&mut random);
            rig.place(&mut random).map(|start| (random, rig, start))
        })
        .expect("there is always another seed");
    let dynamics = some_dynamics(&mut random, &mut rig);
    let controller = match clock {
        Some(clock) => PlainController::by_clock(clock, rig.bounds.clone(), start),
        None => PlainController::start(rig.bounds.clone(), start),
    };
    let config = clock.map_or_else(|| Config::new().stale_after(LONG), |clock| Config::new().clock(clock));
    let mut robot = robot(&controller, &config, &rig);
    let now = || clock.map_or_else(Instant::now, SimulatedClock::now);
    let sleep = |time| clock.map_or_else(|| thread::sleep(time), |clock| clock.sleep(time));
    let servo = ServoConfig::new().max_unanswered(LONG).rest_timeout(LONG);
    let config = StreamConfig::new().servo(servo).dynamics(dynamics).max_gap(LONG).max_departure(1e4);
    let mut wire = Wire::new(Judge::new(rig.bounds.clone(), Moves::of(&dynamics, PERIOD.as_secs_f64()), start), PERIOD);
    let mut tally = Tally::default();
    while !is_over() {
        let stream = robot.stream(&config).expect("the arm is ready");
        let begun = now();
        while !is_over() && (arm.is_multiple_of(2) || now() - begun < stream_lasts) {
            let goal = some_goal(&mut random, &rig, stream.handle().joints().0);
            let time = Duration::from_millis(random.below(500).into());
            let given = give(&stream.handle(), &mut random, &rig, goal, time);
            tally.goals += 1;
            tally.refused += u64::from(is_refused(given));
            let pause = if random.one_in(10) { 1000 } else { 100 };
            sleep(Duration::from_millis(random.below(pause).into()));
            wire.read(&controller).unwrap_or_else(|what| panic!("arm {arm}: {what}"));
        }
        let report = stream.land().expect("it lands").report;
        wire.read(&controller).unwrap_or_else(|what| panic!("arm {arm}: {what}"));
        wire.stands();
        tally.streams += 1;
        tally.gaps += report.gaps;
    }
    Tally { set_points: wire.set_points, stood: wire.stood(), lost: wire.lost, ..tally }
}

fn robot(controller: &PlainController, config: &Config, rig: &Rig) -> Robot {
    let monitor: Monitor = Monitor::connect_with(config, controller.status).expect("it listens");
    monitor.wait_until(|status| status.enabled == Some(true), LONG).expect("packets come");
    let client = Client::connect_with(config, controller.commands).expect("it listens");
    Robot::new(client, monitor)
        .expect("it is the only robot")
        .configured(&RobotConfig::new().limits(rig.limits.clone()))
        .expect("the controller computes as the model does")
}

fn give(handle: &StreamHandle, random: &mut Random, rig: &Rig, goal: Goal, time: Duration) -> Result<(), Error> {
    match goal {
        Goal::Joints(to) if to.0.iter().all(|joint| joint.abs() < 1e6) && random.one_in(3) => {
            handle.set_pose(rig.pose(to.0))
        }
        Goal::Joints(to) => handle.set_joints(to),
        Goal::Velocity(speeds) => handle.set_joint_velocity(speeds, time),
        Goal::TcpVelocity(velocity) => handle.set_tcp_velocity(velocity, time),
        _ => handle.rest(),
    }
}

/// Goals at random may be beyond a limit, which is said.
fn is_refused(given: Result<(), Error>) -> bool {
    given.is_err_and(|error| {
        let kind = error.kind();
        assert!(matches!(kind, ErrorKind::BeyondLimit { .. } | ErrorKind::InvalidOption { .. }), "{error}");
        true
    })
}
