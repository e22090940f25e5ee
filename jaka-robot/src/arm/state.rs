//! State of an arm: its known facts, and the check that something may be sent to it.

use std::mem;
use std::ops::ControlFlow;
use std::sync::{Arc, Weak};
use std::time::Duration;

use jaka_clock::Clock;
#[cfg(not(all(test, shuttle)))]
use jaka_sync::layer::Watched;
use jaka_sync::layer::{Kept, Stops};
use jaka_sync::layer::{MonitorParts as _, StatusNews};

use super::guards::{GuardProgress, Guards, PacketObserver};
use super::status::{Status, check_braking, check_stops, unknown};
use super::trouble::{self, PacketNews, Since};
#[cfg(all(test, shuttle))]
use crate::sync::Watched;
use crate::{
    Cause, Disconnect, Error, ErrorKind, Monitor, MotionStatus, Occurrence, ServoModeState, Snapshot, StatusProblem,
};

/// Kind of a command that is to be sent to an arm.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Sending {
    /// Motion that the controller plans.
    Motion,
    /// Set-point that moves the arm, or the entry into servo mode.
    SetPoint,
    /// A set-point that brakes it.
    Braking,
    /// A set-point at the present position of the arm.
    Holding,
}

/// State of the arm of one command connection. Monitors can be shared by several.
///
/// # Order of locks
/// 1. The conditions of a guard, and then its stop: both in `guard/armed.rs`. A program's own questions run under the
///    first.
/// 2. The state of the command connection, in jaka-sync's `Link`. Gates run under it.
/// 3. The state of an arm, here. Nothing is locked under it: no I/O, no code of a program, no log, no conversion and no
///    drop of a packet. The board of a monitor, in jaka-sync, is never locked together with it.
#[derive(Debug)]
pub(crate) struct ArmState {
    known: Watched<Known>,
    /// Stops of the command connection. Locked apart from the known facts, never under them.
    stops: Arc<Stops>,
    stale_after: Duration,
}

/// Known facts of an arm.
#[derive(Debug)]
pub(crate) struct Known {
    status: Status,
    /// News of all packets, also of those that newer ones have overtaken.
    news: PacketNews,
    /// Occurrence that must be acknowledged: a stop or drag mode that a packet has shown, a lost status, or a packet
    /// that tells nothing because its own type has panicked.
    latched: Option<Occurrence>,
    guards: Guards,
    /// Packets that guards have not judged yet.
    unjudged: Vec<Arc<Snapshot>>,
    /// False if the program has allowed motion without status.
    needs_status: bool,
    /// Number of wake-ups of waiting threads.
    wakes: u64,
}

impl ArmState {
    /// State that follows a monitor, for as long as it lives.
    pub(crate) fn new<S: MotionStatus>(monitor: &Monitor<S>, stops: &Arc<Stops>, needs_status: bool) -> Arc<Self> {
        let state = Self::before_news(monitor.address(), monitor.stale_after(), stops, needs_status);
        let state = Arc::new(state);
        let weak = Arc::downgrade(&state);
        monitor.listen(move |news| take_into::<S>(&weak, news));
        // Earlier news keeps nothing back by itself, and is known already where packets have come meanwhile.
        monitor.tell_known(|news| match news {
            StatusNews::Packet { packet, .. } => {
                let packet = S::snapshot(packet);
                let mut known = state.lock();
                if known.status.newest().is_none() {
                    known.news.take(&packet.status, packet.number);
                }
                known.status.begin(packet);
            }
            news => state.take(news),
        });
        state
    }

    /// State before any news of a status port at this address, whose packets are stale after this time.
    pub(super) fn before_news(address: String, stale_after: Duration, stops: &Arc<Stops>, needs_status: bool) -> Self {
        let known = Known {
            status: Status::new(address, stale_after),
            news: PacketNews::default(),
            latched: None,
            guards: Guards::default(),
            unjudged: Vec::new(),
            needs_status,
            wakes: 0,
        };
        Self { known: Watched::new(stops.clock(), known), stops: Arc::clone(stops), stale_after }
    }

