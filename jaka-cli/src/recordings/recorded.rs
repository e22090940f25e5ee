//! Recordings that are read, and the files that are made of them.

use std::fs::{self, File};
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

/// The options of a command that makes something of a recording.
#[derive(Debug, Args)]
pub(crate) struct RecordedArgs {
    /// The recording
    pub(crate) file: PathBuf,
    /// Write to this file instead of standard output
    #[arg(long, short, value_name = "FILE")]
    output: Option<PathBuf>,
}

impl RecordedArgs {
    /// Opens the output. A file that exists is replaced, but never the recording itself.
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

/// A file, or standard output.
pub(crate) struct Output {
    path: Option<PathBuf>,
    to: Box<dyn Write>,
}

impl Output {
    /// Writes text, whose invisible characters are visible by now.
    pub(crate) fn write(&mut self, text: &str) -> Result<(), Failure> {
        self.to.write_all(text.as_bytes()).map_err(|error| self.failed(error))
    }

    /// Ends it, with all of it written.
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

/// Reads a recording. One whose last line is cut off, as after a crash, is still used.
pub(crate) fn read(path: &Path) -> Result<Recording, Failure> {
    let file = fs::read(path);
    let file = file.map_err(|error| Failure::Usage(format!("cannot read {}: {error}", path.display())))?;
    let recording = Recording::read(&file).map_err(|error| Failure::Usage(format!("{}: {error}", path.display())))?;
    if let Some(error) = &recording.truncated {
        output::warning(&format!("{}: the file ends in the middle of a line: {error}", path.display()));
    }
    Ok(recording)
}

/// A message of the status port.
#[derive(Debug)]
pub(crate) struct RecordedPacket {
    /// Time of its arrival, counted from the start of the recording.
    pub(crate) time: Duration,
    /// The number of its connection.
    pub(crate) connection: u32,
    /// The packet; all that does not fit the spec is in its `unfit`. An error where it is not a packet.
    pub(crate) status: Result<PackedStatus, DecodeError>,
}

/// The messages of the status port, in the order of the recording.
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

/// The command that a message names.
pub(crate) fn command_of(message: &Message) -> Option<String> {
    let text = framing::text(message.bytes());
    Envelope::read_odd(&text).ok()?.command.map(|name| name.trim().to_owned())
}

/// The controller's refusal, if the reply is one.
pub(crate) fn refusal_of(reply: &Message) -> Option<Refusal> {
    Envelope::read_odd(&framing::text(reply.bytes())).ok()?.refusal()
}

/// The first so many characters of a message, in one line.
pub(crate) fn excerpt(message: &Message, most: usize) -> String {
    let text = message.to_string();
    let text = visible_json_line(&text);
    match text.char_indices().nth(most) {
        Some((end, _)) => format!("{}… ({} bytes)", &text[..end], message.bytes().len()),
        None => text.into_owned(),
    }
}

/// Number of entries that are missing at the place of this one.
pub(crate) fn missing(entry: &Entry) -> u64 {
    if let Event::Dropped { count } = entry.event { count } else { 0 }
}
