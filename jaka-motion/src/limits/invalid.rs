//! Limits that make no sense.

use std::sync::Arc;

jaka_proto::worded! {
    /// Why something cannot be a limit.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub enum InvalidLimit {
        /// A number is not finite.
        NotFinite {
            /// Of what, for example `joint range`.
            what: &'static str,
        } => "{what}: a number is not finite",
        /// A number that must be above 0 is not.
        NotPositive {
            /// Of what, for example `joint speed`.
            what: &'static str,
            /// The number.
            given: f64,
        } => "{what}: {given} is not above 0",
        /// Joints are numbered from 1 to 6.
        NoSuchJoint {
            /// The number that was given.
            joint: usize,
        } => "there is no joint {joint}; joints are numbered from 1 to 6",
        /// The lower end of a range is above the upper one.
        EmptyRange {
            /// The joint, 1 to 6.
            joint: usize,
            /// The lower end, in degrees.
            min_deg: f64,
            /// The upper end, in degrees.
            max_deg: f64,
        } => "joint {joint}: the range from {min_deg} to {max_deg} deg is empty",
        /// A limit allows more than the arm's published figure.
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
        } =>
            "joint {joint}: {given} {unit} is beyond the {published} {unit} of the {model}; a limit can \
             only be tighter",
        /// A distance from a singularity is from 0 to below 1.
        NotADistance {
            /// The number that was given.
            given: f64,
        } => "distance from a singularity: {given} is not from 0 to below 1",
        /// A region has no name.
        NoName => "a region has no name",
        /// Two regions have the same name.
        NameTaken {
            /// The name.
            name: Arc<str>,
        } => (format!("two regions are called `{}`", name.escape_debug())),
        /// A box is too thin: less than nothing, or to be kept outside of and thinner than 1 mm.
        ThinBox {
            /// The region's name.
            name: Arc<str>,
            /// The box's smallest side, in mm.
            side_mm: f64,
        } => (format!(
            "box `{}`: a side of {side_mm} mm; a box is not thinner than 0 mm, and than 1 mm if kept outside of",
            name.escape_debug()
        )),
        /// The direction of a half-space has no length.
        NoDirection {
            /// The region's name.
            name: Arc<str>,
        } => (format!("half-space `{}`: the direction inward has no length", name.escape_debug())),
    }
}

impl std::error::Error for InvalidLimit {}
