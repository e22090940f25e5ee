//! Sessions and streams that land at speed while something goes wrong, by what the controller receives.
//!
//! Not cells of the table: how such a landing ends depends on the moment. What holds in each is asserted.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use jaka_sim::{Controller, Delays, StatusFault};
use jaka_sync::jaka_motion::{Limits, Model};
use jaka_sync::{Config, Error, ErrorKind, Robot, ServoConfig, StreamConfig};
use serde_json::Value;

use crate::cell::LIMIT;
use crate::troubles::Trouble;
use crate::{AT_ONCE, push};

/// What moves until it lands.
#[derive(Debug, Clone, Copy)]
enum Way {
    Session,
    Stream,
}

/// A set-point each four cycles, so that a busy machine seldom leaves the arm without one for three periods.
pub(crate) const CYCLES: u32 = 4;
pub(crate) const PERIOD: f64 = 0.032;
/// What is allowed, and what the ramps ask for, in deg/s².
pub(crate) const MOST: f64 = 720.0;
const ASKED: f64 = 600.0;
pub(crate) const START: [f64; 6] = [10.0, 100.0, 80.0, 90.0, -90.0, 0.0];
const TRIES: usize = 8;

/// Each trouble with each way; fails with all that is wrong.
pub(crate) fn go_through(troubles: &[Trouble]) {
    let tasks: Vec<_> =
        troubles.iter().flat_map(|trouble| [Way::Session, Way::Stream].map(|way| (trouble, way))).collect();
    let (place, failed) = (AtomicUsize::new(0), Mutex::new(Vec::new()));
    let work = || {
        while let Some((trouble, way)) = tasks.get(place.fetch_add(1, Ordering::SeqCst)) {
            let landed = catch_unwind(AssertUnwindSafe(|| (0..TRIES).any(|_| land(trouble, *way))));
            match landed {
                Ok(true) => {}
                Ok(false) => push(&failed, format!("{trouble}, {way:?}: the machine was too busy, {TRIES} times")),
                Err(_) => push(&failed, format!("{trouble}, {way:?}")),
            }
        }
    };
    thread::scope(|scope| {
        for _ in 0..AT_ONCE {
            scope.spawn(work);
        }
    });
    let failed = failed.into_inner().expect("no thread panics with it");
    assert!(failed.is_empty(), "{failed:#?}");
}

/// False where the machine was too busy: the arm stood before it was to land.
fn land(trouble: &Trouble, way: Way) -> bool {
    let controller = Controller::builder().delays(Delays::NONE).status_period(Duration::from_millis(10)).start();
    let controller = controller.expect("loopback has free ports");
    controller.set_state(|state| {
        (state.powered, state.enabled) = (true, true);
        state.joint_position = START.into();
    });
    let config = Config::new().reply_timeout(Duration::from_secs(1));
    let Ok(mut robot) = config.connect_robot_at(controller.command_addr(), controller.status_addr()) else {
        return false;
    };
    let ended = match way {
        Way::Session => session(trouble, &controller, &mut robot),
        Way::Stream => stream(trouble, &controller, robot),
    };
    let Some(ended) = ended else { return false };
    lift(trouble, &controller);
    judge(trouble, way, &controller, &ended)
}

/// None where it did not get to its speed.
fn session(trouble: &Trouble, controller: &Controller, robot: &mut Robot) -> Option<Result<(), Error>> {
    let config = ServoConfig::new().step_count(CYCLES).rest_timeout(LIMIT / 30);
    let mut session = robot.enter_servo_mode(&config).ok()?;
    let step = ASKED * PERIOD * PERIOD;
    for n in 1..=5 {
        session.send_joint_offset([0.0, 0.0, f64::from(n) * step, 0.0, 0.0, 0.0]).ok()?;
    }
    Some(struck(trouble, controller, || session.land().map(drop)))
}

