//! Bounds of the motion of points of the arm while joints turn.

use nalgebra::{Isometry3, Point3, Vector3};

use crate::closed_form::Wrist;
use crate::links::Links;
use crate::model::{Model, Point};
use crate::piece::{Hull, Piece};

/// Distances of points from the axes of joints, which bound the motion of the points.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Radii {
    /// Greatest distance of each point from the axis of each joint, in mm; 0 for a joint that does not move it.
    of: [[f64; 6]; 3],
    /// Greatest change of each distance from a singularity for a turn of a joint by one radian.
    distances: [[f64; 6]; 3],
}

/// Bounds of the motion of a point along a path, whose length is 1.
#[derive(Debug, Clone, Copy)]
pub(super) struct PointMotion {
    /// Greatest distance that the point moves, in mm.
    pub(super) rate_mm: f64,
    /// Greatest change of the point's velocity, in mm.
    pub(super) bend_mm: f64,
}

/// Points of the arm at the end of a piece, with the levers of its joints.
#[derive(Debug, Clone)]
pub(crate) struct PieceEnd {
    /// Positions in the order of [`Point::ALL`], in the arm's base.
    points: [Point3<f64>; 3],
    /// Motion of the tool centre point for a turn of each joint, in mm a radian.
    levers: [Vector3<f64>; 6],
}

/// Greatest distance of a point from the straight line between two neighbouring samples, in mm. With the quarter of a
/// box's side by which [`Region::crossed`](crate::limits::Region) reduces it, at least 0.25 mm, a path through the box
/// has a sample in it.
pub(super) const BEND_MM: f64 = 0.1;
/// Least share of a path between two samples, which bounds their number.
pub(super) const LEAST_STEP: f64 = 5e-5;

impl Radii {
    /// Creates the bounds for a model with a tool at this place on its flange.
    pub(super) fn new(model: &Model, tool: &Vector3<f64>) -> Self {
        let links = &model.links;
        let of = Point::ALL.map(|point| {
            let tool = if point == Point::Tcp { *tool } else { Vector3::zeros() };
            std::array::from_fn(|joint| {
                let bars = (joint + 1..=point.frame()).map(|link| links.a[link].hypot(links.d[link])).sum::<f64>();
                // The last axis is the tool's z axis.
                bars + if joint == 5 { tool.x.hypot(tool.y) } else { tool.norm() }
            })
        });
        Self { of, distances: distances(model, &of[Point::Wrist as usize]) }
    }

    fn of(&self, point: Point) -> &[f64; 6] {
        &self.of[point as usize]
    }

    /// Returns a bound of the distance that the tool centre point moves while the joints turn by these degrees, in mm.
    pub(crate) fn tcp_rate_at_most(&self, moved: &[f64; 6]) -> f64 {
        self.of(Point::Tcp).iter().zip(moved).map(|(radius, moved)| radius * moved.abs().to_radians()).sum()
    }

    /// Returns a bound of the change of each distance from a singularity while the joints turn by these radians.
    pub(crate) fn distances_change(&self, turned: &[f64; 6]) -> [f64; 3] {
        self.distances.map(|rates| rates.iter().zip(turned).map(|(rate, turned)| rate * turned).sum())
    }

    /// Returns the bounds of a point's motion while the joints turn by at most these radians.
    pub(super) fn motion(&self, point: Point, turned: &[f64; 6]) -> PointMotion {
        let (mut rate_mm, mut bend_mm, mut sum) = (0.0, 0.0, 0.0);
        for (radius, turned) in self.of(point).iter().zip(turned) {
            rate_mm += turned * radius;
            // A turn changes the motion of the point by another joint: at most by both turns times the outer one's
            // distance.
            bend_mm += (2.0 * sum + turned) * turned * radius;
            sum += turned;
        }
        PointMotion { rate_mm, bend_mm }
    }

    /// Returns the bounds of a point's motion on a path straight in joint space, over these degrees.
    pub(super) fn motion_of_path(&self, point: Point, moved: &[f64; 6]) -> PointMotion {
        self.motion(point, &moved.map(|degrees| degrees.abs().to_radians()))
    }

