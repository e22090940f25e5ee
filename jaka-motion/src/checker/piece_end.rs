//! Where the arm is between two parts of a trajectory.

use nalgebra::{Isometry3, Point3, Vector3};

use crate::model::Point;

/// Where the arm is at the end of a piece.
#[derive(Debug, Clone)]
pub(crate) struct PieceEnd {
    /// In the order of [`Point::ALL`], in the arm's base.
    points: [Point3<f64>; 3],
    /// How each joint moves the tool centre point, in mm a radian.
    levers: [Vector3<f64>; 6],
}

impl PieceEnd {
    /// For the frames of the joints, and a tool on the flange.
    pub(super) fn new(frames: &[Isometry3<f64>; 6], tool: &Isometry3<f64>) -> Self {
        let tcp = (frames[5] * tool).translation.vector;
        let lever = |frame: &Isometry3<f64>| (frame.rotation * Vector3::z()).cross(&(tcp - frame.translation.vector));
        let levers = std::array::from_fn(|joint| lever(&frames[joint]));
        let [elbow, wrist] = [Point::Elbow, Point::Wrist].map(|point| frames[point.frame()].translation.vector.into());
        Self { points: [tcp.into(), elbow, wrist], levers }
    }

    pub(super) fn point(&self, point: Point) -> &Point3<f64> {
        &self.points[point as usize]
    }

    /// How the tool centre point moves where the joints turn so, in radians.
    pub(super) fn moved(&self, turns: [f64; 6]) -> Vector3<f64> {
        self.levers.iter().zip(turns).map(|(lever, turn)| lever * turn).sum()
    }
}
