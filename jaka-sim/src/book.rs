//! What the spec says about each command, ready to look up.

use std::collections::HashMap;
use std::io;
use std::sync::OnceLock;

use jaka_proto::{Command, Envelope, ErrorCode, read_payload};
use jaka_spec::{Effect, Requirement, Spec};

/// The built-in spec, by `cmdName`.
#[derive(Debug)]
pub(crate) struct Book {
    entries: HashMap<String, Entry>,
    /// All of it.
    pub(crate) spec: Spec,
    /// What the controller says to something that is no command.
    pub(crate) unknown: String,
}

/// What the spec says about one command.
#[derive(Debug)]
pub(crate) struct Entry {
    /// True for a command that moves the arm: one that needs it enabled to do so.
    pub(crate) moves: bool,
    /// What the command needs.
    pub(crate) requires: Vec<Requirement>,
    /// The code and message of the refusal in a wrong state.
    pub(crate) refusal: (ErrorCode, String),
    /// The first successful reply that the spec prints.
    pub(crate) example: Option<String>,
}

impl Book {
    /// The book, which is read once in a process.
    pub(crate) fn open() -> io::Result<&'static Self> {
        static BOOK: OnceLock<Book> = OnceLock::new();
        if let Some(book) = BOOK.get() {
            return Ok(book);
        }
        let spec = jaka_spec::builtin().map_err(io::Error::other)?;
        Ok(BOOK.get_or_init(|| Self::new(spec)))
    }

    fn new(spec: Spec) -> Self {
        let entries = spec.commands().map(|command| (command.wire.clone(), Entry::new(command))).collect();
        let exception = spec.errors().find(|error| error.wire == ErrorCode::EXCEPTION.0);
        let unknown = exception.and_then(|error| error.message.clone()).unwrap_or_default();
        Self { entries, spec, unknown }
    }

    pub(crate) fn entry(&self, command: &str) -> Option<&Entry> {
        self.entries.get(command)
    }

    /// The reply that the spec prints for a command.
    pub(crate) fn example<C: Command>(&self) -> io::Result<C::Reply> {
        let text = self.entry(C::INFO.name).and_then(|entry| entry.example.as_deref());
        let text = text.ok_or_else(|| io::Error::other(format!("the spec has no reply of `{}`", C::INFO.name)))?;
        read_payload(C::INFO, text).map_err(io::Error::other)
    }
}

impl Entry {
    fn new(command: &jaka_spec::Command) -> Self {
        let own = command.refusal.as_ref().map(|refusal| (ErrorCode(refusal.code), refusal.message.clone()));
        let mut replies = command.examples.iter().filter_map(|example| example.reply.as_deref());
        Self {
            moves: command.effect == Effect::Motion && command.requires.contains(&Requirement::Enabled),
            requires: command.requires.clone(),
            refusal: own.unwrap_or_else(|| usual_refusal(&command.wire)),
            example: replies.find(|reply| is_success(reply)).map(str::to_owned),
        }
    }
}

/// How controllers refuse a command that they know.
pub(crate) fn usual_refusal(command: &str) -> (ErrorCode, String) {
    (ErrorCode::CALL_FAILED, format!("call {command} failed"))
}

fn is_success(reply: &str) -> bool {
    Envelope::read(reply).is_ok_and(|envelope| envelope.code.is_ok_and(ErrorCode::is_success))
}
