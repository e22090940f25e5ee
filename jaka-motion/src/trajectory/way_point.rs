//! The points that a trajectory was made of.

/// A point that a trajectory was made of: when it is reached, and how.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct WayPoint {
    /// When the arm is there, or nearest to it, in seconds from the start.
    pub time_s: f64,
    /// How the arm passes it.
    pub passing: Passing,
}

/// How the arm passes a way-point.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Passing {
    /// It stops there.
    Stops,
    /// It goes through it.
    Through,
    /// It rounds the corner, within the tolerance that was named.
    Rounded,
}
