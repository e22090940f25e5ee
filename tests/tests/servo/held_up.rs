//! Threads of set-points that are held up. By simulated clocks they are late only where something takes their time:
//! here, a type of status packets of the program's own, which such a thread asks what a packet means.

use std::sync::{Mutex, PoisonError};
use std::thread;
use std::time::Duration;

use jaka_proto::wire::{Decode, DecodeError, Reader};
use jaka_sim::SimulatedClock;
use jaka_sync::jaka_motion::{Checker, Frames};
use jaka_sync::status::RobotStatus;
use jaka_sync::{ErrorKind, FollowConfig, FollowEnd, FollowOutcome, MotionStatus, Robot, ServoConfig, StreamConfig};
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
static HOLD_UPS: [Mutex<Option<(SimulatedClock, Duration)>>; 4] = [const { Mutex::new(None) }; 4];

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
    let robot = robot.with_limits(if matches!(TEST, 0 | 3) { stream::limits() } else { follow::limits() });
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

#[test]
fn a_stream_without_a_set_point_for_three_periods_begins_again_from_standstill() {
    let (arm, mut robot) = ready::<0>();
    let stream = robot.stream(&StreamConfig::new().servo(servo())).expect("the arm is ready");
    stream::speed_up(&stream, arm.clock());
    hold_up::<0>(&arm, SERVO_PERIOD * 4);
    assert!(stream.wait_for_rest(LONG).expect("it goes on"));
    let report = stream.land().expect("it comes to rest");
    assert_eq!((report.gaps, report.late_cycles, report.lateness(1.0)), (1, 1, SERVO_PERIOD * 3));
    let (set_points, _) = positions(&arm, CYCLES);
    let stood = stream::jump(stream::START, &set_points).expect("it was at speed");
    assert_eq!(stream::jump(set_points[stood - 1], &set_points[stood..]), None);
}

/// A run whose thread is held up on its way.
fn followed<const TEST: usize>(time: Duration) -> (Vec<[f64; 6]>, FollowEnd) {
    let (arm, mut robot) = ready::<TEST>();
    let trajectory =
        follow::trajectory(&to_and_fro(), &Checker::new(follow::limits(), Frames::new())).expect("within the limits");
    let run = robot.start_follow(&trajectory, &FollowConfig::new().servo(servo())).expect("the arm is at its start");
    follow::wait_for(&arm, &run, 0.5);
    hold_up::<TEST>(&arm, time);
    let end = run.wait();
    let (set_points, _) = positions(&arm, CYCLES);
    to_and_fro().has(&set_points).unwrap_or_else(|what| panic!("{what}: {end:?}"));
    (set_points, end)
}

#[test]
fn a_run_without_a_set_point_for_three_periods_goes_on_from_standstill() {
    let (set_points, end) = followed::<1>(SERVO_PERIOD * 4);
    assert_eq!((end.outcome, end.has_left_curve, end.report.gaps), (FollowOutcome::Completed, false, 1), "{end:?}");
    assert!(apart(set_points.last().expect("there are some"), &to_and_fro().at(3.0)) < 1e-9);
    let stood = follow::jump(follow::START, &set_points).expect("it was at speed");
    assert_eq!(follow::jump(set_points[stood - 1], &set_points[stood..]), None);
}

#[test]
fn a_set_point_that_is_too_late_is_an_underrun() {
    let late_by = Duration::from_millis(118);
    let (_, end) = followed::<2>(SERVO_PERIOD + late_by);
    assert_eq!((end.outcome, end.has_left_curve, end.is_at_rest()), (FollowOutcome::Underrun, false, true), "{end:?}");
    let error = end.error.as_ref().expect("it says so");
    let ErrorKind::SetPointLate { late } = error.kind() else { panic!("{error:?}") };
    assert_eq!(*late, late_by);
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
        hold_up::<3>(&arm, SERVO_PERIOD * 3);
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
