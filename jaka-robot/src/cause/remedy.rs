//! What helps against causes.

use std::fmt;

jaka_proto::worded! {
    /// What somebody can do about a [`Cause`](crate::Cause) or an [`Error`](crate::Error), in the calls of this crate.
    /// A program that shows other calls matches on it.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    pub enum Remedy {
        /// Nothing has to be done.
        None => "",
        /// Release the emergency stop, and power the arm up, when nobody is at it.
        ReleaseEmergencyStop => "when nobody is at the arm, release it, then call `acknowledge` and `power_up`",
        /// Clear the protective stop, when somebody has looked at the arm.
        ClearError => "when somebody has looked at the arm, call `clear_error` and `acknowledge`",
        /// Power the arm up, when somebody has looked at it.
        PowerUp => "when somebody has looked at the arm, call `power_up`",
        /// Read the controller's error, and clear it, when somebody has looked at the arm.
        SeeController => "look up the error; when somebody has looked at the arm, call `clear_error`",
        /// Move the arm away from the limit.
        MoveAway => "move the arm away from the limit",
        /// Grant remote control on the controller's panel.
        GrantRemoteControl => "grant remote control on the controller's panel",
        /// Find out who uses servo mode.
        SeeServoMode =>
            "wait until the arm rests, and find out which program uses servo mode; `set_servo_mode` with off leaves it",
        /// Wait for the end of the motion, or stop it.
        WaitOrStop => "wait for its end, or stop it",
        /// Look at the arm before it moves again.
        LookAtArm => "look at the arm, then call `acknowledge`",
        /// Select the frames for which the motion is meant.
        SelectFrames =>
            "find out who has changed it, and select the frames for which the motion is meant (`set_tool_id`, \
             `set_user_id`)",
        /// Stop the arm with the emergency stop, or connect again and stop it.
        ConnectAndStop => "use the emergency stop, or connect again and stop the arm",
        /// Give the thread a priority, or the machine less to do.
        UnloadMachine => "give the thread a priority (`ServoConfig::realtime_priority`), or the machine less to do",
        /// Find out what holds the arm.
        FindObstacle => "find out what holds the arm",
        /// Move the arm to the start of the trajectory, or ask for an approach.
        MoveToStart => "move the arm there first, or ask for an approach (`FollowConfig::approach`)",
        /// Leave the port out of the address of a robot, or name both ports.
        LeaveOutPort => "give its address without a port, or both addresses to `Robot::connect_at`",
        /// Switch the force sensor on.
        SwitchSensorOn => "switch the sensor on (`set_torque_sensor_mode`)",
        /// Move more slowly.
        MoveMoreSlowly => "move more slowly",
        /// Move on a line or an arc towards a contact.
        MoveOnLine => "move on a line or an arc towards a contact (`move_l`, `move_c`)",
        /// Give the motion an acceleration.
        GiveAcceleration => "give the motion an acceleration",
        /// Wait for the end of all motions.
        WaitForMotions => "wait for the end of all motions first",
        /// Give an absolute target.
        GiveAbsoluteTarget => "give an absolute target",
        /// Give the robot limits.
        GiveLimits => "give the robot limits with `RobotConfig::limits`",
        /// Give the limit of force a longer reaction.
        LengthenReaction => "give the limit a reaction that is longer than the lag (`ForceLimit::reaction`)",
        /// Allow the user, or the program, real-time priorities.
        AllowRealtimePriority =>
            "set `rtprio` to that or more for the user in /etc/security/limits.conf and log in again (`ulimit -r` \
             shows it), or give the program CAP_SYS_NICE (`setcap cap_sys_nice=ep PROGRAM`; of a \
             container: `--cap-add SYS_NICE`)",
        /// That of the connection.
        Connection(remedy: jaka_sync::Remedy) => "{remedy}",
        /// The error or the end says it.
        SeeError => "see the error",
    }
}

impl Remedy {
    /// Appends it to a fact.
    pub(crate) fn append(self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::None | Self::SeeError => Ok(()),
            other => write!(f, "; {other}"),
        }
    }
}

impl From<jaka_sync::Remedy> for Remedy {
    fn from(remedy: jaka_sync::Remedy) -> Self {
        if remedy == jaka_sync::Remedy::None { Self::None } else { Self::Connection(remedy) }
    }
}
