//! Completions of a word of a command line, from the parser's own description.

mod values;

use std::ffi::OsString;

use clap::{Arg, ArgAction, Command, CommandFactory, ValueHint};
use jaka_spec::words::first_sentence;

use crate::Cli;
use crate::builtin;
use crate::commands::{all_of_call, protocol_of};
use crate::terminal::output;
use crate::words::{LastWord, Words};

/// Completion of the word at the cursor.
#[derive(Debug, PartialEq)]
pub(crate) enum Completion {
    /// File, completed by the shell.
    File,
    Words(Vec<Candidate>),
}

/// Possible completion of the word at the cursor, and its meaning.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Candidate {
    pub(crate) word: String,
    pub(crate) help: String,
}

impl Candidate {
    fn new(word: impl Into<String>, help: impl Into<String>) -> Self {
        Self { word: word.into(), help: help.into() }
    }
}

/// Completes the word at the cursor. `before` has the words before it, without the name of the program.
pub(crate) fn complete(before: &[OsString], current: &str) -> Completion {
    // A shell would show messages on its line.
    output::be_quiet();
    // Continues without packs if they are unreadable.
    if let Ok(protocol) = protocol_of(before) {
        protocol.read_status();
    }
    let mut tree = Cli::command().mut_subcommand("call", |_| all_of_call(builtin::of_status()));
    tree.build();
    let line = Words::of(&tree, before);
    match line.last_word(current) {
        LastWord::Value(arg) => values(&line, arg, "", current),
        LastWord::NamedValue { arg, name, value } => values(&line, arg, &format!("{name}="), value),
        LastWord::Option => Completion::Words(begun(options(&line), current)),
        LastWord::Unnamed => words(&line, current),
    }
}

/// Returns subcommands, or values of the argument without a name at this place; options if there are neither.
fn words(line: &Words<'_>, current: &str) -> Completion {
    let subcommands = line.command.get_subcommands().filter(|command| !command.is_hide_set());
    let subcommands: Vec<_> = subcommands.filter(|_| line.positionals.is_empty()).map(candidate_of).collect();
    match line.command.get_positionals().nth(line.positionals.len()) {
        _ if !subcommands.is_empty() => Completion::Words(begun(subcommands, current)),
        Some(arg) => values(line, arg, "", current),
        None => Completion::Words(begun(options(line), current)),
    }
}

fn candidate_of(command: &Command) -> Candidate {
    Candidate::new(command.get_name(), summary(command.get_about()))
}

/// Returns the values of an argument, each after this prefix. The shell completes an argument that only has paths.
fn values(line: &Words<'_>, arg: &Arg, prefix: &str, current: &str) -> Completion {
    let known = values::of(line, arg, current);
    let is_path = matches!(arg.get_value_hint(), ValueHint::AnyPath | ValueHint::FilePath | ValueHint::DirPath);
    if known.is_empty() && is_path {
        return Completion::File;
    }
    let words = begun(known, current).into_iter();
    Completion::Words(words.map(|value| Candidate { word: format!("{prefix}{}", value.word), ..value }).collect())
}

/// Returns the options that can still be given, with those of the command's own fields first.
fn options(line: &Words<'_>) -> Vec<Candidate> {
    let is_free = |arg: &&Arg| {
        let again = matches!(arg.get_action(), ArgAction::Append | ArgAction::Count);
        !arg.is_hide_set() && (again || !line.has(arg.get_id().as_str()))
    };
    let named = line.command.get_arguments().filter(is_free);
    named.filter_map(|arg| Some(Candidate::new(format!("--{}", arg.get_long()?), summary(arg.get_help())))).collect()
}

fn begun(candidates: Vec<Candidate>, current: &str) -> Vec<Candidate> {
    candidates.into_iter().filter(|candidate| candidate.word.starts_with(current)).collect()
}

/// Returns the first sentence of a help, in one line.
fn summary(help: Option<&clap::builder::StyledStr>) -> String {
    let help = help.map(ToString::to_string).unwrap_or_default();
    first_sentence(&help).0.replace('\n', " ")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn completed(line: &str) -> Completion {
        let words: Vec<_> = line.split(' ').map(OsString::from).collect();
        let (current, before) = words.split_last().expect("there is a word, if an empty one");
        complete(before, current.to_str().expect("it was text"))
    }

    fn words(line: &str) -> Vec<String> {
        match completed(line) {
            Completion::Words(words) => words.into_iter().map(|candidate| candidate.word).collect(),
            Completion::File => vec!["a file".to_owned()],
        }
    }

    #[test]
    fn commands_are_completed_by_their_beginning() {
        assert_eq!(words("st"), ["status", "stop"]);
        assert_eq!(words("spec d"), ["diff", "doc"]);
        assert_eq!(words("call joint_m"), ["joint_move"]);
        assert_eq!(words("-v call -r 10.5.5.100 get_tcp"), ["get_tcp_pos"]);
        assert_eq!(words("complete"), Vec::<String>::new(), "it is for scripts");
    }

    #[test]
    fn fields_and_their_values_are_completed() {
        assert_eq!(words("call joint_move --mo"), ["--mode"]);
        assert_eq!(words("call joint_move --mode "), ["absolute", "relative"]);
        assert_eq!(words("call joint_move --mode=r"), ["--mode=relative"]);
        assert_eq!(words("call joint_move --joint-position -10,0,0,0,0,0 --mo"), ["--mode"]);
        let left = words("call joint_move --mode relative ");
        assert!(left.contains(&"--speed".to_owned()) && !left.contains(&"--mode".to_owned()), "{left:?}");
        assert_eq!(words("call move_l --mode rel"), ["relative", "relative-to-tool"], "by its name in Rust");
    }

    #[test]
    fn values_that_are_named_elsewhere_are_completed() {
        assert_eq!(words("status --fields enabled,joint_actual"), ["enabled,joint_actual_position"]);
        assert_eq!(words("status --until !protective_s"), ["!protective_stop"]);
        assert_eq!(words("check --model zu1"), ["zu12", "zu18"]);
        assert_eq!(words("status --sim=zu1"), ["--sim=zu12", "--sim=zu18"]);
        assert_eq!(words("status --format "), ["table", "json", "csv"]);
        assert_eq!(words("call --list pay"), ["payload"]);
        assert_eq!(words("jog "), ["1", "2", "3", "4", "5", "6", "x", "y", "z"]);
        assert_eq!(words("jog 6 "), Vec::<String>::new(), "any distance");
        assert_eq!(words("sim --firmware "), ["1.5.14", "newer", "document"]);
        assert_eq!(words("replay a.jsonl --show --command get_tcp"), ["get_tcp_pos"]);
    }

    #[test]
    fn files_are_left_to_the_shell() {
        for line in ["replay ", "call --pack x", "follow way.csv --limits ", "report a.jsonl -o ", "status --config=x"]
        {
            assert_eq!(completed(line), Completion::File, "{line}");
        }
        assert_eq!(words("jog 1 5 --speed "), Vec::<String>::new());
    }
}
