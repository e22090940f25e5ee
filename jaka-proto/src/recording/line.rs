//! The keys of a line of a recording, and their values.

use std::borrow::Cow;
use std::collections::HashMap;
use std::collections::hash_map;
use std::time::Duration;

use super::{Ending, Event, Message, MotionStep};
use crate::wire::{Decode, DecodeError, Reader};

/// The keys of a line, each with the text of its value.
pub(super) struct Line<'l>(HashMap<Cow<'l, str>, &'l str>);

impl<'l> Line<'l> {
    /// Reads the keys and their values.
    pub(super) fn read(line: &'l str) -> Result<Self, DecodeError> {
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

    /// The text of a key's value. A null counts as absent.
    fn value(&self, key: &str) -> Option<&'l str> {
        self.0.get(key).copied().filter(|value| *value != "null")
    }

    /// The value of a key.
    pub(super) fn optional<T: Decode>(&self, key: &'static str) -> Result<Option<T>, DecodeError> {
        self.value(key).map(|value| T::decode(&mut Reader::new(value)).map_err(|error| error.in_field(key))).transpose()
    }

    /// The value of a key that must be there.
    pub(super) fn required<T: Decode>(&self, key: &'static str) -> Result<T, DecodeError> {
        self.optional(key)?.ok_or_else(|| DecodeError::missing(key, key))
    }

    /// The one of some values that a key names by its word.
    pub(super) fn one_of<T: Copy, const N: usize>(
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

    /// The event, by its name and keys.
    pub(super) fn event(&self) -> Result<Event, DecodeError> {
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
            "dropped" => self.count().map(|count| Event::Dropped { count }),
            other => Err(DecodeError::unfit("an event of the format", other).in_field("event")),
        }
    }

    fn message(&self) -> Result<Message, DecodeError> {
        match (self.optional::<String>("text")?, self.optional::<String>("hex")?) {
            (Some(text), _) => Ok(Message::new(text)),
            (None, Some(hex)) => {
                let unfit = || DecodeError::unfit("two hexadecimal digits for each byte", &hex).in_field("hex");
                bytes(&hex).map(Message::new).ok_or_else(unfit)
            }
            (None, None) => Err(DecodeError::missing("text", "text")),
        }
    }

    /// A time in seconds, to the microsecond.
    pub(super) fn seconds(&self, key: &'static str) -> Result<Duration, DecodeError> {
        let seconds: f64 = self.required(key)?;
        let unfit = || DecodeError::unfit("a time in seconds", &seconds.to_string()).in_field(key);
        let time = Duration::try_from_secs_f64(seconds).map_err(|_| unfit())?;
        let microseconds = time.subsec_nanos().saturating_add(500) / 1000;
        let whole = Duration::from_secs(time.as_secs()).checked_add(Duration::from_micros(microseconds.into()));
        whole.ok_or_else(unfit)
    }

    /// A count, also one beyond what a whole number of the wire holds.
    fn count(&self) -> Result<u64, DecodeError> {
        let found = self.value("count").ok_or_else(|| DecodeError::missing("count", "count"))?;
        found.parse().map_err(|_| DecodeError::unfit("a count", found).in_field("count"))
    }
}

/// The bytes that two hexadecimal digits each stand for.
fn bytes(text: &str) -> Option<Vec<u8>> {
    let digit = |digit: u8| char::from(digit).to_digit(16).and_then(|digit| u8::try_from(digit).ok());
    let byte = |pair: &[u8]| match *pair {
        [high, low] => Some(digit(high)? << 4 | digit(low)?),
        _ => None,
    };
    text.as_bytes().chunks(2).map(byte).collect()
}
