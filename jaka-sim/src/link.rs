//! Links between the ports and their clients, with their faults.
//!
//! A connection is a [`Wire`]. Until the first fault of any link, a wire writes to its socket and reads from it
//! directly, with only atomic flags in addition. After the first fault, outgoing bytes can wait in a queue for a thread
//! that starts when the first bytes wait. Incoming bytes wait in the thread that reads.

mod inbound;
mod queue;
mod state;
mod wire;

use std::collections::VecDeque;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, Weak};
use std::thread::JoinHandle;
use std::time::Duration;

use jaka_clock::{Clock, Signal, lock};

pub(crate) use self::inbound::{Inbound, Received};
use self::state::LinkStates;
pub(crate) use self::wire::Wire;
use crate::fault::LinkFault;
use crate::link_selector::LinkSelector;

/// Greatest number of connections with a delayed end because of a fault. Beyond it, the oldest ends at once.
const MOST_SENDERS: usize = 512;

/// Links of a controller.
///
/// Locks are taken in this order: `state`, a wire's queue.
#[derive(Debug)]
pub(crate) struct Links {
    /// Whether any link has ever had a fault.
    used: AtomicBool,
    state: Mutex<LinkStates>,
    changed: Signal,
    time: Clock,
    senders: Mutex<VecDeque<Sender>>,
}

/// Thread that sends queued bytes, and its connection.
type Sender = (Weak<Wire>, JoinHandle<()>);

impl Links {
    /// Creates the links of a controller.
    pub(crate) fn new(time: &Clock) -> Self {
        Self {
            used: AtomicBool::new(false),
            state: Mutex::default(),
            changed: Signal::new(time),
            time: time.clone(),
            senders: Mutex::default(),
        }
    }

    /// Sets the fault of these links from now on.
    pub(crate) fn set(&self, selector: LinkSelector, fault: LinkFault) {
        let mut state = lock(&self.state);
        if fault != LinkFault::None {
            self.used.store(true, Ordering::SeqCst);
        }
        state.set(selector, fault);
        drop(state);
        self.changed.notify_all();
    }

    /// Returns the clock for waits.
    pub(crate) fn time(&self) -> &Clock {
        &self.time
    }

    /// Whether any link has ever had a fault.
    fn are_used(&self) -> bool {
        self.used.load(Ordering::SeqCst)
    }

    fn state(&self) -> MutexGuard<'_, LinkStates> {
        lock(&self.state)
    }

    /// Waits for a change, or for at most this time; may return early.
    fn wait<'l>(&'l self, state: MutexGuard<'l, LinkStates>, time: Option<Duration>) -> MutexGuard<'l, LinkStates> {
        self.changed.wait(&self.state, state, time.unwrap_or(Duration::MAX))
    }

    /// Wakes all waiting threads to check their link again.
    fn notify(&self) {
        drop(self.state());
        self.changed.notify_all();
    }

    fn add_sender(&self, sender: Sender) {
        let mut senders = lock(&self.senders);
        senders.retain(|(_, thread)| !thread.is_finished());
        senders.push_back(sender);
        let oldest = if senders.len() > MOST_SENDERS { senders.pop_front() } else { None };
        drop(senders);
        if let Some((wire, _)) = oldest {
            wire.upgrade().inspect(|wire| wire.abort());
        }
    }

    /// Ends all connections with waiting bytes, and waits for their threads.
    pub(crate) fn abort(&self) {
        let senders = std::mem::take(&mut *lock(&self.senders));
        for (wire, _) in &senders {
            wire.upgrade().inspect(|wire| wire.abort());
        }
        for (_, thread) in senders {
            // The panic hook has reported a panic of the thread, which concerns one connection.
            drop(thread.join());
        }
    }
}
