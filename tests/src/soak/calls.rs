//! Operations of an arm's program.

use std::time::Duration;

use jaka_proto::read_payload;
use jaka_robot::io::GetFuncdiStatus;
use jaka_robot::kinematics::{GetDhParam, GetJointPos, GetJointPosReply, KineForward};
use jaka_robot::motion::JointMove;
use jaka_robot::payload::{Centroid, GetPayload, GetPayloadReply, SetPayload};
use jaka_robot::power::{GetRobotState, GetVersion};
use jaka_robot::program::{LoadProgram, SetRapidRate};
use jaka_robot::servo::SetServoMode;
use jaka_robot::types::JointPosition;
use jaka_robot::variables::{ModifyUserDefinedVariable, QueryUserDefinedVariable};
use jaka_robot::{Cause, Command, End, Error, Evidence};
use serde_json::{Value, json};

use super::account::Fate;
use super::arm::Arm;
use super::faults;
use super::servo::{LEAVE, servo_session};
use super::session::Session;
use crate::text;

/// The first command of each connection.
pub(super) const FIRST: &str = GetRobotState::INFO.name;

/// Timeout for a motion, its reply included.
const MOTION: Duration = Duration::from_secs(1);

/// The shortest time between two questions where the arm is.
const QUESTION_PERIOD: Duration = Duration::from_millis(100);

/// Timeout for a status packet that shows a new setting, long enough for a slow machine.
const SHOWN: Duration = Duration::from_secs(120);

/// The variable that a controller has from the start.
const VARIABLE: i64 = 5500;

/// Largest distance of a joint from a reached target, in degrees.
const CLOSE: f64 = 0.1;

/// The tool's turn about the vertical where joint 1 is at 0, in degrees, of the simulator's arm.
const UPRIGHT: f64 = 90.0;

type Operation = fn(&mut Arm, &mut Session);

/// Operations with their relative frequencies.
const OPERATIONS: [(u32, Operation); 14] = [
    (16, forward_kinematics),
    (12, set_mass),
    (12, get_mass),
    (4, get_mass_as_text),
    (6, set_variable),
    (6, get_variable),
    (6, raw_query),
    (3, unknown),
    (4, refused),
    (4, once),
    (10, motion),
    (6, servo_session),
    (4, change_status_fault),
    (4, status_follows),
];

/// Does one thing, while other threads may stop the arm.
pub(super) fn one(arm: &mut Arm, session: &mut Session) {
    for hand in &session.hands {
        if arm.random.one_in(9) {
            hand.go();
        }
    }
    let all = OPERATIONS.iter().map(|(weight, _)| weight).sum();
    let mut place = arm.random.below(all);
    for (weight, operation) in OPERATIONS {
        if place < weight {
            return operation(arm, session);
        }
        place -= weight;
    }
}

/// A typed call, noted.
fn call<C: Command>(arm: &mut Arm, session: &mut Session, command: &C) -> Result<C::Reply, Error> {
    let timeout = session.robot.client().reply_timeout();
    let result = session.robot.client().call_within(command, timeout).map_err(Error::from);
    arm.note(session, text(command), &result);
    result
}

/// Some queries of one name in a row, each of which has an answer of its own: the tool turns about the vertical as
/// joint 1 does.
fn forward_kinematics(arm: &mut Arm, session: &mut Session) {
    for _ in 0..3 {
        let angle = f64::from(arm.serial() % 34_000) / 100.0 - 170.0;
        let joint_position = [angle, 90.0, 90.0, 90.0, -90.0, 0.0];
        let Ok(reply) = call(arm, session, &KineForward::new(joint_position)) else { continue };
        let off = (reply.pose.rz - angle - UPRIGHT).rem_euclid(360.0);
        if off.min(360.0 - off) > 1e-6 {
            arm.find(&format!("a reply to another query: at {angle} the tool is at {:?}", reply.pose));
        }
    }
}

fn set_mass(arm: &mut Arm, session: &mut Session) {
    let mass = f64::from(arm.serial());
    let result = call(arm, session, &SetPayload::new(mass, Centroid { x: 1.5, y: -2.0, z: mass }));
    arm.mass.set(mass, Fate::of(&result));
}

