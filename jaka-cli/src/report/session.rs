//! What a recording tells.

mod calls;
mod happenings;
mod lateness;
mod messages;
mod packets;

use std::time::Duration;

use jaka_sync::recording::{Event, Recording};

pub(super) use self::calls::{Calls, CommandCount};
pub(super) use self::happenings::{Happening, Kind};
pub(super) use self::lateness::Lateness;
pub(super) use self::messages::Messages;
pub(super) use self::packets::Packets;
use crate::utc;

/// Longer than any session: times are drawn up to this.
const LONGEST_S: f64 = 1e9;

/// A recording, read for a page.
#[derive(Debug)]
pub(super) struct Session<'r> {
    pub(super) software: &'r str,
    pub(super) started: String,
    /// The time of the last entry, in seconds, and more than 0.
    pub(super) end: f64,
    /// Where the file is cut off.
    pub(super) truncated: Option<String>,
    /// How many entries could not be written.
    pub(super) dropped: u64,
    pub(super) connections: Vec<&'r str>,
    pub(super) packets: Packets,
    pub(super) calls: Calls,
    pub(super) lateness: Lateness,
    /// In the order of their times.
    pub(super) happenings: Vec<Happening>,
    pub(super) messages: Messages<'r>,
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
        let dropped = entries.iter().map(|entry| if let Event::Dropped { count } = entry.event { count } else { 0 });
        let connections = entries.iter().filter_map(|entry| match &entry.event {
            Event::Connected { address } => Some(address.as_str()),
            _ => None,
        });
        Self {
            software: &recording.header.software,
            started: utc::date_and_time(recording.header.started),
            end: end.as_secs_f64().clamp(0.001, LONGEST_S),
            truncated: recording.truncated.as_ref().map(ToString::to_string),
            dropped: dropped.fold(0, u64::saturating_add),
            connections: connections.collect(),
            packets,
            calls,
            lateness: Lateness::read(recording),
            happenings,
            messages: Messages::read(recording),
        }
    }

    /// What went wrong.
    pub(super) fn problems(&self) -> impl Iterator<Item = &Happening> {
        self.happenings.iter().filter(|happening| happening.is_wrong)
    }
}

/// A duration in milliseconds.
pub(super) fn milliseconds(time: Duration) -> f64 {
    time.as_secs_f64() * 1e3
}
