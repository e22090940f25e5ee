//! What happens in a run, one thing after the other.

use proptest::prelude::*;

use crate::model::{Actor, STOP};

/// The client's own thread; the others have stop handles.
pub(crate) const CLIENT: Actor = 0;
pub(crate) const STOPS: [Actor; 2] = [1, 2];

/// What the client calls. Its stop has the name of the stop handles'.
pub(crate) const NAMES: [&str; 3] = ["query_a", "query_b", STOP];

#[derive(Debug, Clone, Copy)]
pub(crate) enum Step {
    Call(usize),
    /// A call whose deadline passes before the server does anything.
    CallInVain(usize),
    Stop(usize),
    /// A query and a stop at the same time, from two threads.
    CallAndStop(usize, usize),
    /// The server answers the oldest command that has no answer.
    Answer,
    /// The two oldest, in one write.
    AnswerTwo,
    AnswerNameless,
    Lose,
    /// The answer, and a copy of it in the same write.
    AnswerTwice,
    /// A copy of the last answer.
    Copy,
    Unasked(usize),
    Garbage,
    /// The server closes its side.
    End,
}

pub(crate) fn any_step() -> impl Strategy<Value = Step> {
    (0u8..64, 0..NAMES.len(), 0..STOPS.len()).prop_map(|(kind, name, handle)| match kind {
        0..=13 => Step::Call(name),
        14..=17 => Step::CallInVain(name),
        18..=25 => Step::Stop(handle),
        26..=29 => Step::CallAndStop(name % 2, handle),
        30..=49 => Step::Answer,
        50..=52 => Step::AnswerTwo,
        53 => Step::AnswerNameless,
        54..=57 => Step::Lose,
        58 => Step::AnswerTwice,
        59..=60 => Step::Copy,
        61 => Step::Unasked(name),
        62 => Step::Garbage,
        _ => Step::End,
    })
}

/// Whether stop handles wait, or give up before the server does anything.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Handles {
    Patient,
    Hasty,
}
