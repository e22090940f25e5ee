//! What a servo session did.

use std::time::Duration;

use super::histogram::Histogram;

/// What a servo session did, from [`ServoSession::land`](super::ServoSession::land).
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub struct ServoReport {
    /// Set-points sent, without those of the landing.
    pub cycles: u64,
    /// Set-points sent more than half a period late.
    pub late_cycles: u64,
    /// Gaps: set-points that were late by three periods or more. The arm is taken to have stood then.
    pub gaps: u64,
    /// The longest of these, by the lateness of the set-point after it; zero without a gap.
    pub longest_gap: Duration,
    /// Set-points of the landing: those that braked the arm, and those that held it.
    pub landing_cycles: u64,
    /// Answers that accepted a set-point.
    pub accepted: u64,
    /// Answers that refused one.
    pub refused: u64,
    /// Set-points whose answers never came.
    pub unanswered: u64,
    /// True if packets showed the arm at rest at its last set-point before servo mode was left. False where none came and motions are allowed without a
    /// known status, and where the error says so.
    pub rest_was_seen: bool,
    /// The most answers that were outstanding at once.
    pub most_outstanding: usize,
    lateness: Histogram,
}

impl ServoReport {
    pub(super) fn late(&mut self, late: Duration, period: Duration) {
        self.cycles += 1;
        self.late_cycles += u64::from(late > period / 2);
        self.lateness.add(late);
    }

    /// Counts a gap.
    pub(super) fn gap(&mut self, late: Duration) {
        self.gaps += 1;
        self.longest_gap = self.longest_gap.max(late);
    }

    /// By how much set-points were sent late, at a share from 0 to 1 of them: 0.99 for the 99th percentile, 1 for the
    /// maximum. Correct to 3 %, and to a microsecond.
    pub fn lateness(&self, share: f64) -> Duration {
        self.lateness.at(share)
    }
}
