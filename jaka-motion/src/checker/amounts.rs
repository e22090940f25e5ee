//! By how much a limit may be exceeded without notice.

use super::Checker;

/// By how much a limit may be exceeded without notice, somewhere between the places on a way that are computed.
impl Checker {
    /// What is beyond a region by more than this, in mm, is refused.
    pub const AMOUNT_MM: f64 = 1.0;

    /// What is beyond a joint's range by more than this, in degrees, is refused.
    pub const AMOUNT_DEG: f64 = 0.1;

    /// What is faster than a speed limit by more than this share of it is refused. The speeds of set-points are means over the period.
    pub const AMOUNT_SPEED: f64 = 0.02;

    /// What is nearer to a singularity than the least distance by more than this is refused.
    pub const AMOUNT_SINGULARITY: f64 = 0.002;
}

/// What rounding may add to an angle in degrees, a length in mm or a distance from a singularity: far below the stated amounts, and far above
/// how exactly joint positions are found for a pose.
pub(super) const ROUNDING: f64 = 1e-5;

/// What rounding may add to where a start beyond a limit is: so little that it does not add up over a queue of motions or a session.
pub(super) const START_ROUNDING: f64 = 1e-9;

/// How far, in mm, a point may be from the straight way between two neighbouring samples. With the quarter of a box's side by which
/// [`Region::crossed`](crate::limits::Region) reduces it, at least 0.25 mm, a way through the box has a sample in it.
pub(super) const BEND_MM: f64 = 0.1;

/// The least share of a way between two samples, which bounds their number.
pub(super) const LEAST_STEP: f64 = 5e-5;
