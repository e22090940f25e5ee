//! A draft of a command pack.

use std::fmt::Write;

use jaka_dynamic::{Departure, DepartureKind, Reading, notation};
use jaka_spec::{Source, Spec, load_pack};
use jaka_sync::proto::text::{is_visible, visible};
use serde_json::Value;

use super::finding::{Finding, Findings};
use super::location::{self, Location};

/// A pack with the keys that the spec does not know; none if there are no such keys.
///
/// It loads as it is. What its author has to find out is marked `TODO`.
pub(super) fn text(spec: &Spec, findings: &Findings) -> Option<String> {
    let version = findings.version.as_deref().unwrap_or("a controller of unknown version");
    let mut draft =
        Draft { spec, version, text: head(version, &findings.packs), added: Vec::new(), suggestions: String::new() };
    for finding in &findings.commands {
        let fields = spec.command(&finding.name).map_or(&[][..], |command| spec.reply_fields(command));
        draft.take(finding, |path| location::find(spec, &finding.name, "reply", fields, path));
    }
    if let Some(id) = spec.status_type() {
        let (name, fields) = (&spec[id].name, spec.status_fields());
        draft.take(&findings.status, |path| location::find(spec, name, "field", fields, path));
    }
    (!draft.added.is_empty()).then(|| draft.text + &draft.suggestions)
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
    added: Vec<Location>,
    /// What is commented out.
    suggestions: String,
}

impl Draft<'_> {
    fn take(&mut self, finding: &Finding, find: impl Fn(&str) -> Option<Location>) {
        for departure in &finding.departures {
            let Some(location) = find(&departure.field).filter(|location| !self.added.contains(location)) else {
                continue;
            };
            if departure.kind == DepartureKind::Unknown && !location.is_known {
                self.extend(departure, location);
            } else if departure.reading == Reading::Unreadable && location.is_known {
                self.suggest(finding, departure, &location);
            }
        }
    }

    /// Adds a field for an unknown key, under a name that the spec takes.
    fn extend(&mut self, departure: &Departure, location: Location) {
        let count = self.added.len() + 1;
        let names = [snake(&location.key), format!("{}_value", snake(&location.key)), format!("unknown_key_{count}")];
        let entries = names.iter().map(|name| self.entry(departure, &location, name));
        let loads = |text: &String| load_pack(self.spec, Source { path: "draft.toml", text }).is_ok();
        let draft = entries.map(|entry| format!("{}{entry}", self.text)).find(loads);
        if let Some(text) = draft {
            self.text = text;
            self.added.push(location);
        }
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

    /// Adds what may be done about a field that cannot be read, as a comment.
    fn suggest(&mut self, finding: &Finding, departure: &Departure, location: &Location) {
        let change = match departure.kind {
            DepartureKind::Missing => "optional = true".to_owned(),
            _ => format!("type = \"{}\"", guess(&departure.found)),
        };
        self.suggestions.push('\n');
        let lines = [
            format!("{}: {departure}", finding.name),
            "[[override]]".to_owned(),
            format!("target = {}", quoted(&location.target)),
            format!("{} = {}", location.part, quoted(&location.key)),
            change,
        ];
        for line in lines {
            self.suggestions.extend(["# ", &visible(&line), "\n"]);
        }
    }
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
