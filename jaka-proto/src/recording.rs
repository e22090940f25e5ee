//! Recordings of sessions: a file format of JSON lines. No I/O: the caller reads and writes the file.
//!
//! # The format
//!
//! A recording is UTF-8 text with a JSON object on each line. Each line ends with a line feed, and there are no empty
//! lines. Keys that a reader does not know are skipped. The first line is the header:
//!
//! ```json
//! {"jaka_recording":1,"started":1763726000.123456,"software":"jaka-sync 0.1.0"}
//! ```
//!
//! | key | meaning |
//! |---|---|
//! | `jaka_recording` | version of the format: 1 |
//! | `started` | when the recording began, in seconds since 1970-01-01 00:00 UTC |
//! | `software` | what wrote it, with its version |
//!
//! Every other line is an entry:
//!
//! ```json
//! {"time":0.000412,"port":"command","connection":1,"event":"connected","address":"10.5.5.100:10001"}
//! {"time":0.000593,"port":"command","connection":1,"event":"sent","text":"{\"cmdName\":\"get_version\"}"}
//! {"time":0.002190,"port":"command","connection":1,"event":"received","hex":"7bff7d"}
//! ```
//!
//! | key | meaning |
//! |---|---|
//! | `time` | seconds since `started`, with six digits after the point |
//! | `port` | `command` or `status` |
//! | `connection` | number of the connection, counted from 1 over both ports; 1 if absent |
//! | `event` | what happened: see below |
//!
//! | event | its keys |
//! |---|---|
//! | `connected` | `address`: address and port of the controller |
//! | `sent` | `text` or `hex`: a message to the controller |
//! | `received` | `text` or `hex`: a message of the controller, or bytes that are not one |
//! | `closed` | `by`: `client`, `controller` or `failure`; `why`: in words |
//! | `error` | `text`: an error that was reported to the program, as text |
//! | `motion` | `step`: `late`, `gap`, `done` or `failed`; `text`: in words, of the program that moves the arm |
//! | `dropped` | `count`: how many entries of this connection are missing here, since the file could not be written as fast |
//!
//! A recording has the exact messages: as the string `text` if they are UTF-8, otherwise as `hex`, two hexadecimal
//! digits for each byte. It lacks white space between messages, and bytes that the program never read. The entries of a
//! connection are in the order in which the program sent or read them; a message's time is the time of its arrival,
//! which may be earlier than the previous entry's.

mod answers;
mod line;

use std::time::Duration;
use std::{fmt, str};

pub use self::answers::{Answer, Answered};
use self::line::Line;
use crate::wire::{DecodeError, Writer};

/// The version of the format that this crate writes and reads.
pub const FORMAT: u32 = 1;

/// A recording that has been read.
///
/// ```
/// use jaka_proto::recording::{Event, Recording};
///
/// let file = r#"{"jaka_recording":1,"started":1763726000.5,"software":"by hand"}
/// {"time":0.001,"port":"command","event":"connected","address":"10.5.5.100:10001"}
/// {"time":0.002,"port":"command","event":"sent","text":"{\"cmdName\":\"power_on\"}"}
/// "#;
/// let recording = Recording::read(file.as_bytes())?;
/// let Event::Sent(message) = &recording.entries[1].event else { panic!("it is a message") };
/// assert_eq!(message.text(), Some(r#"{"cmdName":"power_on"}"#));
/// # Ok::<(), jaka_proto::recording::RecordingError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Recording {
    /// The first line.
    pub header: Header,
    /// All others, in the order of the file.
    pub entries: Vec<Entry>,
    /// Error in the last line, if the file ends within that line, as after a crash. The line is not an entry.
    pub truncated: Option<RecordingError>,
}

/// The first line of a recording.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Header {
    /// Start of the recording, counted from 1970-01-01 00:00 UTC, in whole microseconds.
    pub started: Duration,
    /// Software that wrote the recording, with its version, such as `jaka-sync 0.1.0`.
    pub software: String,
}

/// One line of a recording.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Entry {
    /// Time of the event, counted from the start of the recording, in whole microseconds.
    pub time: Duration,
    /// The port of the connection.
    pub port: Port,
    /// The number of the connection, counted from 1 over both ports.
    pub connection: u32,
    /// Event on the connection.
    pub event: Event,
}

/// A port of a controller.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Port {
    /// Port that takes commands, usually 10001.
    Command,
    /// Port that sends status packets, usually 10000.
    Status,
}

/// Event on a connection.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Event {
    /// The connection was made.
    Connected {
        /// Address and port of the controller.
        address: String,
    },
    /// The program sent a message.
    Sent(Message),
    /// A message of the controller came, or bytes that are not one.
    Received(Message),
    /// The connection ended.
    Closed {
        /// Party that ended it.
        by: Ending,
        /// Reason, in words.
        why: String,
    },
    /// A call failed, or no connection could be made.
    Error {
        /// The error that was reported to the program.
        text: String,
    },
    /// Something happened to a motion of the program.
    Motion {
        /// Kind of happening.
        step: MotionStep,
        /// In words.
        text: String,
    },
    /// Entries of this connection are missing here, since the file could not be written as fast.
    Dropped {
        /// Number of missing entries.
        count: u64,
    },
}