fn get_mass(arm: &mut Arm, session: &mut Session) {
    if let Ok(reply) = call(arm, session, &GetPayload::new()) {
        check_mass(arm, &reply);
    }
}

fn get_mass_as_text(arm: &mut Arm, session: &mut Session) {
    let (_, text) = arm.numbered(GetPayload::INFO.name, json!({}));
    let timeout = session.robot.client().reply_timeout();
    let result = session.robot.client().call_text(&text, timeout).map(str::to_owned);
    let result = result.map_err(Error::from);
    arm.note(session, text, &result);
    if let Ok(reply) = result {
        match read_payload::<GetPayloadReply>(GetPayload::INFO, &reply) {
            Ok(reply) => check_mass(arm, &reply),
            Err(error) => arm.find(&format!("the reply to a query is {reply}: {error}")),
        }
    }
}

fn check_mass(arm: &mut Arm, reply: &GetPayloadReply) {
    if let Err(finding) = arm.mass.read(reply.mass) {
        arm.find(&format!("a reply to another query: {finding}"));
    }
}

fn set_variable(arm: &mut Arm, session: &mut Session) {
    let value = f64::from(arm.serial());
    let result = call(arm, session, &ModifyUserDefinedVariable::new(VARIABLE, "soak", value));
    arm.variable.set(value, Fate::of(&result));
}

fn get_variable(arm: &mut Arm, session: &mut Session) {
    let Ok(reply) = call(arm, session, &QueryUserDefinedVariable::new()) else { return };
    let value = reply.variables.iter().find(|variable| variable.id == VARIABLE).map(|variable| variable.value);
    if let Err(finding) = arm.variable.read(value.unwrap_or(f64::NAN)) {
        arm.find(&format!("a reply to another query: {finding}"));
    }
}

fn raw_query(arm: &mut Arm, session: &mut Session) {
    let name = GetJointPos::INFO.name;
    let reply = raw(arm, session, name, json!({}));
    if let Some(reply) = reply.filter(|reply| reply["cmdName"].as_str().map(str::trim) != Some(name)) {
        arm.find(&format!("the reply to {name} is {reply}"));
    }
}

/// A command that no controller knows, whose refusal names none.
fn unknown(arm: &mut Arm, session: &mut Session) {
    if let Some(reply) = raw(arm, session, "soak", json!({})) {
        arm.find(&format!("the reply to a command that there is not is {reply}"));
    }
}

/// A raw call with a number, so that no other has its text. Its reply, if it has one.
pub(super) fn raw(arm: &mut Arm, session: &mut Session, name: &str, parameters: Value) -> Option<Value> {
    let (parameters, text) = arm.numbered(name, parameters);
    let result = session.robot.client().call_raw(name, &parameters).map_err(Error::from);
    arm.note(session, text, &result);
    result.ok()
}

/// A command that the controller refuses.
fn refused(arm: &mut Arm, session: &mut Session) {
    let command = LoadProgram::new(format!("soak-{}.jks", arm.serial()));
    if call(arm, session, &command).is_ok() {
        arm.find("a refusal was taken for success");
    }
}

/// A query that the connection has not seen yet.
fn once(arm: &mut Arm, session: &mut Session) {
    session.once += 1;
    match session.once {
        1 => drop(call(arm, session, &GetVersion::new())),
        2 => drop(call(arm, session, &GetDhParam::new())),
        3 => drop(call(arm, session, &GetFuncdiStatus::new())),
        _ => get_mass(arm, session),
    }
}

/// A motion to where the arm has never been.
fn motion(arm: &mut Arm, session: &mut Session) {
    if !is_ready(arm, session) {
        return;
    }
    let angle = f64::from(arm.random.below(7)) - 3.0;
    let target = [angle, 90.0, 90.0, 90.0, -90.0, f64::from(arm.serial()) / 1000.0].into();
    let command = JointMove::absolute(target, 170.0).acceleration(700.0);
    let result = session.robot.run(&command, MOTION);
    // After a stop the robot first asks whether the arm is at rest.
    session.connection.note_repeated(text(&GetJointPos::new()), Fate::Perhaps, usize::MAX);
    arm.note(session, text(&command), &result);
    match result {
        Ok(end) => {
            note_questions(session, &end);
            check_end(arm, session, &end, target);
        }
        // A refusal is explained by the robot's state, if the controller tells it.
        Err(error) if error.is_refused() => session.connection.note(text(&GetRobotState::new()), Fate::Perhaps),
        Err(_) => {}
    }
}

