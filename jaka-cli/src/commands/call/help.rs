//! Texts of the command list and of the help of one command, from the spec.

use std::borrow::Cow;
use std::fmt::Write;

use itertools::Itertools as _;
use jaka_dynamic::{Argument, arguments};
use jaka_spec::words::{first_sentence, requirements};
use jaka_spec::{Command, Reply, Request, Spec, Topic, evidence_sentence};
use jaka_sync::proto::text::{visible, visible_lines};

use crate::arm::consent::effect;
use crate::failure::Failure;
use crate::terminal::output;

/// Returns the description of a command, in one sentence.
pub(super) fn about(command: &Command) -> Cow<'_, str> {
    visible_lines(first_sentence(&command.doc).0)
}

/// Returns the description of a command with its facts, such as its effect and required states, its errata and its
/// evidence.
pub(super) fn long_about(command: &Command) -> String {
    let mut text = format!("{}\n\n{}", command.doc, facts(command).join("\n"));
    for erratum in &command.errata {
        // Writing to a string cannot fail.
        let _ = write!(text, "\n\nErratum: {erratum}");
    }
    if let Some(evidence) = evidence_sentence(&command.evidence) {
        let _ = write!(text, "\n\nNot in the document. {evidence}");
    }
    if let Some(evidence) = &command.reconstructed {
        let _ = write!(text, "\n\nThe document's text is lost. Evidence: {evidence}");
    }
    visible_lines(&text).into_owned()
}

fn facts(command: &Command) -> Vec<String> {
    let mut facts = vec![format!("Command: {} (`cmdName`), {} (Rust)", command.wire, command.name)];
    facts.extend(command.section.as_ref().map(|section| format!("Section: {section} of the vendor's document")));
    facts.push(format!("Effect:  {}", effect(command.effect)));
    facts.extend(requirements(&command.requires).map(|states| format!("Needs:   {states}")));
    facts.extend(command.deadline.map(|deadline| format!("Reply:   within {} s", deadline.as_secs_f64())));
    facts.extend(command.versions.since.as_ref().map(|version| format!("Since:   firmware {version}")));
    facts.extend(command.versions.until.as_ref().map(|version| format!("Until:   firmware {version}")));
    facts.extend(command.deprecated.as_ref().map(|instead| format!("Withdrawn by the vendor; instead: {instead}")));
    facts
}

/// Returns the meaning of the reply's fields.
pub(super) fn notes(spec: &Spec, command: &Command) -> String {
    // The description of request fields applies to reply fields as well.
    let as_request = Command { request: Request::Fields(spec.reply_fields(command).to_vec()), ..command.clone() };
    let fields = arguments(spec, &as_request);
    if command.reply == Reply::Raw {
        return "Reply:\n  keys that the spec does not fix".to_owned();
    }
    if fields.is_empty() {
        return "Reply:\n  accepted, or refused with code and message".to_owned();
    }
    let row = |field: &Argument| (format!("  {}", field.field), field.help.replace('\n', " "));
    let rows: Vec<_> = fields.iter().map(row).collect();
    visible_lines(format!("Reply:\n{}", output::aligned(&rows)).trim_end()).into_owned()
}

/// Returns a field's help: its meaning, and its variants.
pub(super) fn field(argument: &Argument) -> String {
    let mut help = visible(&argument.help.replace('\n', " ")).into_owned();
    if !argument.variants.is_empty() {
        help = format!("{help} [with {}]", argument.variants.join(", "));
    }
    if argument.required { help + " [required]" } else { help }
}

/// Returns the usage line of a command: its required fields, and a placeholder for the rest.
pub(super) fn usage(command: &Command, arguments: &[Argument], longs: &[String]) -> String {
    let mut usage = format!("jaka call {}", command.wire);
    for (argument, long) in arguments.iter().zip(longs) {
        if argument.required && argument.variants.is_empty() {
            usage = format!("{usage} --{long} <{}>", argument.hint);
        }
    }
    let has_more = arguments.iter().any(|argument| !argument.required || !argument.variants.is_empty());
    usage + if has_more { " [FIELDS] [OPTIONS]" } else { " [OPTIONS]" }
}

/// Returns the commands by topic, with one sentence each; those of one topic if it is named.
///
/// # Errors
/// The topic is unknown; the message lists the topics.
pub(super) fn list(spec: &Spec, topic: &str) -> Result<String, Failure> {
    let all: Vec<_> = spec.topics.iter().filter(|topic| !topic.commands.is_empty()).collect();
    let wanted: Vec<_> = all.iter().filter(|known| topic.is_empty() || known.name == topic).collect();
    if wanted.is_empty() {
        let names = all.iter().map(|known| &known.name).join(", ");
        return Err(Failure::Usage(format!("there is no topic `{topic}`; the topics are {names}")));
    }
    Ok(wanted.iter().map(|topic| section(topic)).join("\n"))
}

fn section(topic: &Topic) -> String {
    let row = |command: &Command| (format!("  {}", names(command)), about(command).replace('\n', " "));
    let rows: Vec<_> = topic.commands.iter().map(row).collect();
    format!("{}: {}\n{}", topic.name, visible(&topic.title), output::aligned(&rows))
}

/// Returns the names of a command.
fn names(command: &Command) -> String {
    if command.name == command.wire { command.wire.clone() } else { format!("{}, {}", command.wire, command.name) }
}
