//! Recordings as input, and the files generated from them.

use std::fs::File;
use std::io::{self, Write, stdout};
use std::path::{Path, PathBuf};
use std::time::Duration;

use clap::Args;
use jaka_sync::Refusal;
use jaka_sync::proto::text::visible_json_line;
use jaka_sync::proto::wire::{Decode, DecodeError, Reader};
use jaka_sync::proto::{Envelope, framing};
use jaka_sync::recording::{Entry, Event, Message, Port, Recording};

use crate::failure::Failure;
use crate::packets::packed_status::PackedStatus;
use crate::terminal::output;

/// Options of a command that evaluates a recording.
#[derive(Debug, Args)]
pub(crate) struct RecordedArgs {
    /// Recording
    pub(crate) file: PathBuf,
    /// Write to this file instead of standard output
    #[arg(long, short, value_name = "FILE")]
    output: Option<PathBuf>,
}

impl RecordedArgs {
    /// Opens the output. Replaces an existing file, but never the recording itself.
    pub(crate) fn create(&self) -> Result<Output, Failure> {
        let Some(path) = &self.output else { return Ok(Output { path: None, to: Box::new(stdout().lock()) }) };
        if let (Ok(here), Ok(there)) = (path.canonicalize(), self.file.canonicalize())
            && here == there
        {
            return Err(Failure::Usage(format!("{} is the recording, which is not overwritten", path.display())));
        }
        let file = File::create(path).map_err(|error| Failure::unwritten(path, error))?;
        Ok(Output { path: Some(path.clone()), to: Box::new(io::BufWriter::new(file)) })
    }
}

/// File, or standard output.
pub(crate) struct Output {
    path: Option<PathBuf>,
    to: Box<dyn Write>,
}

impl Output {
    /// Writes text with invisible characters already made visible.
    pub(crate) fn write(&mut self, text: &str) -> Result<(), Failure> {
        self.to.write_all(text.as_bytes()).map_err(|error| self.failed(error))
    }

    /// Finishes the output, after writing all of it.
    pub(crate) fn finish(mut self) -> Result<(), Failure> {
        self.to.flush().map_err(|error| self.failed(error))
    }

    fn failed(&self, error: io::Error) -> Failure {
        match &self.path {
            Some(path) => Failure::unwritten(path, error),
            None => Failure::output(error),
        }
    }
}

/// Most bytes of a recording: 4 GiB, some days of both ports.
const LONGEST: u64 = 1 << 32;

/// Reads a recording. Accepts one with a truncated last line, as after a crash.
pub(crate) fn read(path: &Path) -> Result<Recording, Failure> {
    let file = jaka_spec::read_file(path, LONGEST);
    let file = file.map_err(|error| Failure::Usage(format!("cannot read {}: {error}", path.display())))?;
    let recording = Recording::read(&file).map_err(|error| Failure::Usage(format!("{}: {error}", path.display())))?;
    if let Some(error) = &recording.truncated {
        output::warning(&format!("{}: the file ends in the middle of a line: {error}", path.display()));
    }
    Ok(recording)
}

/// Message of the status port.
#[derive(Debug)]
pub(crate) struct RecordedPacket {
    /// Time of its arrival, from the start of the recording.
    pub(crate) time: Duration,
    /// Number of its connection.
    pub(crate) connection: u32,
    /// Packet, with values that do not fit the spec in its `unfit`; an error if the message is not a packet.
    pub(crate) status: Result<PackedStatus, DecodeError>,
}

/// Returns the messages of the status port, in the order of the recording.
pub(crate) fn packets(recording: &Recording) -> impl Iterator<Item = RecordedPacket> {
    let entries = recording.entries.iter().filter(|entry| entry.port == Port::Status);
    entries.filter_map(|entry| match &entry.event {
        Event::Received(message) => {
            Some(RecordedPacket { time: entry.time, connection: entry.connection, status: status(message.bytes()) })
        }
        _ => None,
    })
}

fn status(bytes: &[u8]) -> Result<PackedStatus, DecodeError> {
    let text = framing::text(bytes);
    let mut reader = Reader::new(&text);
    let mut status = PackedStatus::decode(&mut reader)?;
    reader.end()?;
    status.unfit.extend(reader.take_unfit());
    Ok(status)
}

/// Returns the command named in a message.
pub(crate) fn command_of(message: &Message) -> Option<String> {
    let text = framing::text(message.bytes());
    Envelope::read_odd(&text).ok()?.command.map(|name| name.trim().to_owned())
}

/// Returns the controller's refusal, if the reply is one.
pub(crate) fn refusal_of(reply: &Message) -> Option<Refusal> {
    Envelope::read_odd(&framing::text(reply.bytes())).ok()?.refusal()
}

/// Returns this many characters from the start of a message, in one line.
pub(crate) fn excerpt(message: &Message, most: usize) -> String {
    let text = message.to_string();
    let text = visible_json_line(&text);
    match text.char_indices().nth(most) {
        Some((end, _)) => format!("{}… ({} bytes)", &text[..end], message.bytes().len()),
        None => text.into_owned(),
    }
}

/// Returns the number of missing entries at this place.
pub(crate) fn missing(entry: &Entry) -> u64 {
    if let Event::Dropped { count } = entry.event { count } else { 0 }
}
