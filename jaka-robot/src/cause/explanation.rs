//! Reasons of refusals.

use jaka_proto::messages::status::RobotStatus;
use jaka_proto::{ControllerEvent, ErrorCode, Refusal, Request, Requirement, Severity};

use super::remedy::Remedy;
use super::table::Cause;

jaka_proto::worded! {
    /// Reason why the controller refused a command, as far as its status shows it. The controller's own message is in
    /// the [`Refusal`].
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub enum Explanation {
        /// The emergency stop is pressed: release it, and enable the arm.
        EmergencyStop => "the emergency stop is pressed",
        /// The robot is in a protective stop: call `clear_error`.
        ProtectiveStop => "the robot is in a protective stop",
        /// The robot is in drag mode: end it when nobody has a hand on the arm.
        DragMode => "the robot is in drag mode",
        /// The arm has no power: call `power_on`.
        NotPowered => "the arm has no power",
        /// The arm is not enabled: call `enable_robot`.
        NotEnabled => "the arm is not enabled",
        /// Servo mode is off: call `set_servo_mode`, and wait until `is_in_servomove` says that it is on.
        NotInServoMode => "servo mode is in the wrong state: it is off",
        /// The controller does not accept commands from this client: grant remote control on its panel.
        NoRemoteControl =>
            "the controller does not accept commands from this client",
        /// The arm is moving, or a motion has not been waited for: wait for its end, or stop it.
        Moving => "the arm is moving, or the program has not waited for the end of a motion",
        /// Servo mode is on already: another program may send set-points, or a session of this one that was forgotten.
        /// If it is left over, call `set_servo_mode` with off.
        ServoModeOn =>
            "servo mode is in the wrong state: it is on already, perhaps with set-points of another program or session",
        /// The controller acknowledged servo mode but did not enter it, which happens while the arm moves.
        ServoModeNotEntered =>
            "servo mode is in the wrong state: the controller acknowledged it but did not enter it, for example because the arm moved",
        /// The controller acknowledged the end of servo mode but is still in it.
        ServoModeNotLeft => "servo mode is in the wrong state: the controller acknowledged its end but is still in it",
        /// The controller reports an error event, which ends servo mode, or may keep the arm from moving.
        Event(event: ControllerEvent) => "the controller reports an error: {event}",
        /// A soft limit of the controller was hit (`on_soft_limit` of the status): move away from it.
        SoftLimit => "a soft limit of the controller was hit",
    }
}

impl Explanation {
    /// Cause that it shows.
    pub fn cause(&self) -> Cause {
        match self {
            Self::EmergencyStop => Cause::EmergencyStop,
            Self::ProtectiveStop => Cause::ProtectiveStop,
            Self::DragMode => Cause::DragMode,
            Self::NotPowered => Cause::NotPowered,
            Self::NotEnabled => Cause::NotEnabled,
            Self::NotInServoMode | Self::ServoModeOn | Self::ServoModeNotEntered | Self::ServoModeNotLeft => {
                Cause::ServoMode
            }
            Self::NoRemoteControl => Cause::NoRemoteControl,
            Self::Moving => Cause::Moving,
            Self::Event(_) => Cause::ControllerError,
            Self::SoftLimit => Cause::SoftLimit,
        }
    }

    /// Remedy: the cause's, or the one of the controller's event.
    pub fn remedy(&self) -> Remedy {
        match self {
            Self::Event(event) => Remedy::for_event(Some(*event)),
            other => other.cause().remedy(),
        }
    }

    /// Explains a refusal by the refusal itself and by the robot's status; `None` if neither shows the reason.
    ///
    /// [`Robot`](crate::Robot) does this for its motions. The status is the newest one after the refusal.
    pub fn of(refusal: &Refusal, status: Option<&RobotStatus>) -> Option<Self> {
        if refusal.code == ErrorCode::PERMISSION_DENIED {
            return Some(Self::NoRemoteControl);
        }
        let info = Request::COMMANDS.iter().find(|info| info.name == refusal.command)?;
        let needs = |requirement| info.requires.contains(&requirement);
        let status = status.filter(|_| needs(Requirement::Powered))?;
        // An error of a drive ends servo mode.
        let event = status.event().ok().flatten().filter(|event| event.severity() == Severity::Error);
        let reasons = [
            (status.emergency_stop == Some(true)).then_some(Self::EmergencyStop),
            (status.powered_on == Some(false)).then_some(Self::NotPowered),
            (status.protective_stop == Some(true)).then_some(Self::ProtectiveStop),
            (status.drag_status == Some(true)).then_some(Self::DragMode),
            (status.enabled == Some(false) && needs(Requirement::Enabled)).then_some(Self::NotEnabled),
            event.map(Self::Event),
            (refusal.code == ErrorCode::REJECTED && needs(Requirement::ServoMode)).then_some(Self::NotInServoMode),
            (status.on_soft_limit == Some(1)).then_some(Self::SoftLimit),
        ];
        reasons.into_iter().flatten().next()
    }
}
