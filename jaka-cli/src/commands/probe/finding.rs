//! Findings of a probe.

use std::path::PathBuf;

use jaka_dynamic::{Departure, Reading};
use jaka_sync::power::GetVersion;
use jaka_sync::proto::read_payload;
use jaka_sync::{Command, ErrorCode};
use serde_json::Value;

use crate::commands::call::reply_json;

/// All findings at a controller.
#[derive(Debug)]
pub(super) struct Findings {
    /// Version reported by the controller.
    pub(super) version: Option<String>,
    /// File names of the packs in the comparison.
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
    /// Received message, if there is one.
    pub(super) raw: Option<String>,
    /// All messages of the kind, as JSON.
    pub(super) samples: Vec<Value>,
}

/// Outcome of a question.
#[derive(Debug)]
pub(super) enum Outcome {
    /// The message fits the spec, or departs from it and is still readable.
    Answered,
    /// The controller refused the request.
    Refused {
        /// Code of the controller.
        code: ErrorCode,
        /// Message of the controller.
        message: String,
    },
    /// The message is unreadable, with the reason.
    Unreadable(String),
    /// No message came, with the reason.
    NoReply(String),
    /// Nothing was asked, with the reason.
    NotProbed(String),
}

impl Findings {
    pub(super) fn new(commands: Vec<Finding>, status: Finding, packs: &[PathBuf]) -> Self {
        let name = |path: &PathBuf| path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
        Self { version: version(&commands), packs: packs.iter().map(name).collect(), commands, status }
    }

    /// Returns the findings of commands and status.
    pub(super) fn all(&self) -> impl Iterator<Item = &Finding> {
        self.commands.iter().chain([&self.status])
    }

    /// Returns the number of questions asked.
    pub(super) fn asked(&self) -> usize {
        self.all().filter(|finding| finding.is_asked()).count()
    }

    /// Returns the number of these questions with messages that depart from the spec, or without an answer.
    pub(super) fn departing(&self) -> usize {
        self.all().filter(|finding| finding.departs()).count()
    }
}

/// Returns the controller's version, from the reply to its query.
fn version(commands: &[Finding]) -> Option<String> {
    let finding = commands.iter().find(|finding| finding.name == GetVersion::INFO.name)?;
    let reply: <GetVersion as Command>::Reply = read_payload(GetVersion::INFO, finding.raw.as_deref()?).ok()?;
    Some(reply.version)
}

impl Finding {
    /// Returns the finding of a received message.
    pub(super) fn of(name: impl Into<String>, departures: Vec<Departure>, raw: String) -> Self {
        let unreadable = departures.iter().find(|departure| departure.reading == Reading::Unreadable);
        let outcome = unreadable.map_or(Outcome::Answered, |_| Outcome::Unreadable(String::new()));
        Self { name: name.into(), outcome, departures, samples: vec![reply_json(&raw)], raw: Some(raw) }
    }

    /// Returns the finding of a question without a message.
    pub(super) fn without(name: impl Into<String>, outcome: Outcome) -> Self {
        Self { name: name.into(), outcome, departures: Vec::new(), raw: None, samples: Vec::new() }
    }

    fn is_asked(&self) -> bool {
        !matches!(self.outcome, Outcome::NotProbed(_))
    }

    /// Whether the message departs from the spec, or did not come.
    pub(super) fn departs(&self) -> bool {
        !self.departures.is_empty() || matches!(self.outcome, Outcome::Unreadable(_) | Outcome::NoReply(_))
    }
}
