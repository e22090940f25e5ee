//! When a monitor reconnects.

use std::time::Duration;

/// When a [`Monitor`](crate::Monitor) reconnects after its connection has ended.
///
/// Only connections to the status port are made again: it is only read, and serves any number of readers. Connections to the command
/// port never are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Reconnect {
    /// Never: the monitor reports that the connection has ended.
    #[default]
    Never,
    /// It tries up to `limit` times in a row, and waits before each attempt: first `delay`, then twice as long each time, up to `longest`.
    Attempts {
        /// How many attempts in a row may fail.
        limit: u32,
        /// How long it waits before the first.
        delay: Duration,
        /// The longest it waits.
        longest: Duration,
    },
}

impl Reconnect {
    /// Up to `limit` attempts in a row, after 0.1 s, 0.2 s and so on, up to 5 s.
    pub fn attempts(limit: u32) -> Self {
        Self::Attempts { limit, delay: Duration::from_millis(100), longest: Duration::from_secs(5) }
    }

    /// How long to wait before an attempt, counted from 0; `None` if there are no more attempts.
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
