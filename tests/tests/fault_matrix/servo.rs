//! Servo sessions.

use std::time::Duration;

use jaka_robot::servo::{ServoJ, SetServoMode};
use jaka_robot::{Command, Error, Robot, ServoConfig, SessionConfig};

use crate::cell::{Cell, LIMIT, Next, Seen};
use crate::outcome::{Cause, Outcome};
use crate::robot::{Witness, notice, recover, robot};
use crate::troubles::Trouble;

/// Number of set-points in a session that must succeed.
const SET_POINTS: usize = 8;

/// Maximum number of set-points in a session that must fail.
const MOST_SET_POINTS: usize = 1000;

/// Travel of the first joint with each set-point, in degrees.
const STEP: f64 = 0.05;

/// Timeout for the arm to come to rest.
const REST: Duration = Duration::from_secs(5);

/// Default maximum number of unanswered set-points: 100 ms.
const UNANSWERED: u32 = 12;

/// Runs a session with a fault before servo mode is requested.
pub(crate) fn run_entering(cell: &Cell<'_>) -> Seen {
    let mut robot = robot(cell);
    let expected = cell.expected.first;
    let witness = Witness::new(cell);
    cell.strike(SetServoMode::INFO.name);
    notice(cell, &robot, expected);
    let timeout = cell.patience(expected);
    let first = cell.ends(timeout, expected, || session(cell, &mut robot, expected, || {}));
    cell.lift();
    // Where nothing passes, the question whether the arm is at rest is not answered, and servo mode not asked for.
    let is_asked_for = expected != Outcome::StatusUnknown
        && !(expected == Outcome::Timeout && matches!(cell.trouble, Trouble::Link(_)));
    if !is_asked_for {
        witness.assert_still(cell);
    }
    let next = next(cell, &mut robot);
    if !is_asked_for && cell.next == Next::Other {
        witness.assert_no_command(cell);
    }
    Seen { first, stop: None, next }
}

/// Runs a session with a fault in servo mode.
pub(crate) fn run_set_points(cell: &Cell<'_>) -> Seen {
    let mut robot = robot(cell);
    let expected = cell.expected.first;
    let begin = Witness::new(cell);
    let first = cell.ends(cell.patience(expected), expected, || {
        session(cell, &mut robot, expected, || cell.strike(ServoJ::INFO.name))
    });
    let end = Witness::new(cell);
    cell.lift();
    match expected {
        // Those that were not answered are as many as may be, also if they come by now.
        Outcome::Broken(Cause::Reset) => begin.assert_within(cell, f64::from(UNANSWERED) * STEP),
        // Servo mode was left after the last of them.
        Outcome::StatusUnknown => {
            assert!(!cell.controller.state().servo_mode, "{cell}: servo mode is on");
            end.assert_no_command(cell);
            end.assert_still(cell);
        }
        _ => {}
    }
    let next = next(cell, &mut robot);
    Seen { first, stop: None, next }
}

fn next(cell: &Cell<'_>, robot: &mut Robot) -> Outcome {
    let timeout = cell.patience(cell.then);
    match cell.next {
        Next::Other => cell.ends(timeout, cell.then, || cell.payload(robot.client(), timeout)),
        Next::Same => {
            robot.acknowledge();
            if matches!(cell.trouble, Trouble::Refusal) {
                // What a controller refuses it has not done, but the simulated one, whose reply alone is another.
                cell.controller.set_state(|state| state.servo_mode = false);
            }
            recover(cell, robot);
            cell.ends(timeout, cell.then, || session(cell, robot, cell.then, || {}))
        }
    }
}

/// A whole session, with something in servo mode before its first set-point; its first error, if there is one.
fn session(cell: &Cell<'_>, robot: &mut Robot, expected: Outcome, then: impl FnOnce()) -> Result<(), Error> {
    let is_to_succeed = expected == Outcome::Ok;
    // The bound is for what is to reach it alone.
    let is_to_gather = expected == Outcome::Broken(Cause::Reset);
    let servo = ServoConfig::new().rest_timeout(REST);
    let servo = if is_to_gather { servo } else { servo.max_unanswered(LIMIT) };
    let config = SessionConfig::new().servo(servo).unchecked();
    let sent = cell.received(ServoJ::INFO.name);
    let mut session = robot.enter_servo_mode(&config)?;
    then();
    let count = if is_to_succeed { SET_POINTS } else { MOST_SET_POINTS };
    let failed = (0..count).find_map(|_| session.send_joint_offset([STEP, 0.0, 0.0, 0.0, 0.0, 0.0]).err());
    let finished = session.land();
    if let Some(error) = failed {
        return Err(error);
    }
    let report = finished?.report;
    let set_points = SET_POINTS as u64 + report.landing_cycles;
    let received = cell.received(ServoJ::INFO.name) - sent;
    assert_eq!(received as u64, set_points, "{cell}: a set-point was not sent");
    assert!(report.accepted + report.unanswered == set_points, "{cell}: {report:?}");
    assert!(!cell.controller.state().servo_mode, "{cell}: servo mode is on");
    Ok(())
}
