//! Meaning of a command to the arm: roles, changes and motions.

use crate::model::{Command, Field, Reply, Request, Type, TypeDef, TypeKind};
use crate::scalar::Scalar;

/// Role of a command, or of a variant of its request.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// Stops the arm. Goes out without a question.
    Stop,
    /// Pauses a motion or a program. Goes out without a question.
    Pause,
    /// Resumes what is paused.
    Resume,
    /// Set-point of servo mode.
    SetPoint,
    /// Enters or leaves servo mode.
    ServoMode,
    /// Sets an output. Passes while a session, a stream or a trajectory moves the arm.
    Output,
    /// Short query for a state of the robot. Passes likewise.
    State,
}

/// Property of the arm that a command changes, and on which other commands depend.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Change {
    /// Frames to which poses refer: the user frame, or the mounting of the arm.
    Frames,
    /// Tool frame, whose origin is the tool centre point.
    Tool,
    /// Payload.
    Payload,
}

/// Motion that a command starts, by the Rust names of the fields of its request.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Motion {
    /// Path to the target; none where the controller chooses it.
    pub path: Option<PathKind>,
    /// Field with the target, a `JointPosition` or a `Pose`.
    pub target: String,
    /// Field that says whether the target is absolute or an offset; none where it is absolute.
    pub mode: Option<MotionMode>,
    /// Field with the pose between the ends of an arc.
    pub through: Option<String>,
    /// Field with the speed.
    pub speed: Option<String>,
    /// Field with the acceleration.
    pub acceleration: Option<String>,
    /// Field with the tolerance: the distance from the target at which the controller may blend into the next motion.
    pub tolerance: Option<String>,
}

/// Enum that says whether the target of a motion is absolute or an offset. With any other value it is unknown.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MotionMode {
    /// Field with the enum.
    pub field: String,
    /// Value for an absolute target.
    pub absolute: i64,
    /// Value for an offset: of the joints, or along the axes of the selected user frame.
    pub offset: Option<i64>,
}

/// Kind of path of a motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PathKind {
    /// All joints at once.
    Joints,
    /// Tool centre point on a straight line.
    Line,
    /// Tool centre point on an arc.
    Arc,
}

/// Type of the target of a motion in joint positions.
pub const JOINT_POSITION: &str = "JointPosition";

/// Type of a pose.
pub const POSE: &str = "Pose";

impl PathKind {
    /// Unit of the speed on it.
    fn speed_unit(self) -> &'static str {
        match self {
            Self::Joints => "deg/s",
            Self::Line | Self::Arc => "mm/s",
        }
    }

    fn acceleration_unit(self) -> &'static str {
        match self {
            Self::Joints => "deg/s²",
            Self::Line | Self::Arc => "mm/s²",
        }
    }
}

impl Command {
    /// Role of the request, which may be that of its variant.
    pub fn role_of_variant(&self, tag: Option<i64>) -> Option<Role> {
        let variant = match &self.request {
            Request::Choice(choice) => choice.variants.iter().find(|variant| Some(variant.wire) == tag),
            Request::Fields(_) => None,
        };
        variant.and_then(|variant| variant.role).or(self.role)
    }

    /// Field of the request, by its Rust name, where all requests have the same fields.
    pub fn request_field(&self, name: &str) -> Option<&Field> {
        match &self.request {
            Request::Fields(fields) => fields.iter().find(|field| field.name == name),
            Request::Choice(_) => None,
        }
    }
}

impl Motion {
    /// Follows a field that gets another name in Rust.
    pub(crate) fn rename(&mut self, old: &str, new: &str) {
        let Self { path: _, target, mode, through, speed, acceleration, tolerance } = self;
        let mode = mode.as_mut().map(|mode| &mut mode.field);
        let names = [mode, through.as_mut(), speed.as_mut(), acceleration.as_mut(), tolerance.as_mut()];
        names.into_iter().flatten().chain([target]).filter(|name| *name == old).for_each(|name| new.clone_into(name));
    }
}

/// Problem of a command's role or motion, once all types are known.
pub(crate) fn problem(command: &Command, types: &[TypeDef]) -> Option<String> {
    let motion = command.motion.as_ref();
    if command.role == Some(Role::Stop) && (!command.is_bare() || motion.is_some()) {
        return Some(
            "a stop has no parameters and no `[command.motion]`, so that nothing but a stop can go out".into(),
        );
    }
    let motion = motion?;
    if !matches!(command.request, Request::Fields(_)) {
        return Some("a motion has `request` fields, and no `choice`".into());
    }
    if !matches!(command.reply, Reply::Fields(_)) {
        return Some("the reply of a motion has fields of its own, or none".into());
    }
    motion_problem(command, motion, types)
}

fn motion_problem(command: &Command, motion: &Motion, types: &[TypeDef]) -> Option<String> {
    let Motion { path, target, mode, through, speed, acceleration, tolerance } = motion;
    let is_arc = *path == Some(PathKind::Arc);
    if is_arc != through.is_some() {
        return Some("`through` is the pose between the ends of an arc, which has one, and no other path".into());
    }
    if path.is_some() != speed.is_some() || path.is_none() && acceleration.is_some() {
        return Some("a motion has a `path` and a `speed`, or neither and no `acceleration`".into());
    }
    let named = |field: &Field, name: &str| matches!(field.ty, Type::Named(id) if types[id.0].name == name);
    let checked = |key: &str, name: &String, expected: &str, fits: &dyn Fn(&Field) -> bool| {
        let field = command.request_field(name);
        let fits = field.is_some_and(|field| !field.or_raw && field.disputed.is_empty() && fits(field));
        (!fits).then(|| {
            format!("`{key}` of the motion names `{name}`, which is no field of the request that is {expected}")
        })
    };
    let is_target = |field: &Field| !field.optional && (named(field, JOINT_POSITION) || named(field, POSE));
    let is_number = |unit: &'static str| {
        move |field: &Field| field.ty == Type::Scalar(Scalar::Float) && field.unit.as_deref() == Some(unit)
    };
    let mut problem = checked("target", target, "a `JointPosition` or a `Pose`, and not optional", &is_target);
    if let Some(through) = through {
        let is_pose = |field: &Field| !field.optional && named(field, POSE);
        problem = problem.or_else(|| checked("through", through, "a `Pose`, and not optional", &is_pose));
    }
    if let Some(MotionMode { field, absolute, offset }) = mode {
        let has = |field: &Field, value: i64| {
            let Type::Named(id) = field.ty else { return false };
            matches!(&types[id.0].kind, TypeKind::IntEnum(values) if values.iter().any(|known| known.wire == value))
        };
        let fits =
            |field: &Field| !field.optional && has(field, *absolute) && offset.is_none_or(|value| has(field, value));
        let expected = "an enum of whole numbers with these values, and not optional";
        problem = problem.or_else(|| checked("mode", field, expected, &fits));
    }
    if let (Some(path), Some(speed)) = (path, speed) {
        let unit = path.speed_unit();
        let fits = |field: &Field| !field.optional && is_number(unit)(field);
        problem = problem.or_else(|| checked("speed", speed, &format!("a float in {unit}, and not optional"), &fits));
    }
    if let (Some(path), Some(acceleration)) = (path, acceleration) {
        let unit = path.acceleration_unit();
        let expected = format!("a float in {unit}");
        problem = problem.or_else(|| checked("acceleration", acceleration, &expected, &is_number(unit)));
    }
    if let Some(tolerance) = tolerance {
        problem = problem.or_else(|| checked("tolerance", tolerance, "a float in mm", &is_number("mm")));
    }
    problem
}
