//! Failures of a command.

pub(crate) mod command_line;

use std::borrow::Cow;
use std::error::Error as StdError;
use std::fmt;
use std::io;
use std::path::Path;

use itertools::Itertools as _;
use jaka_robot::{Error, ErrorKind, Occurrence, Refusal, Remedy, jaka_sync};
use jaka_spec::Spec;
use jaka_spec::words::first_sentence;

/// Failure of a command.
#[derive(Debug)]
pub(crate) enum Failure {
    /// The command line, an argument or the config file is wrong.
    Usage(String),
    /// The command line is unreadable, or asks for help.
    CommandLine(Box<clap::Error>),
    /// Error of the robot, or of the connection to it.
    Robot(Error),
    /// The controller refused the command.
    Refused {
        /// Text of the controller.
        refusal: Refusal,
        /// Meaning of the code, if the spec knows it.
        meaning: Option<String>,
        /// Explanation of the refusal, if the robot's status shows one.
        explanation: Option<Box<Occurrence>>,
    },
    /// The controller did not accept a stop, or its acceptance is unknown.
    NotStopped(Box<Failure>),
    /// The arm was stopped, and was not seen at rest.
    NotAtRest {
        /// Failure of the stopped action, if there is one.
        ended: Option<Box<Failure>>,
        /// Failure of the wait for rest.
        unrest: Box<Failure>,
    },
    /// A wait ended with its timeout.
    NotInTime(String),
    /// A motion was not sent, with the cause and a remedy.
    NotSent(String),
    /// Messages of the controller deviate from the spec, or requests of clients from the recording, with the number of
    /// deviations.
    Departs(String),
    /// All output has been printed, or its reader is gone, with the exit code.
    Printed(u8),
    /// Ctrl-C ended the command early, after it printed the results so far.
    Interrupted,
    /// Failure on this machine.
    Local {
        /// Text that names the failed action, such as "cannot start the simulated controller".
        what: String,
        /// Cause of the failure.
        source: io::Error,
        /// Action against it, if one is known.
        hint: Option<&'static str>,
    },
}

impl Failure {
    /// Creates the failure of an output error.
    pub(crate) fn output(source: io::Error) -> Self {
        if source.kind() == io::ErrorKind::BrokenPipe {
            // A closed reader is not a failure.
            return Self::Printed(0);
        }
        Self::local("cannot write the output", source)
    }

    /// Creates the failure of a file that cannot be written.
    pub(crate) fn unwritten(path: &Path, source: io::Error) -> Self {
        Self::local(format!("cannot write {}", path.display()), source)
    }

    /// Creates a failure with the meaning of the controller's code in the spec or a pack.
    pub(crate) fn explained(spec: &Spec, error: impl Into<Error>) -> Self {
        let error = error.into();
        match error.kind() {
            ErrorKind::Refused { refusal, explanation } => {
                let (refusal, explanation) = (refusal.clone(), explanation.clone().map(Box::new));
                Self::Refused { meaning: meaning(spec, &refusal), refusal, explanation }
            }
            _ => error.into(),
        }
    }

    /// Creates the failure of an action on this machine, with its cause.
    pub(crate) fn local(what: impl Into<String>, source: io::Error) -> Self {
        Self::Local { what: what.into(), source, hint: None }
    }

    /// Creates the failure of ports that cannot be opened; `in_use` is the hint for ports in use.
    pub(crate) fn unopened(what: impl Into<String>, source: io::Error, in_use: &'static str) -> Self {
        let hint = (source.kind() == io::ErrorKind::AddrInUse).then_some(in_use);
        Self::Local { what: what.into(), source, hint }
    }
}

/// Returns the meaning of a refusal's code, from the spec or a pack.
fn meaning(spec: &Spec, refusal: &Refusal) -> Option<String> {
    let known = spec.errors().find(|known| known.wire == refusal.code.0);
    known.map(|known| first_sentence(&known.doc).0.to_owned())
}

