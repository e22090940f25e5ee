//! The robot of a cell, and what its arm must not do.

use std::time::Duration;

use jaka_proto::wire::Writer;
use jaka_robot::motion::JointMove;
use jaka_robot::servo::{ServoJ, SetServoMode};
use jaka_robot::types::Switch;
use jaka_robot::{Command, Monitor, Robot, RobotConfig};
use jaka_tests::Configured as _;

use crate::cell::{Cell, LIMIT, PERIOD, STALE};
use crate::outcome::Outcome;
use crate::troubles::Trouble;

/// More cycles than a motion takes.
pub(crate) const MOTION: u32 = 100;

/// Packets enough for a fault of the status port to show.
const SHOWN: u32 = 25;

/// Start grace where the position is asked for again: the arm must be seen at rest for longer than that takes.
const UNSEEN: Duration = Duration::from_secs(2);

pub(crate) fn robot(cell: &Cell<'_>) -> Robot {
    let monitor: Monitor =
        Monitor::connect_with(&cell.config(), cell.controller.status_addr()).expect("the controller listens");
    monitor.wait_until(|_| true, LIMIT).expect("a packet comes on connecting");
    let grace = match cell.trouble {
        Trouble::Refusal | Trouble::Misfit => UNSEEN,
        _ => Duration::ZERO,
    };
    let silence = if cell.expected.first == Outcome::StatusLost { STALE } else { LIMIT };
    Robot::new(cell.client(), monitor)
        .expect("it is the only robot")
        .configured(&RobotConfig::new().start_grace(grace, 4).status_silence(silence))
        .expect("it has no limits")
}

/// Waits until the robot has noticed that its status is not known, where that is expected.
pub(crate) fn notice(cell: &Cell<'_>, robot: &Robot, expected: Outcome) {
    if expected != Outcome::StatusUnknown {
        return;
    }
    cell.clock().sleep(SHOWN * PERIOD);
    until(cell, "the monitor does not notice it", || robot.monitor().disconnect_cause().is_some() || !is_shown(robot));
}

/// Waits until packets come again, where they are to, and are those of now.
pub(crate) fn recover(cell: &Cell<'_>, robot: &Robot) {
    if cell.then == Outcome::StatusUnknown || robot.monitor().disconnect_cause().is_some() {
        return;
    }
    cell.clock().sleep(PERIOD);
    until(cell, "packets do not come again", || is_shown(robot));
}

/// True while packets come, and show where the arm is.
fn is_shown(robot: &Robot) -> bool {
    let newest = robot.monitor().last_known_packet();
    !robot.monitor().is_stale() && newest.is_some_and(|newest| newest.status.joint_actual_position.is_some())
}

fn until(cell: &Cell<'_>, what: &str, holds: impl Fn() -> bool) {
    let since = cell.clock().elapsed();
    while !holds() {
        assert!(cell.clock().elapsed().saturating_sub(since) < LIMIT, "{cell}: {what}");
        cell.clock().sleep(PERIOD);
    }
}

/// Number of commands that move the arm which the controller had received, and the arm's position.
#[derive(Debug, PartialEq)]
pub(crate) struct Witness {
    commands: usize,
    joints: [f64; 6],
}

impl Witness {
    /// By now.
    pub(crate) fn new(cell: &Cell<'_>) -> Self {
        Self { commands: commands(cell), joints: cell.controller.state().joint_position.0 }
    }

    /// Nothing has moved the arm since, and nothing will: what was held passes now, and time goes on.
    pub(crate) fn assert_still(&self, cell: &Cell<'_>) {
        cell.clock().sleep(MOTION * PERIOD);
        assert_eq!(Self::new(cell), *self, "{cell}: what moved the arm was said not to have been sent");
    }

    /// The arm has not moved further than these degrees since, and does not.
    pub(crate) fn assert_within(&self, cell: &Cell<'_>, degrees: f64) {
        cell.clock().sleep(MOTION * PERIOD);
        let now = Self::new(cell);
        let furthest = self.joints.iter().zip(now.joints).map(|(from, to)| (to - from).abs()).fold(0.0, f64::max);
        assert!(furthest <= degrees + 1e-6, "{cell}: the arm has moved by {furthest} deg, and {degrees} may be");
    }

    /// No command that moves the arm has come since.
    pub(crate) fn assert_no_command(&self, cell: &Cell<'_>) {
        assert_eq!(commands(cell), self.commands, "{cell}: {:?}", cell.controller.requests());
    }
}

/// Number of commands received that move the arm, or lead to it.
fn commands(cell: &Cell<'_>) -> usize {
    let mut on = Writer::new();
    SetServoMode::new(Switch::On).write_request(&mut on);
    let names = [JointMove::INFO.name, ServoJ::INFO.name].map(|name| format!("\"{name}\""));
    let moves = |request: &String| request == on.as_str() || names.iter().any(|name| request.contains(name));
    cell.controller.requests().iter().filter(|request| moves(request)).count()
}
