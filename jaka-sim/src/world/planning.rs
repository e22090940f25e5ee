//! Motions as planned from the requests that command them.

use jaka_motion::Transform;
use jaka_proto::Request;
use jaka_proto::messages::motion::{EndMove, JointMove, LineMode, MoveC, MoveL};
use jaka_proto::messages::types::{JointPosition, MoveMode, Pose};

use super::World;
use crate::motion::{Joints, Path, Planned, Profile, Reference, Zone};

/// Acceleration where a command leaves it out, in deg/s² and mm/s². What controllers choose is not known.
const USUAL_ACCELERATION: f64 = 180.0;

impl World {
    /// Queues a motion; false if the arm cannot make it, or the request is not a motion.
    pub(crate) fn start_motion(&mut self, request: &Request) -> bool {
        let planned = match request {
            Request::JointMove(command) => joint_move(command, self),
            Request::EndMove(command) => end_move(command, self),
            Request::MoveL(command) => move_l(command, self),
            Request::MoveC(command) => move_c(command, self),
            _ => None,
        };
        self.enqueue(planned.filter(|_| self.engine.jog.is_none()))
    }

    /// Queues a motion; false if there is none.
    pub(crate) fn enqueue(&mut self, planned: Option<Planned>) -> bool {
        planned.map(|planned| self.engine.enqueue(planned)).is_some()
    }

    /// Where the next motion starts.
    pub(crate) fn tail(&self) -> Joints {
        self.engine.tail(self.drives.commanded)
    }

    /// The way of all joints to a target.
    pub(crate) fn plan_joints(&self, to: Joints, speed: f64, acceleration: f64) -> Option<Planned> {
        let from = self.tail();
        self.model.is_within_range(to).then_some(())?;
        self.plan(Path::Joints { from, to }, speed, acceleration)
    }

    pub(crate) fn plan(&self, path: Path, speed: f64, acceleration: f64) -> Option<Planned> {
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
        Planned { zone: Zone::new(self.tool(), end, radius), ..planned }
    }

    /// The flange displaced along the axes of the user frame.
    pub(crate) fn displaced(&self, flange: Transform, by: Pose) -> Transform {
        let reference = Reference::Fixed { base: self.user(), tool: self.tool() };
        reference.moved(flange, by.into())
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
    let to = world.model.inverse(world.flange(command.pose), world.tail()).ok()?;
    world.plan_joints(to.into(), command.speed, command.acceleration.unwrap_or(USUAL_ACCELERATION))
}

/// Where the tool is at a pose that a command gives.
fn tool_at(world: &World, mode: MoveMode, pose: Pose) -> Transform {
    let tool = world.tool();
    match mode {
        MoveMode::Relative => world.displaced(world.model.forward(world.tail()), pose) * tool,
        _ => world.flange(pose) * tool,
    }
}

fn move_l(command: &MoveL, world: &World) -> Option<Planned> {
    let tool = world.tool();
    let from = world.model.forward(world.tail()) * tool;
    let to = match command.mode {
        LineMode::Relative => tool_at(world, MoveMode::Relative, command.pose),
        LineMode::RelativeToTool => from * command.pose.into(),
        _ => tool_at(world, MoveMode::Absolute, command.pose),
    };
    let acceleration = command.acceleration.unwrap_or(USUAL_ACCELERATION);
    let planned = world.plan(Path::Line { from, to, tool }, command.speed, acceleration)?;
    Some(world.rounded(planned, command.tolerance))
}

fn move_c(command: &MoveC, world: &World) -> Option<Planned> {
    let tool = world.tool();
    let from = world.model.forward(world.tail()) * tool;
    let middle = tool_at(world, command.mode, command.mid_pose);
    let to = tool_at(world, command.mode, command.end_pose);
    let arc = Path::arc(from, middle, to, tool)?;
    let planned = world.plan(arc, command.speed, command.acceleration)?;
    Some(world.rounded(planned, Some(command.tolerance)))
}
