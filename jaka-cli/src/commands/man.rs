//! `jaka man`: pages of the manual.

use std::fs;
use std::path::PathBuf;

use clap::{Args, CommandFactory};
use clap_mangen::Man as Page;

use super::call;
use crate::failure::Failure;
use crate::output;

/// Write the pages of the manual, one for each command
///
/// `jaka man ~/.local/share/man/man1` writes `jaka.1`, `jaka-status.1` and so on, which `man jaka-status` shows then.
#[derive(Debug, Args)]
pub(crate) struct Man {
    /// The folder for the pages, in which older ones are replaced [default: `jaka.1` alone, on standard output]
    folder: Option<PathBuf>,
}

impl Man {
    pub(crate) fn run(self) -> Result<(), Failure> {
        // The commands of the protocol are in the reference, and in `jaka call COMMAND --help`.
        let mut command = crate::Cli::command().mut_subcommand("call", |_| call::page());
        let Some(folder) = self.folder else {
            command.build();
            let mut page = Vec::new();
            Page::new(command).render(&mut page).map_err(Failure::output)?;
            return output::write(&page);
        };
        let written = fs::create_dir_all(&folder).and_then(|()| clap_mangen::generate_to(command, &folder));
        written.map_err(|error| Failure::local(format!("cannot write pages to {}", folder.display()), error))
    }
}
