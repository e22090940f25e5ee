//! `jaka completions`: scripts for shells.

use clap::{Args, CommandFactory};
use clap_complete::Shell;

use super::call;
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
        // Those of `jaka call` come from the spec when it runs.
        let spec = jaka_spec::builtin().expect("the spec's own tests load it");
        let mut command = crate::Cli::command().mut_subcommand("call", |_| call::all(&spec));
        let mut script = Vec::new();
        clap_complete::generate(self.shell, &mut command, "jaka", &mut script);
        output::write(&script)
    }
}
