//! What queries tell: states and settings.

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
use super::finding::{CheckItem, Finding, Verdict};
use super::packets::not_shown;

/// The collision levels that firmware has: 5 in the document, 7 on newer firmware (field notes).
const COLLISION_LEVELS: std::ops::RangeInclusive<i64> = 1..=7;

/// Asks for all of them.
pub(super) fn read(commands: &mut Commands<'_>, packet: Option<&RobotStatus>, findings: &mut Vec<Finding>) {
    findings.extend(power(commands, packet));
    findings.push(protective_stop(commands, packet));
    findings.push(commands.judge(CheckItem::ServoMode, &IsInServomove::new(), |reply| servo_mode(reply.in_servo_mode)));
    findings.push(commands.judge(CheckItem::DragMode, &DragStatus::new(), |reply| drag_mode(reply.drag_status)));
    findings.push(
        commands.judge(CheckItem::Program, &GetProgramState::new(), |reply| program(&reply.program_state, packet)),
    );
    let tool = packet.and_then(|packet| packet.current_tool_id);
    findings.push(tool.map_or_else(
        || not_shown(CheckItem::ToolFrame, packet),
        |id| {
            let offsets = || commands.ask(CheckItem::ToolFrame, &GetToolOffsets::new()).map(|reply| reply.offsets);
            frame(CheckItem::ToolFrame, id, "the centre of the flange", offsets)
        },
    ));
    let user = packet.and_then(|packet| packet.current_user_frame_id);
    findings.push(user.map_or_else(
        || not_shown(CheckItem::UserFrame, packet),
        |id| {
            let offsets = || commands.ask(CheckItem::UserFrame, &GetUserOffsets::new()).map(|reply| reply.offsets);
            frame(CheckItem::UserFrame, id, "the robot's base", offsets)
        },
    ));
    findings.push(commands.judge(CheckItem::Payload, &GetPayload::new(), |reply| payload(reply.mass)));
    findings.push(
        commands.judge(CheckItem::CollisionLevel, &GetClsnSensitivity::new(), |reply| collision_level(reply.level)),
    );
}

/// Power and enabling: an emergency stop ends enabling, and so does a lack of power, which is then the only finding.
fn power(commands: &mut Commands<'_>, packet: Option<&RobotStatus>) -> [Finding; 2] {
    let answer = commands.ask(CheckItem::Power, &GetRobotState::new());
    let (powered, enabled, failed) = match answer {
        Ok(state) => (Some(state.powered_on), Some(state.enabled), None),
        Err(failed) => {
            let shown = packet.map(|packet| (packet.powered_on, packet.enabled)).unwrap_or_default();
            (shown.0, shown.1, Some(failed).filter(|failed| failed.verdict() > Verdict::NotChecked))
        }
    };
    let stopped = packet.is_some_and(|packet| packet.emergency_stop == Some(true));
    let power = failed.unwrap_or_else(|| match powered {
        Some(true) => Finding::nothing(CheckItem::Power, "the arm has power"),
        Some(false) if stopped => Finding::not_checked(CheckItem::Power, "off, in an emergency stop"),
        Some(false) => Finding::look(CheckItem::Power, "the arm has no power", "switch it on: `power_on`"),
        None => not_shown(CheckItem::Power, packet),
    });
    let enabled = match enabled {
        Some(true) => Finding::nothing(CheckItem::Enabled, "the arm is enabled"),
        Some(false) if stopped || powered == Some(false) => {
            let why = if stopped { "not enabled, in an emergency stop" } else { "not enabled, without power" };
            Finding::not_checked(CheckItem::Enabled, why)
        }
        Some(false) => Finding::look(CheckItem::Enabled, "the arm is not enabled", "enable it: `enable_robot`"),
        None => not_shown(CheckItem::Enabled, packet),
    };
    [power, enabled]
}

