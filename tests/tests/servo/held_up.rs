//! Threads of set-points that are held up. By simulated clocks they are late only where something takes their time:
//! here, a type of status packets of the program's own, which such a thread asks what a packet means.

use std::sync::{Mutex, PoisonError};
use std::thread;
use std::time::Duration;

use jaka_proto::wire::{Decode, DecodeError, Reader};
use jaka_sim::SimulatedClock;
use jaka_sync::jaka_motion::{Checker, Frames};
use jaka_sync::status::RobotStatus;
use jaka_sync::{
    Error, ErrorKind, FollowConfig, FollowEnd, FollowOutcome, MotionStatus, Robot, ServoConfig, StreamConfig,
};
use jaka_tests::simulated::beside;
use jaka_tests::witness::curve::apart;
use jaka_tests::{Arm, LONG};

use crate::follow::{self, to_and_fro};
use crate::received::positions;
use crate::stream;

const CYCLES: u32 = 4;
const SERVO_PERIOD: Duration = Duration::from_millis(32);

/// Packets of the test with this number.
struct Slow<const TEST: usize>(RobotStatus);

/// Next hold-up of each test's thread of set-points, with its clock.
static HOLD_UPS: [Mutex<Option<(SimulatedClock, Duration)>>; 5] = [const { Mutex::new(None) }; 5];

impl<const TEST: usize> Decode for Slow<TEST> {
    fn decode(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        RobotStatus::decode(reader).map(Self)
    }
}

impl<const TEST: usize> MotionStatus for Slow<TEST> {
    fn robot_status(&self) -> RobotStatus {
        if matches!(thread::current().name(), Some("jaka stream" | "jaka follow")) {
            let hold_up = HOLD_UPS[TEST].lock().unwrap_or_else(PoisonError::into_inner).take();
            if let Some((clock, time)) = hold_up {
                clock.sleep(time);
            }
        }
        self.0.clone()
    }
}

fn ready<const TEST: usize>() -> (Arm, Robot<Slow<TEST>>) {
    let arm = stream::arm().start();
    let monitor = arm.monitor::<Slow<TEST>>();
    let robot = Robot::with_monitor(arm.client(), monitor);
    let robot = robot.with_limits(if matches!(TEST, 0 | 3 | 4) { stream::limits() } else { follow::limits() });
    (arm, robot.expect("it is this arm"))
}

/// Holds the thread of set-points up in its next cycle, which is in time, so that the one after it is late by a period
/// less.
fn hold_up<const TEST: usize>(arm: &Arm, time: Duration) {
    *HOLD_UPS[TEST].lock().unwrap_or_else(PoisonError::into_inner) = Some((arm.clock().clone(), time));
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
    let (arm, mut robot) = ready::<0>();
    let stream = robot.stream(&StreamConfig::new().servo(servo())).expect("the arm is ready");
    stream::speed_up(&stream, arm.clock());
    hold_up::<0>(&arm, SERVO_PERIOD * 3);
    let handle = stream.handle();
    assert!(stream.wait_for_rest(LONG).is_err(), "it ends");
    let error = stream.land().expect_err("it has ended");
    assert!(matches!(error.kind(), ErrorKind::SetPointLate { late } if *late == SERVO_PERIOD * 3), "{error:?}");
    let (set_points, _) = positions(&arm, CYCLES);
    assert_held(&set_points);
    assert!(apart(&handle.joints().0, &set_points[set_points.len() - 1]) == 0.0);
}

