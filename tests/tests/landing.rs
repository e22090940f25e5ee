//! How servo sessions end while the arm moves: what the controller receives, read as JSON and differenced by index.

use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::mpsc;
use std::thread;
use std::time::{Duration, Instant};

use jaka_sim::{Builder, Controller, Delays, Fault, Port, Trip, Underrun};
use jaka_sync::types::Pose;
use jaka_sync::{Config, Error, ErrorKind, Robot, ServoConfig, ServoSession};
use serde_json::Value;

const LONG: Duration = Duration::from_secs(60);
/// Four cycles, so that a busy machine seldom leaves the arm without a set-point for three periods.
const CYCLES: u32 = 4;
const PERIOD: f64 = 0.032;

/// What the checks allow, and what the ramps here ask for, in deg/s².
const MOST: f64 = 720.0;
const ASKED: f64 = 600.0;

/// The last speed of a ramp is 115 deg/s, which takes five periods to brake.
const STEPS: u32 = 6;

fn ready() -> (Controller, Robot) {
    ready_with(&Config::new().stale_after(LONG))
}

fn ready_with(config: &Config) -> (Controller, Robot) {
    ready_of(Controller::builder(), config)
}

fn ready_of(builder: Builder, config: &Config) -> (Controller, Robot) {
    let controller = builder.delays(Delays::NONE).status_period(Duration::from_millis(10)).start();
    let controller = controller.expect("loopback has free ports");
    controller.set_state(|state| {
        state.powered = true;
        state.enabled = true;
    });
    let monitor = config.connect_monitor(controller.status_addr()).expect("the controller listens");
    let client = config.connect_client(controller.command_addr()).expect("the controller listens");
    (controller, Robot::new(client, monitor))
}

fn patient() -> ServoConfig {
    ServoConfig::new().step_count(CYCLES).max_unanswered(LONG).rest_timeout(LONG)
}

/// Goes faster by the same each period. False where the machine is so busy that the arm has had no set-points meanwhile, and stands: then
/// the next one is refused.
fn speed_up(session: &mut ServoSession<'_>) -> bool {
    let most = ASKED * PERIOD * PERIOD;
    (1..=STEPS).all(|n| match session.send_joint_offset([0.0, 0.0, f64::from(n) * most, 0.0, 0.0, 0.0]) {
        Ok(()) => true,
        Err(error) => {
            assert!(error.to_string().contains("from standstill"), "{error}");
            false
        }
    })
}

/// The steps of joint 3, and nothing else that moves, in the order in which they came; and the names of what came after the last of them.
fn steps(controller: &Controller) -> (Vec<f64>, Vec<String>) {
    let requests: Vec<Value> =
        controller.requests().iter().map(|text| serde_json::from_str(text).expect("requests are JSON")).collect();
    let is_set_point = |request: &Value| request["cmdName"] == "servo_j";
    let last = requests.iter().rposition(is_set_point).expect("set-points came");
    let step = |request: &Value| {
        assert_eq!(request["relFlag"], 1);
        request["jointPosition"][2].as_f64().expect("a number")
    };
    let name = |request: &Value| request["cmdName"].as_str().expect("a name").to_owned();
    (
        requests.iter().filter(|request| is_set_point(request)).map(step).collect(),
        requests[last + 1..].iter().map(name).collect(),
    )
}

/// No speed changes faster than it may, and the last one is none. The distance of the landing, in degrees; none where the machine was so
/// busy in the middle of it that the arm was without set-points, and stands.
fn braked(steps: &[f64]) -> Option<f64> {
    let fastest = f64::from(STEPS) * ASKED * PERIOD * PERIOD;
    let begins = steps.iter().rposition(|step| (step - fastest).abs() < 1e-9).expect("it was fast");
    let holds = steps.iter().rposition(|step| *step > MOST * PERIOD * PERIOD + 1e-9).expect("it was fast");
    if holds >= begins && steps[holds + 1] == 0.0 {
        return None;
    }
    let changes = steps.windows(2).map(|two| (two[1] - two[0]).abs() / PERIOD / PERIOD);
    let worst = changes.fold(0.0, f64::max);
    assert!(worst <= MOST * (1.0 + 1e-6), "{worst} deg/s²: {steps:?}");
    assert_eq!(steps.last(), Some(&0.0), "{steps:?}");
    Some(steps[begins + 1..].iter().sum())
}

