//! Threads of set-points that are held up. By simulated clocks they are late only where something takes their time:
//! here, the clock itself, as a scheduler does, and a logger.

use std::cell::RefCell;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Once};
use std::time::Duration;

use jaka_robot::jaka_motion::{Checker, Frames, Limits};
use jaka_robot::status::RobotStatus;
use jaka_robot::{
    Cause, Client, End, Error, ErrorKind, FollowConfig, FollowRun, Robot, RobotConfig, ServoConfig, StreamConfig,
};
use jaka_sim::SimulatedClock;
use jaka_tests::simulated::{SetPoints, SetPointsSeen, beside};
use jaka_tests::witness::curve::apart;
use jaka_tests::{Arm, Configured as _, LONG, followed};
use log::{LevelFilter, Log, Metadata, Record};

use crate::follow::{self, to_and_fro};
use crate::received::positions;
use crate::stream;

const CYCLES: u32 = 4;
const SERVO_PERIOD: Duration = Duration::from_millis(32);

/// Place at which a set-point thread is held up.
#[derive(Clone, Copy)]
enum Place {
    /// Before its set-point, in a cycle that has begun in time.
    Cycle,
    /// In the logger of the wire.
    Logger,
    /// In the logger, which panics after the time.
    Panic,
}

struct HoldUp {
    place: Place,
    clock: SimulatedClock,
    time: Duration,
}

thread_local! {
    /// Next hold-up of this thread by the logger.
    static BY_LOGGER: RefCell<Option<HoldUp>> = const { RefCell::new(None) };
}

struct SlowLogger;

impl Log for SlowLogger {
    fn enabled(&self, metadata: &Metadata<'_>) -> bool {
        metadata.target() == "jaka_sync::wire" && BY_LOGGER.with_borrow(Option::is_some)
    }

    fn log(&self, record: &Record<'_>) {
        if self.enabled(record.metadata()) && record.args().to_string().starts_with("-> ") {
            let hold_up = BY_LOGGER.take().expect("it is enabled");
            hold_up.clock.sleep(hold_up.time);
            assert!(!matches!(hold_up.place, Place::Panic), "a logger that panics");
        }
    }

    fn flush(&self) {}
}

fn ready(limits: Limits) -> (Arm, Robot) {
    let arm = stream::arm().start();
    let robot = Robot::new(arm.client(), arm.monitor::<RobotStatus>())
        .expect("it is the only robot")
        .configured(&RobotConfig::new().limits(limits))
        .expect("it is this arm");
    (arm, robot)
}

/// Holds the thread of set-points up in its next cycle, which is in time.
fn hold_up(arm: &Arm, time: Duration) -> Arc<AtomicBool> {
    hold_up_at(Place::Cycle, arm, time)
}

/// Holds the set-point thread up at a place in its next cycle. The returned flag becomes true at that moment.
fn hold_up_at(place: Place, arm: &Arm, time: Duration) -> Arc<AtomicBool> {
    static LOGGER: Once = Once::new();
    LOGGER.call_once(|| {
        log::set_logger(&SlowLogger).expect("it is the only one");
        log::set_max_level(LevelFilter::Trace);
    });
    let was_held_up = Arc::new(AtomicBool::new(false));
    for thread in ["jaka stream", "jaka follow"] {
        let (clock, happens) = (arm.clock().clone(), Arc::clone(&was_held_up));
        arm.clock().hold_up(thread, move || {
            happens.store(true, Ordering::SeqCst);
            match place {
                Place::Cycle => clock.sleep(time),
                Place::Logger | Place::Panic => BY_LOGGER.set(Some(HoldUp { place, clock, time })),
            }
        });
    }
    was_held_up
}

fn servo() -> ServoConfig {
    ServoConfig::new().step_count(CYCLES)
}

/// Asserts that an arm was at speed, and then held where it was: no set-point brakes a motion that is over.
fn assert_held(set_points: &[[f64; 6]]) {
    let last = set_points[set_points.len() - 1];
    let held = set_points.iter().position(|set_point| apart(set_point, &last) == 0.0).expect("it is there");
    assert!(held + 1 < set_points.len(), "it is held");
    assert!(apart(&set_points[held - 1], &last) > 0.5, "it was at speed: {:?}", &set_points[held - 1..]);
    assert!(set_points[held..].iter().all(|set_point| apart(set_point, &last) == 0.0), "{:?}", &set_points[held..]);
}

