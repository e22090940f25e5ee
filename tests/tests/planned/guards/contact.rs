//! Contact with a plane: how far the tool goes in, at each period of the packets.

use std::time::Duration;

use jaka_robot::motion::{EndMove, JointMove, MoveL};
use jaka_robot::program::StopProgram;
use jaka_robot::{Command, Error, ErrorKind, ForceComponent, ForceLimit, MotionExt as _, NotGuarded, NotShown, Robot};
use jaka_tests::LONG;
use jaka_tests::simulated::{beside, until};

use super::{CHANGE, above_a_plane, count, names};

/// Time between two packets where it is of no interest.
const PERIOD: Duration = Duration::from_millis(30);

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

fn down(speed: f64) -> MoveL {
    MoveL::relative([0.0, 0.0, -20.0, 0.0, 0.0, 0.0], speed).acceleration(BRAKING)
}

fn fz() -> ForceLimit {
    ForceLimit::new(ForceComponent::Fz, CHANGE)
}

/// Depth to which the tool goes in with the speed that is permitted.
fn penetration(period: Duration, above_mm: f64, overtravel: f64) -> f64 {
    let (arm, mut robot) = above_a_plane(period, above_mm);
    let motion = down(permitted(period, overtravel) - 1e-6);
    let end = robot.run(&motion.guard(fz().overtravel(overtravel)), LONG);
    let end = end.unwrap_or_else(|error| panic!("it is slow enough, and the sensor works: {error}"));
    let deepest = arm.deepest_penetration();
    assert!(deepest <= overtravel, "{period:?}, {above_mm} mm above: {deepest} mm");
    assert_eq!(count(&arm, StopProgram::INFO.name), 1);
    let trip = end.guarded().unwrap_or_else(|error| panic!("{period:?}, {above_mm} mm above: {error}"));
    let torque_sensor = trip.packet.status.torque_sensor.as_ref().and_then(|report| report.known());
    assert!(torque_sensor.is_some_and(|report| report.state.contact_force[2].abs() > CHANGE), "{trip:?}");
    deepest
}

#[test]
fn the_tool_goes_no_further_in_than_is_allowed_at_every_period() {
    let share = |(period_ms, overtravel): (u64, f64)| {
        let period = Duration::from_millis(period_ms);
        let at_phase = |phase: f64| {
            let above = 2.0 + phase * permitted(period, overtravel) * period.as_secs_f64();
            penetration(period, above, overtravel)
        };
        [0.0, 0.35, 0.7].into_iter().map(at_phase).fold(0.0, f64::max) / overtravel
    };
    let mut cases = vec![(8, 1.0), (16, 1.0), (30, 1.0), (30, 0.25), (50, 2.0), (100, 1.0)];
    if jaka_tests::reliability_times() > 1 {
        cases.extend((8..=100).step_by(4).map(|period_ms| (period_ms, 1.0)));
    }
    let shares: Vec<f64> = cases.into_iter().map(share).collect();
    // What is permitted is not much less than what could be: most of it is used up where a contact comes just after a
    // packet.
    assert!(shares.iter().all(|share| *share > 0.4), "{shares:?}");
}

#[test]
fn a_motion_that_is_too_fast_for_the_overtravel_or_of_unknown_speed_is_not_sent() {
    let (arm, mut robot) = above_a_plane(PERIOD, 5.0);
    let before = arm.requests().len();
    let error = robot.run(&down(400.0).guard(fz()), LONG).expect_err("it is too fast");
    let ErrorKind::NotGuarded { command, reason: NotGuarded::TooFast { speed_mm_s, permitted_mm_s, period, .. } } =
        error.kind()
    else {
        panic!("{error:?}")
    };
    assert_eq!((&**command, *speed_mm_s), (MoveL::INFO.name, 400.0));
    assert_eq!(*period, PERIOD);
    assert!((permitted_mm_s - permitted(PERIOD, 1.0)).abs() < 1e-6, "{error}");
    let text = error.to_string();
    assert!(
        text.starts_with("`moveL` was not sent under a guard: at 400 mm/s the tool moves more than 1 mm after a contact; permitted are "),
        "{text}"
    );
    let reason = |error: Error| match error.kind() {
        ErrorKind::NotGuarded { reason, .. } => *reason,
        _ => panic!("{error:?}"),
    };
    let joints = JointMove::absolute([0.0, 90.0, 90.0, 90.0, -90.0, 0.0], 1.0).acceleration(10.0);
    let end_move = EndMove::new(arm.state().tcp_pose, 1.0);
    assert_eq!(reason(robot.run(&joints.guard(fz()), LONG).expect_err("unknown")), NotGuarded::SpeedUnknown);
    assert_eq!(reason(robot.run(&end_move.guard(fz()), LONG).expect_err("unknown")), NotGuarded::SpeedUnknown);
    let unknown = MoveL::relative([0.0, 0.0, -1.0, 0.0, 0.0, 0.0], 1.0);
    assert_eq!(reason(robot.run(&unknown.guard(fz()), LONG).expect_err("unknown")), NotGuarded::BrakingUnknown);
    for limit in [fz().overtravel(0.0), fz().braking(f64::NAN), ForceLimit::new(ForceComponent::Fx, -1.0)] {
        let error = robot.run(&down(1.0).guard(limit), LONG).expect_err("it is not a limit");
        assert!(error.is_invalid_argument(), "{error:?}");
    }
    assert_eq!(arm.requests().len(), before, "{:?}", names(&arm));
}

#[test]
fn without_a_sensor_that_works_nothing_is_sent() {
    let (arm, mut robot) = above_a_plane(PERIOD, 5.0);
    let sensor = |keys: serde_json::Value| {
        arm.set_status([("torqsensor".to_owned(), keys)]);
        arm.clock().sleep(2 * PERIOD);
    };
    let not_shown = |robot: &mut Robot| {
        let error = robot.run(&down(1.0).guard(fz()), LONG).expect_err("the sensor does not work");
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
    assert_eq!(names(&arm), Vec::<String>::new());
}

#[test]
fn a_sensor_that_fails_on_the_way_stops_the_motion() {
    let (arm, mut robot) = above_a_plane(PERIOD, 5.0);
    let fail = || {
        until(arm.clock(), || !arm.state().at_rest);
        arm.set_state(|state| state.torque_sensor.working = false);
    };
    let end = beside(arm.clock(), fail, || robot.run(&down(1.0).guard(fz()), LONG)).expect("the sensor works");
    assert_eq!(count(&arm, StopProgram::INFO.name), 1, "{end:?}");
    assert!(end.guarded().is_err());
}
