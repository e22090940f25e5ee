//! The traffic of one arm in one round.

use std::sync::Arc;

use jaka_robot::Error;
use serde_json::{Value, json};

use super::account::{Connection, Fate};
use super::background::{Findings, Rate, Reader, count};
use super::calls;
use super::held::Held;
use super::host::{Host, Ports};
use super::random::Random;
use super::resources::Peak;
use super::session::{Session, config};
use super::tally::Tally;

/// After this many calls in a row without an answer the program reconnects.
const SILENT: u32 = 3;

/// One in this many connections is recorded.
const RECORDED: u32 = 3;

/// The arm, and who must know what happens to it.
#[derive(Debug, Clone)]
pub(super) struct Place {
    pub(super) host: Arc<Host>,
    pub(super) arm: u32,
    pub(super) ports: Ports,
    pub(super) rate: Rate,
    pub(super) findings: Findings,
    pub(super) peak: Arc<Peak>,
}

/// Record of an arm's program in a round: its connections and counts.
#[derive(Debug)]
pub(super) struct Done {
    pub(super) connections: Vec<Connection>,
    pub(super) tally: Tally,
    /// Faults on the status port, by kind.
    pub(super) faults: Tally,
}

/// An arm's program, in one round.
#[derive(Debug)]
pub(super) struct Arm {
    pub(super) place: Place,
    pub(super) random: Random,
    pub(super) tally: Tally,
    faults: Tally,
    /// The mass of the payload.
    pub(super) mass: Held,
    /// The user's variable.
    pub(super) variable: Held,
    /// The arm may still be in servo mode.
    pub(super) in_servo_mode: bool,
    /// The number of the next command that carries one.
    serial: u32,
    connections: Vec<Connection>,
}

impl Arm {
    pub(super) fn new(place: Place, random: Random) -> Self {
        Self {
            place,
            random,
            tally: Tally::default(),
            faults: Tally::default(),
            // What a controller begins with is known when it is read.
            mass: Held::unknown(),
            variable: Held::unknown(),
            in_servo_mode: false,
            serial: 0,
            connections: Vec::new(),
        }
    }

    /// Does this many things, and reports what was sent and the outcomes.
    pub(super) fn run(mut self, operations: u32) -> Done {
        let reader = Reader::new(config(&self.place.ports), &self.place.ports, &self.place.rate, &self.place.findings);
        let mut session = None;
        for number in 0..operations {
            let mut current = match session.take().map_or_else(|| self.connect(), Ok) {
                Ok(current) => current,
                Err(error) => {
                    self.find(&format!("cannot connect: {error:?}"));
                    break;
                }
            };
            if number % 16 == 0 {
                self.place.peak.look();
            }
            calls::one(&mut self, &mut current);
            if current.silent >= SILENT || current.robot.client().disconnect_cause().is_some() {
                self.leave(current);
            } else {
                session = Some(current);
            }
        }
        if let Some(current) = session {
            self.leave(current);
        }
        match reader.end() {
            Some(tally) => self.tally.join(&tally),
            None => self.find("a reader of the status port panicked"),
        }
        Done { connections: self.connections, tally: self.tally, faults: self.faults }
    }

    fn connect(&mut self) -> Result<Session, Error> {
        let (parameters, text) = self.numbered(calls::FIRST, json!({}));
        let is_recorded = self.random.one_in(RECORDED);
        let mut session = Session::new(&self.place, text.clone(), is_recorded)?;
        self.tally.one("connections");
        self.mass.new_connection();
        self.variable.new_connection();
        let result = session.robot.client().call_raw(calls::FIRST, &parameters).map_err(Error::from);
        self.note(&mut session, text, &result);
        Ok(session)
    }

    /// Ends a connection: by what broke it, or because the program wants it to.
    fn leave(&mut self, mut session: Session) {
        let is_broken = session.robot.client().disconnect_cause().is_some();
        self.tally.one(if is_broken { "connections broken" } else { "connections left" });
        let connection = session.end(&self.place, &mut self.tally);
        self.connections.push(connection);
    }

    /// Notes what was sent, and what it ended with.
    pub(super) fn note<T>(&mut self, session: &mut Session, text: String, result: &Result<T, Error>) -> Fate {
        count(&mut self.tally, result);
        let fate = Fate::of(result);
        session.connection.note(text, fate);
        session.silent = match fate {
            Fate::Seen => 0,
            // What is kept back asks for no answer.
            Fate::NotSent => session.silent,
            Fate::Sent | Fate::Perhaps => session.silent + 1,
        };
        if fate == Fate::Seen {
            self.mass.answered();
            self.variable.answered();
        }
        fate
    }

    /// The next number.
    pub(super) fn serial(&mut self) -> u32 {
        self.serial += 1;
        self.serial
    }

    /// The parameters of a raw call with a number, and its text, which no other call has.
    pub(super) fn numbered(&mut self, name: &str, mut parameters: Value) -> (Value, String) {
        if let Some(fields) = parameters.as_object_mut() {
            fields.remove("cmdName");
        }
        parameters["soak"] = self.serial().into();
        let fields = parameters.to_string();
        let text = format!("{{\"cmdName\":{},{}", json!(name), &fields[1..]);
        (parameters, text)
    }

    /// Something goes wrong on the status port.
    pub(super) fn fault(&mut self, kind: &str) {
        self.faults.one(kind);
    }

    pub(super) fn find(&self, finding: &str) {
        self.place.findings.add(format!("arm {}: {finding}", self.place.arm));
    }
}
