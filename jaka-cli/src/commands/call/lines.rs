//! Lines of JSON on standard input, one request each, over one connection.

use std::io::{BufRead, stdin};

use jaka_dynamic::Node;
use jaka_spec::COMMAND_NAME;
use serde_json::{Value, json};

use super::exchange::Connection;
use super::options::Options;
use super::request::Request;
use super::{consent, exchange, reply, request, wait};
use crate::arm::interrupt::{Stage, UnderWay};
use crate::arm::motion;
use crate::failure::{Failure, chain};
use crate::target::Target;
use crate::target::packs::Protocol;
use crate::target::seat;
use crate::terminal::exit;
use crate::terminal::output;

/// Carries out the request of each line, and prints a line for each. Ends at the first failure, except with
/// `--keep-going`.
///
/// # Errors
/// The first failure.
pub(super) fn carry_out(protocol: &Protocol, options: &Options) -> Result<(), Failure> {
    let under_way = UnderWay::begin();
    let target = options.robot.target(&protocol.packs)?;
    if !options.yes {
        seat::warn(&options.robot);
        consent::warn_of_stops(protocol, options);
    }
    let connection = Connection::open(&target, options)?;
    let mut session = LineSession { protocol, options, target, connection, under_way };
    let mut first = Ok(());
    session.under_way.set(Stage::Idle);
    for line in stdin().lock().lines() {
        let line = line.map_err(|error| Failure::local("cannot read standard input", error))?;
        if line.trim().is_empty() {
            continue;
        }
        let (answer, failure) = session.answer(&line);
        session.under_way.set(Stage::Idle);
        output::json(&format!("{answer}\n"))?;
        if let Some(failure) = failure {
            first = first.and(Err(failure));
            if !options.keep_going {
                break;
            }
        }
    }
    first
}

struct LineSession<'s> {
    protocol: &'s Protocol,
    options: &'s Options,
    target: Target,
    connection: Connection,
    under_way: UnderWay,
}

impl LineSession<'_> {
    /// Carries out a line. Returns the value to print for it, and the failure, if there is one.
    fn answer(&mut self, line: &str) -> (Value, Option<Failure>) {
        let mut answer = json!({});
        if let Some(name) = named_in(line) {
            answer["command"] = name;
        }
        let failure = self.carry_out(line, &mut answer).err();
        if let Some(failure) = &failure {
            answer["error"] = chain(failure).into();
            answer["exit_code"] = exit::code(failure).into();
        }
        (answer, failure)
    }

    fn carry_out(&mut self, line: &str, answer: &mut Value) -> Result<(), Failure> {
        let spec = &self.protocol.spec;
        let request = request::of_text(spec, None, line, self.options.advisory_ranges)?;
        answer["command"] = request.name.as_str().into();
        self.allow(&request)?;
        let motion = if self.options.wait { wait::motion(self.protocol, &request)? } else { None };
        match (&mut self.connection, motion) {
            (Connection::Robot(robot), Some(motion)) => {
                let patience = self.target.patience(motion::PATIENCE);
                let ended = motion::end(robot, |robot| robot.run(&motion, patience), spec, &self.under_way)?;
                answer["end"] = output::as_json(serde_json::to_value(&ended.end))?;
                ended.reached()
            }
            (connection, _) => {
                let sent = exchange::send(connection.client(), &request, &self.target, &self.under_way);
                let reply = sent.map_err(|error| exchange::explained(spec, &self.target, error))?;
                let Some(text) = reply else {
                    answer["reply"] = Value::Null;
                    return Ok(());
                };
                let reply = Node::reply(spec, request.command, reply::json(&text));
                answer["reply"] = reply.named();
                exchange::must_fit(&request, &reply)
            }
        }
    }

    /// Returns an error if the request needs a confirmation, which this mode cannot ask for.
    fn allow(&self, request: &Request<'_>) -> Result<(), Failure> {
        if self.options.yes || self.options.robot.is_simulated() || consent::is_harmless(self.protocol, request) {
            return Ok(());
        }
        Err(Failure::Usage(format!(
            "`{}` was not sent: it {}; use --yes to send such commands from standard input",
            request.name,
            request.effect()
        )))
    }
}

/// Returns the command named in a line, also if it is not sent.
fn named_in(line: &str) -> Option<Value> {
    let request: Value = serde_json::from_str(line).ok()?;
    request.get(COMMAND_NAME).filter(|name| name.is_string()).cloned()
}
