//! Waiting for the end of a motion, in two phases.
//!
//! Controllers say that they are in position for some 100 ms after they have accepted a motion, and a motion without length
//! may never change that (field notes). So the first phase waits for the arm to leave its position, for a time of grace; the
//! second for it to be in position again. Where the target is known, being in position elsewhere is no end.

use std::collections::VecDeque;
use std::sync::Arc;
use std::time::{Duration, Instant};

use jaka_proto::messages::status::RobotStatus;
use jaka_proto::messages::types::JointPosition;

use super::outcome::Outcome;
use crate::Snapshot;

/// How many packets are kept to show what led to an end.
const KEPT: usize = 10;

/// How close, in degrees, a joint is to its target when it is there.
const CLOSE: f64 = 0.1;

/// What is waited for, and how far it is.
#[derive(Debug)]
pub(super) struct Wait {
    /// Packets that came before this tell nothing of the motion.
    sent: Instant,
    target: Option<JointPosition>,
    grace: Grace,
    has_moved: bool,
    /// Since when, and for how many packets, the arm has been in position.
    resting: Option<(Instant, u32)>,
    pub(super) packets: VecDeque<Arc<Snapshot>>,
}

/// How long the arm must have been in position to be taken at its word where it has not been seen to move, or is not at its
/// target.
#[derive(Debug, Clone, Copy)]
pub(super) struct Grace {
    pub(super) time: Duration,
    pub(super) packets: u32,
}

impl Wait {
    pub(super) fn new(sent: Instant, target: Option<JointPosition>, grace: Grace) -> Self {
        Self { sent, target, grace, has_moved: false, resting: None, packets: VecDeque::with_capacity(KEPT) }
    }

    /// Looks at a packet: the outcome, if it tells one.
    pub(super) fn look(&mut self, snapshot: &Arc<Snapshot>) -> Option<Outcome> {
        let seen = self.packets.back().is_some_and(|last| last.number >= snapshot.number);
        if seen || snapshot.received <= self.sent {
            return None;
        }
        if self.packets.len() == KEPT {
            self.packets.pop_front();
        }
        self.packets.push_back(Arc::clone(snapshot));
        trouble(&snapshot.status).or_else(|| self.progress(snapshot))
    }

    fn progress(&mut self, snapshot: &Snapshot) -> Option<Outcome> {
        // A packet without the key tells nothing.
        if !snapshot.status.in_position? {
            self.has_moved = true;
            self.resting = None;
            return None;
        }
        let (since, packets) = self.resting.unwrap_or((snapshot.received, 0));
        self.resting = Some((since, packets + 1));
        let at_target = self.target.zip(snapshot.status.joint_actual_position).map(|(target, at)| is_close(target, at));
        if self.has_moved && at_target != Some(false) {
            return Some(Outcome::Reached);
        }
        let from = if self.has_moved { since } else { self.sent };
        let patience_over = snapshot.received - from >= self.grace.time && packets + 1 >= self.grace.packets;
        patience_over.then_some(if at_target == Some(false) { Outcome::Stopped } else { Outcome::Reached })
    }
}

fn is_close(target: JointPosition, at: JointPosition) -> bool {
    target.0.iter().zip(at.0).all(|(target, at)| (target - at).abs() <= CLOSE)
}

/// What keeps the arm from moving, if something does.
pub(super) fn trouble(status: &RobotStatus) -> Option<Outcome> {
    if status.emergency_stop == Some(true) {
        return Some(Outcome::EmergencyStop);
    }
    if status.protective_stop == Some(true) {
        return Some(Outcome::ProtectiveStop);
    }
    let code = status.error_code.as_deref().filter(|code| !is_zero(code));
    if let Some(code) = code {
        let message = status.error_message.clone().unwrap_or_default();
        return Some(Outcome::ControllerError { code: code.to_owned(), message });
    }
    (status.powered_on == Some(false) || status.enabled == Some(false)).then_some(Outcome::Disabled)
}

/// `0x0`, `0`, or nothing.
fn is_zero(code: &str) -> bool {
    let digits = code.trim().trim_start_matches("0x").trim_start_matches("0X");
    digits.bytes().all(|digit| digit == b'0')
}
