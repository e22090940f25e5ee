//! The links between the ports and their clients, with what is wrong with them.
//!
//! A connection is a [`Wire`]. As long as no link has ever had a fault, a wire writes to its socket and reads from it,
//! and the only addition is atomic flags. After the first fault, what a wire sends can wait in a queue, for a thread
//! that is spawned when the first bytes wait; what it receives waits where it is read, in the thread that reads.

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

/// Greatest number of connections that may wait to end because of a fault. If there are more, the oldest ends at once.
const MOST_SENDERS: usize = 512;

/// The links of a controller.
///
/// Locks are taken in this order: `state`, a wire's queue.
#[derive(Debug)]
pub(crate) struct Links {
    /// True once any link has had a fault.
    used: AtomicBool,
    state: Mutex<LinkStates>,
    changed: Signal,
    time: Clock,
    senders: Mutex<VecDeque<Sender>>,
}

/// A thread that sends what has waited, and the connection on which it does.
type Sender = (Weak<Wire>, JoinHandle<()>);

impl Links {
    /// The links of a controller.
    pub(crate) fn new(time: &Clock) -> Self {
        Self {
            used: AtomicBool::new(false),
            state: Mutex::default(),
            changed: Signal::new(time),
            time: time.clone(),
            senders: Mutex::default(),
        }
    }

    /// Sets what is wrong with these links from now on.
    pub(crate) fn set(&self, selector: LinkSelector, fault: LinkFault) {
        let mut state = lock(&self.state);
        if fault != LinkFault::None {
            self.used.store(true, Ordering::SeqCst);
        }
        state.set(selector, fault);
        drop(state);
        self.changed.notify_all();
    }

    /// The time in which they wait.
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

    /// Waits for a change, or for so long, or less.
    fn wait<'l>(&'l self, state: MutexGuard<'l, LinkStates>, time: Option<Duration>) -> MutexGuard<'l, LinkStates> {
        self.changed.wait(&self.state, state, time.unwrap_or(Duration::MAX))
    }

    /// Has all threads that wait check their link again.
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
