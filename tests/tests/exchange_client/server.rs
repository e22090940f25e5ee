//! The server: the requests that it has received, and what it writes.

use std::collections::{HashSet, VecDeque};
use std::fmt;

use proptest::prelude::*;

use jaka_sync::proto::exchange::Support;

use crate::model::{NAMES, STOP, TUPLE, support};

/// A move of the server.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Move {
    /// Accepts the oldest request that has no reply.
    Accept,
    Refuse,
    /// Answers the two oldest, in one write.
    AnswerTwo,
    /// Answers the newest request; the replies to those before it are lost.
    AnswerNewest,
    /// Refuses the oldest request without its name, as a controller does that does not have the command; otherwise as
    /// [`Refuse`](Self::Refuse).
    RefuseNameless,
    /// Accepts the oldest request without its name.
    AcceptAnonymous,
    /// Loses the reply to the oldest request.
    Lose,
    /// Answers the oldest request, and writes a copy of the reply in the same write.
    AnswerTwice,
    /// Writes a copy of the last reply, or that to a request before an [answer to the newest](Self::AnswerNewest): it
    /// comes out of order.
    Copy,
    /// Writes a reply to no request, with this name.
    Unasked(usize),
    /// Writes a refusal without a name, to no request.
    UnaskedNameless,
    Garbage,
    /// Closes its side.
    End,
}

impl Move {
    /// True if a reply to no outstanding request may come of it.
    pub(crate) fn is_surplus(self) -> bool {
        matches!(self, Self::AnswerTwice | Self::Copy | Self::Unasked(_) | Self::UnaskedNameless)
    }
}

pub(crate) fn any_move() -> impl Strategy<Value = Move> {
    (0u8..64, 0..NAMES.len()).prop_map(|(kind, name)| match kind {
        0..=25 => Move::Accept,
        26..=31 => Move::Refuse,
        32..=36 => Move::AnswerTwo,
        37..=39 => Move::AnswerNewest,
        40..=41 => Move::RefuseNameless,
        42 => Move::AcceptAnonymous,
        43..=50 => Move::Lose,
        51..=52 => Move::AnswerTwice,
        53..=56 => Move::Copy,
        57..=59 => Move::Unasked(name),
        60..=61 => Move::UnaskedNameless,
        62 => Move::Garbage,
        _ => Move::End,
    })
}

/// Form of a reply.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Form {
    Accepted,
    Refused,
    /// A refusal that names no command.
    Nameless,
    /// An acceptance that names no command.
    Anonymous,
}

/// A reply, with the number of the request for which it was written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Reply {
    pub(crate) number: u32,
    pub(crate) name: &'static str,
    pub(crate) form: Form,
}

/// Message of the server.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Message {
    Reply(Reply),
    Garbage,
    /// The end of the connection.
    End,
}

/// The number of replies that were written for no request.
const NO_REQUEST: u32 = 1 << 30;

