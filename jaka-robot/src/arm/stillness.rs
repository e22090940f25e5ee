//! Rest as status packets show it.

use std::time::{Duration, Instant};

use jaka_proto::messages::types::JointPosition;

use crate::Snapshot;
use crate::place::Place;

/// Least time between two packets that show rest, if the joint positions of rest are not known.
const APART: Duration = Duration::from_millis(100);

/// Stillness of an arm that is held by its last set-point, by status packets.
#[derive(Debug)]
pub(crate) struct Stillness {
    /// Packets from before do not count.
    since: Instant,
    /// Joint positions at which the arm is held, if they are known.
    held: Option<JointPosition>,
    /// The first of the packets that agree, with its time of arrival and its number.
    first: Option<(JointPosition, Instant, u64)>,
}

impl Stillness {
    pub(crate) fn new(since: Instant, held: Option<JointPosition>) -> Self {
        Self { since, held, first: None }
    }

    /// Takes a packet: true if an earlier one shows the same joint positions, and these are the commanded ones.
    pub(crate) fn is_seen(&mut self, packet: &Snapshot) -> bool {
        let Some(joints) = packet.status.joint_actual_position.filter(|_| packet.received > self.since) else {
            return false;
        };
        let here = Place::Joints(joints);
        let is_there = self.held.is_none_or(|held| Place::Joints(held).is_at(&here));
        match self.first {
            Some((first, came, number)) if is_there && Place::Joints(first).is_still(&here) => {
                let apart = packet.received.saturating_duration_since(came);
                number != packet.number && (self.held.is_some() || apart >= APART)
            }
            _ => {
                self.first = is_there.then_some((joints, packet.received, packet.number));
                false
            }
        }
    }
}
