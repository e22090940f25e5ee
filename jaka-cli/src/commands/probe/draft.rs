//! Draft of a command pack.

mod samples;

use std::fmt::Write;

use jaka_dynamic::{Departure, DepartureKind, Node, Reading, notation, sample_value};
use jaka_spec::{Field, Shape, Source, Spec, Type, load_pack};
use jaka_sync::proto::text::{is_visible, visible};
use serde_json::Value;

use super::finding::{Finding, Findings};

/// Returns a pack with the keys unknown to the spec and the types of unreadable values; `None` without any.
///
/// The pack loads unchanged. `TODO` marks entries for its author to complete.
pub(super) fn text<'f>(spec: &'f Spec, findings: &'f Findings) -> Option<String> {
    let version = findings.version.as_deref().unwrap_or("a controller of unknown version");
    let mut draft = Draft {
        spec,
        version,
        text: head(version, &findings.packs),
        lines: String::new(),
        written: Vec::new(),
        known_arrays: samples::fixed(spec),
    };
    for finding in &findings.commands {
        let command = spec.command(&finding.name);
        let fields = command.map_or(&[][..], |command| spec.reply_fields(command));
        // The fields of a reply that is an object of a named type belong to the type.
        let object = command.and_then(|command| command.reply.object()).map(|id| &*spec[id].name);
        let (target, part) = object.map_or((&*finding.name, "reply"), |name| (name, "field"));
        draft.take(finding, |path| locate(spec, target, part, fields, path));
    }
    if let Some(id) = spec.status_type() {
        let (name, fields) = (&spec[id].name, spec.status_fields());
        draft.take(&findings.status, |path| locate(spec, name, "field", fields, path));
    }
    (!draft.written.is_empty()).then(|| draft.with(""))
}

fn head(version: &str, packs: &[String]) -> String {
    let title = quoted(&visible(&format!("Messages of {version} beyond the spec")));
    let on_top_of = if packs.is_empty() {
        String::new()
    } else {
        format!("# It applies on top of {}.\n", visible(&packs.join(", ")))
    };
    format!(
        "# A draft by `jaka probe`: answer each TODO, and correct guessed names and types.\n\
         {on_top_of}title = {title}\n"
    )
}

struct Draft<'f> {
    spec: &'f Spec,
    version: &'f str,
    text: String,
    /// Lines of its `[robot_status]`.
    lines: String,
    /// Locations for which the draft has entries or comments.
    written: Vec<Location<'f>>,
    /// Arrays of fixed length in the spec.
    known_arrays: Vec<(String, usize)>,
}

/// Departure, and the part of the spec that it concerns.
type Located<'f> = (&'f Departure, Location<'f>);

