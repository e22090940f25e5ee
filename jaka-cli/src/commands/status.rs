//! `jaka status`: what the status packets of port 10000 say.

mod csv;
mod json;
mod packets;
mod table;

use std::num::NonZeroU64;
use std::time::Duration;

use clap::{Args, ValueEnum};
use jaka_sync::status::RobotStatus;
use jaka_sync::{Monitor, Reconnect, Snapshot};
use serde_json::Value;

use self::packets::{Packets, RawText};
use crate::failure::Failure;
use crate::fields::Field;
use crate::interrupt::end_on_interrupt;
use crate::output;
use crate::seconds::seconds;
use crate::target::RobotArgs;

/// The fields that are shown where none are asked for.
const USUAL: &str = "powered_on,enabled,in_position,protective_stop,emergency_stop,drag_status,task_mode,\
                     interpreter_state,rapid_rate,error_code,error_message,joint_actual_position,actual_position,\
                     tcp_speed,current_tool_id,current_user_frame_id";

/// Print the robot's state, once or again and again.
///
/// Only reads, from the status port, so that it disturbs no other program.
#[derive(Debug, Args)]
pub(crate) struct Status {
    #[command(flatten)]
    robot: RobotArgs,
    /// Print again each second, or each so many seconds; 0 for every packet
    #[arg(long, short, value_name = "SECONDS", num_args = 0..=1, default_missing_value = "1", value_parser = seconds)]
    watch: Option<Duration>,
    /// End after so many packets; without --watch one a second
    #[arg(long, short = 'n', value_name = "N")]
    count: Option<NonZeroU64>,
    /// What to print: names as in the Rust API or on the wire, such as
    /// `enabled,actual_position.x,joint_actual_position[0]`; `all` for everything [default: the usual]
    #[arg(long, short, value_name = "NAMES", conflicts_with = "raw")]
    fields: Option<String>,
    /// How to print it
    #[arg(long, value_enum, default_value_t, conflicts_with = "raw")]
    format: Format,
    /// Print each packet's own text
    #[arg(long)]
    raw: bool,
}

/// How packets are printed.
#[derive(Debug, Clone, Copy, Default, ValueEnum)]
enum Format {
    /// For people
    #[default]
    Table,
    /// A JSON object a line, with the Unix time at which the packet came, in seconds
    Json,
    /// A header, then a line a packet; arrays take a column for each element
    Csv,
}

impl Status {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let fields = self.fields()?;
        let target = self.robot.target()?;
        end_on_interrupt()?;
        if self.raw {
            let monitor: Monitor<RawText> = target.monitor(Reconnect::Never)?;
            return self.print(&monitor, |snapshot| format!("{}\n", snapshot.status.0));
        }
        let monitor: Monitor = target.monitor(Reconnect::Never)?;
        match self.format {
            Format::Table => {
                let table = table::Table::new(fields, self.repeats());
                self.print(&monitor, |packet| table.text(&json_of(packet)))
            }
            Format::Json => self.print(&monitor, |packet| json::line(&fields, packet, &json_of(packet))),
            Format::Csv => {
                let mut columns = csv::Columns::new(fields);
                self.print(&monitor, |packet| columns.lines(packet, &json_of(packet)))
            }
        }
    }

    fn fields(&self) -> Result<Vec<Field>, Failure> {
        let names = self.fields.as_deref().unwrap_or(USUAL);
        if names == "all" {
            return Ok(Field::all());
        }
        names.split(',').map(|name| Field::find(name).map_err(Failure::Usage)).collect()
    }

    fn repeats(&self) -> bool {
        self.watch.is_some() || self.count.is_some()
    }

    /// Prints packets, each as `text` has it, until there have been enough.
    fn print<S>(&self, monitor: &Monitor<S>, mut text: impl FnMut(&Snapshot<S>) -> String) -> Result<(), Failure>
    where
        S: jaka_sync::proto::wire::Decode + Send + Sync + 'static,
    {
        let period = self.watch.unwrap_or(Duration::from_secs(1));
        let most = if self.repeats() { self.count.map_or(u64::MAX, NonZeroU64::get) } else { 1 };
        let mut packets = Packets::new(monitor, period);
        for _ in 0..most {
            output::write(text(&*packets.next()?).as_bytes())?;
        }
        Ok(())
    }
}

/// A packet's JSON as the codec writes it, whatever form the controller used.
fn json_of(packet: &Snapshot<RobotStatus>) -> Value {
    serde_json::to_value(&packet.status).unwrap_or_default()
}
