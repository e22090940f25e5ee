//! What went wrong, told apart by what the caller can do about it.

use std::error::Error as StdError;
use std::fmt::{self, Write};
use std::io;
use std::sync::Arc;
use std::time::Duration;

use jaka_proto::check::InvalidArgument;
use jaka_proto::recording::Port;
use jaka_proto::text::VisibleWriter;
use jaka_proto::wire::DecodeError;
use jaka_proto::{NotInFirmware, Refusal};

use super::{Disconnect, Error};
use crate::{Explanation, GuardTrip, NotGuarded, NotShown, Outcome, StatusProblem};

/// What went wrong, told apart by what the caller can do about it: see [`Error::kind`].
#[derive(Debug)]
#[non_exhaustive]
pub enum ErrorKind {
    /// The spec forbids the request. Nothing was sent; correct the field that is named.
    InvalidArgument(InvalidArgument),
    /// The controller's firmware does not have the command, or a field that is given. Nothing was sent.
    ///
    /// Only where the firmware is known: see [`Client::check_firmware`](crate::Client::check_firmware).
    NotInFirmware(NotInFirmware),
    /// No connection could be made. Check the address, the cable, and whether the controller is on.
    ///
    /// A controller may refuse a second client of its command port, which serves one.
    Connect {
        /// The address given, with the port.
        address: String,
        /// Which of the ports it was to be.
        port: Port,
        /// Why not, in the system's words.
        source: io::Error,
    },
    /// The address of a robot names a port, and a robot has two: 10001 for commands and 10000 for its status. Give the address without a
    /// port, or both addresses to [`Config::connect_robot_at`](crate::Config::connect_robot_at). Nothing was connected to.
    PortInAddress {
        /// The address given.
        address: String,
    },
    /// The controller refused the command, which did not run. The connection is fine.
    Refused {
        /// The controller's own words.
        refusal: Refusal,
        /// Why, and what helps: for a motion of a [`Robot`](crate::Robot), where its status tells it.
        explanation: Option<Explanation>,
    },
    /// No reply came in time. The command may have run; read the robot's state before you go on.
    ///
    /// The connection can still be used: the reply is discarded if it comes later.
    Timeout {
        /// `cmdName` of the command.
        command: String,
        /// How long the call waited.
        after: Duration,
    },
    /// The command could not be sent in time: the controller accepts no more data, or other threads were sending. It did not run, and
    /// the connection can still be used.
    NotSentInTime {
        /// `cmdName` of the command.
        command: String,
        /// How long the call waited.
        after: Duration,
    },
    /// A later command was answered, this one was not. The command may have run; the connection is fine.
    ReplyLost {
        /// `cmdName` of the command.
        command: String,
    },
    /// The reply is not a refusal, and does not fit the spec. The command has most likely run; the connection is fine.
    ///
    /// The raw reply is kept: see [`Client::last_reply`](crate::Client::last_reply).
    UnexpectedReply {
        /// `cmdName` of the command.
        command: String,
        /// Which field does not fit.
        source: DecodeError,
    },
    /// The connection is broken for good, and each later call says so again. Connect again when the robot's state is known.
    Disconnected {
        /// Where the connection led, with the port.
        address: String,
        /// `cmdName` of the command of this call; none for a status connection.
        command: Option<String>,
        /// True if the command had been sent, at least in part, and may have run.
        sent: bool,
        /// What broke the connection.
        cause: Arc<Disconnect>,
    },
    /// Status packets came, but none in time that shows the state that was waited for.
    StateTimeout {
        /// How long the call waited.
        after: Duration,
        /// How many packets came meanwhile.
        packets: u64,
        /// What the last one says about the arm; none for a type of the user's own.
        says: Option<String>,
    },
    /// Status packets do not show what was asked of them: an input, a force, the joints. Nothing was sent; a stream or a trajectory of which packets do not show the joints any
    /// more has landed.
    NotShown {
        /// What was asked, in words.
        what: String,
        /// Why they do not show it, and what helps.
        reason: NotShown,
    },
    /// A wait for an input has ended, because the status is no longer known. Nothing was sent.
    WaitEnded {
        /// What was waited for, in words.
        what: String,
        /// Why the status is not known, and what helps.
        problem: StatusProblem,
    },
    /// A wait for an input has ended, because the command connection was lost: nothing can be sent on it any more, no stop either. Connect
    /// again when the robot's state is known.
    CommandsLost {
        /// Where the connection led, with the port.
        address: String,
        /// What was waited for, in words.
        what: String,
        /// What broke the connection.
        cause: Arc<Disconnect>,
    },
    /// A motion was not sent, because it could not be stopped within the overtravel of a limit of force, or that is not known.
    NotGuarded {
        /// `cmdName` of the motion.
        command: String,
        /// Why not, and what helps.
        reason: NotGuarded,
    },
    /// The guard of a motion has tripped.
    GuardTripped {
        /// Which condition, by which packet, and what followed.
        trip: Arc<GuardTrip>,
    },
    /// A motion under a guard failed, of which it is not known whether it runs, and the stop that followed was not accepted: the arm may move, and
    /// nobody judges the guard.
    NotStopped {
        /// What failed first.
        first: Error,
        /// Why the stop was not accepted.
        stopping: Error,
    },
    /// A motion or a set-point was not sent, because it is not known whether the robot is stopped. See to the status port, or, for a
    /// program that must do without it, [`Robot::allow_motion_without_status`](crate::Robot::allow_motion_without_status).
    StatusUnknown {
        /// Why it is not known, and what helps.
        problem: StatusProblem,
    },
    /// The robot is in a state that keeps it from doing what was asked. Nothing that moves the arm was sent.
    NotReady {
        /// Which state, and what helps.
        explanation: Explanation,
    },
    /// A motion or a set-point was not sent, because it is beyond a limit of the robot. Needs the feature `motion`.
    #[cfg(feature = "motion")]
    BeyondLimit {
        /// `cmdName` of the command.
        command: String,
        /// Which limit, by how much, and where on the way.
        beyond: jaka_motion::Beyond,
    },
    /// A motion or a set-point was not sent, because it cannot be checked against the robot's limits. Needs the feature `motion`.
    #[cfg(feature = "motion")]
    NotChecked {
        /// `cmdName` of the command.
        command: String,
        /// Why not, and what helps.
        reason: crate::Unchecked,
    },
    /// The limits are those of a model by which the controller does not compute its poses. Needs the feature `motion`.
    #[cfg(feature = "motion")]
    ModelMismatch {
        /// How far they differ.
        source: jaka_motion::FitError,
    },
    /// A trajectory was not started, because it is beyond a limit of the robot. Nothing that moves the arm was sent. Needs the feature `stream`.
    #[cfg(feature = "stream")]
    Trajectory {
        /// Which limit, and where: the way-point before, the time, the joint.
        source: jaka_motion::TrajectoryError,
    },
    /// A trajectory was not started, because the arm is not where it starts: move it there first, or set
    /// [`FollowConfig::approach`](crate::FollowConfig::approach). Nothing that moves the arm was sent. Needs the feature `stream`.
    #[cfg(feature = "stream")]
    NotAtStart {
        /// The joint that is the furthest away, 1 to 6.
        joint: usize,
        /// Where it is to be by the controller's answer, in degrees.
        at_deg: f64,
        /// Where the trajectory has it at the start, in degrees.
        start_deg: f64,
    },
    /// A joint does not follow the set-points of a stream or a trajectory, which has landed. Find out what holds it. Needs the feature `stream`.
    #[cfg(feature = "stream")]
    Departed {
        /// The joint, 1 to 6.
        joint: usize,
        /// Where a packet shows it, in degrees.
        at_deg: f64,
        /// How far that is from all its set-points of the last half second, in degrees.
        off_deg: f64,
    },
    /// A set-point of a stream or a trajectory was due too long ago: the machine was too busy for it. It has ended. Needs the feature `stream`.
    #[cfg(feature = "stream")]
    SetPointLate {
        /// How long ago.
        late: Duration,
    },
    /// The system has no thread for a stream, a trajectory or a guard, or that of the guard has ended too early. Nothing was sent.
    Thread {
        /// Why not, in the system's words.
        source: io::Error,
    },
    /// The system does not give the thread a real-time priority: allow it, or do without. Nothing was sent. Needs the feature `realtime`.
    #[cfg(feature = "realtime")]
    RealtimePriority {
        /// The priority that was asked for.
        priority: u8,
        /// Why not, in the system's words.
        source: io::Error,
    },
    /// Too many set-points of a servo session have no reply. The session has ended.
    SetPointsUnanswered {
        /// How many.
        count: usize,
        /// How long ago the oldest of them was sent.
        oldest: Duration,
    },
    /// A set-point was not sent: its servo session has ended.
    SessionEnded {
        /// Why it has ended.
        because: String,
    },
    /// No status packet came in time. The stream can still be used.
    StatusTimeout {
        /// Where the packets were to come from, with the port.
        address: String,
        /// How long the call waited.
        after: Duration,
    },
    /// A motion was not sent, because the robot has stopped or a connection was lost, and this has not been acknowledged: see
    /// [`Robot::acknowledge`](crate::Robot::acknowledge).
    NotAcknowledged {
        /// What happened.
        outcome: Outcome,
    },
    /// A stop of the program's own has ended a call that sends one step after the other, such as
    /// [`Robot::power_up`](crate::Robot::power_up): no further step was sent.
    Stopped {
        /// `cmdName` of the steps that had been accepted by then, in their order.
        accepted: Vec<String>,
        /// `cmdName` of the steps that were not sent.
        not_sent: Vec<String>,
    },
    /// Servo mode could not be left, or it is not known that it was: the arm may still be in servo mode. Where the connection is
    /// broken ([`Error::is_disconnected`]), no stop can be sent on it either.
    ServoModeNotLeft {
        /// What failed in the session before; none where only leaving did.
        first: Option<Error>,
        /// Why servo mode could not be left.
        leaving: Error,
    },
    /// A servo session has ended by a landing, but no status packet has shown the arm at rest at its last set-point; servo mode was left. The arm
    /// may not have followed: look at it before you go on.
    RestNotSeen {
        /// What ended the session; none where it was to land.
        first: Option<Error>,
        /// How long the last set-point was held.
        after: Duration,
    },
    /// A servo session has ended, and could not brake the arm to rest; servo mode was left. Look at the arm before you go on.
    NotLanded {
        /// What ended the session.
        first: Error,
        /// What ended the landing.
        landing: Error,
    },
    /// A status packet does not fit the spec. The stream can still be used, and the packet's text is kept.
    UnexpectedStatus {
        /// Which field does not fit.
        source: DecodeError,
    },
}

