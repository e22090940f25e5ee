//! Servo mode.

use jaka_proto::Request;
use jaka_proto::messages::types::{JointPosition, MoveMode, Pose};

use super::{Draft, Outcome, is_on, reply};
use crate::motion::{Joints, Servo, SetPoint, Space, can_follow};
use crate::world::{Change, World};

pub(super) fn answer(request: &Request, world: &mut World, out: &mut Draft<'_>) -> Outcome {
    match request {
        Request::IsInServomove(command) => {
            return reply(command, out, |reply| reply.in_servo_mode = world.state.servo_mode);
        }
        // It is acknowledged, and servo mode is not entered.
        Request::SetServoMode(command)
            if world.habits.servo_at_rest && world.is_moving() && is_on(command.servo_mode) => {}
        Request::SetServoMode(command) => {
            world.cancel_changes(|change| matches!(change, Change::ServoMode(_)));
            world.later(world.delays.servo_mode, Change::ServoMode(is_on(command.servo_mode)));
        }
        Request::ServoJ(command) => {
            let target = joint_target(world, command.mode, command.joint_position);
            set_point(world, target, Space::Joints, command.step_count);
        }
        Request::ServoP(command) => match pose_target(world, command.mode, command.pose) {
            Some(target) => set_point(world, target, Space::Pose, command.step_count),
            None => return Outcome::Refused,
        },
        Request::SetServoMoveFilter(command) if !can_follow(command) => return Outcome::Refused,
        Request::SetServoMoveFilter(command) => world.state.servo_filter = *command,
        _ => return Outcome::Unhandled,
    }
    Outcome::Accepted
}

fn set_point(world: &mut World, target: Joints, space: Space, step_count: Option<i64>) {
    let cycles = step_count.and_then(|count| u32::try_from(count).ok()).unwrap_or(1);
    // A target beyond the soft limits has no effect, like one that is too fast.
    if !world.model.is_within_range(target) {
        return;
    }
    let time = world.now();
    if let Some(servo) = &mut world.engine.servo {
        servo.push(SetPoint { target, space, cycles, time });
    }
}

/// Where the set-points so far lead to.
fn tail(world: &World) -> Joints {
    world.engine.servo.as_ref().map_or(world.drives.commanded, Servo::tail)
}

fn joint_target(world: &World, mode: MoveMode, position: JointPosition) -> Joints {
    let last = tail(world);
    match mode {
        MoveMode::Relative => std::array::from_fn(|i| last[i] + position.0[i]),
        _ => position.0,
    }
}

fn pose_target(world: &World, mode: MoveMode, pose: Pose) -> Option<Joints> {
    let last = tail(world);
    let flange = match mode {
        MoveMode::Relative => world.displaced(world.model.forward(last), pose),
        _ => world.flange(pose),
    };
    world.model.inverse(flange, last).ok().map(Into::into)
}
