//! Check that the joints follow their set-points.

use jaka_proto::messages::types::JointPosition;

use crate::{Error, ErrorKind};

/// The set-points of the last half second: the arm lags, and packets are late.
#[derive(Debug)]
pub(super) struct Departure {
    recent: Vec<JointPosition>,
    next: usize,
    most_deg: f64,
}

/// Time for which set-points count, in seconds.
const COUNTS_S: f64 = 0.5;

impl Departure {
    /// For an arm at rest.
    pub(super) fn new(start: JointPosition, period_s: f64, most_deg: f64) -> Self {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a period is 8 ms to 96 ms")]
        let count = (COUNTS_S / period_s).ceil() as usize;
        Self { recent: vec![start; count.max(1)], next: 0, most_deg }
    }

    pub(super) fn sent(&mut self, joints: JointPosition) {
        self.recent[self.next] = joints;
        self.next = (self.next + 1) % self.recent.len();
    }

    /// Compares the joints of a packet.
    pub(super) fn check(&self, joints: JointPosition) -> Result<(), Error> {
        for joint in 0..6 {
            let at = joints.0[joint];
            let (least, most) = self.recent.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), recent| {
                (least.min(recent.0[joint]), most.max(recent.0[joint]))
            });
            let off_deg = (at - most).max(least - at);
            if off_deg > self.most_deg {
                return Err(ErrorKind::Departed { joint: joint + 1, at_deg: at, off_deg }.into());
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_joint_may_be_where_it_was_to_be_half_a_second_ago_and_no_further() {
        let at = |degrees: f64| JointPosition([0.0, degrees, 0.0, 0.0, 0.0, 0.0]);
        let mut departure = Departure::new(at(0.0), 0.008, 2.0);
        (1..=62).for_each(|n| departure.sent(at(f64::from(n))));
        // 0 and 1 to 62 in half a second of 63 set-points.
        assert!(departure.check(at(-2.0)).is_ok() && departure.check(at(64.0)).is_ok());
        let error = departure.check(at(-2.5)).expect_err("it is off");
        assert!(matches!(error.kind(), ErrorKind::Departed { joint: 2, off_deg: 2.5, .. }), "{error:?}");
        departure.sent(at(63.0));
        assert!(departure.check(at(-2.0)).is_err(), "the start is older than half a second");
    }
}
