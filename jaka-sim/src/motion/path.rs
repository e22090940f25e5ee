//! The ways along which the arm moves.

use nalgebra::{Isometry3, Point3, Rotation3, Translation3, Unit, UnitQuaternion, Vector3};

use crate::kinematics::Model;

/// Joint positions, in degrees.
pub(crate) type Joints = [f64; 6];

/// A transform, in millimetres.
pub(crate) type Transform = Isometry3<f64>;

/// The way from one position to another, by the distance from its beginning.
#[derive(Debug, Clone)]
pub(crate) enum Path {
    /// All joints at once, each at an even share of the way.
    Joints { from: Joints, to: Joints },
    /// The flange along a straight line.
    CommandConnection { from: Transform, to: Transform, tool: Transform },
    /// The flange along an arc.
    Arc(Box<Arc>),
}

/// The tool centre point on a circle, turning evenly to the middle pose and on to the last.
#[derive(Debug, Clone)]
pub(crate) struct Arc {
    centre: Point3<f64>,
    axis: Unit<Vector3<f64>>,
    from: Transform,
    middle: Transform,
    to: Transform,
    tool: Transform,
    /// The angles from the first pose to the middle one and to the last, in radians.
    angles: (f64, f64),
}

impl Path {
    /// The straight line of the tool centre point from one pose to another, both those of the tool.
    pub(crate) fn line(from: Transform, to: Transform, tool: Transform) -> Self {
        Self::CommandConnection { from, to, tool }
    }

    /// How long the way is: in degrees of the joint that turns furthest, or in millimetres of the tool centre point.
    ///
    /// Where the tool turns further in degrees than it moves in millimetres, the turn counts, so that a turn on the spot takes
    /// its time.
    pub(crate) fn length(&self) -> f64 {
        match self {
            Self::Joints { from, to } => from.iter().zip(to).map(|(from, to)| (to - from).abs()).fold(0.0, f64::max),
            Self::CommandConnection { from, to, .. } => {
                (to.translation.vector - from.translation.vector).norm().max(turn(from, to))
            }
            Self::Arc(arc) => {
                let radius = (arc.from.translation.vector - arc.centre.coords).norm();
                (radius * arc.angles.1).max(turn(&arc.from, &arc.middle) + turn(&arc.middle, &arc.to))
            }
        }
    }

    /// The joints at a share of the way from 0 to 1; `None` where the arm cannot be there.
    pub(crate) fn at(&self, share: f64, model: &Model, reference: Joints) -> Option<Joints> {
        match self {
            Self::Joints { from, to } => Some(std::array::from_fn(|i| from[i] + (to[i] - from[i]) * share)),
            Self::CommandConnection { from, to, tool } => {
                model.inverse(&(between(from, to, share) * tool.inverse()), reference)
            }
            Self::Arc(arc) => model.inverse(&(arc.at(share) * arc.tool.inverse()), reference),
        }
    }

    /// The joints at the end, if the arm can go all the way: tried at some places on it.
    pub(crate) fn end(&self, model: &Model, start: Joints) -> Option<Joints> {
        const PLACES: u32 = 32;
        let places = (1..=PLACES).map(|place| f64::from(place) / f64::from(PLACES));
        let end = places.into_iter().try_fold(start, |reference, share| self.at(share, model, reference))?;
        model.within_limits(&end).then_some(end)
    }
}

impl Arc {
    /// The arc through three poses of the tool; `None` where they lie on a line.
    pub(crate) fn through(from: Transform, middle: Transform, to: Transform, tool: Transform) -> Option<Self> {
        let [a, b, c] = [from, middle, to].map(|frame| Point3::from(frame.translation.vector));
        let (ab, ac) = (b - a, c - a);
        let normal = ab.cross(&ac);
        let axis = Unit::try_new(normal, 1e-6)?;
        let to_centre = (ac.norm_squared() * normal.cross(&ab) + ab.norm_squared() * ac.cross(&normal))
            / (2.0 * normal.norm_squared());
        let centre = a + to_centre;
        // With this normal the three points follow one another in the positive sense.
        let angle = |point: Point3<f64>| {
            let (start, here) = (a - centre, point - centre);
            axis.dot(&start.cross(&here)).atan2(start.dot(&here)).rem_euclid(std::f64::consts::TAU)
        };
        Some(Self { centre, axis, from, middle, to, tool, angles: (angle(b), angle(c)) })
    }

    fn at(&self, share: f64) -> Transform {
        let (to_middle, to_end) = self.angles;
        let angle = to_end * share;
        let spoke = Rotation3::from_axis_angle(&self.axis, angle) * (self.from.translation.vector - self.centre.coords);
        let turned = if angle < to_middle {
            between(&self.from, &self.middle, angle / to_middle)
        } else {
            between(&self.middle, &self.to, (angle - to_middle) / (to_end - to_middle))
        };
        Transform::from_parts(Translation3::from(self.centre.coords + spoke), turned.rotation)
    }
}

/// The angle between the orientations of two frames, in degrees.
fn turn(from: &Transform, to: &Transform) -> f64 {
    from.rotation.angle_to(&to.rotation).to_degrees()
}

/// The frame at a share of the straight way, turned evenly about one axis.
fn between(from: &Transform, to: &Transform, share: f64) -> Transform {
    let place = from.translation.vector.lerp(&to.translation.vector, share);
    // By axis and angle, which unlike slerp knows a way also for half a turn.
    let turn = (from.rotation.inverse() * to.rotation).scaled_axis() * share;
    Transform::from_parts(Translation3::from(place), from.rotation * UnitQuaternion::from_scaled_axis(turn))
}
