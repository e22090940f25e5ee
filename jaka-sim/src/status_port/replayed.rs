//! Packets from a recording.

use std::sync::Arc;
use std::time::Duration;

use super::outlet::LEAST_PERIOD;
use crate::replay::{Script, Stage, Step};

/// The packets of one connection of a recording, each with its time.
#[derive(Debug)]
pub(super) struct Packets {
    script: Arc<Script>,
    place: usize,
    number: u32,
    last: Duration,
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
        Self { script, place: 0, number: 0, last: Duration::ZERO, period: period.max(LEAST_PERIOD) }
    }

    /// What comes next, and how long after the beginning of the connection; `None` if nothing ever does.
    ///
    /// Behind the last packet it comes again each period, unless the controller has ended the connection.
    pub(super) fn next(&mut self, stage: &Stage) -> Option<(Duration, Turn)> {
        while let Some(step) = self.script.steps.get(self.place) {
            self.place += 1;
            let (turn, at) = match step {
                Step::Send { bytes, at } => (Turn::Packet(bytes.clone()), *at),
                Step::End { at, .. } => (Turn::End, *at),
                Step::Expect { .. } | Step::Gap { .. } => continue,
            };
            self.last = stage.packet_time(at, self.number, self.period);
            self.number += 1;
            return Some((self.last, turn));
        }
        let stays = self.script.last.as_ref()?;
        self.last = self.last.checked_add(self.period)?;
        Some((self.last, Turn::Packet(stays.bytes().to_vec())))
    }
}