impl Failure {
    /// Returns a command to type, or an action to take, against the cause.
    pub(crate) fn hint(&self) -> Option<Cow<'static, str>> {
        match self {
            Self::Refused { explanation: Some(explanation), .. } => verb(explanation.remedy()),
            Self::Robot(error) => verb(error.remedy()),
            Self::Local { hint, .. } => hint.map(Cow::Borrowed),
            Self::NotAtRest { .. } => Some("use the emergency stop, unless you see the arm at rest".into()),
            _ => None,
        }
    }
}

/// Returns the text of a remedy, in terms of this program's commands.
pub(crate) fn verb(remedy: Remedy) -> Option<Cow<'static, str>> {
    if let Remedy::OfEvent(event) = remedy {
        let remedy = event.remedy()?;
        let code = event.code();
        return Some(
            format!("{remedy}; when the cause is gone and somebody has looked at the arm, `jaka clear` clears the error; `jaka explain {code:#08x}`")
                .into(),
        );
    }
    Some(Cow::Borrowed(match remedy {
        Remedy::None | Remedy::SeeError | Remedy::OfEvent(_) | Remedy::Connection(jaka_sync::Remedy::None) => {
            return None;
        }
        // Without a call of the library.
        Remedy::GrantRemoteControl
        | Remedy::FindObstacle
        | Remedy::MoveMoreSlowly
        | Remedy::GiveAbsoluteTarget
        | Remedy::AllowRealtimePriority
        | Remedy::Connection(
            jaka_sync::Remedy::CheckAddress
            | jaka_sync::Remedy::FreeSeat
            | jaka_sync::Remedy::CheckStatusPort
            | jaka_sync::Remedy::TryAgain,
        ) => return Some(remedy.to_string().into()),
        Remedy::ReleaseEmergencyStop => "when nobody is at the arm, release it, then `jaka up`",
        Remedy::ClearError => "when somebody has looked at the arm, `jaka clear` leaves the protective stop",
        Remedy::LeaveDragMode => {
            "when nobody has a hand on the arm, end drag mode: `jaka call set_torque_control --enable-flag off`"
        }
        Remedy::PowerUp => "when somebody has looked at the arm, `jaka up` powers and enables it",
        Remedy::SeeController => "when somebody has looked at the arm, `jaka clear` clears the error",
        Remedy::MoveAway => "when somebody has looked at the arm, `jaka jog` moves it away from the limit",
        Remedy::SeeServoMode => "find the program that uses servo mode",
        Remedy::WaitOrStop => "`jaka stop` stops it, `jaka status --watch` shows it",
        Remedy::WaitForRest => "`jaka stop` stops it; try again once it is at rest",
        Remedy::PowerDownUnseen => "look at the arm; `jaka down --without-joints` powers it down all the same",
        Remedy::LookAtArm => "look at the arm before it moves again",
        Remedy::SelectFrames => {
            "find the person or program that changed it, and select the frames of the motion: `jaka call set_tool_id`, \
             `jaka call set_user_id`"
        }
        Remedy::ConnectAndStop => {
            "use the emergency stop, or `jaka stop`, which takes the command port back and stops the arm"
        }
        Remedy::Connection(jaka_sync::Remedy::CheckNetwork | jaka_sync::Remedy::ConnectStatusAgain) => {
            "check the network; try `jaka stop`: commands may still pass"
        }
        Remedy::UnloadMachine => "`jaka jitter` measures the lateness of this machine and names remedies",
        Remedy::MoveToStart => "`--approach` moves the arm to the start first",
        Remedy::LeaveOutPort => "leave out the port; `--command-port` and `--status-port` name other ones",
        Remedy::UseOneRobot => "end the other robot of this connection first",
        Remedy::Connection(jaka_sync::Remedy::WaitForPackets) => {
            "wait for more status packets: `jaka status --watch` shows them"
        }
        Remedy::SwitchSensorOn => "switch the sensor on: `jaka call set_torque_sensor_mode`",
        Remedy::MoveOnLine => "move on a line or an arc towards a contact",
        Remedy::GiveAcceleration => "`--acceleration` sets it",
        Remedy::WaitForMotions => "wait for the end of all motions first: `jaka status --watch` shows it",
        Remedy::GiveLimits => "`--model` gives the robot limits",
        Remedy::LengthenReaction => "set a reaction longer than the lag",
    }))
}

