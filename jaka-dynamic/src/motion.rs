//! Motions of requests, by the spec.

use std::time::Duration;

use jaka_proto::messages::types::{JointPosition, Pose};
use jaka_proto::wire::{Decode, Reader};
use jaka_proto::{Change, CommandInfo, Effect, Path, Requirement, Role, Target};
use jaka_spec::{self as spec, Command, Field, JOINT_POSITION, PathKind, Spec};
use serde_json::{Map, Value};

use crate::scalar;

/// Motion that a request starts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RequestedMotion {
    /// Target of the motion.
    pub target: Target,
    /// Path to the target.
    pub path: Path,
    /// Distance from the target at which the controller may blend into the next motion, in mm.
    pub tolerance_mm: f64,
}

/// Returns the motion of a request of this command, a result of [`request`](crate::request); `None` for a command
/// without one. `built_in` is the built-in spec, which defines the types of targets.
///
/// # Errors
/// A phrase with the field that cannot be read, or whose type a pack has changed.
pub fn motion(
    spec: &Spec,
    built_in: &Spec,
    command: &Command,
    request: &str,
) -> Result<Option<RequestedMotion>, String> {
    let Some(motion) = &command.motion else { return Ok(None) };
    let fields: Map<String, Value> = serde_json::from_str(request).map_err(|error| error.to_string())?;
    let fields = Fields { spec, built_in, command, values: &fields };
    Ok(Some(RequestedMotion {
        target: fields.target(motion)?,
        path: fields.path(motion)?,
        tolerance_mm: fields.number(motion.tolerance.as_ref())?.unwrap_or_default(),
    }))
}

/// Fields of a request.
struct Fields<'s> {
    spec: &'s Spec,
    built_in: &'s Spec,
    command: &'s Command,
    values: &'s Map<String, Value>,
}

impl Fields<'_> {
    fn target(&self, motion: &spec::Motion) -> Result<Target, String> {
        let is_offset = match &motion.mode {
            None => false,
            Some(mode) => match self.value(&mode.field)?.and_then(scalar::int).map(|(wire, _)| wire) {
                Some(wire) if wire == mode.absolute => false,
                Some(wire) if Some(wire) == mode.offset => true,
                _ => return Ok(Target::Unknown),
            },
        };
        let is_joints = self.type_name(&motion.target) == Some(JOINT_POSITION);
        Ok(match (is_joints, is_offset) {
            (true, false) => Target::Joints(self.place::<JointPosition>(&motion.target)?),
            (true, true) => Target::JointOffset(self.place::<JointPosition>(&motion.target)?),
            (false, false) => Target::Pose(self.place::<Pose>(&motion.target)?),
            (false, true) => Target::pose_offset(self.place::<Pose>(&motion.target)?),
        })
    }

    fn path(&self, motion: &spec::Motion) -> Result<Path, String> {
        let (Some(path), Some(speed)) = (motion.path, self.number(motion.speed.as_ref())?) else {
            return Ok(Path::Unknown);
        };
        for field in &motion.unknown_with {
            if self.value(field)?.is_some() {
                return Ok(Path::Unknown);
            }
        }
        let acceleration = self.number(motion.acceleration.as_ref())?;
        Ok(match (path, &motion.through) {
            (PathKind::Joints, _) => Path::Joints { speed, acceleration },
            (PathKind::Line, _) => Path::Line { speed, acceleration },
            (PathKind::Arc, Some(through)) => Path::Arc { through: self.place(through)?, speed, acceleration },
            (PathKind::Arc, None) => Path::Unknown,
        })
    }

    fn field(&self, name: &str) -> Result<&Field, String> {
        self.command.request_field(name).ok_or_else(|| format!("there is no field `{name}`"))
    }

    fn type_name(&self, name: &str) -> Option<&str> {
        let id = self.command.request_field(name)?.ty.named()?;
        Some(&self.spec[id].name)
    }

    fn value(&self, name: &str) -> Result<Option<&Value>, String> {
        Ok(self.values.get(&self.field(name)?.wire).filter(|value| !value.is_null()))
    }

    fn number(&self, name: Option<&String>) -> Result<Option<f64>, String> {
        let Some(name) = name else { return Ok(None) };
        let Some(value) = self.value(name)? else { return Ok(None) };
        value.as_f64().map(Some).ok_or_else(|| format!("`{name}` is no number"))
    }

    /// Reads a joint position or a pose of the built-in types.
    fn place<T: Decode>(&self, name: &str) -> Result<T, String> {
        let field = self.field(name)?;
        if !self.spec.defines_as(self.built_in, &field.ty) {
            return Err(format!("a pack has changed the type of `{}`", field.wire));
        }
        let text = self.values.get(&field.wire).map(Value::to_string).unwrap_or_default();
        T::decode(&mut Reader::new(&text)).map_err(|error| format!("`{}`: {error}", field.wire))
    }
}

