//! How late cycles begin, in each way of waiting for them.

use std::time::Duration;

use jaka_sync::{Error, ErrorKind, ServoConfig};

use super::times::Times;
use crate::failure::{Failure, chain};

/// How long the thread spins before a cycle, where it does.
pub(super) const SPIN: Duration = Duration::from_micros(200);

/// The real-time priority of the thread, where it has one.
pub(super) const PRIORITY: u8 = 20;

/// How late cycles began.
#[derive(Debug)]
pub(super) struct Lateness {
    pub(super) usual: Waits,
    /// With a real-time priority, or why the system does not allow it.
    pub(super) realtime: Result<Waits, String>,
}

/// The two ways of waiting, with the same priority.
#[derive(Debug, Default)]
pub(super) struct Waits {
    pub(super) asleep: Times,
    pub(super) spinning: Times,
}

impl Lateness {
    /// Measures all ways, in turns of a second at most: then what else the machine does meets all of them.
    pub(super) fn measure(time: Duration) -> Result<Self, Failure> {
        let share = time / 4;
        let rounds = u32::try_from(share.as_secs()).unwrap_or(u32::MAX).max(1);
        let turn = share / rounds;
        let (usual, realtime) = (ServoConfig::new(), ServoConfig::new().realtime_priority(PRIORITY));
        let mut measured = Self { usual: Waits::default(), realtime: Ok(Waits::default()) };
        for _ in 0..rounds {
            measured.usual.turn(&usual, turn)?;
            let Ok(waits) = &mut measured.realtime else { continue };
            match waits.turn(&realtime, turn) {
                Err(error) if matches!(error.kind(), ErrorKind::RealtimePriority { .. }) => {
                    measured.realtime = Err(chain(&error));
                }
                turned => turned?,
            }
        }
        Ok(measured)
    }
}

impl Waits {
    fn turn(&mut self, config: &ServoConfig, time: Duration) -> Result<(), Error> {
        self.asleep.add(config.measure_lateness(time)?);
        self.spinning.add(config.clone().busy_wait(SPIN).measure_lateness(time)?);
        Ok(())
    }

    pub(super) fn count(&self) -> usize {
        self.asleep.count() + self.spinning.count()
    }

    /// How many cycles of both ways were late by so much.
    pub(super) fn at_least(&self, time: Duration) -> usize {
        self.asleep.at_least(time) + self.spinning.at_least(time)
    }
}
