//! Servo mode.

use jaka_proto::Request;
use jaka_proto::messages::types::{JointPosition, MoveMode, Pose};

use super::{Draft, Outcome, is_on, reply};
use crate::motion::Joints;
use crate::world::{Change, World};

pub(super) fn answer(request: &Request, world: &mut World, out: &mut Draft<'_>) -> Outcome {
    match request {
        Request::IsInServomove(command) => {
            return reply(command, out, |reply| reply.in_servo_mode = world.state.servo_mode);
        }
        // It is acknowledged, and servo mode is not entered.
        Request::SetServoMode(command)
            if world.habits.servo_at_rest && world.engine.is_busy() && is_on(command.servo_mode) => {}
        Request::SetServoMode(command) => {
            world.cancel_changes(|change| matches!(change, Change::ServoMode(_)));
            world.later(world.delays.servo_mode, Change::ServoMode(is_on(command.servo_mode)));
        }
        Request::ServoJ(command) => {
            let target = joint_target(world, command.mode, command.joint_position);
            set_point(world, target, command.step_count);
        }
        Request::ServoP(command) => match pose_target(world, command.mode, command.pose) {
            Some(target) => set_point(world, target, command.step_count),
            None => return Outcome::Refused,
        },
        Request::SetServoMoveFilter(command) => world.state.servo_filter = *command,
        _ => return Outcome::Unhandled,
    }
    Outcome::Accepted
}

fn set_point(world: &mut World, target: Joints, step_count: Option<i64>) {
    let cycles = step_count.and_then(|count| u32::try_from(count).ok()).unwrap_or(1);
    // A target beyond the soft limits has no effect, like one that is too fast.
    if world.model.is_within_range(target) {
        world.engine.servo.push(world.state.joint_position.0, target, cycles);
    }
}

fn joint_target(world: &World, mode: MoveMode, position: JointPosition) -> Joints {
    let last = world.engine.servo.tail(world.state.joint_position.0);
    match mode {
        MoveMode::Relative => std::array::from_fn(|i| last[i] + position.0[i]),
        _ => position.0,
    }
}

fn pose_target(world: &World, mode: MoveMode, pose: Pose) -> Option<Joints> {
    let last = world.engine.servo.tail(world.state.joint_position.0);
    let flange = match mode {
        MoveMode::Relative => world.displaced(world.model.forward(last), pose),
        _ => world.flange(pose),
    };
    world.model.inverse(flange, last).ok().map(Into::into)
}
