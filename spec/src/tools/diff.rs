//! Differences between two specs, and their impact on the Rust interface that is generated from them.

use std::fmt;

use crate::spec::STATUS_TYPE;
use crate::{Command, ErrorCode, FieldSource, NeededSource, Spec, Topic, TypeDef};

mod collect;
mod command;
mod events;
mod field;
mod made;
mod types;

use collect::{ADDED, Differ, Pair, REMOVED, pairs};

/// Impact of a change on programs that use the generated Rust interface, in the terms of semantic versioning.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Impact {
    /// Documentation, answers of the simulator, or the order of keys in requests.
    Patch,
    /// There is more than before, or the client or the robot behaves otherwise at run time; every program compiles.
    Minor,
    /// A program may not compile any more, a request that was sent is refused, or a number means something else.
    Major,
}

/// `patch`, `minor` or `major`.
impl fmt::Display for Impact {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Patch => "patch",
            Self::Minor => "minor",
            Self::Major => "major",
        })
    }
}

/// One difference between two specs.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Difference {
    /// Item that changed, such as ``command `joint_move`, request field `speed` ``.
    pub place: String,
    /// Description of the change, such as ``unit changed from `deg/s` to `rad/s` ``.
    pub what: String,
    /// Impact of the change on the Rust interface.
    pub impact: Impact,
}

/// In one line: impact, place and change.
impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { place, what, impact } = self;
        write!(f, "{impact}: {place}: {what}")
    }
}

/// Compares two specs: all changes, those with the greatest impact first, then by place.
///
/// Commands are matched by `cmdName`, fields by key (elements of arrays by name), variants and values by what stands
/// for them on the wire, error codes and events by number, types by name. They are found in whichever topic they stand.
///
/// The impact follows from the code that the macros of `jaka-proto-derive` write. A test compares it with the verdict
/// of the compiler on forty edits of the spec:
///
/// | change | impact | because |
/// |---|---|---|
/// | command, type, error code, value of an enum, variant: added | minor | new items; `Request`, the enums over values and those over variants are `#[non_exhaustive]` |
/// | any of these, or a field or variant: removed, or its Rust name changed | major | the item is gone |
/// | command or type: moved to another topic | major | topics are modules, so the path changes |
/// | optional field added to a request, or to a type or variant that requests have | minor | these are `#[non_exhaustive]` and made by constructors of the required fields; it gets a setter, and no method another argument |
/// | the same, named as the constructor for a value | major | the constructor gets another name |
/// | required field added to one of these | major | the constructors get another argument |
/// | required fields of one of these in another order | major | the constructors take them in this order |
/// | field added to a reply, or to a type or variant that is only received | minor | these are `#[non_exhaustive]` |
/// | required field added to a reply or type, all of whose fields were optional | major | `Default` is gone |
/// | field added to a reply without fields | major | the method returned `()` |
/// | field added to an array of nothing but numbers | major | it converts from an array of this many numbers |
/// | `constructors` set | minor | there are functions more; major where they go, patch in what is only received |
/// | field: another Rust type, `optional`, `or_raw` | major | the field's type changes |
/// | the same Rust type, written in another form | minor | only the bytes change: `written`, `python(…)`, the key of a tag |
/// | `python(…)` around what functions take as `impl Into<…>`, or a method in place of the request | major | they take it otherwise |
/// | unit: another | major | the same number means something else |
/// | unit: stated or left out | patch | the number means what it meant |
/// | range, `ascii`, newer firmware's values: narrower, where requests are checked | major | what was sent before is refused |
/// | the same, wider | minor | more is sent |
/// | the same in what is only received | patch | nothing is checked there: documentation |
/// | a struct is no longer `Copy`, as a field needs memory of its own | major | the derive is gone; minor where it comes |
/// | array: `exact` set | major | longer arrays were read and are not any more |
/// | effect, role, changes, requirements, deadline | minor | `CommandInfo` says so at run time; the request is sent either way |
/// | motion: added or changed | minor | its end can be waited for; where it is removed, major, since a program may run it |
/// | the session ends with the command, or a missing reply becomes an error | major | calls that succeeded fail |
/// | the opposite of these two | minor | calls succeed that failed |
/// | bare reply read | minor | a reply is understood that was not; major where it is given up |
/// | event of the controller: added, removed, or of another severity | minor | a program that waits acts otherwise at run time |
/// | `[robot_status]` | minor | a robot reads the status otherwise; major where the module's `RobotStatus` becomes, or is no longer, a `MotionStatus` |
/// | deprecated | minor | the method gets `#[deprecated]`: a warning; patch where that goes |
/// | doc, aliases, errata, disputed readings, firmware versions, remembered setting, section, titles, evidence, sources, refusal and its causes, examples, message of an error code, explanation of an event | patch | documentation, and what the simulator answers |
pub fn diff(old: &Spec, new: &Spec) -> Vec<Difference> {
    let mut differ = Differ::new(old, new);
    topics(&mut differ);
    let listed = |spec| placed(spec, |topic| &topic.commands);
    for pair in pairs(&listed(old), &listed(new), |(_, command)| command.wire.clone()) {
        commands(&mut differ, &pair);
    }
    for pair in pairs(&types(old), &types(new), |(_, def)| def.name.clone()) {
        named_types(&mut differ, &pair);
    }
    robot_status(&mut differ);
    for pair in pairs(&old.errors().collect::<Vec<_>>(), &new.errors().collect::<Vec<_>>(), |error| error.wire) {
        error_codes(&mut differ, &pair);
    }
    events::compare(&mut differ);
    differ.finish()
}

