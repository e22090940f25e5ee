//! Packets of a recording.

use std::sync::Arc;
use std::time::{Duration, Instant};

use jaka_clock::Clock;

use super::packet_writer::LEAST_PERIOD;
use crate::replay::{ReplaySession, Script, ScriptStep};

/// Packets of one connection of a recording, with their times.
#[derive(Debug)]
pub(crate) struct RecordedPackets {
    script: Arc<Script>,
    position: usize,
    began: Instant,
    last: Option<Instant>,
    period: Duration,
    time: Clock,
}

/// Next step on a connection.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum RecordedStep {
    Packet(Vec<u8>),
    End,
}

impl RecordedPackets {
    pub(crate) fn new(script: Arc<Script>, period: Duration, time: &Clock) -> Self {
        Self {
            script,
            position: 0,
            began: time.now(),
            last: None,
            period: period.max(LEAST_PERIOD),
            time: time.clone(),
        }
    }

    /// Returns the time at which the next step is due; `None` if it is unknown, or there is no step.
    pub(super) fn due(&self, session: &ReplaySession) -> Option<Instant> {
        let next = match self.last {
            Some(last) => last.checked_add(self.period)?,
            None => self.began,
        };
        match self.script.steps.get(self.position) {
            Some(ScriptStep::Send { at, .. } | ScriptStep::End { at, .. }) => {
                session.packet_due(&self.script, *at, self.began, next)
            }
            Some(ScriptStep::Expect { .. } | ScriptStep::Gap { .. }) => Some(self.began),
            // Repeats the last packet each period.
            None => self.script.last.as_ref().map(|_| next),
        }
    }

    /// Takes the step that is due; `None` if it sends nothing.
    pub(super) fn take(&mut self) -> Option<RecordedStep> {
        let step = self.script.steps.get(self.position);
        self.position += 1;
        let packet = match step {
            Some(ScriptStep::Send { bytes, .. }) => bytes.clone(),
            Some(ScriptStep::End { .. }) => return Some(RecordedStep::End),
            Some(ScriptStep::Expect { .. } | ScriptStep::Gap { .. }) => return None,
            None => self.script.last.as_ref()?.bytes().to_vec(),
        };
        self.last = Some(self.time.now());
        Some(RecordedStep::Packet(packet))
    }
}
