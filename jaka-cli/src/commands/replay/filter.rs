//! Which entries of a recording are shown.

use std::collections::{BTreeSet, HashSet};
use std::time::Duration;

use clap::{Args, ValueEnum};
use jaka_sync::proto::text::visible;
use jaka_sync::recording::{Answer, Answered, Entry, Message, Port, Recording};

use crate::recorded::command_of;
use crate::{output, packs};

/// The options that select entries.
#[derive(Debug, Args)]
pub(super) struct FilterArgs {
    /// Show only the connections to this port
    #[arg(long, value_enum, requires = "show")]
    port: Option<PortName>,
    /// Show only the requests of this command, and their replies
    #[arg(long, value_name = "NAME", requires = "show", conflicts_with = "port")]
    command: Option<String>,
}

/// A port of a controller.
#[derive(Debug, Clone, Copy, ValueEnum)]
enum PortName {
    /// Requests and replies
    Command,
    /// Status packets
    Status,
}

/// Which entries of a recording are shown.
#[derive(Debug)]
pub(super) enum Filter {
    All,
    Port(Port),
    Command(CommandFilter),
}

/// The requests of a command and their replies.
#[derive(Debug)]
pub(super) struct CommandFilter {
    name: String,
    /// The replies, including those that do not name their command, by the time at which they came.
    replies: HashSet<(Duration, Message)>,
}

impl FilterArgs {
    /// The filter that the options ask for. If the recording has no request of the command, says which it has.
    pub(super) fn filter(&self, recording: &Recording) -> Filter {
        match (&self.command, self.port) {
            (Some(name), _) => Filter::Command(CommandFilter::new(name, recording)),
            (None, Some(PortName::Command)) => Filter::Port(Port::Command),
            (None, Some(PortName::Status)) => Filter::Port(Port::Status),
            (None, None) => Filter::All,
        }
    }
}

impl Filter {
    /// Whether an entry is shown.
    pub(super) fn shows(&self, entry: &Entry) -> bool {
        match self {
            Self::All => true,
            Self::Port(port) => entry.port == *port,
            Self::Command(command) => entry.event.message().is_some_and(|message| command.shows(entry, message)),
        }
    }

    /// The requests that are shown, with their outcomes.
    pub(super) fn answers(&self, recording: &Recording) -> Vec<Answered> {
        let mut answers = recording.answers();
        match self {
            Self::All | Self::Port(Port::Command) => {}
            Self::Port(Port::Status) => answers.clear(),
            Self::Command(command) => {
                answers.retain(|answered| command_of(&answered.request).as_ref() == Some(&command.name));
            }
        }
        answers
    }
}

impl CommandFilter {
    /// The command by its `cmdName` or its name in Rust, or a name that is not in the spec.
    fn new(called: &str, recording: &Recording) -> Self {
        let known = packs::builtin().command_called(called).map(|command| command.wire.clone());
        let command = known.unwrap_or_else(|| called.to_owned());
        let names: BTreeSet<_> =
            recording.answers().iter().filter_map(|answered| command_of(&answered.request)).collect();
        if !names.contains(&command) {
            let names: Vec<_> = names.iter().map(|name| format!("`{}`", visible(name))).collect();
            let names = if names.is_empty() { "no command".to_owned() } else { names.join(", ") };
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
