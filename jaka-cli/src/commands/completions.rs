//! `jaka completions`: scripts for shells, which call this program.

mod completion;

use std::ffi::OsString;

use clap::{Args, ValueEnum};
use jaka_sync::proto::text::visible;

use self::completion::{Completion, complete};
use crate::failure::Failure;
use crate::terminal::output;

/// Print the completion script of a shell
///
/// For bash: `jaka completions bash > ~/.local/share/bash-completion/completions/jaka`. The script asks `jaka` itself
/// for commands, the commands and fields of the protocol with those of packs, values, robots of the config file, and
/// the fields of a recording.
#[derive(Debug, Args)]
pub(crate) struct Completions {
    /// Shell
    shell: Shell,
}

/// Shell with completions.
#[derive(Debug, Clone, Copy, ValueEnum)]
enum Shell {
    Bash,
    Zsh,
    Fish,
    Powershell,
}

impl Completions {
    pub(crate) fn run(self) -> Result<(), Failure> {
        output::lines(match self.shell {
            Shell::Bash => include_str!("completions/jaka.bash"),
            Shell::Zsh => include_str!("completions/jaka.zsh"),
            Shell::Fish => include_str!("completions/jaka.fish"),
            Shell::Powershell => include_str!("completions/jaka.ps1"),
        })
    }
}

/// Print the completions of a word, for shell scripts: `file`, or `words` and one line each
#[derive(Debug, Args)]
pub(crate) struct CompleteWords {
    /// Word at the cursor
    #[arg(long, allow_hyphen_values = true)]
    current: String,
    /// Words before it
    #[arg(last = true)]
    before: Vec<OsString>,
}

impl CompleteWords {
    pub(crate) fn run(self) -> Result<(), Failure> {
        match complete(&self.before, &self.current) {
            Completion::File => output::line("file"),
            Completion::Words(words) => {
                output::line("words")?;
                // A tab in a word would start its help, and a line end another word.
                let words = words
                    .iter()
                    .map(|candidate| format!("{}\t{}\n", visible(&candidate.word), visible(&candidate.help)));
                output::write(words.collect::<String>().as_bytes())
            }
        }
    }
}
