//! Wait until a packet meets a condition.

use std::time::{Duration, Instant};

use jaka_dynamic::Node;

use super::now;
use crate::failure::Failure;
use crate::packets::condition::Condition;

/// Interval of the timeout checks without a packet.
pub(super) const POLL: Duration = Duration::from_millis(100);

/// Awaited condition, and its timeout.
#[derive(Debug)]
pub(super) struct Until {
    condition: Condition,
    limit: Option<Duration>,
    since: Instant,
    /// Values of the condition's fields in the last packet.
    last: Option<String>,
    /// Whether a packet has met it.
    is_met: bool,
}

impl Until {
    pub(super) fn new(condition: Condition, limit: Option<Duration>) -> Self {
        Self { condition, limit, since: now(), last: None, is_met: false }
    }

    pub(super) fn is_met(&self) -> bool {
        self.is_met
    }

    /// Takes a packet.
    ///
    /// # Errors
    /// It does not meet the condition, and the time is over.
    pub(super) fn packet(&mut self, packet: &Node<'_>) -> Result<(), Failure> {
        self.is_met = self.condition.holds(packet);
        if self.is_met {
            return Ok(());
        }
        self.last = Some(self.condition.describe(packet));
        self.check_time()
    }

    /// Whether the wait has a time limit of its own, instead of the timeout for packets.
    pub(super) fn is_limited(&self) -> bool {
        self.limit.is_some()
    }

    /// Returns an error if the time is over.
    pub(super) fn check_time(&self) -> Result<(), Failure> {
        let Some(limit) = self.limit.filter(|limit| now().saturating_duration_since(self.since) >= *limit) else {
            return Ok(());
        };
        let last = match &self.last {
            Some(last) => format!("the last packet: {last}"),
            None => "no status packet came".to_owned(),
        };
        Err(Failure::NotInTime(format!("`{}` was not true within {limit:?}; {last}", self.condition)))
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;
    use serde_json::json;

    use super::*;
    use crate::tests::packet;

    #[test]
    fn what_was_last_shown_is_told_when_the_time_is_over() {
        let condition = || "enabled || rapid_rate > 1".parse().expect("it is one");
        let mut until = Until::new(condition(), Some(Duration::ZERO));
        let text = |failed: Result<(), Failure>| failed.expect_err("the time is over").to_string();
        expect!["`enabled || rapid_rate > 1` was not true within 0ns; no status packet came"]
            .assert_eq(&text(until.check_time()));
        expect!["`enabled || rapid_rate > 1` was not true within 0ns; the last packet: enabled false, rapid_rate 1"]
            .assert_eq(&text(until.packet(&packet(json!({"enabled": false, "rapidrate": 1})))));
        until.packet(&packet(json!({"enabled": true, "rapidrate": 1}))).expect("it holds, however late");
        assert!(until.is_met());
        Until::new(condition(), None).check_time().expect("it is waited for for ever");
    }
}
