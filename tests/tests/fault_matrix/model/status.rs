//! Arrival of status packets, and the outcome for their readers.

use jaka_sim::StatusFault;

use super::Expected;
use crate::outcome::{Cause, Outcome};
use crate::troubles::LATE;

/// Items that a reader of status packets finds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Packets {
    /// Packets, in time.
    Good,
    /// None in time.
    None,
    /// None ever again.
    Gone,
    /// Packets with bytes between them that are none.
    Noisy,
    /// The beginnings of packets.
    Torn,
    /// Objects without the keys of a packet.
    Empty,
    /// Lines of firmware that is too old.
    Old,
    End,
}

impl Packets {
    /// True if the robot's state is known. A packet that says nothing about stops does not allow a motion.
    pub(super) fn are_known(self) -> bool {
        matches!(self, Self::Good | Self::Noisy)
    }

    /// True if they come again once nothing is wrong any more, to a monitor that does not reconnect.
    pub(super) fn come_again(self) -> bool {
        !matches!(self, Self::Gone | Self::End | Self::Old)
    }
}

pub(super) fn packets(fault: &StatusFault) -> Packets {
    match fault {
        StatusFault::None | StatusFault::Pieces(_) => Packets::Good,
        StatusFault::Slow(period) if *period < LATE => Packets::Good,
        StatusFault::Slow(_) | StatusFault::Silent => Packets::None,
        StatusFault::Garbage { .. } => Packets::Noisy,
        StatusFault::Cut(_) => Packets::Torn,
        StatusFault::Instead(bytes) if bytes.starts_with(b"{") => Packets::Empty,
        StatusFault::Instead(_) => Packets::Old,
        StatusFault::CloseAfter(_) => Packets::End,
        other => panic!("the model knows nothing of {other}"),
    }
}

pub(super) fn expected(packets: Packets) -> Expected {
    let (first, other) = reader(packets);
    Expected { first, stop: None, other, same: None }
}

/// A stream and a monitor look for the next packet after bytes that are not one.
fn reader(packets: Packets) -> (Outcome, Outcome) {
    let broken = |cause| (Outcome::Broken(cause), Outcome::Broken(cause));
    match packets {
        Packets::Good | Packets::Noisy => (Outcome::Ok, Outcome::Ok),
        Packets::None | Packets::Empty | Packets::Torn => (Outcome::Timeout, Outcome::Ok),
        Packets::Gone => (Outcome::Timeout, Outcome::Timeout),
        Packets::Old => broken(Cause::Garbage),
        Packets::End => broken(Cause::End),
    }
}
