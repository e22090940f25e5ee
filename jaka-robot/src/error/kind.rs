//! Kinds of errors, by the possible actions of the caller.

use std::error::Error as StdError;
use std::io;
use std::sync::Arc;
use std::time::Duration;

use jaka_proto::Refusal;
use jaka_sync::layer::{Failure, seat_hint};

use super::Error;
use super::end::{End, Phase};
use super::line::{Line, STOP_NOT_ACCEPTED, Sequence, with_fact};
use crate::{Cause, Disconnect, Evidence, GuardTrip, NotGuarded, NotShown, Occurrence, Remedy, StatusProblem};

jaka_proto::worded! {
    /// Kind of an error, by the possible actions of the caller: see [`Error::kind`].
    #[derive(Debug)]
    #[non_exhaustive]
    pub enum ErrorKind {
        /// A call of the connection failed: a command was not sent, refused by the spec, or not answered; a connection
        /// could not be made, or broke; status packets did not come, or did not show the awaited state.
        ///
        /// A command that the controller refused is [`Refused`](Self::Refused).
        Connection(error: jaka_sync::Error) => (error.kind().to_string()),
        /// An option of this crate does not take the value that it was given. Nothing that moves the arm was sent;
        /// correct the option.
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
        /// The address of a robot names a port, and a robot has two: 10001 for commands and 10000 for its status. Give
        /// the address without a port, or both addresses to [`Robot::connect_at`](crate::Robot::connect_at). Nothing
        /// was connected to.
        PortInAddress {
            /// The address given.
            address: String,
        } =>
            "cannot connect to {address}: the address has a port, but a robot has two",
        /// The connection of a client has a robot already, and no second one was made of it: see
        /// [`Robot::new`](crate::Robot::new).
        HasRobot => "no second robot was made: the connection of this client has a robot already",
        /// The controller refused the command, which did not run. The connection is fine.
        Refused {
            /// The controller's own words.
            refusal: Refusal,
            /// Reason for the refusal of a motion of a [`Robot`](crate::Robot), if the robot's status shows it.
            explanation: Option<Occurrence>,
        } => (refused(refusal, explanation.as_ref())),
        /// Status packets do not show a requested fact: an input, a force, the joints. Nothing was sent; a stream or a
        /// trajectory has landed if packets no longer show the joints.
        NotShown {
            /// Requested fact, in words.
            what: String,
            /// Reason why they do not show it.
            reason: NotShown,
        } => "it is not known whether {what}: {reason}",
        /// A wait for an input has ended, because the status is no longer known. Nothing was sent.
        WaitEnded {
            /// Condition that was waited for, in words.
            what: String,
            /// Reason why the status is not known.
            problem: StatusProblem,
        } => (wait_ended(what, problem)),
        /// A wait for an input has ended, because the robot has stopped meanwhile, or was stopped. Nothing was sent.
        WaitBroken {
            /// Condition that was waited for, in words.
            what: String,
            /// Occurrence that ended the wait.
            occurrence: Occurrence,
        } => "the wait has ended before {what}: {occurrence}",
        /// A wait for an input has ended, because the command connection was lost: nothing can be sent on it any more,
        /// no stop either. Connect again when the robot's state is known.
        CommandsLost {
            /// Address of the connection, with the port.
            address: String,
            /// Condition that was waited for, in words.
            what: String,
            /// Cause of the end of the connection.
            cause: Arc<Disconnect>,
        } => (commands_lost(address, what, cause)),
        /// A command was not sent, because a query before it failed, or showed that the arm moves. Nothing that moves
        /// the arm was sent, nor the step of its power that the command is.
        NotSent {
            /// `cmdName` of the command.
            command: String,
            /// Error of the query, or of the arm that moves.
            because: Error,
            /// Remedy for it.
            remedy: Remedy,
        } => (not_sent(command, because)),
        /// A motion was not sent, because it could not be stopped within the overtravel of a limit of force, or that is
        /// not known.
        NotGuarded {
            /// `cmdName` of the motion.
            command: String,
            /// Reason why it was not sent.
            reason: NotGuarded,
        } => "`{command}` was not sent under a guard: {reason}",
        /// A motion, a landing or a trajectory has not ended as it was commanded: see [`End::reached`].
        NotReached {
            /// The end, with its cause.
            end: Box<End>,
        } => "{end}",
        /// The guard of a motion has tripped.
        GuardTripped {
            /// Trip, with its condition, its packet and its consequences.
            trip: Arc<GuardTrip>,
        } => (with_fact(trip.cause(), trip.to_string())),
        /// A motion under a guard failed, of which it is not known whether it runs, and the stop that followed was not
        /// accepted: the arm may move, and nobody judges the guard.
        NotStopped {
            /// First error.
            first: Error,
            /// Reason why the stop was not accepted.
            stopping: Error,
        } => (Sequence::new(first, stopping).line(STOP_NOT_ACCEPTED)),
        /// A motion or a set-point was not sent, because it is not known whether the robot is stopped. See to the
        /// status port, or, for a program that must do without it,
        /// [`RobotConfig::allow_motion_without_status`](crate::RobotConfig::allow_motion_without_status).
        StatusUnknown {
            /// Reason why it is not known.
            problem: StatusProblem,
        } => "not sent, because the state of the robot is unknown: {problem}",
        /// The state of the robot prevents the action. Nothing that moves the arm was sent.
        NotReady {
            /// State that keeps it from doing so.
            occurrence: Occurrence,
        } => "the robot cannot do this now: {occurrence}",
        /// The controller's answers do not show the arm at rest: a joint turned faster over the last three than
        /// [`RobotConfig::rest_speed`](crate::RobotConfig::rest_speed) allows. Nothing that moves the arm was sent.
        NotAtRest {
            /// The joint that turned fastest, 1 to 6.
            joint: usize,
            /// Difference between the greatest and the smallest of its three positions, in degrees.
            by_deg: f64,
            /// Least time in which it turned so far.
            within: Duration,
            /// Its speed by that, in deg/s.
            speed: f64,
            /// Greatest speed of an arm at rest, in deg/s.
            rest_speed: f64,
        } => (not_at_rest(*joint, *by_deg, *within, (*speed, *rest_speed))),
        /// A motion or a set-point was not sent, because it is beyond a limit of the robot.
        BeyondLimit {
            /// `cmdName` of the command.
            command: String,
            /// Limit that is exceeded, with the excess and the place on the path.
            beyond: jaka_motion::Beyond,
        } => "`{command}` was not sent: {beyond}",
        /// A motion or a set-point was not sent, because it cannot be checked against the robot's limits.
        NotChecked {
            /// `cmdName` of the command.
            command: String,
            /// Reason why it cannot be checked.
            reason: crate::Unchecked,
        } => "`{command}` was not sent, because it cannot be checked against the limits: {reason}",
        /// The limits are for a model whose poses differ from the controller's.
        ModelMismatch {
            /// Difference between the model's poses and the controller's.
            source: jaka_motion::FitError,
        } => "the limits are for another arm: the controller computes other poses than their model",
        /// A trajectory was not started, because it is beyond a limit of the robot. Nothing that moves the arm was
        /// sent.
        Trajectory {
            /// Limit that is exceeded, with the way-point before, the time and the joint.
            source: jaka_motion::TrajectoryError,
        } => "the trajectory was not started: {source}",
        /// A trajectory was not started, because the arm is not where it starts: move it there first, or set
        /// [`FollowConfig::approach`](crate::FollowConfig::approach). Nothing that moves the arm was sent.
        NotAtStart {
            /// The joint that is the furthest away, 1 to 6.
            joint: usize,
            /// Commanded position of the joint by the controller's answer, in degrees.
            at_deg: f64,
            /// Position of the joint at the start of the trajectory, in degrees.
            start_deg: f64,
        } => (not_at_start(*joint, *at_deg, *start_deg)),
        /// A joint does not follow the set-points of a stream or a trajectory, which has landed. Look for an obstacle.
        Departed {
            /// The joint, 1 to 6.
            joint: usize,
            /// Position of the joint in a packet, in degrees.
            at_deg: f64,
            /// Distance of that position from all its set-points of the last half second, in degrees.
            off_deg: f64,
        } =>
            "a joint does not follow its set-points: joint {joint} is at {at_deg:.2} deg, {off_deg:.2} deg from each set-point of the last half second",
        /// A set-point of a servo session, a stream or a trajectory was due too long ago, because the machine was too
        /// busy: it was not sent, and the session has ended without set-points that brake. Give the thread a priority
        /// (`ServoConfig::realtime_priority`), or the machine less to do.
        SetPointLate {
            /// Time since it was due.
            late: Duration,
        } => "a set-point was too late, by {late:.1?}: the machine was too busy to send it in time",
        /// The system cannot start a thread for a stream, a trajectory or a guard, or the guard's thread has ended too
        /// early. Nothing was sent.
        Thread {
            /// Reason, in the system's words.
            source: io::Error,
        } => "the system cannot start a thread",
        /// The system does not give the thread a real-time priority: allow it, or do without. Nothing was sent. Needs
        /// the feature `realtime`.
        RealtimePriority {
            /// Requested priority.
            priority: u8,
            /// Reason, in the system's words.
            source: io::Error,
        } => (no_priority(*priority, source)),
        /// Too many set-points of a servo session have no reply. The session has ended.
        SetPointsUnanswered {
            /// Number of set-points without a reply.
            count: usize,
            /// Time since the oldest of them was sent.
            oldest: Duration,
        } =>
            "the controller does not answer: {count} set-points have no reply, and the oldest was sent {oldest:.1?} ago; the \
             servo session has ended without a landing",
        /// A set-point was not sent: its servo session has ended.
        SessionEnded {
            /// Cause of its end.
            cause: Cause,
            /// Reason for its end, in words.
            because: String,
            /// Remedy for the cause of the end.
            remedy: Remedy,
        } => "not sent, because the servo session has ended: {because}",
        /// A motion was not sent, because the robot has stopped or a connection was lost, and this has not been
        /// acknowledged: see [`Robot::acknowledge`](crate::Robot::acknowledge).
        NotAcknowledged {
            /// Occurrence that has not been acknowledged.
            occurrence: Occurrence,
        } => "not sent: {occurrence}",
        /// Status packets show a state of the robot that ends set-points: no power, an arm that is not enabled, an
        /// error of the controller, a soft limit, or another tool frame or user frame than at the start where the
        /// set-points depend on them. The servo session, the stream or the trajectory has landed, as far as the
        /// controller followed set-points and, of poses in a changed frame, as far as their joint positions are known
        /// ([`NotLanded`](Self::NotLanded)).
        RobotState {
            /// State, with the evidence for it.
            occurrence: Occurrence,
        } => "{occurrence}",
        /// A stop of the program's own has ended a call that sends one step after the other, such as
        /// [`Robot::power_up`](crate::Robot::power_up): no further step was sent.
        Stopped {
            /// `cmdName` of the steps that had been accepted by then, in their order.
            accepted: Vec<String>,
            /// `cmdName` of the steps that were not sent.
            not_sent: Vec<String>,
        } => (stopped(&named(accepted), &named(not_sent))),
        /// Servo mode could not be left, or it is not known that it was: the arm may still be in servo mode. Where the
        /// connection is broken ([`Error::is_disconnected`]), no stop can be sent on it either.
        ServoModeNotLeft {
            /// First error of the session; `None` if only leaving servo mode failed.
            first: Option<Error>,
            /// Reason why servo mode could not be left.
            leaving: Error,
        } => (Sequence::new(first.as_ref(), leaving).line(not_left(leaving))),
        /// A servo session has ended by a landing, but no status packet has shown the arm at rest at its last
        /// set-point; servo mode was left. The arm may not have followed: look at it before the next motion.
        RestNotSeen {
            /// Error that ended the session; `None` for a requested landing.
            first: Option<Error>,
            /// Time for which the last set-point was held.
            after: Duration,
        } => (rest_not_seen(first.as_ref(), *after)),
        /// A servo session has ended, and could not brake the arm to rest; servo mode was left. Look at the arm before
        /// the next motion.
        NotLanded {
            /// Error that ended the session.
            first: Error,
            /// Error that ended the landing.
            landing: Error,
        } => (Sequence::new(first, landing).line("the arm was not braked to rest")),
    }
}