    /// Returns the bounds of a point's motion while the joints turn by at most the radians of `turned`, and these turns
    /// change by at most those of `swung`.
    pub(super) fn motion_with_swings(&self, point: Point, turned: &[f64; 6], swung: &[f64; 6]) -> PointMotion {
        let motion = self.motion(point, turned);
        let swings: f64 = self.of(point).iter().zip(swung).map(|(radius, swung)| radius * swung).sum();
        PointMotion { bend_mm: motion.bend_mm + swings, ..motion }
    }

    /// Returns the bounds of a point's motion on a piece.
    pub(super) fn motion_on_piece(&self, point: Point, piece: &Piece, hull: &Hull) -> PointMotion {
        self.motion_with_swings(point, &hull.turned(piece.seconds), &hull.swung(piece.seconds))
    }

    /// Returns a bound of the tool centre point's speed on a piece, in mm/s.
    ///
    /// If the levers changed evenly from one end to the other, the velocity would be a polynomial of the fifth degree,
    /// no larger than its Bernstein coefficients. The remaining change of the levers is at most an eighth of their
    /// second derivative. That derivative is bounded by the joints' accelerations and twice the products of their
    /// speeds, times the distance from the outermost axis involved.
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
        for (joint, radius) in self.of(Point::Tcp).iter().enumerate() {
            let (inner, outer) = ((turns, swings), (turns + turned[joint], swings + swung[joint]));
            let all = |(turns, swings): (f64, f64)| turns * (swings + turns * turns);
            bend_mm += radius * (all(outer) - all(inner));
            (turns, swings) = outer;
        }
        largest.max(before.norm()) + 0.125 * bend_mm / piece.seconds
    }
}

/// Returns bounds of the change of the distances from singularities with the joints, for the wrist's distances from
/// their axes.
fn distances(model: &Model, wrist: &[f64; 6]) -> [[f64; 6]; 3] {
    match model.closed_form.wrist {
        Wrist::Parallel | Wrist::Spherical => {
            let shoulder = [0.0, wrist[1], wrist[2], wrist[3], 0.0, 0.0].map(|radius| radius / model.reach_mm());
            [shoulder, [0.0, 0.0, 1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0, 1.0, 0.0]]
        }
        Wrist::Offset => [[0.0; 6], [0.0; 6], determinant(model)],
    }
}

/// Returns bounds of the change of the determinant of an offset wrist's Jacobian with the joints, as a share of its
/// bound.
///
/// Up to the sign it is the length of the upper arm times `p q s + p e t + u t f + v q f`. `p` is the lever of the
/// wrist about the elbow, `q` about the base axis, `u` along the axis of joint 2. `t` and `v` are parts of the offset;
/// `s`, `e` and `f` are cosines between directions. Each factor is no larger than its length, and changes by at most
/// that length or the length with which a joint turns it.
fn determinant(model: &Model) -> [f64; 6] {
    let Links { a, d, .. } = &model.links;
    let (offset, upper_arm) = (a[4].hypot(d[4]), a[2].hypot(d[2]));
    let forearm = a[3].hypot(d[3]).hypot(offset);
    let (aside, radius) = (d[1].abs() + d[2].abs() + offset, upper_arm + forearm + d[1].abs());
    let turn = |p: f64, q: f64, u: f64, [t, v]: [f64; 2], [s, e, f]: [f64; 3]| {
        let parts = [
            p * radius + forearm * q + forearm * radius * s,
            p * offset + forearm * t + forearm * offset * e,
            u * offset + aside * t + aside * offset * f,
            v * radius + offset * q + offset * radius * f,
        ];
        parts.iter().sum::<f64>() * upper_arm / model.links.largest_determinant()
    };
    [
        0.0,
        turn(0.0, radius, aside, [0.0; 2], [0.0, 1.0, 0.0]),
        turn(forearm, forearm, 0.0, [0.0, offset], [0.0, 1.0, 0.0]),
        turn(offset, offset, offset, [offset; 2], [0.0, 1.0, 1.0]),
        turn(0.0, 0.0, 0.0, [0.0; 2], [1.0; 3]),
        0.0,
    ]
}

impl PieceEnd {
    /// Creates the points and levers for the frames of the joints and a tool on the flange.
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

    /// Returns the motion of the tool centre point while the joints turn by these radians, in mm.
    pub(super) fn moved(&self, turns: [f64; 6]) -> Vector3<f64> {
        self.levers.iter().zip(turns).map(|(lever, turn)| lever * turn).sum()
    }
}
