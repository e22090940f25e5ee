//! The options that `jaka call` has for every command.

use clap::{Args, ValueEnum};
use jaka_dynamic::AdvisoryRanges;

use crate::choice::{Choice, one_of};
use crate::target::RobotArgs;
use crate::target::packs::SpecArgs;
use crate::terminal::console::ConsoleArgs;

/// The options that every command has.
#[expect(clippy::struct_excessive_bools, reason = "each is a switch of its own")]
#[derive(Debug, Args)]
pub(super) struct Options {
    /// List the commands, or those of a topic
    #[arg(long, value_name = "TOPIC", num_args = 0..=1, default_missing_value = "")]
    pub(super) list: Option<String>,
    /// The whole request in place of fields: JSON, or @FILE, or - for standard input
    ///
    /// It is checked like fields. `cmdName` may be left out if the command is named before.
    #[arg(long, value_name = "JSON", allow_hyphen_values = true)]
    pub(super) params: Option<String>,
    /// Send the request of --params unchecked, also for a command that is not in the spec; needs --yes
    #[arg(long, conflicts_with_all = ["check_firmware", "advisory_ranges", "wait"])]
    pub(super) raw: bool,
    /// Send without asking
    ///
    /// Commands that move the arm, switch power or change a setting ask for confirmation on a terminal, and are refused
    /// elsewhere unless this is given. Queries, commands of the connection, and those that stop or pause the arm are
    /// sent at once; on a terminal a warning says before the former two that another program may lose the command port.
    #[arg(long, short)]
    pub(super) yes: bool,
    /// Whether advisory ranges are enforced: those that newer firmware has widened, and those that are only advised
    #[arg(long, value_name = "WHAT", default_value = "enforce", value_parser = one_of(&RANGES))]
    pub(super) advisory_ranges: AdvisoryRanges,
    /// Ask for the controller's version first, and send only what that firmware has
    #[arg(long)]
    pub(super) check_firmware: bool,
    /// Wait until the motion has ended, and tell by the exit code how; Ctrl-C stops the arm
    ///
    /// The arm is where it was sent if the controller says so when it is asked after the motion. The wait ends after
    /// 300 s, or after --timeout; the motion does not. For `joint_move`, `end_move`, `moveL`, `movc` and
    /// `start_torq_sensor_payload_identify`.
    #[arg(long)]
    pub(super) wait: bool,
    /// Print the bytes that would be sent, and send nothing
    #[arg(long, conflicts_with = "wait")]
    pub(super) dry_run: bool,
    /// Print one JSON object: `command` and `reply`, by the names of its fields; or, with `=wire`, the reply's text as
    /// received
    #[arg(long, value_enum, value_name = "KEYS", num_args = 0..=1, require_equals = true, default_missing_value = "names")]
    pub(super) json: Option<Keys>,
    /// Read requests from standard input, one JSON object a line, and print a line of JSON for each; over one
    /// connection
    ///
    /// A line has the whole request, as --params takes it. The answer has `command`, and `reply` by the names of its
    /// fields; with --wait motions are waited for, and it has their `end`; where something fails, `error` and
    /// `exit_code`. The first failure ends it. Nothing is asked: commands about which `jaka call` would ask
    /// need --yes.
    #[arg(long, conflicts_with_all = ["params", "raw", "dry_run", "list", "check_firmware", "json"])]
    pub(super) stdin: bool,
    /// With --stdin, go on after a failure; the exit code is that of the first
    #[arg(long, requires = "stdin")]
    pub(super) keep_going: bool,
    #[command(flatten)]
    pub(super) spec: SpecArgs,
    #[command(flatten)]
    pub(super) robot: RobotArgs,
    #[command(flatten)]
    pub(super) console: ConsoleArgs,
}

/// The keys of a reply that is printed as JSON.
#[derive(Debug, Clone, Copy, PartialEq, ValueEnum)]
pub(super) enum Keys {
    /// The names of the fields in Rust, values as the spec has them, and without the envelope
    Names,
    /// The reply's text as received
    Wire,
}

const RANGES: [Choice<AdvisoryRanges>; 2] = [
    ("enforce", "They are enforced like all others", AdvisoryRanges::Enforced),
    ("ignore", "They are left to the controller", AdvisoryRanges::Ignored),
];
