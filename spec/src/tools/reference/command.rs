//! One command.

use std::fmt::Write as _;

use super::markdown::{code, escape};
use super::{command_heading, fields};
use crate::words;
use crate::{Command, Reply, Request, Spec};

/// All there is to know about a command.
pub(super) fn render(out: &mut String, spec: &Spec, command: &Command) {
    let _ = writeln!(out, "### {}\n\n{}\n", command_heading(command), escape(&command.doc));
    for fact in facts(command) {
        let _ = writeln!(out, "- {}", escape(&fact));
    }
    *out += "\n";
    request(out, spec, command);
    reply(out, spec, command);
    if !command.errata.is_empty() {
        *out += "**Errata**\n\n";
        for erratum in &command.errata {
            let _ = writeln!(out, "- {}", escape(erratum));
        }
        *out += "\n";
    }
    examples(out, command);
}

/// What can be said in a line each.
fn facts(command: &Command) -> Vec<String> {
    let mut facts =
        vec![format!("Effect: {}.", words::effect(command.effect)), format!("In Rust: `Client::{}`.", command.name)];
    if let Some(title) = &command.title_zh {
        facts.push(format!("In the document: {title}."));
    }
    if let Some(evidence) = &command.evidence {
        facts.push(format!("Not in the document. {evidence}"));
    }
    if let Some(states) = words::requirements(&command.requires) {
        let refusal = command.refusal.as_ref().map(|refusal| {
            format!(" Otherwise the controller answers error code {}, `{}`.", refusal.code, refusal.message)
        });
        let source = command.requires_source.as_ref().map(|source| format!(" Source: {source}"));
        facts.push(format!("The robot must be {states}.{}{}", refusal.unwrap_or_default(), source.unwrap_or_default()));
    }
    if let Some(deadline) = command.deadline {
        facts.push(format!("The reply may take up to {} s.", deadline.as_secs_f64()));
    }
    if !command.reply_certain {
        facts.push("The controller may close the connection instead of replying.".to_owned());
    }
    if command.ends_session {
        facts.push("The connection is of no use after the reply.".to_owned());
    }
    facts.extend(words::known_to(command));
    if let Some(instead) = &command.deprecated {
        facts.push(format!("Withdrawn by the vendor: {instead}."));
    }
    if let Some(evidence) = &command.reconstructed {
        facts.push(format!("Reconstructed: {evidence}"));
    }
    facts
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
            let name = super::types::name_link(&spec[*id].name);
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
