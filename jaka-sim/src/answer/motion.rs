//! Jog and planned motion.

use jaka_proto::Request;
use jaka_proto::messages::motion::{EndMove, Jog, JogFrame, JointMove, MoveC, MoveL};
use jaka_proto::messages::types::{JointPosition, MoveMode, Pose};
use jaka_proto::wire::Writer;

use super::{Outcome, accept};
use crate::motion::{Arc, Frame, Jogging, Joints, Path, Planned, Profile, Reference, Zone, small};
use crate::world::World;

/// Acceleration where a command leaves it out, in deg/s² and mm/s². What controllers choose is not known.
const USUAL_ACCELERATION: f64 = 180.0;
/// Acceleration of a jog, in deg/s² and mm/s². Not known either.
const JOG_ACCELERATION: f64 = 180.0;

pub(super) fn answer(request: &Request, world: &mut World, out: &mut Writer) -> Outcome {
    let accepted = match request {
        Request::Jog(command) => start_jog(command, world).then(|| accept(command, out)),
        Request::JointMove(command) => start(request, world).then(|| accept(command, out)),
        Request::EndMove(command) => start(request, world).then(|| accept(command, out)),
        Request::MoveL(command) => start(request, world).then(|| accept(command, out)),
        Request::MoveC(command) => start(request, world).then(|| accept(command, out)),
        _ => return Outcome::Unhandled,
    };
    accepted.unwrap_or(Outcome::Refused)
}

/// Puts a motion behind those that wait; false where the arm cannot make it.
pub(crate) fn start(request: &Request, world: &mut World) -> bool {
    let planned = match request {
        Request::JointMove(command) => joint_move(command, world),
        Request::EndMove(command) => end_move(command, world),
        Request::MoveL(command) => move_l(command, world),
        Request::MoveC(command) => move_c(command, world),
        _ => None,
    };
    let Some(planned) = planned.filter(|_| world.engine.jog.is_none()) else {
        return false;
    };
    world.engine.enqueue(planned);
    true
}

impl World {
    /// Where the next motion starts.
    fn tail(&self) -> Joints {
        self.engine.tail(self.state.joint_position.0)
    }

    /// The way of all joints to a target.
    pub(super) fn plan_joints(&self, to: Joints, speed: f64, acceleration: f64) -> Option<Planned> {
        let from = self.tail();
        self.model.within_limits(&to).then_some(())?;
        self.plan(Path::Joints { from, to }, speed, acceleration)
    }

    fn plan(&self, path: Path, speed: f64, acceleration: f64) -> Option<Planned> {
        if speed <= 0.0 || acceleration <= 0.0 {
            return None;
        }
        let end = path.end(&self.model, self.tail())?;
        let profile = Profile::new(path.length(), speed, acceleration);
        Some(Planned { path, profile, deceleration: acceleration, end, zone: None })
    }

    /// A motion that goes over into the next one within a tolerance, where that is a habit.
    fn rounded(&self, planned: Planned, tolerance: Option<f64>) -> Planned {
        let radius = tolerance.filter(|_| self.habits.blend).unwrap_or_default();
        let end = self.model.forward(planned.end) * self.tool();
        Planned { zone: Zone::new(self.tool(), &end, radius), ..planned }
    }

    /// The flange displaced along the axes of the user frame.
    pub(super) fn displaced(&self, flange: &Frame, by: Pose) -> Frame {
        let reference = Reference::Fixed { base: self.user(), tool: self.tool() };
        reference.moved(flange, &crate::kinematics::from_pose(by.into()))
    }
}

fn joint_move(command: &JointMove, world: &World) -> Option<Planned> {
    let from = world.tail();
    let JointPosition(values) = command.joint_position;
    let to = match command.mode {
        MoveMode::Relative => std::array::from_fn(|i| from[i] + values[i]),
        _ => values,
    };
    world.plan_joints(to, command.speed, command.acceleration.unwrap_or(USUAL_ACCELERATION))
}

fn end_move(command: &EndMove, world: &World) -> Option<Planned> {
    let to = world.model.inverse(&world.flange(command.pose), world.tail())?;
    world.plan_joints(to, command.speed, command.acceleration.unwrap_or(USUAL_ACCELERATION))
}

