//! A draft of a command pack.

use std::fmt::Write;

use jaka_dynamic::{Departure, DepartureKind, Reading, notation};
use jaka_spec::{Field, Shape, Source, Spec, Type, load_pack};
use jaka_sync::proto::text::{is_visible, visible};
use serde_json::Value;

use super::finding::{Finding, Findings};

/// A pack with the keys that the spec does not know and the types of what cannot be read; none if there is neither.
///
/// It loads as it is. What its author has to find out is marked `TODO`.
pub(super) fn text(spec: &Spec, findings: &Findings) -> Option<String> {
    let version = findings.version.as_deref().unwrap_or("a controller of unknown version");
    let mut draft = Draft { spec, version, text: head(version, &findings.packs), written: Vec::new() };
    for finding in &findings.commands {
        let command = spec.command(&finding.name);
        let fields = command.map_or(&[][..], |command| spec.reply_fields(command));
        // The fields of a reply that is an object of a named type are that type's.
        let object = command.and_then(|command| command.reply.object()).map(|id| &*spec[id].name);
        let (target, part) = object.map_or((&*finding.name, "reply"), |name| (name, "field"));
        draft.take(finding, |path| locate(spec, target, part, fields, path));
    }
    if let Some(id) = spec.status_type() {
        let (name, fields) = (&spec[id].name, spec.status_fields());
        draft.take(&findings.status, |path| locate(spec, name, "field", fields, path));
    }
    (!draft.written.is_empty()).then_some(draft.text)
}

fn head(version: &str, packs: &[String]) -> String {
    let title = quoted(&visible(&format!("What {version} sends beyond the spec")));
    let on_top_of = if packs.is_empty() {
        String::new()
    } else {
        format!("# It applies on top of {}.\n", visible(&packs.join(", ")))
    };
    format!(
        "# A draft by `jaka probe`: find out what TODO asks for, and correct names and types that were guessed.\n\
         {on_top_of}title = {title}\n"
    )
}

struct Draft<'s> {
    spec: &'s Spec,
    version: &'s str,
    text: String,
    /// What it has entries or comments for.
    written: Vec<Location>,
}

impl Draft<'_> {
    fn take(&mut self, finding: &Finding, find: impl Fn(&str) -> Option<Location>) {
        for departure in &finding.departures {
            let Some(location) = find(&departure.field).filter(|location| !self.written.contains(location)) else {
                continue;
            };
            if departure.kind == DepartureKind::Unknown && !location.is_known {
                self.extend(departure, location);
            } else if departure.reading == Reading::Unreadable && location.is_known {
                self.change(finding, departure, location);
            }
        }
    }

    /// Adds a field for an unknown key, under a name that the spec takes.
    fn extend(&mut self, departure: &Departure, location: Location) {
        let count = self.written.len() + 1;
        let names = [snake(&location.key), format!("{}_value", snake(&location.key)), format!("unknown_key_{count}")];
        let entries = names.iter().map(|name| self.entry(departure, &location, name));
        if let Some(entry) = entries.into_iter().find(|entry| self.loads(entry)) {
            self.text += &entry;
            self.written.push(location);
        }
    }

    /// True if the draft loads with this entry.
    fn loads(&self, entry: &str) -> bool {
        let text = format!("{}{entry}", self.text);
        load_pack(self.spec, Source { path: "draft.toml", text: &text }).is_ok()
    }

    fn entry(&self, departure: &Departure, location: &Location, name: &str) -> String {
        let doc = format!("TODO: what it means is not known yet. {} sends {}.", self.version, departure.found);
        let Location { target, part, key, .. } = location;
        format!(
            "\n[[extend]]\ntarget = {}\n\n[[extend.{part}]]\nwire = {}\nname = \"{name}\"\ntype = \"{}\"\noptional = \
             true\ndoc = {}\n",
            quoted(target),
            quoted(key),
            departure.expected,
            quoted(&visible(&doc)),
        )
    }

    /// Changes a field that cannot be read into one that can; as a comment, where the draft would not load with it.
    fn change(&mut self, finding: &Finding, departure: &Departure, location: Location) {
        let change = match departure.kind {
            DepartureKind::Missing => "optional = true".to_owned(),
            _ => retyped(&guess(&departure.found)),
        };
        let target = quoted(&location.target);
        let entry =
            format!("[[override]]\ntarget = {target}\n{} = {}\n{change}\n", location.part, quoted(&location.key));
        let comment = comment(&format!("TODO: whether this is right. {}: {departure}", finding.name));
        let entry = if self.loads(&format!("\n{entry}")) { entry } else { entry.lines().map(self::comment).collect() };
        self.text.extend(["\n", &comment, &entry]);
        self.written.push(location);
    }
}

fn comment(line: &str) -> String {
    format!("# {}\n", visible(line))
}

/// What gives a field another type. What is not a number has no unit.
fn retyped(ty: &str) -> String {
    let unit = if ty.starts_with("int") || ty.starts_with("float") { "" } else { "\nunit = \"\"" };
    format!("type = \"{ty}\"{unit}")
}

/// The type of a value of which an excerpt is known.
fn guess(found: &str) -> String {
    let value: Result<Value, _> = serde_json::from_str(found);
    value.map_or_else(|_| "json".to_owned(), |value| notation(&value))
}

/// A key as a name in Rust: `powerState` and `power state` become `power_state`.
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

/// A string in TOML, with escapes for invisible characters, which stand for the same string.
fn quoted(text: &str) -> String {
    let mut out = String::from('"');
    for c in text.chars() {
        match c {
            '"' | '\\' => out.extend(['\\', c]),
            c if is_visible(c) => out.push(c),
            c => {
                // A string takes all that is written.
                let _ = write!(out, "\\U{:08X}", u32::from(c));
            }
        }
    }
    out + "\""
}

/// The part of the spec that a pack would change.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Location {
    /// A command's `cmdName` or a type's name.
    target: String,
    /// The key of a pack that names fields there: `reply` or `field`.
    part: &'static str,
    /// The field's key, or its name where it is an element of an array.
    key: String,
    /// True if the spec has the field.
    is_known: bool,
}

/// Follows a departure's path from the fields at its beginning; `None` if it ends where a pack can change nothing.
fn locate(spec: &Spec, target: &str, part: &'static str, fields: &[Field], path: &str) -> Option<Location> {
    let location =
        |key: &str, is_known| Some(Location { target: target.to_owned(), part, key: key.to_owned(), is_known });
    let steps = fields.iter().filter_map(|field| Some((field, rest(path, key(field))?)));
    // Where one key begins with another, the longer one matches.
    let Some((field, rest)) = steps.min_by_key(|(_, rest)| rest.len()) else { return location(path, false) };
    let Some(inner) = inside(spec, &field.ty, rest) else { return location(key(field), true) };
    locate(spec, inner.0, "field", inner.1, inner.2)
}

fn key(field: &Field) -> &str {
    if field.wire.is_empty() { &field.name } else { &field.wire }
}

/// What follows a key in a path, if the path begins with the key.
fn rest<'p>(path: &'p str, key: &str) -> Option<&'p str> {
    path.strip_prefix(key).filter(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
}

/// The type with fields into which a path continues, its fields, and the rest of the path.
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
