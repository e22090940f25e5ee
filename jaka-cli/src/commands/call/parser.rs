//! clap's description of a command, generated from the spec.

use std::collections::BTreeSet;
use std::ffi::{OsStr, OsString};
use std::fmt::Write as _;
use std::iter;

use clap::builder::{PossibleValue, StringValueParser, TypedValueParser};
use clap::{Arg, ArgAction, ArgMatches, Args, FromArgMatches};
use jaka_dynamic::{Argument, arguments};
use jaka_spec::{Command, Spec};
use serde_json::{Map, Value};

use super::help;
use super::options::Options;
use crate::failure::Failure;

/// Usage of `jaka call` without a command.
pub(super) const USAGE: &str = "jaka call [OPTIONS] <COMMAND> [--FIELD <VALUE>]...";

/// Parser for lines of one command.
#[derive(Debug)]
pub(super) struct Parser<'s> {
    spec: &'s Spec,
    arguments: Vec<Argument>,
    clap: clap::Command,
}

/// Parsed line.
#[derive(Debug)]
pub(super) struct CommandLine {
    pub(super) options: Options,
    /// Given fields, in the form for [`jaka_dynamic::request`].
    pub(super) fields: Map<String, Value>,
}

/// Returns the parser of a line without fields.
pub(super) fn bare() -> clap::Command {
    let about = "Send one command of the protocol, and print the reply";
    with_options(clap::Command::new("jaka call"))
        .about(about)
        .override_usage(USAGE)
        .after_help("`jaka call --list` lists the commands, `jaka call COMMAND --help` describes one and its fields.")
}

/// Adds the options of every command, after the existing ones.
fn with_options(parser: clap::Command) -> clap::Command {
    let help = Arg::new("help").short('h').long("help").action(ArgAction::Help);
    let help = help.help("Print help; -h for a summary").help_heading("Options");
    Options::augment_args(parser.disable_help_flag(true).next_help_heading("Options")).arg(help)
}

/// Returns a description of `jaka call` without its commands, for the manual.
pub(crate) fn page() -> clap::Command {
    bare().name("call")
}

/// Returns a description of all commands as subcommands, for the completions of shells.
pub(crate) fn all(spec: &Spec) -> clap::Command {
    let commands = spec.commands().map(|command| {
        let parser = described(spec, command, &arguments(spec, command));
        let in_rust = Some(command.name.clone()).filter(|name| *name != command.wire);
        parser.name(command.wire.clone()).aliases(in_rust)
    });
    page().disable_help_subcommand(true).subcommands(commands)
}

impl<'s> Parser<'s> {
    /// Creates the parser of a command's lines; without a command, of options alone.
    pub(super) fn of(spec: &'s Spec, command: Option<&Command>) -> Self {
        let arguments = command.map(|command| arguments(spec, command)).unwrap_or_default();
        let clap = command.map_or_else(bare, |command| described(spec, command, &arguments));
        Self { spec, arguments, clap }
    }

    /// Explains a given common option that has the name of a field, whose own option is not given; empty if there is
    /// none. In a valid line, explains it only for a required field.
    pub(super) fn explanation(&self, words: &[OsString], is_parsed: bool) -> String {
        let is_given = |long: &str| {
            let options = words.iter().filter_map(|word| word.to_str()?.strip_prefix("--"));
            options.filter_map(|option| option.strip_prefix(long)).any(|rest| rest.is_empty() || rest.starts_with('='))
        };
        let mut text = String::new();
        for (argument, long) in self.arguments.iter().zip(longs(&self.arguments)) {
            let name = &argument.name;
            if *name != long && is_given(name) && !is_given(&long) && (argument.required || !is_parsed) {
                // Writing to a string cannot fail.
                let _ = write!(
                    text,
                    "\nhint: `--{name}` is an option of `jaka call`; the field `{}` is given by `--{long}`, or by --params",
                    argument.field
                );
            }
        }
        text
    }

    /// Parses a line without its command.
    ///
    /// # Errors
    /// The line is invalid, or asks for help; or all values that do not have the type of their field.
    pub(super) fn parse(&self, words: Vec<OsString>) -> Result<CommandLine, Failure> {
        let Self { spec, arguments, clap } = self;
        let matches = clap.clone().try_get_matches_from(iter::once("jaka call".into()).chain(words))?;
        let options = Options::from_arg_matches(&matches)?;
        Ok(CommandLine { options, fields: fields(spec, arguments, &matches)? })
    }
}

