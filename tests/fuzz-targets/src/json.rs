//! Messages by the model at run time, against the generated code.

use jaka_proto::check::AdvisoryRanges as Ranges;
use jaka_proto::wire::{DecodeError, Writer};
use jaka_proto::{Envelope, ErrorCode, Request, Visit, read_payload};
use jaka_spec::Command;
use jaka_spec::json::{self, AdvisoryRanges, Reading};
use serde_json::{Map, Value};

use crate::builtin::{COMMANDS, SPEC};

/// A JSON object is taken for a request and for a reply of the command that it names: the model and the generated code agree on
/// what can be read, what is allowed and how it is written. Other text is taken for a command, an argument and what was typed
/// for it, a line each.
///
/// # Panics
/// They do not agree.
pub fn json(data: &[u8]) {
    let Ok(text) = std::str::from_utf8(data) else { return };
    let Ok(Value::Object(message)) = serde_json::from_str(text) else { return typed(text) };
    let named = message.get("cmdName").and_then(Value::as_str).and_then(|name| SPEC.command(name.trim()));
    let Some(command) = named else { return };
    // `serde_json` takes what nests deeper.
    if Envelope::read(&Value::from(message.clone()).to_string()).is_err() {
        return;
    }
    check_request(command, &message);
    check_reply(command, &message);
    write_request(command, message);
}

fn check_request(command: &Command, message: &Map<String, Value>) {
    let text = Value::from(message.clone()).to_string();
    let problems = json::check_request(&SPEC, command, message);
    let request = Request::read(&text);
    let is_allowed = request.as_ref().is_ok_and(|request| request.check(Ranges::Ignored).is_ok());
    assert_eq!(problems.is_empty(), is_allowed, "{problems:?} {request:?}");
}

fn check_reply(command: &Command, message: &Map<String, Value>) {
    let reply = Value::from(message.clone());
    let text = reply.to_string();
    let departures = json::departures(&SPEC, command, &reply);
    let envelope = Envelope::read(&text).expect("it is a JSON object");
    if envelope.code.is_ok_and(ErrorCode::is_success) {
        let is_readable = departures.iter().all(|departure| departure.reading == Reading::Lenient);
        let decoded = COMMANDS[command.wire.as_str()].visit(Decode(&text));
        // Of keys that appear twice, which literals can have, the model sees the last.
        let is_repeated = decoded.as_ref().is_err_and(|error| error.to_string().ends_with("the key appears twice"));
        // In a literal, a number that is not whole may be so as the float that the model sees.
        let is_rounded = decoded.as_ref().is_err_and(|error| is_rounded_to_whole(&error.to_string()));
        assert!(is_readable == decoded.is_ok() || is_repeated || is_rounded, "{departures:?} {decoded:?} {text}");
    }
}

/// Whether an error shows a number that is whole as a float.
fn is_rounded_to_whole(error: &str) -> bool {
    let found = error.rsplit('`').nth(1).map(|found| found.trim_matches('"').trim().parse::<f64>());
    found.is_some_and(|found| found.is_ok_and(|found| found.fract() == 0.0))
}

/// Reads a reply.
struct Decode<'t>(&'t str);

impl Visit for Decode<'_> {
    type Output = Result<(), DecodeError>;

    fn visit<C: jaka_proto::Command>(self, _command: &C) -> Self::Output {
        read_payload::<C::Reply>(C::INFO, self.0).map(drop)
    }
}

fn write_request(command: &Command, mut fields: Map<String, Value>) {
    fields.remove("cmdName");
    json::request(&SPEC, command, &fields, AdvisoryRanges::Ignored).ok();
    let Ok(text) = json::request(&SPEC, command, &fields, AdvisoryRanges::Enforced) else { return };
    let request = Request::read(&text).unwrap_or_else(|error| panic!("{error:?}: {text}"));
    let mut out = Writer::new();
    request.write(&mut out);
    assert_eq!(out.as_str(), text);
    assert_eq!(request.check(Ranges::Enforced), Ok(()), "{text}");
}

/// Reads what was typed for an argument, and writes a request with it.
fn typed(text: &str) {
    let mut lines = text.splitn(3, '\n');
    let (Some(command), Some(name), Some(value)) = (lines.next(), lines.next(), lines.next()) else { return };
    let Some(command) = SPEC.command(command) else { return };
    let arguments = json::arguments(&SPEC, command);
    let Some(argument) = arguments.iter().find(|argument| argument.name == name) else { return };
    if let Ok(value) = argument.value(&SPEC, value) {
        write_request(command, Map::from_iter([(argument.field.clone(), value)]));
    }
}
