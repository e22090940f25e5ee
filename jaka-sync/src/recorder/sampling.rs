//! Choice of the status packets that are recorded.

use std::time::Duration;

/// Choice of the status packets that are recorded. Packets of some firmware have 9 kB and come every 20 ms: 1.6 GB an
/// hour.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum StatusSampling {
    /// All of them.
    #[default]
    All,
    /// The first of each connection, and then every n-th.
    EveryNth(u32),
    /// The first of each connection, and then one after each interval of this length.
    AtMostEach(Duration),
}

/// Number of the packets of one connection, and time of the last one that was recorded.
#[derive(Debug, Default)]
pub(super) struct Sampler {
    packets: u64,
    last: Option<Duration>,
}

impl Sampler {
    /// Decides whether the packet that has come at this time is recorded.
    pub(super) fn takes(&mut self, sampling: StatusSampling, now: Duration) -> bool {
        let number = self.packets;
        self.packets += 1;
        let takes = match (sampling, self.last) {
            (StatusSampling::All, _) | (_, None) => true,
            (StatusSampling::EveryNth(n), _) => number % u64::from(n.max(1)) == 0,
            (StatusSampling::AtMostEach(time), Some(last)) => now.saturating_sub(last) >= time,
        };
        if takes {
            self.last = Some(now);
        }
        takes
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn taken(sampling: StatusSampling) -> Vec<u64> {
        let mut sampler = Sampler::default();
        (0..10).map(|n| n * 20).filter(|millis| sampler.takes(sampling, Duration::from_millis(*millis))).collect()
    }

    #[test]
    fn each_sampling_takes_the_first_and_its_share() {
        assert_eq!(taken(StatusSampling::All).len(), 10);
        assert_eq!(taken(StatusSampling::EveryNth(4)), [0, 80, 160]);
        assert_eq!(taken(StatusSampling::EveryNth(0)).len(), 10);
        assert_eq!(taken(StatusSampling::AtMostEach(Duration::from_millis(50))), [0, 60, 120, 180]);
    }
}
