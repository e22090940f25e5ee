//! Regions for points of the arm.

use std::sync::Arc;

use nalgebra::{Point3, Unit, Vector3};

use super::{InvalidLimit, finite};
use crate::model::Point;

/// Region for a point of the arm: the inside of a box, the outside of one, or one side of a plane.
///
/// By default it is for the tool centre point, seen from the user frame. The distance of a point beyond a box is
/// measured along the box's axes: for a box to be kept inside of, the longest distance along one of them; for a box to
/// be kept outside of, the shortest.
#[derive(Debug, Clone, PartialEq)]
pub struct Region {
    name: Arc<str>,
    shape: Shape,
    point: Point,
    frame: RegionFrame,
}

/// Frame from which a region is seen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[non_exhaustive]
pub enum RegionFrame {
    /// The arm's own base, as [`Model::forward`](crate::Model::forward) has it: it goes where the arm is mounted.
    #[cfg_attr(feature = "serde", serde(rename = "base"))]
    ArmBase,
    /// The frame in which poses are given: the user frame.
    User,
}

#[derive(Debug, Clone, PartialEq)]
pub(super) enum Shape {
    Inside { min: Point3<f64>, max: Point3<f64> },
    Outside { min: Point3<f64>, max: Point3<f64> },
    HalfSpace { border: Point3<f64>, inward: Unit<Vector3<f64>> },
}

/// The thinnest box that can be kept outside of, in mm.
const THINNEST: f64 = 1.0;

impl Region {
    /// Inside a box between two corners, in mm.
    ///
    /// # Errors
    /// A number is not finite, a lower corner is above the upper one, or the name is empty.
    pub fn inside_box(name: impl Into<Arc<str>>, min_mm: [f64; 3], max_mm: [f64; 3]) -> Result<Self, InvalidLimit> {
        Self::boxed(name.into(), min_mm, max_mm, 0.0, |min, max| Shape::Inside { min, max })
    }

    /// Outside of a box between two corners, in mm.
    ///
    /// # Errors
    /// A number is not finite, a side is shorter than 1 mm, or the name is empty.
    pub fn outside_box(name: impl Into<Arc<str>>, min_mm: [f64; 3], max_mm: [f64; 3]) -> Result<Self, InvalidLimit> {
        Self::boxed(name.into(), min_mm, max_mm, THINNEST, |min, max| Shape::Outside { min, max })
    }

    /// On the side of a plane to which a direction points; the plane goes through a point, in mm, at right angles to
    /// the direction.
    ///
    /// # Errors
    /// A number is not finite, the direction has no length, or the name is empty.
    pub fn half_space(name: impl Into<Arc<str>>, point_mm: [f64; 3], inward: [f64; 3]) -> Result<Self, InvalidLimit> {
        let name = name.into();
        finite("half-space", &point_mm)?;
        finite("half-space", &inward)?;
        // Divided by the largest first: a tiny or huge one has a direction too.
        let inward = Vector3::from(inward);
        let Some(inward) = Unit::try_new(inward / inward.amax(), 0.1) else {
            return Err(InvalidLimit::NoDirection { name });
        };
        Self::new(name, Shape::HalfSpace { border: point_mm.into(), inward })
    }

    /// For this point of the arm.
    #[must_use]
    pub fn of(self, point: Point) -> Self {
        Self { point, ..self }
    }

    /// Seen from this frame.
    #[must_use]
    pub fn seen_from(self, frame: RegionFrame) -> Self {
        Self { frame, ..self }
    }

    /// Its name, for messages.
    pub fn name(&self) -> &Arc<str> {
        &self.name
    }

    /// The point of the arm that it is for.
    pub fn point(&self) -> Point {
        self.point
    }

    /// Returns the frame from which it is seen.
    pub fn frame(&self) -> RegionFrame {
        self.frame
    }

    /// Returns the shape.
    #[cfg(feature = "serde")]
    pub(super) fn shape(&self) -> &Shape {
        &self.shape
    }

    fn boxed(
        name: Arc<str>,
        min: [f64; 3],
        max: [f64; 3],
        thinnest: f64,
        shape: impl FnOnce(Point3<f64>, Point3<f64>) -> Shape,
    ) -> Result<Self, InvalidLimit> {
        finite("box", &min)?;
        finite("box", &max)?;
        let side_mm = min.iter().zip(max).map(|(min, max)| max - min).fold(f64::INFINITY, f64::min);
        if side_mm < thinnest {
            return Err(InvalidLimit::ThinBox { name, side_mm });
        }
        Self::new(name, shape(min.into(), max.into()))
    }

    fn new(name: Arc<str>, shape: Shape) -> Result<Self, InvalidLimit> {
        if name.trim().is_empty() {
            return Err(InvalidLimit::NoName);
        }
        Ok(Self { name, shape, point: Point::Tcp, frame: RegionFrame::User })
    }

    /// Returns the distance of a point in the region's frame beyond the region, in mm; negative if the point is within.
    pub(crate) fn beyond(&self, at: &Point3<f64>) -> f64 {
        let past = |min: &Point3<f64>, max: &Point3<f64>| (min - at).max().max((at - max).max());
        match &self.shape {
            Shape::Inside { min, max } => past(min, max),
            Shape::Outside { min, max } => -past(min, max),
            Shape::HalfSpace { border, inward } => inward.dot(&(border - at)),
        }
    }

    /// Returns the place at which a straight path between two points is in the midst of a box to be kept outside of, as
    /// a share of the path.
    ///
    /// The box is smaller by `depth` mm on each side, and by a quarter of its thinnest side or half a millimetre, so
    /// that a path along a side does not count.
    pub(crate) fn crossed(&self, from: &Point3<f64>, to: &Point3<f64>, depth: f64) -> Option<f64> {
        let Shape::Outside { min, max } = &self.shape else { return None };
        let less = depth + (0.25 * (max - min).min()).min(0.5);
        let (mut enters, mut leaves) = (0.0_f64, 1.0_f64);
        for axis in 0..3 {
            let (start, along) = (from[axis], to[axis] - from[axis]);
            let (low, high) = (min[axis] + less, max[axis] - less);
            if along == 0.0 {
                if start < low || start > high {
                    return None;
                }
            } else {
                let (one, other) = ((low - start) / along, (high - start) / along);
                enters = enters.max(one.min(other));
                leaves = leaves.min(one.max(other));
            }
            if low > high {
                return None;
            }
        }
        (enters <= leaves).then_some(f64::midpoint(enters, leaves))
    }
}
