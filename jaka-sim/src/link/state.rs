//! What is wrong with each link, and the threads that wait for a change.

use std::collections::VecDeque;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, Weak};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use super::wire::Wire;
use crate::fault::{LinkEvent, LinkFault};
use crate::link_selector::LinkSelector;
use crate::lock::lock;
use crate::time::{Signal, Time};
use crate::{Direction, Port};

/// How many connections may wait to end because of a fault. If there are more, the oldest ends at once.
const MOST_SENDERS: usize = 512;

/// The links of a controller.
///
/// Locks are taken in this order: `state`, a wire's queue.
#[derive(Debug)]
pub(crate) struct Links {
    /// Whether any link has ever had a fault.
    used: AtomicBool,
    state: Mutex<LinkStates>,
    changed: Signal,
    time: Time,
    senders: Mutex<VecDeque<Sender>>,
}

/// A thread that sends what has waited, and the connection on which it does.
type Sender = (Weak<Wire>, JoinHandle<()>);

/// The faults of each port in each direction.
#[derive(Debug, Default)]
pub(super) struct LinkStates {
    links: [[LinkState; 2]; 2],
}

/// One port in one direction.
#[derive(Debug, Default)]
pub(super) struct LinkState {
    fault: LinkFault,
    /// How many times it has been cut. A connection that is older than the last of these is cut.
    cuts: u64,
    /// What is to follow, in order.
    schedule: VecDeque<(Instant, LinkFault)>,
}

impl Links {
    /// The links of a controller that starts now.
    pub(crate) fn new(events: &[LinkEvent], time: &Time) -> Self {
        let mut state = LinkStates::default();
        let start = time.now();
        for event in events {
            state.schedule(event, start);
        }
        state.links.iter_mut().flatten().for_each(|link| link.catch_up(start));
        Self {
            used: AtomicBool::new(!events.is_empty()),
            state: Mutex::new(state),
            changed: Signal::new(time),
            time: time.clone(),
            senders: Mutex::default(),
        }
    }

    /// Sets what is wrong with these links from now on, and forgets what was to follow.
    pub(crate) fn set(&self, selector: LinkSelector, fault: LinkFault) {
        let mut state = lock(&self.state);
        if fault != LinkFault::None {
            self.used.store(true, Ordering::SeqCst);
        }
        for (port, direction) in selector.each() {
            let link = state.link(port, direction);
            link.schedule.clear();
            link.set(fault);
        }
        drop(state);
        self.changed.notify_all();
    }

    /// The time in which they wait.
    pub(crate) fn time(&self) -> &Time {
        &self.time
    }

    /// Whether any link has ever had a fault.
    pub(super) fn are_used(&self) -> bool {
        self.used.load(Ordering::SeqCst)
    }

    pub(super) fn state(&self) -> MutexGuard<'_, LinkStates> {
        lock(&self.state)
    }

    /// Waits for a change, or so long.
    pub(super) fn wait<'l>(
        &'l self,
        state: MutexGuard<'l, LinkStates>,
        time: Option<Duration>,
    ) -> MutexGuard<'l, LinkStates> {
        let mut waited = false;
        let time = time.unwrap_or(Duration::MAX);
        self.changed.wait_on(&self.state, state, time, |_| std::mem::replace(&mut waited, true))
    }

    /// Has all threads that wait check their link again.
    pub(super) fn notify(&self) {
        drop(self.state());
        self.changed.notify_all();
    }

    pub(super) fn add_sender(&self, sender: Sender) {
        let mut senders = lock(&self.senders);
        senders.retain(|(_, thread)| !thread.is_finished());
        senders.push_back(sender);
        let oldest = if senders.len() > MOST_SENDERS { senders.pop_front() } else { None };
        drop(senders);
        if let Some((wire, _)) = oldest {
            wire.upgrade().inspect(|wire| wire.abort());
        }
    }

    /// Ends all connections on which something waits, and waits for their threads.
    pub(crate) fn abort(&self) {
        let senders = std::mem::take(&mut *lock(&self.senders));
        for (wire, _) in &senders {
            wire.upgrade().inspect(|wire| wire.abort());
        }
        for (_, thread) in senders {
            // A panic there has been reported, and concerns one connection.
            drop(thread.join());
        }
    }
}

impl LinkStates {
    fn schedule(&mut self, event: &LinkEvent, start: Instant) {
        let Some(begin) = start.checked_add(event.after) else { return };
        let end = event.lasting.and_then(|time| begin.checked_add(time));
        for (port, direction) in event.selector.each() {
            let schedule = &mut self.link(port, direction).schedule;
            schedule.push_back((begin, event.fault));
            schedule.extend(end.map(|end| (end, LinkFault::None)));
            // Of two for the same moment, the one that was given later holds.
            schedule.make_contiguous().sort_by_key(|(at, _)| *at);
        }
    }

    /// The link of a port in a direction, as it is at this time, which is now.
    pub(super) fn at(&mut self, now: Instant, port: Port, direction: Direction) -> &mut LinkState {
        let link = self.link(port, direction);
        link.catch_up(now);
        link
    }

    fn link(&mut self, port: Port, direction: Direction) -> &mut LinkState {
        &mut self.links[port as usize][direction as usize]
    }
}

impl LinkState {
    fn set(&mut self, fault: LinkFault) {
        self.fault = fault;
        if fault == LinkFault::Cut {
            self.cuts += 1;
        }
    }

    fn catch_up(&mut self, now: Instant) {
        while self.schedule.front().is_some_and(|(at, _)| *at <= now) {
            if let Some((_, fault)) = self.schedule.pop_front() {
                self.set(fault);
            }
        }
    }

    /// What a connection that is made now remembers, to know whether it has been cut.
    pub(super) fn generation(&self) -> u64 {
        if self.fault == LinkFault::Cut { self.cuts.saturating_sub(1) } else { self.cuts }
    }

    /// What is wrong for a connection of this generation.
    pub(super) fn fault(&self, generation: u64) -> LinkFault {
        if self.cuts > generation { LinkFault::Cut } else { self.fault }
    }

    /// How long it stays as it is now, if that is known.
    pub(super) fn stays_for(&self, now: Instant) -> Option<Duration> {
        self.schedule.front().map(|(at, _)| at.saturating_duration_since(now))
    }
}

/// The shorter of two times, of which none is the longest.
pub(super) fn shorter(a: Option<Duration>, b: Option<Duration>) -> Option<Duration> {
    match (a, b) {
        (Some(a), Some(b)) => Some(a.min(b)),
        (a, b) => a.or(b),
    }
}
