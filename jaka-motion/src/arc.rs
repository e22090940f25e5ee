//! Arcs of a circle.

use nalgebra::{Isometry3, Point3, Rotation3, Translation3, Unit, Vector3};

use crate::transform::Transform;

/// Path along a circle from one pose through a second to a third. The tool turns evenly from each pose to the next.
#[derive(Debug, Clone)]
pub struct Arc {
    centre: Point3<f64>,
    axis: Unit<Vector3<f64>>,
    from: Transform,
    middle: Transform,
    to: Transform,
    /// Angles from the first pose to the middle one and to the last, in radians.
    angles: (f64, f64),
}

impl Arc {
    /// Returns the arc through three poses; `None` if their positions lie on a line.
    pub fn through(from: Transform, middle: Transform, to: Transform) -> Option<Self> {
        let [a, b, c] = [from, middle, to].map(|frame| Point3::from(frame.0.translation.vector));
        let (ab, ac) = (b - a, c - a);
        let normal = ab.cross(&ac);
        let axis = Unit::try_new(normal, 1e-6)?;
        let to_centre = (ac.norm_squared() * normal.cross(&ab) + ab.norm_squared() * ac.cross(&normal))
            / (2.0 * normal.norm_squared());
        let centre = a + to_centre;
        // With this normal the three points follow one another in the positive direction.
        let angle = |point: Point3<f64>| {
            let (start, here) = (a - centre, point - centre);
            axis.dot(&start.cross(&here)).atan2(start.dot(&here)).rem_euclid(std::f64::consts::TAU)
        };
        Some(Self { centre, axis, from, middle, to, angles: (angle(b), angle(c)) })
    }

    /// Returns the frame at a share of the arc, from 0 to 1.
    pub fn at(&self, share: f64) -> Transform {
        let (to_middle, to_end) = self.angles;
        let angle = to_end * share;
        let spoke = Rotation3::from_axis_angle(&self.axis, angle) * self.spoke();
        let turned = if angle < to_middle {
            self.from.between(&self.middle, angle / to_middle)
        } else {
            self.middle.between(&self.to, (angle - to_middle) / (to_end - to_middle))
        };
        Transform(Isometry3::from_parts(Translation3::from(self.centre.coords + spoke), turned.0.rotation))
    }

    /// Returns the length of the arc, in mm.
    pub fn length_mm(&self) -> f64 {
        self.spoke().norm() * self.angles.1
    }

    /// Returns the total turn of the frame along the arc, in degrees.
    pub fn turn_deg(&self) -> f64 {
        self.from.angle_deg(&self.middle) + self.middle.angle_deg(&self.to)
    }

    /// Returns the derivative of the position with respect to the share of the arc, in mm for the whole arc.
    pub(crate) fn velocity(&self, share: f64) -> Vector3<f64> {
        let (_, to_end) = self.angles;
        self.axis.cross(&(Rotation3::from_axis_angle(&self.axis, to_end * share) * self.spoke())) * to_end
    }

    /// Returns the share of the arc at the middle pose.
    pub(crate) fn middle_share(&self) -> f64 {
        self.angles.0 / self.angles.1
    }

    /// Returns the angle of the arc in radians.
    pub(crate) fn angle(&self) -> f64 {
        self.angles.1
    }

    /// Returns the three poses.
    pub(crate) fn poses(&self) -> [Transform; 3] {
        [self.from, self.middle, self.to]
    }

    /// Returns the vector from the centre to the start.
    fn spoke(&self) -> Vector3<f64> {
        self.from.0.translation.vector - self.centre.coords
    }
}
