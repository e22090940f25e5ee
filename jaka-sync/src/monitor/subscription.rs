//! Packets in a queue.

use std::collections::VecDeque;
use std::sync::Arc;
use std::time::Duration;

use crate::Snapshot;
use crate::sync::Watched;

/// Packets in the order in which they came, from [`Monitor::subscribe`](super::Monitor::subscribe).
///
/// A reader that is too slow loses the oldest packets; [`dropped`](Self::dropped) is their number.
#[derive(Debug)]
#[must_use = "packets are queued only as long as the subscription lives"]
pub struct Subscription<S> {
    pub(super) queue: Arc<Queue<S>>,
}

/// Queue that a subscription and the monitor's thread share.
pub(super) type Queue<S> = Watched<Items<S>>;

#[derive(Debug)]
pub(super) struct Items<S> {
    waiting: VecDeque<Arc<Snapshot<S>>>,
    capacity: usize,
    dropped: u64,
    closed: bool,
}

impl<S> Items<S> {
    pub(super) fn new(capacity: usize) -> Self {
        Self { waiting: VecDeque::new(), capacity: capacity.max(1), dropped: 0, closed: false }
    }
}

impl<S> Queue<S> {
    pub(super) fn push(&self, snapshot: Arc<Snapshot<S>>) {
        let mut items = self.lock();
        if items.waiting.len() == items.capacity {
            items.waiting.pop_front();
            items.dropped += 1;
        }
        items.waiting.push_back(snapshot);
        self.wake();
    }

    /// Marks the end: no more packets will come.
    pub(super) fn close(&self) {
        self.lock().closed = true;
        self.wake();
    }
}

impl<S> Subscription<S> {
    /// Returns the next packet of the queue; `None` if it is empty.
    pub fn try_next_packet(&self) -> Option<Arc<Snapshot<S>>> {
        self.queue.lock().waiting.pop_front()
    }

    /// Returns the next packet of the queue, or waits for one for at most `timeout`; `None` if none has come, or no
    /// more will come.
    pub fn next_packet_within(&self, timeout: Duration) -> Option<Arc<Snapshot<S>>> {
        let next = self.queue.wait_for(timeout, |items| match items.waiting.pop_front() {
            None if !items.closed => None,
            next => Some(next),
        });
        next.flatten()
    }

    /// Number of packets dropped because the queue was full.
    pub fn dropped(&self) -> u64 {
        self.queue.lock().dropped
    }

    /// True if no packets will come after those in the queue.
    pub fn is_closed(&self) -> bool {
        self.queue.lock().closed
    }
}
