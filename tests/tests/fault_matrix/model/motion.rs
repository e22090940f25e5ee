//! Motions: their acceptance is a reply, and their end is a reply to a query that packets lead to.

use super::status::Packets;
use super::{Expected, Replies, When, call, end as ends, later};
use crate::cell::Kind;
use crate::outcome::Outcome;

/// A motion, where something goes wrong before it is sent.
pub(super) fn sent(replies: &Replies, packets: Packets) -> Expected {
    if !packets.are_known() {
        return unknown(replies, packets);
    }
    let expected = call(replies, Kind::Motion);
    // What is left is found while the motion is waited for, or meets the query for the arm's position.
    match (expected.first, expected.other) {
        (Outcome::Ok, broken @ Outcome::Broken(_)) => Expected { first: broken, ..expected },
        _ => expected,
    }
}

/// The end of a motion that was accepted, where something goes wrong with the query for the arm's position, or with
/// packets.
pub(super) fn end(replies: &Replies, packets: Packets) -> Expected {
    if !packets.are_known() {
        return Expected { first: Outcome::StatusLost, ..unknown(replies, packets) };
    }
    let next = later(replies);
    let Some((answer, taken)) = ends(&replies.found, Kind::Query) else {
        return Expected::new(Outcome::Deadline, next, next);
    };
    match (replies.when, answer) {
        // There is no second query before the first is answered.
        (When::WithNext | When::Released | When::Never, _) => Expected::new(Outcome::Deadline, next, next),
        (_, Outcome::Broken(_)) => Expected::new(answer, answer, answer),
        // A query that was answered without a position is asked again.
        _ => {
            let left = ends(&replies.found[taken..], Kind::Query).map_or(next, |(broken, _)| broken);
            Expected::new(Outcome::Ok, left, left)
        }
    }
}

/// Nothing is sent.
pub(super) fn unknown(replies: &Replies, packets: Packets) -> Expected {
    let same = if packets.come_again() { later(replies) } else { Outcome::StatusUnknown };
    Expected::new(Outcome::StatusUnknown, later(replies), same)
}
