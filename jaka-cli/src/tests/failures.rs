//! Texts, remedies and exit codes of all causes and of each kind of error that a program can make, side by side.

use std::fmt::Write as _;
use std::io;
use std::sync::Arc;
use std::time::Duration;

use expect_test::expect_file;
use jaka_robot::jaka_motion::{FitError, TrajectoryError};
use jaka_robot::jaka_sync;
use jaka_robot::jaka_sync::proto::recording::Port;
use jaka_robot::{
    Cause, Disconnect, Error, ErrorCode, ErrorKind, Evidence, NotGuarded, NotShown, Occurrence, Refusal, Remedy,
    ServoModeState, StatusProblem, Unchecked,
};

use crate::failure::{Failure, verb};
use crate::terminal::exit;

const TIME: Duration = Duration::from_millis(1500);

fn lost() -> Arc<Disconnect> {
    Arc::new(Disconnect::Read(io::ErrorKind::ConnectionReset.into()))
}

fn refusal() -> Refusal {
    Refusal::new("joint_move", ErrorCode(2), "call joint_move failed")
}

/// Errors of a connection.
fn of_connection() -> Vec<jaka_sync::ErrorKind> {
    use jaka_sync::ErrorKind::*;
    let command = || "joint_move".to_owned();
    let address = || "arm:10001".to_owned();
    vec![
        Connect { address: address(), port: Port::Command, source: io::ErrorKind::ConnectionRefused.into() },
        KeptBack { command: command(), because: "a stop has been sent" },
        Timeout { command: command(), after: TIME },
        NotSentInTime { command: command(), after: TIME },
        ReplyLost { command: command() },
        Disconnected { address: address(), command: Some(command()), sent: true, cause: lost() },
        Disconnected { address: address(), command: Some(command()), sent: false, cause: lost() },
        Disconnected { address: address(), command: None, sent: false, cause: lost() },
    ]
}

fn problems() -> [StatusProblem; 5] {
    [
        StatusProblem::Missing { address: "arm:10000".to_owned() },
        StatusProblem::Stale { age: TIME },
        StatusProblem::Resuming,
        StatusProblem::Ended { cause: lost() },
        StatusProblem::Reconnecting,
    ]
}

fn occurrences() -> Vec<Occurrence> {
    use Cause::{DragMode, EmergencyStop, Moving, NoRemoteControl, NotEnabled, NotPowered, ProtectiveStop, SoftLimit};
    let causes = [EmergencyStop, ProtectiveStop, DragMode, NotPowered, NotEnabled, NoRemoteControl, Moving, SoftLimit];
    let states = [ServoModeState::Off, ServoModeState::OnAlready, ServoModeState::NotEntered, ServoModeState::NotLeft];
    causes.into_iter().map(Occurrence::from).chain(states.map(Occurrence::from)).collect()
}

/// Errors of a robot; those that contain others follow.
fn of_robot() -> Vec<ErrorKind> {
    let what = || "the force is at least 10 N".to_owned();
    let command = || "move_l".to_owned();
    let occurrence = || Occurrence::from(Cause::ProtectiveStop);
    let (option, of, value, expected) = ("step_count", "ServoConfig", "99".to_owned(), "1 to 12".to_owned());
    let not_guarded = [
        NotGuarded::TooFast {
            speed_mm_s: 50.0,
            permitted_mm_s: 4.5,
            overtravel_mm: 1.0,
            period: TIME,
            reaction: TIME,
            braking_mm_s2: 500.0,
        },
        NotGuarded::CannotBrake { after: 2, time_s: 1.25 },
        NotGuarded::SpeedUnknown,
        NotGuarded::BrakingUnknown,
        NotGuarded::Moving,
        NotGuarded::PeriodUnknown,
    ];
    let unchecked = [
        Unchecked::Start,
        Unchecked::Target,
        Unchecked::Path,
        Unchecked::Frames,
        Unchecked::FramesInQueue,
        Unchecked::NoLimits,
    ];
    let not_shown = [
        NotShown::Absent { field: "torque_sensor".to_owned() },
        NotShown::TooShort { field: "digital_inputs".to_owned(), count: 2 },
        NotShown::SensorOff,
        NotShown::SensorError { code: "7".to_owned() },
    ];
    let mut kinds = vec![
        ErrorKind::InvalidOption { option, of, value, expected },
        ErrorKind::PortInAddress { address: "arm:10001".to_owned() },
        ErrorKind::HasRobot,
        ErrorKind::Refused { refusal: refusal(), explanation: None },
        ErrorKind::WaitBroken { what: what(), occurrence: occurrence() },
        ErrorKind::CommandsLost { address: "arm:10001".to_owned(), what: what(), cause: lost() },
        ErrorKind::NotAtRest { joint: 2, by_deg: 0.5, within: TIME, speed: 3.0, rest_speed: 0.1 },
        ErrorKind::ModelMismatch { source: FitError::NotFinite },
        ErrorKind::Trajectory { source: TrajectoryError::TooFew { given: 1 } },
        ErrorKind::NotAtStart { joint: 3, at_deg: 10.0, start_deg: 12.0 },
        ErrorKind::Departed { joint: 3, at_deg: 10.0, off_deg: 2.0 },
        ErrorKind::SetPointLate { late: TIME },
        ErrorKind::Thread { source: io::ErrorKind::OutOfMemory.into() },
        ErrorKind::RealtimePriority { priority: 20, source: io::ErrorKind::PermissionDenied.into() },
        ErrorKind::RealtimePriority { priority: 20, source: io::ErrorKind::InvalidInput.into() },
        ErrorKind::SetPointsUnanswered { count: 13, oldest: TIME },
        ErrorKind::SessionEnded {
            cause: Cause::Departed,
            because: "it departed".to_owned(),
            remedy: Remedy::FindObstacle,
        },
        ErrorKind::NotAcknowledged { occurrence: occurrence() },
        ErrorKind::RobotState {
            occurrence: Occurrence::new(Cause::StatusLost, Evidence::Status { cause: None, unreadable: None }),
        },
        ErrorKind::Stopped { accepted: vec!["power_on".to_owned()], not_sent: vec!["enable_robot".to_owned()] },
        ErrorKind::Stopped { accepted: vec![], not_sent: vec![command()] },
        ErrorKind::RestNotSeen { first: None, after: TIME },
    ];
    kinds.extend(occurrences().into_iter().map(|occurrence| ErrorKind::NotReady { occurrence }));
    kinds.extend(
        occurrences().into_iter().map(|reason| ErrorKind::Refused { refusal: refusal(), explanation: Some(reason) }),
    );
    kinds.extend(problems().map(|problem| ErrorKind::StatusUnknown { problem }));
    kinds.extend(problems().map(|problem| ErrorKind::WaitEnded { what: what(), problem }));
    kinds.extend(not_shown.map(|reason| ErrorKind::NotShown { what: what(), reason }));
    kinds.extend(not_guarded.map(|reason| ErrorKind::NotGuarded { command: command(), reason }));
    kinds.extend(unchecked.map(|reason| ErrorKind::NotChecked { command: command(), reason }));
    kinds
}