/// The stop counts if the controller or a packet says so.
fn protective_stop(commands: &mut Commands<'_>, packet: Option<&RobotStatus>) -> Finding {
    const ITEM: CheckItem = CheckItem::ProtectiveStop;
    let answer = commands.ask(ITEM, &ProtectiveStopStatus::new()).map(|reply| reply.protective_stop);
    let shown = packet.and_then(|packet| packet.protective_stop);
    match (answer, shown) {
        (Ok(true), _) | (_, Some(true)) => Finding::wrong(
            ITEM,
            "the robot is in a protective stop",
            "find out what the arm has hit, free it, and call `clear_error`",
        ),
        (Ok(false), _) => Finding::nothing(ITEM, "not in one"),
        (Err(failed), Some(false)) if failed.verdict() == Verdict::NotChecked => Finding::nothing(ITEM, "not in one"),
        (Err(failed), _) => failed,
    }
}

fn servo_mode(is_on: bool) -> Finding {
    if is_on {
        let advice = "other motions are refused: leave it with `set_servo_mode`, if no other program needs it";
        return Finding::look(CheckItem::ServoMode, "on", advice);
    }
    Finding::nothing(CheckItem::ServoMode, "off")
}

fn drag_mode(is_on: bool) -> Finding {
    if is_on {
        return Finding::look(
            CheckItem::DragMode,
            "on",
            "the arm gives way to a hand: leave it at the pendant or the arm",
        );
    }
    Finding::nothing(CheckItem::DragMode, "off")
}

fn program(state: &ProgramState, packet: Option<&RobotStatus>) -> Finding {
    const ITEM: CheckItem = CheckItem::Program;
    let paused = packet.is_some_and(|packet| packet.paused == Some(true));
    match state {
        ProgramState::Idle if !paused => Finding::nothing(ITEM, "none runs"),
        ProgramState::Running => {
            Finding::look(ITEM, "a program runs", "the arm moves by it: stop it first, or let it end")
        }
        ProgramState::Idle | ProgramState::Paused => Finding::look(
            ITEM,
            "a program is paused",
            "it moves the arm when somebody resumes it: `stop_program` ends it",
        ),
        other => {
            Finding::look(ITEM, format!("the state is {:?}, which is not known", other.as_ref()), "look at the pendant")
        }
    }
}

/// The selected frame; the controller is asked for its offset if it can have one.
fn frame(item: CheckItem, id: i64, fixed: &str, offsets: impl FnOnce() -> Result<Vec<Pose>, Finding>) -> Finding {
    if id == 0 {
        return Finding::nothing(item, format!("0, {fixed}"));
    }
    let offsets = match offsets() {
        Ok(offsets) => offsets,
        Err(failed) => return failed,
    };
    let Some(offset) = usize::try_from(id).ok().and_then(|id| offsets.get(id)) else {
        let advice = "look at its offset at the pendant: poses are of this frame";
        return Finding::look(item, format!("{id}, of which the controller tells no offset"), advice);
    };
    if <[f64; 6]>::from(*offset).iter().all(|part| *part == 0.0) {
        let advice = "it is the same as frame 0: set its offset, or select frame 0";
        return Finding::look(item, format!("{id}, with an offset of zero"), advice);
    }
    Finding::nothing(item, format!("{id}, offset {offset}"))
}

fn payload(mass: f64) -> Finding {
    let seen = format!("{mass} kg");
    if mass > 0.0 {
        return Finding::nothing(CheckItem::Payload, seen);
    }
    let advice = "set what the arm carries, the gripper included: `set_payload`";
    Finding::look(CheckItem::Payload, seen, advice)
}

fn collision_level(level: i64) -> Finding {
    const ITEM: CheckItem = CheckItem::CollisionLevel;
    match level {
        0 => Finding::look(ITEM, "0: collision detection is off", "switch it on: `set_clsn_sensitivity`"),
        level if COLLISION_LEVELS.contains(&level) => Finding::nothing(ITEM, level.to_string()),
        level => Finding::look(ITEM, format!("{level}, which is not known"), "look at the pendant"),
    }
}