/// Tries until the machine is quick enough for a ramp.
fn at_speed(mut end: impl FnMut(&Controller, &mut Robot) -> bool) {
    at_speed_with(ready, |controller, robot| end(controller, robot));
}

fn at_speed_with(make: impl Fn() -> (Controller, Robot), mut end: impl FnMut(&Controller, &mut Robot) -> bool) {
    for _ in 0..50 {
        let (controller, mut robot) = make();
        if end(&controller, &mut robot) {
            return;
        }
    }
    panic!("the machine is too busy for a ramp of 0.1 s");
}

#[test]
fn a_session_that_lands_at_speed_brakes_and_holds_the_arm() {
    at_speed(|controller, robot| {
        let mut session = robot.enter_servo_mode(&patient()).expect("the arm is enabled");
        if !speed_up(&mut session) {
            return false;
        }
        let report = session.land().expect("it comes to rest");
        let (steps, after) = steps(controller);
        // From v in N periods: v T (N - 1) / 2.
        let (speed, periods) = (f64::from(STEPS) * ASKED * PERIOD, f64::from(STEPS) * ASKED / MOST);
        let Some(distance) = braked(&steps) else { return false };
        assert!((distance - speed * PERIOD * (periods.ceil() - 1.0) / 2.0).abs() < 1e-9, "{steps:?}");
        assert_eq!(report.cycles + report.landing_cycles, steps.len() as u64);
        assert_eq!(after[0], "servo_move");
        assert!(!controller.state().servo_mode);
        true
    });
}

#[test]
fn a_session_that_is_dropped_or_unwinds_at_speed_lands() {
    for panics in [false, true] {
        at_speed(|controller, robot| {
            let mut was_quick = false;
            let end = catch_unwind(AssertUnwindSafe(|| {
                let mut session = robot.enter_servo_mode(&patient()).expect("the arm is enabled");
                was_quick = speed_up(&mut session);
                if panics {
                    // Without a message, which takes longer than the arm may be without set-points.
                    resume_unwind(Box::new("a bug in the user's program"));
                }
            }));
            assert_eq!(end.is_err(), panics);
            if !was_quick {
                return false;
            }
            assert!(!controller.state().servo_mode);
            braked(&steps(controller).0).is_some()
        });
    }
}

#[test]
fn a_set_point_that_is_refused_at_speed_ends_in_a_landing() {
    at_speed(|controller, robot| {
        let mut session = robot.enter_servo_mode(&patient()).expect("the arm is enabled");
        if !speed_up(&mut session) {
            return false;
        }
        let error = session.send_joint_offset([0.0; 6]).expect_err("it would stop at once");
        let text = error.to_string();
        if text.contains("from standstill") {
            return false;
        }
        assert!(error.is_invalid_argument() && text.contains("differs by 3.686 deg from the step before"), "{text}");
        assert!(text.contains("(720 deg/s²)"), "{text}");
        assert!(!controller.state().servo_mode);
        let next = session.send_joint_offset([0.0; 6]).expect_err("it has ended");
        assert!(matches!(next.kind(), ErrorKind::SessionEnded { .. }), "{next:?}");
        braked(&steps(controller).0).is_some()
    });
}

#[test]
fn a_stop_of_the_program_brakes_first_and_nothing_goes_out_after_it() {
    at_speed(|controller, robot| {
        let stop = robot.stop_handle();
        let (fast, is_fast) = mpsc::channel();
        let was_quick = thread::scope(|scope| {
            let stopping = scope.spawn(move || is_fast.recv().is_ok_and(|()| stop.stop().is_ok()));
            let mut session = robot.enter_servo_mode(&patient()).expect("the arm is enabled");
            if !speed_up(&mut session) {
                drop(fast);
                return false;
            }
            fast.send(()).expect("the other thread waits");
            let speed = f64::from(STEPS) * ASKED * PERIOD * PERIOD;
            let error = loop {
                if let Err(error) = session.send_joint_offset([0.0, 0.0, speed, 0.0, 0.0, 0.0]) {
                    break error;
                }
            };
            assert!(stopping.join().expect("no panic"), "the controller takes the stop");
            assert!(!matches!(error.kind(), ErrorKind::RestNotSeen { .. }), "{error:?}");
            // Where the machine was busy, it stood.
            matches!(error.kind(), ErrorKind::NotAcknowledged { .. })
        });
        if was_quick {
            let (steps, after) = steps(controller);
            let last = steps.last().expect("there are some");
            if *last > MOST * PERIOD * PERIOD + 1e-9 {
                // It was not braked: only where the machine was too busy for it.
                return false;
            }
            assert!(steps.windows(2).all(|two| (two[1] - two[0]).abs() <= MOST * PERIOD * PERIOD + 1e-9), "{steps:?}");
            assert!(after.contains(&"stop_program".to_owned()), "{after:?}");
        }
        was_quick
    });
}

