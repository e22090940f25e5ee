//! What went wrong, told apart by what the caller can do about it.

use std::error::Error as StdError;
use std::io;
use std::sync::Arc;
use std::time::Duration;

use jaka_proto::check::InvalidArgument;
use jaka_proto::recording::Port;
use jaka_proto::wire::DecodeError;
use jaka_proto::{NotInFirmware, Refusal};

use super::Error;
use super::end::{End, Phase};
use super::line::{Line, STOP_NOT_ACCEPTED, Sequence, with_fact};
#[cfg(feature = "stream")]
use crate::Evidence;
use crate::{Cause, Disconnect, Explanation, GuardTrip, NotGuarded, NotShown, Occurrence, Remedy, StatusProblem};

jaka_proto::worded! {
    /// What went wrong, told apart by what the caller can do about it: see [`Error::kind`].
    #[derive(Debug)]
    #[non_exhaustive]
    pub enum ErrorKind {
        /// The spec forbids the request. Nothing was sent; correct the field that is named.
        InvalidArgument(invalid: InvalidArgument) => "{invalid}",
        /// An option of this crate does not take the value that it was given. Nothing that moves the arm was sent; correct
        /// the option.
        InvalidOption {
            /// Name of the option, such as `step_count`.
            option: &'static str,
            /// Type that has the option, such as `ServoConfig`.
            of: &'static str,
            /// Value that was given.
            value: String,
            /// Values that the option takes, in words.
            expected: String,
        } => "option `{option}` of `{of}` is {value}, expected {expected}",
        /// The controller's firmware does not have the command, or a field that is given. Nothing was sent.
        ///
        /// Only where the firmware is known: see [`Client::check_firmware`](crate::Client::check_firmware).
        NotInFirmware(missing: NotInFirmware) => "{missing}",
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
        } => "cannot connect to {address}",
        /// The address of a robot names a port, and a robot has two: 10001 for commands and 10000 for its status. Give the address without a
        /// port, or both addresses to [`Robot::connect_at`](crate::Robot::connect_at). Nothing was connected to.
        PortInAddress {
            /// The address given.
            address: String,
        } =>
            "cannot connect to {address}: the address has a port, but a robot has two",
        /// The controller refused the command, which did not run. The connection is fine.
        Refused {
            /// The controller's own words.
            refusal: Refusal,
            /// Why: for a motion of a [`Robot`](crate::Robot), where its status tells it.
            explanation: Option<Explanation>,
        } => (refused(refusal, explanation.as_ref())),
        /// No reply came in time. The command may have run; read the robot's state before you go on.
        ///
        /// The connection can still be used: the reply is discarded if it comes later.
        Timeout {
            /// `cmdName` of the command.
            command: String,
            /// How long the call waited.
            after: Duration,
        } => "no reply to `{command}` within {after:?}; it may have run",
        /// The command could not be sent in time: the controller accepts no more data, or other threads were sending. It did not run, and
        /// the connection can still be used.
        NotSentInTime {
            /// `cmdName` of the command.
            command: String,
            /// How long the call waited.
            after: Duration,
        } => "`{command}` could not be sent within {after:?}; it did not run",
        /// A later command was answered, this one was not. The command may have run; the connection is fine.
        ReplyLost {
            /// `cmdName` of the command.
            command: String,
        } => "`{command}` may have run, but its reply was lost: a later command was answered",
        /// The reply is not a refusal, and does not fit the spec. The command has most likely run; the connection is fine.
        ///
        /// The raw reply is kept: see [`Client::last_reply`](crate::Client::last_reply).
        UnexpectedReply {
            /// `cmdName` of the command.
            command: String,
            /// Which field does not fit.
            source: DecodeError,
        } => "`{command}` was not refused, but its reply does not fit the spec",
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
        } => (disconnected(address, command.as_deref(), *sent, cause)),
        /// Status packets came, but none in time that shows the state that was waited for.
        StateTimeout {
            /// How long the call waited.
            after: Duration,
            /// How many packets came meanwhile.
            packets: u64,
            /// What the last one says about the arm; none for a type of the user's own.
            says: Option<String>,
        } => (not_in_state(*after, *packets, says.as_deref())),
        /// Status packets do not show what was asked of them: an input, a force, the joints. Nothing was sent; a stream or a trajectory of which packets do not show the joints any
        /// more has landed.
        NotShown {
            /// What was asked, in words.
            what: String,
            /// Why they do not show it.
            reason: NotShown,
        } => "it is not known whether {what}: {reason}",
        /// A wait for an input has ended, because the status is no longer known. Nothing was sent.
        WaitEnded {
            /// What was waited for, in words.
            what: String,
            /// Why the status is not known.
            problem: StatusProblem,
        } => (wait_ended(what, problem)),
        /// A wait for an input has ended, because the robot has stopped meanwhile, or was stopped. Nothing was sent.
        WaitBroken {
            /// What was waited for, in words.
            what: String,
            /// What happened.
            occurrence: Occurrence,
        } => "the wait has ended before {what}: {occurrence}",
        /// A wait for an input has ended, because the command connection was lost: nothing can be sent on it any more, no stop either. Connect
        /// again when the robot's state is known.
        CommandsLost {
            /// Where the connection led, with the port.
            address: String,
            /// What was waited for, in words.
            what: String,
            /// What broke the connection.
            cause: Arc<Disconnect>,
        } => (commands_lost(address, what, cause)),
        /// A motion was not sent, because it could not be stopped within the overtravel of a limit of force, or that is not known.
        NotGuarded {
            /// `cmdName` of the motion.
            command: String,
            /// Why not.
            reason: NotGuarded,
        } => "`{command}` was not sent under a guard: {reason}",
        /// A motion, a landing or a trajectory has not ended as it was commanded: see [`End::reached`].
        NotReached {
            /// The end, with what led to it.
            end: Box<End>,
        } => "{end}",
        /// The guard of a motion has tripped.
        GuardTripped {
            /// Which condition, by which packet, and what followed.
            trip: Arc<GuardTrip>,
        } => (with_fact(trip.cause(), trip.to_string())),
        /// A motion under a guard failed, of which it is not known whether it runs, and the stop that followed was not accepted: the arm may move, and
        /// nobody judges the guard.
        NotStopped {
            /// What failed first.
            first: Error,
            /// Why the stop was not accepted.
            stopping: Error,
        } => (Sequence::new(first, stopping).line(STOP_NOT_ACCEPTED)),
        /// A motion or a set-point was not sent, because it is not known whether the robot is stopped. See to the status port, or, for a
        /// program that must do without it, [`Robot::allow_motion_without_status`](crate::Robot::allow_motion_without_status).
        StatusUnknown {
            /// Why it is not known.
            problem: StatusProblem,
        } => "not sent, because the state of the robot is unknown: {problem}",
        /// The robot is in a state that keeps it from doing what was asked. Nothing that moves the arm was sent.
        NotReady {
            /// Which state.
            explanation: Explanation,
        } => "the robot cannot do this now: {explanation}",
        /// A motion or a set-point was not sent, because it is beyond a limit of the robot. Needs the feature `motion`.
        #[cfg(feature = "motion")]
        BeyondLimit {
            /// `cmdName` of the command.
            command: String,
            /// Which limit, by how much, and where on the way.
            beyond: jaka_motion::Beyond,
        } => "`{command}` was not sent: {beyond}",
        /// A motion or a set-point was not sent, because it cannot be checked against the robot's limits. Needs the feature `motion`.
        #[cfg(feature = "motion")]
        NotChecked {
            /// `cmdName` of the command.
            command: String,
            /// Why not.
            reason: crate::Unchecked,
        } => "`{command}` was not sent, because it cannot be checked against the limits: {reason}",
        /// The limits are those of a model by which the controller does not compute its poses. Needs the feature `motion`.
        #[cfg(feature = "motion")]
        ModelMismatch {
            /// How far they differ.
            source: jaka_motion::FitError,
        } => "the limits are not those of this robot: its controller computes other poses than their model",
        /// A trajectory was not started, because it is beyond a limit of the robot. Nothing that moves the arm was sent. Needs the feature `stream`.
        #[cfg(feature = "stream")]
        Trajectory {
            /// Which limit, and where: the way-point before, the time, the joint.
            source: jaka_motion::TrajectoryError,
        } => "the trajectory was not started: {source}",
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
        } => (not_at_start(*joint, *at_deg, *start_deg)),
        /// A joint does not follow the set-points of a stream or a trajectory, which has landed. Find out what holds it. Needs the feature `stream`.
        #[cfg(feature = "stream")]
        Departed {
            /// The joint, 1 to 6.
            joint: usize,
            /// Where a packet shows it, in degrees.
            at_deg: f64,
            /// How far that is from all its set-points of the last half second, in degrees.
            off_deg: f64,
        } =>
            "a joint does not follow its set-points: joint {joint} is at {at_deg:.2} deg, {off_deg:.2} deg from all of \
             the last half second",
        /// A set-point of a servo session, a stream or a trajectory was due too long ago, because the machine was too
        /// busy: it was not sent, and the session has ended without set-points that brake. Give the thread a priority
        /// (`ServoConfig::realtime_priority`), or the machine less to do.
        SetPointLate {
            /// Time since it was due.
            late: Duration,
        } => "a set-point was too late, by {late:.1?}: the machine was too busy to send it in time",
        /// The system has no thread for a stream, a trajectory or a guard, or that of the guard has ended too early. Nothing was sent.
        Thread {
            /// Why not, in the system's words.
            source: io::Error,
        } => "the system has no thread for this",
        /// The system does not give the thread a real-time priority: allow it, or do without. Nothing was sent. Needs the feature `realtime`.
        #[cfg(feature = "realtime")]
        RealtimePriority {
            /// The priority that was asked for.
            priority: u8,
            /// Why not, in the system's words.
            source: io::Error,
        } => (no_priority(*priority, source)),
        /// Too many set-points of a servo session have no reply. The session has ended.
        SetPointsUnanswered {
            /// How many.
            count: usize,
            /// How long ago the oldest of them was sent.
            oldest: Duration,
        } =>
            "the controller does not answer: {count} set-points have no reply, and the oldest was sent {oldest:.1?} ago; the \
             servo session has ended without a landing",
        /// A set-point was not sent: its servo session has ended.
        SessionEnded {
            /// Cause of its end.
            cause: Cause,
            /// Why it has ended.
            because: String,
            /// Remedy for what has ended it.
            remedy: Remedy,
        } => "not sent, because the servo session has ended: {because}",
        /// No status packet came in time. The stream can still be used.
        StatusTimeout {
            /// Where the packets were to come from, with the port.
            address: String,
            /// How long the call waited.
            after: Duration,
        } =>
            "no status packet from {address} within {after:?}",
        /// A motion was not sent, because the robot has stopped or a connection was lost, and this has not been acknowledged: see
        /// [`Robot::acknowledge`](crate::Robot::acknowledge).
        NotAcknowledged {
            /// What happened.
            occurrence: Occurrence,
        } => "not sent: {occurrence}",
        /// A stop of the program's own has ended a call that sends one step after the other, such as
        /// [`Robot::power_up`](crate::Robot::power_up): no further step was sent.
        Stopped {
            /// `cmdName` of the steps that had been accepted by then, in their order.
            accepted: Vec<String>,
            /// `cmdName` of the steps that were not sent.
            not_sent: Vec<String>,
        } => (stopped(&named(accepted), &named(not_sent))),
        /// Servo mode could not be left, or it is not known that it was: the arm may still be in servo mode. Where the connection is
        /// broken ([`Error::is_disconnected`]), no stop can be sent on it either.
        ServoModeNotLeft {
            /// What failed in the session before; none where only leaving did.
            first: Option<Error>,
            /// Why servo mode could not be left.
            leaving: Error,
        } => (Sequence::new(first.as_ref(), leaving).line(not_left(leaving))),
        /// A servo session has ended by a landing, but no status packet has shown the arm at rest at its last set-point; servo mode was left. The arm
        /// may not have followed: look at it before you go on.
        RestNotSeen {
            /// What ended the session; none where it was to land.
            first: Option<Error>,
            /// How long the last set-point was held.
            after: Duration,
        } => (rest_not_seen(first.as_ref(), *after)),
        /// A servo session has ended, and could not brake the arm to rest; servo mode was left. Look at the arm before you go on.
        NotLanded {
            /// What ended the session.
            first: Error,
            /// What ended the landing.
            landing: Error,
        } => (Sequence::new(first, landing).line("the arm was not braked to rest")),
        /// A status packet does not fit the spec. The stream can still be used, and the packet's text is kept.
        UnexpectedStatus {
            /// Which field does not fit.
            source: DecodeError,
        } => "a status packet does not fit the spec",
    }
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

