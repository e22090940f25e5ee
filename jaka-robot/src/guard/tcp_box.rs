//! A box in which the tool centre point is, or is not.

use std::fmt;

use crate::cause::Field;
use crate::error::OptionName;
use crate::{Error, NotShown, Snapshot};

/// A box along the axes of the selected user frame, for the tool centre point: mm.
///
/// It is compared with [`RobotStatus::actual_position`](crate::status::RobotStatus::actual_position), in the frames
/// that are selected when a packet is made.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TcpBox {
    least: [f64; 3],
    most: [f64; 3],
}

impl TcpBox {
    /// A box of any two opposite corners. One with a number that is not finite is an
    /// [`ErrorKind::InvalidOption`](crate::ErrorKind::InvalidOption) where the box is used.
    pub fn from_corners(one: [f64; 3], other: [f64; 3]) -> Self {
        // A corner that is not a number stays one, and is refused.
        let pick = |choose: fn(f64, f64) -> bool| {
            std::array::from_fn(|i| if one[i].is_nan() || choose(one[i], other[i]) { one[i] } else { other[i] })
        };
        Self { least: pick(|one, other| one < other), most: pick(|one, other| one > other) }
    }

    pub(super) fn check(&self) -> Result<(), Error> {
        let Some(odd) = self.least.iter().chain(&self.most).find(|value| !value.is_finite()) else {
            return Ok(());
        };
        Err(OptionName::new("TcpBox", "corner").refuse(odd, "a finite number of mm"))
    }

    pub(super) fn contains(&self, packet: &Snapshot) -> Result<bool, NotShown> {
        let pose = Field { packet, name: "actual_position" }.shown(packet.status.actual_position)?;
        let at = [pose.x, pose.y, pose.z];
        Ok((0..3).all(|i| (self.least[i]..=self.most[i]).contains(&at[i])))
    }
}

impl fmt::Display for TcpBox {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { least: [x0, y0, z0], most: [x1, y1, z1] } = self;
        write!(f, "the box x {x0} to {x1}, y {y0} to {y1}, z {z0} to {z1} mm")
    }
}
