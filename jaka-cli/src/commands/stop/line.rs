//! Line of `jaka stop`, in which words that concern other commands are ignored: a person who sees an arm move changes
//! the command of the last line, and leaves its options.

use std::ffi::OsString;
use std::path::PathBuf;
use std::ptr;

use clap::{Arg, Command, CommandFactory as _};

use crate::Cli;
use crate::builtin;
use crate::commands::{all_of_call, call};
use crate::words::{GivenOption, Words};

/// Line of `jaka stop`.
#[derive(Debug)]
pub(crate) struct StopLine {
    /// Words that concern `jaka stop`, after the name of the program. Without `--robot`, also the unknown ones, so that
    /// they are errors: one of them may be a misspelt address.
    pub(crate) words: Vec<OsString>,
    /// Unknown words that are ignored, because `--robot` names the robot.
    pub(crate) ignored: Vec<String>,
    /// Packs of other commands.
    pub(crate) packs: Vec<PathBuf>,
}

/// Beginning of the ids of options that are ignored.
const IGNORED: &str = "ignored ";

impl StopLine {
    /// Reads a line that begins with the name of the program; `None` if it is of another command.
    pub(crate) fn of(line: &[OsString]) -> Option<Self> {
        let (program, words) = line.split_first()?;
        let tree = with_options_of_others(call::page());
        let read = Words::of(&tree, words);
        if !ptr::eq(read.command, tree.find_subcommand("stop")?) {
            return None;
        }
        if strays(&read).is_empty() || is_explicit(&read) {
            return Some(Self::new(program, words, &read));
        }
        // Fields of `jaka call` need the spec, for which a stop beside `--robot` does not wait.
        let tree = with_options_of_others(all_of_call(builtin::spec()));
        Some(Self::new(program, words, &Words::of(&tree, words)))
    }

    fn new(program: &OsString, words: &[OsString], read: &Words<'_>) -> Self {
        let is_own = |option: &&GivenOption<'_>| !option.arg.get_id().as_str().starts_with(IGNORED);
        let own = read.options.iter().filter(is_own).filter_map(word);
        let mut own: Vec<_> = [program.clone(), "stop".into()].into_iter().chain(own).collect();
        let packs = read.values(&format!("{IGNORED}packs")).map(PathBuf::from).collect();
        let strays = strays(read).into_iter().map(|place| &words[place]);
        if is_explicit(read) {
            let ignored = strays.map(|word| word.to_string_lossy().into_owned()).collect();
            return Self { words: own, ignored, packs };
        }
        own.extend(strays.cloned());
        Self { words: own, ignored: Vec::new(), packs }
    }
}

/// Returns the commands of a line, where `jaka stop` also has the options of all commands for robots. `call` has those
/// of `jaka call`.
fn with_options_of_others(call: Command) -> Command {
    let mut tree = Cli::command().mut_subcommand("call", |_| call);
    tree.build();
    let others = tree.get_subcommands().filter(|command| command.get_arguments().any(|arg| arg.get_id() == "robot"));
    let options: Vec<_> = others
        .flat_map(|command| command.get_arguments().chain(command.get_subcommands().flat_map(Command::get_arguments)))
        .filter(|arg| !arg.is_positional())
        .map(ignored)
        .collect();
    tree.mut_subcommand("stop", |stop| stop.args(options))
}

/// Returns an option whose value is the next word, unless that is an option: what it takes must not hide `--robot`.
fn ignored(option: &Arg) -> Arg {
    let id = format!("{IGNORED}{}", option.get_id());
    option.clone().id(id).allow_hyphen_values(false).allow_negative_numbers(true)
}

/// Returns the places of unknown options and of words without a name, in their order.
fn strays(read: &Words<'_>) -> Vec<usize> {
    let unnamed = read.positionals.iter().map(|positional| positional.place);
    let mut places: Vec<_> = read.unknown.iter().copied().chain(unnamed).collect();
    places.sort_unstable();
    places
}

/// True if the line itself names the robot.
fn is_explicit(read: &Words<'_>) -> bool {
    read.value("robot").is_some()
}

