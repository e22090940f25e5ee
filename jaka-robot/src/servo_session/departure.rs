//! Check that the joints follow their set-points.

use jaka_proto::messages::types::JointPosition;

use crate::{Error, ErrorKind};

/// The set-points of the last half second: the arm lags, and packets are late.
#[derive(Debug)]
pub(super) struct Departure {
    /// Joint positions of set-points, where they are known.
    recent: Vec<Option<JointPosition>>,
    next: usize,
    pub(super) most_deg: f64,
}

/// Time for which set-points count, in seconds.
const COUNTS_S: f64 = 0.5;

/// Departure that counts unless a program says otherwise, in degrees.
pub(crate) const MOST_DEG: f64 = 5.0;

impl Departure {
    /// For an arm at rest here, where that is known.
    pub(super) fn new(start: Option<JointPosition>, period_s: f64) -> Self {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a period is 8 ms to 96 ms")]
        let count = (COUNTS_S / period_s).ceil() as usize;
        Self { recent: vec![start; count.max(1)], next: 0, most_deg: MOST_DEG }
    }

    /// A set-point was sent.
    pub(super) fn sent(&mut self, joints: Option<JointPosition>) {
        self.recent[self.next] = joints;
        self.next = (self.next + 1) % self.recent.len();
    }

    /// Compares the joints of a packet with the known set-points.
    pub(super) fn check(&self, joints: JointPosition) -> Result<(), Error> {
        for joint in 0..6 {
            let at = joints.0[joint];
            let known = self.recent.iter().flatten().map(|recent| recent.0[joint]);
            let (least, most) =
                known.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), at| (least.min(at), most.max(at)));
            let off_deg = (at - most).max(least - at);
            if off_deg > self.most_deg {
                return Err(ErrorKind::Departed { joint: joint + 1, at_deg: at, off_deg }.into());
            }
        }
        Ok(())
    }

    /// True if joints are known to follow their set-points, by a packet.
    pub(super) fn is_followed(&self, joints: JointPosition) -> bool {
        self.recent.iter().all(Option::is_some) && self.check(joints).is_ok()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_joint_may_be_where_it_was_to_be_half_a_second_ago_and_no_further() {
        let at = |degrees: f64| JointPosition([0.0, degrees, 0.0, 0.0, 0.0, 0.0]);
        let mut departure = Departure { most_deg: 2.0, ..Departure::new(Some(at(0.0)), 0.008) };
        (1..=62).for_each(|n| departure.sent(Some(at(f64::from(n)))));
        // 0 and 1 to 62 in half a second of 63 set-points.
        assert!(departure.check(at(-2.0)).is_ok() && departure.check(at(64.0)).is_ok());
        let error = departure.check(at(-2.5)).expect_err("it is off");
        assert!(matches!(error.kind(), ErrorKind::Departed { joint: 2, off_deg: 2.5, .. }), "{error:?}");
        departure.sent(Some(at(63.0)));
        assert!(departure.check(at(-2.0)).is_err(), "the start is older than half a second");
    }
}
