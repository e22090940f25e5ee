//! Known values of an argument.

use std::io::Read;
use std::path::Path;

use clap::Arg;
use jaka_dynamic::Node;
use jaka_sim::{Firmware, Model};
use jaka_spec::words::first_sentence;
use jaka_sync::recording::Recording;

use super::Candidate;
use crate::packets::fields::Field;
use crate::recordings::recorded;
use crate::words::Words;
use crate::{builtin, target};

/// Number of bytes read from a recording for the fields of its packets.
const GLANCE: u64 = 1 << 20;

/// Returns the values of this argument; some depend on the rest of the line, or on the start of the word.
pub(super) fn of(line: &Words<'_>, arg: &Arg, current: &str) -> Vec<Candidate> {
    match arg.get_id().as_str() {
        "robot" => target::robots(line.value("config").map(Path::new))
            .into_iter()
            .map(|(name, address)| Candidate::new(name, address))
            .collect(),
        "model" | "sim" => {
            Model::published().iter().map(|model| Candidate::new(short(model.name()), model.name())).collect()
        }
        "firmware" => Firmware::ALL.iter().map(|firmware| Candidate::new(firmware.name(), "")).collect(),
        "fields" => after_others(current, ",", &fields(line)),
        "until" => after_others(current, "!&|()<>= ", &fields(line)),
        "list" => builtin::of_status()
            .topics
            .iter()
            .filter(|topic| !topic.commands.is_empty())
            .map(|topic| Candidate::new(&topic.name, &topic.title))
            .collect(),
        "axis" => axes(),
        "command" => {
            let commands = builtin::of_status().commands();
            commands.map(|command| Candidate::new(&command.wire, first_sentence(&command.doc).0)).collect()
        }
        _ => possible(arg),
    }
}

/// Returns the axes for a jog.
fn axes() -> Vec<Candidate> {
    let joints = (1..=6).map(|joint| Candidate::new(joint.to_string(), format!("joint {joint}, in deg")));
    let lines = ["x", "y", "z"].map(|axis| Candidate::new(axis, "axis of the selected user frame, in mm"));
    joints.chain(lines).collect()
}

fn possible(arg: &Arg) -> Vec<Candidate> {
    let values = arg.get_possible_values().into_iter().filter(|value| !value.is_hide_set());
    values.map(|value| Candidate::new(value.get_name(), super::summary(value.get_help()))).collect()
}

/// Returns a model as typed: `zu5`.
fn short(model: &str) -> String {
    model.replace(' ', "").to_lowercase()
}

/// Returns candidates for the part of a word after the last of these signs.
fn after_others(current: &str, signs: &str, all: &[Candidate]) -> Vec<Candidate> {
    let (before, _) = current.split_at(current.rfind(|c| signs.contains(c)).map_or(0, |at| at + 1));
    all.iter().map(|one| Candidate { word: format!("{before}{}", one.word), ..one.clone() }).collect()
}

/// Returns the fields of status packets; if the line names a recording, those of its first packets.
fn fields(line: &Words<'_>) -> Vec<Candidate> {
    let all = Field::all();
    let recorded = line.positionals.first().and_then(|file| first_packets(Path::new(&*file.word))).unwrap_or_default();
    let has = |field: &&Field| recorded.is_empty() || recorded.iter().any(|packet| field.value(packet).is_some());
    all.iter().filter(has).map(|field| Candidate::new(&field.name, field.unit().unwrap_or_default())).collect()
}

/// Returns the packets at the start of a recording.
fn first_packets(file: &Path) -> Option<Vec<Node<'static>>> {
    let mut text = Vec::new();
    jaka_spec::open_regular(file).ok()?.take(GLANCE).read_to_end(&mut text).ok()?;
    text.truncate(text.iter().rposition(|byte| *byte == b'\n')? + 1);
    let recording = Recording::read(&text).ok()?;
    Some(recorded::packets(&recording).filter_map(|packet| packet.status.ok()?.tree().ok()).collect())
}
