//! Causes of the end of a motion, or of its refusal.

use std::fmt;

use super::braking::Braking;
use super::consequence::Consequence;
use super::remedy::Remedy;

/// Kinds of causes, for programs that treat the causes of a kind alike.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "snake_case"))]
pub enum CauseGroup {
    /// The motion has ended as it was commanded.
    Done,
    /// The motion has ended before its target because somebody, or a guard, ended it.
    Ended,
    /// The robot does not move: a stop, power, an error of the controller.
    Robot,
    /// A connection is lost, or the controller does not answer.
    Connection,
    /// The arm did not follow, or was not seen to.
    Following,
    /// This program or its machine: a request, a limit, a late cycle.
    Program,
}

/// The word of a row, as a truth value.
macro_rules! is_status {
    (status) => {
        true
    };
    (other) => {
        false
    };
}

/// Makes the enum of the rows. A row has the variant, its name for programs, its group, its fact and its remedy; and
/// the braking of an arm that set-points lead, the consequence for motions that the controller plans, whether a packet
/// of the status port or its absence shows it, and the exit code. The order of the rows is the precedence.
macro_rules! causes {
    ($($(#[$doc:meta])* $variant:ident $name:literal $group:ident $fact:literal $remedy:ident $(($of_connection:ident))?,
        $braking:ident $consequence:ident $shown:ident $code:literal;)+) => {
        /// Cause of the end of a motion, or of its refusal.
        ///
        /// An event has the same cause in each kind of motion: planned motions, servo sessions, streams and
        /// trajectories ([`End::cause`](crate::End::cause)), and waits ([`Error::cause`](crate::Error::cause)). The end
        /// or the error carries the evidence.
        ///
        /// # Precedence
        /// An event has consequences: an arm that loses its power refuses set-points, and its controller may close
        /// connections. If several causes are known within a quarter of a second, the first in the order of the
        /// variants is reported.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[non_exhaustive]
        pub enum Cause {
            $($(#[$doc])* $variant,)+
        }

        impl Cause {
            /// All causes, by precedence.
            pub const ALL: &'static [Self] = &[$(Self::$variant,)+];

            /// Name for programs, such as `protective_stop`. Names do not change.
            pub fn name(self) -> &'static str {
                match self { $(Self::$variant => $name,)+ }
            }

            /// Group of the cause.
            pub fn group(self) -> CauseGroup {
                match self { $(Self::$variant => CauseGroup::$group,)+ }
            }

            /// Remedy for the cause.
            pub fn remedy(self) -> Remedy {
                match self { $(Self::$variant => Remedy::$remedy $((jaka_sync::Remedy::$of_connection))?,)+ }
            }

            /// Exit code of `jaka` for a motion that ends by it, which a program can use as well.
            pub const fn exit_code(self) -> u8 {
                match self { $(Self::$variant => $code,)+ }
            }

            /// Action on an arm at speed that set-points lead.
            pub(crate) fn braking(self) -> Braking {
                match self { $(Self::$variant => Braking::$braking,)+ }
            }

            /// Consequence for motions that the controller plans.
            pub(super) fn consequence(self) -> Consequence {
                match self { $(Self::$variant => Consequence::$consequence,)+ }
            }

            /// True for a state of the robot in packets, or for their absence: under a guard it is reported before the
            /// stop that the guard has sent.
            pub(crate) fn is_of_status(self) -> bool {
                match self { $(Self::$variant => is_status!($shown),)+ }
            }

            fn fact(self) -> &'static str {
                match self { $(Self::$variant => $fact,)+ }
            }
        }
    };
}

causes! {
    /// The emergency stop is pressed.
    EmergencyStop "emergency_stop" Robot "the emergency stop is pressed" ReleaseEmergencyStop,
        Leave Latched status 24;
    /// The robot is in a protective stop, as after a collision.
    ProtectiveStop "protective_stop" Robot "the robot is in a protective stop" ClearError,
        Leave Latched status 23;
    /// The robot is in drag mode: a person may have a hand on the arm.
    DragMode "drag_mode" Robot "the robot is in drag mode" LeaveDragMode,
        Land LatchedStops status 22;
    /// The connection for commands is lost: no stop can be sent on it.
    CommandsLost "commands_lost" Connection "the command connection is lost, and no stop can be sent on it" ConnectAndStop,
        Leave GoesOn other 4;
    /// The controller reports an error.
    ControllerError "controller_error" Robot "the controller reports an error" SeeController,
        Land MayMove status 26;
    /// The arm has no power.
    NotPowered "not_powered" Robot "the arm has no power" PowerUp,
        Land Over status 25;
    /// The arm is not enabled.
    NotEnabled "not_enabled" Robot "the arm is not enabled" PowerUp,
        Land Over status 25;
    /// A soft limit of the controller was hit.
    SoftLimit "soft_limit" Robot "a soft limit of the controller was hit" MoveAway,
        Land MayMove status 26;
    /// The controller does not accept commands from this client.
    NoRemoteControl "no_remote_control" Robot "the controller does not accept commands from this client" GrantRemoteControl,
        Leave MayMove status 20;
    /// The arm is in servo mode, or was to be and is not.
    ServoMode "servo_mode" Robot "servo mode is in the wrong state" SeeServoMode,
        Leave MayMove status 30;
    /// A motion continues, or the program has not waited for its end.
    Moving "moving" Program "the arm is moving, or the program has not waited for the end of a motion" WaitOrStop,
        Leave MayMove other 20;
    /// Status packets show another tool frame or user frame than at the start of a motion that depends on them.
    FramesChanged "frames_changed" Ended "another tool or user frame is selected than at the start" SelectFrames,
        Land Stops status 22;
    /// A guard has tripped.
    Guard "guard" Ended "the guard tripped" None,
        Leave MayMove other 30;
    /// This program or another client stopped it.
    Stopped "stopped" Ended "the motion was stopped before its target" LookAtArm,
        Land Over other 22;
    /// The controller does not answer commands.
    Unanswered "unanswered" Connection "the controller does not answer" Connection(CheckNetwork),
        Leave MayMove other 4;
    /// The state of the robot is unknown: no status packets come that can be read.
    StatusLost "status_lost" Connection "the state of the robot is unknown" Connection(CheckNetwork),
        Land LatchedMayMove status 28;
    /// Packets do not show a state that the program needs.
    NotShown "not_shown" Robot "status packets do not show a state that the program needs" SeeError,
        Land MayMove other 28;
    /// A limit of force cannot protect the motion: the tool could not be stopped within the overtravel, or that is not
    /// known.
    NotGuarded "not_guarded" Program "a limit of force cannot protect the motion" SeeError,
        Land MayMove other 20;
    /// It has not ended in time.
    Deadline "deadline" Ended "the motion has not ended in time" WaitOrStop,
        Leave GoesOn other 27;
    /// A set-point was due too long ago.
    SetPointLate "set_point_late" Program "a set-point was too late" UnloadMachine,
        Land MayMove other 30;
    /// A joint does not follow its set-points.
    Departed "departed" Following "a joint does not follow its set-points" FindObstacle,
        Land MayMove other 30;
    /// The controller refused a command for a reason that it does not show.
    Refused "refused" Robot "the controller refused" SeeError,
        Land MayMove other 30;
    /// The motion is beyond a limit, or cannot be compared with the limits.
    BeyondLimit "beyond_limit" Program "the motion is beyond a limit of the robot, or cannot be compared with the limits" SeeError,
        Land MayMove other 20;
    /// The arm is not at the start of the trajectory.
    NotAtStart "not_at_start" Program "the arm is not where the trajectory starts" MoveToStart,
        Land MayMove other 20;
    /// No status packet has shown the arm at rest.
    RestNotSeen "rest_not_seen" Following "the arm was not seen at rest" LookAtArm,
        Leave MayMove other 30;
    /// The request is wrong, or something on this machine.
    Failed "failed" Program "the operation failed" SeeError,
        Land MayMove other 30;
    /// There was nothing to wait for.
    NoMotion "no_motion" Done "there was nothing to wait for: no motion of this robot was accepted" None,
        Leave Over other 4;
    /// The arm is at rest, and it is not known whether it is at its target.
    AtRest "at_rest" Done "the arm is at rest, but it is not known whether it is at its target" None,
        Leave Over other 21;
    /// The program has ended set-points, and the arm was braked to rest.
    Landed "landed" Done "the set-points have ended, and the arm is at rest" None,
        Leave Over other 0;
    /// The arm is at its target.
    Reached "reached" Done "the motion has reached its target" None,
        Leave Over other 0;
}

/// Its [name](Cause::name).
#[cfg(feature = "serde")]
impl serde::Serialize for Cause {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

impl fmt::Display for Cause {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.fact())
    }
}
