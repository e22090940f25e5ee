//! Waiting for the end of a batch: packets, stops, and the controller's answers.

use std::sync::Arc;
use std::time::{Duration, Instant};

use super::rule::EndRule;
use crate::arm::{Answer, Arm};
use crate::{Cause, Disconnect, Occurrence, Rest, Snapshot};

/// Longest wait for an answer before packets and stops are checked again.
const SLICE: Duration = Duration::from_millis(10);

/// Next step of the wait, by packets and stops.
#[derive(Debug)]
enum Next {
    Ended(Occurrence, Rest),
    /// It is time to send a query, or to check for its answer.
    Query,
}

/// Arrival of the last packet that can be read.
#[derive(Debug)]
struct Heard {
    at: Instant,
    number: u64,
    unreadable: Option<Arc<Snapshot>>,
}

/// A wait for the end of a batch.
pub(super) struct EndWait<'a> {
    pub(super) arm: &'a mut Arm,
    pub(super) rule: &'a mut EndRule,
    /// Longest time without a status packet.
    pub(super) silence: Duration,
}

impl EndWait<'_> {
    /// Waits until the motions have ended, or it is certain that their end cannot be observed. A stop, an error, a lost
    /// connection and the deadline end the wait at once, also while an answer is outstanding; and so does `gives_up`,
    /// as the deadline does.
    pub(super) fn end(&mut self, timeout: Duration, gives_up: &dyn Fn() -> bool) -> (Occurrence, Rest) {
        let since = self.arm.clock().stopwatch();
        let mut heard = Heard { at: since.began, number: 0, unreadable: None };
        loop {
            let left = since.left_of(timeout);
            let silence = self.silence.saturating_sub(self.arm.clock().elapsed(heard.at));
            let patience = left.min(silence).min(self.query_in());
            let state = Arc::clone(&self.arm.state);
            let found = state.watch(patience, |newest| {
                let next = self.observe(newest, &mut heard);
                next.or_else(|| gives_up().then(|| Next::ended(Cause::Deadline)))
            });
            match found {
                Ok(Some(Next::Ended(occurrence, rest))) => return self.told(occurrence, rest),
                Err(cause) => return (Occurrence::status_lost(Some(cause), None), Rest::NotSeen),
                Ok(_) if left.is_zero() => return (Cause::Deadline.into(), Rest::NotSeen),
                Ok(_) if self.arm.clock().elapsed(heard.at) >= self.silence => return (heard.lost(), Rest::NotSeen),
                Ok(_) => {}
            }
            if let Some(cause) = self.look_up(left) {
                return self.told(cause, Rest::Answers);
            }
        }
    }

    /// Time until a query is due or its answer is to be checked for, if no packet comes before.
    fn query_in(&self) -> Duration {
        if self.arm.position.is_asked() {
            return Duration::ZERO;
        }
        self.rule.query_in(self.arm.clock().now())
    }

    /// Checks the newest packet, the stops, and the connection on which the arm could be stopped, and returns the next
    /// step, if they show one.
    fn observe(&mut self, newest: Option<&Arc<Snapshot>>, heard: &mut Heard) -> Option<Next> {
        if self.arm.state.lock().stops.has_unreported() {
            return Some(Next::ended(Cause::Stopped));
        }
        let shown = newest.filter(|newest| heard.takes(newest)).and_then(|newest| self.rule.packet(newest));
        match (shown, self.lost()) {
            // Packets alone do not prove that the arm rests.
            (None | Some((Occurrence { cause: Cause::AtRest, .. }, _)), Some(cause)) => {
                Some(Next::ended(Occurrence::commands_lost(self.arm.link().address(), cause)))
            }
            (Some((occurrence, rest)), _) => Some(Next::Ended(occurrence, rest)),
            (None, None) => {
                let is_due = || self.rule.query(self.arm.clock().now()).is_some();
                (self.arm.position.is_asked() || is_due()).then_some(Next::Query)
            }
        }
    }

    /// Cause of the loss of the connection on which the arm could be stopped, if it is lost. A query that is
    /// outstanding reads by itself.
    fn lost(&self) -> Option<Arc<Disconnect>> {
        let link = self.arm.link();
        if self.arm.position.is_asked() { link.broken() } else { link.lost() }
    }

    /// Queries the arm's position, if it is time, and takes the answer, if it has come.
    fn look_up(&mut self, left: Duration) -> Option<Occurrence> {
        let now = |arm: &Arm| arm.clock().now();
        if !self.arm.position.is_asked() {
            let quantity = self.rule.query(now(self.arm))?;
            self.rule.asked(now(self.arm));
            if let Err(error) = self.arm.position.ask(quantity) {
                self.rule.no_answer(error);
                return None;
            }
        }
        match self.arm.position.answer(SLICE.min(left))? {
            Answer { place: Ok(place), asked, answered } => self.rule.answer(place, asked, answered),
            Answer { place: Err(error), .. } => {
                self.rule.no_answer(error);
                None
            }
        }
    }

    /// The end as reported to the program. With an unknown target, the arm may be at rest because of a stop whose reply
    /// has not come.
    fn told(&self, occurrence: Occurrence, rest: Rest) -> (Occurrence, Rest) {
        let is_stopping = occurrence.cause == Cause::AtRest && self.arm.state.lock().stops.is_under_way();
        (if is_stopping { Cause::Stopped.into() } else { occurrence }, rest)
    }
}

impl Next {
    fn ended(occurrence: impl Into<Occurrence>) -> Self {
        Self::Ended(occurrence.into(), Rest::NotSeen)
    }
}

impl Heard {
    /// True if a packet is new and can be read.
    fn takes(&mut self, newest: &Arc<Snapshot>) -> bool {
        if newest.number <= self.number {
            return false;
        }
        self.number = newest.number;
        if newest.unreadable().is_some() {
            self.unreadable = Some(Arc::clone(newest));
            return false;
        }
        self.unreadable = None;
        self.at = self.at.max(newest.received);
        true
    }

    fn lost(self) -> Occurrence {
        let unreadable = self.unreadable.as_ref().and_then(|packet| packet.unreadable());
        Occurrence::status_lost(None, unreadable)
    }
}
