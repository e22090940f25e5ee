//! Contact with a plane: how far the tool goes in, at each period of the packets, with a clock that the test moves on.

use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use jaka_sim::{Controller, Delays, Port};
use jaka_sync::motion::{EndMove, JointMove, MoveL};
use jaka_sync::program::StopProgram;
use jaka_sync::{
    Command, Config, Error, ErrorKind, ForceComponent, ForceLimit, Monitor, MotionEnd, NotGuarded, NotShown, Outcome,
    Robot,
};

use super::{LONG, count, names, stand_above_a_plane};

/// How long it takes from a packet until the controller has the stop, in its time: what is left of the 20 ms of reaction is less than the
/// cycle in which it begins to brake.
const REACTION: Duration = Duration::from_millis(16);

/// The change of force, in N, and how much 1 mm takes: so 0.0025 mm is the depth at which it is reached.
const CHANGE: f64 = 5.0;
const STIFFNESS: f64 = 2000.0;

/// The acceleration of the motions, in mm/s².
const BRAKING: f64 = 500.0;

/// By another formula than the robot's: halving, until the way is the overtravel.
fn permitted(period: Duration, overtravel: f64) -> f64 {
    let time = (period + Duration::from_millis(20)).as_secs_f64();
    let (mut low, mut high) = (0.0, 1000.0);
    for _ in 0..60 {
        let speed = f64::midpoint(low, high);
        let way = speed * time + speed * speed / (2.0 * BRAKING);
        if way <= overtravel { low = speed } else { high = speed }
    }
    low
}

/// A controller whose tool is this far above a plane, and a robot that knows how often packets come.
struct Bench {
    controller: Controller,
    period: Duration,
}

impl Bench {
    fn new(period: Duration, above_mm: f64) -> (Self, Robot) {
        let builder = Controller::builder().delays(Delays::NONE).stepped_clock().status_period(period);
        let controller = builder.start().expect("loopback has free ports");
        stand_above_a_plane(&controller, above_mm, STIFFNESS);
        let config = Config::new().stale_after(LONG).reply_timeout(LONG);
        let monitor: Monitor = config.connect_monitor(controller.status_addr()).expect("the controller listens");
        let client = config.connect_client(controller.command_addr()).expect("the controller listens");
        let (bench, robot) = (Self { controller, period }, Robot::new(client, monitor));
        bench.steps_until(&robot, || robot.monitor().statistics().recent_gap.is_some_and(|gap| gap < period / 2));
        (bench, robot)
    }

    /// Packets come until something is so.
    fn steps_until(&self, robot: &Robot, is_so: impl Fn() -> bool) {
        let since = Instant::now();
        while !is_so() {
            assert!(since.elapsed() < LONG, "this machine is too busy");
            (0..40).for_each(|_| self.step(robot.monitor()));
        }
    }

    /// Lets a period pass, and waits until the monitor has its packet.
    fn step(&self, monitor: &Monitor) {
        let number = || monitor.last_known_packet().map_or(0, |newest| newest.number);
        let (before, since) = (number(), Instant::now());
        self.controller.advance(self.period);
        while number() == before {
            assert!(since.elapsed() < LONG, "the packet does not come");
            thread::yield_now();
        }
    }

    /// Runs the motion; the stop reaches the controller as late as the reaction allows.
    fn run(&self, robot: &mut Robot, motion: &MoveL, limit: ForceLimit) -> Result<MotionEnd, Error> {
        let (monitor, done) = (robot.monitor().clone(), AtomicBool::new(false));
        let link = self.controller.link(Port::Command).to_controller();
        thread::scope(|scope| {
            let running = scope.spawn(|| {
                let end = robot.run_until(motion, limit, LONG);
                done.store(true, Ordering::SeqCst);
                end
            });
            let is_done = || done.load(Ordering::SeqCst) || running.is_finished();
            let mut is_touched = false;
            while !is_done() {
                let moves = !self.controller.state().at_rest;
                if moves && !is_touched {
                    link.hold();
                }
                self.step(&monitor);
                let force = self.controller.state().torque_sensor.contact_force;
                if moves && !is_touched && force[2].abs() > CHANGE {
                    is_touched = true;
                    self.controller.advance(REACTION);
                    link.release();
                    let since = Instant::now();
                    while !is_done() && count(&self.controller, StopProgram::INFO.name) == 0 {
                        assert!(since.elapsed() < LONG, "no stop comes: {:?}", names(&self.controller));
                        thread::yield_now();
                    }
                }
                if !moves {
                    link.release();
                }
            }
            running.join().expect("it does not panic")
        })
    }
}

