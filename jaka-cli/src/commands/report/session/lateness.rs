//! Lateness of set-points.

use std::collections::HashMap;
use std::time::Duration;

use jaka_sync::Request;
use jaka_sync::recording::{Event, Port, Recording};

use super::milliseconds;

/// Cycle of the controller (section 4.15 of the vendor's document).
const CYCLE: Duration = Duration::from_millis(8);
/// Bounds of the histogram, in ms.
const BOUNDS: [f64; 10] = [-4.0, -1.0, -0.25, 0.25, 1.0, 2.0, 4.0, 8.0, 16.0, 24.0];

/// Lateness of each set-point against its period after the previous one, in ms, in increasing order.
#[derive(Debug, Default)]
pub(in crate::commands::report) struct SetPointLateness(Vec<f64>);

impl SetPointLateness {
    pub(super) fn read(recording: &Recording) -> Self {
        let mut all = Vec::new();
        // Send time and period of the last set-point of each connection.
        let mut last: HashMap<u32, (Duration, Duration)> = HashMap::new();
        for entry in recording.entries.iter().filter(|entry| entry.port == Port::Command) {
            let sent = match &entry.event {
                Event::Sent(message) => message.text().and_then(|text| Request::read(text).ok()),
                // The number of set-points sent between two entries is unknown.
                Event::Connected { .. } | Event::Closed { .. } | Event::Dropped { .. } => {
                    last.remove(&entry.connection);
                    None
                }
                _ => None,
            };
            let step_count = match sent {
                Some(Request::ServoJ(set_point)) => set_point.step_count,
                Some(Request::ServoP(set_point)) => set_point.step_count,
                // Start or end of a session.
                Some(Request::SetServoMode(_)) => {
                    last.remove(&entry.connection);
                    continue;
                }
                _ => continue,
            };
            let cycles = step_count.and_then(|count| u32::try_from(count).ok()).unwrap_or(1);
            if let Some((before, period)) = last.insert(entry.connection, (entry.time, CYCLE.saturating_mul(cycles))) {
                all.push(milliseconds(entry.time) - milliseconds(before) - milliseconds(period));
            }
        }
        all.sort_by(f64::total_cmp);
        Self(all)
    }

    pub(in crate::commands::report) fn count(&self) -> usize {
        self.0.len()
    }

    /// Returns the number of set-points that were late by this many milliseconds or more.
    pub(in crate::commands::report) fn late_by(&self, ms: f64) -> usize {
        self.0.len() - self.0.partition_point(|late| *late < ms)
    }

    /// Returns the median, the 99th percentile and the maximum, in ms; `None` without set-points.
    pub(in crate::commands::report) fn figures(&self) -> Option<[f64; 3]> {
        let last = self.0.len().checked_sub(1)?;
        Some([self.0[last / 2], self.0[last - last / 100], self.0[last]])
    }

    /// Returns the number of set-points between each two bounds, with the bounds as text.
    pub(in crate::commands::report) fn bars(&self) -> Vec<(String, usize)> {
        let mut bars = Vec::new();
        let (mut before, mut begin) = (0, None);
        for bound in BOUNDS {
            let end = self.0.partition_point(|late| *late < bound);
            let label = begin.map_or_else(|| format!("below {bound}"), |begin: f64| format!("{begin} to {bound}"));
            bars.push((label.replace('-', "−"), end - before));
            (before, begin) = (end, Some(bound));
        }
        bars.push((format!("{} or more", BOUNDS[BOUNDS.len() - 1]), self.0.len() - before));
        bars
    }
}
