//! Recordings of sessions: a file format of JSON lines. No I/O: the caller reads and writes the file.
//!
//! # The format
//!
//! A recording is UTF-8 text with a JSON object on each line. Each line ends with a line feed, and there are no empty lines.
//! Keys that a reader does not know are skipped. The first line is the header:
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
//! Messages are kept exactly: as the string `text` where they are UTF-8, otherwise as `hex`, two hexadecimal digits for each
//! byte. White space between messages is not kept, nor what the program never read. The entries of a connection are in the order in which the program took
//! part in them; a message's time is that of its arrival, which may be earlier than the entry before.

mod answers;
mod message;
mod read;
mod write;

use std::time::Duration;

pub use self::answers::{Answer, Answered};
pub use self::message::Message;
pub use self::read::RecordingError;

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
    /// What is wrong with the last line, if the file ends within it, as after a crash. It is not an entry.
    pub truncated: Option<RecordingError>,
}

impl Recording {
    /// A recording of these entries.
    pub fn new(header: Header, entries: Vec<Entry>) -> Self {
        Self { header, entries, truncated: None }
    }
}

/// The first line of a recording.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Header {
    /// When the recording began, counted from 1970-01-01 00:00 UTC, in whole microseconds.
    pub started: Duration,
    /// What wrote it, with its version, such as `jaka-sync 0.1.0`.
    pub software: String,
}

impl Header {
    /// The header of a recording that began then, counted from 1970-01-01 00:00 UTC.
    pub fn new(started: Duration, software: impl Into<String>) -> Self {
        Self { started: whole_microseconds(started), software: software.into() }
    }
}

/// One line of a recording.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Entry {
    /// When it happened, counted from the start of the recording, in whole microseconds.
    pub time: Duration,
    /// The port of the connection.
    pub port: Port,
    /// The number of the connection, counted from 1 over both ports.
    pub connection: u32,
    /// What happened.
    pub event: Event,
}

impl Entry {
    /// An event on a connection, this long after the start of the recording.
    pub fn new(time: Duration, port: Port, connection: u32, event: Event) -> Self {
        Self { time: whole_microseconds(time), port, connection, event }
    }
}

/// What a recording can hold, so that what is read is equal to what was written.
fn whole_microseconds(time: Duration) -> Duration {
    Duration::new(time.as_secs(), time.subsec_micros() * 1000)
}

/// A port of a controller.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Port {
    /// Where commands are taken, usually 10001.
    Command,
    /// Where status packets are sent, usually 10000.
    Status,
}

/// What happened on a connection.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Event {
    /// It was made.
    Connected {
        /// Address and port of the controller.
        address: String,
    },
    /// The program sent a message.
    Sent(Message),
    /// A message of the controller came, or bytes that are not one.
    Received(Message),
    /// It ended.
    Closed {
        /// Who ended it.
        by: Ending,
        /// Why, in words.
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
        /// How many.
        count: u64,
    },
}

impl Event {
    /// The message, of either direction, if it is one.
    pub fn message(&self) -> Option<&Message> {
        match self {
            Self::Sent(message) | Self::Received(message) => Some(message),
            _ => None,
        }
    }
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

/// Who ended a connection.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Ending {
    /// The program, or the client because of what it received.
    Client,
    /// The controller.
    Controller,
    /// The network: the connection was reset, or the controller no longer there.
    Failure,
}

#[cfg(test)]
mod tests;
