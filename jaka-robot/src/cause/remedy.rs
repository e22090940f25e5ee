//! Remedies for causes and errors.

use std::fmt;

use jaka_proto::ControllerEvent;

jaka_proto::worded! {
    /// Remedy for a [`Cause`](crate::Cause) or an [`Error`](crate::Error), in the calls of this crate. A program that
    /// shows other calls matches on it.
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
        /// Follow the vendor's table for the controller's event, and clear it after somebody has looked at the arm.
        OfEvent(event: ControllerEvent) => (of_event(*event)),
        /// Move the arm away from the limit.
        MoveAway => "when somebody has looked at the arm, move it away from the limit",
        /// Grant remote control on the controller's panel.
        GrantRemoteControl => "grant remote control on the controller's panel",
        /// Find the user of servo mode.
        SeeServoMode =>
            "wait until the arm is at rest, and find the program that uses servo mode; `set_servo_mode` with off ends servo mode",
        /// Wait for the end of the motion, or stop it.
        WaitOrStop => "wait for the end of the motion, or stop it",
        /// Stop the arm, or wait for the end of its motion, and then for its rest.
        WaitForRest =>
            "stop the arm or wait for the end of its motion, then wait for its rest (`wait_for_rest`) and try again",
        /// Look at the arm before it moves again.
        LookAtArm => "look at the arm, then call `acknowledge`",
        /// Select the frames of the motion.
        SelectFrames =>
            "find the person or program that changed it, and select the frames of the motion (`set_tool_id`, \
             `set_user_id`)",
        /// Stop the arm with the emergency stop, or connect again and stop it.
        ConnectAndStop => "use the emergency stop, or connect again and stop the arm",
        /// Give the thread a priority, or the machine less to do.
        UnloadMachine => "set a real-time priority (`ServoConfig::realtime_priority`), or reduce the load of the machine",
        /// Look for an obstacle at the arm.
        FindObstacle => "look for an obstacle at the arm",
        /// Move the arm to the start of the trajectory, or ask for an approach.
        MoveToStart => "move the arm there first, or set an approach (`FollowConfig::approach`)",
        /// Leave the port out of the address of a robot, or name both ports.
        LeaveOutPort => "give its address without a port, or both addresses to `Robot::connect_at`",
        /// Switch the force sensor on.
        SwitchSensorOn => "switch the sensor on (`set_torque_sensor_mode`)",
        /// Move more slowly.
        MoveMoreSlowly => "move more slowly",
        /// Move on a line or an arc towards a contact.
        MoveOnLine => "move on a line or an arc towards a contact (`move_l`, `move_c`)",
        /// Give the motion an acceleration.
        GiveAcceleration => "set an acceleration of the motion",
        /// Wait for the end of all motions.
        WaitForMotions => "wait for the end of all motions first",
        /// Give an absolute target.
        GiveAbsoluteTarget => "give an absolute target",
        /// Give the robot limits.
        GiveLimits => "give the robot limits with `RobotConfig::limits`",
        /// Give the limit of force a longer reaction.
        LengthenReaction => "set a reaction longer than the lag (`ForceLimit::reaction`)",
        /// Allow the user, or the program, real-time priorities.
        AllowRealtimePriority =>
            "set `rtprio` to that or more for the user in /etc/security/limits.conf and log in again (`ulimit -r` \
             shows it), or give the program CAP_SYS_NICE (`setcap cap_sys_nice=ep PROGRAM`; of a \
             container: `--cap-add SYS_NICE`)",
        /// Remedy for an error of the connection.
        Connection(remedy: jaka_sync::Remedy) => "{remedy}",
        /// The error or the end says it.
        SeeError => "see the error",
    }
}

/// Remedy of an event, before its error is cleared.
fn of_event(event: ControllerEvent) -> String {
    let Some(remedy) = event.remedy() else { return Remedy::SeeController.to_string() };
    format!("{remedy}; when the cause is gone and somebody has looked at the arm, call `clear_error`")
}

impl Remedy {
    /// Remedy for an error that the controller reports by an event; none of the table's for a code that it does not
    /// have.
    pub(crate) fn for_event(event: Option<ControllerEvent>) -> Self {
        event.filter(|event| event.remedy().is_some()).map_or(Self::SeeController, Self::OfEvent)
    }

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

#[cfg(test)]
mod tests {
    use super::*;

    fn event(code: u32) -> ControllerEvent {
        ControllerEvent::new(code).expect("the code is not zero")
    }

    #[test]
    fn the_remedy_of_an_event_clears_its_error_after_a_look_at_the_arm() {
        let texts = (1..0x200_0000).map(event).filter_map(|event| {
            let remedy = Remedy::for_event(Some(event));
            (remedy != Remedy::SeeController).then(|| remedy.to_string())
        });
        let mut count = 0;
        for text in texts {
            let (before, _) = text.split_once("`clear_error`").expect("the error is cleared at last");
            assert!(before.ends_with("when the cause is gone and somebody has looked at the arm, call "), "{text}");
            count += 1;
        }
        assert_eq!(count, 894);
    }

    #[test]
    fn an_event_of_no_table_has_the_remedy_of_an_error() {
        assert_eq!(Remedy::for_event(None), Remedy::SeeController);
        assert_eq!(Remedy::for_event(Some(event(0x0F_9999))), Remedy::SeeController);
    }
}
