//! Consequences of causes for motions that the controller plans.

/// Consequence of an end of the wait for motions.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Consequence {
    /// They have ended.
    Over,
    /// They have ended, and no other is sent before somebody has acknowledged that.
    Latched,
    /// They have ended, no other is sent before somebody has acknowledged that, and the arm may still move.
    LatchedMayMove,
    /// As [`Stops`](Self::Stops), and no motion is sent before somebody has acknowledged that.
    LatchedStops,
    /// They are not waited for any more, and the arm may still move. Also of causes that never end this wait.
    MayMove,
    /// They are not waited for any more, and the arm is stopped.
    Stops,
    /// They may continue, and the program can wait for them again.
    GoesOn,
}

impl Consequence {
    /// True if no motion is sent before somebody has acknowledged it.
    pub(crate) fn latches(self) -> bool {
        match self {
            Self::Latched | Self::LatchedMayMove | Self::LatchedStops => true,
            Self::Over | Self::MayMove | Self::Stops | Self::GoesOn => false,
        }
    }

    /// True if the arm is stopped because of it.
    pub(crate) fn stops(self) -> bool {
        match self {
            Self::Stops | Self::LatchedStops => true,
            Self::Over | Self::Latched | Self::LatchedMayMove | Self::MayMove | Self::GoesOn => false,
        }
    }

    /// True if the arm may still move.
    pub(crate) fn may_move(self) -> bool {
        match self {
            Self::LatchedMayMove | Self::LatchedStops | Self::MayMove | Self::Stops | Self::GoesOn => true,
            Self::Over | Self::Latched => false,
        }
    }
}
