//! State from which the screen is drawn.

use std::time::Duration;

use jaka_sync::proto::text::visible;
use jaka_sync::status::RobotStatus;

use super::alarms::Alarms;
use crate::packets::value_rows::Row;

/// Age from which a packet is out of date: several periods of any firmware.
pub(super) const STALE: Duration = Duration::from_millis(500);

/// State from which the screen is drawn. The screen depends on nothing else, not even on a clock.
#[derive(Debug, Default)]
pub(crate) struct View {
    /// Title of the robot, for people.
    pub(super) title: String,
    /// Shown packet.
    pub(super) status: Option<RobotStatus>,
    /// Rows of its fields that packs add or change.
    pub(super) packed: Vec<Row>,
    /// Time since that packet came.
    pub(super) age: Option<Duration>,
    /// Reception of packets.
    pub(super) link: Link,
    /// Alarms, the newest first.
    pub(super) alarms: Alarms,
    /// Shown page.
    pub(super) page: Page,
    /// Scroll position of the page, in lines.
    pub(super) scroll: u16,
    /// Whether the display is paused.
    pub(super) paused: bool,
    /// Whether the help with the keys is shown.
    pub(super) help: bool,
}

impl View {
    /// Limits scrolling to the length of the page.
    pub(crate) fn scroll_at_most(&mut self, most: u16) {
        self.scroll = self.scroll.min(most);
    }

    /// Creates a view of a robot without any data yet.
    pub(crate) fn new(title: &str) -> Self {
        Self { title: visible(title).into_owned(), ..Self::default() }
    }

    /// Whether the shown packet is current.
    pub(super) fn is_fresh(&self) -> bool {
        !self.paused && self.age.is_some_and(|age| age <= STALE)
    }
}

/// Reception of packets.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Link {
    /// Packets a second, over the last seconds.
    pub(super) rate: Option<f64>,
    /// Mean change of the time between packets.
    pub(super) jitter: Option<Duration>,
    /// Longest time between two packets.
    pub(super) longest_gap: Option<Duration>,
    /// Number of packets skipped because a newer one had come.
    pub(super) skipped: u64,
    /// Number of packets that did not fit the spec, and of bytes outside packets.
    pub(super) unfit: u64,
    /// Number of the monitor's reconnections.
    pub(super) reconnects: u64,
    /// Cause of the final end of the connection, if it has ended.
    pub(super) ended: Option<String>,
}

/// Page of the dashboard.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) enum Page {
    /// The most important values.
    #[default]
    Overview,
    /// All inputs and outputs.
    Io,
    /// All measurements.
    Measurements,
    /// Alarms.
    Alarms,
}

impl Page {
    /// All pages, in order.
    pub(super) const ALL: [Self; 4] = [Self::Overview, Self::Io, Self::Measurements, Self::Alarms];

    /// Returns its name.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Overview => "Overview",
            Self::Io => "I/O",
            Self::Measurements => "Measurements",
            Self::Alarms => "Alarms",
        }
    }

    /// Returns the page this many after this one, wrapping from the last to the first.
    pub(super) fn step(self, by: usize) -> Self {
        let at = Self::ALL.iter().position(|page| *page == self).unwrap_or_default();
        Self::ALL[(at + by) % Self::ALL.len()]
    }
}