    /// Takes news of the status port.
    pub(super) fn take<S: MotionStatus>(&self, news: StatusNews<'_, S>) {
        match news {
            StatusNews::Packet { packet, is_newest } => return self.take_packet(&S::snapshot(packet), is_newest),
            StatusNews::Shown => self.judge(),
            StatusNews::Unreadable(source) => self.lock().status.take_unreadable(source.clone()),
            StatusNews::Reconnecting => self.lock().status.take_reconnecting(),
            StatusNews::Ended(cause) => self.lock().status.take_end(Arc::clone(cause)),
        }
        self.wake();
    }

    /// From here on gates know of a packet. Guards, which run code of the program, judge it later.
    fn take_packet(&self, packet: &Arc<Snapshot>, is_newest: bool) {
        // A packet without information may have hidden a stop.
        let panicked = packet.panicked().cloned().map(|source| Occurrence::status_lost(None, Some(source)));
        let stop = trouble::stop(&packet.status);
        let found = stop.map(|stop| stop.cause().into()).or(panicked);
        let mut known = self.lock();
        if let Some(found) = found {
            known.latch(found);
        }
        known.news.take(&packet.status, packet.number);
        let before = if is_newest { known.status.take(Arc::clone(packet)) } else { None };
        if !known.guards.is_empty() {
            known.unjudged.push(Arc::clone(packet));
        }
        drop(known);
        drop(before);
        // After the packet, from which a gate has the cause.
        if stop.is_some() {
            self.stops.require_rest();
        }
    }

    fn judge(&self) {
        let mut known = self.lock();
        if known.unjudged.is_empty() {
            return;
        }
        let (packets, guards) = (mem::take(&mut known.unjudged), known.guards.armed());
        drop(known);
        for guard in guards {
            for packet in &packets {
                guard.observe(packet);
            }
        }
    }

