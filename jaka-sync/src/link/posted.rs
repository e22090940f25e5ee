//! Commands whose replies are counted, and waited for by nobody in particular: set-points and the commands of a pipeline.

use std::collections::VecDeque;
use std::time::{Duration, Instant};

use jaka_proto::Ticket;

use super::Link;
use super::answer::{Caller, Progress, disconnected};
use super::state::State;
use crate::{Disconnect, Error, ErrorKind};

/// How many replies a connection may be owed when a command is posted, with those that were given up: a stop behind more than that
/// would be of little use, since the controller works off what came before it.
pub(crate) const MOST_OWED: usize = 256;

/// Commands whose replies are counted.
#[derive(Debug, Default)]
pub(super) struct Posted {
    /// In the order in which they were sent, which is that of their tickets.
    outstanding: VecDeque<Debt>,
    answers: Answers,
}

#[derive(Debug)]
struct Debt {
    ticket: Ticket,
    command: &'static str,
    since: Instant,
}

/// What became of commands that were posted, since this was last asked for.
#[derive(Debug, Default)]
pub(crate) struct Answers {
    /// How many were accepted.
    pub(crate) accepted: u64,
    /// What became of the others, in the order in which it was learnt.
    pub(crate) failed: Vec<Error>,
}

impl Posted {
    pub(super) fn sent(&mut self, ticket: Ticket, command: &'static str, since: Instant) {
        self.outstanding.push_back(Debt { ticket, command, since });
    }

    /// When the oldest command that is outstanding was sent.
    pub(super) fn oldest(&self) -> Option<Instant> {
        self.outstanding.front().map(|debt| debt.since)
    }

    pub(super) fn outstanding(&self) -> usize {
        self.outstanding.len()
    }

    /// Takes off a command that is outstanding, and says which it was. Most often it is the oldest.
    pub(super) fn settle(&mut self, ticket: Ticket) -> Option<&'static str> {
        let place = self.outstanding.binary_search_by_key(&ticket, |debt| debt.ticket).ok()?;
        let command = self.outstanding[place].command;
        self.outstanding.remove(place);
        Some(command)
    }

    pub(super) fn answered(&mut self, answer: Result<(), Error>) {
        match answer {
            Ok(()) => self.answers.accepted += 1,
            Err(error) => self.answers.failed.push(error),
        }
    }

    /// Takes off a command with what became of it; false if it is none of these.
    pub(super) fn fail(&mut self, ticket: Ticket, error: impl FnOnce(&str) -> Error) -> bool {
        let command = self.settle(ticket);
        self.answers.failed.extend(command.map(error));
        command.is_some()
    }
}

/// The error for a command whose reply has not come in time.
pub(super) fn time_up(command: &str, after: Duration) -> Error {
    ErrorKind::Timeout { command: command.to_owned(), after }.into()
}

impl Link {
    /// Reads what has come, without waiting, and takes what became of posted commands; and an error if the connection is
    /// broken. Where another thread is reading, what it has read so far has to do.
    pub(crate) fn drain(&self, command: &str) -> (Answers, Result<(), Error>) {
        let mut state = self.lock();
        if let Err(cause) = self.settle_arrived(&mut state) {
            self.break_off(&mut state, cause);
        }
        (self.take_answers(&mut state), self.check(&state, command, Progress::Sent))
    }

    /// Waits until at most so many posted commands are outstanding, each for at most `timeout` since it was sent, and takes
    /// what became of them; and an error if the connection is broken.
    pub(crate) fn wait_for_posted(&self, most: usize, timeout: Duration) -> (Answers, Result<(), Error>) {
        let mut state = self.lock();
        let mut checked = Ok(());
        while state.posted.outstanding.len() > most && checked.is_ok() {
            let Some(oldest) = state.posted.outstanding.front() else { break };
            let (ticket, command, left) =
                (oldest.ticket, oldest.command, timeout.saturating_sub(oldest.since.elapsed()));
            if left.is_zero() {
                self.give_up_posted(&mut state, ticket, timeout);
            } else if state.broken.is_none() {
                state = self.turn(state, left, &mut Caller::nobody());
            }
            checked = self.check(&state, command, Progress::Sent);
        }
        (self.take_answers(&mut state), checked)
    }

    /// How many more commands may be posted: none where too many replies are owed, also those that were given up.
    pub(crate) fn room(&self) -> usize {
        MOST_OWED.saturating_sub(self.lock().ledger.outstanding())
    }

    /// Waits until there is [`room`](Self::room) to post `command`.
    pub(crate) fn wait_for_room(&self, command: &str, timeout: Duration) -> Result<(), Error> {
        let since = Instant::now();
        let mut state = self.lock();
        while state.ledger.outstanding() >= MOST_OWED {
            self.check(&state, command, Progress::NotSent)?;
            let left = timeout.saturating_sub(since.elapsed());
            if left.is_zero() {
                let not_sent = ErrorKind::NotSentInTime { command: command.to_owned(), after: timeout };
                return Err(self.attach(not_sent.into()));
            }
            state = self.turn(state, left, &mut Caller::nobody());
        }
        Ok(())
    }

    /// How many posted commands are outstanding.
    pub(crate) fn outstanding(&self) -> usize {
        self.lock().posted.outstanding()
    }

    /// For how long the oldest posted command has been outstanding; none if none is.
    pub(crate) fn oldest_posted(&self) -> Option<Duration> {
        self.lock().posted.oldest().map(|since| since.elapsed())
    }

    /// Gives up the replies to all posted commands that have not come: they belong to nobody when they come. Takes what became of the
    /// others, and says how many were given up.
    pub(crate) fn forget_posted(&self) -> (Answers, u64) {
        let mut state = self.lock();
        // A pipeline is dropped also while a panic unwinds, which a logger's must not meet.
        let settled = if std::thread::panicking() { Ok(()) } else { self.settle_arrived(&mut state) };
        if let Err(cause) = settled {
            self.break_off(&mut state, cause);
        }
        let mut given_up = 0;
        while let Some(debt) = state.posted.outstanding.pop_front() {
            given_up += 1;
            state.ledger.abandon(debt.ticket);
        }
        (self.take_answers(&mut state), given_up)
    }

    fn give_up_posted(&self, state: &mut State, ticket: Ticket, timeout: Duration) {
        match state.ledger.give_up(ticket) {
            Ok(()) => drop(state.posted.fail(ticket, |command| time_up(command, timeout))),
            Err(mistrust) => drop(self.break_off(state, Disconnect::Mistrust(mistrust))),
        }
    }

    fn take_answers(&self, state: &mut State) -> Answers {
        let mut answers = std::mem::take(&mut state.posted.answers);
        answers.failed = answers.failed.into_iter().map(|error| self.attach(error)).collect();
        answers
    }

    fn check(&self, state: &State, command: &str, progress: Progress) -> Result<(), Error> {
        let broken = state.broken.clone();
        broken.map_or(Ok(()), |cause| Err(self.attach(disconnected(command, progress, cause))))
    }
}
