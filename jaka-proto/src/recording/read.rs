//! How a recording is read, line by line.

use std::fmt;
use std::str;
use std::time::Duration;

use super::{Ending, Entry, Event, FORMAT, Header, Message, Port, Recording};
use crate::wire::{Decode, DecodeError, Reader};

impl Recording {
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
}

fn at_line<T>(index: usize, read: Result<T, DecodeError>) -> Result<T, RecordingError> {
    read.map_err(|source| RecordingError { line: index + 1, source })
}

fn text(line: &[u8]) -> Result<&str, DecodeError> {
    str::from_utf8(line).map_err(|_| DecodeError::unfit("UTF-8", &String::from_utf8_lossy(line)))
}

impl Header {
    /// Reads the first line of a recording, with or without its line feed.
    ///
    /// # Errors
    /// It is not a header, or one of another version of the format.
    pub fn read(line: &str) -> Result<Self, DecodeError> {
        let mut reader = Reader::new(line);
        let (mut format, mut started, mut software) = (None, None, None);
        reader.begin_object()?;
        while let Some(key) = reader.next_key()? {
            match &*key {
                "jaka_recording" => reader.field::<i64>("jaka_recording", &mut format)?,
                "started" => reader.field("started", &mut started)?,
                "software" => reader.field("software", &mut software)?,
                _ => reader.skip()?,
            }
        }
        reader.end()?;
        let format = required("jaka_recording", format)?;
        if format != i64::from(FORMAT) {
            let expected = format!("version {FORMAT} of the format");
            return Err(DecodeError::unfit(expected, &format.to_string()).in_field("jaka_recording"));
        }
        let Seconds(started) = required("started", started)?;
        Ok(Self { started, software: software.unwrap_or_default() })
    }
}

impl Entry {
    /// Reads a line after the first, with or without its line feed.
    ///
    /// # Errors
    /// It is not an entry.
    pub fn read(line: &str) -> Result<Self, DecodeError> {
        let mut reader = Reader::new(line);
        let mut keys = Keys::default();
        reader.begin_object()?;
        while let Some(key) = reader.next_key()? {
            keys.read(&key, &mut reader)?;
        }
        reader.end()?;
        let Seconds(time) = required("time", keys.time.take())?;
        let port = required("port", keys.port.take())?;
        let port = one_of("port", "`command` or `status`", &port, Port::ALL, Port::word)?;
        let connection = keys.connection.take().unwrap_or(1);
        let connection = u32::try_from(connection)
            .map_err(|_| DecodeError::unfit("a number", &connection.to_string()).in_field("connection"))?;
        Ok(Self { time, port, connection, event: keys.event()? })
    }
}

/// The keys of an entry, of whatever event.
#[derive(Debug, Default)]
struct Keys {
    time: Option<Seconds>,
    port: Option<String>,
    connection: Option<i64>,
    event: Option<String>,
    text: Option<String>,
    hex: Option<Hex>,
    address: Option<String>,
    by: Option<String>,
    why: Option<String>,
    count: Option<Count>,
}

impl Keys {
    fn read(&mut self, key: &str, reader: &mut Reader<'_>) -> Result<(), DecodeError> {
        match key {
            "time" => reader.field("time", &mut self.time),
            "port" => reader.field("port", &mut self.port),
            "connection" => reader.field("connection", &mut self.connection),
            "event" => reader.field("event", &mut self.event),
            "text" => reader.field("text", &mut self.text),
            "hex" => reader.field("hex", &mut self.hex),
            "address" => reader.field("address", &mut self.address),
            "by" => reader.field("by", &mut self.by),
            "why" => reader.field("why", &mut self.why),
            "count" => reader.field("count", &mut self.count),
            _ => reader.skip(),
        }
    }

    fn event(mut self) -> Result<Event, DecodeError> {
        match &*required("event", self.event.take())? {
            "connected" => Ok(Event::Connected { address: self.address.unwrap_or_default() }),
            "sent" => self.message().map(Event::Sent),
            "received" => self.message().map(Event::Received),
            "closed" => {
                let by = required("by", self.by)?;
                let by = one_of("by", "`client`, `controller` or `failure`", &by, Ending::ALL, Ending::word)?;
                Ok(Event::Closed { by, why: self.why.unwrap_or_default() })
            }
            "error" => Ok(Event::Error { text: required("text", self.text)? }),
            "dropped" => required("count", self.count).map(|Count(count)| Event::Dropped { count }),
            other => Err(DecodeError::unfit("an event of the format", other).in_field("event")),
        }
    }

    fn message(self) -> Result<Message, DecodeError> {
        match (self.text, self.hex) {
            (Some(text), _) => Ok(Message::new(text)),
            (None, Some(Hex(bytes))) => Ok(Message::new(bytes)),
            (None, None) => Err(DecodeError::missing("text", "text")),
        }
    }
}

fn required<T>(key: &'static str, value: Option<T>) -> Result<T, DecodeError> {
    value.ok_or_else(|| DecodeError::missing(key, key))
}

fn one_of<T: Copy, const N: usize>(
    field: &str,
    expected: &str,
    found: &str,
    all: [T; N],
    word: fn(T) -> &'static str,
) -> Result<T, DecodeError> {
    let value = all.into_iter().find(|value| word(*value) == found);
    value.ok_or_else(|| DecodeError::unfit(expected, found).in_field(field))
}

/// A time in seconds, to the microsecond.
#[derive(Debug)]
struct Seconds(Duration);

impl Decode for Seconds {
    fn decode(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let seconds = f64::decode(reader)?;
        let time = Duration::try_from_secs_f64(seconds)
            .map_err(|_| DecodeError::unfit("a time in seconds", &seconds.to_string()))?;
        let microseconds = time.subsec_nanos().saturating_add(500) / 1000;
        let whole = Duration::from_secs(time.as_secs()).checked_add(Duration::from_micros(microseconds.into()));
        whole.map(Self).ok_or_else(|| DecodeError::unfit("a time in seconds", &seconds.to_string()))
    }
}

/// A count, also one beyond what a whole number of the wire holds.
#[derive(Debug)]
struct Count(u64);

impl Decode for Count {
    fn decode(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let raw = reader.raw()?;
        raw.parse().map(Self).map_err(|_| DecodeError::unfit("a count", raw))
    }
}

/// Bytes, as two digits each.
#[derive(Debug)]
struct Hex(Vec<u8>);

impl Decode for Hex {
    fn decode(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let text = reader.text()?;
        let digit = |digit: u8| char::from(digit).to_digit(16).and_then(|digit| u8::try_from(digit).ok());
        let byte = |pair: &[u8]| match *pair {
            [high, low] => Some(digit(high)? << 4 | digit(low)?),
            _ => None,
        };
        let bytes: Option<_> = text.as_bytes().chunks(2).map(byte).collect();
        bytes.map(Self).ok_or_else(|| DecodeError::unfit("two hexadecimal digits for each byte", &text))
    }
}

/// A line of a recording that cannot be read.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct RecordingError {
    /// The number of the line, counted from 1.
    pub line: usize,
    /// What is wrong with it.
    pub source: DecodeError,
}

impl fmt::Display for RecordingError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {} of the recording cannot be read: {}", self.line, self.source)
    }
}

/// The text of what is wrong is this error's own.
impl std::error::Error for RecordingError {}
