//! Motions under a guard: what happens between arming the guard, sending the motion, and the end.

use std::panic::resume_unwind;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use jaka_proto::wire::{Decode, DecodeError, Reader};
use jaka_robot::motion::MoveL;
use jaka_robot::status::RobotStatus;
use jaka_robot::{
    Cause, ErrorKind, Evidence, ForceComponent, ForceLimit, Guard, InputCondition, MotionExt as _, MotionStatus,
    Occurrence, Robot,
};
use jaka_sim::{Controller, Fault, Port};
use jaka_tests::simulated::beside;
use jaka_tests::{Arm, LONG};

use super::{FAR, Hooked, IO, PERIOD, arm, assert_moves, assert_stopped_on_the_way, changes, names, refusal, to};

fn input() -> InputCondition {
    IO.cabinet(1).is_high()
}

fn set_high(controller: &Controller) {
    controller.set_state(|state| state.digital_inputs[0] = true);
}

/// Sets the input once the arm moves.
fn set_high_on_the_way(arm: &Arm) {
    arm.when(|state| state.joint_position.0[0] > 5.0, set_high).expect("a thread starts");
}

/// `Armed::let_out` alone keeps the motion back, and has the monitor's thread write no stop for a motion that has not
/// begun.
#[test]
fn a_guard_that_trips_after_it_was_armed_and_before_the_motion_goes_out_sends_nothing() {
    let (arm, mut robot) = arm().with_robot();
    let trips = || {
        set_high(&arm);
        arm.clock().sleep(3 * PERIOD);
    };
    let motion = Hooked { before_sending: &trips, ..Hooked::default() };
    let end = robot.run(&motion.guard(input()), LONG).expect("that is an end");
    let Evidence::Trip(trip) = end.evidence() else { panic!("{:?}", end.cause()) };
    assert!(trip.is_before_start && end.stop.is_none(), "{:?}", end.cause());
    assert_eq!(names(&arm), [""; 0]);
}

/// The gate of all motions asks for a fresh packet, which has come again: `Armed::let_out` alone remembers the silence.
#[test]
fn a_status_that_was_silent_after_the_guard_was_armed_sends_nothing_also_when_packets_come_again() {
    let (arm, mut robot) = arm().with_robot();
    let falls_silent = || {
        arm.link(Port::Status).to_client().hold();
        arm.clock().sleep(Duration::from_secs(2));
        arm.link(Port::Status).to_client().release();
        arm.clock().sleep(Duration::from_secs(2));
    };
    let motion = Hooked { before_sending: &falls_silent, ..Hooked::default() };
    let error = robot.run(&motion.guard(input()), LONG).expect_err("the guard was not judged for a while");
    assert!(matches!(error.kind(), ErrorKind::StatusUnknown { .. }), "{error:?}");
    assert_eq!(names(&arm), [""; 0]);
    // Packets have come again: nothing keeps back the next one.
    assert_moves(&mut robot);
}

/// A motion whose reply is outstanding keeps the monitor's thread from writing the stop; the guard's own thread writes
/// it.
#[test]
fn a_stop_that_could_not_be_written_at_once_leaves_nothing_to_acknowledge() {
    let (arm, mut robot) = arm().with_robot();
    arm.inject_for("joint_move", Fault::Hold);
    set_high_on_the_way(&arm);
    let end = robot.run(&to(FAR).guard(input()), LONG).expect("the reply comes with that to the stop");
    assert!(end.cause() == Cause::Guard && matches!(end.stop, Some(Ok(()))), "{:?}", end.cause());
    assert_stopped_on_the_way(&arm);
    assert!(robot.unacknowledged().is_none(), "the end has reported the only stop: {:?}", robot.unacknowledged());
    assert_moves(&mut robot);
}

#[test]
fn a_motion_under_a_guard_whose_reply_does_not_come_is_stopped() {
    for is_refused in [false, true] {
        let (arm, mut robot) = arm().with_robot();
        arm.inject_for("joint_move", Fault::Drop);
        if is_refused {
            arm.inject_for("stop_program", refusal("stop_program"));
        }
        let error = robot.run(&to(FAR).guard(input()), Duration::from_secs(1)).expect_err("no reply comes");
        assert_eq!(matches!(error.kind(), ErrorKind::NotStopped { .. }), is_refused, "{error:?}");
        assert!(error.may_have_run(), "{error:?}");
        assert_eq!(changes(&arm), ["joint_move", "stop_program"]);
        arm.clock().sleep(Duration::from_secs(1));
        assert_stopped_on_the_way(&arm);
    }
}

/// Nobody judges the guard after the end, and the arm goes on.
#[test]
fn an_error_of_the_controller_under_a_guard_stops_the_arm() {
    let (arm, mut robot) = arm().with_robot();
    let fails = |controller: &Controller| {
        controller.set_state(|state| "0x0F0034".clone_into(&mut state.error_code));
    };
    arm.when(|state| state.joint_position.0[0] > 5.0, fails).expect("a thread starts");
    let end = robot.run(&to(FAR).guard(input()), LONG).expect("the motion is accepted");
    assert!(end.cause() == Cause::ControllerError && matches!(end.stop, Some(Ok(()))), "{:?}", end.cause());
    assert_eq!(changes(&arm), ["joint_move", "stop_program"]);
    arm.clock().sleep(Duration::from_secs(1));
    assert_stopped_on_the_way(&arm);
}

