//! States and settings of the controller, by queries.

use jaka_proto::messages::collision::{GetClsnSensitivity, ProtectiveStopStatus};
use jaka_proto::messages::force::DragStatus;
use jaka_proto::messages::frames::{GetToolOffsets, GetUserOffsets};
use jaka_proto::messages::payload::GetPayload;
use jaka_proto::messages::power::GetRobotState;
use jaka_proto::messages::program::{GetProgramState, ProgramState};
use jaka_proto::messages::servo::IsInServomove;
use jaka_proto::messages::status::RobotStatus;
use jaka_proto::messages::types::Pose;

use super::commands::Commands;
use super::finding::{CheckItem, Finding, Judgement, Verdict, either};
use super::packets::not_shown;

/// The collision levels that firmware has: 5 in the document, 7 on newer firmware (field notes).
const COLLISION_LEVELS: std::ops::RangeInclusive<i64> = 1..=7;

const LEAVE_SERVO_MODE: &str =
    "other motions are refused: leave it with `set_servo_mode`, if no other program needs it";
const LEAVE_DRAG_MODE: &str = "a hand can move the arm: switch it off at the pendant or at the arm";

/// Asks for all of them.
pub(super) fn read(commands: &mut Commands<'_>, packet: Option<&RobotStatus>, findings: &mut Vec<Finding>) {
    let [power, enabled] = power(commands, packet);
    findings.extend([
        power.at(CheckItem::Power),
        enabled.at(CheckItem::Enabled),
        protective_stop(commands, packet).at(CheckItem::ProtectiveStop),
        commands
            .judge(&IsInServomove::new(), |reply| off(reply.in_servo_mode, LEAVE_SERVO_MODE))
            .at(CheckItem::ServoMode),
        commands.judge(&DragStatus::new(), |reply| off(reply.drag_status, LEAVE_DRAG_MODE)).at(CheckItem::DragMode),
        commands.judge(&GetProgramState::new(), |reply| program(&reply.program_state, packet)).at(CheckItem::Program),
    ]);
    let tool = packet.and_then(|packet| packet.current_tool_id).ok_or_else(|| not_shown(packet));
    let tool = tool.and_then(|id| {
        let offsets = || commands.ask(&GetToolOffsets::new()).map(|reply| reply.offsets);
        frame(id, "the centre of the flange", offsets)
    });
    let user = packet.and_then(|packet| packet.current_user_frame_id).ok_or_else(|| not_shown(packet));
    let user = user.and_then(|id| {
        let offsets = || commands.ask(&GetUserOffsets::new()).map(|reply| reply.offsets);
        frame(id, "the robot's base", offsets)
    });
    findings.extend([
        either(tool).at(CheckItem::ToolFrame),
        either(user).at(CheckItem::UserFrame),
        commands.judge(&GetPayload::new(), |reply| payload(reply.mass)).at(CheckItem::Payload),
        commands.judge(&GetClsnSensitivity::new(), |reply| collision_level(reply.level)).at(CheckItem::CollisionLevel),
    ]);
}

/// Power and enabling: an emergency stop ends enabling, and so does a lack of power, which is then the only finding.
fn power(commands: &mut Commands<'_>, packet: Option<&RobotStatus>) -> [Judgement; 2] {
    let answer = commands.ask(&GetRobotState::new());
    let (powered, enabled, failed) = match answer {
        Ok(state) => (Some(state.powered_on), Some(state.enabled), None),
        Err(failed) => {
            let shown = packet.map(|packet| (packet.powered_on, packet.enabled)).unwrap_or_default();
            (shown.0, shown.1, Some(failed).filter(|failed| failed.verdict > Verdict::NotChecked))
        }
    };
    let stopped = packet.is_some_and(|packet| packet.emergency_stop == Some(true));
    let power = failed.unwrap_or_else(|| match powered {
        Some(true) => Judgement::nothing("the arm has power"),
        Some(false) if stopped => Judgement::not_checked("off, in an emergency stop"),
        Some(false) => Judgement::look("the arm has no power", "switch it on: `power_on`"),
        None => not_shown(packet),
    });
    let enabled = match enabled {
        Some(true) => Judgement::nothing("the arm is enabled"),
        Some(false) if stopped || powered == Some(false) => {
            let why = if stopped { "not enabled, in an emergency stop" } else { "not enabled, without power" };
            Judgement::not_checked(why)
        }
        Some(false) => Judgement::look("the arm is not enabled", "enable it: `enable_robot`"),
        None => not_shown(packet),
    };
    [power, enabled]
}

