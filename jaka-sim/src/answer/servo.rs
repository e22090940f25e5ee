//! Set-points.

use jaka_proto::messages::servo::{ServoJ, ServoP};
use jaka_proto::messages::types::{JointPosition, MoveMode, Pose};

use super::Outcome;
use crate::motion::{Joints, Servo, SetPoint, Space};
use crate::world::World;

/// Adds a set-point of joint positions.
pub(super) fn joint_set_point(command: &ServoJ, world: &mut World) -> Outcome {
    let target = joint_target(world, command.mode, command.joint_position);
    set_point(world, target, Space::Joints, command.step_count)
}

/// Adds a set-point as a pose; refuses one that the arm cannot reach.
pub(super) fn pose_set_point(command: &ServoP, world: &mut World) -> Outcome {
    match pose_target(world, command.mode, command.pose) {
        Some(target) => set_point(world, target, Space::Pose, command.step_count),
        None => Outcome::Refused,
    }
}

fn set_point(world: &mut World, target: Joints, space: Space, step_count: Option<i64>) -> Outcome {
    let cycles = step_count.and_then(|count| u32::try_from(count).ok()).unwrap_or(1);
    // A target beyond the soft limits has no effect, like one beyond the speed limit.
    let is_within_range = world.model.is_within_range(target);
    let time = world.now();
    if let Some(servo) = world.engine.servo.as_mut().filter(|_| is_within_range) {
        servo.push(SetPoint { target, space, cycles, time });
    }
    Outcome::Accepted
}

/// Returns the joint position at the last set-point, in degrees.
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
