//! Queries of the command port.

use itertools::Itertools as _;
use jaka_dynamic::{AdvisoryRanges, Node};
use jaka_spec::{Command, Effect, Spec};
use jaka_sync::{Client, Disconnect, Error, ErrorCode, ErrorKind};
use serde_json::Map;

use super::finding::{Finding, Outcome};
use super::progress::ProbeProgress;
use crate::commands::call::reply_json;
use crate::failure::{Failure, chain, fact};
use crate::target::Target;

/// Greatest number of reconnections, to limit the load on a controller that ends the connection on every query.
const MOST_RECONNECTS: u32 = 3;

/// Sends every query that needs no argument, and nothing else.
///
/// # Errors
/// The first connection fails, or is closed before a reply, as by a controller whose seat is occupied. A later error is
/// a finding.
pub(super) fn ask_all(spec: &Spec, target: &Target, progress: &ProbeProgress) -> Result<Vec<Finding>, Failure> {
    let mut connection = ProbeConnection { target, client: Ok(target.client()?), has_answered: false, reconnects: 0 };
    let queries: Vec<_> = spec.commands().filter(|command| command.effect == Effect::Query).collect();
    let ask = |(number, command): (usize, &&Command)| {
        if progress.is_interrupted() {
            return Ok(Finding::without(command.wire.as_str(), Outcome::NotProbed("interrupted".to_owned())));
        }
        progress.show(number, queries.len(), &command.wire);
        connection.ask(spec, command)
    };
    let findings = queries.iter().enumerate().map(ask).collect();
    progress.clear();
    findings
}

/// Connection to the controller, replaced when it breaks.
struct ProbeConnection<'t> {
    target: &'t Target,
    /// Connection, or the reason for its absence.
    client: Result<Client, String>,
    has_answered: bool,
    reconnects: u32,
}

impl ProbeConnection<'_> {
    fn ask(&mut self, spec: &Spec, command: &Command) -> Result<Finding, Failure> {
        let name = command.wire.as_str();
        let not_probed = |why| Ok(Finding::without(name, Outcome::NotProbed(why)));
        let required: Vec<_> =
            jaka_dynamic::arguments(spec, command).into_iter().filter(|argument| argument.required).collect();
        if !required.is_empty() {
            let names = required.iter().map(|argument| format!("`{}`", argument.wire));
            return not_probed(format!("it needs {}", names.format(", ")));
        }
        let Ok(request) = jaka_dynamic::request(spec, command, &Map::new(), AdvisoryRanges::Enforced) else {
            return not_probed("the spec does not allow it without arguments".to_owned());
        };
        let client = match &mut self.client {
            Ok(client) => client,
            Err(why) => return not_probed(why.clone()),
        };
        let usual = client.reply_timeout().max(command.deadline.unwrap_or_default());
        let timeout = self.target.patience(usual);
        let asked = client.call_text(&request, timeout).map(drop);
        let reply = client.last_reply().unwrap_or_default().to_owned();
        let finding = |reply: String| {
            let departures = Node::reply(spec, command, reply_json(&reply)).departures();
            Finding::of(name, departures, reply)
        };
        let Err(error) = asked else {
            self.has_answered = true;
            return Ok(finding(reply));
        };
        let found = match error.kind() {
            ErrorKind::Refused { refusal, .. } => {
                let outcome = Outcome::Refused { code: refusal.code, message: refusal.message.clone() };
                // Firmware refuses unknown commands in this way, without a name.
                let is_unknown = !command.evidence.is_empty() && refusal.code == ErrorCode::EXCEPTION;
                let finding = finding(reply);
                let departures = if is_unknown { Vec::new() } else { finding.departures };
                Finding { outcome, departures, ..finding }
            }
            ErrorKind::UnexpectedReply { source, .. } => {
                Finding { outcome: Outcome::Unreadable(source.to_string()), ..finding(reply) }
            }
            _ => {
                let outcome = unanswered(&error);
                if error.is_disconnected() {
                    if !self.has_answered && matches!(outcome, Outcome::NoReply(_)) {
                        return Err(error.into());
                    }
                    self.reconnect(name);
                }
                return Ok(Finding::without(name, outcome));
            }
        };
        self.has_answered = true;
        Ok(found)
    }

    fn reconnect(&mut self, command: &str) {
        self.reconnects += 1;
        self.client = if self.reconnects > MOST_RECONNECTS {
            Err(format!("the connection broke {} times, the last time at `{command}`", self.reconnects))
        } else {
            let again = self.target.client();
            again.map_err(|failure| {
                format!("the connection broke at `{command}`, and reconnecting failed: {}", chain(&failure))
            })
        };
    }
}

/// Returns the outcome of an error without a reply: bytes came that are not a message, or nothing came.
fn unanswered(error: &Error) -> Outcome {
    match error.kind() {
        ErrorKind::Timeout { after, .. } => Outcome::NoReply(format!("none within {after:?}")),
        ErrorKind::Disconnected { cause, .. } => match &**cause {
            Disconnect::Frame(_) | Disconnect::NotJson(_) | Disconnect::OutOfSync(_) => {
                Outcome::Unreadable(chain(&**cause))
            }
            _ => Outcome::NoReply(chain(&**cause)),
        },
        _ => Outcome::NoReply(fact(error.kind(), error)),
    }
}