/// The stop counts if the controller or a packet says so.
fn protective_stop(commands: &mut Commands<'_>, packet: Option<&RobotStatus>) -> Judgement {
    let answer = commands.ask(&ProtectiveStopStatus::new()).map(|reply| reply.protective_stop);
    let shown = packet.and_then(|packet| packet.protective_stop);
    match (answer, shown) {
        (Ok(true), _) | (_, Some(true)) => Judgement::wrong(
            "the robot is in a protective stop",
            "find the obstacle, free the arm, and call `clear_error`",
        ),
        (Ok(false), _) => Judgement::nothing("not active"),
        (Err(failed), Some(false)) if failed.verdict == Verdict::NotChecked => Judgement::nothing("not active"),
        (Err(failed), _) => failed,
    }
}

/// A mode that keeps motions of a program from the arm.
fn off(is_on: bool, leave: &str) -> Judgement {
    if is_on { Judgement::look("on", leave) } else { Judgement::nothing("off") }
}

fn program(state: &ProgramState, packet: Option<&RobotStatus>) -> Judgement {
    let paused = packet.is_some_and(|packet| packet.paused == Some(true));
    match state {
        ProgramState::Idle if !paused => Judgement::nothing("no program runs"),
        ProgramState::Running => {
            Judgement::look("a program runs", "it may move the arm: stop it first, or wait for its end")
        }
        ProgramState::Idle | ProgramState::Paused => Judgement::look(
            "a program is paused",
            "it may move the arm when somebody resumes it: `stop_program` ends it",
        ),
        other => Judgement::look(format!("unknown state {:?}", other.as_ref()), "look at the pendant"),
    }
}

/// The selected frame, with its offset from the controller if it can have one.
fn frame(id: i64, fixed: &str, offsets: impl FnOnce() -> Result<Vec<Pose>, Judgement>) -> Result<Judgement, Judgement> {
    if id == 0 {
        return Ok(Judgement::nothing(format!("0, {fixed}")));
    }
    let offsets = offsets()?;
    let Some(offset) = usize::try_from(id).ok().and_then(|id| offsets.get(id)) else {
        let advice = "look at its offset at the pendant: poses refer to this frame";
        return Ok(Judgement::look(format!("{id}, without an offset from the controller"), advice));
    };
    if <[f64; 6]>::from(*offset).iter().all(|part| *part == 0.0) {
        let advice = "it is the same as frame 0: set its offset, or select frame 0";
        return Ok(Judgement::look(format!("{id}, with an offset of zero"), advice));
    }
    Ok(Judgement::nothing(format!("{id}, offset {offset}")))
}

fn payload(mass: f64) -> Judgement {
    let seen = format!("{mass} kg");
    if mass > 0.0 {
        return Judgement::nothing(seen);
    }
    let advice = "set the load of the arm with the gripper: `set_payload`";
    Judgement::look(seen, advice)
}

fn collision_level(level: i64) -> Judgement {
    match level {
        0 => Judgement::look("0: collision detection is off", "switch it on: `set_clsn_sensitivity`"),
        level if COLLISION_LEVELS.contains(&level) => Judgement::nothing(level.to_string()),
        level => Judgement::look(format!("unknown level {level}"), "look at the pendant"),
    }
}
