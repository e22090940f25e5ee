//! `jaka export`: the status packets of a recording as a table for other programs.

mod columns;

use std::collections::BTreeSet;

use clap::{Args, ValueEnum};
use jaka_dynamic::Node;
use jaka_sync::recording::Recording;
use serde_json::{Map, Value};

use self::columns::{Columns, seconds};
use crate::builtin::of_status;
use crate::failure::Failure;
use crate::packets::fields::Field;
use crate::recordings::recorded;
use crate::recordings::recorded::{RecordedArgs, packets};
use crate::target::Lookup;
use crate::target::packs::SpecArgs;
use crate::terminal::output;
use crate::text::number::count;

const EXAMPLES: &str = "\
Examples:
  jaka export session.jsonl -o session.csv
  jaka export session.jsonl --fields joint_actual_position,tcp_speed --format jsonl | head -1";

/// Write the status packets of a recording as a table, with a line for each packet
///
/// Does not connect to a robot or wait: the times are those of the recording. The columns have the names of the fields,
/// with their units: `time (s)` since the start of the recording, `unix_time (s)`, `connection`, and then each part of
/// each field. A missing value is an empty cell, or null.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Export {
    #[command(flatten)]
    recorded: RecordedArgs,
    /// Output format
    #[arg(long, value_enum, default_value_t)]
    format: ExportFormat,
    /// Fields to write, such as `enabled,actual_position.x`; `all` for everything [default: as `jaka status`]
    ///
    /// Names are those of the Rust API or those of the wire, with indices as in `joint_actual_position[0]`.
    #[arg(long, short, value_name = "NAMES")]
    fields: Option<String>,
    #[command(flatten)]
    spec: SpecArgs,
}

/// Format of the packets.
#[derive(Debug, Clone, Copy, Default, ValueEnum)]
enum ExportFormat {
    /// A header, then one line per packet
    #[default]
    Csv,
    /// One JSON object per line, whose keys are the columns
    Jsonl,
}

impl Export {
    pub(crate) fn run(self) -> Result<(), Failure> {
        self.spec.load(Lookup::default())?.read_status();
        let fields = Field::named(self.fields.as_deref())?;
        let recording = recorded::read(&self.recorded.file)?;
        let columns = Columns::new(fields, &widest(&recording)?);
        let mut out = self.recorded.create()?;
        if let ExportFormat::Csv = self.format {
            out.write(&columns.header())?;
        }
        // Counts of the data missing in the table: messages that are not packets, and fields, each reported once.
        let (mut messages, mut unfit) = (0, BTreeSet::new());
        for packet in packets(&recording) {
            let Ok(status) = packet.status else {
                messages += 1;
                continue;
            };
            for error in status.unfit.iter().filter(|error| unfit.insert(error.field().to_owned())) {
                output::warning(&format!("{error}; it is left out"));
            }
            let unix_time = recording.header.started.saturating_add(packet.time);
            let first = [seconds(packet.time), seconds(unix_time), packet.connection.to_string()];
            out.write(&match self.format {
                ExportFormat::Csv => columns.csv(first, &status.tree()?),
                ExportFormat::Jsonl => columns.json(first, &status.tree()?),
            })?;
        }
        out.finish()?;
        if messages > 0 {
            let messages = count(messages, "message");
            output::warning(&format!("{messages} of the status port cannot be read as packets, and are left out"));
        }
        Ok(())
    }
}

/// Returns a packet with all parts of all packets.
fn widest(recording: &Recording) -> Result<Node<'static>, Failure> {
    let mut statuses = packets(recording).filter_map(|packet| packet.status.ok());
    let widest: Result<_, Failure> = statuses
        .try_fold(Value::Object(Map::new()), |widest, status| Ok(columns::wider(widest, status.tree()?.found())));
    Ok(Node::status(of_status(), widest?))
}
