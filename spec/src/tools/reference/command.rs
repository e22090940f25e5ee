//! One command.

use std::fmt::Write as _;

use super::markdown::{code, escape};
use super::{command_heading, fields, type_phrase};
use crate::{Command, Motion, Reply, Request, Spec, evidence_sentence, words};

/// All there is to know about a command.
pub(super) fn render(out: &mut String, spec: &Spec, command: &Command) {
    let _ = writeln!(out, "### {}\n\n{}\n", command_heading(command), escape(&command.doc));
    for fact in facts(command) {
        let _ = writeln!(out, "- {}", escape(&fact));
    }
    *out += "\n";
    request(out, spec, command);
    reply(out, spec, command);
    items(out, "Known causes of a refusal", &command.refused_because);
    items(out, "Errata", &command.errata);
    examples(out, command);
}

/// List with a heading; nothing without items.
fn items(out: &mut String, heading: &str, items: &[String]) {
    if !items.is_empty() {
        let _ = writeln!(out, "**{heading}**\n");
        for item in items {
            let _ = writeln!(out, "- {}", escape(item));
        }
        *out += "\n";
    }
}

/// Facts about the command, in a line each.
fn facts(command: &Command) -> impl Iterator<Item = String> {
    let facts = [
        Some(format!("Effect: {}.", command.effect.word())),
        command.role.map(|role| role.doc().to_owned()),
        words::changes(&command.changes).map(|changes| format!("Changes {changes}.")),
        command.motion.as_ref().map(|motion| motion_fact(command, motion)),
        Some(format!("In Rust: `Client::{}`.", command.name)),
        command.title_zh.as_ref().map(|title| format!("In the document: {title}.")),
        evidence_sentence(&command.evidence).map(|evidence| format!("Not in the document. {evidence}")),
        requirements(command),
        command.deadline.map(|deadline| format!("The reply may take up to {} s.", deadline.as_secs_f64())),
        (!command.reply_certain).then(|| "The controller may close the connection instead of replying.".to_owned()),
        command.ends_session.then(|| "The connection is of no use after the reply.".to_owned()),
        words::known_to(command),
        command.deprecated.as_ref().map(|instead| format!("Withdrawn by the vendor: {instead}.")),
        command.reconstructed.as_ref().map(|evidence| format!("Reconstructed: {evidence}")),
    ];
    facts.into_iter().flatten()
}

/// The motion by the keys of its fields.
fn motion_fact(command: &Command, motion: &Motion) -> String {
    let key = |name: &str| code(command.request_field(name).map_or(name, |field| &field.wire));
    format!("Motion: {}.", words::motion(motion, key))
}

fn requirements(command: &Command) -> Option<String> {
    let states = words::requirements(&command.requires)?;
    let refusal = command.refusal.as_ref().map(|refusal| {
        format!(" Otherwise the controller answers error code {}, `{}`.", refusal.code, refusal.message)
    });
    let source = command.requires_source.as_ref().map(|source| format!(" Source: {source}"));
    Some(format!("The robot must be {states}.{}{}", refusal.unwrap_or_default(), source.unwrap_or_default()))
}

fn request(out: &mut String, spec: &Spec, command: &Command) {
    match &command.request {
        Request::Fields(fields) if fields.is_empty() => *out += "**Request**: `cmdName` alone.\n\n",
        Request::Fields(fields) => {
            *out += "**Request**, in addition to `cmdName`:\n\n";
            fields::render(out, spec, fields, 0);
        }
        Request::Choice(choice) => {
            let tag = code(&choice.tag);
            let _ = writeln!(
                out,
                "**Request**, in addition to `cmdName`: {tag}, an integer that tells which keys follow.\n"
            );
            fields::variants(out, spec, choice);
        }
    }
}

fn reply(out: &mut String, spec: &Spec, command: &Command) {
    let fields = match &command.reply {
        Reply::Fields(fields) if fields.is_empty() => {
            *out += "**Reply**: `errorCode`, `errorMsg` and `cmdName` alone.\n\n";
            return;
        }
        Reply::Fields(fields) => fields,
        Reply::Object(id) => {
            let name = type_phrase::name_link(&spec[*id].name);
            let _ =
                writeln!(out, "**Reply**, in addition to `errorCode`, `errorMsg` and `cmdName`: the keys of {name}.\n");
            return;
        }
        Reply::Raw => {
            *out += "**Reply**, in addition to `errorCode`, `errorMsg` and `cmdName`: keys that this spec does not fix.\n\n";
            return;
        }
    };
    *out += "**Reply**, in addition to `errorCode`, `errorMsg` and `cmdName`:\n\n";
    fields::render(out, spec, fields, 0);
    let bare = command.bare_reply.as_ref().and_then(|name| fields.iter().find(|field| field.name == *name));
    if let Some(field) = bare {
        let _ = writeln!(out, "A bare Python tuple in place of a JSON reply stands for `{}`.\n", field.wire);
    }
}

fn examples(out: &mut String, command: &Command) {
    for example in &command.examples {
        let request = ("Sent", &example.request, example.request_is_ours);
        let reply = ("Answered", &example.reply, example.reply_is_ours);
        for (title, message, is_ours) in [request, reply] {
            if let Some(message) = message {
                let mark = if is_ours { " (values of our own)" } else { "" };
                let _ = writeln!(out, "{title}{mark}:\n\n```json\n{message}\n```\n");
            }
        }
    }
}
