//! Why a model was not accepted.

use jaka_proto::messages::types::JointPosition;

use super::Tolerance;

jaka_proto::worded! {
    /// Why a model was not accepted.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub enum FitError {
        /// A joint position or pose has a number that is not finite.
        NotFinite => "a number of the joint positions or poses is not finite",
        /// There are too few poses.
        TooFew {
            /// How many are needed.
            least: usize,
        } => "too few poses to compare; at least {least} are needed",
        /// A joint hardly moves over the poses, so that they do not tell about it.
        JointNotMoved {
            /// The joint, 1 to 6.
            joint: usize,
            /// How far it moves, in degrees.
            moved_deg: f64,
            /// How far it must.
            least_deg: f64,
        } => "joint {joint} moves by {moved_deg:.1} deg over the poses to compare; at least {least_deg} deg are needed",
        /// The poses are turned about one axis alone, so that more than one tool and mounting fit them.
        TooAlike => "the poses to compare are turned about one axis alone",
        /// The model differs from the controller: it is another arm, or one that is calibrated differently.
        Differs {
            /// The model's name.
            model: &'static str,
            /// Where the position differs most.
            joints: JointPosition,
            /// The largest difference of a position, in mm.
            position_mm: f64,
            /// The largest difference of an orientation, in degrees.
            angle_deg: f64,
            /// What is allowed.
            tolerance: Tolerance,
        } => (format!(
            "at joints {joints} the {model} differs from the controller by {position_mm:.3} mm and {angle_deg:.4} deg; \
             allowed are {} mm and {} deg",
            tolerance.position_mm, tolerance.angle_deg
        )),
    }
}

impl std::error::Error for FitError {}
