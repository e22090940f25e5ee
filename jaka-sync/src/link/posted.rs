//! Posted commands: set-points and the commands of a pipeline. Their outcomes are counted; no thread waits for a
//! particular one.

use std::time::Duration;

use jaka_proto::exchange::{Owner, PostedOutcomes, Waiter};

use super::{Link, Transmission, failed, not_sent_in_time};
use crate::{Disconnect, Error};

/// Greatest number of outstanding requests on a connection to which commands are posted, including requests that were
/// given up. A stop after more requests would be of little use, since the controller processes them first.
pub(crate) const MOST_OUTSTANDING: usize = 256;

/// Outcomes of the posted commands of an owner, since they were last taken.
#[derive(Debug, Default)]
pub struct Answers {
    /// Number of accepted commands.
    pub accepted: u64,
    /// Outcomes of the others, in the order in which they became known.
    pub failed: Vec<Error>,
}

impl Link {
    /// Reads the bytes that have come, without waiting. Returns the outcomes of the posted commands of an owner, and an
    /// error if the connection is broken. While another thread reads, only the bytes that it has read so far count.
    pub fn drain(&self, owner: Owner, command: &str) -> (Answers, Result<(), Error>) {
        let mut state = self.arrived();
        let outcomes = state.exchange.take_posted_outcomes(owner);
        (self.answers(outcomes), self.check(&state, command, Transmission::Sent))
    }

    /// Waits until at most this many posted commands of an owner are outstanding, each for at most `timeout` since it
    /// was sent. Returns their outcomes, the number of outstanding ones, and an error if the connection is broken.
    pub(crate) fn wait_for_posted(
        &self,
        owner: Owner,
        most: usize,
        timeout: Duration,
    ) -> (Answers, usize, Result<(), Error>) {
        let mut state = self.state.lock();
        let mut checked = Ok(());
        while state.exchange.posted_outstanding(owner) > most && checked.is_ok() {
            let Some(oldest) = state.exchange.oldest_posted(owner) else { break };
            let left = timeout.saturating_sub(self.clock.elapsed(oldest.sent_at));
            if left.is_zero() {
                if let Err(out_of_sync) = state.exchange.give_up_oldest_posted(owner, timeout) {
                    self.break_off(&mut state, Disconnect::OutOfSync(out_of_sync));
                }
            } else if state.broken.is_none() {
                state = self.turn(state, left, &mut Waiter::nobody());
            }
            checked = self.check(&state, oldest.command, Transmission::Sent);
        }
        let outcomes = state.exchange.take_posted_outcomes(owner);
        (self.answers(outcomes), state.exchange.posted_outstanding(owner), checked)
    }

    /// Waits until there is room to post `command`: requests that were given up are outstanding, too. Returns the
    /// number of commands that may be posted.
    pub(crate) fn wait_for_room(&self, command: &str, timeout: Duration) -> Result<usize, Error> {
        let since = self.clock.stopwatch();
        let mut state = self.state.lock();
        loop {
            let room = MOST_OUTSTANDING.saturating_sub(state.exchange.outstanding());
            if room > 0 {
                return Ok(room);
            }
            self.check(&state, command, Transmission::NotSent)?;
            let left = since.left_of(timeout);
            if left.is_zero() {
                return Err(self.attach(not_sent_in_time(command, timeout)));
            }
            state = self.turn(state, left, &mut Waiter::nobody());
        }
    }

    /// Number of outstanding posted commands of an owner.
    pub fn outstanding(&self, owner: Owner) -> usize {
        self.state.lock().exchange.posted_outstanding(owner)
    }

    /// True if no request is outstanding, including requests that were given up.
    pub(crate) fn is_idle(&self) -> bool {
        self.state.lock().exchange.outstanding() == 0
    }

    /// Time for which the oldest posted command of an owner has been outstanding; `None` if none is.
    pub fn oldest_posted(&self, owner: Owner) -> Option<Duration> {
        self.state.lock().exchange.oldest_posted(owner).map(|oldest| self.clock.elapsed(oldest.sent_at))
    }

    /// Abandons all outstanding posted commands of an owner, which posts no more: their replies are discarded when they
    /// come. Returns the outcomes of the others and the number of abandoned commands.
    pub fn forget_posted(&self, owner: Owner) -> (Answers, u64) {
        let mut state = self.state.lock();
        // A pipeline may be dropped during a panic: then no logger must run, which may panic, too.
        let arrived = if std::thread::panicking() { Ok(()) } else { self.attribute_arrived(&mut state) };
        if let Err(cause) = arrived {
            self.break_off(&mut state, cause);
        }
        let (abandoned, outcomes) = state.exchange.abandon_posted(owner);
        (self.answers(outcomes), abandoned)
    }

    fn answers(&self, outcomes: PostedOutcomes) -> Answers {
        let errors = outcomes.failed.into_iter().map(|(command, failure)| self.attach(failed(command, failure)));
        Answers { accepted: outcomes.accepted, failed: errors.collect() }
    }
}
