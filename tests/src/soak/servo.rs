//! Servo sessions.

use jaka_sync::kinematics::GetJointPos;
use jaka_sync::servo::{IsInServomove, ServoJ, ServoMove};
use jaka_sync::types::{MoveMode, Switch};
use jaka_sync::{Error, ServoConfig, ServoReport, ServoSession};

use super::account::Fate;
use super::arm::{Arm, text};
use super::calls::is_ready;
use super::session::Session;

/// How many set-points a session has at least, and at most.
const SET_POINTS: (u32, u32) = (10, 50);

/// The command that leaves servo mode.
pub(super) const LEAVE: ServoMove = ServoMove { servo_mode: Switch::Off };

/// What was sent, in order, and what it ended with; no report from a session that was dropped.
#[derive(Debug)]
struct Outcome {
    sent: Vec<(String, Fate)>,
    result: Result<Option<ServoReport>, Error>,
}

/// A session of some set-points, each with a number.
pub(super) fn servo_session(arm: &mut Arm, session: &mut Session) {
    if !is_ready(arm, session) {
        return;
    }
    let outcome = match session.robot.servo(&ServoConfig::new().max_unanswered(std::time::Duration::from_secs(30))) {
        Ok(servo) => go_through(arm, servo),
        Err(error) => not_entered(error),
    };
    let repeated = text(&IsInServomove);
    for (text, fate) in outcome.sent {
        if text == repeated {
            session.connection.note_repeated(text, fate);
        } else {
            session.connection.note(text, fate);
        }
    }
    arm.in_servo_mode = !matches!(outcome.result, Ok(Some(_)));
    arm.tally.one(match &outcome.result {
        Ok(Some(_)) => "servo sessions finished",
        Ok(None) => "servo sessions dropped",
        Err(_) => "servo sessions failed",
    });
    session.silent = if outcome.result.is_ok() { 0 } else { session.silent + 1 };
}

/// How the session began, and what it did.
fn commands(fate: Fate) -> Vec<(String, Fate)> {
    vec![(text(&GetJointPos), fate), (text(&ServoMove { servo_mode: Switch::On }), fate), (text(&IsInServomove), fate)]
}

fn not_entered(error: Error) -> Outcome {
    let mut sent = commands(Fate::Perhaps);
    match error {
        Error::NotAcknowledged { .. } => sent.clear(),
        // On a connection that works on, the first has gone out.
        _ if !error.is_disconnected() => sent[0].1 = Fate::Sent,
        _ => {}
    }
    if !sent.is_empty() {
        sent.push((text(&LEAVE), Fate::Perhaps));
    }
    Outcome { sent, result: Err(error) }
}

fn go_through(arm: &mut Arm, mut servo: ServoSession<'_>) -> Outcome {
    let mut sent = commands(Fate::Seen);
    let count = SET_POINTS.0 + arm.random.below(SET_POINTS.1 - SET_POINTS.0);
    let before = sent.len();
    for at in 0..count {
        let step = if at % 2 == 0 { 0.05 } else { -0.05 };
        let offset = [step, 0.0, 0.0, 0.0, 0.0, f64::from(arm.serial()) * 1e-7].into();
        let result = servo.joints_by(offset);
        let command = ServoJ { mode: MoveMode::Relative, joint_position: offset, step_count: Some(1) };
        let fate = match &result {
            Ok(()) => Fate::Sent,
            Err(error) if error.may_have_run() => Fate::Perhaps,
            Err(_) => Fate::NotSent,
        };
        sent.push((text(&command), fate));
        if result.is_err() {
            break;
        }
    }
    let set_points = sent[before..].iter().filter(|(_, fate)| *fate == Fate::Sent).count();
    arm.tally.add("set-points", u64::try_from(set_points).unwrap_or_default());
    let result = if arm.random.one_in(4) { Ok(None) } else { servo.finish().map(Some) };
    if let Ok(Some(report)) = &result {
        check(arm, report, set_points);
    }
    sent.push((text(&LEAVE), if matches!(result, Ok(Some(_))) { Fate::Seen } else { Fate::Perhaps }));
    Outcome { sent, result }
}

fn check(arm: &mut Arm, report: &ServoReport, sent: usize) {
    let answers = report.accepted + report.refused + report.unanswered;
    if report.cycles != answers || usize::try_from(report.cycles) != Ok(sent) {
        arm.find(&format!("of {sent} set-points, {report:?}"));
    }
    arm.tally.add("set-points accepted", report.accepted);
    arm.tally.add("set-points unanswered", report.unanswered);
}
