//! Set-points that a program gives too late. The controller is plain sockets; each set-point has the time at which it
//! came.

use std::time::Duration;

use jaka_robot::{Client, Config, Error, ErrorKind, Monitor, Report, Robot, ServoConfig, ServoSession};
use jaka_sim::SimulatedClock;
use jaka_tests::LONG;
use jaka_tests::plain_controller::{PlainController, six};
use jaka_tests::rig::{Random, Rig};

const PERIOD: Duration = Duration::from_millis(8);

fn ready() -> (SimulatedClock, PlainController, Robot) {
    let clock = SimulatedClock::new();
    let rig = Rig::new(&mut Random::new(28));
    let controller = PlainController::by_clock(&clock, rig.bounds, [10.0, 80.0, 90.0, 70.0, -80.0, 20.0]);
    let config = Config::new().clock(&clock);
    let monitor: Monitor = Monitor::connect_with(&config, controller.status).expect("it listens");
    let client = Client::connect_with(&config, controller.commands).expect("it listens");
    monitor.wait_until(|status| status.enabled == Some(true), LONG).expect("packets come");
    (clock, controller, Robot::new(client, monitor).expect("it is the only robot"))
}

fn joint(session: &mut ServoSession<'_>, offset_deg: f64) -> Result<(), Error> {
    session.send_joint_offset([0.0, 0.0, 0.0, 0.0, 0.0, offset_deg])
}

fn tool(session: &mut ServoSession<'_>, offset_mm: f64) -> Result<(), Error> {
    session.send_pose_offset([0.0, 0.0, offset_mm, 0.0, 0.0, 0.0])
}

/// Offsets of a kind of set-points, and the one with which they begin.
struct Course {
    send: fn(&mut ServoSession<'_>, f64) -> Result<(), Error>,
    first: f64,
    then: f64,
    key: &'static str,
    index: usize,
}

/// 10 deg/s, where 5.76 is the acceleration of 720 deg/s² times a period, and 100 mm/s, where 64 is that of 8000 mm/s².
const FAST: [Course; 2] = [
    Course { send: joint, first: 0.04, then: 0.08, key: "jointPosition", index: 5 },
    Course { send: tool, first: 0.4, then: 0.8, key: "catPosition", index: 2 },
];

/// 5 deg/s, and 50 mm/s.
const SLOW: [Course; 2] = [
    Course { send: joint, first: 0.04, then: 0.04, key: "jointPosition", index: 5 },
    Course { send: tool, first: 0.4, then: 0.4, key: "catPosition", index: 2 },
];

/// Sends set-points of a motion, then one three periods late, and a few more; returns how the late one went, the
/// session's report by then, and what the controller got after the gap.
fn late(course: &Course) -> (Result<(), Error>, Report, Vec<f64>) {
    let (clock, controller, mut robot) = ready();
    let mut session = robot.enter_servo_mode(ServoConfig::new()).expect("the arm is enabled");
    (course.send)(&mut session, course.first).expect("it is sent");
    (0..20).try_for_each(|_| (course.send)(&mut session, course.then)).expect("they are sent");
    let paused_at = clock.now();
    // The next one is due after a period.
    clock.sleep(PERIOD * 4);
    let sent = (course.send)(&mut session, course.then);
    let report = session.report().clone();
    drop(session);
    // Replies of the landing have been read by then.
    clock.sleep(PERIOD);
    let after = controller.timed_motions().into_iter().filter(|(at, _)| *at > paused_at);
    (sent, report, after.map(|(_, request)| six(&request[course.key])[course.index]).collect())
}

#[test]
fn one_late_set_point_at_speed_ends_the_session_and_is_named() {
    for course in FAST {
        let (sent, report, after) = late(&course);
        let error = sent.expect_err("the arm was at speed");
        assert!(matches!(error.kind(), ErrorKind::SetPointLate { late } if *late == PERIOD * 3), "{error:?}");
        assert_eq!(
            error.kind().to_string(),
            "a set-point was too late, by 24.0ms: the machine was too busy to send it in time"
        );
        assert!(!error.may_have_run());
        assert_eq!((report.cycles, report.gaps, report.longest_gap), (21, 1, PERIOD * 3));
        assert!(report.landing_cycles > 0, "{report:?}");
        // It is held where it is: nothing brakes a motion that is over.
        assert!(!after.is_empty() && after.iter().all(|offset| *offset == 0.0), "{after:?}");
    }
}

#[test]
fn a_slow_arm_goes_on_after_a_gap() {
    for course in SLOW {
        let (sent, report, after) = late(&course);
        sent.expect("from standstill it is within the acceleration");
        assert_eq!((report.cycles, report.gaps, report.longest_gap), (22, 1, PERIOD * 3));
        assert!((after[0] - course.then).abs() < 1e-12, "{after:?}");
    }
}

#[test]
fn a_gap_just_too_short_is_none() {
    let (clock, _controller, mut robot) = ready();
    let mut session = robot.enter_servo_mode(ServoConfig::new()).expect("the arm is enabled");
    joint(&mut session, 0.04).expect("it is sent");
    for _ in 0..5 {
        joint(&mut session, 0.08).expect("it is sent");
        clock.sleep((PERIOD * 4).saturating_sub(Duration::from_millis(1)));
    }
    let report = session.land().expect("it lands").report;
    assert_eq!((report.gaps, report.longest_gap, report.late_cycles), (0, Duration::ZERO, 4));
}