/// What the predicates of [`Error`] ask for.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Group {
    InvalidArgument,
    NotInFirmware,
    Connect,
    Refused,
    Timeout,
    Disconnected,
    Other,
}

/// Each kind is named in each of these, so that a new one does not compile before it is decided what it means.
impl ErrorKind {
    pub(super) fn group(&self) -> Group {
        match self {
            Self::InvalidArgument(_) => Group::InvalidArgument,
            Self::NotInFirmware(_) => Group::NotInFirmware,
            Self::Connect { .. } | Self::PortInAddress { .. } => Group::Connect,
            Self::Refused { .. } => Group::Refused,
            Self::Timeout { .. }
            | Self::NotSentInTime { .. }
            | Self::StateTimeout { .. }
            | Self::StatusTimeout { .. } => Group::Timeout,
            Self::Disconnected { .. } | Self::CommandsLost { .. } => Group::Disconnected,
            Self::ServoModeNotLeft { leaving, .. } if leaving.is_disconnected() => Group::Disconnected,
            Self::NotStopped { stopping, .. } if stopping.is_disconnected() => Group::Disconnected,
            Self::ServoModeNotLeft { .. }
            | Self::ReplyLost { .. }
            | Self::UnexpectedReply { .. }
            | Self::StatusUnknown { .. }
            | Self::NotReady { .. }
            | Self::SetPointsUnanswered { .. }
            | Self::SessionEnded { .. }
            | Self::NotAcknowledged { .. }
            | Self::Stopped { .. }
            | Self::RestNotSeen { .. }
            | Self::NotLanded { .. }
            | Self::NotShown { .. }
            | Self::WaitEnded { .. }
            | Self::NotGuarded { .. }
            | Self::GuardTripped { .. }
            | Self::NotStopped { .. }
            | Self::Thread { .. }
            | Self::UnexpectedStatus { .. } => Group::Other,
            #[cfg(feature = "motion")]
            Self::BeyondLimit { .. } | Self::NotChecked { .. } | Self::ModelMismatch { .. } => Group::Other,
            #[cfg(feature = "stream")]
            Self::Trajectory { .. } | Self::NotAtStart { .. } | Self::Departed { .. } | Self::SetPointLate { .. } => {
                Group::Other
            }
            #[cfg(feature = "realtime")]
            Self::RealtimePriority { .. } => Group::Other,
        }
    }

