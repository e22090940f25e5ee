//! Wrong states of servo mode.

jaka_proto::worded! {
    /// State of servo mode that keeps a call from its work: [`Cause::ServoMode`](crate::Cause::ServoMode).
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "snake_case"))]
    #[non_exhaustive]
    pub enum ServoModeState {
        /// It is off: call `set_servo_mode`, and wait until `is_in_servomove` says that it is on.
        Off => "it is off",
        /// It is on already: another program may send set-points, or a session of this one that was forgotten. If it is
        /// left over, call `set_servo_mode` with off.
        OnAlready => "it is on already, perhaps with set-points of another program or session",
        /// The controller acknowledged it but did not enter it, which happens while the arm moves.
        NotEntered => "the controller acknowledged it but did not enter it, for example because the arm moved",
        /// The controller acknowledged its end but is still in it.
        NotLeft => "the controller acknowledged its end but is still in it",
    }
}
