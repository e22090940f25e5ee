//! How often packets come, on which the speed under a limit of force depends.

use std::time::Duration;

use crate::arm::Arm;

/// How long is waited for packets, to know their period.
const PERIOD_WITHIN: Duration = Duration::from_secs(2);

/// For how long at least packets may stay away under a limit of force.
const SHORTEST_SILENCE: Duration = Duration::from_millis(100);

/// The longest time between two of the last packets; none where too few come.
pub(crate) fn packet_period(arm: &Arm, timeout: Duration) -> Option<Duration> {
    let period = || arm.statistics().recent_gap;
    arm.state.watch(timeout.min(PERIOD_WITHIN), |_| period()).ok().flatten()
}

/// For how long packets may stay away under a limit of force that come each `period`.
pub(crate) fn longest_silence(period: Duration) -> Duration {
    (period * 3).max(SHORTEST_SILENCE)
}