fn down(speed: f64) -> MoveL {
    MoveL::relative([0.0, 0.0, -20.0, 0.0, 0.0, 0.0], speed).acceleration(BRAKING)
}

fn fz() -> ForceLimit {
    ForceLimit::new(ForceComponent::Fz, CHANGE)
}

/// The end of a motion; none where the machine was too busy, so that the robot was blind before it began.
fn seen(end: Result<MotionEnd, Error>) -> Option<MotionEnd> {
    match end {
        Err(error) if matches!(error.kind(), ErrorKind::StatusUnknown { .. }) => None,
        end => Some(end.unwrap_or_else(|error| panic!("it is slow enough, and the sensor works: {error}"))),
    }
}

/// How deep the tool goes in with the speed that is permitted; none where the machine was too busy, so that the robot was blind for a moment.
fn penetration(period: Duration, above_mm: f64, overtravel: f64) -> Option<f64> {
    let (bench, mut robot) = Bench::new(period, above_mm);
    let motion = down(permitted(period, overtravel) - 1e-6);
    let end = seen(bench.run(&mut robot, &motion, fz().overtravel(overtravel)))?;
    let deepest = bench.controller.deepest_penetration();
    assert!(deepest <= overtravel, "{period:?}, {above_mm} mm above: {deepest} mm");
    if matches!(end.outcome, Outcome::StatusLost { .. }) {
        return None;
    }
    assert_eq!(count(&bench.controller, StopProgram::INFO.name), 1);
    let trip = end.guarded().unwrap_or_else(|error| panic!("{period:?}, {above_mm} mm above: {error}"));
    let torque_sensor = trip.packet.status.torque_sensor.as_ref().and_then(|report| report.known());
    assert!(torque_sensor.is_some_and(|report| report.state.contact_force[2].abs() > CHANGE), "{trip:?}");
    Some(deepest)
}

/// How often a run is tried for which the machine was too busy.
const TRIES: usize = 20;

#[test]
fn the_tool_goes_no_further_in_than_is_allowed_at_every_period() {
    let share = |period_ms: u64, overtravel: f64| {
        let period = Duration::from_millis(period_ms);
        let at_phase = |phase: f64| {
            let above = 2.0 + phase * permitted(period, overtravel) * period.as_secs_f64();
            (0..TRIES).find_map(|_| penetration(period, above, overtravel)).expect("this machine is too busy")
        };
        [0.0, 0.35, 0.7].into_iter().map(at_phase).fold(0.0, f64::max) / overtravel
    };
    let mut cases = vec![(8, 1.0), (16, 1.0), (30, 1.0), (30, 0.25), (50, 2.0), (100, 1.0)];
    if jaka_tests::reliability_times() > 1 {
        cases.extend((8..=100).step_by(4).map(|period_ms| (period_ms, 1.0)));
    }
    let shares: Vec<f64> = thread::scope(|scope| {
        let run = |(period_ms, overtravel)| scope.spawn(move || share(period_ms, overtravel));
        let runs: Vec<_> = cases.into_iter().map(run).collect();
        runs.into_iter().map(|run| run.join().expect("the tool goes no further")).collect()
    });
    // What is permitted is not much less than what could be: most of it is used up where a contact comes just after a packet.
    assert!(shares.iter().all(|share| *share > 0.4), "{shares:?}");
}