/// While a motion is waited for, the robot asks where the arm is, from time to time; what has been reached was
/// answered.
fn note_questions(session: &mut Session, end: &End) {
    let fate = if end.cause() == Cause::Reached { Fate::Seen } else { Fate::Perhaps };
    // The first at once, and one where the times are not exact.
    let most = end.report.waited.as_millis() / QUESTION_PERIOD.as_millis() + 2;
    session.connection.note_repeated(text(&GetJointPos::new()), fate, usize::try_from(most).unwrap_or(usize::MAX));
    if matches!(end.evidence(), Evidence::Status { .. } | Evidence::Commands { .. }) {
        // Which of them it is is settled by a question.
        session.connection.note(text(&GetRobotState::new()), Fate::Perhaps);
    }
}

fn check_end(arm: &mut Arm, session: &mut Session, end: &End, target: JointPosition) {
    arm.tally.one(ended(end.cause()));
    match end.cause() {
        Cause::Reached => {
            let reply = raw(arm, session, GetJointPos::INFO.name, json!({})).map(|reply| reply.to_string());
            let reply = reply.map(|reply| read_payload::<GetJointPosReply>(GetJointPos::INFO, &reply));
            match reply {
                Some(Ok(reply)) => check_position(arm, target, reply.joint_position),
                Some(Err(error)) => arm.find(&format!("a position that cannot be read: {error}")),
                None => {}
            }
        }
        Cause::AtRest if end.error.is_none() => {
            arm.find(&format!("the target of a motion is known, and its end is said to be unknown: {end:?}"));
        }
        Cause::NoMotion => arm.find("a motion was accepted, and there is said to be none"),
        _ => {}
    }
}

fn check_position(arm: &mut Arm, target: JointPosition, found: JointPosition) {
    let is_there = target.0.iter().zip(found.0).all(|(target, at)| (target - at).abs() <= CLOSE + 1e-9);
    if !is_there {
        arm.find(&format!("a motion is said to have reached {target:?}, and the arm is at {found:?}"));
    }
}

fn ended(cause: Cause) -> &'static str {
    match cause {
        Cause::Reached => "motions reached",
        Cause::AtRest => "motions at rest somewhere",
        Cause::Stopped => "motions stopped",
        Cause::Deadline => "motions at their deadline",
        Cause::StatusLost => "motions without status",
        Cause::CommandsLost => "motions without connection",
        _ => "motions ended otherwise",
    }
}

/// Acknowledges what latched, and leaves servo mode, where a session may not have.
pub(super) fn is_ready(arm: &mut Arm, session: &mut Session) -> bool {
    session.robot.acknowledge();
    if arm.in_servo_mode {
        let off: Value = serde_json::from_str(&text(&LEAVE)).expect("requests are JSON");
        arm.in_servo_mode = raw(arm, session, SetServoMode::INFO.name, off).is_none();
    }
    !arm.in_servo_mode
}

/// Sets what is wrong with the status port from now on.
fn change_status_fault(arm: &mut Arm, _: &mut Session) {
    let faults = faults::of_status();
    let fault = arm.random.below(u32::try_from(faults.len()).unwrap_or(1)) as usize;
    arm.place.host.status_fault(arm.place.arm, fault);
    arm.fault(&format!("status {}", faults::kind(&faults[fault])));
}

/// Checks that the packets of a status port without faults show a new setting.
fn status_follows(arm: &mut Arm, session: &mut Session) {
    arm.place.host.status_fault(arm.place.arm, 0);
    let rate = arm.place.rate.next();
    if call(arm, session, &SetRapidRate::new(rate)).is_err() {
        return;
    }
    match session.robot.monitor().wait_until(|status| status.rapid_rate == Some(rate), SHOWN) {
        Ok(_) => arm.tally.one("settings seen in the status"),
        Err(error) => arm.find(&format!("no packet shows the rate {rate}: {error:?}")),
    }
}