/// Group of kinds that a predicate of [`Error`] asks for.
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

/// Meaning of a kind to the methods of an error.
pub(super) struct Meaning<'k> {
    pub(super) group: Group,
    /// True if the command may have run.
    pub(super) may_have_run: bool,
    /// Error below it; if the kind's text has the text of that error, the error below that.
    pub(super) source: Option<&'k (dyn StdError + 'static)>,
}

impl<'k> Meaning<'k> {
    /// Meaning of a kind whose command has not run.
    fn not_run(group: Group) -> Self {
        Self { group, may_have_run: false, source: None }
    }

    /// Meaning of a kind whose command may have run.
    fn may_have_run(group: Group) -> Self {
        Self { group, may_have_run: true, source: None }
    }

    /// Meaning with an error below it.
    fn source(self, source: impl Into<Option<&'k (dyn StdError + 'static)>>) -> Self {
        Self { source: source.into(), ..self }
    }
}

impl ErrorKind {
    /// Cause of the end of a motion, or of its refusal; of several errors in one, the first by precedence.
    pub(super) fn cause(&self) -> Cause {
        match self {
            Self::Refused { explanation: None, .. } => Cause::Refused,
            Self::Connection(error) => of_connection(error),
            Self::SetPointsUnanswered { .. } => Cause::Unanswered,
            Self::CommandsLost { .. } => Cause::CommandsLost,
            Self::NotReached { end } => end.cause(),
            Self::WaitEnded { .. } | Self::StatusUnknown { .. } => Cause::StatusLost,
            Self::NotShown { .. } => Cause::NotShown,
            Self::NotGuarded { .. } => Cause::NotGuarded,
            Self::GuardTripped { trip } => trip.cause(),
            Self::NotStopped { first, stopping } => Sequence::new(first, stopping).cause(),
            Self::SetPointLate { .. } => Cause::SetPointLate,
            Self::NotSent { because, .. } => because.cause(),
            Self::NotAtRest { .. } => Cause::Moving,
            Self::SessionEnded { cause, .. } => *cause,
            Self::NotAcknowledged { occurrence }
            | Self::NotReady { occurrence }
            | Self::Refused { explanation: Some(occurrence), .. }
            | Self::RobotState { occurrence }
            | Self::WaitBroken { occurrence, .. } => occurrence.cause,
            Self::Stopped { .. } => Cause::Stopped,
            Self::ServoModeNotLeft { first, leaving } => Sequence::new(first.as_ref(), leaving).cause(),
            Self::RestNotSeen { first, .. } => first.as_ref().map_or(Cause::RestNotSeen, Error::cause),
            Self::NotLanded { first, landing } => Sequence::new(first, landing).cause(),
            Self::InvalidOption { .. }
            | Self::PortInAddress { .. }
            | Self::HasRobot
            | Self::Thread { .. }
            | Self::ModelMismatch { .. }
            | Self::RealtimePriority { .. } => Cause::Failed,
            Self::BeyondLimit { .. } | Self::NotChecked { .. } | Self::Trajectory { .. } => Cause::BeyondLimit,
            Self::NotAtStart { .. } => Cause::NotAtStart,
            Self::Departed { .. } => Cause::Departed,
        }
    }

