//! Servo sessions.

use std::time::Duration;

use jaka_proto::read_payload;
use jaka_robot::jaka_sync::ErrorKind as Failure;
use jaka_robot::kinematics::{GetJointPos, GetTcpPos};
use jaka_robot::power::GetRobotState;
use jaka_robot::servo::{IsInServomove, IsInServomoveReply, ServoJ, SetServoMode};
use jaka_robot::types::Switch;
use jaka_robot::{Command, Error, ErrorKind, Explanation, Report, ServoConfig, ServoSession, SessionConfig};
use serde_json::json;

use super::account::{Connection, Fate};
use super::arm::Arm;
use super::calls::{is_ready, raw};
use super::session::Session;
use crate::text;

/// Minimum and maximum number of set-points of a session.
const SET_POINTS: (u32, u32) = (10, 50);

/// Timeout for the arm to come to rest, and for the controller to enter servo mode.
const ENTER: Duration = Duration::from_secs(1);

/// Longer than any session: its set-points need no answers.
const LONG: Duration = Duration::from_secs(60);

/// Maximum number of queries of the arm's position until it is at rest: two each 100 ms.
const QUESTIONS: usize = 30;

/// The command that leaves servo mode.
pub(super) const LEAVE: SetServoMode = SetServoMode::new(Switch::Off);

/// A command, its fate, and the maximum number of times that it may have been sent in a row.
type Sent = (String, Fate, usize);

/// Commands of a session in the order of sending, and its result; a dropped session has no report.
#[derive(Debug)]
struct Outcome {
    sent: Vec<Sent>,
    result: Result<Option<Report>, Error>,
}

/// A session of some set-points, each with a number. In every other one set-points may be unanswered for as long as it
/// lasts.
pub(super) fn servo_session(arm: &mut Arm, session: &mut Session) {
    if !is_ready(arm, session) {
        return;
    }
    let servo = ServoConfig::new().enter_timeout(ENTER);
    let servo = if arm.random.one_in(2) { servo.max_unanswered(LONG) } else { servo };
    let config = SessionConfig::new().servo(servo).unchecked();
    let outcome = match session.robot.enter_servo_mode(&config) {
        Ok(servo) => go_through(arm, servo),
        Err(error) => Outcome { sent: not_entered(&error), result: Err(error) },
    };
    note(&mut session.connection, outcome.sent);
    arm.tally.one(ended(&outcome.result));
    session.silent = if outcome.result.is_ok() { 0 } else { session.silent + 1 };
    see_that_it_was_left(arm, session, &outcome.result);
}

fn note(connection: &mut Connection, sent: Vec<Sent>) {
    for (text, fate, most) in sent {
        connection.note_repeated(text, fate, most);
    }
}

fn ended(result: &Result<Option<Report>, Error>) -> &'static str {
    match result.as_ref().map_err(Error::kind) {
        Ok(Some(_)) => "servo sessions finished",
        Ok(None) => "servo sessions dropped",
        Err(ErrorKind::ServoModeNotLeft { .. }) => "servo sessions not left",
        Err(ErrorKind::SetPointsUnanswered { .. }) => "servo sessions without answers",
        Err(ErrorKind::StatusUnknown { .. }) => "servo sessions without status",
        Err(_) => "servo sessions failed",
    }
}

/// A session that does not say otherwise has left servo mode.
fn see_that_it_was_left(arm: &mut Arm, session: &mut Session, result: &Result<Option<Report>, Error>) {
    // One that was dropped says nothing.
    arm.in_servo_mode =
        matches!(result.as_ref().map_err(Error::kind), Ok(None) | Err(ErrorKind::ServoModeNotLeft { .. }));
    if arm.in_servo_mode {
        return;
    }
    let reply = raw(arm, session, IsInServomove::INFO.name, json!({})).map(|reply| reply.to_string());
    match reply.map(|reply| read_payload::<IsInServomoveReply>(IsInServomove::INFO, &reply)) {
        Some(Ok(reply)) if !reply.in_servo_mode => {}
        Some(reply) => arm.find(&format!("servo mode was not left, after {result:?}: {reply:?}")),
        None => arm.in_servo_mode = true,
    }
}

/// Queries of the joint position, which check that the arm is at rest before servo mode is requested.
fn asking() -> Sent {
    (text(&GetJointPos::new()), Fate::Perhaps, QUESTIONS)
}

/// Query that checks if servo mode is on already.
fn is_on() -> Sent {
    (text(&IsInServomove::new()), Fate::Perhaps, 1)
}

/// Commands at the start of a session.
fn entering(switched: Fate, entered: Fate) -> Vec<Sent> {
    vec![
        asking(),
        is_on(),
        (text(&SetServoMode::new(Switch::On)), switched, 1),
        (text(&IsInServomove::new()), entered, usize::MAX),
        (text(&GetJointPos::new()), entered, 1),
        (text(&GetTcpPos::new()), entered, 1),
    ]
}

/// Commands at the end of a session. A query confirms that servo mode was left. After a refusal the session may query
/// the robot state to explain it.
fn leaving(fate: Fate) -> [Sent; 3] {
    let state = (text(&GetRobotState::new()), Fate::Perhaps, 1);
    [(text(&LEAVE), fate, 1), (text(&IsInServomove::new()), fate, usize::MAX), state]
}

