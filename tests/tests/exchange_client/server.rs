//! The server: what it has received, and what it writes at a step.

use std::collections::VecDeque;

use crate::model::Message;
use crate::step::{NAMES, Step};

#[derive(Debug, Default)]
pub(crate) struct Server {
    /// Commands that have been received and not answered.
    to_answer: VecDeque<(&'static str, u32)>,
    number: u32,
    last: Option<(&'static str, u32)>,
    has_ended: bool,
}

impl Server {
    /// The number of the next command.
    pub(crate) fn next_number(&self) -> u32 {
        self.number + 1
    }

    /// The number of the command that is received.
    pub(crate) fn receive(&mut self, name: &'static str) -> u32 {
        self.number += 1;
        self.to_answer.push_back((name, self.number));
        self.number
    }

    /// The command whose reply is lost.
    pub(crate) fn lose(&mut self) -> Option<&'static str> {
        self.to_answer.pop_front().map(|(name, _)| name)
    }

    /// Replies to all that has been received; none once the connection has ended.
    pub(crate) fn answer_all(&mut self) -> Vec<Message> {
        if self.has_ended { Vec::new() } else { self.answer(usize::MAX) }
    }

    /// What is written in one piece; nothing once the connection has ended.
    pub(crate) fn write(&mut self, step: Step) -> Vec<Message> {
        if self.has_ended {
            return Vec::new();
        }
        self.has_ended = matches!(step, Step::End);
        match step {
            Step::Answer => self.answer(1),
            Step::AnswerTwo => self.answer(2),
            Step::AnswerNameless => self.answer_as(|_, number| vec![Message::Nameless { number }]),
            Step::AnswerTwice => {
                self.answer_as(|name, number| vec![Message::Reply { name, number }, Message::Surplus { name, number }])
            }
            Step::Copy => self.last.map(|(name, number)| Message::Surplus { name, number }).into_iter().collect(),
            Step::Unasked(name) => vec![Message::Surplus { name: NAMES[name], number: u32::MAX >> 1 }],
            Step::Garbage => vec![Message::Garbage],
            Step::End => vec![Message::End],
            Step::Call(_) | Step::CallInVain(_) | Step::Stop(_) | Step::CallAndStop(..) | Step::Lose => Vec::new(),
        }
    }

    /// Replies to the oldest commands.
    fn answer(&mut self, count: usize) -> Vec<Message> {
        let count = count.min(self.to_answer.len());
        let answered: Vec<_> = self.to_answer.drain(..count).collect();
        self.last = answered.last().copied().or(self.last);
        answered.into_iter().map(|(name, number)| Message::Reply { name, number }).collect()
    }

    fn answer_as(&mut self, messages: impl FnOnce(&'static str, u32) -> Vec<Message>) -> Vec<Message> {
        self.to_answer.pop_front().map(|(name, number)| messages(name, number)).unwrap_or_default()
    }
}
