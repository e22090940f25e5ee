//! State from which the screen is drawn.

use std::time::Duration;

use jaka_sync::proto::text::visible;
use jaka_sync::status::RobotStatus;

use super::alarms::Alarms;
use crate::packets::value_rows::Row;

/// A packet that is older than this is out of date: several periods of any firmware.
pub(super) const STALE: Duration = Duration::from_millis(500);

/// State from which the screen is drawn. The drawing depends on nothing else, not even on a clock.
#[derive(Debug, Default)]
pub(crate) struct View {
    /// Title of the robot, for people.
    pub(super) title: String,
    /// The packet that is shown.
    pub(super) status: Option<RobotStatus>,
    /// Rows of the fields of it that packs add or change.
    pub(super) packed: Vec<Row>,
    /// Time since that packet came.
    pub(super) age: Option<Duration>,
    /// Reception of packets.
    pub(super) link: Link,
    /// Alarms, the newest first.
    pub(super) alarms: Alarms,
    /// The page that is shown.
    pub(super) page: Page,
    /// Number of lines by which the page is scrolled down.
    pub(super) scroll: u16,
    /// Whether the display is paused.
    pub(super) paused: bool,
    /// Whether the keys are explained.
    pub(super) help: bool,
}

impl View {
    /// Limits scrolling to the length of the page.
    pub(crate) fn scroll_at_most(&mut self, most: u16) {
        self.scroll = self.scroll.min(most);
    }

    /// A view of a robot of which nothing is known yet.
    pub(crate) fn new(title: &str) -> Self {
        Self { title: visible(title).into_owned(), ..Self::default() }
    }

    /// True if the packet that is shown is a current one.
    pub(super) fn is_fresh(&self) -> bool {
        !self.paused && self.age.is_some_and(|age| age <= STALE)
    }
}

/// Reception of packets.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Link {
    /// Packets a second, over the last seconds.
    pub(super) rate: Option<f64>,
    /// Mean deviation of the time between packets from the one before.
    pub(super) jitter: Option<Duration>,
    /// The longest time between two packets.
    pub(super) longest_gap: Option<Duration>,
    /// Packets that were skipped because a newer one had come.
    pub(super) skipped: u64,
    /// Packets that did not fit the spec, and bytes in which no packet could be found.
    pub(super) unfit: u64,
    /// Number of the monitor's reconnections.
    pub(super) reconnects: u64,
    /// Cause for which the connection has ended for good, if it has.
    pub(super) ended: Option<String>,
}

/// A page of the dashboard.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) enum Page {
    /// The most important values.
    #[default]
    Overview,
    /// All inputs and outputs.
    Io,
    /// All measurements.
    Measurements,
    /// The alarms.
    Alarms,
}

impl Page {
    /// All of them, in order.
    pub(super) const ALL: [Self; 4] = [Self::Overview, Self::Io, Self::Measurements, Self::Alarms];

    /// Its name.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Overview => "Overview",
            Self::Io => "I/O",
            Self::Measurements => "Measurements",
            Self::Alarms => "Alarms",
        }
    }

    /// The page this many after this one, from the last on to the first.
    pub(super) fn step(self, by: usize) -> Self {
        let at = Self::ALL.iter().position(|page| *page == self).unwrap_or_default();
        Self::ALL[(at + by) % Self::ALL.len()]
    }
}
