//! Filter for the shown entries of a recording: those of a command.

use std::collections::{BTreeSet, HashSet};
use std::time::Duration;

use clap::Args;
use itertools::Itertools as _;
use jaka_sync::proto::text::visible;
use jaka_sync::recording::{Answer, Answered, Entry, Message, Port, Recording};

use crate::builtin;
use crate::recordings::recorded::command_of;
use crate::terminal::output;

/// Options for the selection of entries.
#[derive(Debug, Args)]
pub(super) struct FilterArgs {
    /// Show only the requests of this command, and their replies
    #[arg(long, value_name = "NAME", requires = "show")]
    command: Option<String>,
}

/// Filter for the shown entries of a recording: all, or those of a command.
#[derive(Debug)]
pub(super) struct Filter(Option<CommandFilter>);

/// Requests of a command and their replies.
#[derive(Debug)]
struct CommandFilter {
    name: String,
    /// Replies, including those that do not name their command, by their arrival times.
    replies: HashSet<(Duration, Message)>,
}

impl FilterArgs {
    /// Returns the filter of the options. If the recording has no request of the command, prints the commands that it
    /// has.
    pub(super) fn filter(&self, recording: &Recording) -> Filter {
        Filter(self.command.as_ref().map(|name| CommandFilter::new(name, recording)))
    }
}

impl Filter {
    /// Whether an entry is shown.
    pub(super) fn shows(&self, entry: &Entry) -> bool {
        let is_of =
            |command: &CommandFilter| entry.event.message().is_some_and(|message| command.shows(entry, message));
        self.0.as_ref().is_none_or(is_of)
    }

    /// Returns the shown requests, with their outcomes.
    pub(super) fn answers(&self, recording: &Recording) -> Vec<Answered> {
        let mut answers = recording.answers();
        answers.retain(|answered| {
            let is_of = |command: &CommandFilter| command_of(&answered.request).as_ref() == Some(&command.name);
            self.0.as_ref().is_none_or(is_of)
        });
        answers
    }
}

impl CommandFilter {
    /// Creates a filter for the command by its `cmdName` or its name in Rust, or by a name that is not in the spec.
    fn new(called: &str, recording: &Recording) -> Self {
        let known = builtin::spec().command_called(called).map(|command| command.wire.clone());
        let command = known.unwrap_or_else(|| called.to_owned());
        let names: BTreeSet<_> =
            recording.answers().iter().filter_map(|answered| command_of(&answered.request)).collect();
        if !names.contains(&command) {
            let names = names.iter().map(|name| format!("`{}`", visible(name))).join(", ");
            let names = if names.is_empty() { "no command" } else { &names };
            output::warning(&format!("the recording has no request of `{command}`; it has {names}"));
        }
        let of_it = |answered: &Answered| command_of(&answered.request).as_ref() == Some(&command);
        let reply = |answered: Answered| match answered.answer {
            Answer::Reply { reply, after } => Some((answered.sent + after, reply)),
            _ => None,
        };
        let replies = recording.answers().into_iter().filter(of_it).filter_map(reply).collect();
        Self { name: command, replies }
    }

    fn shows(&self, entry: &Entry, message: &Message) -> bool {
        let is_named = || command_of(message).as_ref() == Some(&self.name);
        entry.port == Port::Command && (is_named() || self.replies.contains(&(entry.time, message.clone())))
    }
}