    /// Causes of all its events.
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

    /// Event, beginning with the fact of its cause: for texts that name the commands not sent because of it.
    pub(super) fn event(&self) -> String {
        let text = match self {
            Self::NotAcknowledged { occurrence } | Self::NotReady { occurrence } => occurrence.to_string(),
            Self::NotSent { because, .. } => because.kind().event(),
            Self::StatusUnknown { problem } => problem.to_string(),
            Self::Refused { refusal, .. } => refusal.to_string(),
            kind => kind.to_string(),
        };
        with_fact(self.cause(), text)
    }

    /// Evidence for the cause, besides the error.
    pub(super) fn evidence(&self) -> Evidence {
        match self {
            Self::NotAcknowledged { occurrence }
            | Self::NotReady { occurrence }
            | Self::Refused { explanation: Some(occurrence), .. }
            | Self::RobotState { occurrence }
            | Self::WaitBroken { occurrence, .. } => occurrence.evidence.clone(),
            Self::GuardTripped { trip } => Evidence::Trip(Arc::clone(trip)),
            Self::NotReached { end } => end.evidence().clone(),
            Self::Connection(error) => evidence(error),
            Self::NotSent { because, .. } => because.kind().evidence(),
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
            Self::NotAcknowledged { occurrence }
            | Self::NotReady { occurrence }
            | Self::Refused { explanation: Some(occurrence), .. }
            | Self::RobotState { occurrence }
            | Self::WaitBroken { occurrence, .. } => occurrence.remedy(),
            Self::StatusUnknown { problem } | Self::WaitEnded { problem, .. } => problem.remedy().into(),
            Self::NotShown { reason, .. } => reason.remedy(),
            Self::NotGuarded { reason, .. } => reason.remedy(),
            Self::SessionEnded { remedy, .. } | Self::NotSent { remedy, .. } => *remedy,
            Self::NotStopped { first, stopping } => Sequence::new(first, stopping).remedy(),
            Self::ServoModeNotLeft { first, leaving } => Sequence::new(first.as_ref(), leaving).remedy(),
            Self::NotLanded { first, landing } => Sequence::new(first, landing).remedy(),
            Self::RestNotSeen { first: Some(first), .. } => first.remedy_of_event(),
            Self::Refused { explanation: None, .. }
            | Self::CommandsLost { .. }
            | Self::SetPointLate { .. }
            | Self::SetPointsUnanswered { .. }
            | Self::Departed { .. }
            | Self::NotAtStart { .. }
            | Self::Stopped { .. }
            | Self::RestNotSeen { first: None, .. } => self.cause().remedy(),
            Self::Connection(error) => error.remedy().into(),
            Self::PortInAddress { .. } => Remedy::LeaveOutPort,
            Self::HasRobot => Remedy::UseOneRobot,
            Self::NotChecked { reason, .. } => reason.remedy(),
            Self::NotAtRest { .. } => Remedy::WaitForRest,
            Self::RealtimePriority { source, .. } if source.kind() == io::ErrorKind::PermissionDenied => {
                Remedy::AllowRealtimePriority
            }
            // The fact says all that is known.
            Self::InvalidOption { .. }
            | Self::Thread { .. }
            | Self::BeyondLimit { .. }
            | Self::ModelMismatch { .. }
            | Self::Trajectory { .. }
            | Self::RealtimePriority { .. } => Remedy::None,
        }
    }

