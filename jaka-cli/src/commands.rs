//! The commands, one file each.
//!
//! A new one is a file with a `#[derive(clap::Args)]` struct that has `fn run(self) -> Result<(), Failure>`, and a row
//! of the table of commands. One that talks to a robot has a field `#[command(flatten)] robot: RobotArgs`, the last so
//! that its options have a heading of their own, and begins with `self.robot.target(&packs)?`, with the packs of a
//! `SpecArgs` or with none. It asks for the one seat of the command port as `target/seat.rs` says.

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

/// Makes the enum of the commands, and its `run`.
macro_rules! commands {
    ($($(#[$attribute:meta])* $name:ident($arguments:ty),)*) => {
        /// Command of a line.
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
