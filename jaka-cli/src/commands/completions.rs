//! `jaka completions`: scripts for shells.

use clap::{Args, CommandFactory};
use clap_complete::Shell;

use crate::failure::Failure;
use crate::output;

/// Print the completion script of a shell.
///
/// For bash: `jaka completions bash > ~/.local/share/bash-completion/completions/jaka`.
#[derive(Debug, Args)]
pub(crate) struct Completions {
    /// The shell
    shell: Shell,
}

impl Completions {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let mut script = Vec::new();
        clap_complete::generate(self.shell, &mut crate::Cli::command(), "jaka", &mut script);
        output::write(&script)
    }
}
