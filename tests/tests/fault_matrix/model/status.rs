//! The same for what goes wrong with status packets.

use jaka_sim::StatusFault;

use super::{Expected, Found, When, call, stop_beside};
use crate::cell::Kind;
use crate::outcome::{Cause, Outcome};
use crate::troubles::LATE;

/// What a reader of status packets finds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Packets {
    /// Packets, in time.
    Good,
    /// None in time.
    None,
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

fn packets(fault: &StatusFault) -> Packets {
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

pub(super) fn expected(fault: &StatusFault, kind: Kind) -> Expected {
    let packets = packets(fault);
    match kind {
        Kind::StatusStream | Kind::Monitor => {
            let (first, other) = reader(packets);
            Expected { first, beside: None, other, same: None }
        }
        Kind::Motion => {
            let (first, same) = motion(packets);
            Expected { first, beside: None, other: Outcome::Ok, same: Some(same) }
        }
        Kind::ServoSession => {
            let first = if is_end(packets) { Outcome::NotAcknowledged } else { Outcome::Ok };
            Expected { first, beside: None, other: Outcome::Ok, same: Some(first) }
        }
        // The command port knows nothing of the status port.
        Kind::StopBeside => stop_beside((When::InTime, vec![Found::Own])),
        _ => call((When::InTime, vec![Found::Own]), kind),
    }
}

/// The end of the connection, for a monitor that does not connect anew.
fn is_end(packets: Packets) -> bool {
    matches!(packets, Packets::End | Packets::Old)
}

/// A stream and a monitor look for the next packet behind what is none.
fn reader(packets: Packets) -> (Outcome, Outcome) {
    let broken = |cause| (Outcome::Broken(cause), Outcome::Broken(cause));
    match packets {
        Packets::Good | Packets::Noisy => (Outcome::Ok, Outcome::Ok),
        Packets::None | Packets::Empty | Packets::Torn => (Outcome::Timeout, Outcome::Ok),
        Packets::Old => broken(Cause::Garbage),
        Packets::End => broken(Cause::End),
    }
}

/// What a motion ends with that is waited for by a monitor, and the next one.
fn motion(packets: Packets) -> (Outcome, Outcome) {
    match packets {
        Packets::Good | Packets::Noisy => (Outcome::Ok, Outcome::Ok),
        Packets::None | Packets::Torn => (Outcome::StatusLost, Outcome::Ok),
        Packets::Empty => (Outcome::Deadline, Outcome::Ok),
        Packets::Old | Packets::End => (Outcome::StatusLost, Outcome::NotAcknowledged),
    }
}
