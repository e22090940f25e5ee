//! Words of a command line, for readers that need some of them before its parser, or without it.

use std::borrow::Cow;
use std::ffi::{OsStr, OsString};

use clap::{Arg, Command};

/// Words of a command line up to some place. The parser reports errors.
pub(crate) struct Words<'c> {
    /// Command of the words.
    pub(crate) command: &'c Command,
    /// Words without a name that are no commands.
    pub(crate) positionals: Vec<Positional<'c>>,
    /// Options, in their order.
    pub(crate) options: Vec<GivenOption<'c>>,
    /// Indices of `--`, and of words with an option that the command does not have.
    pub(crate) unknown: Vec<usize>,
    /// Option with its value in the next word.
    pending: Option<&'c Arg>,
    /// Whether `--` precedes: all later words have no name.
    is_escaped: bool,
}

/// Word without a name.
pub(crate) struct Positional<'c> {
    /// Index among the words.
    pub(crate) place: usize,
    pub(crate) word: Cow<'c, str>,
}

/// Option in a line, with its value if it has one.
pub(crate) struct GivenOption<'c> {
    pub(crate) arg: &'c Arg,
    pub(crate) value: Option<OsString>,
}

/// Meaning of a word at the end of a line.
pub(crate) enum LastWord<'c, 'w> {
    /// Value of an argument.
    Value(&'c Arg),
    /// Value of an argument after the argument's name, such as `--mode`, and an equals sign.
    NamedValue { arg: &'c Arg, name: &'w str, value: &'w str },
    /// Name of an option.
    Option,
    /// Command, or a word without a name.
    Unnamed,
}

impl<'c> Words<'c> {
    /// Reads words by the options of a command and of its subcommands.
    pub(crate) fn of(command: &'c Command, words: &'c [OsString]) -> Self {
        let (positionals, options, unknown) = (Vec::new(), Vec::new(), Vec::new());
        let mut line = Self { command, positionals, options, unknown, pending: None, is_escaped: false };
        for (place, word) in words.iter().enumerate() {
            line.add(place, word);
        }
        line.options.extend(line.pending.map(|arg| GivenOption { arg, value: None }));
        line
    }

    /// Returns the last value of an option.
    pub(crate) fn value(&self, id: &str) -> Option<&OsStr> {
        self.values(id).last()
    }

    /// Returns the values of an option.
    pub(crate) fn values(&self, id: &str) -> impl Iterator<Item = &OsStr> {
        self.options.iter().filter(move |option| option.arg.get_id() == id).filter_map(|option| option.value.as_deref())
    }

    /// Whether the line has an option.
    pub(crate) fn has(&self, id: &str) -> bool {
        self.options.iter().any(|option| option.arg.get_id() == id)
    }

    /// Returns the meaning of the next word.
    pub(crate) fn last_word<'w>(&self, word: &'w str) -> LastWord<'c, 'w> {
        if let Some(arg) = self.pending.filter(|arg| takes(arg, word)) {
            return LastWord::Value(arg);
        }
        if self.is_escaped || !word.starts_with('-') {
            return LastWord::Unnamed;
        }
        let named =
            word.split_once('=').and_then(|(name, value)| Some((self.long(name.strip_prefix("--")?)?, name, value)));
        named.map_or(LastWord::Option, |(arg, name, value)| LastWord::NamedValue { arg, name, value })
    }

    fn add(&mut self, place: usize, word: &'c OsString) {
        let text = word.to_string_lossy();
        if let Some(arg) = self.pending.take() {
            let value = takes(arg, &text).then(|| word.clone());
            let is_value = value.is_some();
            self.options.push(GivenOption { arg, value });
            if is_value {
                return;
            }
        }
        if self.is_escaped || !text.starts_with('-') || text == "-" {
            match self.command.find_subcommand(word).filter(|_| self.positionals.is_empty()) {
                Some(command) => self.command = command,
                None => self.positionals.push(Positional { place, word: text }),
            }
        } else if text == "--" {
            self.is_escaped = true;
            self.unknown.push(place);
        } else if self.add_options(&text).is_none() {
            self.unknown.push(place);
        }
    }

    /// Adds the options of a word, such as `--pack`, `--pack=a.toml`, `-y`, `-rcell1` or `-yr`. `None` if the command
    /// does not have one of them; those before it are added.
    fn add_options(&mut self, word: &str) -> Option<()> {
        if let Some(long) = word.strip_prefix("--") {
            let (name, value) = long.split_once('=').map_or((long, None), |(name, value)| (name, Some(value)));
            self.add_option(self.long(name)?, value);
            return Some(());
        }
        let mut shorts = word[1..].chars();
        while let Some(short) = shorts.next() {
            let arg = self.command.get_arguments().find(|arg| arg.get_short() == Some(short))?;
            if arg.get_action().takes_values() {
                let value = Some(shorts.as_str()).filter(|value| !value.is_empty());
                self.add_option(arg, value.map(|value| value.strip_prefix('=').unwrap_or(value)));
                return Some(());
            }
            self.add_option(arg, None);
        }
        Some(())
    }

    fn add_option(&mut self, arg: &'c Arg, value: Option<&str>) {
        if value.is_none() && arg.get_action().takes_values() && !arg.is_require_equals_set() {
            self.pending = Some(arg);
        } else {
            self.options.push(GivenOption { arg, value: value.map(OsString::from) });
        }
    }

    /// Returns the option of a long name.
    fn long(&self, name: &str) -> Option<&'c Arg> {
        let has = |arg: &&Arg| {
            arg.get_long() == Some(name) || arg.get_all_aliases().is_some_and(|aliases| aliases.contains(&name))
        };
        self.command.get_arguments().find(has)
    }
}

/// Whether the next word is the option's value; `-` is one, for standard input.
fn takes(option: &Arg, word: &str) -> bool {
    let is_number = || {
        let begins = |rest: &str| rest.starts_with(|c: char| c.is_ascii_digit() || c == '.');
        option.is_allow_negative_numbers_set() && word.strip_prefix('-').is_some_and(begins)
    };
    !word.starts_with('-') || word == "-" || option.is_allow_hyphen_values_set() || is_number()
}