impl<'f> Draft<'f> {
    fn take(&mut self, finding: &'f Finding, find: impl Fn(&'f str) -> Option<Location<'f>>) {
        let locate = |departure: &'f Departure| Some((departure, find(&departure.field)?));
        let located: Vec<Located<'f>> = finding.departures.iter().filter_map(locate).collect();
        for (new, location) in &located {
            if let Some((field, old)) = self.renamed(finding, (new, location), &located) {
                self.rename(finding, field, &old, (new, location));
            }
        }
        for (departure, location) in located {
            if self.is_written(&location) {
                continue;
            }
            if departure.kind == DepartureKind::Unknown && !location.is_known {
                self.extend(finding, departure, location);
            } else if departure.reading == Reading::Unreadable && location.is_known {
                self.change(finding, departure, location);
            }
        }
    }

    /// Returns the field that a new key seems to rename: the only missing field of its object, if no other new key
    /// there has its type.
    ///
    /// Controllers omit optional fields, and all fields of status packets are optional. Without a missing required
    /// field, it is the only absent field with the type of the new key.
    fn renamed(
        &self,
        finding: &Finding,
        (new, location): (&Departure, &Location<'f>),
        all: &[Located<'f>],
    ) -> Option<(&'f Field, Location<'f>)> {
        if new.kind != DepartureKind::Unknown || location.is_known {
            return None;
        }
        let object = new.field.strip_suffix(location.key)?;
        let is_near = |(departure, other): &&Located<'f>| {
            other.is_in(location) && departure.field.strip_suffix(other.key) == Some(object)
        };
        let near = |kind| all.iter().filter(is_near).filter(move |(departure, _)| departure.kind == kind);
        let samples = |key: &str| samples::at(&finding.samples, &format!("{object}{key}"));
        let is_missing = |field: &Field| near(DepartureKind::Missing).any(|(_, missing)| missing.key == key(field));
        let is_absent = |field: &Field| samples(key(field)).is_empty() && self.has_type(field, &samples(location.key));
        let mut candidates: Vec<_> = location.fields.iter().filter(|field| is_missing(field)).collect();
        if candidates.is_empty() {
            candidates = location.fields.iter().filter(|field| is_absent(field)).collect();
        }
        let [field] = candidates[..] else { return None };
        let mut alike = near(DepartureKind::Unknown).filter(|(_, other)| self.has_type(field, &samples(other.key)));
        let is_it = alike.next().is_some_and(|(_, first)| first.key == location.key) && alike.next().is_none();
        is_it.then(|| (field, Location { key: key(field), is_known: true, ..*location }))
    }

    /// Whether all values are readable as the field, and have the apparent type of its values.
    fn has_type(&self, field: &Field, values: &[&Value]) -> bool {
        let kind = |value: &Value| match &*notation(value) {
            "int" => "float".to_owned(),
            other => other.to_owned(),
        };
        let own = kind(&sample_value(self.spec, field));
        let is_readable = |value: &Value| Node::field(self.spec, field, value.clone()).is_readable();
        !values.is_empty() && values.iter().all(|value| is_readable(value) && kind(value) == own)
    }

    /// Proposes another key for a field, if the draft loads with it.
    fn rename(
        &mut self,
        finding: &Finding,
        field: &Field,
        old: &Location<'f>,
        (new, location): (&Departure, &Location<'f>),
    ) {
        if self.is_written(old) || self.is_written(location) {
            return;
        }
        let (target, was, is) = (quoted(old.target), quoted(old.key), quoted(location.key));
        let entry = format!("[[override]]\ntarget = {target}\n{} = {was}\nwire = {is}\n", old.part);
        if self.loads(&format!("\n{entry}")) {
            let comment = comment(&format!(
                "TODO: check this proposal. {}: `{}` is missing, and `{}` is new and looks like it: {}",
                finding.name,
                key(field),
                location.key,
                new.found,
            ));
            self.text.extend(["\n", &comment, &entry]);
            self.written.extend([*old, *location]);
        }
    }
    /// Adds a field for an unknown key, with a name valid in the spec.
    fn extend(&mut self, finding: &Finding, departure: &Departure, location: Location<'f>) {
        let ty = samples::ty(&samples::at(&finding.samples, &departure.field), &self.known_arrays);
        let ty = ty.unwrap_or_else(|| departure.expected.clone());
        let count = self.written.len() + 1;
        let names = [snake(location.key), format!("{}_value", snake(location.key)), format!("unknown_key_{count}")];
        let entries = names.iter().map(|name| self.entry(departure, &location, (name, &ty)));
        if let Some(entry) = entries.into_iter().find(|entry| self.loads(entry)) {
            self.text += &entry;
            self.written.push(location);
        }
    }

    fn is_written(&self, location: &Location<'_>) -> bool {
        self.written.iter().any(|written| written.is(location))
    }

    /// Whether the draft loads with this entry.
    fn loads(&self, entry: &str) -> bool {
        load_pack(self.spec, Source { path: "draft.toml", text: &self.with(entry) }).is_ok()
    }

    /// Returns the draft with one more entry, and with its `[robot_status]` if it has lines there.
    fn with(&self, entry: &str) -> String {
        let Self { text, lines, .. } = self;
        let table =
            if lines.is_empty() { String::new() } else { format!("\n{}[robot_status]\n{lines}", comment(TODO_ROBOT)) };
        format!("{text}{entry}{table}")
    }

    /// Whether the draft loads with this entry, or with it and a line for the field that a robot needs; in that case,
    /// adds the line.
    fn loads_with_line(&mut self, entry: &str, location: &Location<'f>) -> bool {
        if self.loads(entry) {
            return true;
        }
        let mut fields = self.spec.status_fields().iter().filter(|field| field.wire == location.key);
        let is_of_status = self.spec.status_type().is_some_and(|id| self.spec[id].name == location.target);
        let Some(field) = fields.next().filter(|_| is_of_status) else { return false };
        let before = self.lines.clone();
        self.lines += &[&field.name, " = \"program\"\n"].concat();
        let loads = self.loads(entry);
        if !loads {
            self.lines = before;
        }
        loads
    }

    fn entry(&self, departure: &Departure, location: &Location<'_>, (name, ty): (&str, &str)) -> String {
        let doc = format!("TODO: its meaning is not known yet. {} sends {}.", self.version, departure.found);
        let Location { target, part, key, .. } = location;
        format!(
            "\n[[extend]]\ntarget = {}\n\n[[extend.{part}]]\nwire = {}\nname = \"{name}\"\ntype = \"{ty}\"\noptional = \
             true\ndoc = {}\n",
            quoted(target),
            quoted(key),
            quoted(&visible(&doc)),
        )
    }

    /// Changes an unreadable field into a readable one; as a comment if the draft would not load with the change.
    fn change(&mut self, finding: &Finding, departure: &Departure, location: Location<'f>) {
        let change = if departure.kind == DepartureKind::Missing {
            "optional = true".to_owned()
        } else {
            let ty = samples::ty(&samples::at(&finding.samples, &departure.field), &self.known_arrays);
            retyped(&ty.unwrap_or_else(|| guess(&departure.found)))
        };
        let target = quoted(location.target);
        let entry =
            format!("[[override]]\ntarget = {target}\n{} = {}\n{change}\n", location.part, quoted(location.key));
        let comment = comment(&format!("TODO: check this change. {}: {departure}", finding.name));
        let loads = self.loads_with_line(&format!("\n{entry}"), &location);
        let entry = if loads { entry } else { entry.lines().map(self::comment).collect() };
        self.text.extend(["\n", &comment, &entry]);
        self.written.push(location);
    }
}

/// Task for the author of a draft with a `[robot_status]`.
const TODO_ROBOT: &str =
    "TODO: a robot needs these: name a field that has the built-in type, or implement `MotionStatus` in your program.";

fn comment(line: &str) -> String {
    format!("# {}\n", visible(line))
}

/// Returns the lines of a pack that give a field another type. A type other than a number has no unit.
fn retyped(ty: &str) -> String {
    let unit = if ty.starts_with("int") || ty.starts_with("float") { "" } else { "\nunit = \"\"" };
    format!("type = \"{ty}\"{unit}")
}

/// Returns the apparent type of a value from its excerpt.
fn guess(found: &str) -> String {
    let value: Result<Value, _> = serde_json::from_str(found);
    value.map_or_else(|_| "json".to_owned(), |value| notation(&value))
}

/// Converts a key to a name in Rust: `powerState` and `power state` become `power_state`.
fn snake(key: &str) -> String {
    let mut name = String::new();
    for c in key.chars() {
        let is_word = c.is_ascii_alphanumeric();
        if (!is_word || c.is_ascii_uppercase()) && !name.is_empty() && !name.ends_with('_') {
            name.push('_');
        }
        name.extend(is_word.then(|| c.to_ascii_lowercase()));
    }
    name.trim_end_matches('_').to_owned()
}

/// Quotes a string for TOML, with equivalent escapes for invisible characters.
fn quoted(text: &str) -> String {
    let mut out = String::from('"');
    for c in text.chars() {
        match c {
            '"' | '\\' => out.extend(['\\', c]),
            c if is_visible(c) => out.push(c),
            c => {
                // Writing to a string cannot fail.
                let _ = write!(out, "\\U{:08X}", u32::from(c));
            }
        }
    }
    out + "\""
}

/// Part of the spec that a pack would change.
#[derive(Debug, Clone, Copy)]
struct Location<'f> {
    /// `cmdName` of a command, or name of a type.
    target: &'f str,
    /// Key of a pack for its fields: `reply` or `field`.
    part: &'static str,
    /// Key of the field, or its name if it is an element of an array.
    key: &'f str,
    /// Whether the spec has the field.
    is_known: bool,
    /// Fields of the same reply or type.
    fields: &'f [Field],
}

