//! Command and packs of a line, which must be known before parsing.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use super::parser;
use crate::failure::Failure;
use crate::target::Lookup;
use crate::target::packs::{Protocol, SpecArgs};
use crate::words::Words;

/// Command, packs and rest of a line.
#[derive(Debug)]
pub(super) struct Outline {
    /// Command, as typed.
    pub(super) command: Option<String>,
    /// Values of `--pack`.
    pub(super) packs: Vec<PathBuf>,
    /// Value of `--config`.
    pub(super) config: Option<PathBuf>,
    /// Value of `--robot`.
    pub(super) robot: Option<PathBuf>,
    /// Whether `--raw` is given.
    pub(super) raw: bool,
    /// Whether `--quiet` is given.
    pub(super) quiet: bool,
    /// Line without the command.
    pub(super) rest: Vec<OsString>,
}

impl Outline {
    /// Reads the outline from the words of a line. The parser reports errors.
    pub(super) fn of(mut words: Vec<OsString>) -> Self {
        let known = parser::bare();
        let line = Words::of(&known, &words);
        let path = |id| line.value(id).map(PathBuf::from);
        let (packs, config, robot) = (line.values("packs").map(PathBuf::from).collect(), path("config"), path("robot"));
        let (raw, quiet) = (line.has("raw"), line.has("quiet"));
        let command = line.positionals.into_iter().next();
        let (place, command) = command.map(|command| (command.place, command.word.into_owned())).unzip();
        if let Some(place) = place {
            words.remove(place);
        }
        Self { command, packs, config, robot, raw, quiet, rest: words }
    }

    /// Loads the protocol with these packs, or else with those of the environment or the config file.
    pub(super) fn protocol(&self) -> Result<Protocol, Failure> {
        let robot = self.robot.as_deref().and_then(Path::to_str);
        SpecArgs::of(self.packs.clone()).load(Lookup { config: self.config.as_deref(), robot })
    }
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
