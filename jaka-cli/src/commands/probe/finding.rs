//! Findings of a probe.

use std::path::PathBuf;

use jaka_dynamic::{Departure, Reading};
use jaka_sync::power::GetVersion;
use jaka_sync::proto::read_payload;
use jaka_sync::{Command, ErrorCode};
use serde_json::Value;

use crate::commands::call::reply_json;

/// All that was found at a controller.
#[derive(Debug)]
pub(super) struct Findings {
    /// The controller's version, in its own words.
    pub(super) version: Option<String>,
    /// The packs that it was compared with, by their file names.
    pub(super) packs: Vec<String>,
    /// Finding of each query.
    pub(super) commands: Vec<Finding>,
    /// Finding of the status port.
    pub(super) status: Finding,
}

/// Finding on one message.
#[derive(Debug)]
pub(super) struct Finding {
    /// `cmdName`, or the name of another question.
    pub(super) name: String,
    pub(super) outcome: Outcome,
    /// Departures of the message from the spec.
    pub(super) departures: Vec<Departure>,
    /// The message as it came, if one did.
    pub(super) raw: Option<String>,
    /// All messages of the kind, as JSON.
    pub(super) samples: Vec<Value>,
}

/// The outcome of a question.
#[derive(Debug)]
pub(super) enum Outcome {
    /// A message that fits the spec, or departs from it and can still be read.
    Answered,
    /// A refusal.
    Refused {
        /// The controller's code.
        code: ErrorCode,
        /// The controller's message.
        message: String,
    },
    /// A message that cannot be read, and why.
    Unreadable(String),
    /// No message came, and why.
    NoReply(String),
    /// Nothing was asked, and why.
    NotProbed(String),
}

impl Findings {
    pub(super) fn new(commands: Vec<Finding>, status: Finding, packs: &[PathBuf]) -> Self {
        let name = |path: &PathBuf| path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
        Self { version: version(&commands), packs: packs.iter().map(name).collect(), commands, status }
    }

    /// Commands and status.
    pub(super) fn all(&self) -> impl Iterator<Item = &Finding> {
        self.commands.iter().chain([&self.status])
    }

    /// Number of questions that were asked.
    pub(super) fn asked(&self) -> usize {
        self.all().filter(|finding| finding.is_asked()).count()
    }

    /// Number of those questions whose messages depart from the spec, or that were not answered.
    pub(super) fn departing(&self) -> usize {
        self.all().filter(|finding| finding.departs()).count()
    }
}

/// The controller's version, from the reply to the query for it.
fn version(commands: &[Finding]) -> Option<String> {
    let finding = commands.iter().find(|finding| finding.name == GetVersion::INFO.name)?;
    let reply: <GetVersion as Command>::Reply = read_payload(GetVersion::INFO, finding.raw.as_deref()?).ok()?;
    Some(reply.version)
}

impl Finding {
    /// The finding of a message that came.
    pub(super) fn of(name: impl Into<String>, departures: Vec<Departure>, raw: String) -> Self {
        let unreadable = departures.iter().find(|departure| departure.reading == Reading::Unreadable);
        let outcome = unreadable.map_or(Outcome::Answered, |_| Outcome::Unreadable(String::new()));
        Self { name: name.into(), outcome, departures, samples: vec![reply_json(&raw)], raw: Some(raw) }
    }

    /// The finding of a question to which no message came.
    pub(super) fn without(name: impl Into<String>, outcome: Outcome) -> Self {
        Self { name: name.into(), outcome, departures: Vec::new(), raw: None, samples: Vec::new() }
    }

    fn is_asked(&self) -> bool {
        !matches!(self.outcome, Outcome::NotProbed(_))
    }

    /// True for a message that departs from the spec, or did not come.
    pub(super) fn departs(&self) -> bool {
        !self.departures.is_empty() || matches!(self.outcome, Outcome::Unreadable(_) | Outcome::NoReply(_))
    }
}
