//! The `jaka` command: see the crate's README.

mod arm;
mod builtin;
mod choice;
mod commands;
mod failure;
mod listen;
mod packets;
mod plots;
mod recordings;
mod target;
mod terminal;
#[cfg(test)]
mod tests;
mod text;
mod words;

use std::env::args_os;
use std::ffi::OsString;
use std::process::ExitCode;

use clap::Parser;

use crate::commands::{Command, StopLine};
use crate::failure::Failure;
use crate::failure::command_line::is_help;
use crate::terminal::console::ConsoleArgs;

/// Text of `jaka --help` after the list of commands.
const NOTES: &str = "\
The robot:
  Commands that talk to a robot take its address from, in this order: --sim,
  --robot, the environment's JAKA_ROBOT, and `robot = \"NAME\"` in the config
  file. Each may be an address or the name of a [robots.NAME] in the config
  file, which is ~/.config/jaka/config.toml unless --config or JAKA_CONFIG say
  otherwise.

Command packs:
  Commands that accept packs take them from, in this order: --pack, the
  environment's JAKA_PACK, and `packs = [\"FILE\"]` in the config file. The
  first of these that names any is used.

Exit codes:
  0  success; also when the reader of the output closes it, and on Ctrl-C if
     the command runs until then
  1  the controller refused the command, which did not run
  2  the command line, the config file, a pack or an argument is wrong, or a
     question was not answered with yes; nothing was sent
  3  no connection could be made; nothing was sent
  4  the command may have run: no reply in time, or an unexpected one; check
     the robot's state before you go on
  5  the connection was lost or became unreadable with no command outstanding;
     also no status packet in time
  6  something on this machine: a file, a port, the terminal
  7  `jaka probe` found a departure from the spec or got no answer; clients of
     `jaka replay` deviated from the recording
  8, 9  `jaka check` found something to look at, or something wrong; also
        where no connection could be made
  10, 11, 12  `jaka spec diff --exit-code` found differences: patch, minor or
              major at most
  20 to 30 are for what moves the arm, and 27 for whatever is waited for:
  20  the robot's state or a limit forbids it, or the state is not known;
      nothing that moves the arm was sent
  21  the arm is at rest, and it is not known whether it is where it was sent
  22  the motion ended before its target, also by Ctrl-C, after which the arm
      was seen at rest
  23  a protective stop
  24  the emergency stop
  25  the arm has no power, or is not enabled
  26  the controller reports an error
  27  what was waited for did not come in time; a motion may go on
  28  no status packets that can be read any more; the arm may still move
  29  Ctrl-C or `jaka stop`, and the arm may still move: the controller has
      not taken the stop, or it is not known whether it has, or the arm still
      moves after it, or cannot be observed
  30  `jaka follow`: set-points were too late or refused, or a joint did not
      follow; the message says whether the arm is at rest
  130  Ctrl-C before anything was sent that changes something, or before what
       was waited for";

/// Commands, status, live dashboard and simulated controller for JAKA robots.
#[derive(Debug, Parser)]
#[command(name = "jaka", version, after_long_help = NOTES, after_help = "`jaka --help` also explains exit codes.")]
struct Cli {
    #[command(subcommand)]
    command: Command,
    #[command(flatten)]
    console: ConsoleArgs,
}

impl Cli {
    /// Reads a command line. That of `jaka stop` may have words that do not concern it.
    fn read(line: &[OsString]) -> Result<Self, clap::Error> {
        let error = match Self::try_parse_from(line) {
            Err(error) if !is_help(&error) => error,
            read => return read,
        };
        let Some(stop) = StopLine::of(line) else { return Err(error) };
        let mut cli = Self::try_parse_from(stop.words)?;
        if let Command::Stop(command) = &mut cli.command {
            (command.ignored, command.packs) = (stop.ignored, stop.packs);
        }
        Ok(cli)
    }
}

fn main() -> ExitCode {
    let caught = arm::interrupt::begin();
    terminal::logging::begin();
    terminal::console::color(args_os().skip(1).map(|word| word.to_string_lossy().into_owned()));
    let result = caught.and_then(|()| run());
    terminal::logging::finish();
    result.map_or_else(|failure| terminal::exit::report(&failure), |()| ExitCode::SUCCESS)
}

fn run() -> Result<(), Failure> {
    let cli = Cli::read(&args_os().collect::<Vec<_>>())?;
    cli.console.apply();
    let result = cli.command.run();
    let recorded = recordings::record::finish();
    result.and(recorded.map(drop))
}
