//! Statistics on the regularity of packets.

use std::collections::VecDeque;
use std::time::{Duration, Instant};

/// Number of the status packets since the monitor began, and their regularity.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub struct MonitorStatistics {
    /// Packets that could be read, including those with fields that do not fit.
    pub packets: u64,
    /// Packets with at least one field that does not fit ([`Snapshot::unfit`](crate::Snapshot::unfit)), which
    /// [`packets`](Self::packets) counts, too; and packets that could not be read at all: they are not a JSON object,
    /// or your own [`Decode`](jaka_proto::wire::Decode) refuses them.
    pub unfit: u64,
    /// Packets that were never the newest, because a newer one had come already. Queues and observers get them; if
    /// there are none, they are not decoded.
    pub skipped: u64,
    /// Bytes that did not belong to a packet, or belonged to an incomplete one.
    pub dropped_bytes: u64,
    /// Number of searches for the beginning of a packet.
    pub resyncs: u64,
    /// Number of times that the monitor has reconnected.
    pub reconnects: u64,
    /// Mean time between packets; `None` before the second.
    pub period: Option<Duration>,
    /// Mean deviation of the time between packets from the one before.
    pub jitter: Duration,
    /// The longest time between two packets.
    pub longest_gap: Duration,
    /// The longest time between two of the last 33 packets; `None` before 11 have come since the monitor connected.
    pub recent_gap: Option<Duration>,
}

/// Counts kept while packets come.
#[derive(Debug, Default)]
pub(super) struct Counters {
    /// Statistics that are counted directly; computed ones are absent.
    pub(super) counted: MonitorStatistics,
    last: Option<(Instant, Duration)>,
    gaps: u32,
    gaps_total: Duration,
    deviations: Duration,
    /// The last gaps, since the connection was made.
    recent: VecDeque<Duration>,
}

/// Number of gaps kept, and number needed for [`recent_gap`](MonitorStatistics::recent_gap).
const RECENT: usize = 32;
const ENOUGH: usize = 10;

impl Counters {
    /// Counts a packet that can be read.
    pub(super) fn packet(&mut self, now: Instant) {
        self.counted.packets += 1;
        let Some((last, last_gap)) = self.last else {
            self.last = Some((now, Duration::ZERO));
            return;
        };
        let gap = now.saturating_duration_since(last);
        self.gaps += 1;
        self.gaps_total += gap;
        self.counted.longest_gap = self.counted.longest_gap.max(gap);
        if self.gaps > 1 {
            self.deviations += gap.abs_diff(last_gap);
        }
        if self.recent.len() == RECENT {
            self.recent.pop_front();
        }
        self.recent.push_back(gap);
        self.last = Some((now, gap));
    }

    /// Ends the series of gaps after a loss of the connection: the time that follows is not a gap between packets.
    pub(super) fn interrupted(&mut self) {
        self.last = None;
        self.recent.clear();
    }

    pub(super) fn statistics(&self) -> MonitorStatistics {
        MonitorStatistics {
            period: self.gaps_total.checked_div(self.gaps),
            recent_gap: self.recent.iter().max().filter(|_| self.recent.len() >= ENOUGH).copied(),
            jitter: self.deviations.checked_div(self.gaps.saturating_sub(1)).unwrap_or_default(),
            ..self.counted
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gaps_are_counted_between_packets_alone() {
        let mut counters = Counters::default();
        let start = Instant::now();
        for ms in [0, 10, 20, 40] {
            counters.packet(start + Duration::from_millis(ms));
        }
        counters.interrupted();
        counters.packet(start + Duration::from_secs(100));
        let found = counters.statistics();
        assert_eq!((found.packets, found.longest_gap), (5, Duration::from_millis(20)));
        assert_eq!(found.period, Some(Duration::from_millis(40) / 3));
        assert_eq!(found.jitter, Duration::from_millis(5));
    }

    #[test]
    fn the_recent_gap_is_that_of_the_last_packets_of_a_connection() {
        let mut counters = Counters::default();
        let mut now = Instant::now();
        let mut after = |counters: &mut Counters, ms| {
            now += Duration::from_millis(ms);
            counters.packet(now);
            counters.statistics().recent_gap
        };
        let gaps = [0, 50, 8, 8, 8, 8, 8, 8, 8, 8];
        assert!(gaps.into_iter().all(|ms| after(&mut counters, ms).is_none()));
        assert_eq!(after(&mut counters, 8), Some(Duration::from_millis(50)));
        // 50 ms are forgotten when 32 other gaps have come.
        let found: Vec<_> = (0..23).map(|_| after(&mut counters, 9)).collect();
        assert_eq!(found[21], Some(Duration::from_millis(50)));
        assert_eq!(found[22], Some(Duration::from_millis(9)));
        counters.interrupted();
        assert_eq!(after(&mut counters, 8), None);
    }

    #[test]
    fn no_packets_have_no_period() {
        assert_eq!(Counters::default().statistics().period, None);
    }
}
