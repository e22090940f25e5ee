//! How long a stop along a trajectory takes.

use super::Follower;

/// A stop along the curve, looked at before it is made. Made by [`Follower::stopping`].
///
/// Each period of it is found as the set-point of that period is, in some microseconds. How many there are depends on what the trajectory leaves of
/// the joints' accelerations, and can be all that are left of it: so who has to be done in a servo period looks so far ahead in one as there is time for.
#[derive(Debug, Clone)]
#[must_use = "it looks ahead as far as it is asked to"]
pub struct Stopping {
    pub(super) follower: Follower,
    pub(super) periods: u32,
}

impl Stopping {
    /// Looks ahead by at most so many periods more; in how many periods from the start of the stop it is at rest, if that was found.
    pub fn look_ahead(&mut self, periods: u32) -> Option<u32> {
        let last = self.periods.saturating_add(periods);
        while !self.follower.is_at_rest() {
            if self.periods == last {
                return None;
            }
            self.follower.advance();
            self.periods += 1;
        }
        Some(self.periods)
    }

    /// How many periods it has looked at.
    pub fn periods(&self) -> u32 {
        self.periods
    }
}
