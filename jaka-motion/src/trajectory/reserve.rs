//! What is left of the accelerations for following at another rate.

use super::Trajectory;
use crate::piece::Piece;
use crate::piece::bernstein::{part, peak};

impl Trajectory {
    /// How fast the rate may change at a time, in 1/s: the most by which it may rise or fall in a second with all joints within their
    /// accelerations.
    ///
    /// The rate is how much of the trajectory's time passes in a second: 1 as planned, 0 at a pause. At rate r that changes by r' the joints'
    /// accelerations are `a r² + v r'`, with speeds v and accelerations a of [`at`](Self::at). So this is the least of `(limit - |a| r²) / |v|`, which is
    /// 0 where nothing is left, and infinite where no joint moves. Where an acceleration steps, the larger one counts.
    ///
    /// A trajectory that was made of points with times can leave nothing at rate 1. Who follows it then goes on at this rate until something is left:
    /// a pause or a stop along the way begins so much later.
    pub fn rate_change(&self, time_s: f64, rate: f64) -> f64 {
        self.rate_change_between(time_s, time_s, rate)
    }

    /// How fast the rate may change all the while between two times, as [`rate_change`](Self::rate_change): at most the least of those in between, and
    /// rarely less.
    pub fn rate_change_between(&self, from_s: f64, to_s: f64, rate: f64) -> f64 {
        // What is not a number counts as the start.
        let (from_s, to_s) = (from_s.max(0.0), to_s.max(0.0));
        // A step of acceleration at the time itself counts with both sides.
        let last = self.piece_at(to_s.max(from_s));
        let pieces = &self.0.pieces[..=last];
        let first = pieces.partition_point(|piece| piece.end_s() < from_s).min(last);
        let changes = pieces[first..].iter().map(|piece| self.rate_change_on(piece, from_s, to_s, rate));
        changes.fold(f64::INFINITY, f64::min)
    }

    /// By which accelerations, in deg/s², that is counted.
    pub(crate) fn joint_accelerations(&self) -> &[f64; 6] {
        self.0.checker.limits().joint_accelerations()
    }

    fn rate_change_on(&self, piece: &Piece, from_s: f64, to_s: f64, rate: f64) -> f64 {
        let share = |time_s: f64| ((time_s - piece.start_s) / piece.seconds).clamp(0.0, 1.0);
        let (from, to) = (share(from_s), share(to_s.max(from_s)));
        let accelerations = self.joint_accelerations();
        let change = |joint: usize| {
            let speed = peak(&part(&piece.speeds(joint), from, to));
            let acceleration = peak(&part(&piece.accelerations(joint), from, to));
            let left = (accelerations[joint] - acceleration * rate * rate).max(0.0);
            if speed > 0.0 { left / speed } else { f64::INFINITY }
        };
        (0..6).map(change).fold(f64::INFINITY, f64::min)
    }
}
