//! Roles, changes and motions.

use super::common::{keyword, word};
use crate::item::Item;
use crate::model::{Command, Effect};
use crate::resolve::{Index, Need};
use crate::role::{Change, Motion, MotionMode, PathKind, Role};

/// Effect of the commands that can have a role.
fn effect_of(role: Role) -> Effect {
    match role {
        Role::Stop | Role::StopAxis | Role::Pause | Role::Resume | Role::SetPoint | Role::ServoMode => Effect::Motion,
        Role::Output => Effect::Setting,
        Role::State => Effect::Query,
    }
}

/// The role of a command or of a variant.
pub(super) fn role(item: &Item<'_, '_>) -> Option<Role> {
    if item.has("role") { keyword(item, "role", Role::WORDS) } else { None }
}

pub(super) fn changes(item: &Item<'_, '_>) -> Vec<Change> {
    item.texts("changes").iter().filter_map(|text| word(item, "changes", text, Change::WORDS)).collect()
}

/// The motion that a command starts.
pub(crate) fn motion(item: &Item<'_, '_>) -> Option<Motion> {
    let item = item.item("motion", "motion")?;
    let name = |key| item.text(key).map(|text| text.value);
    let path = if item.has("path") { keyword(&item, "path", PathKind::WORDS) } else { None };
    let motion = Motion {
        path,
        target: item.required_text("target").value,
        mode: item.item("mode", "mode").map(|item| mode(&item)),
        through: name("through"),
        speed: name("speed"),
        acceleration: name("acceleration"),
        tolerance: name("tolerance"),
        unknown_with: item.texts("unknown_with").into_iter().map(|text| text.value).collect(),
    };
    item.finish();
    Some(motion)
}

fn mode(item: &Item<'_, '_>) -> MotionMode {
    if !item.has("absolute") {
        item.error(item.at, "`absolute` is missing");
    }
    let value = |key| item.int(key).map(|value| value.value);
    let mode = MotionMode {
        field: item.required_text("field").value,
        absolute: value("absolute").unwrap_or_default(),
        offset: value("offset"),
    };
    item.finish();
    mode
}

/// Checks what a command says of its meaning: now against its effect, and later against the types.
pub(super) fn check<'s>(item: &Item<'_, 's>, command: &Command, index: &mut Index<'s>) {
    let roles = command.variants().iter().filter_map(|variant| variant.role).chain(command.role);
    if roles.into_iter().any(|role| effect_of(role) != command.effect) {
        item.error(
            item.at,
            "a role needs its effect: `state` is one of queries, `output` of settings, others of motions",
        );
    }
    if !command.changes.is_empty() && command.effect == Effect::Query {
        item.error(item.at, "a query changes nothing");
    }
    if let Some(remembers) = item.text("remembers") {
        if command.effect != Effect::Query {
            item.error(remembers.at, "`remembers` is for queries");
        }
        index.needs(item, remembers.at, Need::Remembers(Box::new(command.clone())));
    }
    if command.role.is_some() || command.motion.is_some() {
        index.needs(item, item.at, Need::Meaning(Box::new(command.clone())));
    }
}