#[test]
fn a_stream_at_speed_without_a_set_point_for_three_periods_ends_and_is_held() {
    let (arm, mut robot) = ready(stream::limits());
    let stream = robot.stream(&StreamConfig::new().servo(servo())).expect("the arm is ready");
    stream::speed_up(&stream.handle(), arm.clock());
    hold_up(&arm, SERVO_PERIOD * 3);
    let handle = stream.handle();
    assert!(stream.handle().wait_for_rest(LONG).is_err(), "it ends");
    let error = stream.land().expect_err("it has ended");
    assert!(matches!(error.kind(), ErrorKind::SetPointLate { late } if *late == SERVO_PERIOD * 3), "{error:?}");
    let (set_points, _) = positions(&arm, CYCLES);
    assert_held(&set_points);
    assert!(apart(&handle.joints().0, &set_points[set_points.len() - 1]) == 0.0);
}

#[test]
fn a_slow_stream_without_a_set_point_for_three_periods_goes_on_from_standstill() {
    for (held_up, goes_on) in [(SERVO_PERIOD * 3, true), (SERVO_PERIOD * 4, false)] {
        let (arm, mut robot) = ready(stream::limits());
        let stream = robot.stream(&StreamConfig::new().servo(servo())).expect("the arm is ready");
        // An acceleration of 72 deg/s² times a period of 32 ms is 2.3 deg/s.
        let turn = || stream.handle().set_joint_velocity([0.0, 0.0, 0.0, 0.0, 0.0, 2.0], Duration::from_millis(500));
        turn().expect("within its speed");
        arm.clock().sleep(Duration::from_millis(300));
        hold_up(&arm, held_up);
        arm.clock().sleep(held_up + SERVO_PERIOD * 2);
        // It may have ended.
        let _ = turn();
        arm.clock().sleep(Duration::from_millis(200));
        let landed = stream.land();
        let gaps = landed.as_ref().map(|end| (end.report.gaps, end.report.longest_gap));
        match landed.as_ref().map_err(Error::kind) {
            Ok(_) => assert_eq!(gaps.ok(), Some((1, SERVO_PERIOD * 3))),
            Err(ErrorKind::SetPointLate { late }) => assert_eq!((*late, goes_on), (SERVO_PERIOD * 4, false)),
            Err(other) => panic!("{other:?}"),
        }
        let (set_points, _) = positions(&arm, CYCLES);
        assert!(
            set_points.windows(2).all(|pair| apart(&pair[0], &pair[1]) < 0.065),
            "2 deg/s are 0.064 deg in a period"
        );
    }
}

/// It is compared with standstill like one that is given after a gap.
#[test]
fn a_set_point_that_is_held_up_until_an_arm_stands_and_is_too_fast_from_there_is_not_sent() {
    let (arm, mut robot) = ready(stream::limits());
    let stream = robot.stream(&StreamConfig::new().servo(servo())).expect("the arm is ready");
    arm.clock().sleep(SERVO_PERIOD * 2);
    let turn = [0.0, 0.0, 0.0, 0.0, 0.0, 20.0];
    stream.handle().set_joint_velocity(turn, Duration::from_millis(500)).expect("within its speed");
    // The last one is slower than 2.3 deg/s, an acceleration of 72 deg/s² times a period; the next one is not.
    let is_slow = |by: f64| by < 72.0 * 0.032 * 0.032;
    let last_step = || {
        let (set_points, _) = positions(&arm, CYCLES);
        set_points.windows(2).last().map_or(0.0, |pair| apart(&pair[0], &pair[1]))
    };
    while last_step() < 0.02 {
        arm.clock().sleep(Duration::from_millis(1));
    }
    assert!(is_slow(last_step()), "{}", last_step());
    let sent = positions(&arm, CYCLES).0.len();
    hold_up(&arm, SERVO_PERIOD * 3);
    assert!(stream.handle().wait_for_rest(LONG).is_err(), "it ends");
    let error = stream.land().expect_err("it has ended");
    assert!(matches!(error.kind(), ErrorKind::SetPointLate { late } if *late == SERVO_PERIOD * 3), "{error:?}");
    let after = &positions(&arm, CYCLES).0[sent - 1..];
    assert!(is_slow(apart(&after[0], &after[1])), "{after:?}");
}

