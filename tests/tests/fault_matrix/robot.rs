//! The robot of a cell, and what its arm must not do.

use std::panic::panic_any;
use std::thread;
use std::time::{Duration, Instant};

use jaka_proto::wire::Writer;
use jaka_sync::motion::JointMove;
use jaka_sync::servo::{ServoJ, SetServoMode};
use jaka_sync::types::Switch;
use jaka_sync::{Command, Monitor, Robot};

use crate::TooBusy;
use crate::cell::{Cell, LIMIT, PATIENCE, PERIOD, SHORT, STALE};
use crate::outcome::Outcome;
use crate::troubles::Trouble;

/// More cycles than a motion takes.
pub(crate) const MOTION: u32 = 100;

/// Packets enough for a fault of the status port to show.
const SHOWN: u32 = 25;

/// Where the position is asked for again, the arm must be seen at rest for longer than that takes, and than this machine stalls.
const UNSEEN: Duration = Duration::from_secs(2);

pub(crate) fn robot(cell: &Cell<'_>) -> Robot {
    let monitor: Monitor =
        cell.config().connect_monitor(cell.controller.status_addr()).expect("the controller listens");
    // It comes at once, and is old on a machine that is busy for longer than a packet counts.
    if let Err(error) = monitor.wait_until(|_| true, PATIENCE) {
        panic_any(TooBusy(format!("no packet was seen in time: {error}")));
    }
    // Counted in packets alone, so that nothing depends on how fast this machine is.
    let grace = match cell.trouble {
        Trouble::Refusal | Trouble::Misfit => UNSEEN,
        _ => Duration::ZERO,
    };
    let silence = if cell.expected.first == Outcome::StatusLost { STALE } else { LIMIT };
    Robot::new(cell.client(), monitor).with_start_grace(grace, 4).with_status_silence(silence)
}

/// Does something while the controller's time goes on; where packets are not to come, for as long as a motion takes.
pub(crate) fn while_time_goes_on<T: Send>(cell: &Cell<'_>, expected: Outcome, work: impl FnOnce() -> T + Send) -> T {
    let most = if matches!(expected, Outcome::Ok | Outcome::Broken(_)) { u32::MAX } else { MOTION };
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

/// Waits until the robot has noticed that its status is not known, where that is expected.
pub(crate) fn notice(cell: &Cell<'_>, robot: &Robot, expected: Outcome) {
    if expected != Outcome::StatusUnknown {
        return;
    }
    for _ in 0..SHOWN {
        cell.controller.advance(PERIOD);
    }
    until(cell, "the monitor does not notice it", || {
        robot.monitor().disconnect_cause().is_some() || robot.monitor().is_stale()
    });
}

/// Waits until packets come again, where they are to, and are those of now.
pub(crate) fn recover(cell: &Cell<'_>, robot: &Robot) {
    if cell.then == Outcome::StatusUnknown || robot.monitor().disconnect_cause().is_some() {
        return;
    }
    until(cell, "packets do not come again", || {
        cell.controller.advance(PERIOD);
        !robot.monitor().is_stale()
    });
}

fn until(cell: &Cell<'_>, what: &str, holds: impl Fn() -> bool) {
    let since = Instant::now();
    while !holds() {
        assert!(since.elapsed() < LIMIT, "{cell}: {what}");
        thread::sleep(SHORT);
    }
}

/// What the controller had received of commands that move the arm, and where the arm was.
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
        for _ in 0..MOTION {
            cell.controller.advance(PERIOD);
            thread::sleep(PERIOD / 8);
        }
        assert_eq!(Self::new(cell), *self, "{cell}: what moved the arm was said not to have been sent");
    }

    /// The arm has not moved further than these degrees since, and does not.
    pub(crate) fn assert_within(&self, cell: &Cell<'_>, degrees: f64) {
        for _ in 0..MOTION {
            cell.controller.advance(PERIOD);
            thread::sleep(PERIOD / 8);
        }
        let now = Self::new(cell);
        let furthest = self.joints.iter().zip(now.joints).map(|(from, to)| (to - from).abs()).fold(0.0, f64::max);
        assert!(furthest <= degrees + 1e-6, "{cell}: the arm has moved by {furthest} deg, and {degrees} may be");
    }

    /// No command that moves the arm has come since.
    pub(crate) fn assert_no_command(&self, cell: &Cell<'_>) {
        assert_eq!(commands(cell), self.commands, "{cell}: {:?}", cell.controller.requests());
    }
}

/// How many commands the controller has received that move the arm, or lead to it.
fn commands(cell: &Cell<'_>) -> usize {
    let mut on = Writer::new();
    SetServoMode::new(Switch::On).write_request(&mut on);
    let names = [JointMove::INFO.name, ServoJ::INFO.name].map(|name| format!("\"{name}\""));
    let moves = |request: &String| request == on.as_str() || names.iter().any(|name| request.contains(name));
    cell.controller.requests().iter().filter(|request| moves(request)).count()
}