    pub(super) fn may_have_run(&self) -> bool {
        match self {
            Self::Timeout { .. }
            | Self::ReplyLost { .. }
            | Self::UnexpectedReply { .. }
            | Self::SetPointsUnanswered { .. }
            | Self::RestNotSeen { .. }
            | Self::NotLanded { .. }
            | Self::NotStopped { .. }
            | Self::ServoModeNotLeft { .. } => true,
            Self::Disconnected { sent, .. } => *sent,
            Self::GuardTripped { trip } => !trip.is_before_start,
            Self::InvalidArgument(_)
            | Self::NotInFirmware(_)
            | Self::Connect { .. }
            | Self::PortInAddress { .. }
            | Self::Refused { .. }
            | Self::NotSentInTime { .. }
            | Self::StateTimeout { .. }
            | Self::StatusUnknown { .. }
            | Self::NotReady { .. }
            | Self::SessionEnded { .. }
            | Self::StatusTimeout { .. }
            | Self::NotAcknowledged { .. }
            | Self::Stopped { .. }
            | Self::NotShown { .. }
            | Self::NotGuarded { .. }
            | Self::WaitEnded { .. }
            | Self::CommandsLost { .. }
            | Self::Thread { .. }
            | Self::UnexpectedStatus { .. } => false,
            #[cfg(feature = "motion")]
            Self::BeyondLimit { .. } | Self::NotChecked { .. } | Self::ModelMismatch { .. } => false,
            #[cfg(feature = "stream")]
            Self::Trajectory { .. } | Self::NotAtStart { .. } | Self::Departed { .. } | Self::SetPointLate { .. } => {
                false
            }
            #[cfg(feature = "realtime")]
            Self::RealtimePriority { .. } => false,
        }
    }

