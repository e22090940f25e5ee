//! Checks of the meaning of a command for the arm against its fields.

use std::collections::BTreeMap;

use crate::model::{Command, Effect, Field, Reply, Request, Type, TypeDef, TypeKind};
use crate::role::{JOINT_POSITION, Motion, MotionMode, POSE, PathKind, Role};
use crate::scalar::Scalar;

/// Problem of a command's role or motion, once all types are known.
pub(crate) fn problem(command: &Command, types: &[TypeDef]) -> Option<String> {
    let motion = command.motion.as_ref();
    if command.role == Some(Role::Stop) && (!command.is_bare() || motion.is_some()) {
        return Some(
            "a stop has no parameters and no `[command.motion]`, so that nothing but a stop can go out".into(),
        );
    }
    let motion = motion?;
    if command.effect != Effect::Motion || command.role.is_some() {
        return Some("a command with `[command.motion]` has the effect `motion`, and no `role`".into());
    }
    if !matches!(command.request, Request::Fields(_)) {
        return Some("a motion has `request` fields, and no `choice`".into());
    }
    if !matches!(command.reply, Reply::Fields(_)) {
        return Some("the reply of a motion has fields of its own, or none".into());
    }
    motion_problem(command, motion, types)
}

/// Problem of a query that remembers a setting, once all commands are known.
pub(crate) fn remembers_problem(
    query: &Command,
    settings: &BTreeMap<String, Command>,
    types: &[TypeDef],
) -> Option<String> {
    let name = query.remembers.as_ref()?;
    let Some(setting) = settings.get(name) else {
        return Some(format!("`remembers` names `{name}`, which is no setting with `request` fields"));
    };
    let fields = match &query.reply {
        Reply::Fields(fields) => fields.as_slice(),
        Reply::Object(id) => match &types[id.0].kind {
            TypeKind::Object(fields) => fields.as_slice(),
            _ => &[],
        },
        Reply::Raw => &[],
    };
    let is_set = |field: &Field| {
        setting.request.fields().any(|set| (&set.name, &set.ty, &set.unit) == (&field.name, &field.ty, &field.unit))
    };
    let problem = || format!("no field of the reply has name, type and unit of one that `{name}` sets");
    (!fields.iter().any(is_set)).then(problem)
}

fn motion_problem(command: &Command, motion: &Motion, types: &[TypeDef]) -> Option<String> {
    let Motion { path, target, mode, through, speed, acceleration, tolerance, unknown_with } = motion;
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
    for field in unknown_with {
        let is_optional = |field: &Field| field.optional;
        problem = problem.or_else(|| checked("unknown_with", field, "optional", &is_optional));
    }
    if let Some(tolerance) = tolerance {
        problem = problem.or_else(|| checked("tolerance", tolerance, "a float in mm", &is_number("mm")));
    }
    problem
}
