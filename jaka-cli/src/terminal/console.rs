//! Options for messages on standard error, and for colours.

use anstream::ColorChoice;
use clap::{ArgAction, Args, ValueEnum};

use crate::terminal::{logging, output};

/// Options of every command.
#[derive(Debug, Args)]
pub(crate) struct ConsoleArgs {
    /// Log connections, requests and replies on standard error; `-vv` also the actions of a simulated controller
    #[arg(long, short, global = true, action = ArgAction::Count, help_heading = HEADING)]
    verbose: u8,
    /// Print only errors, questions and outcomes of motions on standard error
    #[arg(long, short, global = true, conflicts_with = "verbose", help_heading = HEADING)]
    quiet: bool,
    /// Colours: always, never, or auto: on terminals, unless `NO_COLOR` is set [default: auto]
    #[arg(long, global = true, value_enum, value_name = "WHEN", default_value_t, help_heading = HEADING)]
    #[arg(hide_default_value = true, hide_possible_values = true)]
    color: Color,
}

const HEADING: &str = "Messages";

/// Use of colours.
#[derive(Debug, Clone, Copy, Default, ValueEnum)]
enum Color {
    /// On terminals, unless `NO_COLOR` is set
    #[default]
    Auto,
    /// Also without a terminal
    Always,
    /// No colours
    Never,
}

impl ConsoleArgs {
    /// Applies the options to later messages. Options of an earlier call stay, since a line can have them at two
    /// places.
    pub(crate) fn apply(&self) {
        if self.quiet {
            output::be_quiet();
        }
        if self.verbose > 0 {
            logging::tell(self.verbose);
        }
    }
}

/// Selects the colours of a line, also for texts printed before it can be parsed: its help and its errors.
pub(crate) fn color(words: impl Iterator<Item = String>) {
    let mut words = words.take_while(|word| word != "--").peekable();
    while let Some(word) = words.next() {
        let value = match word.strip_prefix("--color") {
            Some("") => words.peek().map(String::as_str),
            Some(value) => value.strip_prefix('='),
            None => None,
        };
        let Some(color) = value.and_then(|value| Color::from_str(value, false).ok()) else { continue };
        match color {
            Color::Auto => {}
            Color::Always => use_colors(ColorChoice::Always),
            Color::Never => use_colors(ColorChoice::Never),
        }
    }
}

fn use_colors(choice: ColorChoice) {
    choice.write_global();
    // Colours of the dashboard.
    ratatui::crossterm::style::force_color_output(choice == ColorChoice::Always);
}
