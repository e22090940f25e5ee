//! Whether the examples of a command fit its fields.

use std::fmt;

use serde_json::{Map, Value};

use super::{AdvisoryRanges, Departure, DepartureKind, Node, Reading};
use jaka_spec::{COMMAND_NAME, Command, Example, Spec};

/// An example of a command that is not as the command's fields have it.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Misfit {
    /// The command, by its `cmdName`.
    pub command: String,
    /// The example's message, as the spec has it.
    pub message: String,
    /// True for a request, false for a reply.
    pub is_request: bool,
    /// What does not fit.
    pub what: String,
    /// True for a reply that can still be read, such as one with a number written as a string.
    pub is_lenient: bool,
}

/// Such as ``command `rapid_rate`, request of an example: field `rate_value` is 2; allowed is a number from 0 to 1``.
impl fmt::Display for Misfit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { command, what, is_request, .. } = self;
        let part = if *is_request { "request" } else { "reply" };
        write!(f, "command `{command}`, {part} of an example: {what}")
    }
}

/// Everything in the examples of a command that does not fit its fields, in their order.
///
/// A request must be one that the client would send, except for ranges that newer firmware has widened. A reply must have no key that the
/// spec does not know; where it departs from the spec in another way and can still be read, the misfit is lenient.
pub fn misfits(spec: &Spec, command: &Command) -> Vec<Misfit> {
    command.examples.iter().flat_map(|example| of_example(spec, command, example)).collect()
}

fn of_example(spec: &Spec, command: &Command, example: &Example) -> Vec<Misfit> {
    let mut found = Vec::new();
    let mut add = |message: &str, is_request, what: Vec<(String, bool)>| {
        found.extend(what.into_iter().map(|(what, is_lenient)| Misfit {
            command: command.wire.clone(),
            message: message.to_owned(),
            is_request,
            what,
            is_lenient,
        }));
    };
    if let Some(request) = &example.request {
        let problems = of_request(spec, command, request);
        add(request, true, problems.into_iter().map(|problem| (problem, false)).collect());
    }
    if let Some(reply) = &example.reply {
        add(reply, false, of_reply(spec, command, reply));
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
        // Names that are not those of the wire can be written, but not read.
        Ok(_) => Node::request(spec, command, message).problems(),
        Err(problems) => problems,
    };
    problems.iter().map(ToString::to_string).collect()
}

fn of_reply(spec: &Spec, command: &Command, reply: &str) -> Vec<(String, bool)> {
    let message = match serde_json::from_str(reply) {
        Ok(message) => message,
        // A bare Python tuple, perhaps.
        Err(_) => Value::String(reply.to_owned()),
    };
    Node::reply(spec, command, message).departures().iter().map(misfit).collect()
}

/// What departs, and whether that is lenient: a key that the spec does not know is skipped, but belongs to no example.
fn misfit(departure: &Departure) -> (String, bool) {
    let is_lenient = departure.reading == Reading::Lenient && departure.kind != DepartureKind::Unknown;
    let text = departure.to_string();
    // Without the reading, which the misfit has in its own terms.
    let what = text.split_once(": ").map_or(&*text, |(_reading, what)| what);
    (what.to_owned(), is_lenient)
}
