//! What each fault should lead to with each kind of call.
//!
//! The model looks at what a fault leaves on the wire, in the order in which a reader finds it, and follows one rule: the
//! first thing that decides ends the call, and what is left meets the next one.

mod status;

use jaka_proto::Envelope;
use jaka_sim::{Fault, StatusFault};

use crate::cell::{Kind, MAX_FRAME};
use crate::outcome::{Cause, Outcome};
use crate::troubles::{LATE, Trouble};

/// What a cell of the matrix should show.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Expected {
    pub(crate) first: Outcome,
    /// What a stop ends with that is sent while the call waits.
    pub(crate) beside: Option<Outcome>,
    /// What the next call ends with, if it is of another name.
    pub(crate) other: Outcome,
    /// The same, if it is of the same name; none where that makes no difference.
    pub(crate) same: Option<Outcome>,
}

/// What a reader finds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Found {
    /// The reply.
    Own,
    /// A refusal of the command.
    Refusal,
    /// An acceptance of the command, without the fields of its reply.
    Misfit,
    /// What is no reply to the command, and no end either: the connection cannot be trusted.
    Wrong(Cause),
    End,
}

/// When it is found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum When {
    InTime,
    /// After the deadline.
    Late,
    /// With the next reply.
    WithNext,
    /// Neither this nor anything else.
    Never,
}

pub(crate) fn expected(trouble: &Trouble, kind: Kind) -> Expected {
    match (trouble, kind) {
        (Trouble::Status(fault), _) => status::expected(fault, kind),
        (_, Kind::StatusStream | Kind::Monitor) => status::expected(&StatusFault::None, kind),
        (_, Kind::ServoSession) => servo_session(on_the_wire(trouble)),
        (_, Kind::StopBeside) => stop_beside(on_the_wire(trouble)),
        _ => call(on_the_wire(trouble), kind),
    }
}

fn on_the_wire(trouble: &Trouble) -> (When, Vec<Found>) {
    let found = match trouble {
        Trouble::Refusal => vec![Found::Refusal],
        Trouble::Misfit => vec![Found::Misfit],
        Trouble::Status(_) => vec![Found::Own],
        Trouble::Reply(fault) => return of_fault(fault),
    };
    (When::InTime, found)
}

fn of_fault(fault: &Fault) -> (When, Vec<Found>) {
    let found = match fault {
        Fault::Drop => vec![],
        Fault::HalfOpen => return (When::Never, vec![]),
        Fault::Delay(time) if *time >= LATE => return (When::Late, vec![Found::Own]),
        Fault::None | Fault::Pieces(_) | Fault::Delay(_) => vec![Found::Own],
        Fault::Hold | Fault::WithNext => return (When::WithNext, vec![Found::Own]),
        Fault::Twice => vec![Found::Own, Found::Wrong(Cause::Unasked)],
        Fault::Nameless => vec![Found::Wrong(Cause::Nameless)],
        Fault::Renamed(_) => vec![Found::Wrong(Cause::Unasked)],
        Fault::Before(bytes) => [of_bytes(bytes), vec![Found::Own]].concat(),
        Fault::After(bytes) => [vec![Found::Own], of_bytes(bytes)].concat(),
        Fault::Instead(bytes) => of_bytes(bytes),
        Fault::Garbage { .. } => vec![Found::Wrong(Cause::Garbage)],
        Fault::Oversized(size) => vec![if *size > MAX_FRAME { Found::Wrong(Cause::TooLong) } else { Found::Own }],
        Fault::CloseAfter(count) if *count > MAX_REPLY => vec![Found::Own, Found::End],
        Fault::Close | Fault::CloseAfter(_) | Fault::Reset | Fault::Takeover => vec![Found::End],
        other => panic!("the model knows nothing of {other}"),
    };
    (When::InTime, found)
}

/// More than any reply of the matrix has, in bytes.
const MAX_REPLY: usize = 1000;

/// What bytes are found to be that are no reply to the command.
fn of_bytes(bytes: &[u8]) -> Vec<Found> {
    let bytes = bytes.trim_ascii();
    let Some(first) = bytes.first() else { return vec![] };
    if !b"{(".contains(first) {
        return vec![Found::Wrong(Cause::Garbage)];
    }
    let Ok(text) = std::str::from_utf8(bytes) else { return vec![Found::Wrong(Cause::NotUtf8)] };
    let cause = match Envelope::read(text) {
        Err(_) => Cause::NotJson,
        Ok(envelope) if envelope.command.is_none() => Cause::Nameless,
        Ok(_) => Cause::Unasked,
    };
    vec![Found::Wrong(cause)]
}

/// What ends a call with what it finds, and how much of that it takes; `None` if nothing does.
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
fn call((when, found): (When, Vec<Found>), kind: Kind) -> Expected {
    let in_time = if when == When::InTime { end(&found, kind) } else { None };
    let (first, taken) = in_time.unwrap_or((Outcome::Timeout, 0));
    if matches!(first, Outcome::Broken(_)) {
        // A robot does not even try to move.
        let same = if kind == Kind::Motion { Outcome::NotAcknowledged } else { first };
        return Expected { first, beside: None, other: first, same: Some(same) };
    }
    // A late reply that is still owed is dropped; all else that is left breaks the connection.
    let left = found[taken..].iter().find(|left| **left != Found::Own);
    let next = match left {
        Some(Found::Wrong(cause)) => Outcome::Broken(*cause),
        Some(Found::End) => Outcome::Broken(Cause::End),
        _ if when == When::Never => Outcome::Timeout,
        _ => Outcome::Ok,
    };
    // The reply to a second command of the name settles the debt of the first, whose reply may just be late.
    let is_lost = when == When::InTime && first == Outcome::Timeout;
    let same = if is_lost { Outcome::Broken(Cause::Ambiguous) } else { next };
    Expected { first, beside: None, other: next, same: Some(same) }
}

/// A call that waits long enough for a stop to be answered behind it.
fn stop_beside((when, found): (When, Vec<Found>)) -> Expected {
    let (first, stop) = match (when, end(&found, Kind::StopBeside)) {
        (When::Never, _) => (Outcome::Timeout, Outcome::Timeout),
        (_, None) => (Outcome::ReplyLost, Outcome::Ok),
        (_, Some((broken @ Outcome::Broken(_), _))) => (broken, broken),
        (_, Some((outcome, taken))) => match end(&found[taken..], Kind::StopBeside) {
            Some((broken, _)) => (outcome, broken),
            None => (outcome, Outcome::Ok),
        },
    };
    let other = if first == Outcome::Timeout { first } else { stop };
    Expected { first, beside: Some(stop), other, same: None }
}

/// Set-points whose answers are counted: all that is found is read, and a lost answer is no error.
fn servo_session((when, found): (When, Vec<Found>)) -> Expected {
    let failed = found.iter().enumerate().find_map(|(place, _)| {
        let (outcome, _) = end(&found[place..], Kind::ServoSession)?;
        (outcome != Outcome::Ok).then_some(outcome)
    });
    let first = match (when, failed) {
        (When::Never, _) => Outcome::Timeout,
        (_, Some(failed)) => failed,
        (_, None) => Outcome::Ok,
    };
    let (other, same) = match first {
        Outcome::Broken(_) => (first, Outcome::NotAcknowledged),
        Outcome::Timeout => (first, first),
        _ => (Outcome::Ok, Outcome::Ok),
    };
    Expected { first, beside: None, other, same: Some(same) }
}
