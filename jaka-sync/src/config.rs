//! Configuration of connections.

use std::time::Duration;

use jaka_clock::Clock;
use jaka_proto::check::AdvisoryRanges;
use jaka_proto::framing::DEFAULT_MAX_FRAME;

use crate::Recorder;

/// Configuration of connections: timeouts, keepalive, frame size and checks.
///
/// The name of a getter begins with `get_`. [`Client::connect_with`](crate::Client::connect_with) and
/// the methods of the same name of [`Monitor`](crate::Monitor), [`StatusStream`](crate::StatusStream) and
/// `jaka_robot::Robot` connect by a configuration.
///
/// Addresses are not settings: each connection takes its own. An address without a port, such as `10.5.5.100` or
/// `robot.local`, means the protocol's port for this kind of connection; one with a port, such as `10.5.5.100:10001` or
/// a socket address, means that port. Since a robot has two ports, `jaka_robot::Robot::connect_with` takes an address
/// without a port, and `jaka_robot::Robot::connect_at` two addresses.
///
/// ```no_run
/// use std::time::Duration;
/// use jaka_sync::{Client, Config};
///
/// let config = Config::new().reply_timeout(Duration::from_secs(2));
/// let mut robot = Client::connect_with(&config, "10.5.5.100")?;
/// assert_eq!(config.get_reply_timeout(), Duration::from_secs(2));
/// # Ok::<(), jaka_sync::Error>(())
/// ```
#[must_use = "a configuration does nothing until something is connected with it"]
#[derive(Debug, Clone)]
pub struct Config {
    pub(crate) connect_timeout: Duration,
    pub(crate) reply_timeout: Duration,
    pub(crate) keepalive: Option<Duration>,
    pub(crate) max_frame: usize,
    pub(crate) advisory_ranges: AdvisoryRanges,
    pub(crate) stale_after: Duration,
    pub(crate) reconnect: Reconnect,
    pub(crate) recorder: Option<Recorder>,
    pub(crate) recorded_status_interval: Duration,
    pub(crate) clock: Clock,
}

impl Default for Config {
    fn default() -> Self {
        Self {
            connect_timeout: Duration::from_secs(5),
            reply_timeout: Duration::from_secs(5),
            keepalive: Some(Duration::from_secs(9)),
            max_frame: DEFAULT_MAX_FRAME,
            advisory_ranges: AdvisoryRanges::Enforced,
            stale_after: Duration::from_millis(500),
            reconnect: Reconnect::Never,
            recorder: None,
            recorded_status_interval: Duration::ZERO,
            clock: Clock::default(),
        }
    }
}

/// Shortest duration: shorter ones are raised to it, since sockets accept no timeout of zero.
const SHORTEST: Duration = Duration::from_millis(1);

impl Config {
    /// Returns the defaults, which the setters name.
    pub fn new() -> Self {
        Self::default()
    }

    /// Sets the longest time for connecting, over all addresses of a name, which share the time. 5 s by default.
    pub fn connect_timeout(mut self, timeout: Duration) -> Self {
        self.connect_timeout = timeout.max(SHORTEST);
        self
    }

    /// Sets the longest time for a reply, or a status packet, from the moment of the call. 5 s by default.
    ///
    /// The time of a call includes the wait for other threads that send, and the sending itself. Commands with a longer
    /// time in the spec, such as `power_on` and the motions, get that time.
    pub fn reply_timeout(mut self, timeout: Duration) -> Self {
        self.reply_timeout = timeout.max(SHORTEST);
        self
    }

    /// The value of [`reply_timeout`](Self::reply_timeout).
    pub fn get_reply_timeout(&self) -> Duration {
        self.reply_timeout
    }

    /// Sets the time of silence after which TCP probes the controller, so that a pulled cable is noticed; `None` for
    /// never. 9 s by default, and a third of it between probes.
    ///
    /// Systems accept whole seconds from 1 to 32767: other times are rounded up to the next second, and limited to this
    /// range. The time between probes is at least one second.
    pub fn keepalive(mut self, idle: Option<Duration>) -> Self {
        self.keepalive = idle;
        self
    }

