//! Where the arm is between two parts of a trajectory, and how fast the tool centre point is at most on a part.

use nalgebra::{Point3, Vector3};

use super::Checker;
use crate::limits::Point;
use crate::piece::{Hull, Piece};

/// Where the arm is at the end of a piece.
#[derive(Debug, Clone)]
pub(crate) struct PieceEnd {
    /// In the order of `POINTS`, in the arm's base.
    points: [Point3<f64>; 3],
    /// How each joint moves the tool centre point, in mm a radian.
    levers: [Vector3<f64>; 6],
}

impl PieceEnd {
    pub(super) fn point(&self, point: Point) -> &Point3<f64> {
        &self.points[point as usize]
    }

    fn moved(&self, turns: [f64; 6]) -> Vector3<f64> {
        self.levers.iter().zip(turns).map(|(lever, turn)| lever * turn).sum()
    }
}

impl Checker {
    pub(super) fn piece_end(&self, joints: &[f64; 6]) -> PieceEnd {
        let frames = self.limits.model().links.frames(joints);
        let tcp = (frames[5] * self.tool).translation.vector;
        let levers = frames.map(|frame| (frame.rotation * Vector3::z()).cross(&(tcp - frame.translation.vector)));
        let [elbow, wrist] = [Point::Elbow, Point::Wrist].map(|point| frames[point.frame()].translation.vector.into());
        PieceEnd { points: [tcp.into(), elbow, wrist], levers }
    }

    /// What the speed of the tool centre point is not above, in mm/s.
    ///
    /// If levers changed evenly from one end to the other, the velocity would be a polynomial of the fifth degree, no larger than its Bernstein coefficients. What they
    /// change otherwise is at most an eighth of their second derivative: the joints' accelerations, and their speeds twice, times the distance from the outermost
    /// axis of those that count.
    pub(super) fn tcp_speed_at_most(&self, piece: &Piece, hull: &Hull, ends: &[PieceEnd; 2]) -> f64 {
        let speeds: [[f64; 5]; 6] = std::array::from_fn(|joint| piece.speeds(joint).map(f64::to_radians));
        let moved = |end: usize, index: usize| ends[end].moved(speeds.map(|speed| speed[index]));
        let (mut largest, mut before) = (0.0_f64, Vector3::zeros());
        for (index, share) in [0.0, 0.2, 0.4, 0.6, 0.8].into_iter().enumerate() {
            largest = largest.max((moved(0, index) * (1.0 - share) + before * share).norm());
            before = moved(1, index);
        }
        let (turned, swung) = (hull.turned(piece.seconds), hull.swung(piece.seconds));
        let (mut bend_mm, mut turns, mut swings) = (0.0, 0.0, 0.0);
        for (joint, radius) in self.radii(Point::Tcp).iter().enumerate() {
            let (inner, outer) = ((turns, swings), (turns + turned[joint], swings + swung[joint]));
            let all = |(turns, swings): (f64, f64)| turns * (swings + turns * turns);
            bend_mm += radius * (all(outer) - all(inner));
            (turns, swings) = outer;
        }
        largest.max(before.norm()) + 0.125 * bend_mm / piece.seconds
    }
}

impl Hull {
    /// How far each joint turns at most in so many seconds, in radians.
    pub(super) fn turned(&self, seconds: f64) -> [f64; 6] {
        self.speeds.map(|speed| speed.to_radians() * seconds)
    }

    /// By how much that changes at most, in radians.
    pub(super) fn swung(&self, seconds: f64) -> [f64; 6] {
        self.accelerations.map(|acceleration| acceleration.to_radians() * seconds * seconds)
    }
}
