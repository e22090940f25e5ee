//! Regions for points of the arm.

use std::sync::Arc;

use nalgebra::{Point3, Unit, Vector3};

use super::{InvalidLimit, finite};
use crate::model::Point;

/// Region for a point of the arm: the inside of a box, the outside of one, or one side of a plane.
///
/// By default it applies to the tool centre point, seen from the user frame. The distance of a point beyond a box is
/// along the box's axes: for a box to be kept inside of, the longest distance along one of them; for a box to be kept
/// outside of, the shortest.
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
    /// Base of the arm, as in [`Model::forward`](crate::Model::forward): it moves with the mounting of the arm.
    #[cfg_attr(feature = "serde", serde(rename = "base"))]
    ArmBase,
    /// User frame, the frame of poses.
    User,
}

#[derive(Debug, Clone, PartialEq)]
pub(super) enum Shape {
    Inside { min: Point3<f64>, max: Point3<f64> },
    Outside { min: Point3<f64>, max: Point3<f64> },
    HalfSpace { border: Point3<f64>, inward: Unit<Vector3<f64>> },
}

/// Least side of a box that can be kept outside of, in mm.
const THINNEST: f64 = 1.0;

impl Region {
    /// Creates the inside of a box between two corners, in mm.
    ///
    /// # Errors
    /// A number is not finite, a lower corner is above the upper one, or the name is empty.
    pub fn inside_box(name: impl Into<Arc<str>>, min_mm: [f64; 3], max_mm: [f64; 3]) -> Result<Self, InvalidLimit> {
        Self::boxed(name.into(), min_mm, max_mm, 0.0, |min, max| Shape::Inside { min, max })
    }

    /// Creates the outside of a box between two corners, in mm.
    ///
    /// # Errors
    /// A number is not finite, a side is shorter than 1 mm, or the name is empty.
    pub fn outside_box(name: impl Into<Arc<str>>, min_mm: [f64; 3], max_mm: [f64; 3]) -> Result<Self, InvalidLimit> {
        Self::boxed(name.into(), min_mm, max_mm, THINNEST, |min, max| Shape::Outside { min, max })
    }

    /// Creates the half-space on one side of a plane. `inward` points to that side; the plane goes through a point, in
    /// mm, at right angles to it.
    ///
    /// # Errors
    /// A number is not finite, the direction has no length, or the name is empty.
    pub fn half_space(name: impl Into<Arc<str>>, point_mm: [f64; 3], inward: [f64; 3]) -> Result<Self, InvalidLimit> {
        let name = name.into();
        finite("half-space", &point_mm)?;
        finite("half-space", &inward)?;
        // Division by the largest number first gives a tiny or huge vector a direction, too.
        let inward = Vector3::from(inward);
        let Some(inward) = Unit::try_new(inward / inward.amax(), 0.1) else {
            return Err(InvalidLimit::NoDirection { name });
        };
        Self::new(name, Shape::HalfSpace { border: point_mm.into(), inward })
    }

    /// Sets the point of the arm that the region applies to.
    #[must_use]
    pub fn of(self, point: Point) -> Self {
        Self { point, ..self }
    }

    /// Sets the frame from which the region is seen.
    #[must_use]
    pub fn seen_from(self, frame: RegionFrame) -> Self {
        Self { frame, ..self }
    }

    /// Returns the name for messages.
    pub fn name(&self) -> &Arc<str> {
        &self.name
    }

    /// Returns the point of the arm that the region applies to.
    pub fn point(&self) -> Point {
        self.point
    }

    /// Returns the frame from which the region is seen.
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

    /// Returns the place at which a straight path between two points is in the middle of a box to be kept outside of,
    /// as a share of the path.
    ///
    /// The box is smaller by `depth` mm on each side, and by the lesser of a quarter of its thinnest side and half a
    /// millimetre, so that a path along a side does not count.
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
