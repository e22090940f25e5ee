//! Motions that are waited for.

use std::time::Duration;

use jaka_robot::kinematics::GetJointPos;
use jaka_robot::motion::JointMove;
use jaka_robot::types::JointPosition;
use jaka_robot::{Cause as Ended, Command, End, Error, ErrorKind, Evidence, Robot, RobotConfig};
use jaka_sim::Port;
use jaka_tests::Configured as _;

use crate::cell::{Cell, LIMIT, Next, PATIENCE, PERIOD, Seen};
use crate::link::LinkTrouble;
use crate::outcome::{Cause, Outcome};
use crate::robot::{MOTION, Witness, notice, recover, robot};
use crate::troubles::Trouble;

/// Largest distance of a joint from a reached target, in degrees.
const CLOSE: f64 = 0.1;

/// Travel of each joint, in degrees: some 50 cycles.
const STEP: f64 = 20.0;

/// A motion, where it goes wrong before it is sent.
pub(crate) fn run(cell: &Cell<'_>) -> Seen {
    let mut robot = robot(cell);
    let expected = cell.expected.first;
    let witness = Witness::new(cell);
    cell.strike(JointMove::INFO.name);
    notice(cell, &robot, expected);
    if expected == Outcome::Ok {
        move_before(cell, &mut robot);
    }
    let first = moves(cell, &mut robot, expected);
    cell.lift();
    if expected == Outcome::StatusUnknown {
        witness.assert_still(cell);
    }
    let next = next(cell, &mut robot);
    if expected == Outcome::StatusUnknown && cell.next == Next::Other {
        // After the answer to a later command, nothing can come any more.
        witness.assert_no_command(cell);
    }
    Seen { first, stop: None, next }
}

/// Packets that a link holds or delays are those of another motion: in position, moving, and in
/// position again.
fn move_before(cell: &Cell<'_>, robot: &mut Robot) {
    if !matches!(cell.trouble, Trouble::Link(LinkTrouble { port: Some(Port::Status), .. })) {
        return;
    }
    robot.client().joint_move(&motion(cell)).expect("nothing is wrong with the command port");
    cell.clock().sleep(MOTION * PERIOD);
}

/// A motion, where it goes wrong once it was accepted.
pub(crate) fn run_end(cell: &Cell<'_>) -> Seen {
    let mut robot = robot(cell);
    let expected = cell.expected.first;
    // Once it was answered, it does not wait for the answer to another query.
    cell.payload(robot.client(), LIMIT).expect("nothing is wrong yet");
    let motion = motion(cell);
    robot.start(&motion).expect("nothing is wrong yet");
    // From here on no packet is older than the motion.
    cell.clock().sleep(2 * PERIOD);
    robot.monitor().wait_until(|status| status.in_position == Some(false), PATIENCE).expect("the arm moves");
    cell.strike(GetJointPos::INFO.name);
    let timeout = cell.patience(expected);
    let first =
        cell.ends(timeout, expected, || Ok::<_, Error>(outcome(cell, &robot.wait(timeout), motion.joint_position)));
    cell.lift();
    if expected == Outcome::StatusLost {
        assert_latched(cell, &mut robot);
    }
    // The next motion has all the time that it needs.
    let next = next(cell, &mut robot.configured(&RobotConfig::new().status_silence(LIMIT)).expect("it has no limits"));
    Seen { first, stop: None, next }
}

/// Each joint by some degrees from where it is.
fn motion(cell: &Cell<'_>) -> JointMove {
    let joint_position = cell.controller.state().joint_position.0.map(|joint| joint + STEP);
    JointMove::absolute(joint_position, 90.0).acceleration(700.0)
}

/// Moves the arm.
fn moves(cell: &Cell<'_>, robot: &mut Robot, expected: Outcome) -> Outcome {
    let (motion, timeout) = (motion(cell), cell.patience(expected));
    cell.ends(timeout, expected, || robot.run(&motion, timeout).map(|end| outcome(cell, &end, motion.joint_position)))
}

/// A motion that has reached its target is there, and at rest.
fn outcome(cell: &Cell<'_>, end: &End, target: JointPosition) -> Outcome {
    match (end.evidence(), end.cause()) {
        (Evidence::Commands { cause, .. }, _) => Outcome::Broken(Cause::of(cause)),
        (Evidence::Status { .. }, _) => Outcome::StatusLost,
        (Evidence::None, Ended::Reached) => {
            let state = cell.controller.state();
            let off = state.joint_position.max_distance(&target);
            assert!(off <= CLOSE, "{cell}: the arm is at {:?}, and not at {target:?}", state.joint_position);
            assert!(state.tcp_speed == 0.0, "{cell}: the arm moves");
            Outcome::Ok
        }
        // A query may be outstanding at the deadline.
        (Evidence::None, Ended::Deadline | Ended::Unanswered) => Outcome::Deadline,
        other => panic!("{cell}: no fault may end a motion with {other:?}: {end:?}"),
    }
}

/// After a status that was lost, nothing moves before somebody has looked.
fn assert_latched(cell: &Cell<'_>, robot: &mut Robot) {
    // The motion that was accepted goes on to its end.
    cell.clock().sleep(MOTION * PERIOD);
    let witness = Witness::new(cell);
    let refused = robot.run(&motion(cell), Duration::ZERO);
    assert!(
        refused.as_ref().is_err_and(|error| matches!(error.kind(), ErrorKind::NotAcknowledged { .. })),
        "{cell}: {refused:?}"
    );
    witness.assert_still(cell);
}

fn next(cell: &Cell<'_>, robot: &mut Robot) -> Outcome {
    match cell.next {
        Next::Other => {
            let timeout = cell.patience(cell.then);
            cell.ends(timeout, cell.then, || cell.payload(robot.client(), timeout))
        }
        Next::Same => {
            robot.acknowledge();
            recover(cell, robot);
            moves(cell, robot, cell.then)
        }
    }
}