/// The stop was accepted; the position is refused.
#[test]
fn rest_that_the_controller_does_not_confirm_is_not_told_after_a_trip() {
    let (arm, mut robot) = arm().with_robot();
    arm.inject_for("joint_move", Fault::None);
    arm.inject_for("stop_program", Fault::None);
    arm.inject_always(refusal("get_joint_pos"));
    set_high_on_the_way(&arm);
    let end = robot.run(&to(FAR).guard(input()), LONG).expect("the motion is accepted");
    assert!(matches!(end.evidence(), Evidence::Trip(trip) if !trip.is_at_rest), "{:?}", end.cause());
    assert!(matches!(end.stop, Some(Ok(()))), "{:?}", end.cause());
    // It is asked for two seconds, and not without a pause.
    let asked = names(&arm).iter().filter(|name| *name == "get_joint_pos").count();
    assert!((2..=40).contains(&asked), "{asked} queries");
}

#[test]
fn the_condition_that_has_held_first_is_told() {
    let (arm, mut robot) = arm().with_robot();
    let guard = Guard::from(input()).or(IO.cabinet(2).is_high());
    let trips = || {
        arm.set_state(|state| state.digital_inputs[1] = true);
        arm.clock().sleep(3 * PERIOD);
        set_high(&arm);
        arm.clock().sleep(3 * PERIOD);
    };
    let motion = Hooked { before_sending: &trips, ..Hooked::default() };
    let end = robot.run(&motion.guard(guard), LONG).expect("that is an end");
    let Evidence::Trip(trip) = end.evidence() else { panic!("{:?}", end.cause()) };
    assert_eq!(trip.condition, 1, "{trip}");
}

/// Under a limit of force packets may stay away for three periods, and 100 ms at least; without one, for half a second.
#[test]
fn without_packets_in_time_a_motion_under_a_limit_of_force_is_stopped() {
    let (arm, mut robot) = arm().with_robot();
    arm.set_state(|state| state.torque_sensor.working = true);
    arm.clock().sleep(Duration::from_secs(1));
    let limit = ForceLimit::new(ForceComponent::Force, 5.0).overtravel(1.0);
    let down = MoveL::relative([0.0, 0.0, -50.0, 0.0, 0.0, 0.0], 5.0).acceleration(500.0);
    let (clock, silent_from) = (arm.clock(), Duration::from_secs(2));
    let falls_silent = || {
        clock.sleep(silent_from);
        arm.link(Port::Status).to_client().hold();
    };
    let end = beside(clock, falls_silent, || robot.run(&down.guard(limit), LONG)).expect("it is slow enough");
    assert!(end.cause() == Cause::StatusLost && matches!(end.stop, Some(Ok(()))), "{:?}", end.cause());
    let took = end.report.waited.saturating_sub(silent_from);
    assert!(took < Duration::from_millis(200), "{took:?}");
}

/// The deadline comes while the stop of the guard waits for its reply: the end waits for that, and tells it.
#[test]
fn a_deadline_waits_for_the_reply_to_the_stop_of_a_guard() {
    let (arm, mut robot) = arm().with_robot();
    let delay = Duration::from_secs(1);
    arm.inject_for("stop_program", Fault::Delay(delay));
    let (tripped, deadline) = (Duration::from_millis(1900), Duration::from_secs(2));
    let trips = || {
        arm.clock().sleep(tripped);
        set_high(&arm);
    };
    let since = arm.clock().elapsed();
    let end = beside(arm.clock(), trips, || robot.run(&to(FAR).guard(input()), deadline));
    let took = arm.clock().elapsed().saturating_sub(since);
    let end = end.expect("the motion is accepted");
    assert!(end.cause() == Cause::Guard && matches!(end.stop, Some(Ok(()))), "{:?}", end.cause());
    assert!(took >= tripped + delay, "{took:?}");
    assert_eq!(changes(&arm), ["joint_move", "stop_program"]);
}

/// Packets of a type of the program's own, whose code panics while this is set.
struct Odd(RobotStatus);

static PANICS: AtomicBool = AtomicBool::new(false);

impl Decode for Odd {
    fn decode(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        RobotStatus::decode(reader).map(Self)
    }
}

impl MotionStatus for Odd {
    fn robot_status(&self) -> RobotStatus {
        if PANICS.load(Ordering::SeqCst) {
            resume_unwind(Box::new("as it should"));
        }
        self.0.clone()
    }
}

/// Such a packet may have shown a stop. It is guarded twice: the latch keeps all motions back, `Armed::let_out` this
/// one.
#[test]
fn a_packet_that_nobody_could_judge_keeps_motions_back() {
    let arm = arm().start();
    let monitor = arm.monitor::<Odd>();
    let mut robot = Robot::<Odd>::with_monitor(arm.client(), monitor).expect("it is the only robot");
    let panics = || {
        PANICS.store(true, Ordering::SeqCst);
        arm.clock().sleep(3 * PERIOD);
        PANICS.store(false, Ordering::SeqCst);
        arm.clock().sleep(3 * PERIOD);
    };
    let motion = Hooked { before_sending: &panics, ..Hooked::default() };
    let error = robot.run(&motion.guard(input()), LONG).expect_err("a packet was not judged");
    assert!(matches!(error.kind(), ErrorKind::NotAcknowledged { .. } | ErrorKind::StatusUnknown { .. }), "{error:?}");
    // Without a guard, too.
    let error = robot.start(&to(FAR)).expect_err("a packet was not read");
    assert!(
        matches!(error.kind(), ErrorKind::NotAcknowledged { occurrence: Occurrence { cause: Cause::StatusLost, .. } }),
        "{error:?}"
    );
    assert_eq!(names(&arm), [""; 0]);
    robot.acknowledge();
    robot.start(&to(FAR)).expect("somebody has looked");
}
