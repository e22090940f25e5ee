//! Servo sessions: entering servo mode, and set-points, whose answers are counted.

use super::motion::unknown;
use super::status::Packets;
use super::{Expected, Replies, When, call, end, later};
use crate::cell::Kind;
use crate::outcome::{Cause, Outcome};

/// Outcomes of a fault before servo mode is requested. After any fault the session leaves servo mode and confirms that
/// with a query: a lost reply is not a reason to give up the connection, on which a stop can be sent.
pub(super) fn entering(replies: &Replies, packets: Packets) -> Expected {
    if !packets.are_known() {
        return unknown(replies, packets);
    }
    let Expected { first, other, .. } = call(replies, Kind::Entering);
    match (replies.when, other) {
        (_, Outcome::Broken(_)) => Expected::new(other, other, other),
        // The next session gets no answer to where the arm is, and asks for nothing that moves it.
        (When::Never, _) => Expected::new(Outcome::NotLeft, Outcome::Timeout, Outcome::Timeout),
        _ => Expected::new(first, other, other),
    }
}

/// Outcomes of a fault before servo mode is requested, where the link was faulty before. The session first queries if
/// the arm is at rest. Without an answer it does not request servo mode.
pub(super) fn asking_for_rest(replies: &Replies, packets: Packets) -> Expected {
    match replies.when {
        _ if !packets.are_known() => unknown(replies, packets),
        When::Never => Expected::new(Outcome::Timeout, Outcome::Timeout, Outcome::Timeout),
        When::Released => Expected::new(Outcome::Timeout, Outcome::Ok, Outcome::Ok),
        _ => Expected::new(Outcome::Ok, later(replies), later(replies)),
    }
}

/// Outcomes of a fault in servo mode. The session reads all items that arrive. A lost answer is not an error.
pub(super) fn set_points(replies: &Replies, packets: Packets) -> Expected {
    // Neither set-points nor the end of servo mode are answered, so what is queued of them is discarded.
    if matches!(replies.when, When::Released | When::Never) {
        let reset = Outcome::Broken(Cause::Reset);
        return Expected::new(reset, reset, reset);
    }
    if !packets.are_known() {
        return unknown(replies, packets);
    }
    let failed = (0..replies.found.len()).find_map(|place| {
        let (outcome, _) = end(&replies.found[place..], Kind::SetPoints)?;
        (outcome != Outcome::Ok).then_some(outcome)
    });
    match failed {
        Some(broken @ Outcome::Broken(_)) => Expected::new(broken, broken, broken),
        failed => Expected::new(failed.unwrap_or(Outcome::Ok), later(replies), later(replies)),
    }
}