#[test]
fn a_stop_does_not_wait_for_a_session_whose_thread_is_held_up() {
    let (controller, mut robot) = ready();
    let stop = robot.stop_handle();
    let mut session = robot.enter_servo_mode(&patient()).expect("the arm is enabled");
    speed_up(&mut session);
    // This thread does nothing more for the session.
    let since = Instant::now();
    thread::spawn(move || stop.stop()).join().expect("no panic").expect("the controller takes the stop");
    assert!(controller.requests().iter().any(|request| request.contains("stop_program")));
    // Less than a session may take to brake.
    assert!(since.elapsed() < Duration::from_secs(2), "{:?}", since.elapsed());
    let before = steps(&controller).0.len();
    let error = session.send_joint_offset([0.0; 6]).expect_err("it was stopped");
    assert!(matches!(error.kind(), ErrorKind::NotAcknowledged { .. } | ErrorKind::SessionEnded { .. }), "{error:?}");
    drop(session);
    assert_eq!(steps(&controller).0.len(), before, "a set-point went out after the stop");
}

#[test]
fn a_landing_ends_at_rest_on_an_arm_that_lags_whatever_it_does_without_set_points() {
    for underrun in [Underrun::Hold, Underrun::Fault(Duration::from_millis(500))] {
        let make = || {
            // Its drives fault at twice what is sent, and where the arm is left alone at speed.
            let drives = [Trip::CommandAcceleration(2.0 * MOST), Trip::CommandSpeed(180.0)];
            let builder = Controller::builder().lag(Duration::from_millis(80)).underrun(underrun).trips(drives);
            ready_of(builder, &Config::new().stale_after(LONG))
        };
        at_speed_with(make, |controller, robot| {
            let start = controller.state().joint_position.0[2];
            let config = patient().rest_timeout(Duration::from_secs(10));
            let mut session = robot.enter_servo_mode(&config).expect("the arm is enabled");
            if !speed_up(&mut session) {
                return false;
            }
            let landed = session.land();
            let (steps, _) = steps(controller);
            if braked(&steps).is_none() {
                return false;
            }
            landed.expect("it comes to rest");
            let state = controller.state();
            let moved: f64 = steps.iter().sum();
            // Seen at rest, not only told to be: the arm lags by 9 deg at full speed.
            assert!((state.joint_position.0[2] - start - moved).abs() <= 0.1, "{underrun:?}: {state:?}");
            assert!(!state.servo_mode && state.enabled, "{underrun:?}: {state:?}");
            true
        });
    }
}

#[test]
fn a_stop_goes_out_in_time_though_the_arm_brakes_slowly_and_no_set_point_after_it() {
    let (controller, mut robot) = ready();
    let stop = robot.stop_handle();
    // From 100 deg/s with 20 deg/s²: five seconds.
    let config = patient().unchecked().max_joint_acceleration(20.0);
    let jump = 100.0 * PERIOD;
    thread::scope(|scope| {
        let (moving, is_moving) = mpsc::channel();
        let stopping = scope.spawn(move || {
            let since = is_moving.recv().map(|()| Instant::now());
            stop.stop().map(|()| since.map(|since| since.elapsed()))
        });
        let mut session = robot.enter_servo_mode(&config).expect("the arm is enabled");
        session.send_joint_offset([0.0, 0.0, jump, 0.0, 0.0, 0.0]).expect("it is sent");
        session.send_joint_offset([0.0, 0.0, -jump, 0.0, 0.0, 0.0]).expect("it is sent");
        moving.send(()).expect("the other thread waits");
        let error = (0..1000)
            .find_map(|n| {
                session.send_joint_offset([0.0, 0.0, if n % 2 == 0 { jump } else { -jump }, 0.0, 0.0, 0.0]).err()
            })
            .expect("it is stopped");
        drop(session);
        assert!(error.may_have_run() || matches!(error.kind(), ErrorKind::NotAcknowledged { .. }), "{error:?}");
        let took = stopping.join().expect("no panic").expect("the controller takes it").expect("it was moving");
        assert!(took < Duration::from_secs(30), "{took:?}");
    });
    let after = controller.requests().into_iter().skip_while(|request| !request.contains("stop_program"));
    assert!(!after.into_iter().any(|request| request.contains("servo_j")), "a set-point went out after the stop");
    assert!(!controller.state().servo_mode);
}

