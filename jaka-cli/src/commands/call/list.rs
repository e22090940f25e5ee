//! The list of commands.

use jaka_spec::{Command, Spec, Topic};
use jaka_sync::proto::text::visible;

use super::help;
use crate::failure::Failure;

/// The commands by topic, each with one sentence; only those of a topic if it is named.
///
/// # Errors
/// There is no such topic; the message lists those that exist.
pub(super) fn text(spec: &Spec, topic: &str) -> Result<String, Failure> {
    let all: Vec<_> = spec.topics.iter().filter(|topic| !topic.commands.is_empty()).collect();
    let wanted: Vec<_> = all.iter().filter(|known| topic.is_empty() || known.name == topic).collect();
    if wanted.is_empty() {
        let names: Vec<_> = all.iter().map(|known| known.name.as_str()).collect();
        return Err(Failure::Usage(format!("there is no topic `{topic}`; the topics are {}", names.join(", "))));
    }
    let sections: Vec<_> = wanted.iter().map(|topic| section(topic)).collect();
    Ok(sections.join("\n"))
}

fn section(topic: &Topic) -> String {
    let names: Vec<_> = topic.commands.iter().map(names).collect();
    let width = names.iter().map(String::len).max().unwrap_or_default();
    let row = |(name, command): (&String, &Command)| {
        format!("  {name:width$}  {}\n", help::about(command).replace('\n', " "))
    };
    let rows: String = names.iter().zip(&topic.commands).map(row).collect();
    format!("{}: {}\n{rows}", topic.name, visible(&topic.title))
}

/// The names that a command can be called by.
fn names(command: &Command) -> String {
    if command.name == command.wire { command.wire.clone() } else { format!("{}, {}", command.wire, command.name) }
}
