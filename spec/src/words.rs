//! Parts of the model in words, for docs and for messages.

use std::ops::RangeInclusive;

pub use crate::names::{distance, nearest};
use crate::{Advice, Change, Command, Field, Motion, PathKind, Range, Requirement, Spec, TypeKind, Versions};

/// The first sentence with its full stop, and all that follows.
pub fn first_sentence(text: &str) -> (&str, &str) {
    let end = ["\n\n", ". ", ".\n"].iter().filter_map(|end| Some(text.find(end)? + usize::from(end.starts_with('.'))));
    end.min().map_or((text, ""), |end| text.split_at(end))
}

/// `0 to 5`, `at least 0`; nothing for a range without ends.
pub fn range(range: Range) -> Option<String> {
    match (range.min, range.max) {
        (Some(min), Some(max)) => Some(format!("{min} to {max}")),
        (Some(min), None) => Some(format!("at least {min}")),
        (None, Some(max)) => Some(format!("at most {max}")),
        (None, None) => None,
    }
}

/// `more than 0, at most 265`, or ``-360 to 360, where `mode` is 0 (Absolute)``: what is advised of a field, which
/// stands among `fields`; nothing if that is nothing. `name` says how other fields are called.
pub fn advised(spec: &Spec, fields: &[Field], field: &Field, name: impl Fn(&Field) -> String) -> Option<String> {
    let sibling = |rust: &String| fields.iter().find(|other| other.name == *rust);
    let called = |rust: &String| sibling(rust).map_or_else(|| rust.clone(), &name);
    let row = |advice: &Advice| {
        let per = advice.per.as_ref().map(|count| format!(", times `{}`", called(count)));
        let when = advice.when.as_ref().map(|when| {
            let value = sibling(&when.field).and_then(|selector| value_name(spec, selector, when.value));
            let value = value.map(|value| format!(" ({value})")).unwrap_or_default();
            format!(", where `{}` is {}{value}", called(&when.field), when.value)
        });
        [Some(bounds(advice, field.range)), per, when].into_iter().flatten().collect::<String>()
    };
    let rows: Vec<_> = field.advised.iter().map(row).collect();
    (!rows.is_empty()).then(|| rows.join("; "))
}

fn bounds(advice: &Advice, whole: Range) -> String {
    let within = advice.within(whole);
    let unit = advice.unit.as_ref().map(|unit| format!(" {unit}")).unwrap_or_default();
    match (within.min, within.max) {
        (Some(0.0), Some(max)) if advice.nonzero => format!("more than 0, at most {max}{unit}"),
        _ => range(within).unwrap_or_default() + &unit + if advice.nonzero { ", not 0" } else { "" },
    }
}

/// The name of a value of a field that is an enum.
fn value_name<'s>(spec: &'s Spec, selector: &Field, wire: i64) -> Option<&'s str> {
    let TypeKind::IntEnum(values) = &spec[selector.ty.named()?].kind else { return None };
    values.iter().find(|value| value.wire == wire).map(|value| &*value.name)
}

/// `1.5 and later`; nothing if every firmware has it.
pub fn versions(versions: &Versions) -> Option<String> {
    match (&versions.since, &versions.until) {
        (Some(since), Some(until)) => Some(format!("{since} to {until}")),
        (Some(since), None) => Some(format!("{since} and later")),
        (None, Some(until)) => Some(format!("up to {until}")),
        (None, None) => None,
    }
}

/// `Known to firmware 1.5 to 1.6.` for a command. Of one that the document does not have, the spec's versions are an
/// assumption.
pub fn known_to(command: &Command) -> Option<String> {
    let known = if command.evidence.is_empty() { "Known" } else { "Taken to be known" };
    versions(&command.versions).map(|versions| format!("{known} to firmware {versions}."))
}

/// `the frames of poses, the tool frame and the payload`; nothing if nothing is changed.
pub fn changes(changes: &[Change]) -> Option<String> {
    let words: Vec<_> = changes
        .iter()
        .map(|change| match change {
            Change::Frames => "the frames of poses",
            Change::Tool => "the tool frame",
            Change::Payload => "the payload",
        })
        .collect();
    (!words.is_empty()).then(|| list(&words, "and"))
}

/// `all joints; target joint_position (absolute where mode is 0); speed speed`: a motion by the names that `name` gives
/// its fields.
pub fn motion(motion: &Motion, name: impl Fn(&str) -> String) -> String {
    let path = match motion.path {
        Some(PathKind::Joints) => "all joints",
        Some(PathKind::Line) => "tool centre point on a line",
        Some(PathKind::Arc) => "tool centre point on an arc",
        None => "on a path that the controller chooses",
    };
    let mode = motion.mode.as_ref().map(|mode| {
        let offset = mode.offset.map(|offset| format!(", an offset where it is {offset}")).unwrap_or_default();
        format!(" (absolute where {} is {}{offset})", name(&mode.field), mode.absolute)
    });
    let part = |word: &str, field: &Option<String>| field.as_ref().map(|field| format!("{word} {}", name(field)));
    let unknown: Vec<_> = motion.unknown_with.iter().map(|field| name(field)).collect();
    let parts = [
        Some(path.to_owned()),
        Some(format!("target {}{}", name(&motion.target), mode.unwrap_or_default())),
        part("through", &motion.through),
        part("speed", &motion.speed),
        part("acceleration", &motion.acceleration),
        part("tolerance", &motion.tolerance),
        (!unknown.is_empty()).then(|| format!("on an unknown path with {}", list(&unknown, "or"))),
    ];
    parts.into_iter().flatten().collect::<Vec<_>>().join("; ")
}

/// The code of an event as the vendor's table has it: `0x0F0034`.
pub fn event_code(code: u32) -> String {
    format!("0x{code:06X}")
}

/// A code, or a range of codes, in the notation of the TOML files: `0x0F0006-0x0F0009`.
pub fn event_codes(codes: &RangeInclusive<u32>) -> String {
    let (first, last) = (event_code(*codes.start()), event_code(*codes.end()));
    if first == last { first } else { format!("{first}-{last}") }
}

/// `powered, enabled and outside servo mode`; nothing if the robot may be in any state.
pub fn requirements(requires: &[Requirement]) -> Option<String> {
    let words: Vec<_> = requires.iter().map(|requirement| self::requirement(*requirement)).collect();
    (!words.is_empty()).then(|| list(&words, "and"))
}

fn requirement(requirement: Requirement) -> &'static str {
    match requirement {
        Requirement::Powered => "powered",
        Requirement::Enabled => "enabled",
        Requirement::ServoMode => "in servo mode",
        Requirement::NotServoMode => "outside servo mode",
    }
}

/// `a, b and c`, with the conjunction given.
pub fn list(items: &[impl AsRef<str>], conjunction: &str) -> String {
    let items: Vec<_> = items.iter().map(AsRef::as_ref).collect();
    match items.split_last() {
        Some((last, others)) if !others.is_empty() => format!("{} {conjunction} {last}", others.join(", ")),
        _ => items.concat(),
    }
}