    /// Sets the length of the longest message that is accepted from the controller, in bytes. 1 MiB by default.
    pub fn max_frame(mut self, bytes: usize) -> Self {
        self.max_frame = bytes;
        self
    }

    /// Sets whether advisory ranges are enforced: ranges that newer firmware has widened, and ranges that are only
    /// advised. Enforced by default.
    pub fn advisory_ranges(mut self, ranges: AdvisoryRanges) -> Self {
        self.advisory_ranges = ranges;
        self
    }

    /// Sets the time without a packet after which a [`Monitor`](crate::Monitor)'s status is stale. 0.5 s by default,
    /// which is several periods of any firmware.
    pub fn stale_after(mut self, age: Duration) -> Self {
        self.stale_after = age;
        self
    }

    /// The value of [`stale_after`](Self::stale_after).
    pub fn get_stale_after(&self) -> Duration {
        self.stale_after
    }

    /// Sets the policy by which a [`Monitor`](crate::Monitor) reconnects after its connection has ended. Never, by
    /// default.
    pub fn reconnect(mut self, policy: Reconnect) -> Self {
        self.reconnect = policy;
        self
    }

    /// Records all connections that are made with this configuration. Nothing is recorded by default, at no cost.
    pub fn recorder(mut self, recorder: Recorder) -> Self {
        self.recorder = Some(recorder);
        self
    }

    /// Sets the interval of recorded status packets: of each connection the first one, and then at most one in this
    /// time. Zero by default, for all of them, which can be about 0.5 MB each second.
    pub fn recorded_status_interval(mut self, interval: Duration) -> Self {
        self.recorded_status_interval = interval;
        self
    }

    /// Sets a simulated clock for all connections, for tests: see [`SimulatedClock`](crate::SimulatedClock). The
    /// system's clock by default. Needs the feature `simulated-clock`.
    ///
    /// Making connections takes real time, and no simulated time.
    #[cfg(feature = "simulated-clock")]
    pub fn clock(mut self, clock: &crate::SimulatedClock) -> Self {
        self.clock = Clock::simulated(clock);
        self
    }

    /// The value of [`clock`](Self::clock); `None` for the system's clock.
    #[cfg(feature = "simulated-clock")]
    pub fn get_clock(&self) -> Option<&crate::SimulatedClock> {
        self.clock.as_simulated()
    }
}

/// Policy by which a [`Monitor`](crate::Monitor) reconnects after its connection has ended.
///
/// Only connections to the status port are made again: it is read-only, and serves any number of readers. Connections
/// to the command port never are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Reconnect {
    /// Never: the monitor reports that the connection has ended.
    #[default]
    Never,
    /// The monitor tries up to `limit` times in a row, and waits before each attempt: first `delay`, then twice as long
    /// each time, up to `longest`.
    Attempts {
        /// Number of attempts in a row that may fail.
        limit: u32,
        /// Wait before the first attempt.
        delay: Duration,
        /// Longest wait before an attempt.
        longest: Duration,
    },
}

impl Reconnect {
    /// Up to `limit` attempts in a row, after 0.1 s, 0.2 s and so on, up to 5 s.
    pub fn attempts(limit: u32) -> Self {
        Self::Attempts { limit, delay: Duration::from_millis(100), longest: Duration::from_secs(5) }
    }

    /// Returns the wait before an attempt, counted from 0; `None` if there are no more attempts.
    pub(crate) fn delay(self, attempt: u32) -> Option<Duration> {
        match self {
            Self::Attempts { limit, delay, longest } if attempt < limit => {
                Some(delay.saturating_mul(2u32.saturating_pow(attempt)).min(longest))
            }
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn delays_double_up_to_the_longest_and_then_end() {
        let policy = Reconnect::attempts(9);
        let delays: Vec<_> = (0..).map_while(|attempt| policy.delay(attempt)).map(|delay| delay.as_millis()).collect();
        assert_eq!(delays, [100, 200, 400, 800, 1600, 3200, 5000, 5000, 5000]);
        assert_eq!(Reconnect::Never.delay(0), None);
        assert_eq!(Reconnect::attempts(u32::MAX).delay(u32::MAX - 1), Some(Duration::from_secs(5)));
    }
}
