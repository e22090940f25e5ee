impl ::jaka_proto::ErrorCode {
    /// The controller rejects the command.
    ///
    /// Not in the document. Seen when [`servo_j`](crate::messages::servo::ServoJ) was sent outside servo mode; what else it covers is not known.
    pub const REJECTED: Self = Self(-1i64);
    /// The command was accepted.
    ///
    /// The document says executed, but it may not have ended yet: a motion is only accepted, and on newer firmware [`power_on`](crate::messages::power::PowerOn) and
    /// [`enable_robot`](crate::messages::power::EnableRobot) need seconds after it.
    ///
    /// The message is empty by chapter 5, while chapter 3 prints `unknown`. It may be absent too (field notes).
    pub const SUCCESS: Self = Self(0i64);
    /// An exception arose in the controller's program.
    ///
    /// Also the answer to an unknown `cmdName`, and then the reply itself has no `cmdName`.
    pub const EXCEPTION: Self = Self(1i64);
    /// The command failed; the message says more, or only that: of a motion, the target may be beyond the arm's ranges or out of reach.
    ///
    /// Often `call … failed` with the command's name: in a transcript, for malformed arguments, and of [`kine_inverse`](crate::messages::kinematics::KineInverse) where it finds no
    /// solution. It is likely, not certain, that a wrong state has the same answer, such as [`joint_move`](crate::messages::motion::JointMove) while the robot is not enabled.
    pub const CALL_FAILED: Self = Self(2i64);
    /// The controller does not take commands from this source: grant remote control on its panel.
    ///
    /// Not in the document. Seen on a Schneider Lexium, which is of the same controller family, with the message
    /// `permission deny, please check remote control source`.
    pub const PERMISSION_DENIED: Self = Self(3i64);
    /// Meaning of the code in a sentence, from sources; `None` for a code that they do not name.
    pub fn meaning(self) -> Option<&'static str> {}
}
