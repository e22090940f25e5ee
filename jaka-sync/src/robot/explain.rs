//! Why a command was refused.

use std::fmt;

use jaka_proto::messages::status::RobotStatus;
use jaka_proto::{ErrorCode, Refusal, Request, Requirement};

/// Why the controller refused a command, as far as its status tells. The controller's own words are in the [`Refusal`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Explanation {
    /// The emergency stop is pressed: release it, and enable the arm.
    EmergencyStop,
    /// The robot is in a protective stop: `clear_error` leaves it.
    ProtectiveStop,
    /// The arm has no power: `power_on`.
    NotPowered,
    /// The arm is not enabled: `enable_robot`.
    NotEnabled,
    /// Servo mode is off: `servo_move`, and wait until `is_in_servomove` says that it is on.
    NotInServoMode,
    /// The controller does not take commands from here: grant remote control on its panel.
    NoRemoteControl,
}

impl Explanation {
    /// What a refusal and the robot's status together tell; nothing where neither does.
    ///
    /// [`Robot`](crate::Robot) does this for its motions. The status is the newest one after the refusal.
    pub fn of(refusal: &Refusal, status: Option<&RobotStatus>) -> Option<Self> {
        if refusal.code == ErrorCode::PERMISSION_DENIED {
            return Some(Self::NoRemoteControl);
        }
        let info = Request::COMMANDS.iter().find(|info| info.name == refusal.command)?;
        let needs = |requirement| info.requires.contains(&requirement);
        let status = status.filter(|_| needs(Requirement::Powered))?;
        let reasons = [
            (status.emergency_stop == Some(true), Self::EmergencyStop),
            (status.powered_on == Some(false), Self::NotPowered),
            (status.protective_stop == Some(true), Self::ProtectiveStop),
            (status.enabled == Some(false) && needs(Requirement::Enabled), Self::NotEnabled),
            (refusal.code == ErrorCode::REJECTED && needs(Requirement::ServoMode), Self::NotInServoMode),
        ];
        reasons.into_iter().find(|(holds, _)| *holds).map(|(_, reason)| reason)
    }
}

impl fmt::Display for Explanation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::EmergencyStop => "the emergency stop is pressed: release it, and enable the arm",
            Self::ProtectiveStop => "the robot is in a protective stop: call `clear_error`",
            Self::NotPowered => "the arm has no power: call `power_on`",
            Self::NotEnabled => "the arm is not enabled: call `enable_robot`",
            Self::NotInServoMode => "servo mode is off: call `servo_move`, and wait until it is on",
            Self::NoRemoteControl => "the controller takes no commands from here: grant remote control on its panel",
        })
    }
}