    /// The error below. Where its text is part of this one's, the error below that.
    pub(super) fn cause(&self) -> Option<&(dyn StdError + 'static)> {
        match self {
            Self::Connect { source, .. } | Self::Thread { source } => Some(source),
            Self::UnexpectedReply { source, .. } | Self::UnexpectedStatus { source } => Some(source),
            Self::Disconnected { cause, .. } | Self::CommandsLost { cause, .. } => Some(&**cause),
            Self::ServoModeNotLeft { leaving, .. } => leaving.source(),
            Self::RestNotSeen { first, .. } => first.as_ref().and_then(|first| first.source()),
            Self::NotLanded { first, .. } => first.source(),
            Self::NotStopped { first, .. } => first.source(),
            Self::StatusUnknown { problem } | Self::WaitEnded { problem, .. } => problem.source(),
            Self::NotAcknowledged { outcome } => outcome.cause(),
            #[cfg(feature = "motion")]
            Self::ModelMismatch { source } => Some(source),
            #[cfg(feature = "motion")]
            Self::BeyondLimit { .. } | Self::NotChecked { .. } => None,
            #[cfg(feature = "realtime")]
            Self::RealtimePriority { source, .. } => Some(source),
            #[cfg(feature = "stream")]
            Self::Trajectory { source } => source.source(),
            #[cfg(feature = "stream")]
            Self::NotAtStart { .. } | Self::Departed { .. } | Self::SetPointLate { .. } => None,
            Self::InvalidArgument(_)
            | Self::NotInFirmware(_)
            | Self::PortInAddress { .. }
            | Self::Refused { .. }
            | Self::Timeout { .. }
            | Self::NotSentInTime { .. }
            | Self::ReplyLost { .. }
            | Self::StateTimeout { .. }
            | Self::NotReady { .. }
            | Self::SetPointsUnanswered { .. }
            | Self::SessionEnded { .. }
            | Self::NotShown { .. }
            | Self::NotGuarded { .. }
            | Self::GuardTripped { .. }
            | Self::Stopped { .. }
            | Self::StatusTimeout { .. } => None,
        }
    }
}