/// What a kind means: what it is to the predicates, whether the command may have run, and the error below it; where the text of that is part
/// of its own, the error below that.
pub(super) type Meaning<'k> = (Group, bool, Option<&'k (dyn StdError + 'static)>);

impl ErrorKind {
    /// Cause of the end of moving, or why it is kept back; of several errors in one, the first by precedence.
    pub(super) fn cause(&self) -> Cause {
        match self {
            Self::Refused { explanation: Some(explanation), .. } | Self::NotReady { explanation } => {
                explanation.cause()
            }
            Self::Refused { explanation: None, .. } => Cause::Refused,
            Self::Timeout { .. }
            | Self::NotSentInTime { .. }
            | Self::ReplyLost { .. }
            | Self::UnexpectedReply { .. }
            | Self::SetPointsUnanswered { .. } => Cause::Unanswered,
            // Reset here, because set-points were not answered.
            Self::Disconnected { cause, .. } if matches!(**cause, Disconnect::Reset { .. }) => Cause::Unanswered,
            Self::Disconnected { command: Some(_), .. } | Self::CommandsLost { .. } => Cause::CommandsLost,
            Self::WaitBroken { occurrence, .. } => occurrence.cause,
            Self::NotReached { end } => end.cause(),
            Self::Disconnected { command: None, .. }
            | Self::WaitEnded { .. }
            | Self::StatusUnknown { .. }
            | Self::StatusTimeout { .. }
            | Self::UnexpectedStatus { .. } => Cause::StatusLost,
            Self::NotShown { .. } | Self::NotGuarded { .. } => Cause::NotShown,
            Self::GuardTripped { trip } => trip.cause(),
            Self::NotStopped { first, stopping } => Sequence::new(first, stopping).cause(),
            Self::SetPointLate { .. } => Cause::SetPointLate,
            Self::SessionEnded { cause, .. } => *cause,
            Self::NotAcknowledged { occurrence } => occurrence.cause,
            Self::Stopped { .. } => Cause::Stopped,
            Self::StateTimeout { .. } => Cause::Deadline,
            Self::ServoModeNotLeft { first, leaving } => Sequence::new(first.as_ref(), leaving).cause(),
            Self::RestNotSeen { first, .. } => first.as_ref().map_or(Cause::RestNotSeen, Error::cause),
            Self::NotLanded { first, landing } => Sequence::new(first, landing).cause(),
            Self::InvalidArgument(_)
            | Self::InvalidOption { .. }
            | Self::NotInFirmware(_)
            | Self::Connect { .. }
            | Self::PortInAddress { .. }
            | Self::Thread { .. } => Cause::Failed,
            #[cfg(feature = "motion")]
            Self::BeyondLimit { .. } | Self::NotChecked { .. } => Cause::BeyondLimit,
            #[cfg(feature = "motion")]
            Self::ModelMismatch { .. } => Cause::Failed,
            #[cfg(feature = "stream")]
            Self::Trajectory { .. } => Cause::BeyondLimit,
            #[cfg(feature = "stream")]
            Self::NotAtStart { .. } => Cause::NotAtStart,
            #[cfg(feature = "stream")]
            Self::Departed { .. } => Cause::Departed,
            #[cfg(feature = "realtime")]
            Self::RealtimePriority { .. } => Cause::Failed,
        }
    }

    /// Causes of all events that it tells.
    pub(super) fn causes(&self) -> Vec<Cause> {
        match self {
            Self::NotStopped { first, stopping } => Sequence::new(first, stopping).causes(),
            Self::ServoModeNotLeft { first, leaving } => Sequence::new(first.as_ref(), leaving).causes(),
            Self::NotLanded { first, landing } => Sequence::new(first, landing).causes(),
            Self::RestNotSeen { first: Some(first), .. } => {
                first.kind().causes().into_iter().chain([Cause::RestNotSeen]).collect()
            }
            _ => vec![self.cause()],
        }
    }

    /// Event, beginning with the fact of its cause: for texts that say themselves what was not sent because of it.
    pub(super) fn event(&self) -> String {
        let text = match self {
            Self::NotAcknowledged { occurrence } => occurrence.to_string(),
            Self::NotReady { explanation } => explanation.to_string(),
            Self::StatusUnknown { problem } => problem.to_string(),
            Self::Refused { refusal, .. } => refusal.to_string(),
            kind => kind.to_string(),
        };
        with_fact(self.cause(), text)
    }

    /// Evidence for the cause, besides the error.
    #[cfg(feature = "stream")]
    pub(super) fn evidence(&self) -> Evidence {
        match self {
            Self::NotAcknowledged { occurrence } | Self::WaitBroken { occurrence, .. } => occurrence.evidence.clone(),
            Self::GuardTripped { trip } => Evidence::Trip(Arc::clone(trip)),
            Self::NotReached { end } => end.evidence().clone(),
            Self::Disconnected { address, command: Some(_), cause, .. } => {
                Evidence::Commands { address: address.clone(), cause: Arc::clone(cause) }
            }
            Self::RestNotSeen { first: Some(first), .. }
            | Self::NotLanded { first, .. }
            | Self::ServoModeNotLeft { first: Some(first), .. }
            | Self::NotStopped { first, .. } => first.kind().evidence(),
            _ => Evidence::None,
        }
    }

    /// Remedy. Each kind is named, so that a new one does not compile before it is decided.
    pub(super) fn remedy(&self) -> Remedy {
        match self {
            Self::NotReached { end } => end.remedy(),
            Self::GuardTripped { trip } => trip.remedy(),
            Self::NotAcknowledged { occurrence } | Self::WaitBroken { occurrence, .. } => occurrence.remedy(),
            Self::StatusUnknown { problem } | Self::WaitEnded { problem, .. } => problem.remedy(),
            Self::NotShown { reason, .. } => reason.remedy(),
            Self::NotGuarded { reason, .. } => reason.remedy(),
            Self::SessionEnded { remedy, .. } => *remedy,
            Self::NotStopped { first, stopping } => Sequence::new(first, stopping).remedy(),
            Self::ServoModeNotLeft { first, leaving } => Sequence::new(first.as_ref(), leaving).remedy(),
            Self::NotLanded { first, landing } => Sequence::new(first, landing).remedy(),
            Self::RestNotSeen { first: Some(first), .. } => first.remedy_of_event(),
            Self::Refused { .. }
            | Self::NotReady { .. }
            | Self::CommandsLost { .. }
            | Self::SetPointLate { .. }
            | Self::SetPointsUnanswered { .. }
            | Self::Stopped { .. }
            | Self::RestNotSeen { first: None, .. } => self.cause().remedy(),
            Self::Connect { port: Port::Command, source, .. } if source.kind() == io::ErrorKind::ConnectionRefused => {
                Remedy::FreeSeat
            }
            Self::PortInAddress { .. } => Remedy::LeaveOutPort,
            Self::StatusTimeout { .. } => Remedy::CheckStatusPort,
            Self::Disconnected { command: None, cause, .. } if cause.is_by_controller() => Remedy::CheckNetwork,
            // The fact says all that is known, also where no motion is concerned.
            Self::InvalidArgument(_)
            | Self::InvalidOption { .. }
            | Self::NotInFirmware(_)
            | Self::Connect { .. }
            | Self::Timeout { .. }
            | Self::NotSentInTime { .. }
            | Self::ReplyLost { .. }
            | Self::UnexpectedReply { .. }
            | Self::Disconnected { .. }
            | Self::StateTimeout { .. }
            | Self::Thread { .. }
            | Self::UnexpectedStatus { .. } => Remedy::None,
            #[cfg(feature = "motion")]
            Self::NotChecked { reason, .. } => reason.remedy(),
            #[cfg(feature = "motion")]
            Self::BeyondLimit { .. } | Self::ModelMismatch { .. } => Remedy::None,
            #[cfg(feature = "stream")]
            Self::Departed { .. } | Self::NotAtStart { .. } => self.cause().remedy(),
            #[cfg(feature = "stream")]
            Self::Trajectory { .. } => Remedy::None,
            #[cfg(feature = "realtime")]
            Self::RealtimePriority { source, .. } if source.kind() == io::ErrorKind::PermissionDenied => {
                Remedy::AllowRealtimePriority
            }
            #[cfg(feature = "realtime")]
            Self::RealtimePriority { .. } => Remedy::None,
        }
    }

    /// Each kind is named, so that a new one does not compile before it is decided what it means.
    pub(super) fn meaning(&self) -> Meaning<'_> {
        match self {
            Self::InvalidArgument(_) | Self::InvalidOption { .. } => (Group::InvalidArgument, false, None),
            Self::NotInFirmware(_) => (Group::NotInFirmware, false, None),
            Self::Connect { source, .. } => (Group::Connect, false, Some(source)),
            Self::PortInAddress { .. } => (Group::Connect, false, None),
            Self::Refused { .. } => (Group::Refused, false, None),
            Self::Timeout { .. } => (Group::Timeout, true, None),
            Self::NotSentInTime { .. } | Self::StateTimeout { .. } | Self::StatusTimeout { .. } => {
                (Group::Timeout, false, None)
            }
            Self::Disconnected { sent, cause, .. } => (Group::Disconnected, *sent, Some(&**cause)),
            Self::CommandsLost { cause, .. } => (Group::Disconnected, false, Some(&**cause)),
            Self::ServoModeNotLeft { first, leaving } => {
                (Group::after(leaving), true, Sequence::new(first.as_ref(), leaving).source())
            }
            Self::NotStopped { first, stopping } => {
                (Group::after(stopping), true, Sequence::new(first, stopping).source())
            }
            Self::ReplyLost { .. } | Self::SetPointsUnanswered { .. } => (Group::Other, true, None),
            Self::UnexpectedReply { source, .. } => (Group::Other, true, Some(source)),
            Self::RestNotSeen { first, .. } => (Group::Other, true, first.as_ref().and_then(|first| first.source())),
            Self::NotLanded { first, landing } => (Group::Other, true, Sequence::new(first, landing).source()),
            Self::GuardTripped { trip } => (Group::Other, !trip.is_before_start, None),
            Self::StatusUnknown { problem } | Self::WaitEnded { problem, .. } => {
                (Group::Other, false, problem.source())
            }
            Self::NotAcknowledged { occurrence } | Self::WaitBroken { occurrence, .. } => {
                (Group::Other, false, occurrence.source())
            }
            Self::NotReached { end } => (Group::of(end.cause()), end.phase() != Phase::NotSent, end.source()),
            Self::Thread { source } => (Group::Other, false, Some(source)),
            Self::UnexpectedStatus { source } => (Group::Other, false, Some(source)),
            Self::NotReady { .. }
            | Self::SetPointLate { .. }
            | Self::SessionEnded { .. }
            | Self::NotShown { .. }
            | Self::NotGuarded { .. }
            | Self::Stopped { .. } => (Group::Other, false, None),
            #[cfg(feature = "motion")]
            Self::BeyondLimit { .. } | Self::NotChecked { .. } => (Group::Other, false, None),
            #[cfg(feature = "motion")]
            Self::ModelMismatch { source } => (Group::Other, false, Some(source)),
            #[cfg(feature = "stream")]
            Self::Trajectory { source } => (Group::Other, false, source.source()),
            #[cfg(feature = "stream")]
            Self::NotAtStart { .. } | Self::Departed { .. } => (Group::Other, false, None),
            #[cfg(feature = "realtime")]
            Self::RealtimePriority { source, .. } => (Group::Other, false, Some(source)),
        }
    }
}