fn fields(spec: &Spec, arguments: &[Argument], matches: &ArgMatches) -> Result<Map<String, Value>, Failure> {
    let (mut fields, mut wrong) = (Map::new(), Vec::new());
    for argument in arguments {
        let Some(text) = matches.get_one::<String>(&id(argument)) else { continue };
        match argument.value(spec, text) {
            Ok(_) if fields.contains_key(&argument.field) => {
                wrong.push(format!("`--{}`: another option gives the same field", argument.name));
            }
            Ok(value) => drop(fields.insert(argument.field.clone(), value)),
            Err(error) => wrong.push(format!("`--{}`: {error}", argument.name)),
        }
    }
    if wrong.is_empty() { Ok(fields) } else { Err(Failure::Usage(wrong.join("\n"))) }
}

/// Returns the id of a field, which differs from those of all options.
fn id(argument: &Argument) -> String {
    format!("field {}", argument.name)
}

fn described(spec: &Spec, command: &Command, arguments: &[Argument]) -> clap::Command {
    let longs = longs(arguments);
    let mut taken: BTreeSet<String> = common().chain(longs.iter().cloned()).collect();
    let mut parser = clap::Command::new("jaka call").next_help_heading("Fields");
    for (argument, long) in arguments.iter().zip(&longs) {
        let mut alias = |name: &String, all: fn(&Argument) -> &String| {
            let is_shared = arguments.iter().filter(|argument| all(argument) == name).count() > 1;
            (is_option_name(name) && !is_shared && taken.insert(name.clone())).then(|| name.clone())
        };
        let wire = alias(&argument.wire, |argument| &argument.wire);
        let field_name = alias(&argument.field, |argument| &argument.field);
        parser = parser.arg(field(argument, long).visible_aliases(wire).aliases(field_name));
    }
    with_options(parser)
        .mut_args(|arg| if is_field(&arg) { arg } else { arg.hide_short_help(true) })
        .mut_arg("list", |arg| arg.hide(true))
        .override_usage(help::usage(command, arguments, &longs))
        .about(help::about(command).into_owned())
        .long_about(help::long_about(command))
        .after_long_help(help::notes(spec, command))
}

/// Returns the names of the common options.
fn common() -> impl Iterator<Item = String> {
    let bare = bare();
    bare.get_arguments().filter_map(Arg::get_long).map(str::to_owned).collect::<Vec<_>>().into_iter()
}

/// Returns the option name of each field.
fn longs(arguments: &[Argument]) -> Vec<String> {
    let mut taken = common().collect();
    arguments.iter().map(|argument| long(&argument.name, &mut taken)).collect()
}

/// Returns the option name of a field, which must differ from the common options.
fn long(name: &str, taken: &mut BTreeSet<String>) -> String {
    let mut long = name.to_owned();
    while !taken.insert(long.clone()) {
        long = format!("field-{long}");
    }
    long
}

fn is_option_name(name: &str) -> bool {
    !name.is_empty() && name.chars().all(|c| c.is_alphanumeric() || c == '_' || c == '-')
}

fn is_field(arg: &Arg) -> bool {
    arg.get_id().as_str().starts_with("field ")
}

fn field(argument: &Argument, long: &str) -> Arg {
    let has_parts = argument.hint.starts_with('[') || argument.hint == "JSON";
    Arg::new(id(argument))
        .long(long.to_owned())
        .value_name(if argument.values.is_empty() { argument.hint.clone() } else { "VALUE".to_owned() })
        .help(if argument.name == long {
            help::field(argument)
        } else {
            format!("{} [`--{}` is an option of `jaka call`]", help::field(argument), argument.name)
        })
        .allow_negative_numbers(true)
        .allow_hyphen_values(has_parts)
        .conflicts_with("params")
        .value_parser(Listed::of(argument))
}

/// Value parser that accepts any text, and shows the listed values in help.
#[derive(Debug, Clone)]
struct Listed(Vec<PossibleValue>);

impl Listed {
    fn of(argument: &Argument) -> Self {
        let possible = |value: &jaka_dynamic::PossibleValue| {
            PossibleValue::new(value.name.clone()).help(format!(
                "{} ({})",
                value.help.trim_end_matches('.'),
                value.wire
            ))
        };
        Self(argument.values.iter().map(possible).collect())
    }
}

impl TypedValueParser for Listed {
    type Value = String;

    fn parse_ref(&self, cmd: &clap::Command, arg: Option<&Arg>, value: &OsStr) -> Result<String, clap::Error> {
        StringValueParser::new().parse_ref(cmd, arg, value)
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        Some(Box::new(self.0.iter().cloned())).filter(|_| !self.0.is_empty()).map(|values| values as Box<_>)
    }
}