/// Errors that contain others.
fn sequences() -> Vec<ErrorKind> {
    let firsts: [fn() -> Error; 3] = [
        || ErrorKind::NotReady { occurrence: Cause::EmergencyStop.into() }.into(),
        || ErrorKind::Departed { joint: 3, at_deg: 10.0, off_deg: 2.0 }.into(),
        || ErrorKind::StatusUnknown { problem: StatusProblem::Stale { age: TIME } }.into(),
    ];
    let thens: [fn() -> Error; 3] = [
        || jaka_sync::ErrorKind::Timeout { command: "servo_move".to_owned(), after: TIME }.into(),
        || {
            let (address, command) = ("arm:10001".to_owned(), Some("servo_move".to_owned()));
            jaka_sync::ErrorKind::Disconnected { address, command, sent: true, cause: lost() }.into()
        },
        || ErrorKind::Refused { refusal: refusal(), explanation: None }.into(),
    ];
    let mut kinds = Vec::new();
    for then in thens {
        kinds.push(ErrorKind::NotSent { command: "move_l".to_owned(), because: then(), remedy: Remedy::None });
        kinds.push(ErrorKind::ServoModeNotLeft { first: None, leaving: then() });
        for first in firsts {
            kinds.push(ErrorKind::NotStopped { first: first(), stopping: then() });
            kinds.push(ErrorKind::ServoModeNotLeft { first: Some(first()), leaving: then() });
            kinds.push(ErrorKind::NotLanded { first: first(), landing: then() });
        }
    }
    kinds.extend(firsts.map(|first| ErrorKind::RestNotSeen { first: Some(first()), after: TIME }));
    kinds
}

fn line(out: &mut String, error: Error) {
    let (cause, may_have_run, text) = (error.cause(), error.may_have_run(), error.to_string());
    let failure = Failure::Robot(error);
    let (code, fact, hint) = (exit::code(&failure), failure.to_string(), failure.hint());
    let may = if may_have_run { "may have run" } else { "not run" };
    writeln!(out, "{} | {may} | {code}\n  {text}\n  jaka: {fact}", cause.name()).expect("it is text");
    if let Some(hint) = hint {
        writeln!(out, "  hint: {hint}").expect("it is text");
    }
}

#[test]
fn each_has_its_text_its_remedy_and_its_exit_code() {
    let mut out = String::new();
    for cause in Cause::ALL {
        let (name, group, remedy) = (cause.name(), cause.group(), cause.remedy());
        writeln!(out, "{name} | {group:?} | {}\n  {cause}\n  {remedy}", cause.exit_code()).expect("it is text");
        if let Some(hint) = verb(remedy) {
            writeln!(out, "  hint: {hint}").expect("it is text");
        }
    }
    let errors = of_connection().into_iter().map(Error::from);
    for error in errors.chain(of_robot().into_iter().chain(sequences()).map(Error::from)) {
        line(&mut out, error);
    }
    expect_file!["failures.txt"].assert_eq(&out);
}