impl Group {
    /// Group of an end by this cause.
    fn of(cause: Cause) -> Self {
        if cause == Cause::CommandsLost { Self::Disconnected } else { Self::Other }
    }

    /// That of an error that tells of another one after which nothing more could be sent.
    fn after(last: &Error) -> Self {
        if last.is_disconnected() { Self::Disconnected } else { Self::Other }
    }
}

fn refused(refusal: &Refusal, explanation: Option<&Explanation>) -> String {
    explanation.map_or_else(|| refusal.to_string(), |explanation| format!("{refusal}; {explanation}"))
}

fn disconnected(address: &str, command: Option<&str>, sent: bool, cause: &Disconnect) -> String {
    let hint = cause.seat_hint();
    match command {
        None => format!("the status connection to {address} is broken"),
        Some(command) if sent => {
            format!("the connection to {address} broke during `{command}`, which may have run{hint}")
        }
        Some(command) => format!("`{command}` was not sent: the connection to {address} is broken{hint}"),
    }
}

fn not_in_state(after: Duration, packets: u64, says: Option<&str>) -> String {
    let says = says.map_or_else(String::new, |says| format!("; the last one says: {says}"));
    format!("the robot was not in the expected state within {after:?} ({packets} status packets came){says}")
}

fn commands_lost(address: &str, what: &str, cause: &Disconnect) -> String {
    format!("the wait has ended before {what}: {} ({address}{})", Cause::CommandsLost, cause.seat_hint())
}

