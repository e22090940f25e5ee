//! Jogs.

use jaka_proto::messages::motion::{Jog, JogFrame};
use jaka_proto::messages::types::Pose;

use crate::motion::{ArmPath, Jogging, Planned, moved, small};
use crate::world::World;

/// Acceleration of a jog, in deg/s² and mm/s². The value of real controllers is unknown.
const JOG_ACCELERATION: f64 = 180.0;

/// Starts or stops a jog; returns false if the arm cannot make it.
pub(super) fn start_jog(jog: &Jog, world: &mut World) -> bool {
    match *jog {
        Jog::Stop { axis, .. } => {
            stop_jog(world, axis);
            true
        }
        // A new jog requires that the previous one is stopped.
        _ if world.engine.is_busy() => false,
        Jog::Continuous { frame, axis, velocity, .. } => {
            world.engine.jog = jogging(world, frame, axis, velocity);
            world.engine.jog.is_some()
        }
        Jog::Increment { frame, axis, velocity, distance, .. } => {
            world.enqueue(planned(world, frame, axis, velocity, |from| from + distance))
        }
        Jog::Absolute { frame, axis, velocity, position, .. } => {
            world.enqueue(planned(world, frame, axis, velocity, |_| position))
        }
        // Unknown jog mode.
        _ => false,
    }
}

fn stop_jog(world: &mut World, axis: i64) {
    let jogged = world.engine.jog.is_none_or(|jog| i64::try_from(jog.index) == Ok(axis));
    if jogged {
        world.stop();
    }
}

fn jogging(world: &World, frame: JogFrame, axis: i64, velocity: f64) -> Option<Jogging> {
    Some(Jogging { frame, index: index(axis)?, velocity, tool: world.tool() })
}

/// Plans a jog that ends by itself; `to` maps the axis' present value to its target.
fn planned(world: &World, frame: JogFrame, axis: i64, velocity: f64, to: impl Fn(f64) -> f64) -> Option<Planned> {
    let index = index(axis)?;
    if frame != JogFrame::Joint {
        return jog_line(world, frame, index, velocity.abs(), to);
    }
    let mut target = world.tail();
    target[index] = to(target[index]);
    world.plan_joints(target, velocity.abs(), JOG_ACCELERATION)
}

fn index(axis: i64) -> Option<usize> {
    usize::try_from(axis).ok().filter(|index| *index < 6)
}

fn jog_line(world: &World, frame: JogFrame, index: usize, speed: f64, to: impl Fn(f64) -> f64) -> Option<Planned> {
    let tool = world.tool();
    let flange = world.model.forward(world.tail());
    // In the tool frame, the tool's pose is zero.
    let now = match frame {
        JogFrame::Tool => 0.0,
        _ => <[f64; 6]>::from(Pose::from(flange * tool))[index],
    };
    let end = moved(frame, flange, tool, small(index, to(now) - now));
    world.plan(ArmPath::Line { from: flange * tool, to: end * tool, tool }, speed, JOG_ACCELERATION)
}