/// A run whose thread is held up on its way, with what a proxy has seen of its set-points.
fn run_held_up(place: Place, time: Duration) -> (Vec<[f64; 6]>, End, SetPointsSeen) {
    let arm = stream::arm().start();
    let proxy = SetPoints::watch(arm.clock(), arm.command_addr(), |_, _| true);
    let client = Client::connect_with(&arm.config(), proxy.address()).expect("it listens");
    let mut robot = Robot::new(client, arm.monitor::<RobotStatus>()).expect("it is the only robot");
    robot = robot.configured(&RobotConfig::new().limits(follow::limits())).expect("it is this arm");
    let trajectory =
        follow::trajectory(&to_and_fro(), &Checker::new(follow::limits(), Frames::new())).expect("within the limits");
    let run = robot.start_follow(&trajectory, &FollowConfig::new().servo(servo())).expect("the arm is at its start");
    follow::wait_for(&arm, &run.handle(), 0.5);
    hold_up_at(place, &arm, time);
    let handle = run.handle();
    let end = run.wait();
    assert_eq!((handle.progress().time, handle.progress().rate.to_bits()), (followed(&end).reached, 0.0_f64.to_bits()));
    let (set_points, _) = positions(&arm, CYCLES);
    to_and_fro().has(&set_points).unwrap_or_else(|what| panic!("{what}: {end:?}"));
    (set_points, end, proxy.seen())
}

#[test]
fn a_set_point_that_is_too_late_is_an_underrun() {
    let late_by = Duration::from_millis(118);
    let (set_points, end, _) = run_held_up(Place::Cycle, late_by);
    assert_eq!(
        (end.cause(), followed(&end).has_left_curve, end.rest.was_seen()),
        (Cause::SetPointLate, false, true),
        "{end:?}"
    );
    assert_eq!((end.report.gaps, end.report.longest_gap), (1, late_by));
    let error = end.error.as_ref().expect("it says so");
    let ErrorKind::SetPointLate { late } = error.kind() else { panic!("{error:?}") };
    assert_eq!(*late, late_by);
    assert_held(&set_points);
}

#[test]
fn a_run_whose_set_point_is_late_by_less_goes_on() {
    let late_by = (SERVO_PERIOD * 3).saturating_sub(Duration::from_millis(1));
    let (set_points, end, seen) = run_held_up(Place::Cycle, late_by);
    assert_eq!((end.cause(), followed(&end).has_left_curve, end.report.gaps), (Cause::Reached, false, 0), "{end:?}");
    // The report has the lateness on the wire, and the next one is no sooner for it.
    assert_eq!((seen.shortest, seen.longest), (Some(SERVO_PERIOD), Some(SERVO_PERIOD + late_by)), "{seen:?}");
    assert!((end.report.lateness(1.0).as_secs_f64() / late_by.as_secs_f64() - 1.0).abs() < 0.03, "{:?}", end.report);
    assert!(apart(set_points.last().expect("there are some"), &to_and_fro().at(3.0)) < 1e-9);
    assert_eq!(follow::jump(follow::START, &set_points), None);
}

#[test]
fn a_logger_makes_no_set_point_late_but_the_next_one() {
    let held_up = SERVO_PERIOD * 3;
    let (_, end, seen) = run_held_up(Place::Logger, held_up);
    assert_eq!((end.cause(), end.report.gaps, end.report.late_cycles), (Cause::Reached, 0, 1), "{end:?}");
    assert_eq!((seen.shortest, seen.longest), (Some(SERVO_PERIOD), Some(held_up)), "{seen:?}");
}

#[test]
fn a_gap_while_a_run_is_stopping_is_no_stop_as_commanded() {
    let (arm, mut robot) = ready(follow::limits());
    let run = run(&mut robot);
    follow::wait_for(&arm, &run.handle(), 0.5);
    run.handle().stop().expect("it runs");
    hold_up_at(Place::Logger, &arm, SERVO_PERIOD * 5);
    let end = run.wait();
    let error = end.error.as_ref().unwrap_or_else(|| panic!("it had no set-points at speed: {end:?}"));
    assert!(matches!(error.kind(), ErrorKind::SetPointLate { late } if *late == SERVO_PERIOD * 4), "{error:?}");
    assert_eq!((end.cause(), end.report.gaps), (Cause::SetPointLate, 1), "{end:?}");
}