/// Returns an option as one word.
fn word(option: &GivenOption<'_>) -> Option<OsString> {
    let mut word = OsString::from(format!("--{}", option.arg.get_long()?));
    if let Some(value) = &option.value {
        word.push("=");
        word.push(value);
    }
    Some(word)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    const ROBOT: &str = "jaka stop --robot=10.0.0.1";

    /// Returns the words that concern the stop, and those that are ignored.
    fn read(line: &str) -> (String, String) {
        let line: Vec<_> = ["jaka"].into_iter().chain(line.split(' ')).map(OsString::from).collect();
        let StopLine { words, ignored, .. } = StopLine::of(&line).expect("it is a stop");
        let words: Vec<_> = words.iter().map(|word| word.to_str().expect("it was text")).collect();
        (words.join(" "), ignored.join(" "))
    }

    fn is_wrong(line: &str) -> bool {
        Cli::read(&["jaka"].into_iter().chain(line.split(' ')).map(OsString::from).collect::<Vec<_>>()).is_err()
    }

    /// Commands whose options people leave on the line of a stop.
    const SISTERS: [&str; 13] = [
        "move", "jog", "follow", "up", "down", "clear", "call", "status", "monitor", "check", "probe", "jitter",
        "record",
    ];

    /// Returns the words that give an option, with and without a value.
    fn words_of(option: &Arg) -> Vec<String> {
        let longs =
            option.get_long_and_visible_aliases().unwrap_or_default().into_iter().map(|long| format!("--{long}"));
        let names = longs.chain(option.get_short().map(|short| format!("-{short}")));
        let takes = option.get_action().takes_values();
        names
            .flat_map(|name| {
                let separate = ["nowhere.toml", "-1,2,3", "-"].map(|value| format!("{name} {value}"));
                let separate = separate.into_iter().filter(|_| takes && !option.is_require_equals_set());
                let joined = takes.then(|| format!("{name}=nowhere.toml"));
                separate.chain(joined).chain([name]).collect::<Vec<_>>()
            })
            .collect()
    }

    #[test]
    fn each_option_of_each_sister_is_accepted() {
        let tree = with_options_of_others(all_of_call(builtin::spec()));
        let read = |line: String| {
            let words: Vec<_> = line.split(' ').map(OsString::from).collect();
            StopLine::new(&"jaka".into(), &words, &Words::of(&tree, &words))
        };
        let own = |line: &str| line.split(' ').map(OsString::from).collect::<Vec<_>>();
        let mut sisters = Cli::command().mut_subcommand("call", |_| all_of_call(builtin::spec()));
        sisters.build();
        let stop = sisters.find_subcommand("stop").expect("it is a command");
        let is_own = |option: &&Arg| stop.get_arguments().any(|own| own.get_long() == option.get_long());
        let mut given = BTreeSet::new();
        for sister in SISTERS.map(|name| sisters.find_subcommand(name).expect("it is a command")) {
            let fields = sister.get_subcommands().flat_map(Command::get_arguments);
            let options = sister.get_arguments().chain(fields).filter(|option| !option.is_positional());
            given.extend(options.filter(|option| !is_own(option)).flat_map(words_of));
        }
        for words in &given {
            for (line, expected) in [
                (format!("stop {words}"), "jaka stop"),
                (format!("stop {words} -r 10.0.0.1"), ROBOT),
                (format!("stop --robot 10.0.0.1 {words}"), ROBOT),
            ] {
                let StopLine { words: found, ignored, .. } = read(line);
                assert!(found == own(expected) && ignored.is_empty(), "{words}: {found:?}, {ignored:?}");
            }
        }
        assert!(given.len() > 500, "{}", given.len());
    }

    #[test]
    fn fields_of_a_request_are_accepted_like_options() {
        for words in ["--mode absolute --speed 10", "--joint-position -10,0,0,0,0,0", "--jog-mode stop --axis=-1"] {
            assert_eq!(read(&format!("stop {words}")), ("jaka stop".to_owned(), String::new()), "{words}");
            assert_eq!(read(&format!("stop -r 10.0.0.1 {words}")).0, ROBOT, "{words}");
        }
    }

    #[test]
    fn what_is_unknown_is_ignored_beside_an_explicit_robot() {
        for (line, ignored) in [
            ("stop -r 10.0.0.1 --pakc x.toml", "--pakc x.toml"),
            ("stop --pakc x.toml -r 10.0.0.1", "--pakc x.toml"),
            ("stop --frobnicate -r 10.0.0.1", "--frobnicate"),
            ("stop --frobnicate=-r --robot 10.0.0.1", "--frobnicate=-r"),
            ("stop --robot=10.0.0.1 -X", "-X"),
            ("stop -yr10.0.0.1 6 5 --speed 5", "6 5"),
            (
                "stop joint_move --mode absolute -r=10.0.0.1 --joint-position -10,0,0,0,0,0",
                "joint_move absolute -10,0,0,0,0,0",
            ),
            ("stop --joints -r 10.0.0.1", ""),
            ("stop -r 10.0.0.1 -- --robot 10.0.0.2", "-- --robot 10.0.0.2"),
        ] {
            let (words, found) = read(line);
            let without_fields = found.replace("--mode ", "").replace("--joint-position ", "");
            assert_eq!((&*words, &*without_fields), (ROBOT, ignored), "{line}");
            assert!(!is_wrong(line), "{line}");
        }
    }

    #[test]
    fn without_an_explicit_robot_what_is_unknown_is_an_error() {
        for (line, unknown) in [
            ("stop --robbot 10.0.0.1", "--robbot 10.0.0.1"),
            ("stop --pack x.toml --robbot=10.0.0.1 --yes", "--robbot=10.0.0.1"),
            ("stop -R 10.0.0.1", "-R 10.0.0.1"),
            ("stop -Xr 10.0.0.1", "-Xr 10.0.0.1"),
            ("stop 10.0.0.1", "10.0.0.1"),
            ("stop --frobnicate", "--frobnicate"),
            ("stop -- -r 10.0.0.1", "-- -r 10.0.0.1"),
        ] {
            assert_eq!(read(line), (format!("jaka stop {unknown}"), String::new()));
            assert!(is_wrong(line), "{line}");
        }
    }

    #[test]
    fn its_own_options_are_read_as_strictly_as_elsewhere() {
        for line in [
            "stop -r 10.0.0.1 -r 10.0.0.2",
            "stop --pack x -r 10.0.0.1 --robot=10.0.0.2 --frobnicate",
            "stop --pakc --robot",
            "stop --pakc x.toml -r",
            "stop --robot --pakc 10.0.0.1",
            "stop -r 10.0.0.1 --timeout soon --yes",
            "stop --sim -r 10.0.0.1 --yes",
        ] {
            assert!(is_wrong(line), "{line}");
        }
        let line: Vec<_> = "jaka status --pakc x".split(' ').map(OsString::from).collect();
        assert!(StopLine::of(&line).is_none(), "another command");
    }
}