    /// Locks the known facts. While the lock is held, nothing else is locked, and nothing else is done.
    pub(crate) fn lock(&self) -> impl std::ops::DerefMut<Target = Known> + '_ {
        self.known.lock()
    }

    /// Has the threads in [`watch`](Self::watch) check again.
    pub(crate) fn wake(&self) {
        self.lock().wakes += 1;
        self.known.wake();
    }

    /// Clock of the arm's connections.
    pub(crate) fn clock(&self) -> &Clock {
        self.known.clock()
    }

    /// Address of the status port.
    pub(super) fn address(&self) -> String {
        self.lock().status.address().to_owned()
    }

    /// Age from which a packet is stale.
    pub(crate) fn stale_after(&self) -> Duration {
        self.stale_after
    }

    /// Fails if this may not be sent now. As a gate it blocks nothing and uses no connection.
    ///
    /// A stop that has begun by the time of the write is on the wire before it, or will be sent after it.
    pub(super) fn may_send(&self, what: Sending) -> Result<(), Error> {
        self.packets_permit(what)?;
        match what {
            Sending::Motion => self.stops.check_motion(),
            Sending::SetPoint | Sending::Holding => self.stops.check_set_point(),
            // Until a stop goes out.
            Sending::Braking => self.stops.check_braking(),
        }
        .map_err(kept_back)
    }

    /// Fails if packets keep this back.
    fn packets_permit(&self, what: Sending) -> Result<(), Error> {
        let known = self.lock();
        let latched = match what {
            Sending::Motion | Sending::SetPoint => {
                if known.needs_status {
                    check_stops(known.status.fresh_status().map_err(unknown)?)?;
                }
                known.latched.as_ref()
            }
            // These two also if the status is unknown.
            Sending::Braking => {
                known.status.fresh_status().map_or(Ok(()), |newest| check_braking(newest))?;
                known.latched.as_ref().filter(|latched| !lets_brake(latched))
            }
            Sending::Holding => {
                known.status.fresh_status().map_or(Ok(()), |newest| check_stops(newest))?;
                known.latched.as_ref().filter(|occurrence| !is_lost(occurrence))
            }
        };
        latched.cloned().map_or(Ok(()), |occurrence| Err(not_acknowledged(occurrence)))
    }

    /// Occurrence that must be acknowledged, if there is one.
    pub(super) fn unacknowledged(&self) -> Option<Occurrence> {
        let latched = self.lock().latched.clone();
        latched.or_else(|| self.stop())
    }

    /// Occurrence that must be acknowledged, apart from a lost status: set-points that brake and hold the arm do not
    /// wait for that.
    pub(super) fn unacknowledged_stop(&self) -> Option<Occurrence> {
        let latched = self.lock().latched.clone().filter(|occurrence| !is_lost(occurrence));
        latched.or_else(|| self.stop())
    }

    /// True while a stop that a packet has shown, or a lost status, keeps motions back.
    pub(super) fn is_latched(&self) -> bool {
        self.lock().latched.is_some()
    }

    /// Stop of the program that keeps motions back, if there is one.
    fn stop(&self) -> Option<Occurrence> {
        self.stops.is_held().then(|| Cause::Stopped.into())
    }

    /// Keeps motions back from now on. Of several occurrences the first by [precedence](Cause#precedence) stays.
    pub(crate) fn latch(&self, occurrence: &Occurrence) {
        let occurrence = occurrence.clone();
        self.lock().latch(occurrence);
    }

    /// Acknowledges. A stop that is on its way still keeps motions back.
    pub(crate) fn acknowledge(&self) {
        let mut known = self.lock();
        let before = known.latched.take();
        drop(known);
        drop(before);
        self.stops.acknowledge();
    }

    /// Sets whether motions need a known status.
    pub(crate) fn set_needs_status(&self, needs_status: bool) {
        self.lock().needs_status = needs_status;
    }

    /// True if the program has allowed motion without status.
    pub(crate) fn moves_without_status(&self) -> bool {
        !self.lock().needs_status
    }

    /// News of packets: the first by precedence of those that count.
    pub(crate) fn news(&self, since: Since, counts: impl Fn(Cause) -> bool) -> Option<Occurrence> {
        self.lock().news.after(since).find(|occurrence| counts(occurrence.cause))
    }

    /// First news of packets by precedence, and an event that is in no table: that one counts only at rest.
    pub(crate) fn news_of_motion(&self, since: Since) -> (Option<Occurrence>, Option<Occurrence>) {
        let known = self.lock();
        (known.news.after(since).next(), known.news.unknown_after(since))
    }

    /// True if the next packet may confirm a loss of power or enabling that the newest one shows.
    pub(crate) fn has_unconfirmed_news(&self) -> bool {
        self.lock().news.is_unconfirmed()
    }

    /// Newest packet by now: news after it is new.
    pub(crate) fn now_on(&self) -> Since {
        Since::packet(self.lock().status.newest().map_or(0, |newest| newest.number))
    }

    /// Newest packet, which may be old.
    pub(crate) fn newest_packet(&self) -> Option<Arc<Snapshot>> {
        self.lock().status.newest().cloned()
    }

    /// Newest packet, if the connection is there and the packet is fresh.
    pub(crate) fn fresh_packet(&self) -> Result<Arc<Snapshot>, StatusProblem> {
        self.lock().status.fresh_packet().cloned()
    }

    /// Newest packet, as [`fresh_packet`](Self::fresh_packet), if it shows whether the arm is stopped.
    pub(crate) fn fresh_status(&self) -> Result<Arc<Snapshot>, StatusProblem> {
        self.lock().status.fresh_status().cloned()
    }

    /// Newest packet, as [`fresh_status`](Self::fresh_status). If none has come lately, waits a little for one.
    pub(crate) fn status_within(&self, timeout: Duration) -> Result<Arc<Snapshot>, StatusProblem> {
        let now = self.fresh_status();
        if !matches!(now, Err(StatusProblem::Missing { .. } | StatusProblem::Stale { .. } | StatusProblem::Resuming)) {
            return now;
        }
        // Its result is what `fresh_status` says next.
        let _ = self.watch(self.stale_after.min(timeout), |_| self.fresh_packet().ok());
        self.fresh_status()
    }

    /// Calls `find` with each newest packet as it comes, and after each [`wake`](Self::wake), until it has found
    /// something; none after `timeout`, and the cause once the status port has ended.
    pub(crate) fn watch<T>(
        &self,
        timeout: Duration,
        mut find: impl FnMut(Option<&Arc<Snapshot>>) -> Option<T>,
    ) -> Result<Option<T>, Arc<Disconnect>> {
        let since = self.clock().stopwatch();
        let mut seen = 0;
        loop {
            let known = self.lock();
            let (newest, wakes) = (known.status.newest().cloned(), known.wakes);
            let ended = known.status.ended().cloned();
            drop(known);
            let newest = newest.filter(|packet| packet.number > seen);
            seen = newest.as_ref().map_or(seen, |packet| packet.number);
            if let Some(found) = find(newest.as_ref()) {
                return Ok(Some(found));
            }
            drop(newest);
            if let Some(cause) = ended {
                return Err(cause);
            }
            let left = since.left_of(timeout);
            if left.is_zero() {
                return Ok(None);
            }
            let known = self.known.lock();
            if known.wakes == wakes {
                drop(self.known.wait(known, left));
            }
        }
    }

    /// Progress of an armed guard.
    pub(crate) fn progress<R>(&self, guard: u64, act: impl FnOnce(&mut GuardProgress) -> R) -> R {
        act(self.lock().guards.progress(guard))
    }

    /// Number of a guard that is to be armed.
    pub(crate) fn guard_number(&self) -> u64 {
        self.lock().guards.number()
    }

    /// Arms a guard, which sees each packet that comes from now on.
    pub(crate) fn arm_guard(&self, number: u64, guard: Weak<dyn PacketObserver>) {
        self.lock().guards.add(number, guard);
    }

    /// Disarms a guard.
    pub(crate) fn disarm(&self, guard: u64) {
        let disarmed = self.lock().guards.remove(guard);
        drop(disarmed);
    }
}

