//! Replies and status packets compared with the spec.

use jaka_proto::ErrorCode;
use serde_json::{Map, Value};

use super::decode::Decoder;
use super::departure::{Departure, DepartureKind, Reading};
use super::scalar::{Fit, error_code};
use jaka_spec::{COMMAND_NAME, Command, ENVELOPE, ERROR_CODE, ERROR_MESSAGE, Reply, Spec};

/// How a reply differs from the spec: in its envelope, in unknown keys, and then in the order of the spec.
///
/// Of a refusal only the envelope is compared, for it carries no payload. A bare Python tuple, which some firmware
/// sends in place of a reply, is given as a JSON string.
///
/// Of a key that comes twice, a [`Value`] has the last alone, and a number with a fraction is rounded: what parses the reply
/// must refuse such, as the decoder of jaka-proto does for a [`Value`]. A client that uses jaka-sync never gets a reply in which
/// one of the three keys of the envelope comes twice and says different things.
pub fn departures(spec: &Spec, command: &Command, reply: &Value) -> Vec<Departure> {
    let mut decoder = Decoder::new(spec);
    match (reply, bare_reply(command, reply)) {
        (Value::Object(found), _) => {
            if envelope(&mut decoder, command, found) && command.reply != Reply::Raw {
                decoder.object("", spec.reply_fields(command), found, ENVELOPE);
            }
        }
        (_, Some(found)) => {
            decoder.add("", DepartureKind::Form, reply, "an object".to_owned(), Reading::Lenient);
            decoder.object("", spec.reply_fields(command), &found, ENVELOPE);
        }
        (other, None) => decoder.add("", DepartureKind::Form, other, "an object".to_owned(), Reading::Unreadable),
    }
    decoder.departures
}

/// The reply that a bare Python tuple stands for.
fn bare_reply(command: &Command, reply: &Value) -> Option<Map<String, Value>> {
    let name = command.bare_reply.as_ref()?;
    let field = command.reply.own_fields().iter().find(|field| field.name == *name)?;
    let is_tuple = reply.as_str()?.trim_start().starts_with('(');
    is_tuple.then(|| Map::from_iter([(field.wire.clone(), reply.clone())]))
}

/// How a packet of port 10000 differs from the spec: in unknown keys, and then in the order of the spec.
pub fn status_departures(spec: &Spec, packet: &Value) -> Vec<Departure> {
    let mut decoder = Decoder::new(spec);
    match packet {
        Value::Object(found) => decoder.object("", spec.status_fields(), found, &[]),
        other => decoder.add("", DepartureKind::Form, other, "an object".to_owned(), Reading::Unreadable),
    }
    decoder.departures
}

/// Reads the keys that every reply has; true if the reply is one of success, whose payload follows.
fn envelope(decoder: &mut Decoder<'_>, command: &Command, found: &Map<String, Value>) -> bool {
    let value = |key: &str| found.get(key).unwrap_or(&Value::Null);
    let (name, code, message) = (value(COMMAND_NAME), value(ERROR_CODE), value(ERROR_MESSAGE));
    let lenient = Fit::Lenient(DepartureKind::Form);
    let name_fit = match name.as_str() {
        Some(text) if text == command.wire => Fit::Plain,
        Some(text) if text.trim() != command.wire => Fit::Unfit,
        _ => lenient,
    };
    let code_fit = match error_code(code) {
        Some(number) if code.as_str() == Some(&*number.to_string()) => Fit::Plain,
        Some(_) => lenient,
        None => Fit::Unfit,
    };
    let message_fit = if message.is_string() { Fit::Plain } else { lenient };
    let mut part = |key: &str, value: &Value, expected: &str, fit: Fit| {
        let kind = if value.is_null() { DepartureKind::Missing } else { DepartureKind::Form };
        let reading = match fit {
            Fit::Plain => return,
            Fit::Lenient(_) => Reading::Lenient,
            Fit::Unfit => Reading::Unreadable,
        };
        decoder.add(key, kind, value, expected.to_owned(), reading);
    };
    part(ERROR_CODE, code, "text of decimal digits", code_fit);
    part(ERROR_MESSAGE, message, "text", message_fit);
    part(COMMAND_NAME, name, &format!("`{}`", command.wire), name_fit);
    is_success(found)
}

/// True for the reply to a command that was carried out.
pub(super) fn is_success(reply: &Map<String, Value>) -> bool {
    reply.get(ERROR_CODE).and_then(error_code).is_some_and(ErrorCode::is_success)
}
