//! How often packets come, on which the speed under a limit of force depends.

use std::time::Duration;

use jaka_sync::layer::MonitorParts as _;

use crate::{MotionStatus, Robot};

/// How long is waited for packets, to know their period.
const PERIOD_WITHIN: Duration = Duration::from_secs(2);

/// For how long at least packets may stay away under a limit of force.
const SHORTEST_SILENCE: Duration = Duration::from_millis(100);

impl<S: MotionStatus> Robot<S> {
    /// The longest time between two of the last packets; none where too few come.
    pub(in crate::robot) fn packet_period(&self, timeout: Duration) -> Option<Duration> {
        let period = || self.monitor.statistics().recent_gap;
        self.monitor.watch(timeout.min(PERIOD_WITHIN), |_| period()).ok().flatten()
    }
}

/// For how long packets may stay away under a limit of force that come each `period`.
pub(in crate::robot) fn longest_silence(period: Duration) -> Duration {
    (period * 3).max(SHORTEST_SILENCE)
}
