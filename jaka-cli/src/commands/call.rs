//! `jaka call`: any command of the protocol, with arguments from the spec.
//!
//! The arguments depend on the command and on the packs, so the line is read in two steps: [`outline`] finds the
//! command and the packs, and [`parser`] makes clap's description of that command and parses the rest.

mod consent;
mod exchange;
mod help;
mod lines;
mod options;
mod outline;
mod parser;
mod reply;
mod request;
mod wait;

use std::ffi::OsString;

use clap::Args;
use jaka_spec::{Command, Effect, Spec};

use self::outline::Outline;
use self::parser::Parser;
use crate::failure::Failure;
use crate::failure::command_line;
use crate::target::packs::Protocol;
use crate::terminal::output;

pub(crate) use self::parser::{all, page};
pub(crate) use self::reply::json as reply_json;

/// Send one command of the protocol, and print the reply.
///
/// `jaka call --list` lists the commands, `jaka call COMMAND --help` describes one and its fields, and
/// `jaka call --help` explains the common options.
#[derive(Debug, Args)]
#[command(disable_help_flag = true, override_usage = parser::USAGE)]
pub(crate) struct Call {
    /// Command by its `cmdName` or its name in Rust, its fields, and options
    #[arg(trailing_var_arg = true, allow_hyphen_values = true, value_name = "WORDS")]
    words: Vec<OsString>,
}

impl Call {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let outline = Outline::of(self.words);
        if outline.quiet {
            output::be_quiet();
        }
        let protocol = outline.protocol()?;
        protocol.read_status();
        let spec = &protocol.spec;
        let name = outline.command.as_deref();
        let command = match name {
            Some(name) if !outline.raw => Some(find(spec, name)?),
            _ => None,
        };
        let parser = Parser::of(spec, command);
        let explanations = [true, false].map(|is_parsed| parser.explanation(&outline.rest, is_parsed));
        let [of_fields, of_line] = &explanations;
        let line = parser.parse(outline.rest).map_err(|failure| explained(failure, of_line))?;
        line.options.console.apply();
        if let Some(topic) = &line.options.list {
            return output::lines(&help::list(spec, topic)?);
        }
        if line.options.stdin {
            return match name {
                None => lines::carry_out(&protocol, &line.options),
                Some(name) => Err(Failure::Usage(format!(
                    "--stdin reads the names of commands from standard input, so `{name}` cannot be on the command line"
                ))),
            };
        }
        let request = request::of_line(spec, command, name, &line).map_err(|failure| explained(failure, of_fields))?;
        // The line is valid, but an option may have been meant for an optional field.
        of_line.lines().filter_map(|line| line.strip_prefix("hint: ")).for_each(output::note);
        match request {
            Some(request) => exchange::carry_out(&protocol, &line.options, &request),
            None => output::lines(&help::list(spec, "")?),
        }
    }
}

/// Adds a hint to the failure of a line, if there is one.
fn explained(failure: Failure, hint: &str) -> Failure {
    match failure {
        Failure::CommandLine(error) if command_line::is_help(&error) || hint.is_empty() => Failure::CommandLine(error),
        Failure::Usage(_) | Failure::CommandLine(_) => Failure::Usage(format!("{failure}{hint}")),
        other => other,
    }
}

/// Loads the protocol with the packs of a line, or else of the environment or the config file.
pub(crate) fn protocol_of(words: &[OsString]) -> Result<Protocol, Failure> {
    Outline::of(words.to_vec()).protocol()
}

fn find<'s>(spec: &'s Spec, name: &str) -> Result<&'s Command, Failure> {
    spec.command_called(name).ok_or_else(|| {
        let near = near(spec, name).map(|near| format!("; did you mean `{}`?", near.wire)).unwrap_or_default();
        Failure::Usage(format!(
            "there is no command `{name}`{near}\nhint: `jaka call --list` lists the commands; --pack adds commands, and --raw \
             sends a command that is not in the spec"
        ))
    })
}

/// Returns the command probably meant. Suggests one that moves the arm or switches power only if nothing but signs and
/// case differ: people type suggestions, and must not start another motion.
fn near<'s>(spec: &'s Spec, name: &str) -> Option<&'s Command> {
    let plain = |name: &str| name.replace(['-', '_'], "").to_lowercase();
    let is_same = |command: &&Command| [&command.wire, &command.name].iter().any(|known| plain(known) == plain(name));
    let is_harmless = |command: &&Command| !matches!(command.effect, Effect::Motion | Effect::Power);
    spec.commands().find(is_same).or_else(|| spec.command_like(name).filter(is_harmless))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_other_motion_is_suggested() {
        let spec = jaka_spec::builtin().expect("the spec's own tests load it");
        let near = |name| near(&spec, name).map(|command| command.wire.as_str());
        assert_eq!(near("joint-move"), Some("joint_move"));
        assert_eq!(near("movel"), Some("moveL"));
        assert_eq!(near("get-joint-pos"), Some("get_joint_pos"));
        assert_eq!(near("get_joint_poss"), Some("get_joint_pos"));
        for other in ["joint_moves", "moveJ", "movej", "power_ob", "enable_robo"] {
            assert_eq!(near(other), None, "{other}");
        }
    }
}
