//! Queue of outgoing bytes of a connection.

use std::collections::VecDeque;
use std::time::{Duration, Instant};

use jaka_clock::Clock;

use crate::fault::{LinkFault, Passage};

/// Greatest number of bytes in the queue.
const MOST: usize = 16 << 20;

/// Queue of outgoing bytes, in order.
#[derive(Debug, Default)]
pub(super) struct Queue {
    time: Clock,
    /// Waiting writes, each with the time at which it was queued.
    writes: VecDeque<(Instant, Vec<u8>)>,
    bytes: usize,
    /// End of the connection after the last byte, with the time at which it was requested.
    end: Option<(Instant, End)>,
    pace: Pace,
    /// Whether a thread sends the queued bytes.
    pub(super) has_sender: bool,
    /// Whether that thread is about to write.
    is_sending: bool,
    fate: Fate,
}

/// State of a connection.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
enum Fate {
    #[default]
    Open,
    /// Nothing more can be written.
    Lost,
    /// The connection ends at once, regardless of link faults.
    Aborted,
}

/// Kind of end of a connection.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum End {
    Close,
    /// Drops the socket: with a reset, if that is set.
    Drop,
}

/// Next step of the sending thread.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum SendStep {
    Send(Vec<u8>),
    /// Waits for a change, up to a timeout if there is one.
    Wait(Option<Duration>),
    End(End),
}

impl Queue {
    pub(super) fn new(time: &Clock) -> Self {
        Self { time: time.clone(), ..Self::default() }
    }

    /// Whether all bytes have been sent.
    pub(super) fn is_idle(&self) -> bool {
        self.writes.is_empty() && !self.is_sending
    }

    /// Whether the connection accepts no more bytes.
    pub(super) fn is_over(&self) -> bool {
        self.fate != Fate::Open || self.end.is_some()
    }

    /// Adds bytes; returns false if there are too many.
    pub(super) fn push(&mut self, bytes: &[u8]) -> bool {
        if self.bytes.saturating_add(bytes.len()) > MOST {
            return false;
        }
        self.bytes += bytes.len();
        self.writes.push_back((self.time.now(), bytes.to_vec()));
        true
    }

    /// Sets the end of the connection, unless it is already set.
    pub(super) fn end(&mut self, end: End) {
        self.end.get_or_insert((self.time.now(), end));
    }

    /// Marks the connection as lost: nothing more can be written.
    pub(super) fn lose(&mut self) {
        self.fate = Fate::Lost;
        self.clear();
    }

    /// Ends the connection at once.
    pub(super) fn abort(&mut self) {
        self.fate = Fate::Aborted;
        self.clear();
    }

    pub(super) fn is_aborted(&self) -> bool {
        self.fate == Fate::Aborted
    }

    fn clear(&mut self) {
        self.writes.clear();
        self.bytes = 0;
    }

    /// Takes the next step on a link with this fault.
    pub(super) fn next(&mut self, fault: LinkFault) -> SendStep {
        self.is_sending = false;
        match self.end {
            _ if self.is_aborted() => return SendStep::End(End::Close),
            Some((_, end)) if self.fate == Fate::Lost => return SendStep::End(end),
            _ => {}
        }
        let first = self.writes.front().map(|(sent, _)| *sent).or(self.end.map(|(sent, _)| sent));
        let step = match fault.passage(first.map_or(Duration::ZERO, |sent| self.time.elapsed(sent))) {
            Passage::Lost => {
                self.clear();
                SendStep::Wait(None)
            }
            _ if first.is_none() => SendStep::Wait(None),
            Passage::Now => self.take(usize::MAX),
            Passage::After(left) => SendStep::Wait(Some(left)),
            Passage::Paced(per_second) => self.take_slowly(per_second),
            Passage::Held => SendStep::Wait(None),
        };
        self.is_sending = matches!(step, SendStep::Send(_));
        step
    }

    /// Takes the next write, or at most this much of it.
    fn take(&mut self, most: usize) -> SendStep {
        let Some((sent, mut bytes)) = self.writes.pop_front() else {
            return self.end.map_or(SendStep::Wait(None), |(_, end)| SendStep::End(end));
        };
        if bytes.len() > most {
            let rest = bytes.split_off(most);
            self.writes.push_front((sent, rest));
        }
        self.bytes -= bytes.len();
        SendStep::Send(bytes)
    }