/// Where the tool is at a pose that a command gives.
fn tool_at(world: &World, mode: MoveMode, pose: Pose) -> Frame {
    let tool = world.tool();
    match mode {
        MoveMode::Relative => world.displaced(&world.model.forward(world.tail()), pose) * tool,
        _ => world.flange(pose) * tool,
    }
}

fn move_l(command: &MoveL, world: &World) -> Option<Planned> {
    let tool = world.tool();
    let from = world.model.forward(world.tail()) * tool;
    let to = tool_at(world, command.mode, command.pose);
    let acceleration = command.acceleration.unwrap_or(USUAL_ACCELERATION);
    let planned = world.plan(Path::line(from, to, tool), command.speed, acceleration)?;
    Some(world.rounded(planned, command.tolerance))
}

/// Speed and acceleration as those of the path, in mm/s and mm/s²: the sources leave that open.
fn move_c(command: &MoveC, world: &World) -> Option<Planned> {
    let tool = world.tool();
    let from = world.model.forward(world.tail()) * tool;
    let middle = tool_at(world, command.mode, command.mid_pose);
    let to = tool_at(world, command.mode, command.end_pose);
    let arc = Arc::through(from, middle, to, tool)?;
    let planned = world.plan(Path::Arc(Box::new(arc)), command.speed, command.acceleration)?;
    Some(world.rounded(planned, Some(command.tolerance)))
}

fn start_jog(jog: &Jog, world: &mut World) -> bool {
    match *jog {
        Jog::Stop { axis, .. } => {
            stop_jog(world, axis);
            true
        }
        // The axis must be stopped before it is jogged again.
        _ if world.engine.is_busy() => false,
        Jog::Continuous { frame, axis, velocity } => {
            world.engine.jog = jogging(world, frame, axis, velocity);
            world.engine.jog.is_some()
        }
        Jog::Increment { frame, axis, velocity, distance } => {
            enqueue(world, frame, axis, velocity, |from| from + distance)
        }
        Jog::Absolute { frame, axis, velocity, position } => enqueue(world, frame, axis, velocity, |_| position),
    }
}

fn stop_jog(world: &mut World, axis: i64) {
    let jogged = world.engine.jog.is_none_or(|jog| i64::try_from(jog.index()) == Ok(axis));
    if jogged {
        world.stop();
    }
}

fn jogging(world: &World, frame: JogFrame, axis: i64, velocity: f64) -> Option<Jogging> {
    let index = usize::try_from(axis).ok().filter(|index| *index < 6)?;
    let tool = world.tool();
    Some(match frame {
        JogFrame::Joint => Jogging::Joint { index, velocity },
        JogFrame::Tool => Jogging::Axis { index, velocity, reference: Reference::Tool { tool } },
        _ => Jogging::Axis { index, velocity, reference: Reference::Fixed { base: Frame::identity(), tool } },
    })
}

/// A jog that ends by itself, as a planned motion; `to` gives the axis' target for its present value.
fn enqueue(world: &mut World, frame: JogFrame, axis: i64, velocity: f64, to: impl Fn(f64) -> f64) -> bool {
    let Some(index) = usize::try_from(axis).ok().filter(|index| *index < 6) else {
        return false;
    };
    let planned = match frame {
        JogFrame::Joint => {
            let mut target = world.tail();
            target[index] = to(target[index]);
            world.plan_joints(target, velocity.abs(), JOG_ACCELERATION)
        }
        frame => jog_line(world, frame, index, velocity.abs(), to),
    };
    let Some(planned) = planned else {
        return false;
    };
    world.engine.enqueue(planned);
    true
}

fn jog_line(world: &World, frame: JogFrame, index: usize, speed: f64, to: impl Fn(f64) -> f64) -> Option<Planned> {
    let tool = world.tool();
    let flange = world.model.forward(world.tail());
    let reference = match frame {
        JogFrame::Tool => Reference::Tool { tool },
        _ => Reference::Fixed { base: Frame::identity(), tool },
    };
    // In its own frame the tool is at zero.
    let now = match frame {
        JogFrame::Tool => 0.0,
        _ => crate::kinematics::to_pose(&(flange * tool))[index],
    };
    let end = reference.moved(&flange, &small(index, to(now) - now));
    world.plan(Path::line(flange * tool, end * tool, tool), speed, JOG_ACCELERATION)
}
