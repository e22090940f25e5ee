//! Contents of a recording, read for a page.

mod calls;
mod happenings;
mod lateness;
mod packets;

use std::time::Duration;

use jaka_sync::recording::{Entry, Port, Recording};

pub(super) use self::calls::{Calls, CommandCount};
pub(super) use self::happenings::{Happening, HappeningKind};
pub(super) use self::lateness::SetPointLateness;
pub(super) use self::packets::{Packed, Packets};

/// Limit on drawn times, longer than any session.
const LONGEST_S: f64 = 1e9;

/// Recording, read for a page.
#[derive(Debug)]
pub(super) struct Session<'r> {
    pub(super) recording: &'r Recording,
    /// Time of the last entry, in seconds, and more than 0.
    pub(super) end: f64,
    pub(super) packets: Packets,
    pub(super) calls: Calls,
    pub(super) lateness: SetPointLateness,
    /// Events in the order of their times.
    pub(super) happenings: Vec<Happening>,
    /// Messages of the command port, in the order of their times.
    messages: Vec<&'r Entry>,
}

impl<'r> Session<'r> {
    pub(super) fn read(recording: &'r Recording) -> Self {
        let entries = &recording.entries;
        let end = entries.iter().map(|entry| entry.time).max().unwrap_or_default();
        let (packets, mut happenings) = Packets::read(recording);
        let (calls, failed) = Calls::read(recording);
        happenings.extend(failed);
        happenings.extend(entries.iter().filter_map(happenings::of_connection));
        happenings.sort_by_key(|happening| happening.time);
        let is_message = |entry: &&Entry| entry.port == Port::Command && entry.event.message().is_some();
        let mut messages: Vec<_> = entries.iter().filter(is_message).collect();
        messages.sort_by_key(|entry| entry.time);
        Self {
            recording,
            end: end.as_secs_f64().clamp(0.001, LONGEST_S),
            packets,
            calls,
            lateness: SetPointLateness::read(recording),
            happenings,
            messages,
        }
    }

    /// Returns the last messages of the command port up to a time, at most this many.
    pub(super) fn messages_before(&self, time: Duration, most: usize) -> &[&'r Entry] {
        let end = self.messages.partition_point(|message| message.time <= time);
        &self.messages[end.saturating_sub(most)..end]
    }
}

/// Returns a duration in milliseconds.
pub(super) fn milliseconds(time: Duration) -> f64 {
    time.as_secs_f64() * 1e3
}