    fn take_slowly(&mut self, per_second: u64) -> SendStep {
        if let Some(left) = self.pace.left(self.time.now()) {
            return SendStep::Wait(Some(left));
        }
        let step = self.take(Pace::portion(per_second));
        if let SendStep::Send(bytes) = &step {
            self.pace.passed(bytes.len(), per_second, self.time.now());
        }
        step
    }
}

/// Pace of a slow link.
#[derive(Debug, Default)]
pub(super) struct Pace {
    free_at: Option<Instant>,
}

impl Pace {
    /// Greatest delay of a write that the pace still makes up for.
    const SLACK: Duration = Duration::from_millis(100);

    /// Returns the number of bytes that pass at once: those of 10 ms, or a single one.
    pub(super) fn portion(per_second: u64) -> usize {
        usize::try_from(per_second / 100).unwrap_or(usize::MAX).max(1)
    }

    /// Returns the time until more bytes pass; `None` if bytes pass now.
    pub(super) fn left(&self, now: Instant) -> Option<Duration> {
        let left = self.free_at?.saturating_duration_since(now);
        (!left.is_zero()).then_some(left)
    }

    /// Records that this many bytes have passed.
    pub(super) fn passed(&mut self, bytes: usize, per_second: u64, now: Instant) {
        let from = self.free_at.filter(|free_at| now.duration_since(*free_at) < Self::SLACK).unwrap_or(now);
        let bytes = u64::try_from(bytes).unwrap_or(u64::MAX);
        let nanos = bytes.saturating_mul(1_000_000_000) / per_second.max(1);
        self.free_at = from.checked_add(Duration::from_nanos(nanos));
    }
}

#[cfg(test)]
mod tests {
    use jaka_clock::SimulatedClock;

    use super::*;

    fn queue() -> Queue {
        queue_by(&SimulatedClock::new())
    }

    fn queue_by(clock: &SimulatedClock) -> Queue {
        let mut queue = Queue::new(&Clock::simulated(clock));
        assert!(queue.push(b"one") && queue.push(b"two"));
        queue
    }

    #[test]
    fn the_end_comes_after_the_bytes() {
        let mut queue = queue();
        queue.end(End::Drop);
        queue.end(End::Close);
        assert_eq!(queue.next(LinkFault::Hold), SendStep::Wait(None));
        assert_eq!(queue.next(LinkFault::None), SendStep::Send(b"one".to_vec()));
        assert!(!queue.is_idle());
        assert_eq!(queue.next(LinkFault::None), SendStep::Send(b"two".to_vec()));
        // Counts as written only when the thread asks for the next step.
        assert!(!queue.is_idle());
        assert_eq!(queue.next(LinkFault::Hold), SendStep::Wait(None));
        assert!(queue.is_idle());
        assert_eq!(queue.next(LinkFault::None), SendStep::End(End::Drop));
    }

    #[test]
    fn a_delay_counts_from_when_each_was_sent() {
        let clock = SimulatedClock::new();
        let mut queue = queue_by(&clock);
        let [minute, second, rest] = [60, 1, 59].map(Duration::from_secs);
        clock.sleep(second);
        assert_eq!(queue.next(LinkFault::Delay(minute)), SendStep::Wait(Some(rest)));
        assert_eq!(queue.next(LinkFault::Delay(second)), SendStep::Send(b"one".to_vec()));
    }

    #[test]
    fn a_slow_link_lets_a_portion_pass() {
        let clock = SimulatedClock::new();
        let mut queue = queue_by(&clock);
        let pause = Duration::from_millis(10);
        assert_eq!(queue.next(LinkFault::Slow(200)), SendStep::Send(b"on".to_vec()));
        assert_eq!(queue.next(LinkFault::Slow(200)), SendStep::Wait(Some(pause)));
        clock.sleep(pause);
        assert_eq!(queue.next(LinkFault::Slow(200)), SendStep::Send(b"e".to_vec()));
        assert_eq!(queue.next(LinkFault::None), SendStep::Send(b"two".to_vec()));
    }

    #[test]
    fn what_is_cut_is_gone() {
        let mut queue = queue();
        queue.end(End::Close);
        assert_eq!(queue.next(LinkFault::Cut), SendStep::Wait(None));
        assert!(queue.is_idle());
        queue.abort();
        assert_eq!(queue.next(LinkFault::Cut), SendStep::End(End::Close));
    }

    #[test]
    fn what_waits_is_bounded() {
        let mut queue = Queue::default();
        let bytes = vec![0; 1 << 20];
        assert_eq!((0..100).filter(|_| queue.push(&bytes)).count(), 16);
    }
}
