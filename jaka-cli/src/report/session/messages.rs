//! The messages of the command port, to see what came before a moment.

use std::time::Duration;

use jaka_sync::recording::{Event, Message, Port, Recording};

/// The messages of the command port, in the order of their times.
#[derive(Debug)]
pub(in crate::report) struct Messages<'r>(Vec<RecordedMessage<'r>>);

/// A message of the command port.
#[derive(Debug)]
pub(in crate::report) struct RecordedMessage<'r> {
    pub(in crate::report) time: Duration,
    /// `->` to the controller, `<-` from it.
    pub(in crate::report) arrow: &'static str,
    pub(in crate::report) message: &'r Message,
}

impl<'r> Messages<'r> {
    pub(super) fn read(recording: &'r Recording) -> Self {
        let entries = recording.entries.iter().filter(|entry| entry.port == Port::Command);
        let messages = entries.filter_map(|entry| {
            let (arrow, message) = match &entry.event {
                Event::Sent(message) => ("->", message),
                Event::Received(message) => ("<-", message),
                _ => return None,
            };
            Some(RecordedMessage { time: entry.time, arrow, message })
        });
        let mut messages: Vec<_> = messages.collect();
        messages.sort_by_key(|message| message.time);
        Self(messages)
    }

    /// The last messages up to a time, at most so many.
    pub(in crate::report) fn before(&self, time: Duration, most: usize) -> &[RecordedMessage<'r>] {
        let end = self.0.partition_point(|message| message.time <= time);
        &self.0[end.saturating_sub(most)..end]
    }
}
