//! What keeps motions back until it has been acknowledged.

use std::ops::ControlFlow;
use std::sync::{Arc, Mutex};

use jaka_sync::layer::{Clock, MonitorParts as _, lock};

use super::stops::Stops;
use super::{MotionStatus, trouble};
use crate::{Cause, Error, ErrorKind, Monitor, Occurrence};

/// What keeps the motions of a robot back until it has been acknowledged: a stop that a packet has shown, a lost status, a packet that tells
/// nothing because its own type has panicked, and stops of handles that no [`End`](crate::End) has reported.
///
/// A clone sees all that sets it later, but not what is reported or acknowledged later.
#[derive(Debug, Clone)]
pub(crate) struct Latch {
    /// Set by the monitor's thread, too. Locked after the link's state, and nothing else is locked under it: the order of locks stands
    /// at [`Link`](crate::link::Link).
    occurrence: Arc<Mutex<Option<Occurrence>>>,
    /// The stops of the robot's handles.
    pub(crate) stops: Arc<Stops>,
    /// The number of the latest stop that has been reported to the program.
    reported: u64,
}

impl Latch {
    /// A latch that each stop sets that a packet of the monitor shows, for as long as the robot lives.
    pub(super) fn new<S: MotionStatus>(monitor: &Monitor<S>, clock: &Clock) -> Self {
        let latch = Self { occurrence: Arc::default(), stops: Arc::new(Stops::new(clock)), reported: 0 };
        let occurrence = Arc::downgrade(&latch.occurrence);
        monitor.observe_first(move |snapshot| {
            let Some(occurrence) = occurrence.upgrade() else {
                return ControlFlow::Break(());
            };
            let packet = S::snapshot(snapshot);
            // A packet that tells nothing may have shown a stop.
            let panicked = packet.panicked().cloned();
            let lost = panicked.map(|source| Occurrence::status_lost(None, Some(source)));
            if let Some(found) = trouble::stop(&packet.status).map(|stop| stop.cause().into()).or(lost) {
                put(&occurrence, found);
            }
            ControlFlow::Continue(())
        });
        latch
    }

    /// Sets it. What has set it first stays, but a stop that a packet shows takes the place of a lost status.
    pub(super) fn set(&self, occurrence: &Occurrence) {
        put(&self.occurrence, occurrence.clone());
    }

    /// What must be acknowledged, if something must.
    pub(super) fn unacknowledged(&self) -> Option<Occurrence> {
        lock(&self.occurrence).clone().or_else(|| self.stops.pending(self.reported))
    }

    /// What must be acknowledged apart from a lost status: set-points that brake and hold the arm do not wait for that.
    pub(crate) fn unacknowledged_stop(&self) -> Option<Occurrence> {
        let shown = lock(&self.occurrence).clone().filter(|occurrence| !is_lost(occurrence));
        shown.or_else(|| self.stops.pending(self.reported))
    }

    /// Fails while something must be acknowledged.
    pub(crate) fn check(&self) -> Result<(), Error> {
        self.unacknowledged().map_or(Ok(()), |occurrence| Err(ErrorKind::NotAcknowledged { occurrence }.into()))
    }

    /// Clears it. A stop that is on its way still keeps motions back.
    pub(super) fn acknowledge(&mut self) {
        *lock(&self.occurrence) = None;
        self.reported = self.stops.begun();
    }

    /// True if a stop has gone out, or is about to, that has not been reported to the program.
    pub(super) fn has_sent_stop(&self) -> bool {
        self.stops.sent() > self.reported
    }

    /// True if the controller has accepted a stop that has not been reported to the program.
    pub(super) fn has_unreported_stop(&self) -> bool {
        self.stops.taken() > self.reported
    }

    /// The number of the latest stop that has been reported to the program.
    pub(super) fn reported(&self) -> u64 {
        self.reported
    }

    /// One stop is reported to the program. One before it that was not, or one after it, keeps motions back as before.
    pub(super) fn report_stop(&mut self, number: u64) {
        if number == self.reported + 1 {
            self.reported = number;
        }
    }

    /// The stops that the controller has accepted are reported to the program.
    pub(super) fn report_stops(&mut self) {
        self.reported = self.reported.max(self.stops.taken());
    }
}

fn put(latched: &Mutex<Option<Occurrence>>, found: Occurrence) {
    let mut latched = lock(latched);
    if latched.as_ref().is_none_or(|first| is_lost(first) && !is_lost(&found)) {
        *latched = Some(found);
    }
}

fn is_lost(occurrence: &Occurrence) -> bool {
    occurrence.cause == Cause::StatusLost
}
