//! Errors of a command line, in the form of all errors: problem and hint.

use std::env;

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{CommandFactory, Error};

use itertools::Itertools as _;

use crate::Cli;
use crate::words::Words;

/// Whether it is a help or version text to print, also if a command is missing.
pub(crate) fn is_help(error: &Error) -> bool {
    !error.use_stderr() || error.kind() == ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand
}

/// Returns the problem, and a hint.
pub(crate) fn text(error: &Error) -> String {
    let what = what(error).unwrap_or_else(|| in_words_of_clap(error));
    format!("{what}\nhint: {}", hint(error))
}

fn what(error: &Error) -> Option<String> {
    let argument = || quoted(error, ContextKind::InvalidArg);
    let value = || quoted(error, ContextKind::InvalidValue);
    Some(match error.kind() {
        ErrorKind::UnknownArgument if argument()?.starts_with("`-") => format!("there is no option {}", argument()?),
        ErrorKind::UnknownArgument => format!("{} is not expected here", argument()?),
        ErrorKind::InvalidSubcommand => {
            format!("there is no command {}", quoted(error, ContextKind::InvalidSubcommand)?)
        }
        ErrorKind::InvalidValue => {
            let values = list(error, ContextKind::ValidValue).join(", ");
            let values = if values.is_empty() { values } else { format!(": it is one of {values}") };
            match value()?.as_str() {
                "``" => format!("{} needs a value{values}", argument()?),
                value => format!("{} cannot be {value}{values}", argument()?),
            }
        }
        ErrorKind::ValueValidation => {
            let why = std::error::Error::source(error)?;
            format!("{} cannot be {}: {why}", argument()?, value()?)
        }
        ErrorKind::MissingRequiredArgument => match list(error, ContextKind::InvalidArg).as_slice() {
            [] => return None,
            [one] => format!("{one} is missing"),
            several => format!("{} are missing", several.join(", ")),
        },
        ErrorKind::ArgumentConflict => {
            let others = list(error, ContextKind::PriorArg).join(", ");
            match argument()? {
                argument if argument == others => format!("{argument} is given more than once"),
                argument if others.is_empty() => format!("{argument} cannot be used with other options that are given"),
                argument => format!("{argument} cannot be used with {others}"),
            }
        }
        ErrorKind::NoEquals => format!("the value of {} is written after an equals sign", argument()?),
        _ => return None,
    })
}

/// Returns the text of a rare error: the first paragraph of clap's text.
fn in_words_of_clap(error: &Error) -> String {
    let text = error.to_string();
    let text = text.strip_prefix("error: ").unwrap_or(&text);
    text.split("\n\n").next().unwrap_or_default().trim_end().to_owned()
}

fn hint(error: &Error) -> String {
    // Values are not suggested, since they are listed.
    let suggested = [ContextKind::SuggestedSubcommand, ContextKind::SuggestedArg];
    match suggested.into_iter().flat_map(|kind| list(error, kind)).join(" or ").as_str() {
        "" => format!("`{} --help` lists commands and options", command()),
        suggested => format!("did you mean {suggested}?"),
    }
}

/// Returns the command of the line, as far as there is one.
fn command() -> String {
    let mut jaka = Cli::command();
    jaka.build();
    let words: Vec<_> = env::args_os().skip(1).collect();
    let line = Words::of(&jaka, &words);
    let path = line.command.get_bin_name().unwrap_or("jaka");
    let called = line.positionals.first().filter(|_| line.command.get_name() == "call").map(|called| &called.word);
    match called.filter(|word| jaka_spec::builtin().is_ok_and(|spec| spec.command_called(word).is_some())) {
        Some(word) => format!("{path} {word}"),
        None => path.to_owned(),
    }
}

/// Returns the first text of this kind in the error, in backticks.
fn quoted(error: &Error, kind: ContextKind) -> Option<String> {
    list(error, kind).into_iter().next()
}

fn list(error: &Error, kind: ContextKind) -> Vec<String> {
    match error.get(kind) {
        Some(ContextValue::String(text)) => vec![format!("`{text}`")],
        Some(ContextValue::Strings(texts)) => texts.iter().map(|text| alternatives(text)).collect(),
        _ => Vec::new(),
    }
}

/// Formats alternatives, which are `<--this|--that>` for clap.
fn alternatives(text: &str) -> String {
    let inner = text.strip_prefix('<').and_then(|text| text.strip_suffix('>')).filter(|text| text.starts_with('-'));
    format!("`{}`", inner.unwrap_or(text).replace(">|--", ">` or `--"))
}
