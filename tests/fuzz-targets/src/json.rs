//! Messages by the model at run time, against the generated code.

use jaka_dynamic::{AdvisoryRanges, Node, Reading};
use jaka_proto::wire::{DecodeError, Writer};
use jaka_proto::{Envelope, ErrorCode, Request, Visit, read_payload};
use jaka_spec::Command;
use serde_json::{Map, Value};

use crate::builtin::{COMMANDS, SPEC};

/// A JSON object is taken for a request and for a reply of the command that it names: the model and the generated code
/// agree on what can be read, what is allowed and how it is written. Other text is taken for a command, an argument and
/// what was typed for it, a line each.
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
    let problems = Node::request(&SPEC, command, message.clone()).problems();
    let request = Request::read(&text);
    let is_allowed = request.as_ref().is_ok_and(|request| request.check(AdvisoryRanges::Ignored).is_ok());
    assert_eq!(problems.is_empty(), is_allowed, "{problems:?} {request:?}");
}

fn check_reply(command: &Command, message: &Map<String, Value>) {
    let reply = Value::from(message.clone());
    let text = reply.to_string();
    let departures = Node::reply(&SPEC, command, reply).departures();
    let envelope = Envelope::read(&text).expect("it is a JSON object");
    if envelope.code.is_ok_and(ErrorCode::is_success) {
        let is_readable = departures.iter().all(|departure| departure.reading == Reading::Lenient);
        let decoded = COMMANDS[command.wire.as_str()].visit(Decode(&text));
        // A float takes a number of a literal that it rounds to a whole one, and a JSON value does not.
        let is_rounded = departures.iter().any(|departure| departure.expected.ends_with("Python literal"));
        assert!(is_readable == decoded.is_ok() || is_rounded, "{departures:?} {decoded:?} {text}");
    }
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
    jaka_dynamic::request(&SPEC, command, &fields, AdvisoryRanges::Ignored).ok();
    let Ok(text) = jaka_dynamic::request(&SPEC, command, &fields, AdvisoryRanges::Enforced) else { return };
    let request = Request::read(&text).unwrap_or_else(|error| panic!("{error:?}: {text}"));
    let mut out = Writer::new();
    request.write(&mut out);
    assert_eq!(out.as_str(), text);
    assert_eq!(request.check(AdvisoryRanges::Enforced), Ok(()), "{text}");
}

/// Reads what was typed for an argument, and writes a request with it.
fn typed(text: &str) {
    let mut lines = text.splitn(3, '\n');
    let (Some(command), Some(name), Some(value)) = (lines.next(), lines.next(), lines.next()) else { return };
    let Some(command) = SPEC.command(command) else { return };
    let arguments = jaka_dynamic::arguments(&SPEC, command);
    let Some(argument) = arguments.iter().find(|argument| argument.name == name) else { return };
    if let Ok(value) = argument.value(&SPEC, value) {
        write_request(command, Map::from_iter([(argument.field.clone(), value)]));
    }
}
