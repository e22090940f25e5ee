//! `jaka status`: what the status packets of port 10000 say.

mod lines;
mod packets;
mod table;
mod until;

use std::num::NonZeroU64;
use std::time::Duration;

use clap::{Args, ValueEnum};
use jaka_sync::proto::text::visible_json_line;

use self::lines::Columns;
use self::packets::Packets;
use self::table::StatusTable;
use self::until::{POLL, Until};
use crate::condition::Condition;
use crate::exit;
use crate::failure::Failure;
use crate::fields::Field;
use crate::interrupt::end_on_interrupt;
use crate::output;
use crate::packs::SpecArgs;
use crate::seconds::seconds;
use crate::target::RobotArgs;

/// Print the robot's state, once or repeatedly.
///
/// Only reads, from the status port, so that it disturbs no other program.
#[derive(Debug, Args)]
pub(crate) struct Status {
    /// Print again every second, or at this interval in seconds; 0 for every packet
    #[arg(long, short, value_name = "SECONDS", num_args = 0..=1, default_missing_value = "1", value_parser = seconds)]
    watch: Option<Duration>,
    /// End after this many packets; without --watch one a second
    #[arg(long, short = 'n', value_name = "N")]
    count: Option<NonZeroU64>,
    /// Wait until a packet shows this, such as `in_position && !protective_stop`; print that packet
    ///
    /// Fields that are truth values; comparisons of numbers with ==, !=, <, <=, > and >=; &&, ||, ! and parentheses. With --watch, packets
    /// before it are printed, too. The exit code is 27 if it is not shown within --timeout, and 130 on Ctrl-C.
    #[arg(long, value_name = "CONDITION", conflicts_with_all = ["raw", "count"])]
    until: Option<String>,
    /// What to print, such as `enabled,actual_position.x`; `all` for everything [default: the usual]
    ///
    /// Names are those of the Rust API or those of the wire, with indices as in `joint_actual_position[0]`.
    #[arg(long, short, value_name = "NAMES", conflicts_with = "raw")]
    fields: Option<String>,
    /// How to print it
    #[arg(long, value_enum, default_value_t, conflicts_with = "raw")]
    format: Format,
    /// Print each packet's own text on one line, with JSON escapes for invisible characters
    #[arg(long)]
    raw: bool,
    #[command(flatten)]
    spec: SpecArgs,
    #[command(flatten)]
    robot: RobotArgs,
}

/// How packets are printed.
#[derive(Debug, Clone, Copy, Default, ValueEnum)]
enum Format {
    /// For people
    #[default]
    Table,
    /// One JSON object per line, with the Unix time at which the packet was read, in seconds
    Json,
    /// A header, then one line per packet; arrays take one column per element
    Csv,
}

impl Status {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let protocol = self.spec.load(self.robot.config())?;
        let target = self.robot.target(&protocol.packs)?;
        protocol.read_status();
        let fields = Field::named(self.fields.as_deref())?;
        let until = self.until.as_deref().map(str::parse::<Condition>).transpose();
        let until = until.map_err(|error| Failure::Usage(format!("`--until`, {error}")))?;
        end_on_interrupt(if until.is_some() { exit::INTERRUPTED } else { 0 });
        let limit = target.timeout().filter(|_| until.is_some());
        let stream = match limit {
            Some(limit) => target.status_stream_within(POLL.min(limit))?,
            None => target.status_stream()?,
        };
        let period = if until.is_some() { self.watch } else { self.watch.or(Some(Duration::from_secs(1))) };
        let mut packets = Packets::new(stream, period, until.map(|condition| Until::new(condition, limit)));
        let packets = &mut packets;
        if self.raw {
            return self.print(packets, |packets| Ok(visible_json_line(&packets.next_text()?).into_owned() + "\n"));
        }
        match self.format {
            Format::Table => {
                let table = StatusTable::new(fields, self.repeats());
                self.print(packets, |packets| Ok(table.text(&packets.next()?)))
            }
            Format::Json => self.print(packets, |packets| Ok(lines::json(&fields, &packets.next()?))),
            Format::Csv => {
                let mut columns = Columns::new(fields);
                self.print(packets, |packets| Ok(columns.lines(&packets.next()?)))
            }
        }
    }

    fn repeats(&self) -> bool {
        self.watch.is_some() || self.count.is_some()
    }

    /// Prints packets, each by `text`, until there have been enough.
    fn print(
        &self,
        packets: &mut Packets,
        mut text: impl FnMut(&mut Packets) -> Result<String, Failure>,
    ) -> Result<(), Failure> {
        let once = !self.repeats() && self.until.is_none();
        let most = if once { 1 } else { self.count.map_or(u64::MAX, NonZeroU64::get) };
        for _ in 0..most {
            output::write(text(packets)?.as_bytes())?;
            if packets.is_last() {
                break;
            }
        }
        Ok(())
    }
}
