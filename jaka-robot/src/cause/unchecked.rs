//! Why a motion could not be checked.

use super::remedy::Remedy;

jaka_proto::worded! {
    /// Why a motion or a set-point could not be checked against the limits.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    #[non_exhaustive]
    pub enum Unchecked {
        /// Where it begins is not known: the arm moves, or it follows a motion whose end was not known. Wait for the
        /// end of all motions.
        Start => "where it begins is not known",
        /// The request does not determine where it ends, such as an arc by offsets or a relative motion with a
        /// rotation. Give an absolute target.
        Target => "the request does not say where it ends",
        /// The request does not determine its path: name the `path` in the `[command.motion]` of a pack, or send it
        /// without limits.
        Path => "the request does not say on which way the arm goes",
        /// The controller's pose of the arm does not fit its joint positions, for the frames that its `kine_forward`
        /// shows: a frame was changed at this moment, or the arm moved.
        Frames => "the arm's pose does not fit its joint positions: a frame is changing, or the arm moves",
        /// A motion before it has not been waited for, and a frame was changed since. Wait for its end.
        FramesInQueue => "a frame was changed after a motion that has not ended",
        /// The robot has no limits, by which streams and trajectories know the arm: see
        /// [`RobotConfig::limits`](crate::RobotConfig::limits).
        NoLimits =>
            "the robot has none, by which streams and trajectories know the arm",
    }
}

impl Unchecked {
    /// Remedy.
    pub fn remedy(self) -> Remedy {
        match self {
            Self::Start | Self::FramesInQueue => Remedy::WaitForMotions,
            Self::Target => Remedy::GiveAbsoluteTarget,
            Self::Path => Remedy::None,
            Self::Frames => jaka_sync::Remedy::TryAgain.into(),
            Self::NoLimits => Remedy::GiveLimits,
        }
    }
}