    /// Meaning to the methods of an error. Each kind is named: a new one does not compile before its meaning is
    /// decided.
    pub(super) fn meaning(&self) -> Meaning<'_> {
        let other = Meaning::not_run(Group::Other);
        match self {
            Self::Connection(error) => Meaning {
                group: Group::of_connection(error),
                may_have_run: error.may_have_run(),
                source: error.source(),
            },
            Self::InvalidOption { .. } => Meaning::not_run(Group::InvalidArgument),
            Self::PortInAddress { .. } => Meaning::not_run(Group::Connect),
            Self::HasRobot => Meaning::not_run(Group::Other),
            Self::Refused { .. } => Meaning::not_run(Group::Refused),
            Self::CommandsLost { cause, .. } => {
                Meaning::not_run(Group::Disconnected).source(&**cause as &(dyn StdError + 'static))
            }
            Self::ServoModeNotLeft { first, leaving } => {
                Meaning::may_have_run(Group::after(leaving)).source(Sequence::new(first.as_ref(), leaving).source())
            }
            Self::NotStopped { first, stopping } => {
                Meaning::may_have_run(Group::after(stopping)).source(Sequence::new(first, stopping).source())
            }
            Self::SetPointsUnanswered { .. } => Meaning::may_have_run(Group::Other),
            Self::RestNotSeen { first, .. } => {
                Meaning::may_have_run(Group::Other).source(first.as_ref().and_then(|first| first.source()))
            }
            Self::NotLanded { first, landing } => {
                Meaning::may_have_run(Group::Other).source(Sequence::new(first, landing).source())
            }
            Self::GuardTripped { trip } => Meaning { may_have_run: !trip.is_before_start, ..other },
            Self::StatusUnknown { problem } | Self::WaitEnded { problem, .. } => other.source(problem.source()),
            Self::NotAcknowledged { occurrence }
            | Self::RobotState { occurrence }
            | Self::WaitBroken { occurrence, .. } => other.source(occurrence.source()),
            Self::NotReached { end } => Meaning {
                group: Group::of(end.cause()),
                may_have_run: end.phase() != Phase::NotSent,
                source: end.source(),
            },
            // It is no refusal of the command.
            Self::NotSent { because, .. } if because.is_refused() => other.source(because.source()),
            Self::NotSent { because, .. } => Meaning { may_have_run: false, ..because.kind().meaning() },
            Self::NotReady { .. }
            | Self::NotAtRest { .. }
            | Self::SetPointLate { .. }
            | Self::SessionEnded { .. }
            | Self::NotShown { .. }
            | Self::NotGuarded { .. }
            | Self::NotAtStart { .. }
            | Self::Departed { .. }
            | Self::BeyondLimit { .. }
            | Self::NotChecked { .. }
            | Self::Stopped { .. } => other,
            Self::ModelMismatch { source } => other.source(source as &(dyn StdError + 'static)),
            Self::Trajectory { source } => other.source(source.source()),
            Self::Thread { source } | Self::RealtimePriority { source, .. } => {
                other.source(source as &(dyn StdError + 'static))
            }
        }
    }
}

impl Group {
    /// Group that an error of the connection has by its own predicates.
    fn of_connection(error: &jaka_sync::Error) -> Self {
        let groups = [
            (error.is_invalid_argument(), Self::InvalidArgument),
            (error.is_not_in_firmware(), Self::NotInFirmware),
            (error.is_connect(), Self::Connect),
            (error.is_refused(), Self::Refused),
            (error.is_timeout(), Self::Timeout),
            (error.is_disconnected(), Self::Disconnected),
        ];
        groups.into_iter().find_map(|(is_in, group)| is_in.then_some(group)).unwrap_or(Self::Other)
    }

    /// Group of an end by this cause.
    fn of(cause: Cause) -> Self {
        if cause == Cause::CommandsLost { Self::Disconnected } else { Self::Other }
    }

    /// Group of an error that contains another one, after which nothing more could be sent.
    fn after(last: &Error) -> Self {
        if last.is_disconnected() { Self::Disconnected } else { Self::Other }
    }
}

/// Cause that an error of the connection shows.
fn of_connection(error: &jaka_sync::Error) -> Cause {
    match Failure::of(error) {
        Failure::NotSent | Failure::NotConnected => Cause::Failed,
        Failure::Refused => Cause::Refused,
        // Reset here, because set-points were not answered.
        Failure::UnfitReply | Failure::Unanswered | Failure::Reset => Cause::Unanswered,
        Failure::CommandsLost => Cause::CommandsLost,
        Failure::StatusLost => Cause::StatusLost,
        Failure::NotInState => Cause::Deadline,
    }
}

/// Evidence that an error of the connection has.
fn evidence(error: &jaka_sync::Error) -> Evidence {
    match error.kind() {
        jaka_sync::ErrorKind::Disconnected { address, command: Some(_), cause, .. } => {
            Evidence::Commands { address: address.clone(), cause: Arc::clone(cause) }
        }
        _ => Evidence::None,
    }
}

fn refused(refusal: &Refusal, explanation: Option<&Occurrence>) -> String {
    explanation.map_or_else(|| refusal.to_string(), |explanation| format!("{refusal}; {explanation}"))
}

fn commands_lost(address: &str, what: &str, cause: &Disconnect) -> String {
    format!("the wait has ended before {what}: {} ({address}{})", Cause::CommandsLost, seat_hint(cause))
}

fn wait_ended(what: &str, problem: &StatusProblem) -> String {
    format!("the wait has ended before {what}, because {}: {problem}", Cause::StatusLost)
}

fn not_left(leaving: &Error) -> &'static str {
    // If the command connection is lost, the fact says that no stop can be sent.
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

/// The command and the failure of the query. Texts of the connection say of the query that it may have run.
fn not_sent(command: &str, because: &Error) -> String {
    use jaka_sync::ErrorKind as Failed;
    let why = match because.connection().map(jaka_sync::Error::kind) {
        Some(Failed::Timeout { command: query, after }) => format!("no reply to `{query}` within {after:?}"),
        Some(Failed::ReplyLost { command: query }) => format!("the reply to `{query}` was lost"),
        Some(Failed::UnexpectedReply { command: query, .. }) => format!("the reply to `{query}` does not fit the spec"),
        Some(Failed::Disconnected { address, command: Some(query), sent: true, cause }) => {
            format!("the connection to {address} broke during `{query}`{}", seat_hint(cause))
        }
        Some(Failed::Disconnected { address, command: Some(_), sent: false, cause }) => {
            format!("the connection to {address} is broken{}", seat_hint(cause))
        }
        _ => because.kind().to_string(),
    };
    format!("`{command}` was not sent: {why}")
}

fn not_at_rest(joint: usize, by_deg: f64, within: Duration, (speed, rest_speed): (f64, f64)) -> String {
    format!(
        "the arm is moving: joint {joint} turned by {by_deg:.3} deg within {within:.1?} ({speed:.2} deg/s), and at rest it \
         turns at most at {rest_speed} deg/s"
    )
}

fn not_at_start(joint: usize, at_deg: f64, start_deg: f64) -> String {
    let off_deg = (start_deg - at_deg).abs();
    let digits = if off_deg < 1e-3 { 6 } else { 3 };
    format!(
        "the trajectory was not started: it starts with joint {joint} at {start_deg:.digits$} deg, but the joint is at {at_deg:.digits$} deg, \
         {off_deg:.digits$} deg away"
    )
}

fn no_priority(priority: u8, source: &io::Error) -> String {
    if source.kind() == io::ErrorKind::PermissionDenied {
        return format!("the system does not allow this thread the real-time priority {priority}");
    }
    format!("this thread cannot have the real-time priority {priority}")
}
