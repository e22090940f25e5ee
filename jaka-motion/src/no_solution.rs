//! Why no joint position reaches a pose.

jaka_proto::worded! {
    /// Why the arm cannot bring its flange to a pose.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub enum NoSolution {
        /// The pose or the reference has a number that is not finite.
        NotFinite => "a number of the pose or of the reference is not finite",
        /// The pose is too far away, or too near to the axis of joint 1.
        OutOfReach {
            /// How much longer or shorter the arm would have to be between shoulder and wrist, at least, in mm.
            by_mm: f64,
        } => "out of reach by {by_mm:.1} mm",
        /// The pose is within reach, but each way to it turns a joint beyond its range. This is the least of it.
        BeyondRange {
            /// The joint, 1 to 6.
            joint: usize,
            /// Where it would be, in degrees.
            position_deg: f64,
            /// The end of its range, in degrees.
            limit_deg: f64,
        } => "joint {joint} would be at {position_deg:.1} deg; limit {limit_deg}",
        /// The joint positions that were found do not bring the flange there well enough, which is so at the edge of
        /// reach.
        NotConfirmed => "at the edge of reach: no joint position was confirmed",
    }
}

impl std::error::Error for NoSolution {}