/// Returns the text for a failed stop: the arm may still move.
pub(crate) fn not_taken(may_have_run: bool) -> &'static str {
    if may_have_run {
        "it is not known whether the controller accepted the stop; the arm may still move, use the emergency stop"
    } else {
        "the controller did not accept the stop; the arm may still move, use the emergency stop"
    }
}

/// Returns the text for an arm that was not seen at rest.
pub(crate) fn unrest(failure: &Failure) -> String {
    if let Failure::Robot(error) = failure
        && let ErrorKind::NotAtRest { joint, speed, .. } = error.kind()
    {
        return format!("the arm still moves: joint {joint} turns at {speed:.2} deg/s");
    }
    format!("it is not known whether the arm is at rest: {}", chain(failure))
}

/// Returns the text of an error's kind, followed by the texts of its causes. The error's own text also has the
/// library's remedy.
pub(crate) fn fact(kind: &dyn fmt::Display, error: &dyn StdError) -> String {
    let fact = kind.to_string();
    error.source().map_or_else(|| fact.clone(), |source| format!("{fact}: {}", chain(source)))
}

/// Returns an error's text, followed by those of its causes.
pub(crate) fn chain(error: &(dyn StdError + 'static)) -> String {
    std::iter::successors(Some(error), |&error| error.source()).join(": ")
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Usage(text) | Self::Departs(text) | Self::NotInTime(text) | Self::NotSent(text) => f.write_str(text),
            Self::CommandLine(error) => f.write_str(&command_line::text(error)),
            Self::Robot(error) => match error.kind() {
                ErrorKind::Stopped { accepted, not_sent } => {
                    let named =
                        |names: &[String]| if names.is_empty() { "nothing".to_owned() } else { names.join(", ") };
                    write!(f, "interrupted; accepted before: {}; not sent: {}", named(accepted), named(not_sent))
                }
                // Omits the library's type.
                ErrorKind::InvalidOption { option, value, expected, .. } => {
                    write!(f, "option `{option}` is {value}, expected {expected}")
                }
                // Only the fact: the remedy is a hint.
                kind => kind.fmt(f),
            },
            Self::Refused { refusal, explanation: Some(explanation), .. } => {
                write!(f, "{refusal}\nThe reason: {explanation}")
            }
            Self::Refused { refusal, meaning: Some(meaning), .. } => {
                write!(f, "{refusal}\nThe code's meaning: {meaning}")
            }
            Self::Refused { refusal, .. } => write!(f, "{refusal}\nThe code is not in the spec."),
            Self::Local { what, .. } => f.write_str(what),
            Self::Printed(_) => Ok(()),
            Self::NotStopped(failure) => {
                let may_have_run = matches!(&**failure, Self::Robot(error) if error.may_have_run());
                f.write_str(not_taken(may_have_run))
            }
            Self::NotAtRest { ended: None, unrest } => f.write_str(&self::unrest(unrest)),
            Self::NotAtRest { ended: Some(ended), unrest } => {
                write!(f, "{}; {}", chain(&**ended), self::unrest(unrest))
            }
            Self::Interrupted => f.write_str("interrupted"),
        }
    }
}

impl StdError for Failure {
    fn source(&self) -> Option<&(dyn StdError + 'static)> {
        match self {
            // The display text includes that of the error.
            Self::Robot(error) => error.source(),
            Self::Local { source, .. } => Some(source),
            Self::NotStopped(failure) => Some(&**failure),
            _ => None,
        }
    }
}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        Self::Robot(error)
    }
}

impl From<jaka_sync::Error> for Failure {
    fn from(error: jaka_sync::Error) -> Self {
        Error::from(error).into()
    }
}

impl From<clap::Error> for Failure {
    fn from(error: clap::Error) -> Self {
        Self::CommandLine(Box::new(error))
    }
}