/// The server.
#[derive(Debug, Default)]
pub(crate) struct Server {
    /// Requests that have been received and not answered.
    to_answer: VecDeque<(u32, &'static str)>,
    number: u32,
    /// Request of which a [copy](Move::Copy) of the reply can be written.
    last: Option<(u32, &'static str)>,
    /// Names in replies that were written: the server has these commands.
    named: HashSet<&'static str>,
    has_ended: bool,
}

impl Server {
    /// Receives a request: its number.
    pub(crate) fn receive(&mut self, name: &'static str) -> u32 {
        self.number += 1;
        self.to_answer.push_back((self.number, name));
        self.number
    }

    /// The newest request, where it has no reply, was not received after all.
    pub(crate) fn withdraw(&mut self) {
        if self.to_answer.back().is_some_and(|(number, _)| *number == self.number) {
            self.to_answer.pop_back();
        }
    }

    /// Makes a move: what is written in one piece, and the requests whose replies are lost. Of the only outstanding
    /// request, any refusal may have no name.
    pub(crate) fn make(&mut self, next: Move, outstanding: usize) -> (Vec<Message>, Vec<(u32, &'static str)>) {
        let mut lost = Vec::new();
        if self.has_ended {
            return (Vec::new(), lost);
        }
        let to_nothing = |name, form| vec![Message::Reply(reply((NO_REQUEST, name), form))];
        let written = match next {
            Move::Accept => self.answer(1, Form::Accepted),
            Move::Refuse => self.answer(1, Form::Refused),
            Move::AnswerTwo => self.answer(2, Form::Accepted),
            Move::AnswerNewest => {
                let older = self.to_answer.len().saturating_sub(1);
                lost.extend(self.to_answer.drain(..older));
                let written = self.answer(1, Form::Accepted);
                self.last = lost.last().copied().or(self.last);
                written
            }
            Move::RefuseNameless => {
                let lacks = |name| support(name) == Support::Uncertain && !self.named.contains(name);
                let may_be_nameless =
                    outstanding == 1 || self.to_answer.front().is_some_and(|(_, oldest)| lacks(*oldest));
                self.answer(1, if may_be_nameless { Form::Nameless } else { Form::Refused })
            }
            Move::AcceptAnonymous => self.answer(1, Form::Anonymous),
            Move::Lose => {
                lost.extend(self.to_answer.pop_front());
                Vec::new()
            }
            Move::AnswerTwice => self.answer(1, Form::Accepted).repeat(2),
            Move::Copy => self.last.map(|last| Message::Reply(reply(last, Form::Accepted))).into_iter().collect(),
            Move::Unasked(name) => to_nothing(NAMES[name], Form::Accepted),
            Move::UnaskedNameless => to_nothing(NAMES[0], Form::Nameless),
            Move::Garbage => vec![Message::Garbage],
            Move::End => {
                self.has_ended = true;
                vec![Message::End]
            }
        };
        for message in &written {
            if let Message::Reply(Reply { name, form: Form::Accepted | Form::Refused, .. }) = message {
                self.named.insert(name);
            }
        }
        (written, lost)
    }

    /// Replies to the oldest requests.
    pub(crate) fn answer(&mut self, count: usize, form: Form) -> Vec<Message> {
        let count = if self.has_ended { 0 } else { count.min(self.to_answer.len()) };
        let answered: Vec<_> = self.to_answer.drain(..count).collect();
        self.last = answered.last().copied().or(self.last);
        answered.into_iter().map(|request| Message::Reply(reply(request, form))).collect()
    }
}

/// A stop shows nothing of its reply but the code of a refusal: this is its number.
fn reply((number, name): (u32, &'static str), form: Form) -> Reply {
    Reply { number, name, form: if name == STOP && form == Form::Accepted { Form::Refused } else { form } }
}

impl fmt::Display for Message {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self::Reply(Reply { number, name, form }) = self else {
            return f.write_str(if *self == Self::Garbage { "garbage" } else { "" });
        };
        match form {
            Form::Accepted if *name == TUPLE => write!(f, "(0, [{number}])"),
            Form::Accepted => {
                write!(f, r#"{{"errorCode": "0", "errorMsg": "", "cmdName": "{name}", "number": {number}}}"#)
            }
            Form::Refused => write!(f, r#"{{"errorCode": "{number}", "errorMsg": "", "cmdName": "{name}"}}"#),
            Form::Nameless => write!(f, r#"{{"errorCode": "{number}", "errorMsg": ""}}"#),
            Form::Anonymous => write!(f, r#"{{"errorCode": "0", "errorMsg": "", "number": {number}}}"#),
        }
    }
}

/// The number in the text of an acceptance: its last.
pub(crate) fn number_in(text: &str) -> u32 {
    let digits = text.rsplit(|character: char| !character.is_ascii_digit()).find(|digits| !digits.is_empty());
    digits.and_then(|digits| digits.parse().ok()).expect("the server numbers its replies")
}
