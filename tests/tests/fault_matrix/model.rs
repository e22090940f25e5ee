//! Model of the expected outcome of each fault with each kind of call.
//!
//! The model takes the replies and the status packets that a fault leaves, in the order in which a reader finds them,
//! and follows one rule: the first decisive item ends the call, and the next call meets the remaining items. An item
//! that is late decides nothing. An unknown status moves no arm.

mod link;
mod motion;
mod servo;
mod status;

use jaka_proto::{Envelope, framing};
use jaka_sim::Fault;

use self::status::Packets;
use crate::cell::{Kind, MAX_FRAME};
use crate::outcome::{Cause, Outcome};
use crate::troubles::{LATE, Trouble};

/// Expected contents of a cell of the matrix.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Expected {
    pub(crate) first: Outcome,
    /// Outcome of a stop that is sent while the call waits.
    pub(crate) stop: Option<Outcome>,
    /// Outcome of the next call, if it has another name.
    pub(crate) other: Outcome,
    /// Outcome of the next call, if it has the same name; `None` if the name makes no difference.
    pub(crate) same: Option<Outcome>,
}

impl Expected {
    fn new(first: Outcome, other: Outcome, same: Outcome) -> Self {
        Self { first, stop: None, other, same: Some(same) }
    }
}

/// Item that a reader finds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Found {
    /// The reply.
    Own,
    /// A refusal of the command.
    Refusal,
    /// An acceptance of the command, without the fields of its reply.
    Misfit,
    /// Neither a reply to the command nor an end: the connection cannot be trusted.
    Wrong(Cause),
    End,
}

/// Time at which a reader finds it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum When {
    InTime,
    /// After the deadline, by itself.
    Late,
    /// With the next reply.
    WithNext,
    /// At the release of the link, before the next call.
    Released,
    /// Neither this nor anything else.
    Never,
}

/// Items that arrive after a command, and the time of their arrival.
#[derive(Debug, Clone)]
struct Replies {
    when: When,
    found: Vec<Found>,
}

pub(crate) fn expected(trouble: &Trouble, kind: Kind) -> Expected {
    let (replies, packets) = comes(trouble);
    match kind {
        Kind::StatusStream | Kind::Monitor => status::expected(packets),
        Kind::Motion => motion::sent(&replies, packets),
        Kind::EndOfMotion => motion::end(&replies, packets),
        Kind::Entering if matches!(trouble, Trouble::Link(_)) => servo::asking_for_rest(&replies, packets),
        Kind::Entering => servo::entering(&replies, packets),
        Kind::SetPoints => servo::set_points(&replies, packets),
        Kind::StopBeside => concurrent_stop(&replies),
        _ => call(&replies, kind),
    }
}

/// Replies and status packets that a fault leaves.
fn comes(trouble: &Trouble) -> (Replies, Packets) {
    let found = match trouble {
        Trouble::Link(trouble) => return link::comes(trouble),
        Trouble::Reply(fault) => return (of_fault(fault), Packets::Good),
        Trouble::Status(fault) => {
            return (Replies { when: When::InTime, found: vec![Found::Own] }, status::packets(fault));
        }
        Trouble::Refusal => vec![Found::Refusal],
        Trouble::Misfit => vec![Found::Misfit],
    };
    (Replies { when: When::InTime, found }, Packets::Good)
}

fn of_fault(fault: &Fault) -> Replies {
    let when = match fault {
        Fault::HalfOpen => When::Never,
        Fault::Delay(time) if *time >= LATE => When::Late,
        Fault::Hold | Fault::WithNext => When::WithNext,
        _ => When::InTime,
    };
    let found = match fault {
        Fault::Drop | Fault::HalfOpen => vec![],
        Fault::None | Fault::Pieces(_) | Fault::Delay(_) | Fault::Hold | Fault::WithNext => vec![Found::Own],
        Fault::Twice => vec![Found::Own, Found::Wrong(Cause::Unsolicited)],
        Fault::Nameless => vec![Found::Wrong(Cause::Nameless)],
        Fault::Renamed(_) => vec![Found::Wrong(Cause::Unsolicited)],
        Fault::Before(bytes) => [of_bytes(bytes), vec![Found::Own]].concat(),
        Fault::After(bytes) => [vec![Found::Own], of_bytes(bytes)].concat(),
        Fault::Instead(bytes) => of_bytes(bytes),
        Fault::Garbage { .. } => vec![Found::Wrong(Cause::Garbage)],
        Fault::Oversized(size) => vec![if *size > MAX_FRAME { Found::Wrong(Cause::TooLong) } else { Found::Own }],
        Fault::CloseAfter(count) if *count > MAX_REPLY => vec![Found::Own, Found::End],
        Fault::Close | Fault::CloseAfter(_) | Fault::Reset | Fault::Takeover => vec![Found::End],
        other => panic!("the model knows nothing of {other}"),
    };
    Replies { when, found }
}

