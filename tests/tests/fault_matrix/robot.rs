//! Motions that are waited for, and servo sessions.

use std::thread;
use std::time::{Duration, Instant};

use jaka_sync::motion::JointMove;
use jaka_sync::servo::ServoJ;
use jaka_sync::types::{JointPosition, MoveMode};
use jaka_sync::{Command, Error, Monitor, MotionEnd, Outcome as Ended, Robot, ServoConfig};

use crate::cell::{Cell, LIMIT, Next, PATIENCE, PERIOD, Seen};
use crate::outcome::Outcome;
use crate::troubles::Trouble;

/// How many set-points a session has.
const SET_POINTS: usize = 8;

/// More cycles than a motion takes.
const MOTION: u32 = 100;

/// How long packets may stay away where they are to.
const SILENCE: Duration = Duration::from_millis(200);

fn robot(cell: &Cell<'_>) -> Robot {
    let monitor: Monitor = cell.config().monitor(cell.controller.status_addr()).expect("the controller listens");
    monitor.wait_until(|_| true, PATIENCE).expect("the first packet comes at once");
    // Counted in packets alone, so that nothing depends on how fast this machine is.
    Robot::new(cell.client(), monitor).start_grace(Duration::ZERO, 4)
}

pub(crate) fn run_motion(cell: &Cell<'_>) -> Seen {
    let robot = robot(cell);
    let expected = cell.expected.first;
    let (mut robot, first) = if matches!(cell.trouble, Trouble::Status(_)) {
        // Packets go wrong when the motion was accepted.
        moves(cell, robot, expected, |robot, motion, timeout| {
            robot.start(motion)?;
            cell.strike(JointMove::INFO.name);
            Ok(robot.wait(timeout))
        })
    } else {
        cell.strike(JointMove::INFO.name);
        moves(cell, robot, expected, Robot::run)
    };
    cell.lift();
    let next = match cell.next {
        Next::Other => query(cell, &mut robot),
        Next::Same => {
            robot.acknowledge();
            moves(cell, robot, cell.then, Robot::run).1
        }
    };
    Seen { first, beside: None, next }
}

/// Moves each joint by half a degree, while time goes on.
fn moves(
    cell: &Cell<'_>,
    robot: Robot,
    expected: Outcome,
    run: impl FnOnce(&mut Robot, &JointMove, Duration) -> Result<MotionEnd, Error> + Send,
) -> (Robot, Outcome) {
    let mut robot = robot.status_silence(if expected == Outcome::StatusLost { SILENCE } else { LIMIT });
    let joint_position = cell.controller.state().joint_position.0.map(|joint| joint + 0.5);
    let joint_position = JointPosition(joint_position);
    let motion = JointMove { mode: MoveMode::Absolute, joint_position, speed: 90.0, acceleration: Some(700.0) };
    let timeout = cell.patience(expected);
    let outcome = cell.ends(timeout, expected, || {
        let end = while_time_goes_on(cell, expected, || run(&mut robot, &motion, timeout))?;
        Ok(outcome(cell, &end.outcome, joint_position))
    });
    (robot, outcome)
}

/// A motion that has reached its target is there.
fn outcome(cell: &Cell<'_>, ended: &Ended, target: JointPosition) -> Outcome {
    match ended {
        Ended::Reached => {
            let at = cell.controller.state().joint_position;
            let is_there = at.0.iter().zip(target.0).all(|(at, to)| (at - to).abs() < 1e-6);
            assert!(is_there, "{cell}: the arm is at {at:?}, and not at {target:?}");
            Outcome::Ok
        }
        Ended::StatusLost { .. } => Outcome::StatusLost,
        Ended::Deadline => Outcome::Deadline,
        other => panic!("{cell}: no fault may end a motion with {other:?}"),
    }
}

/// Does something while the controller's time goes on; where packets are not to come, for as long as a motion takes.
fn while_time_goes_on<T: Send>(cell: &Cell<'_>, expected: Outcome, work: impl FnOnce() -> T + Send) -> T {
    let most = if expected == Outcome::Ok { u32::MAX } else { MOTION };
    thread::scope(|scope| {
        let working = scope.spawn(work);
        for _ in 0..most {
            if working.is_finished() {
                break;
            }
            cell.controller.advance(PERIOD);
            // Eight times as fast as real time.
            thread::sleep(PERIOD / 8);
        }
        working.join().expect("no call panics")
    })
}

fn query(cell: &Cell<'_>, robot: &mut Robot) -> Outcome {
    let timeout = cell.patience(cell.then);
    cell.ends(timeout, cell.then, || cell.joint_position(robot.client(), timeout))
}

pub(crate) fn run_servo_session(cell: &Cell<'_>) -> Seen {
    let mut robot = robot(cell);
    cell.strike(ServoJ::INFO.name);
    cell.controller.advance(PERIOD);
    if cell.expected.first == Outcome::NotAcknowledged {
        let since = Instant::now();
        while robot.monitor().disconnect().is_none() {
            assert!(since.elapsed() < LIMIT, "{cell}: the monitor does not notice it");
            thread::yield_now();
        }
    }
    let first = cell.ends(cell.patience(cell.expected.first), cell.expected.first, || session(cell, &mut robot));
    cell.lift();
    let next = match cell.next {
        Next::Other => query(cell, &mut robot),
        Next::Same => {
            robot.acknowledge();
            cell.ends(cell.patience(cell.then), cell.then, || session(cell, &mut robot))
        }
    };
    Seen { first, beside: None, next }
}

/// A whole session; its first error, if there is one.
fn session(cell: &Cell<'_>, robot: &mut Robot) -> Result<(), Error> {
    let sent = set_points(cell);
    let mut session = robot.servo(&ServoConfig::new().max_unanswered(LIMIT))?;
    let failed = (0..SET_POINTS).find_map(|_| session.joints_by([0.05, 0.0, 0.0, 0.0, 0.0, 0.0]).err());
    let finished = session.finish();
    if let Some(error) = failed {
        return Err(error);
    }
    let report = finished?;
    assert_eq!(set_points(cell), sent + SET_POINTS, "{cell}: a set-point was not sent");
    assert!(report.accepted + report.unanswered == SET_POINTS as u64, "{cell}: {report:?}");
    Ok(())
}

/// How many set-points the controller has received.
fn set_points(cell: &Cell<'_>) -> usize {
    let name = format!("\"{}\"", ServoJ::INFO.name);
    cell.controller.requests().iter().filter(|request| request.contains(&name)).count()
}
