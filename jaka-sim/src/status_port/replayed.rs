//! Packets from a recording.

use std::sync::Arc;
use std::time::{Duration, Instant};

use super::outlet::LEAST_PERIOD;
use crate::replay::{Script, Stage, Step};

/// The packets of one connection of a recording, each with its time.
#[derive(Debug)]
pub(super) struct Packets {
    script: Arc<Script>,
    place: usize,
    began: Instant,
    last: Option<Instant>,
    period: Duration,
}

/// What comes next on a connection.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Turn {
    Packet(Vec<u8>),
    End,
}

impl Packets {
    pub(super) fn new(script: Arc<Script>, period: Duration) -> Self {
        Self { script, place: 0, began: Instant::now(), last: None, period: period.max(LEAST_PERIOD) }
    }

    /// When the next turn is due; `None` where that is not known yet, or there is none.
    pub(super) fn due(&self, stage: &Stage) -> Option<Instant> {
        let next = match self.last {
            Some(last) => last.checked_add(self.period)?,
            None => self.began,
        };
        match self.script.steps.get(self.place) {
            Some(Step::Send { at, .. } | Step::End { at, .. }) => stage.packet_due(&self.script, *at, self.began, next),
            Some(Step::Expect { .. } | Step::Gap { .. }) => Some(self.began),
            // Behind the last packet it comes again each period.
            None => self.script.last.as_ref().map(|_| next),
        }
    }

    /// Takes the turn that is due; `None` if there is nothing to do in it.
    pub(super) fn take(&mut self) -> Option<Turn> {
        let step = self.script.steps.get(self.place);
        self.place += 1;
        let packet = match step {
            Some(Step::Send { bytes, .. }) => bytes.clone(),
            Some(Step::End { .. }) => return Some(Turn::End),
            Some(Step::Expect { .. } | Step::Gap { .. }) => return None,
            None => self.script.last.as_ref()?.bytes().to_vec(),
        };
        self.last = Some(Instant::now());
        Some(Turn::Packet(packet))
    }
}