/// The greatest impact among the changes; nothing if there are none.
pub fn impact(changes: &[Difference]) -> Option<Impact> {
    changes.iter().map(|change| change.impact).max()
}

/// Number of changes and their greatest impact, such as `3 additions, 1 change, minor`; `no differences` if there are
/// none.
pub fn summary(changes: &[Difference]) -> String {
    let Some(impact) = impact(changes) else { return "no differences".to_owned() };
    let count = |what: &str| changes.iter().filter(|change| change.what == what).count();
    let (added, removed) = (count(ADDED), count(REMOVED));
    let counts = [(added, "addition"), (removed, "removal"), (changes.len() - added - removed, "change")];
    let counts = counts.iter().filter(|(count, _)| *count > 0);
    let parts: Vec<_> = counts.map(|(count, noun)| format!("{count} {noun}{}", plural(*count))).collect();
    format!("{}, {impact}", parts.join(", "))
}

fn plural(count: usize) -> &'static str {
    if count == 1 { "" } else { "s" }
}

/// Something of a topic, and the topic.
type InTopic<'s, T> = (&'s Topic, &'s T);

fn placed<'s, T>(spec: &'s Spec, items: impl Fn(&'s Topic) -> &'s [T]) -> Vec<InTopic<'s, T>> {
    spec.topics.iter().flat_map(|topic| items(topic).iter().map(move |item| (topic, item))).collect()
}

fn types(spec: &Spec) -> Vec<InTopic<'_, TypeDef>> {
    spec.topics.iter().flat_map(|topic| spec.types_of(topic).map(move |(_, def)| (topic, def))).collect()
}

fn topics(d: &mut Differ<'_>) {
    let (old, new) = (d.old, d.new);
    for pair in pairs(&old.topics, &new.topics, |topic| (topic.name.clone(), topic.is_pack)) {
        // What a topic adds or removes is reported by its commands and types.
        if let Pair::Both(old, new) = pair {
            let place = format!("topic `{}`", new.name);
            d.reworded(&place, "title", &old.title, &new.title);
            d.reworded(&place, "Chinese title", &old.title_zh, &new.title_zh);
            d.reworded(&place, "doc", &old.doc, &new.doc);
        }
    }
}

fn commands(d: &mut Differ<'_>, pair: &Pair<'_, InTopic<'_, Command>>) {
    let place = format!("command `{}`", pair.any().1.wire);
    if let Some(((old_topic, old), (new_topic, new))) = d.both(&place, pair, Impact::Minor) {
        d.value(&place, "topic", &old_topic.name, &new_topic.name, Impact::Major);
        command::compare(d, &place, old, new);
    }
}

fn named_types(d: &mut Differ<'_>, pair: &Pair<'_, InTopic<'_, TypeDef>>) {
    let place = format!("type `{}`", pair.any().1.name);
    if let Some(((old_topic, old), (new_topic, new))) = d.both(&place, pair, Impact::Minor) {
        d.value(&place, "topic", &old_topic.name, &new_topic.name, Impact::Major);
        types::compare(d, &place, old, new);
    }
}

/// Sources of what a robot needs of status packets.
fn robot_status(d: &mut Differ<'_>) {
    let (old, new) = (d.old, d.new);
    let text = |source: &NeededSource<'_>| match source.source {
        FieldSource::Field(field) => field.name.clone(),
        FieldSource::Absent => "absent".to_owned(),
        FieldSource::Program => "program".to_owned(),
    };
    for new in new.robot_status() {
        let Some(old) = old.robot_status().find(|old| old.needed == new.needed) else { continue };
        let is_program = |source: &NeededSource<'_>| source.source == FieldSource::Program;
        let impact = if is_program(&old) == is_program(&new) { Impact::Minor } else { Impact::Major };
        let place = format!("type `{STATUS_TYPE}`, field `{}`", new.needed.name);
        d.value(&place, "source for a robot", &text(&old), &text(&new), impact);
    }
}

fn error_codes(d: &mut Differ<'_>, pair: &Pair<'_, &ErrorCode>) {
    let place = format!("error code `{}`", pair.any().wire);
    if let Some((old, new)) = d.both(&place, pair, Impact::Minor) {
        d.value(&place, "name", &old.name, &new.name, Impact::Major);
        d.reworded(&place, "message", &old.message, &new.message);
        d.reworded(&place, "doc", &old.doc, &new.doc);
    }
}
