//! Options of `jaka call` for every command.

use clap::{Args, ValueEnum};
use jaka_dynamic::AdvisoryRanges;

use crate::choice::{Choice, one_of};
use crate::target::RobotArgs;
use crate::target::packs::SpecArgs;
use crate::terminal::console::ConsoleArgs;

/// Options of every command.
#[expect(clippy::struct_excessive_bools, reason = "each is a switch of its own")]
#[derive(Debug, Args)]
pub(super) struct Options {
    /// List the commands, or those of a topic
    #[arg(long, value_name = "TOPIC", num_args = 0..=1, default_missing_value = "")]
    pub(super) list: Option<String>,
    /// Whole request instead of fields: JSON, or @FILE, or - for standard input
    ///
    /// The request is checked like fields. It may omit `cmdName` if the line names the command.
    #[arg(long, value_name = "JSON", allow_hyphen_values = true)]
    pub(super) params: Option<String>,
    /// Send the request of --params unchecked, also for a command that is not in the spec; needs --yes
    #[arg(long, conflicts_with_all = ["check_firmware", "advisory_ranges", "wait"])]
    pub(super) raw: bool,
    /// Send without asking
    ///
    /// Commands that move the arm, switch power or change a setting ask for confirmation on a terminal, and are refused
    /// elsewhere without this option. Queries, commands of the connection, and commands that stop or pause the arm are
    /// sent at once. On a terminal, queries and commands of the connection first warn that another program may lose the
    /// command port.
    #[arg(long, short)]
    pub(super) yes: bool,
    /// Whether to enforce advisory ranges: those that newer firmware has widened, and recommended ones
    #[arg(long, value_name = "WHAT", default_value = "enforce", value_parser = one_of(&RANGES))]
    pub(super) advisory_ranges: AdvisoryRanges,
    /// Query the controller's version first, and send only requests that its firmware has
    #[arg(long)]
    pub(super) check_firmware: bool,
    /// Wait for the end of the motion, with an exit code for its outcome; Ctrl-C stops the arm
    ///
    /// The arm is at its target if the controller confirms this in a query after the motion. The wait ends after 300 s,
    /// or after --timeout; the motion does not. For `joint_move`, `end_move`, `moveL`, `movc` and
    /// `start_torq_sensor_payload_identify`.
    #[arg(long)]
    pub(super) wait: bool,
    /// Print the bytes of the request without sending them
    #[arg(long, conflicts_with = "wait")]
    pub(super) dry_run: bool,
    /// Print one JSON object: `command` and `reply`, by the names of its fields; or, with `=wire`, the reply's text as
    /// received
    #[arg(long, value_enum, value_name = "KEYS", num_args = 0..=1, require_equals = true, default_missing_value = "names")]
    pub(super) json: Option<Keys>,
    /// Read requests from standard input, one JSON object a line, and print a line of JSON for each; over one
    /// connection
    ///
    /// A line has the whole request, as for --params. The answer has `command`, and `reply` by the names of its fields.
    /// With --wait, the program waits for the end of motions, and the answer has their `end`. After a failure, the
    /// answer has `error` and `exit_code`, and the program ends. It asks no questions: commands for which `jaka call`
    /// asks need --yes.
    #[arg(long, conflicts_with_all = ["params", "raw", "dry_run", "list", "check_firmware", "json"])]
    pub(super) stdin: bool,
    /// With --stdin, continue after a failure; the exit code is that of the first one
    #[arg(long, requires = "stdin")]
    pub(super) keep_going: bool,
    #[command(flatten)]
    pub(super) spec: SpecArgs,
    #[command(flatten)]
    pub(super) robot: RobotArgs,
    #[command(flatten)]
    pub(super) console: ConsoleArgs,
}

/// Keys of a reply printed as JSON.
#[derive(Debug, Clone, Copy, PartialEq, ValueEnum)]
pub(super) enum Keys {
    /// Names of the fields in Rust, with values in the form of the spec, and without the envelope
    Names,
    /// Text of the reply as received
    Wire,
}

const RANGES: [Choice<AdvisoryRanges>; 2] = [
    ("enforce", "They are enforced like all others", AdvisoryRanges::Enforced),
    ("ignore", "They are left to the controller", AdvisoryRanges::Ignored),
];