/// Takes news into a state that may not be there any more.
fn take_into<S: MotionStatus>(state: &Weak<ArmState>, news: StatusNews<'_, S>) -> ControlFlow<()> {
    let Some(state) = state.upgrade() else { return ControlFlow::Break(()) };
    state.take(news);
    ControlFlow::Continue(())
}

impl Known {
    fn latch(&mut self, found: Occurrence) {
        if self.latched.as_ref().is_none_or(|first| found.cause < first.cause) {
            self.latched = Some(found);
        }
    }
}

fn is_lost(occurrence: &Occurrence) -> bool {
    occurrence.cause == Cause::StatusLost
}

/// Error for what stops or a session keep back.
pub(crate) fn kept_back(by: Kept) -> Error {
    match by {
        Kept::Stopped => not_acknowledged(Cause::Stopped.into()),
        Kept::NotAtRest => ErrorKind::NotReady { occurrence: Cause::Moving.into() }.into(),
        Kept::Led => ErrorKind::NotReady { occurrence: ServoModeState::OnAlready.into() }.into(),
    }
}

/// True if set-points may brake the arm after an occurrence that must be acknowledged.
fn lets_brake(occurrence: &Occurrence) -> bool {
    is_lost(occurrence) || occurrence.cause == Cause::DragMode
}

pub(super) fn not_acknowledged(occurrence: Occurrence) -> Error {
    ErrorKind::NotAcknowledged { occurrence }.into()
}

#[cfg(all(test, not(shuttle)))]
mod tests {
    use super::*;

    #[test]
    fn the_first_by_precedence_of_what_must_be_acknowledged_stays() {
        let state = ArmState::before_news(String::new(), Duration::from_secs(1), &Stops::new(&Clock::default()), true);
        let latched = |cause: Cause| {
            state.latch(&cause.into());
            state.unacknowledged().map(|occurrence| occurrence.cause)
        };
        assert_eq!(latched(Cause::StatusLost), Some(Cause::StatusLost));
        assert_eq!(latched(Cause::DragMode), Some(Cause::DragMode));
        assert_eq!(latched(Cause::EmergencyStop), Some(Cause::EmergencyStop));
        for later in [Cause::StatusLost, Cause::DragMode, Cause::ProtectiveStop] {
            assert_eq!(latched(later), Some(Cause::EmergencyStop));
        }
        assert!(state.packets_permit(Sending::Braking).is_err() && state.packets_permit(Sending::Holding).is_err());
        state.acknowledge();
        assert_eq!(latched(Cause::DragMode), Some(Cause::DragMode));
        assert!(state.packets_permit(Sending::Braking).is_ok() && state.packets_permit(Sending::Holding).is_err());
    }
}
