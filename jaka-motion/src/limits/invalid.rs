//! Limits that make no sense.

use std::sync::Arc;

/// Why something cannot be a limit.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum InvalidLimit {
    /// A number is not finite.
    #[error("{what}: a number is not finite")]
    NotFinite {
        /// Of what, for example `joint range`.
        what: &'static str,
    },
    /// A number that must be above 0 is not.
    #[error("{what}: {given} is not above 0")]
    NotPositive {
        /// Of what, for example `joint speed`.
        what: &'static str,
        /// The number.
        given: f64,
    },
    /// Joints are numbered from 1 to 6.
    #[error("there is no joint {joint}; joints are numbered from 1 to 6")]
    NoSuchJoint {
        /// The number that was given.
        joint: usize,
    },
    /// The lower end of a range is above the upper one.
    #[error("joint {joint}: the range from {min_deg} to {max_deg} deg is empty")]
    EmptyRange {
        /// The joint, 1 to 6.
        joint: usize,
        /// The lower end, in degrees.
        min_deg: f64,
        /// The upper end, in degrees.
        max_deg: f64,
    },
    /// A limit allows more than the arm's published figure.
    #[error(
        "joint {joint}: {given} {unit} is beyond the {published} {unit} of the {model}; a limit can only be tighter"
    )]
    Wider {
        /// The joint, 1 to 6.
        joint: usize,
        /// The limit.
        given: f64,
        /// The arm's figure.
        published: f64,
        /// The unit of both, `deg` or `deg/s`.
        unit: &'static str,
        /// The arm's name.
        model: &'static str,
    },
    /// A distance from a singularity is from 0 to below 1.
    #[error("distance from a singularity: {given} is not from 0 to below 1")]
    NotADistance {
        /// The number that was given.
        given: f64,
    },
    /// A region has no name.
    #[error("a region has no name")]
    NoName,
    /// Two regions have the same name.
    #[error("two regions are called `{}`", name.escape_debug())]
    NameTaken {
        /// The name.
        name: Arc<str>,
    },
    /// A box is too thin: less than nothing, or to be kept outside of and thinner than 1 mm.
    #[error("box `{}`: a side of {side_mm} mm; a box is not thinner than 0 mm, and than 1 mm if kept outside of", name.escape_debug())]
    ThinBox {
        /// The region's name.
        name: Arc<str>,
        /// The box's smallest side, in mm.
        side_mm: f64,
    },
    /// The direction of a half-space has no length.
    #[error("half-space `{}`: the direction inward has no length", name.escape_debug())]
    NoDirection {
        /// The region's name.
        name: Arc<str>,
    },
}
