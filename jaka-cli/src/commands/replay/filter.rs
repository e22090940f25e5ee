//! Filter for the shown entries of a recording: those of a command.

use std::collections::{BTreeSet, HashSet};
use std::time::Duration;

use itertools::Itertools as _;
use jaka_sync::proto::text::visible;
use jaka_sync::recording::{Answer, Answered, Entry, Message, Port, Recording};

use crate::builtin;
use crate::recordings::recorded::command_of;
use crate::terminal::output;

/// Filter for the shown entries of a recording: the requests of a command and their replies.
#[derive(Debug)]
pub(super) struct Filter {
    command: String,
    /// Replies, including those that do not name their command, by their arrival times.
    replies: HashSet<(Duration, Message)>,
}

impl Filter {
    /// Creates a filter for the command by its `cmdName` or its name in Rust, or by a name that is not in the spec. If
    /// the recording has no request of the command, prints the commands that it has.
    pub(super) fn new(called: &str, recording: &Recording) -> Self {
        let known = builtin::spec().command_called(called).map(|command| command.wire.clone());
        let command = known.unwrap_or_else(|| called.to_owned());
        let names: BTreeSet<_> =
            recording.answers().iter().filter_map(|answered| command_of(&answered.request)).collect();
        if !names.contains(&command) {
            let names = names.iter().map(|name| format!("`{}`", visible(name))).join(", ");
            let names = if names.is_empty() { "no command" } else { &names };
            output::warning(&format!("the recording has no request of `{command}`; it has {names}"));
        }
        let mut filter = Self { command, replies: HashSet::new() };
        let reply = |answered: Answered| match answered.answer {
            Answer::Reply { reply, after } => Some((answered.sent + after, reply)),
            _ => None,
        };
        let answers = recording.answers().into_iter().filter(|answered| filter.names(&answered.request));
        filter.replies = answers.filter_map(reply).collect();
        filter
    }

    /// True if an entry is shown.
    pub(super) fn shows(&self, entry: &Entry) -> bool {
        let is_shown = |message: &Message| self.names(message) || self.replies.contains(&(entry.time, message.clone()));
        entry.port == Port::Command && entry.event.message().is_some_and(is_shown)
    }

    /// True if a message names the command.
    pub(super) fn names(&self, message: &Message) -> bool {
        command_of(message).as_ref() == Some(&self.command)
    }
}