#[test]
fn a_motion_that_is_too_fast_for_the_overtravel_or_of_unknown_speed_is_not_sent() {
    let period = Duration::from_millis(30);
    let (bench, mut robot) = Bench::new(period, 5.0);
    let before = bench.controller.requests().len();
    let error = robot.run_until(&down(400.0), fz(), LONG).expect_err("it is too fast");
    let ErrorKind::NotGuarded { command, reason: NotGuarded::TooFast { speed_mm_s, permitted_mm_s, period, .. } } =
        error.kind()
    else {
        panic!("{error:?}")
    };
    assert_eq!((&**command, *speed_mm_s), (MoveL::INFO.name, 400.0));
    // The clock of the test goes faster than a real one.
    assert!((permitted_mm_s - permitted(*period, 1.0)).abs() < 1e-6, "{error}");
    let text = error.to_string();
    assert!(
        text.starts_with("`moveL` was not sent under a guard: at 400 mm/s the tool goes on for more than 1 mm after a contact; permitted are "),
        "{text}"
    );
    let reason = |error: Error| match error.kind() {
        ErrorKind::NotGuarded { reason, .. } => *reason,
        _ => panic!("{error:?}"),
    };
    let joints = JointMove::absolute([0.0, 90.0, 90.0, 90.0, -90.0, 0.0], 1.0).acceleration(10.0);
    let end_move = EndMove::new(bench.controller.state().tcp_pose, 1.0);
    assert_eq!(reason(robot.run_until(&joints, fz(), LONG).expect_err("unknown")), NotGuarded::SpeedUnknown);
    assert_eq!(reason(robot.run_until(&end_move, fz(), LONG).expect_err("unknown")), NotGuarded::SpeedUnknown);
    let unknown = MoveL::relative([0.0, 0.0, -1.0, 0.0, 0.0, 0.0], 1.0);
    assert_eq!(reason(robot.run_until(&unknown, fz(), LONG).expect_err("unknown")), NotGuarded::BrakingUnknown);
    for limit in [fz().overtravel(0.0), fz().braking(f64::NAN), ForceLimit::new(ForceComponent::Fx, -1.0)] {
        let error = robot.run_until(&down(1.0), limit, LONG).expect_err("it is not a limit");
        assert!(error.is_invalid_argument(), "{error:?}");
    }
    assert_eq!(bench.controller.requests().len(), before, "{:?}", names(&bench.controller));
}

#[test]
fn without_a_sensor_that_works_nothing_is_sent() {
    let (bench, mut robot) = Bench::new(Duration::from_millis(30), 5.0);
    let monitor = robot.monitor().clone();
    let sensor = |keys: serde_json::Value| {
        bench.controller.set_status([("torqsensor".to_owned(), keys)]);
        bench.step(&monitor);
    };
    let not_shown = |robot: &mut Robot| {
        let error = robot.run_until(&down(1.0), fz(), LONG).expect_err("the sensor does not work");
        match error.kind() {
            ErrorKind::NotShown { reason, .. } => reason.clone(),
            _ => panic!("{error:?}"),
        }
    };
    let zeros = [0.0; 6];
    let settings = serde_json::json!([0, ["192.168.2.228", 49152], [0.0, [0.0, 0.0, 0.0]]]);
    let report = |works: i32, code: serde_json::Value| serde_json::json!([settings, [works, code, zeros, zeros]]);
    sensor(report(0, 0.into()));
    assert_eq!(not_shown(&mut robot), NotShown::SensorOff);
    sensor(report(1, 7.into()));
    assert_eq!(not_shown(&mut robot), NotShown::SensorError { code: "7".to_owned() });
    sensor(report(1, "none".into()));
    assert_eq!(not_shown(&mut robot), NotShown::SensorError { code: "\"none\"".to_owned() });
    sensor("none".into());
    assert!(matches!(not_shown(&mut robot), NotShown::Unfit { .. }));
    assert_eq!(names(&bench.controller), Vec::<String>::new());
}

/// A sensor that fails on the way; none where the machine was too busy.
fn fails_on_the_way() -> Option<()> {
    let (bench, mut robot) = Bench::new(Duration::from_millis(30), 5.0);
    let monitor = robot.monitor().clone();
    let end = thread::scope(|scope| {
        let running = scope.spawn(|| robot.run_until(&down(1.0), fz(), LONG));
        while !running.is_finished() {
            if !bench.controller.state().at_rest {
                bench.controller.set_state(|state| state.torque_sensor.working = false);
            }
            bench.step(&monitor);
        }
        running.join().expect("it does not panic")
    });
    let end = seen(end).filter(|end| !matches!(end.outcome, Outcome::StatusLost { .. }))?;
    assert_eq!(count(&bench.controller, StopProgram::INFO.name), 1, "{end:?}");
    assert!(end.guarded().is_err());
    Some(())
}

#[test]
fn a_sensor_that_fails_on_the_way_stops_the_motion() {
    (0..TRIES).find_map(|_| fails_on_the_way()).expect("this machine is too busy");
}
