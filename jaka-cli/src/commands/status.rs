//! `jaka status`: contents of the status packets of port 10000.

mod lines;
mod packets;
mod table;
mod until;

use std::num::NonZeroU64;
use std::time::Duration;
#[cfg(not(test))]
use std::time::Instant;

use clap::{Args, ValueEnum};
use jaka_sync::proto::text::visible_json_line;

use self::packets::{Due, Overdue, PacketSource};
use self::table::StatusTable;
use self::until::{POLL, Until};
use crate::arm::interrupt::end_on_interrupt;
use crate::failure::Failure;
use crate::packets::condition::Condition;
use crate::packets::fields::Field;
use crate::target::RobotArgs;
use crate::target::packs::SpecArgs;
use crate::terminal::exit;
use crate::terminal::output;
#[cfg(test)]
use crate::tests::now;
use crate::text::seconds::seconds;

/// Print the robot's state, once or repeatedly.
///
/// Reads only the status port, so that it disturbs no other program.
#[derive(Debug, Args)]
pub(crate) struct Status {
    /// Print again every second, or at this interval in seconds; 0 for every packet
    #[arg(long, short, value_name = "SECONDS", num_args = 0..=1, default_missing_value = "1", value_parser = seconds)]
    watch: Option<Duration>,
    /// End after this many packets; without --watch one a second
    #[arg(long, short = 'n', value_name = "N")]
    count: Option<NonZeroU64>,
    /// Wait until a packet meets this condition, such as `in_position && !protective_stop`; print that packet
    ///
    /// A condition consists of fields that are truth values; comparisons of numbers with ==, !=, <, <=, > and >=; &&,
    /// ||, ! and parentheses. With --watch, earlier packets are printed, too. The exit code is 27 if no packet meets
    /// the condition within --timeout, and 130 on Ctrl-C.
    #[arg(long, value_name = "CONDITION", conflicts_with_all = ["raw", "count"])]
    until: Option<String>,
    /// Fields to print, such as `enabled,actual_position.x`; `all` for everything [default: the usual]
    ///
    /// Names are those of the Rust API or those of the wire, with indices as in `joint_actual_position[0]`.
    #[arg(long, short, value_name = "NAMES", conflicts_with = "raw")]
    fields: Option<String>,
    /// Output format
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

/// Format of the packets.
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
        let protocol = self.spec.load(self.robot.lookup())?;
        let target = self.robot.target(&protocol.packs)?;
        protocol.read_status();
        let fields = Field::named(self.fields.as_deref())?;
        let until = self.until.as_deref().map(str::parse::<Condition>).transpose();
        let until = until.map_err(|error| Failure::Usage(format!("`--until`, {error}")))?;
        end_on_interrupt(if until.is_some() { exit::INTERRUPTED } else { 0 });
        let limit = target.timeout().filter(|_| until.is_some());
        let stream = target.status_stream_within(limit.map_or(POLL, |limit| POLL.min(limit)))?;
        let period = if until.is_some() { self.watch } else { self.watch.or(Some(Duration::from_secs(1))) };
        let mut packets =
            PacketSource::new(stream, target.config(), period, until.map(|condition| Until::new(condition, limit)));
        let packets = &mut packets;
        if self.raw {
            let text = |text: String| visible_json_line(&text).into_owned() + "\n";
            return self.print(packets, PacketSource::next_text, text, warn);
        }
        match self.format {
            Format::Table => {
                let table = StatusTable::new(fields, self.repeats());
                let overdue = |overdue: &Overdue| output::write(table.without_packet(overdue).as_bytes());
                self.print(packets, PacketSource::next, |packet| table.text(&packet), overdue)
            }
            Format::Json => self.print(packets, PacketSource::next, |packet| lines::json(&fields, &packet), warn),
            Format::Csv => {
                let mut columns = None;
                self.print(packets, PacketSource::next, |packet| lines::csv(&fields, &mut columns, &packet), warn)
            }
        }
    }

    fn repeats(&self) -> bool {
        self.watch.is_some() || self.count.is_some()
    }

    /// Prints packets, each with `text`, up to the requested number, and reports times without packets.
    fn print<T>(
        &self,
        packets: &mut PacketSource,
        next: impl Fn(&mut PacketSource) -> Result<Due<T>, Failure>,
        mut text: impl FnMut(T) -> String,
        overdue: impl Fn(&Overdue) -> Result<(), Failure>,
    ) -> Result<(), Failure> {
        let once = !self.repeats() && self.until.is_none();
        let mut left = if once { 1 } else { self.count.map_or(u64::MAX, NonZeroU64::get) };
        while left > 0 {
            match next(packets)? {
                Due::Overdue(silence) => overdue(&silence)?,
                Due::Packet(packet) => {
                    output::write(text(packet).as_bytes())?;
                    left -= 1;
                    if packets.is_last() {
                        break;
                    }
                }
            }
        }
        Ok(())
    }
}

/// Warns once of a time without packets, since each line is a packet.
#[expect(clippy::unnecessary_wraps, reason = "a table can fail to be written")]
fn warn(overdue: &Overdue) -> Result<(), Failure> {
    if overdue.is_news {
        output::warning(&overdue.to_string());
    }
    Ok(())
}

/// Current time.
#[cfg(not(test))]
fn now() -> Instant {
    Instant::now()
}