impl ErrorKind {
    /// The text of an error that is about status packets, and what is judged by them.
    fn fmt_of_status(&self, f: &mut impl Write) -> fmt::Result {
        match self {
            Self::StateTimeout { after, packets, says } => {
                write!(f, "the robot was not in the expected state within {after:?} ({packets} status packets came)")?;
                says.as_ref().map_or(Ok(()), |says| write!(f, "; the last one says: {says}"))
            }
            Self::StatusUnknown { problem } => {
                write!(f, "not sent, because the state of the robot is unknown: {problem}")
            }
            Self::NotShown { what, reason } => write!(f, "it is not known whether {what}: {reason}"),
            Self::WaitEnded { what, problem } => {
                write!(f, "the wait has ended, because it is not known any more whether {what}: {problem}")
            }
            Self::CommandsLost { address, what, cause } => write!(
                f,
                "the wait has ended before {what}: the command connection to {address} was lost, and no stop can be sent on it any more{}",
                cause.seat_hint()
            ),
            Self::StatusTimeout { address, after } => write!(
                f,
                "no status packet from {address} within {after:?}; check that this is the status port, 10000, and that the controller has \
                 started"
            ),
            Self::NotGuarded { command, reason } => write!(f, "`{command}` was not sent under a guard: {reason}"),
            Self::GuardTripped { trip } => write!(f, "the guard tripped: {trip}"),
            Self::NotStopped { first, stopping } => {
                write!(f, "{first}; and the stop that followed was not accepted, so the arm may still move: {stopping}")
            }
            _ => Ok(()),
        }
    }
}

