//! Packets in a queue.

use std::collections::VecDeque;
use std::sync::{Arc, PoisonError};
use std::time::Duration;

use super::Snapshot;
use crate::clock::Clock;
use crate::sync::{Mutex, MutexGuard, Signal};

/// Packets in the order in which they came, from [`Monitor::subscribe`](super::Monitor::subscribe).
///
/// A reader that is too slow loses the oldest packets, and can see how many.
#[derive(Debug)]
#[must_use = "packets are queued only as long as the subscription lives"]
pub struct Subscription<S> {
    queue: Arc<Queue<S>>,
}

#[derive(Debug)]
pub(super) struct Queue<S> {
    items: Mutex<Items<S>>,
    changed: Signal,
    clock: Clock,
    capacity: usize,
}

#[derive(Debug)]
struct Items<S> {
    waiting: VecDeque<Arc<Snapshot<S>>>,
    dropped: u64,
    closed: bool,
}

impl<S> Queue<S> {
    pub(super) fn new(clock: &Clock, capacity: usize) -> Self {
        let items = Items { waiting: VecDeque::new(), dropped: 0, closed: false };
        Self { items: Mutex::new(items), changed: Signal::new(clock), clock: clock.clone(), capacity: capacity.max(1) }
    }

    fn lock(&self) -> MutexGuard<'_, Items<S>> {
        self.items.lock().unwrap_or_else(PoisonError::into_inner)
    }

    pub(super) fn push(&self, snapshot: Arc<Snapshot<S>>) {
        let mut items = self.lock();
        if items.waiting.len() == self.capacity {
            items.waiting.pop_front();
            items.dropped += 1;
        }
        items.waiting.push_back(snapshot);
        self.changed.notify_all();
    }

    /// No more packets will come.
    pub(super) fn close(&self) {
        self.lock().closed = true;
        self.changed.notify_all();
    }
}

impl<S> Subscription<S> {
    pub(super) fn new(queue: Arc<Queue<S>>) -> Self {
        Self { queue }
    }

    /// The next packet of the queue; `None` if it is empty.
    pub fn try_next_packet(&self) -> Option<Arc<Snapshot<S>>> {
        self.queue.lock().waiting.pop_front()
    }

    /// The next packet of the queue, or the one that comes within `timeout`; `None` if none has come, or no more will come.
    pub fn next_packet_within(&self, timeout: Duration) -> Option<Arc<Snapshot<S>>> {
        let since = self.queue.clock.stopwatch();
        let mut items = self.queue.lock();
        loop {
            if let Some(next) = items.waiting.pop_front() {
                return Some(next);
            }
            let left = since.left_of(timeout);
            if items.closed || left.is_zero() {
                return None;
            }
            items = self.queue.changed.wait(&self.queue.items, items, left);
        }
    }

    /// How many packets were dropped because the queue was full.
    pub fn dropped(&self) -> u64 {
        self.queue.lock().dropped
    }

    /// True if no more packets will come than those in the queue.
    pub fn is_closed(&self) -> bool {
        self.queue.lock().closed
    }
}