#[test]
fn a_refusal_that_comes_during_the_landing_is_told() {
    let (controller, mut robot) = ready();
    let mut session = robot.enter_servo_mode(&patient()).expect("the arm is enabled");
    // Of all set-points this one alone is refused.
    controller
        .inject_for("servo_j", Fault::Instead(br#"{"errorCode":"3","errorMsg":"no","cmdName":"servo_j"}"#.to_vec()));
    session.send_joint_offset([0.0, 0.0, 0.1, 0.0, 0.0, 0.0]).expect("it is sent");
    let error = session.land().expect_err("it was refused");
    assert!(error.is_refused(), "{error:?}");
    assert!(!controller.state().servo_mode);
}

#[test]
fn a_jump_that_no_arm_makes_is_not_taken_for_a_speed() {
    let (controller, mut robot) = ready();
    let mut session = robot
        .enter_servo_mode(&patient().unchecked().rest_timeout(Duration::from_millis(200)))
        .expect("the arm is enabled");
    session.send_joint_offset([0.0, 0.0, 1.0, 0.0, 0.0, 0.0]).expect("it is sent");
    session.send_joint_offset([0.0, 0.0, 8.0, 0.0, 0.0, 0.0]).expect("it is sent, and a filter may smooth it");
    drop(session);
    let (steps, _) = steps(&controller);
    assert_eq!(steps[..2], [1.0, 8.0]);
    assert!(steps[2..].iter().all(|step| *step == 0.0), "{steps:?}");
}

#[test]
fn a_way_that_is_not_known_is_not_gone() {
    let (controller, mut robot) = ready();
    let pose = controller.state().tcp_pose;
    let mut session = robot.enter_servo_mode(&patient()).expect("the arm is enabled");
    session.send_pose(Pose { z: pose.z + 0.5, ..pose }).expect("a small step");
    let error = session.send_joints(controller.state().joint_position).expect_err("where the joints are is not known");
    assert!(error.to_string().contains("whose distance from the one before is not known"), "{error}");
    assert!(!controller.requests().iter().any(|request| request.contains("servo_j")));
}

#[test]
fn a_status_that_is_no_longer_known_ends_in_a_landing() {
    at_speed_with(
        || ready_with(&Config::new().stale_after(Duration::from_millis(500))),
        |controller, robot| {
            let Ok(mut session) = robot.enter_servo_mode(&patient()) else { return false };
            if !speed_up(&mut session) {
                return false;
            }
            controller.link(Port::Status).to_client().hold();
            let step = f64::from(STEPS) * ASKED * PERIOD * PERIOD;
            let error = loop {
                if let Err(error) = session.send_joint_offset([0.0, 0.0, step, 0.0, 0.0, 0.0]) {
                    break error;
                }
            };
            if error.to_string().contains("from standstill") {
                return false;
            }
            assert!(matches!(error.kind(), ErrorKind::StatusUnknown { .. }), "{error:?}");
            assert!(!controller.state().servo_mode);
            braked(&steps(controller).0).is_some()
        },
    );
}

#[test]
fn a_protective_stop_ends_the_session_without_a_landing() {
    at_speed(|controller, robot| {
        let mut session = robot.enter_servo_mode(&patient()).expect("the arm is enabled");
        if !speed_up(&mut session) {
            return false;
        }
        controller.collide();
        let step = f64::from(STEPS) * ASKED * PERIOD * PERIOD;
        let error = loop {
            if let Err(error) = session.send_joint_offset([0.0, 0.0, step, 0.0, 0.0, 0.0]) {
                break error;
            }
        };
        if error.is_invalid_argument() {
            return false;
        }
        drop(session);
        // A refusal may be seen before the packet with the stop; one set-point may be on its way by then.
        let (steps, _) = steps(controller);
        let braking = steps.iter().skip(STEPS as usize).filter(|sent| (**sent - step).abs() > 1e-9).count();
        assert!(braking <= 2, "{error:?}: {steps:?}");
        true
    });
}

#[test]
fn rest_that_no_packet_shows_is_an_error_that_says_so() {
    let (_controller, mut robot) = ready();
    let config = patient().rest_timeout(Duration::ZERO);
    let mut session = robot.enter_servo_mode(&config).expect("the arm is enabled");
    session.send_joint_offset([0.001; 6]).expect("a small step");
    let error = session.land().expect_err("nothing was seen");
    assert!(matches!(error.kind(), ErrorKind::RestNotSeen { first: None, .. }), "{error:?}");
    assert!(error.may_have_run());
    let mut session = robot.enter_servo_mode(&config).expect("the arm is enabled");
    session.send_joint_offset([0.001; 6]).expect("a small step");
    let error = session.send_joint_offset([10.0; 6]).expect_err("too fast");
    let ErrorKind::RestNotSeen { first: Some(first), .. } = error.kind() else { panic!("{error:?}") };
    assert!(first.is_invalid_argument() && error.to_string().starts_with(&first.to_string()), "{error}");
}

#[test]
fn set_points_that_are_poses_are_compared_and_braked_along_their_line() {
    at_speed(|controller, robot| {
        let start = controller.state().tcp_pose;
        let mut session = robot.enter_servo_mode(&patient()).expect("the arm is enabled");
        let (mut pose, mut step) = (start, [0.0, 0.0]);
        for _ in 0..5 {
            // 188 mm/s and 16 deg/s more each period.
            step = [step[0] + 6.0, step[1] + 0.5];
            pose = Pose { z: pose.z + step[0], rz: pose.rz + step[1], ..pose };
            match session.send_pose(pose) {
                Ok(()) => {}
                Err(error) if error.to_string().contains("from standstill") => return false,
                Err(error) => panic!("{error}"),
            }
        }
        let error = session.send_pose(Pose { z: pose.z + 100.0, ..pose }).expect_err("3125 mm/s");
        let text = error.to_string();
        assert!(text.contains("field `pose` is a step of 100.000 mm") && text.contains("(3000 mm/s)"), "{text}");
        let poses: Vec<[f64; 6]> = controller
            .requests()
            .iter()
            .map(|text| serde_json::from_str::<Value>(text).expect("requests are JSON"))
            .filter(|request| request["cmdName"] == "servo_p")
            .map(|request| std::array::from_fn(|index| request["catPosition"][index].as_f64().expect("a number")))
            .collect();
        let all = [start.into(), start.into()].into_iter().chain(poses.iter().copied()).collect::<Vec<[f64; 6]>>();
        for three in all.windows(3) {
            let change = |axis: usize| (three[2][axis] - 2.0 * three[1][axis] + three[0][axis]) / PERIOD / PERIOD;
            assert!(change(2).abs() <= 8000.0 * (1.0 + 1e-6), "{} mm/s²", change(2));
            assert!(change(5).abs() <= 2160.0 * (1.0 + 1e-6), "{} deg/s²", change(5));
            assert!((three[2][0] - start.x).abs() < 1e-6 && (three[2][1] - start.y).abs() < 1e-6, "off its line");
        }
        assert!(poses.len() > 5 && poses.last() == poses.get(poses.len() - 2), "{poses:?}");
        true
    });
}

#[test]
fn set_points_may_jump_where_the_program_says_so() -> Result<(), Error> {
    let (controller, mut robot) = ready();
    let mut session = robot.enter_servo_mode(&patient().unchecked())?;
    for _ in 0..5 {
        session.send_joint_offset([0.0, 0.0, 0.8, 0.0, 0.0, 0.0])?;
    }
    let report = session.land()?;
    let (steps, _) = steps(&controller);
    assert_eq!(steps[..5], [0.8; 5]);
    if report.gaps == 0 {
        // Braked all the same, by 720 deg/s² at most.
        assert!(steps[4..].windows(2).all(|two| (two[1] - two[0]).abs() <= MOST * PERIOD * PERIOD + 1e-9), "{steps:?}");
    }
    Ok(())
}

#[test]
fn accelerations_of_a_session_are_numbers_above_zero() {
    let (controller, mut robot) = ready();
    for config in [
        ServoConfig::new().max_joint_acceleration(0.0),
        ServoConfig::new().max_tcp_speed(f64::NAN),
        ServoConfig::new().max_tcp_acceleration(-1.0),
    ] {
        let error = robot.enter_servo_mode(&config).expect_err("not a rate");
        assert!(error.is_invalid_argument() && error.to_string().contains("above 0"), "{error}");
    }
    assert!(!controller.requests().iter().any(|request| request.contains("servo_move")));
}