impl Location<'_> {
    /// Whether it is the same field, or the same new key.
    fn is(&self, other: &Location<'_>) -> bool {
        self.is_in(other) && self.key == other.key
    }

    /// Whether it is in the same reply or type.
    fn is_in(&self, other: &Location<'_>) -> bool {
        (self.target, self.part) == (other.target, other.part)
    }
}

/// Follows a departure's path from the top-level fields; returns `None` if a pack cannot change its end.
fn locate<'f>(
    spec: &'f Spec,
    target: &'f str,
    part: &'static str,
    fields: &'f [Field],
    path: &'f str,
) -> Option<Location<'f>> {
    let location = |key, is_known| Some(Location { target, part, key, is_known, fields });
    let steps = fields.iter().filter_map(|field| Some((field, rest(path, key(field))?)));
    // If one key is a prefix of another, the longer one matches.
    let Some((field, rest)) = steps.min_by_key(|(_, rest)| rest.len()) else { return location(path, false) };
    let Some(inner) = inside(spec, &field.ty, rest) else { return location(key(field), true) };
    locate(spec, inner.0, "field", inner.1, inner.2)
}

fn key(field: &Field) -> &str {
    if field.wire.is_empty() { &field.name } else { &field.wire }
}

/// Returns the rest of a path after a key, if the path begins with the key.
fn rest<'p>(path: &'p str, key: &str) -> Option<&'p str> {
    path.strip_prefix(key).filter(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
}

/// Returns the type with fields into which a path continues, its fields, and the rest of the path.
fn inside<'s, 'p>(spec: &'s Spec, ty: &'s Type, path: &'p str) -> Option<(&'s str, &'s [Field], &'p str)> {
    let ty = spec.unwrapped(ty);
    match spec.shape(ty) {
        Shape::List(element, _) => inside(spec, element, path.strip_prefix('[')?.split_once(']')?.1),
        Shape::Object(fields) | Shape::Tuple { fields, .. } => {
            Some((&spec[ty.named()?].name, fields, path.strip_prefix('.')?))
        }
        Shape::Scalar(_) | Shape::Python(_) | Shape::IntEnum(_) | Shape::TextEnum(_) | Shape::Choice(_) => None,
    }
}