#[test]
fn a_slow_stream_without_a_set_point_for_three_periods_goes_on_from_standstill() {
    for (held_up, goes_on) in [(SERVO_PERIOD * 4, true), (SERVO_PERIOD * 5, false)] {
        let (arm, mut robot) = ready::<4>();
        let stream = robot.stream(&StreamConfig::new().servo(servo())).expect("the arm is ready");
        // An acceleration of 72 deg/s² times a period of 32 ms is 2.3 deg/s.
        let turn = || stream.set_joint_velocity([0.0, 0.0, 0.0, 0.0, 0.0, 2.0], Duration::from_millis(500));
        turn().expect("within its speed");
        arm.clock().sleep(Duration::from_millis(300));
        hold_up::<4>(&arm, held_up);
        arm.clock().sleep(held_up + SERVO_PERIOD * 2);
        // It may have ended.
        let _ = turn();
        arm.clock().sleep(Duration::from_millis(200));
        let landed = stream.land();
        let gaps = landed.as_ref().map(|report| (report.gaps, report.longest_gap));
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

/// A run whose thread is held up on its way.
fn followed<const TEST: usize>(time: Duration) -> (Vec<[f64; 6]>, FollowEnd) {
    let (arm, mut robot) = ready::<TEST>();
    let trajectory =
        follow::trajectory(&to_and_fro(), &Checker::new(follow::limits(), Frames::new())).expect("within the limits");
    let run = robot.start_follow(&trajectory, &FollowConfig::new().servo(servo())).expect("the arm is at its start");
    follow::wait_for(&arm, &run, 0.5);
    hold_up::<TEST>(&arm, time);
    let handle = run.handle();
    let end = run.wait();
    assert_eq!((handle.progress().time, handle.progress().rate.to_bits()), (end.reached, 0.0_f64.to_bits()));
    let (set_points, _) = positions(&arm, CYCLES);
    to_and_fro().has(&set_points).unwrap_or_else(|what| panic!("{what}: {end:?}"));
    (set_points, end)
}

#[test]
fn a_set_point_that_is_too_late_is_an_underrun() {
    let late_by = Duration::from_millis(118);
    let (set_points, end) = followed::<1>(late_by);
    assert_eq!((end.outcome, end.has_left_curve, end.is_at_rest()), (FollowOutcome::Underrun, false, true), "{end:?}");
    assert_eq!((end.report.gaps, end.report.longest_gap), (1, late_by));
    let error = end.error.as_ref().expect("it says so");
    let ErrorKind::SetPointLate { late } = error.kind() else { panic!("{error:?}") };
    assert_eq!(*late, late_by);
    assert_held(&set_points);
}

#[test]
fn a_run_whose_set_point_is_late_by_less_goes_on() {
    let (set_points, end) = followed::<2>((SERVO_PERIOD * 3).saturating_sub(Duration::from_millis(1)));
    assert_eq!((end.outcome, end.has_left_curve, end.report.gaps), (FollowOutcome::Completed, false, 0), "{end:?}");
    assert!(apart(set_points.last().expect("there are some"), &to_and_fro().at(3.0)) < 1e-9);
    assert_eq!(follow::jump(follow::START, &set_points), None);
}

/// Its braking set-points go on, and the stop that waits for them does not overtake them.
#[test]
fn a_stop_waits_for_a_stream_whose_braking_is_held_up() {
    let (arm, mut robot) = ready::<3>();
    let stop = robot.stop_handle();
    let stream = robot.stream(&StreamConfig::new().servo(servo())).expect("the arm is ready");
    stream::speed_up(&stream, arm.clock());
    let held_up = || {
        arm.clock().sleep(SERVO_PERIOD * 2);
        hold_up::<3>(&arm, (SERVO_PERIOD * 3).saturating_sub(Duration::from_millis(1)));
    };
    beside(arm.clock(), held_up, || stop.stop().expect("the controller takes it"));
    let error = stream.land().expect_err("it was stopped");
    assert!(matches!(error.kind(), ErrorKind::NotAcknowledged { .. }), "{error:?}");
    let (set_points, after) = positions(&arm, CYCLES);
    // The arm stands after the last one.
    let stands = [set_points[set_points.len() - 1]; 3];
    assert_eq!(stream::jump(stream::START, &[&set_points[..], &stands].concat()), None);
    assert_eq!(after[0], "stop_program");
    let is_held_up = HOLD_UPS[3].lock().unwrap_or_else(PoisonError::into_inner).is_none();
    assert!(is_held_up, "its thread was not held up");
}