/// Returns the facts of a command of a spec that is loaded at run time, in the form of a generated command's. They stay
/// in memory until the program ends: call this once for a command.
pub fn command_info(command: &Command) -> &'static CommandInfo {
    let leaked = |text: &str| &*Box::leak(text.to_owned().into_boxed_str());
    let section = command.section.as_deref().unwrap_or_default();
    let effect = match command.effect {
        spec::Effect::Query => Effect::Query,
        spec::Effect::Setting => Effect::Setting,
        spec::Effect::Motion => Effect::Motion,
        spec::Effect::Power => Effect::Power,
        spec::Effect::Session => Effect::Session,
    };
    let mut info = CommandInfo::usual(leaked(&command.wire), leaked(&command.head()), leaked(section), effect);
    info.role = command.role.map(role).or((info.effect == Effect::Motion).then_some(Role::Start));
    info.changes = Box::leak(command.changes.iter().map(|each| change(*each)).collect());
    info.is_motion = command.motion.is_some();
    info.requires = Box::leak(command.requires.iter().map(|each| requirement(*each)).collect());
    info.deadline = command.deadline.filter(|deadline| *deadline > Duration::ZERO);
    info.reply_certain = command.reply_certain;
    info.ends_session = command.ends_session;
    Box::leak(Box::new(info))
}

fn role(role: spec::Role) -> Role {
    match role {
        spec::Role::Stop => Role::Stop,
        spec::Role::StopAxis => Role::StopAxis,
        spec::Role::Pause => Role::Pause,
        spec::Role::Resume => Role::Resume,
        spec::Role::SetPoint => Role::SetPoint,
        spec::Role::ServoMode => Role::ServoMode,
        spec::Role::Output => Role::Output,
        spec::Role::State => Role::State,
    }
}

fn change(change: spec::Change) -> Change {
    match change {
        spec::Change::Frames => Change::Frames,
        spec::Change::Tool => Change::Tool,
        spec::Change::Payload => Change::Payload,
    }
}

fn requirement(requirement: spec::Requirement) -> Requirement {
    match requirement {
        spec::Requirement::Powered => Requirement::Powered,
        spec::Requirement::Enabled => Requirement::Enabled,
        spec::Requirement::ServoMode => Requirement::ServoMode,
        spec::Requirement::NotServoMode => Requirement::NotServoMode,
    }
}

#[cfg(test)]
mod tests {
    use jaka_proto::messages::motion::{EndMove, JointMove, LineMode, MoveC, MoveL};
    use jaka_proto::messages::types::MoveMode;
    use jaka_proto::wire::Writer;
    use jaka_proto::{Motion, Request};

    use super::*;

    fn builtin() -> Spec {
        spec::builtin().expect("the built-in spec is correct")
    }

    /// Compares the generated code with the spec for the same request.
    fn assert_same(motion: &impl Motion) {
        let spec = builtin();
        let mut out = Writer::new();
        motion.write_request(&mut out);
        let text = out.as_str();
        let name = Request::read(text).expect("it is a request").info().name;
        let command = spec.command(name).expect("the spec has it");
        let expected =
            RequestedMotion { target: motion.target(), path: motion.path(), tolerance_mm: motion.tolerance() };
        assert_eq!(super::motion(&spec, &spec, command, text), Ok(Some(expected)), "{text}");
    }

    fn with<T>(mut value: T, change: impl FnOnce(&mut T)) -> T {
        change(&mut value);
        value
    }

    #[test]
    fn the_motion_of_a_request_is_that_of_the_generated_code() {
        let joints = [1.5, -2.0, 3.0, 4.0, 5.0, 6.25];
        let pose = [100.0, -20.5, 30.0, 180.0, 0.0, 90.0];
        assert_same(&JointMove::absolute(joints, 10.0));
        assert_same(&JointMove::relative(joints, 10.0).acceleration(20.0));
        assert_same(&with(JointMove::absolute(joints, 10.0), |motion| motion.mode = MoveMode::Other(7)));
        assert_same(&EndMove::new(pose, 12.0));
        assert_same(&MoveL::absolute(pose, 50.0).acceleration(100.0).tolerance(0.5));
        assert_same(&MoveL::relative([1.0, 2.0, 3.0, 0.0, 0.0, 0.0], 50.0));
        assert_same(&MoveL::relative([1.0, 2.0, 3.0, 0.0, 0.0, 1.0], 50.0));
        assert_same(&with(MoveL::absolute(pose, 50.0), |motion| motion.mode = LineMode::Other(2)));
        assert_same(&MoveC::absolute(pose, pose, 50.0, 100.0, 0.5));
        assert_same(&MoveC::relative(pose, pose, 50.0, 100.0, 0.5));
    }

    #[test]
    fn the_facts_of_a_command_are_those_of_the_generated_code() {
        let spec = builtin();
        for info in Request::COMMANDS {
            let command = spec.command(info.name).expect("both have the same commands");
            let found = command_info(command);
            let expected = with(**info, |info| (info.bare_reply, info.firmware) = (None, found.firmware));
            assert_eq!(*found, expected);
        }
    }

    #[test]
    fn a_command_without_a_motion_has_none() {
        let spec = builtin();
        let command = spec.command("get_joint_pos").expect("the spec has it");
        assert_eq!(motion(&spec, &spec, command, r#"{"cmdName":"get_joint_pos"}"#), Ok(None));
    }
}