/// A run of the trajectory there and back.
fn run(robot: &mut Robot) -> FollowRun<'_> {
    let checker = Checker::new(follow::limits(), Frames::new());
    let trajectory = follow::trajectory(&to_and_fro(), &checker).expect("within the limits");
    robot.start_follow(&trajectory, &FollowConfig::new().servo(servo())).expect("the arm is at its start")
}

/// Also while the next one is held up, and where that does not go out.
#[test]
fn progress_of_a_run_that_is_braked_is_that_of_the_last_set_point_that_was_sent() {
    for time in [(SERVO_PERIOD * 3).saturating_sub(Duration::from_millis(1)), SERVO_PERIOD * 3] {
        let (arm, mut robot) = ready(follow::limits());
        let stop = robot.stop_handle();
        let run = run(&mut robot);
        follow::wait_for(&arm, &run.handle(), 0.5);
        let assert_is_of_the_last = |time: Duration| {
            let (set_points, _) = positions(&arm, CYCLES);
            let last = set_points[set_points.len() - 1];
            let told = to_and_fro().at(time.as_secs_f64());
            assert!(apart(&told, &last) < 1e-6, "{told:?} at {time:?}, and {last:?} was sent");
        };
        let look = || {
            arm.clock().sleep(SERVO_PERIOD * 2);
            hold_up(&arm, time);
            arm.clock().sleep(SERVO_PERIOD * 2);
            assert!(run.handle().progress().rate > 0.0, "it is still braked");
            assert_is_of_the_last(run.handle().progress().time);
        };
        beside(arm.clock(), || stop.stop().expect("the controller takes it"), look);
        let handle = run.handle();
        let end = run.wait();
        assert_eq!((end.cause(), followed(&end).has_left_curve), (Cause::Stopped, false), "{end:?}");
        assert_is_of_the_last(followed(&end).reached);
        assert_eq!(
            (handle.progress().time, handle.progress().rate.to_bits()),
            (followed(&end).reached, 0.0_f64.to_bits())
        );
    }
}

#[test]
fn no_trajectory_time_passes_after_a_panic() {
    let (arm, mut robot) = ready(follow::limits());
    let run = run(&mut robot);
    follow::wait_for(&arm, &run.handle(), 0.5);
    assert!(run.handle().progress().rate > 0.0);
    hold_up_at(Place::Panic, &arm, Duration::ZERO);
    let handle = run.handle();
    let end = run.wait();
    assert_eq!((end.cause(), handle.has_ended()), (Cause::Failed, true), "{end:?}");
    assert_eq!(handle.progress().rate.to_bits(), 0.0_f64.to_bits());
    assert!(!arm.state().servo_mode);
}

/// Its braking set-points go on, and the stop that waits for them does not overtake them.
#[test]
fn a_stop_waits_for_a_stream_whose_braking_is_held_up() {
    let (arm, mut robot) = ready(stream::limits());
    let stop = robot.stop_handle();
    let stream = robot.stream(&StreamConfig::new().servo(servo())).expect("the arm is ready");
    stream::speed_up(&stream.handle(), arm.clock());
    let stops = || stop.stop().expect("the controller takes it");
    let was_held_up = beside(arm.clock(), stops, || {
        arm.clock().sleep(SERVO_PERIOD * 2);
        hold_up(&arm, (SERVO_PERIOD * 3).saturating_sub(Duration::from_millis(1)))
    });
    let error = stream.land().expect_err("it was stopped");
    assert!(matches!(error.kind(), ErrorKind::NotAcknowledged { .. }), "{error:?}");
    let (set_points, after) = positions(&arm, CYCLES);
    // The arm stands after the last one.
    let stands = [set_points[set_points.len() - 1]; 3];
    assert_eq!(stream::jump(stream::START, &[&set_points[..], &stands].concat()), None);
    assert_eq!(after[0], "stop_program");
    assert!(was_held_up.load(Ordering::SeqCst), "its thread was not held up");
}
