//! `jaka man`: pages of the manual.

use std::path::{Path, PathBuf};
use std::{fs, io};

use clap::{Args, Command, CommandFactory};
use clap_mangen::Man as Page;

use super::call;
use crate::failure::Failure;
use crate::terminal::output;

/// Write the pages of the manual, one for each command
///
/// `jaka man ~/.local/share/man/man1` writes `jaka.1`, `jaka-status.1` and so on, for `man jaka-status`.
#[derive(Debug, Args)]
pub(crate) struct Man {
    /// Folder for the pages; older pages are replaced [default: only `jaka.1`, on standard output]
    folder: Option<PathBuf>,
}

impl Man {
    pub(crate) fn run(self) -> Result<(), Failure> {
        // The reference, and `jaka call COMMAND --help`, have the commands of the protocol.
        let command = crate::Cli::command().mut_subcommand("call", |_| call::page());
        let mut command = command.disable_help_subcommand(true);
        command.build();
        let Some(folder) = self.folder else {
            return output::write(text(&Page::new(command)).map_err(Failure::output)?.as_bytes());
        };
        let written = fs::create_dir_all(&folder).and_then(|()| write(&command, &folder));
        written.map_err(|error| Failure::local(format!("cannot write pages to {}", folder.display()), error))
    }
}

/// Writes the page of a command, and those of its subcommands.
fn write(command: &Command, folder: &Path) -> io::Result<()> {
    let page = Page::new(command.clone());
    fs::write(folder.join(page.get_filename()), text(&page)?)?;
    command.get_subcommands().filter(|command| !command.is_hide_set()).try_for_each(|command| write(command, folder))
}

/// Returns the text of a page. The part after the options has its own lines, which need the whole width.
fn text(page: &Page) -> io::Result<String> {
    let mut text = Vec::new();
    page.render(&mut text)?;
    let text = String::from_utf8(text).map_err(io::Error::other)?;
    Ok(text.replace(".SH EXTRA\n", ".SH NOTES\n.in 0\n.ad l\n"))
}
