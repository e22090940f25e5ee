//! `jaka explain`: meaning of a code or a refusal of the controller, and a remedy.

use std::fmt::Write as _;

use clap::Args;
use jaka_spec::words::{event_code, requirements};
use jaka_spec::{Command, ErrorCode, Event, Spec};
use jaka_sync::proto::text::visible_lines;
use serde_json::Value;

use crate::builtin::of_status;
use crate::choice::{Choice, one_of};
use crate::failure::Failure;
use crate::packets::event::{Language, note};
use crate::target::Lookup;
use crate::target::packs::SpecArgs;
use crate::terminal::output;

/// Explain a code or a refusal of the controller
///
/// Does not connect to a robot. A code is one of `errcode` on the status port, such as `0x0F0034`, or 983092 in decimal
/// digits, or an `errorCode` of a reply, such as -1. A refusal is its message, such as `call joint_move failed`, or the
/// whole reply.
#[derive(Debug, Args)]
pub(crate) struct Explain {
    /// Code, message or reply
    #[arg(required = true, num_args = 1.., value_name = "CODE", allow_negative_numbers = true)]
    text: Vec<String>,
    /// Language of events
    #[arg(long, value_name = "LANGUAGE", default_value = "en", value_parser = one_of(&LANGUAGES))]
    lang: Language,
    #[command(flatten)]
    spec: SpecArgs,
}

const LANGUAGES: [Choice<Language>; 2] = [("en", "English", Language::English), ("zh", "Chinese", Language::Chinese)];

impl Explain {
    pub(crate) fn run(&self) -> Result<(), Failure> {
        self.spec.load(Lookup::default())?.read_status();
        let text = self.text.join(" ");
        let explained = explain(of_status(), text.trim(), self.lang);
        let explained = explained.ok_or_else(|| Failure::Usage(unknown(text.trim())))?;
        output::write(visible_lines(&explained).as_bytes())
    }
}

/// Returns the message for an unknown text.
fn unknown(text: &str) -> String {
    match number(text).as_slice() {
        [] => format!(
            "`{text}` is not a code, nor a refusal of the spec; examples: the code 0x0F0034, the refusal `call joint_move failed`"
        ),
        _ => format!(
            "the code {text} is not in the spec; newer firmware has codes that no table lists, and it may be an error"
        ),
    }
}

/// Returns the explanation of a text; `None` if the spec has none.
fn explain(spec: &'static Spec, text: &str, language: Language) -> Option<String> {
    if let Some(refusal) = of_reply(spec, text) {
        return Some(refusal);
    }
    if let Some(known) = text.parse().ok().and_then(|wire: i64| spec.errors().find(|known| known.wire == wire)) {
        return Some(error_code(known));
    }
    let codes = number(text);
    let events: String =
        codes.iter().filter_map(|code| Some(event(spec, *code, spec.event(*code)?, language))).collect();
    if !events.is_empty() {
        return Some(events);
    }
    refusal(spec, None, text, None)
}

/// Returns the readings of a text as a code: hexadecimal with `0x` or with a letter; else decimal, and hexadecimal too.
fn number(text: &str) -> Vec<u32> {
    let digits = text.strip_prefix("0x").or_else(|| text.strip_prefix("0X"));
    let is_number = |digits: &str| !digits.is_empty() && digits.bytes().all(|digit| digit.is_ascii_hexdigit());
    let hexadecimal = |digits: &str| u32::from_str_radix(digits, 16).ok();
    match digits {
        Some(digits) if is_number(digits) => hexadecimal(digits).into_iter().collect(),
        None if is_number(text) => text.parse().ok().into_iter().chain(hexadecimal(text)).collect(),
        _ => Vec::new(),
    }
}

fn event(spec: &'static Spec, code: u32, event: &'static Event, language: Language) -> String {
    let (texts, labels) = match language {
        Language::English => (&event.texts, ["meaning", "joint", "cause", "remedy", "family"]),
        Language::Chinese => (&event.texts_zh, ["含义", "关节", "原因", "措施", "类别"]),
    };
    let note = |text| note(spec, event, language, text).map(|note| note.to_string());
    let values = [
        texts.meaning.clone(),
        event.joint(code).map(|joint| joint.to_string()),
        note(|texts| texts.cause.as_deref()),
        note(|texts| texts.remedy.as_deref()),
        event.family.clone(),
    ];
    let mut out = format!("{} ({}), event of the controller\n", event_code(code), event.severity.word());
    for (label, value) in labels.into_iter().zip(values) {
        if let Some(value) = value {
            let _ = writeln!(out, "  {label}: {value}");
        }
    }
    out
}

fn error_code(known: &ErrorCode) -> String {
    let mut out = format!("errorCode {}, {}\n", known.wire, known.name);
    for line in known.doc.lines().filter(|line| !line.is_empty()) {
        let _ = writeln!(out, "  {line}");
    }
    out
}

/// Returns the explanation of a whole reply.
fn of_reply(spec: &Spec, text: &str) -> Option<String> {
    let reply: Value = serde_json::from_str(text).ok().filter(Value::is_object)?;
    let word = |key: &str| match &reply[key] {
        Value::String(text) => Some(text.clone()),
        Value::Number(number) => Some(number.to_string()),
        _ => None,
    };
    let command = word("cmdName").and_then(|name| spec.command(name.trim()).cloned());
    let code = word("errorCode").and_then(|code| code.trim().parse().ok());
    refusal(spec, code, &word("errorMsg").unwrap_or_default(), command.as_ref())
}

/// Returns the explanation of a refusal by its message, its code and its command, as far as available.
fn refusal(spec: &Spec, code: Option<i64>, message: &str, command: Option<&Command>) -> Option<String> {
    let failed = message.strip_prefix("call ").and_then(|rest| rest.strip_suffix(" failed"));
    let refused = |command: &&Command| command.refusal.as_ref().is_some_and(|known| known.message == message);
    let command =
        command.or_else(|| failed.and_then(|name| spec.command_called(name))).or_else(|| spec.commands().find(refused));
    let of_failed = || spec.errors().find(|known| known.name == "CallFailed").map(|known| known.wire);
    let code = code
        .or_else(|| failed.and_then(|_| of_failed()))
        .or_else(|| command.and_then(|command| command.refusal.as_ref()).map(|refusal| refusal.code));
    let says = |known: &&ErrorCode| {
        let by_message = !message.is_empty() && known.message.as_deref() == Some(message);
        code.map_or(by_message, |code| known.wire == code)
    };
    let known = spec.errors().find(says);
    if known.is_none() && command.is_none() {
        return None;
    }
    let mut out = known.map(error_code).unwrap_or_default();
    if let Some(command) = command {
        let _ = writeln!(out, "`{}`", command.wire);
        if let Some(states) = requirements(&command.requires) {
            let _ = writeln!(out, "  needs: the robot must be {states}; `jaka status` shows whether it is");
        }
        for cause in &command.refused_because {
            let _ = writeln!(out, "  known cause: {cause}");
        }
    }
    Some(out)
}