/// Happening to a motion of the program.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum MotionStep {
    /// A set-point went out a period late or more.
    Late,
    /// A set-point was late by three periods or more: the controller had none when several were due.
    Gap,
    /// The motion ended as it was to.
    Done,
    /// The motion ended otherwise.
    Failed,
}

/// Party that ended a connection.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Ending {
    /// The program, or the client because of a received message.
    Client,
    /// The controller.
    Controller,
    /// The network: the connection was reset, or the controller no longer there.
    Failure,
}

/// A message as on the wire, with any bytes.
///
/// Displays text as it is; of bytes that are no UTF-8, printable ASCII as it is and every other byte as `\xNN`.
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Message(Vec<u8>);

/// A line of a recording that cannot be read.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct RecordingError {
    /// The number of the line, counted from 1.
    pub line: usize,
    /// Error in the line.
    pub source: DecodeError,
}

impl Recording {
    /// A recording of these entries.
    pub fn new(header: Header, entries: Vec<Entry>) -> Self {
        Self { header, entries, truncated: None }
    }

    /// Reads a file's bytes.
    ///
    /// A last line that is cut off, without a line feed, is reported by [`truncated`](Self::truncated).
    ///
    /// # Errors
    /// The first line that is neither a header nor an entry.
    pub fn read(file: &[u8]) -> Result<Self, RecordingError> {
        let mut lines = file.split_inclusive(|byte| *byte == b'\n').enumerate();
        let (_, first) = lines.next().unwrap_or_default();
        let header = at_line(0, text(first).and_then(Header::read))?;
        let mut recording = Self::new(header, Vec::new());
        for (index, line) in lines {
            match at_line(index, text(line).and_then(Entry::read)) {
                Ok(entry) => recording.entries.push(entry),
                Err(error) if !line.ends_with(b"\n") => recording.truncated = Some(error),
                Err(error) => return Err(error),
            }
        }
        Ok(recording)
    }

    /// The requests of all command connections, in their order, each with the reply that belongs to it.
    ///
    /// Replies that belong to no request, and messages after which replies can no longer be told apart, are left out.
    pub fn answers(&self) -> Vec<Answered> {
        answers::answers(self)
    }

    /// Writes all lines.
    pub fn write(&self, out: &mut Writer) {
        self.header.write(out);
        self.entries.iter().for_each(|entry| entry.write(out));
    }
}

impl Header {
    /// The header of a recording that began then, counted from 1970-01-01 00:00 UTC.
    pub fn new(started: Duration, software: impl Into<String>) -> Self {
        Self { started: whole_microseconds(started), software: software.into() }
    }

    /// Reads the first line of a recording, with or without its line feed.
    ///
    /// # Errors
    /// It is not a header, or one of another version of the format.
    pub fn read(line: &str) -> Result<Self, DecodeError> {
        let line = Line::read(line)?;
        let format: i64 = line.required("jaka_recording")?;
        if format != i64::from(FORMAT) {
            let expected = format!("version {FORMAT} of the format");
            return Err(DecodeError::unfit(expected, &format.to_string()).in_field("jaka_recording"));
        }
        let started = line.seconds("started")?;
        Ok(Self { started, software: line.optional("software")?.unwrap_or_default() })
    }

    /// Writes the line, with its line feed.
    pub fn write(&self, out: &mut Writer) {
        out.raw("{\"jaka_recording\":");
        out.int(FORMAT.into());
        out.raw(",\"started\":");
        seconds(self.started, out);
        out.raw(",\"software\":");
        out.text(&self.software);
        out.raw("}\n");
    }
}

impl Entry {
    /// An event on a connection, this long after the start of the recording.
    pub fn new(time: Duration, port: Port, connection: u32, event: Event) -> Self {
        Self { time: whole_microseconds(time), port, connection, event }
    }

    /// Reads a line after the first, with or without its line feed.
    ///
    /// # Errors
    /// It is not an entry.
    pub fn read(line: &str) -> Result<Self, DecodeError> {
        let line = Line::read(line)?;
        let time = line.seconds("time")?;
        let port = line.one_of("port", "`command` or `status`", Port::ALL, Port::word)?;
        let connection = line.optional("connection")?.unwrap_or(1);
        let connection = u32::try_from(connection)
            .map_err(|_| DecodeError::unfit("a number", &connection.to_string()).in_field("connection"))?;
        Ok(Self { time, port, connection, event: line.event()? })
    }

