//! How a recording is read, line by line.

use std::borrow::Cow;
use std::collections::HashMap;
use std::collections::hash_map;
use std::fmt;
use std::str;
use std::time::Duration;

use super::{Ending, Entry, Event, FORMAT, Header, Message, MotionStep, Port, Recording};
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
        let line = Line::read(line)?;
        let format: i64 = line.required("jaka_recording")?;
        if format != i64::from(FORMAT) {
            let expected = format!("version {FORMAT} of the format");
            return Err(DecodeError::unfit(expected, &format.to_string()).in_field("jaka_recording"));
        }
        let Seconds(started) = line.required("started")?;
        Ok(Self { started, software: line.optional("software")?.unwrap_or_default() })
    }
}

impl Entry {
    /// Reads a line after the first, with or without its line feed.
    ///
    /// # Errors
    /// It is not an entry.
    pub fn read(line: &str) -> Result<Self, DecodeError> {
        let line = Line::read(line)?;
        let Seconds(time) = line.required("time")?;
        let port = line.one_of("port", "`command` or `status`", Port::ALL, Port::word)?;
        let connection = line.optional("connection")?.unwrap_or(1);
        let connection = u32::try_from(connection)
            .map_err(|_| DecodeError::unfit("a number", &connection.to_string()).in_field("connection"))?;
        Ok(Self { time, port, connection, event: line.event()? })
    }
}

/// The keys of a line, each with the text of its value.
struct Line<'l>(HashMap<Cow<'l, str>, &'l str>);

impl<'l> Line<'l> {
    fn read(line: &'l str) -> Result<Self, DecodeError> {
        let (mut reader, mut values) = (Reader::new(line), HashMap::new());
        reader.begin_object()?;
        while let Some(key) = reader.next_key()? {
            match values.entry(key) {
                hash_map::Entry::Vacant(place) => place.insert(reader.raw()?),
                hash_map::Entry::Occupied(taken) => return Err(DecodeError::repeated().in_field(taken.key())),
            };
        }
        reader.end()?;
        Ok(Self(values))
    }

    /// The value of a key. A null counts as absent.
    fn optional<T: Decode>(&self, key: &'static str) -> Result<Option<T>, DecodeError> {
        let value = self.0.get(key).filter(|value| **value != "null");
        value.map(|value| T::decode(&mut Reader::new(value)).map_err(|error| error.in_field(key))).transpose()
    }

    fn required<T: Decode>(&self, key: &'static str) -> Result<T, DecodeError> {
        self.optional(key)?.ok_or_else(|| DecodeError::missing(key, key))
    }

    fn one_of<T: Copy, const N: usize>(
        &self,
        key: &'static str,
        expected: &str,
        all: [T; N],
        word: fn(T) -> &'static str,
    ) -> Result<T, DecodeError> {
        let found: String = self.required(key)?;
        let value = all.into_iter().find(|value| word(*value) == found);
        value.ok_or_else(|| DecodeError::unfit(expected, &found).in_field(key))
    }

    fn event(&self) -> Result<Event, DecodeError> {
        match &*self.required::<String>("event")? {
            "connected" => Ok(Event::Connected { address: self.optional("address")?.unwrap_or_default() }),
            "sent" => self.message().map(Event::Sent),
            "received" => self.message().map(Event::Received),
            "closed" => {
                let by = self.one_of("by", "`client`, `controller` or `failure`", Ending::ALL, Ending::word)?;
                Ok(Event::Closed { by, why: self.optional("why")?.unwrap_or_default() })
            }
            "error" => Ok(Event::Error { text: self.required("text")? }),
            "motion" => {
                let expected = "`late`, `gap`, `done` or `failed`";
                let step = self.one_of("step", expected, MotionStep::ALL, MotionStep::word)?;
                Ok(Event::Motion { step, text: self.required("text")? })
            }
            "dropped" => self.required("count").map(|Count(count)| Event::Dropped { count }),
            other => Err(DecodeError::unfit("an event of the format", other).in_field("event")),
        }
    }

    fn message(&self) -> Result<Message, DecodeError> {
        match (self.optional::<String>("text")?, self.optional("hex")?) {
            (Some(text), _) => Ok(Message::new(text)),
            (None, Some(Hex(bytes))) => Ok(Message::new(bytes)),
            (None, None) => Err(DecodeError::missing("text", "text")),
        }
    }
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
