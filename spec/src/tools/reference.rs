//! The protocol as a text to read.

mod chinese;
mod command;
mod events;
mod fields;
mod markdown;
mod type_phrase;
mod types;
mod wire_names;

use std::fmt::Write as _;

pub use self::chinese::reference_zh;
pub use self::events::{events, events_zh};
use self::markdown::{Table, code, escape, link};
use crate::words::first_sentence;
use crate::{Command, ErrorCode, Spec, Topic};

/// The pages of the English edition.
const ENGLISH: [&str; 13] = [
    include_str!("../../reference/about.md"),
    include_str!("../../reference/session.md"),
    include_str!("../../reference/programs.md"),
    include_str!("../../reference/framing.md"),
    include_str!("../../reference/packet.md"),
    include_str!("../../reference/states.md"),
    include_str!("../../reference/conventions.md"),
    include_str!("../../reference/events.md"),
    include_str!("../../reference/refusals.md"),
    include_str!("../../reference/queries.md"),
    include_str!("../../reference/firmware.md"),
    include_str!("../../reference/traps.md"),
    include_str!("../../reference/tables.md"),
];

/// A reference of the protocol in Markdown, for readers who write no Rust.
///
/// It begins with pages of prose, which are the same for every spec. Then it has an index by topic and one by section,
/// and a chapter for each topic with its commands, types, error codes and events. Docs call commands and fields as the
/// wire does. The anchors are those that GitHub gives to headings.
pub fn reference(spec: &Spec) -> String {
    let spec = &wire_names::in_wire_names(spec);
    let mut out = String::from("# The JAKA TCP protocol\n\n");
    out += &ENGLISH.join("\n");
    index_by_topic(&mut out, spec);
    index_by_section(&mut out, spec);
    for topic in &spec.topics {
        chapter(&mut out, spec, topic);
    }
    out.truncate(out.trim_end().len());
    out + "\n"
}

fn index_by_topic(out: &mut String, spec: &Spec) {
    *out += "\n## Topics\n\n";
    for topic in &spec.topics {
        let _ = writeln!(out, "**{}**\n", link(&topic.title, &topic.title));
        for command in &topic.commands {
            let first = first_sentence(&command.doc).0;
            let _ = writeln!(out, "- {}: {}", command_link(command), escape(first));
        }
        let types: Vec<_> = spec.types_of(topic).map(|(_, def)| type_phrase::name_link(&def.name)).collect();
        if !types.is_empty() {
            let _ = writeln!(out, "- Types: {}", types.join(", "));
        }
        if !topic.errors.is_empty() {
            let codes: Vec<_> = topic.errors.iter().map(|error| error.wire.to_string()).collect();
            let _ = writeln!(out, "- Codes: {}", codes.join(", "));
        }
        events::index(out, &topic.events);
        *out += "\n";
    }
}

fn index_by_section(out: &mut String, spec: &Spec) {
    *out += "## Sections of the document\n\n";
    let mut table = Table::new(&["section", "title in the document", "command", "topic", "effect"]);
    for (topic, command) in by_section(spec) {
        let [section, title] = [&command.section, &command.title_zh].map(|text| text.clone().unwrap_or_default());
        let effect = command.effect.word().to_owned();
        table.row([section, title, command_link(command), link(&topic.title, &topic.title), effect]);
    }
    table.render(out);
}

/// All commands with their topics, in the order of the document's sections.
fn by_section(spec: &Spec) -> Vec<(&Topic, &Command)> {
    let mut commands: Vec<_> =
        spec.topics.iter().flat_map(|topic| topic.commands.iter().map(move |command| (topic, command))).collect();
    commands.sort_by_key(|(_, command)| section_order(command));
    commands
}

/// The section's numbers; commands beyond the document come last.
fn section_order(command: &Command) -> (bool, Vec<u32>) {
    let section = command.section.as_deref();
    let numbers = section.map(|section| section.split('.').map(|part| part.parse().unwrap_or(u32::MAX)).collect());
    (section.is_none(), numbers.unwrap_or_default())
}

/// The heading of a command, with its section so that no other heading has the same anchor.
fn command_heading(command: &Command) -> String {
    let number = command.section.as_deref().unwrap_or("Command");
    format!("{number} `{}`", command.wire)
}

fn command_link(command: &Command) -> String {
    link(&code(&command.wire), &command_heading(command))
}

fn chapter(out: &mut String, spec: &Spec, topic: &Topic) {
    let _ = writeln!(out, "## {}\n\n{}\n", escape(&topic.title), escape(&topic.doc));
    for command in &topic.commands {
        command::render(out, spec, command);
    }
    for def in spec.types_of(topic) {
        types::render(out, spec, def);
    }
    error_codes(out, &topic.errors);
    events::render(out, &topic.events);
}

fn error_codes(out: &mut String, errors: &[ErrorCode]) {
    let mut table = Table::new(&["code", "name", "message", "meaning"]);
    for error in errors {
        let message = error.message.as_deref().map(code).unwrap_or_default();
        table.row([error.wire.to_string(), error.name.clone(), message, first_sentence(&error.doc).0.to_owned()]);
    }
    table.render(out);
    fields::longer_docs(out, errors.iter().map(|error| (error.wire.to_string(), error.doc.as_str())));
}