/// More than any reply of the matrix has, in bytes.
const MAX_REPLY: usize = 1000;

/// Items that a reader makes of bytes that are not a reply to the command.
fn of_bytes(bytes: &[u8]) -> Vec<Found> {
    let bytes = bytes.trim_ascii();
    let Some(first) = bytes.first() else { return vec![] };
    if !b"{(".contains(first) {
        return vec![Found::Wrong(Cause::Garbage)];
    }
    let cause = match Envelope::read_odd(&framing::text(bytes)) {
        Err(_) => Cause::NotJson,
        Ok(envelope) if envelope.command.is_none() => Cause::Nameless,
        Ok(_) => Cause::Unsolicited,
    };
    vec![Found::Wrong(cause)]
}

/// Outcome of a call that finds these items, and the number of items that it takes; `None` if no item ends it.
fn end(found: &[Found], kind: Kind) -> Option<(Outcome, usize)> {
    let outcome = match found.first()? {
        Found::Misfit if kind.has_typed_fields() => Outcome::Unexpected,
        Found::Own | Found::Misfit => Outcome::Ok,
        Found::Refusal => Outcome::Refused,
        Found::Wrong(cause) => Outcome::Broken(*cause),
        Found::End => Outcome::Broken(Cause::End),
    };
    Some((outcome, 1))
}

/// One command whose reply is waited for.
fn call(replies: &Replies, kind: Kind) -> Expected {
    let (when, found) = (replies.when, &replies.found);
    let in_time = if when == When::InTime { end(found, kind) } else { None };
    let (first, taken) = in_time.unwrap_or((Outcome::Timeout, 0));
    if matches!(first, Outcome::Broken(_)) {
        return Expected::new(first, first, first);
    }
    // A late reply that is still outstanding is dropped; all else that is left breaks the connection.
    let left = found[taken..].iter().find(|left| **left != Found::Own);
    let next = match left {
        Some(Found::Wrong(cause)) => Outcome::Broken(*cause),
        Some(Found::End) => Outcome::Broken(Cause::End),
        _ => later(replies),
    };
    // The reply to a second command of the name completes the first, whose reply may just be late.
    let is_lost = when == When::InTime && first == Outcome::Timeout;
    let same = if is_lost { Outcome::Broken(Cause::Ambiguous) } else { next };
    Expected::new(first, next, same)
}

/// Outcome of a later call, if the connection works: a timeout if no reply comes ever again, and success otherwise.
fn later(replies: &Replies) -> Outcome {
    if replies.when == When::Never { Outcome::Timeout } else { Outcome::Ok }
}

/// A call that waits long enough for a stop to be answered after it, if one is answered at all.
fn concurrent_stop(replies: &Replies) -> Expected {
    let found = &replies.found;
    let (first, stop) = match (replies.when, end(found, Kind::StopBeside)) {
        (When::Never | When::Released, _) => (Outcome::Timeout, Outcome::Timeout),
        (_, None) => (Outcome::ReplyLost, Outcome::Ok),
        (_, Some((broken @ Outcome::Broken(_), _))) => (broken, broken),
        (_, Some((outcome, taken))) => match end(&found[taken..], Kind::StopBeside) {
            Some((broken, _)) => (outcome, broken),
            None => (outcome, Outcome::Ok),
        },
    };
    let other = if stop == Outcome::Timeout { later(replies) } else { stop };
    Expected { first, stop: Some(stop), other, same: None }
}