fn wait_ended(what: &str, problem: &StatusProblem) -> String {
    format!("the wait has ended before {what}, because {}: {problem}", Cause::StatusLost)
}

fn not_left(leaving: &Error) -> &'static str {
    // Where the command connection is lost, the fact says that no stop can be sent.
    if leaving.is_disconnected() && leaving.cause() != Cause::CommandsLost {
        "servo mode may be on, because leaving it failed or was not confirmed, and no stop can be sent on this \
         connection"
    } else {
        "servo mode may be on, because leaving it failed or was not confirmed"
    }
}

fn rest_not_seen(first: Option<&Error>, after: Duration) -> String {
    let what = format!("{} at its last set-point within {after:?}", Cause::RestNotSeen);
    Line::of_error(first).followed_by(&what, None).into_text()
}

fn stopped(accepted: &str, not_sent: &str) -> String {
    format!("ended by a stop of this program (accepted before it: {accepted}; not sent: {not_sent})")
}

/// Names of commands, in words.
fn named(commands: &[String]) -> String {
    if commands.is_empty() {
        return "nothing".to_owned();
    }
    commands.iter().map(|command| format!("`{command}`")).collect::<Vec<_>>().join(", ")
}

#[cfg(feature = "stream")]
fn not_at_start(joint: usize, at_deg: f64, start_deg: f64) -> String {
    let off_deg = (start_deg - at_deg).abs();
    let digits = if off_deg < 1e-3 { 6 } else { 3 };
    format!(
        "the trajectory was not started: it starts with joint {joint} at {start_deg:.digits$} deg, and the arm has it at {at_deg:.digits$} deg, \
         {off_deg:.digits$} deg away"
    )
}

#[cfg(feature = "realtime")]
fn no_priority(priority: u8, source: &io::Error) -> String {
    if source.kind() == io::ErrorKind::PermissionDenied {
        return format!("the system does not allow this thread the real-time priority {priority}");
    }
    format!("this thread cannot have the real-time priority {priority}")
}
