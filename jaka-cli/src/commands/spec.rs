//! `jaka spec`: checks, comparisons and documents of a spec.

mod check;
mod diff;
mod document;
mod files;

use clap::{Args, Subcommand};
use jaka_sync::proto::text::visible_json;

use crate::failure::Failure;

/// Check specs and packs, compare them, and write documents from them.
///
/// Does not connect to a robot.
#[derive(Debug, Args)]
pub(crate) struct Spec {
    #[command(subcommand)]
    command: SpecCommand,
}

#[derive(Debug, Subcommand)]
enum SpecCommand {
    Check(check::SpecCheck),
    Diff(diff::Diff),
    Doc(document::Reference),
    /// Write the JSON Schema of all messages
    Schema(document::Document),
}

impl Spec {
    pub(crate) fn run(self) -> Result<(), Failure> {
        match self.command {
            SpecCommand::Check(command) => command.run(),
            SpecCommand::Diff(command) => command.run(),
            SpecCommand::Doc(command) => command.run(),
            SpecCommand::Schema(command) => command.run(document::schema, visible_json),
        }
    }
}