fn stream(trouble: &Trouble, controller: &Controller, robot: Robot) -> Option<Result<(), Error>> {
    let limits = Limits::of(Model::named("Zu 5").expect("a published arm"));
    let mut robot = robot.with_limits(limits.with_joint_accelerations([MOST; 6]).expect("above 0")).ok()?;
    let servo = ServoConfig::new().step_count(CYCLES).rest_timeout(LIMIT / 30);
    let stream = robot.stream(&StreamConfig::new().servo(servo).max_gap(LIMIT)).ok()?;
    let since = Instant::now();
    while stream.joints()[2] - START[2] < 5.0 {
        stream.set_joint_velocity([0.0, 0.0, 60.0, 0.0, 0.0, 0.0], Duration::from_millis(500)).ok()?;
        assert!(since.elapsed() < LIMIT, "{trouble}: it does not move");
        thread::sleep(Duration::from_millis(5));
    }
    Some(struck(trouble, controller, || stream.land().map(drop)))
}

/// Lands while it goes wrong.
fn struck(trouble: &Trouble, controller: &Controller, land: impl FnOnce() -> Result<(), Error>) -> Result<(), Error> {
    if let Some(fault) = trouble.fault("servo_j") {
        controller.inject_for("servo_j", fault);
    }
    controller.status_fault(trouble.status());
    let Trouble::Link(link) = trouble else { return land() };
    link.strike(controller);
    thread::scope(|scope| {
        scope.spawn(|| {
            thread::sleep(link.lasting?);
            controller.links().release();
            Some(())
        });
        land()
    })
}

/// What is held or late comes now.
fn lift(trouble: &Trouble, controller: &Controller) {
    controller.status_fault(StatusFault::None);
    if matches!(trouble, Trouble::Link(_)) {
        controller.links().release();
    }
    let since = Instant::now();
    let mut count = controller.requests().len();
    // Until nothing has come for as long as a reply may take.
    loop {
        thread::sleep(Duration::from_millis(60));
        let now = controller.requests().len();
        if now == count || since.elapsed() > LIMIT {
            return;
        }
        count = now;
    }
}

fn judge(trouble: &Trouble, way: Way, controller: &Controller, ended: &Result<(), Error>) -> bool {
    let requests = parsed(controller);
    let steps = steps(&requests);
    let what = || format!("{trouble}, {way:?}: {ended:?}: {steps:?}");
    // Set-points whose speeds change faster: where the machine was so busy that the arm stood, they begin again.
    let jumps = steps.windows(2).any(|two| (two[1] - two[0]).abs() > MOST * PERIOD * PERIOD * (1.0 + 1e-6));
    if jumps && steps.windows(2).any(|two| two[0] > 1.0 && two[1] <= MOST * PERIOD * PERIOD * (1.0 + 1e-6)) {
        return false;
    }
    assert!(!jumps, "{}", what());
    let off = requests.iter().position(|request| request["cmdName"] == "servo_move" && request["relFlag"] == 0);
    let after = off.map_or(&[][..], |off| &requests[off..]);
    assert!(after.iter().all(|request| request["cmdName"] != "servo_j"), "a set-point after the end: {}", what());
    let rests = steps.last() == Some(&0.0);
    match ended {
        Ok(()) => {
            let state = controller.state();
            assert!(rests && off.is_some() && !state.servo_mode, "{state:?}: {}", what());
            let moved: f64 = steps.iter().sum();
            assert!((state.joint_position.0[2] - START[2] - moved).abs() < 1e-6, "{state:?}: {}", what());
        }
        // What is not at rest is said, or the connection is gone.
        Err(error) if !rests => assert!(
            matches!(
                error.kind(),
                ErrorKind::Disconnected { .. }
                    | ErrorKind::SetPointsUnanswered { .. }
                    | ErrorKind::ServoModeNotLeft { .. }
                    | ErrorKind::NotLanded { .. }
            ),
            "{}",
            what()
        ),
        Err(_) => {}
    }
    true
}

/// The requests that have come.
pub(crate) fn parsed(controller: &Controller) -> Vec<Value> {
    controller.requests().iter().map(|text| serde_json::from_str(text).expect("requests are JSON")).collect()
}

/// How far joint 3 goes with each set-point.
pub(crate) fn steps(requests: &[Value]) -> Vec<f64> {
    let mut at = START[2];
    let set_points = requests.iter().filter(|request| request["cmdName"] == "servo_j");
    let step = |request: &Value| {
        let joint = request["jointPosition"][2].as_f64().expect("a number");
        let step = if request["relFlag"] == 1 { joint } else { joint - at };
        at += step;
        if step.abs() < 1e-9 { 0.0 } else { step }
    };
    set_points.map(step).collect()
}