/// In one line, whatever the controller says: see [`text`](crate::proto::text).
impl fmt::Display for ErrorKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut f = VisibleWriter(f);
        match self {
            Self::InvalidArgument(invalid) => write!(f, "{invalid}"),
            Self::NotInFirmware(missing) => write!(f, "{missing}"),
            Self::Connect { address, port, source } => fmt_connect(&mut f, address, *port, source),
            Self::PortInAddress { address } => write!(
                f,
                "cannot connect to {address}: a robot has two ports, so give its address without a port, or both addresses to \
                 `Config::connect_robot_at`"
            ),
            Self::Refused { refusal, explanation: None } => write!(f, "{refusal}"),
            Self::Refused { refusal, explanation: Some(explanation) } => write!(f, "{refusal}; {explanation}"),
            Self::Timeout { command, after } => write!(f, "no reply to `{command}` within {after:?}; it may have run"),
            Self::NotSentInTime { command, after } => {
                write!(f, "`{command}` could not be sent within {after:?}; it did not run")
            }
            Self::ReplyLost { command } => {
                write!(f, "`{command}` may have run, but its reply was lost: a later command was answered")
            }
            Self::UnexpectedReply { command, .. } => {
                write!(f, "`{command}` was not refused, but its reply does not fit the spec")
            }
            Self::Disconnected { address, command: None, cause, .. } => {
                let hint =
                    if cause.is_by_controller() { "; check the network, and that the controller is on" } else { "" };
                write!(f, "the status connection to {address} is broken{hint}")
            }
            Self::Disconnected { address, command: Some(command), sent: false, cause } => {
                write!(f, "`{command}` was not sent: the connection to {address} is broken{}", cause.seat_hint())
            }
            Self::Disconnected { address, command: Some(command), cause, .. } => write!(
                f,
                "the connection to {address} broke during `{command}`, which may have run{}",
                cause.seat_hint()
            ),
            Self::ServoModeNotLeft { first, leaving } => {
                first.as_ref().map_or(Ok(()), |first| write!(f, "{first}; and "))?;
                write!(f, "servo mode may be on, because leaving it failed or was not confirmed: {leaving}")?;
                if leaving.is_disconnected() { f.write_str("; no stop can be sent on this connection") } else { Ok(()) }
            }
            Self::RestNotSeen { first, after } => {
                first.as_ref().map_or(Ok(()), |first| write!(f, "{first}; and "))?;
                write!(f, "no status packet has shown the arm at rest at its last set-point within {after:?}")
            }
            Self::NotLanded { first, landing } => write!(f, "{first}; and the arm was not braked to rest: {landing}"),
            Self::StateTimeout { .. }
            | Self::StatusTimeout { .. }
            | Self::StatusUnknown { .. }
            | Self::NotShown { .. }
            | Self::WaitEnded { .. }
            | Self::CommandsLost { .. }
            | Self::NotGuarded { .. }
            | Self::GuardTripped { .. }
            | Self::NotStopped { .. } => self.fmt_of_status(&mut f),
            Self::NotReady { explanation } => write!(f, "the robot cannot do this now: {explanation}"),
            Self::SetPointsUnanswered { count, oldest } => write!(
                f,
                "the servo session has ended without a landing: {count} set-points have no reply, and the oldest was sent {oldest:.1?} ago"
            ),
            Self::SessionEnded { because } => write!(f, "not sent, because the servo session has ended: {because}"),
            Self::NotAcknowledged { outcome } => {
                write!(f, "not sent: {outcome}; when somebody has checked the robot, call `acknowledge`")
            }
            Self::Stopped { accepted, not_sent } => {
                let (accepted, not_sent) = (named(accepted), named(not_sent));
                write!(
                    f,
                    "ended by a stop of this program (accepted before it: {accepted}; not sent: {not_sent}); when somebody has checked the \
                     robot, call `acknowledge`"
                )
            }
            Self::UnexpectedStatus { .. } => f.write_str("a status packet does not fit the spec"),
            #[cfg(feature = "stream")]
            Self::Trajectory { source } => write!(f, "the trajectory was not started: {source}"),
            #[cfg(feature = "stream")]
            Self::NotAtStart { joint, at_deg, start_deg } => fmt_not_at_start(&mut f, *joint, *at_deg, *start_deg),
            #[cfg(feature = "stream")]
            Self::Departed { joint, at_deg, off_deg } => write!(
                f,
                "joint {joint} does not follow its set-points: it is at {at_deg:.2} deg, {off_deg:.2} deg from all of the last half second"
            ),
            #[cfg(feature = "stream")]
            Self::SetPointLate { late } => {
                write!(f, "a set-point is {late:.1?} late: the machine was too busy to send it in time")
            }
            Self::Thread { .. } => f.write_str("the system has no thread for this"),
            #[cfg(feature = "realtime")]
            Self::RealtimePriority { priority, source } if source.kind() == io::ErrorKind::PermissionDenied => write!(
                f,
                "the system does not allow this thread the real-time priority {priority}: set `rtprio` to {priority} or more for the user in \
                 /etc/security/limits.conf and log in again (`ulimit -r` shows it), or give the program CAP_SYS_NICE (`setcap \
                 cap_sys_nice=ep PROGRAM`; of a container: `--cap-add SYS_NICE`)"
            ),
            #[cfg(feature = "realtime")]
            Self::RealtimePriority { priority, .. } => {
                write!(f, "this thread cannot have the real-time priority {priority}")
            }
            #[cfg(feature = "motion")]
            Self::BeyondLimit { command, beyond } => write!(f, "`{command}` was not sent: {beyond}"),
            #[cfg(feature = "motion")]
            Self::NotChecked { command, reason } => {
                write!(f, "`{command}` was not sent, because it cannot be checked against the limits: {reason}")
            }
            #[cfg(feature = "motion")]
            Self::ModelMismatch { .. } => f.write_str(
                "the limits are not those of this robot: its controller computes other poses than their model",
            ),
        }
    }
}

fn fmt_connect(f: &mut impl Write, address: &str, port: Port, source: &io::Error) -> fmt::Result {
    write!(f, "cannot connect to {address}")?;
    if port == Port::Command && source.kind() == io::ErrorKind::ConnectionRefused {
        f.write_str(
            "; check that the controller is on, and that no other client, such as the vendor's app, holds its one seat",
        )?;
    }
    Ok(())
}

/// Names of commands, in words.
fn named(commands: &[String]) -> String {
    if commands.is_empty() {
        return "nothing".to_owned();
    }
    commands.iter().map(|command| format!("`{command}`")).collect::<Vec<_>>().join(", ")
}

#[cfg(feature = "stream")]
fn fmt_not_at_start(f: &mut impl Write, joint: usize, at_deg: f64, start_deg: f64) -> fmt::Result {
    let off_deg = (start_deg - at_deg).abs();
    let digits = if off_deg < 1e-3 { 6 } else { 3 };
    write!(
        f,
        "the trajectory was not started: it starts with joint {joint} at {start_deg:.digits$} deg, and the arm has it at {at_deg:.digits$} deg, \
         {off_deg:.digits$} deg away; move the arm there first, or ask for an approach"
    )
}
