//! What must be known of a command line before it can be parsed: its command, and its packs.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use clap::{Arg, Command};

use super::parser;
use crate::failure::Failure;
use crate::packs::{Protocol, SpecArgs};
use crate::target::Lookup;

/// The command, the packs and the rest of a line.
#[derive(Debug, Default)]
pub(super) struct Outline {
    /// The command, as it was typed.
    pub(super) command: Option<String>,
    /// The values of `--pack`.
    pub(super) packs: Vec<PathBuf>,
    /// The value of `--config`.
    pub(super) config: Option<PathBuf>,
    /// The value of `--robot`.
    pub(super) robot: Option<PathBuf>,
    /// True if `--raw` is given.
    pub(super) raw: bool,
    /// True if `--quiet` is given.
    pub(super) quiet: bool,
    /// The line without the command.
    pub(super) rest: Vec<OsString>,
}

impl Outline {
    /// Goes through the words of a line. Errors are left to the parser.
    pub(super) fn of(words: Vec<OsString>) -> Self {
        let known = parser::bare();
        let mut outline = Self::default();
        let mut words = words.into_iter().peekable();
        while let Some(word) = words.next() {
            let text = word.to_string_lossy();
            if !text.starts_with('-') {
                if outline.command.is_none() {
                    outline.command = Some(text.into_owned());
                } else {
                    outline.rest.push(word);
                }
                continue;
            }
            let mut next = None;
            for (option, own_value) in options(&known, &text) {
                next = words.next_if(|next| own_value.is_none() && takes(option, next));
                let value = own_value.map(OsString::from).or_else(|| next.clone());
                outline.note(option.get_id().as_str(), value.map(PathBuf::from));
            }
            outline.rest.push(word);
            outline.rest.extend(next);
        }
        outline
    }

    /// The protocol with these packs, or else with those of the environment or the config file.
    pub(super) fn protocol(&self) -> Result<Protocol, Failure> {
        let robot = self.robot.as_deref().and_then(Path::to_str);
        SpecArgs::of(self.packs.clone()).load(Lookup { config: self.config.as_deref(), robot })
    }

    fn note(&mut self, option: &str, value: Option<PathBuf>) {
        match option {
            "packs" => self.packs.extend(value),
            "config" => self.config = value,
            "robot" => self.robot = value,
            "raw" => self.raw = true,
            "quiet" => self.quiet = true,
            _ => {}
        }
    }
}

/// The options of a word, such as `--pack`, `--pack=a.toml`, `-y`, `-rcell1` or `-yr`, each with the value that the
/// word gives it. One that takes a value is the last.
fn options<'c, 'w>(known: &'c Command, word: &'w str) -> Vec<(&'c Arg, Option<&'w str>)> {
    let mut found = Vec::new();
    if let Some(long) = word.strip_prefix("--") {
        let (name, value) = long.split_once('=').map_or((long, None), |(name, value)| (name, Some(value)));
        found.extend(known.get_arguments().find(|arg| arg.get_long() == Some(name)).map(|arg| (arg, value)));
        return found;
    }
    let mut shorts = word.strip_prefix('-').unwrap_or(word).chars();
    while let Some(short) = shorts.next() {
        let Some(arg) = known.get_arguments().find(|arg| arg.get_short() == Some(short)) else { break };
        let value = shorts.as_str();
        if arg.get_action().takes_values() {
            found.push((arg, (!value.is_empty()).then(|| value.strip_prefix('=').unwrap_or(value))));
            break;
        }
        found.push((arg, None));
    }
    found
}

/// True if the next word is the option's value; `-` is one, for standard input.
fn takes(option: &Arg, next: &OsString) -> bool {
    let is_option = next.len() > 1 && next.to_string_lossy().starts_with('-');
    option.get_action().takes_values() && !option.is_require_equals_set() && !is_option
}

#[cfg(test)]
mod tests {
    use super::*;

    fn outline(line: &str) -> Outline {
        Outline::of(line.split_whitespace().map(OsString::from).collect())
    }

    #[test]
    fn options_may_stand_on_both_sides_of_the_command() {
        let found = outline("--sim --pack a.toml -r x joint_move --pack=b.toml --speed -20 --config c.toml");
        assert_eq!(found.command.as_deref(), Some("joint_move"));
        assert_eq!(found.packs, [PathBuf::from("a.toml"), PathBuf::from("b.toml")]);
        assert_eq!(found.config, Some(PathBuf::from("c.toml")));
        assert!(!found.raw);
        let rest: Vec<_> = "--sim --pack a.toml -r x --pack=b.toml --speed -20 --config c.toml".split(' ').collect();
        assert_eq!(found.rest, rest);
    }

    #[test]
    fn the_robot_is_found_however_its_option_is_written() {
        for line in ["-r cell2", "-rcell2", "-r=cell2", "-yrcell2", "-yr cell2", "--robot cell2", "--robot=cell2"] {
            let found = outline(&format!("{line} power_on"));
            assert_eq!(found.robot.as_deref(), Some(Path::new("cell2")), "{line}");
            assert_eq!(found.command.as_deref(), Some("power_on"), "{line}");
            let parsed = parser::Parser::of(crate::builtin::spec(), None).parse(found.rest).expect("it is a line");
            assert_eq!(parsed.options.robot.lookup().robot, Some("cell2"), "{line}");
        }
    }

    #[test]
    fn what_an_option_takes_is_not_a_command() {
        assert_eq!(outline("--params - --raw --list io").command, None);
        assert_eq!(outline("--sim=zu7 power_on").command.as_deref(), Some("power_on"));
        assert!(outline("--raw --list").raw);
        assert_eq!(outline("--pack").packs, Vec::<PathBuf>::new());
    }
}
