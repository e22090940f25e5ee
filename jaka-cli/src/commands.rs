//! Commands, with one file each.
//!
//! A new command is a file with a `#[derive(clap::Args)]` struct with `fn run(self) -> Result<(), Failure>`, and a row
//! of the table of commands. A command that talks to a robot has a field `#[command(flatten)] robot: RobotArgs`, as the
//! last one so that its options have their own heading. It begins with `self.robot.target(&packs)?`, with the packs of
//! a `SpecArgs` or with none. `target/seat.rs` describes the confirmation before it takes the one seat of the command
//! port.

pub(crate) mod call;
mod check;
mod clear;
mod completions;
mod down;
mod explain;
mod export;
mod follow;
mod jitter;
mod jog;
mod man;
mod monitor;
mod move_to;
mod probe;
mod record;
mod replay;
mod report;
mod sim;
mod spec;
mod status;
mod stop;
mod up;

use clap::Subcommand;

use crate::failure::Failure;

pub(crate) use self::call::{all as all_of_call, protocol_of};
pub(crate) use self::stop::StopLine;

/// Generates the enum of the commands, and its `run`.
macro_rules! commands {
    ($($(#[$attribute:meta])* $name:ident($arguments:ty),)*) => {
        /// Command of a command line.
        #[derive(Debug, Subcommand)]
        pub(crate) enum Command {
            $($(#[$attribute])* $name($arguments),)*
        }

        impl Command {
            /// Runs the command.
            pub(crate) fn run(self) -> Result<(), Failure> {
                match self {
                    $(Self::$name(command) => command.run(),)*
                }
            }
        }
    };
}

commands! {
    Status(status::Status),
    Monitor(monitor::Monitor),
    Call(call::Call),
    Up(up::Up),
    Down(down::Down),
    Stop(stop::Stop),
    Clear(clear::Clear),
    Move(move_to::Move),
    Jog(jog::Jog),
    Follow(follow::Follow),
    Check(check::Check),
    Explain(explain::Explain),
    Probe(probe::Probe),
    Jitter(jitter::Jitter),
    Sim(Box<sim::Sim>),
    Record(record::Record),
    Replay(replay::Replay),
    Report(report::Report),
    Export(export::Export),
    Spec(spec::Spec),
    Completions(completions::Completions),
    #[command(hide = true)]
    CompleteWords(completions::CompleteWords),
    Man(man::Man),
}
