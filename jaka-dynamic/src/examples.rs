//! Check of the examples of a command against its fields.

use std::fmt;

use serde_json::{Map, Value};

use super::{AdvisoryRanges, DepartureKind, Node, Reading};
use jaka_spec::{COMMAND_NAME, Command, Example, Spec};

/// Example of a command that does not fit the command's fields.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Misfit {
    /// The command's `cmdName`.
    pub command: String,
    /// Message of the example, as in the spec.
    pub message: String,
    /// Whether it is a request and not a reply.
    pub is_request: bool,
    /// Description of the misfit.
    pub what: String,
    /// Whether it is a reply that can still be read, such as one with a number written as a string.
    pub is_lenient: bool,
}

/// Writes one line, such as
/// ``command `rapid_rate`, request of an example: field `rate_value` is 2; allowed is a number from 0 to 1``.
impl fmt::Display for Misfit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { command, what, is_request, .. } = self;
        let part = if *is_request { "request" } else { "reply" };
        write!(f, "command `{command}`, {part} of an example: {what}")
    }
}

/// Returns all misfits between the examples of a command and its fields, in their order.
///
/// A request must be one that the client would send, except for ranges that newer firmware has widened. A reply must
/// have no key that the spec does not know. If it departs from the spec in another way and can still be read, the
/// misfit is lenient.
pub fn misfits(spec: &Spec, command: &Command) -> Vec<Misfit> {
    command.examples.iter().flat_map(|example| of_example(spec, command, example)).collect()
}

fn of_example(spec: &Spec, command: &Command, example: &Example) -> Vec<Misfit> {
    let misfit = |message: &str, what| {
        let (command, message) = (command.wire.clone(), message.to_owned());
        Misfit { command, message, is_request: true, what, is_lenient: false }
    };
    let mut found = Vec::new();
    if let Some(request) = &example.request {
        found.extend(of_request(spec, command, request).into_iter().map(|what| misfit(request, what)));
    }
    if let Some(reply) = &example.reply {
        // A reply that is not JSON may be a bare Python tuple.
        let message = serde_json::from_str(reply).unwrap_or_else(|_| Value::String(reply.clone()));
        found.extend(Node::reply(spec, command, message).departures().into_iter().map(|departure| {
            // The decoder skips a key that the spec does not know, but no example may have one.
            let is_lenient = departure.reading == Reading::Lenient && departure.kind != DepartureKind::Unknown;
            let text = departure.to_string();
            // The text is without the reading, since the misfit has its own.
            let what = text.split_once(": ").map_or(&*text, |(_reading, what)| what);
            Misfit { is_request: false, is_lenient, ..misfit(reply, what.to_owned()) }
        }));
    }
    found
}

fn of_request(spec: &Spec, command: &Command, request: &str) -> Vec<String> {
    let message: Map<String, Value> = match serde_json::from_str(request) {
        Ok(message) => message,
        Err(error) => return vec![format!("it is not a JSON object: {error}")],
    };
    let mut fields = message.clone();
    if fields.remove(COMMAND_NAME).as_ref().and_then(Value::as_str) != Some(&command.wire) {
        return vec![format!("its `{COMMAND_NAME}` is not that of the command")];
    }
    let problems = match super::request(spec, command, &fields, AdvisoryRanges::Ignored) {
        // The encoder takes other names than those on the wire, but the decoder does not.
        Ok(_) => Node::request(spec, command, message).problems(),
        Err(problems) => problems,
    };
    problems.iter().map(ToString::to_string).collect()
}
