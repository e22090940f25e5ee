//! Guards that judge packets, and their progress.

use std::collections::BTreeMap;
use std::fmt;
use std::io;
use std::sync::{Arc, Weak};

use jaka_proto::wire::DecodeError;

use super::status::unknown;
use crate::{Error, ErrorKind, GuardTrip, Snapshot, StatusProblem};

/// Sees each packet that comes.
pub(crate) trait PacketObserver: fmt::Debug + Send + Sync {
    /// Sees a packet, on the monitor's thread, without the lock of the arm's state.
    fn observe(&self, packet: &Arc<Snapshot>);
}

/// Guards that are armed, by their numbers.
#[derive(Debug, Default)]
pub(super) struct Guards {
    observers: BTreeMap<u64, Weak<dyn PacketObserver>>,
    progress: BTreeMap<u64, GuardProgress>,
    next: u64,
}

impl Guards {
    /// Number of one that is to be armed.
    pub(super) fn number(&mut self) -> u64 {
        self.next += 1;
        self.next
    }

    /// Arms one.
    pub(super) fn add(&mut self, number: u64, observer: Weak<dyn PacketObserver>) {
        self.observers.insert(number, observer);
    }

    /// Removes one, which is dropped without a lock.
    pub(super) fn remove(&mut self, number: u64) -> (Option<Weak<dyn PacketObserver>>, Option<GuardProgress>) {
        (self.observers.remove(&number), self.progress.remove(&number))
    }

    pub(super) fn is_empty(&self) -> bool {
        self.observers.is_empty()
    }

    /// Guards that still exist.
    pub(super) fn armed(&self) -> Vec<Arc<dyn PacketObserver>> {
        self.observers.values().filter_map(Weak::upgrade).collect()
    }

    /// Progress of one guard.
    pub(super) fn progress(&mut self, number: u64) -> &mut GuardProgress {
        self.progress.entry(number).or_default()
    }
}

/// Progress of a guard with its motion.
#[derive(Debug, Default)]
pub(crate) struct GuardProgress {
    trip: Option<GuardTrip>,
    /// Reason why the status was not known before the motion was let out, if that was so: then it is not any more.
    blind: Option<StatusProblem>,
    /// True once the motion was let out.
    has_begun: bool,
    /// Reason why a packet could not be judged, if one could not: as a rule, its own type has panicked.
    broken: Option<DecodeError>,
    /// True once nobody watches the guard any more.
    is_abandoned: bool,
}

impl GuardProgress {
    /// Trip of the guard, if it has tripped.
    pub(crate) fn trip(&self) -> Option<&GuardTrip> {
        self.trip.as_ref()
    }

    /// Reason why a packet could not be judged, if one could not.
    pub(crate) fn broken(&self) -> Option<StatusProblem> {
        self.broken.clone().map(|source| StatusProblem::Unreadable { source })
    }

    /// True if the motion was let out.
    pub(crate) fn has_begun(&self) -> bool {
        self.has_begun
    }

    /// Lets the motion out, unless the guard has tripped: from here on, a trip calls for a stop.
    pub(crate) fn let_out(&mut self) -> Result<(), Error> {
        if let Some(trip) = self.trip.clone() {
            return Err(trip.before_start().into());
        }
        if let Some(problem) = self.blind.clone().or_else(|| self.broken()) {
            return Err(unknown(problem));
        }
        if self.is_abandoned {
            let source = io::Error::other("the thread that watches the guard has panicked");
            return Err(ErrorKind::Thread { source }.into());
        }
        self.has_begun = true;
        Ok(())
    }

    /// Does not let the motion out any more, and says whether it was. `blind` is why the status is not known, where
    /// that is the reason.
    pub(crate) fn shut(&mut self, blind: Option<StatusProblem>) -> bool {
        self.blind = blind;
        self.has_begun
    }

    /// Nobody watches the guard any more: does not let the motion out, and says whether it was.
    pub(crate) fn abandon(&mut self) -> bool {
        self.is_abandoned = true;
        self.has_begun
    }

    /// Takes a judgement: true if it is the first for which the arm is stopped.
    pub(crate) fn take(&mut self, judged: Result<Option<GuardTrip>, DecodeError>) -> bool {
        let calls_for_stop = self.has_begun && self.trip.is_none() && self.broken.is_none();
        match judged {
            Ok(None) => return false,
            Ok(Some(_)) if self.trip.is_some() => return false,
            Ok(trip) => self.trip = trip,
            Err(source) => self.broken = Some(source),
        }
        calls_for_stop
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_nobody_watches_is_not_let_out() {
        let mut watched = GuardProgress::default();
        assert!(watched.let_out().is_ok() && watched.abandon(), "it is out");
        let mut abandoned = GuardProgress::default();
        assert!(!abandoned.abandon());
        let error = abandoned.let_out().expect_err("nobody watches it");
        assert!(matches!(error.kind(), ErrorKind::Thread { .. }) && !error.may_have_run(), "{error:?}");
        assert!(!abandoned.has_begun());
    }
}