    /// Writes the line, with its line feed.
    pub fn write(&self, out: &mut Writer) {
        out.raw("{\"time\":");
        seconds(self.time, out);
        out.raw(",\"port\":");
        out.text(self.port.word());
        out.raw(",\"connection\":");
        out.int(self.connection.into());
        out.raw(",\"event\":");
        out.text(self.event.word());
        self.event.write_fields(out);
        out.raw("}\n");
    }
}

impl Port {
    /// Both ports.
    pub const ALL: [Self; 2] = [Self::Command, Self::Status];

    /// Its name in a recording: `command` or `status`.
    pub fn word(self) -> &'static str {
        match self {
            Self::Command => "command",
            Self::Status => "status",
        }
    }
}

/// Its [`word`](Port::word).
impl fmt::Display for Port {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.word())
    }
}

impl Event {
    /// The message, of either direction, if it is one.
    pub fn message(&self) -> Option<&Message> {
        match self {
            Self::Sent(message) | Self::Received(message) => Some(message),
            _ => None,
        }
    }

    /// Its name in a recording, such as `sent`.
    pub fn word(&self) -> &'static str {
        match self {
            Self::Connected { .. } => "connected",
            Self::Sent(_) => "sent",
            Self::Received(_) => "received",
            Self::Closed { .. } => "closed",
            Self::Error { .. } => "error",
            Self::Motion { .. } => "motion",
            Self::Dropped { .. } => "dropped",
        }
    }

    fn write_fields(&self, out: &mut Writer) {
        match self {
            Self::Connected { address } => field("address", address, out),
            Self::Sent(message) | Self::Received(message) => write_message(message, out),
            Self::Closed { by, why } => {
                field("by", by.word(), out);
                field("why", why, out);
            }
            Self::Error { text } => field("text", text, out),
            Self::Motion { step, text } => {
                field("step", step.word(), out);
                field("text", text, out);
            }
            Self::Dropped { count } => {
                out.raw(",\"count\":");
                out.raw(&count.to_string());
            }
        }
    }
}

impl MotionStep {
    const ALL: [Self; 4] = [Self::Late, Self::Gap, Self::Done, Self::Failed];

    /// Its name in a recording, such as `late`.
    pub fn word(self) -> &'static str {
        match self {
            Self::Late => "late",
            Self::Gap => "gap",
            Self::Done => "done",
            Self::Failed => "failed",
        }
    }
}

impl Ending {
    const ALL: [Self; 3] = [Self::Client, Self::Controller, Self::Failure];

    /// Its name in a recording: `client`, `controller` or `failure`.
    pub fn word(self) -> &'static str {
        match self {
            Self::Client => "client",
            Self::Controller => "controller",
            Self::Failure => "failure",
        }
    }
}

impl Message {
    /// A message of these bytes.
    pub fn new(bytes: impl Into<Vec<u8>>) -> Self {
        Self(bytes.into())
    }

    /// The bytes.
    pub fn bytes(&self) -> &[u8] {
        &self.0
    }

    /// The text; `None` if the bytes are no UTF-8.
    pub fn text(&self) -> Option<&str> {
        str::from_utf8(&self.0).ok()
    }
}

impl fmt::Display for Message {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(text) = self.text() {
            return f.write_str(text);
        }
        self.0.iter().try_for_each(|&byte| match byte {
            b' '..=b'~' => write!(f, "{}", char::from(byte)),
            _ => write!(f, "\\x{byte:02x}"),
        })
    }
}

impl fmt::Debug for Message {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Message({self})")
    }
}

impl fmt::Display for RecordingError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {} of the recording cannot be read: {}", self.line, self.source)
    }
}

/// Has no source: its text includes the text of the field `source`.
impl std::error::Error for RecordingError {}

/// Rounds down to whole microseconds, the resolution of a recording, so that a time reads back as it was written.
fn whole_microseconds(time: Duration) -> Duration {
    Duration::new(time.as_secs(), time.subsec_micros() * 1000)
}

fn at_line<T>(index: usize, read: Result<T, DecodeError>) -> Result<T, RecordingError> {
    read.map_err(|source| RecordingError { line: index + 1, source })
}

fn text(line: &[u8]) -> Result<&str, DecodeError> {
    str::from_utf8(line).map_err(|_| DecodeError::unfit("UTF-8", &String::from_utf8_lossy(line)))
}

fn write_message(message: &Message, out: &mut Writer) {
    if let Some(text) = message.text() {
        return field("text", text, out);
    }
    out.raw(",\"hex\":\"");
    message.bytes().iter().for_each(|byte| out.raw(&format!("{byte:02x}")));
    out.raw("\"");
}

fn field(key: &str, value: &str, out: &mut Writer) {
    out.comma();
    out.text(key);
    out.raw(":");
    out.text(value);
}

fn seconds(time: Duration, out: &mut Writer) {
    out.raw(&format!("{}.{:06}", time.as_secs(), time.subsec_micros()));
}

#[cfg(test)]
mod tests;