/// Commands of a session that did not begin.
fn not_entered(error: &Error) -> Vec<Sent> {
    // These are asked for before servo mode and in it.
    let is_asked_before = |command: &str| [GetJointPos::INFO.name, IsInServomove::INFO.name].contains(&command);
    let kind = match error.kind() {
        ErrorKind::NotSent { because, .. } => because.kind(),
        kind => kind,
    };
    let command = match kind {
        ErrorKind::Connection(error) => unanswered(error),
        ErrorKind::Refused { refusal, .. } => Some(&*refusal.command),
        _ => None,
    };
    let (switched, left) = match error.kind() {
        ErrorKind::ServoModeNotLeft { .. } => (Fate::Sent, Fate::Perhaps),
        _ if command.is_some_and(is_asked_before) => (Fate::Perhaps, Fate::Perhaps),
        // Of the first command there is nothing to leave, of the others there is.
        ErrorKind::Refused { .. } => (Fate::Seen, Fate::Perhaps),
        ErrorKind::NotReady { explanation: Explanation::ServoModeNotEntered, .. } => (Fate::Seen, Fate::Seen),
        _ if command.is_some() => (Fate::Seen, Fate::Seen),
        // Servo mode was not asked for: the arm moves, the status is not known, somebody must look first, or the
        // connection is broken.
        _ => return vec![asking(), is_on()],
    };
    entering(switched, Fate::Perhaps).into_iter().chain(leaving(left)).collect()
}

/// Command that has no reply, or one that does not fit.
fn unanswered(error: &jaka_sync::Error) -> Option<&str> {
    match error.kind() {
        Failure::Timeout { command, .. }
        | Failure::ReplyLost { command }
        | Failure::UnexpectedReply { command, .. } => Some(command),
        _ => None,
    }
}

fn go_through(arm: &mut Arm, mut servo: ServoSession<'_>) -> Outcome {
    let mut sent = entering(Fate::Seen, Fate::Seen);
    let count = SET_POINTS.0 + arm.random.below(SET_POINTS.1 - SET_POINTS.0);
    let before = sent.len();
    let mut failed = None;
    for at in 0..count {
        let step = if at % 2 == 0 { 0.04 } else { -0.04 };
        let offset = [step, 0.0, 0.0, 0.0, 0.0, f64::from(arm.serial()) * 1e-7];
        let result = servo.send_joint_offset(offset);
        let command = ServoJ::relative(offset).step_count(1);
        sent.push((text(&command), set_point(&result), 1));
        failed = result.err();
        if failed.is_some() {
            break;
        }
    }
    let set_points = sent[before..].iter().filter(|(_, fate, _)| *fate == Fate::Sent).count();
    if set_points > 0 {
        // So slow an arm need not be braked, only held.
        sent.push((text(&ServoJ::relative([0.0; 6]).step_count(1)), Fate::Perhaps, usize::MAX));
    }
    arm.tally.add("set-points", u64::try_from(set_points).unwrap_or_default());
    let finished = if arm.random.one_in(4) { None } else { Some(servo.land().map(|end| end.report)) };
    let (result, left) = leave(failed, finished);
    if let Ok(Some(report)) = &result {
        check(arm, report, set_points);
    }
    sent.extend(leaving(left));
    Outcome { sent, result }
}

/// Fate of a set-point, by the result of its call.
fn set_point(result: &Result<(), Error>) -> Fate {
    let Err(error) = result else { return Fate::Sent };
    let error = match error.kind() {
        ErrorKind::ServoModeNotLeft { first: Some(first), .. } | ErrorKind::RestNotSeen { first: Some(first), .. } => {
            first
        }
        _ => error,
    };
    match error.kind() {
        // Those before it are meant.
        ErrorKind::SetPointsUnanswered { .. } => Fate::NotSent,
        _ if error.may_have_run() => Fate::Perhaps,
        _ => Fate::NotSent,
    }
}

/// Result of a session, by its first error and by the result of its landing, if it landed; with the fate of the command
/// that leaves servo mode.
fn leave(failed: Option<Error>, finished: Option<Result<Report, Error>>) -> (Result<Option<Report>, Error>, Fate) {
    let known = |error: &Error| {
        if matches!(error.kind(), ErrorKind::ServoModeNotLeft { .. }) { Fate::Perhaps } else { Fate::Seen }
    };
    match (failed, finished) {
        (_, Some(Ok(report))) => (Ok(Some(report)), Fate::Seen),
        // It ended with its first error, or fails now.
        (failed, Some(Err(error))) => {
            let had_ended = matches!(error.kind(), ErrorKind::SessionEnded { .. });
            let error = failed.filter(|_| had_ended).unwrap_or(error);
            let left = known(&error);
            (Err(error), left)
        }
        // It ends when it is dropped, or has ended before.
        (_, None) => (Ok(None), Fate::Perhaps),
    }
}

fn check(arm: &mut Arm, report: &Report, sent: usize) {
    let answers = report.accepted + report.refused + report.unanswered;
    if report.cycles + report.landing_cycles != answers || usize::try_from(report.cycles) != Ok(sent) {
        arm.find(&format!("of {sent} set-points, {report:?}"));
    }
    arm.tally.add("set-points accepted", report.accepted);
    arm.tally.add("set-points unanswered", report.unanswered);
}
