//! Measurements: lateness of cycles, for each kind of wait, and reply times of a robot.

use std::thread;
use std::time::{Duration, Instant};

use jaka_robot::{Error, ErrorKind, ServoConfig};

use crate::failure::{Failure, fact, verb};
use crate::target::Target;

/// Results of all measurements.
#[derive(Debug)]
pub(super) struct Measured {
    pub(super) lateness: Lateness,
    pub(super) round_trip: Option<RoundTrip>,
}

/// Spinning time of a thread before each cycle.
pub(super) const SPIN: Duration = Duration::from_micros(200);

/// Real-time priority of the thread, if it has one.
pub(super) const PRIORITY: u8 = 20;

/// Lateness of cycles.
#[derive(Debug)]
pub(super) struct Lateness {
    pub(super) usual: Waits,
    /// Lateness with a real-time priority, or the reason why the system does not allow it.
    pub(super) realtime: Result<Waits, String>,
}

/// Results of both kinds of wait, with the same priority.
#[derive(Debug, Default)]
pub(super) struct Waits {
    pub(super) asleep: Times,
    pub(super) spinning: Times,
}

impl Lateness {
    /// Measures all kinds, in turns of a second at most, so that other load on the machine affects all of them.
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
                    let hint = verb(error.remedy()).map(|hint| format!("; {hint}")).unwrap_or_default();
                    measured.realtime = Err(format!("{}{hint}", fact(error.kind(), &error)));
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

    /// Returns the number of cycles of both kinds that were late by this time or more.
    pub(super) fn at_least(&self, time: Duration) -> usize {
        self.asleep.at_least(time) + self.spinning.at_least(time)
    }
}

/// Reply times.
#[derive(Debug)]
pub(super) struct RoundTrip {
    pub(super) robot: String,
    pub(super) times: Times,
}

impl RoundTrip {
    /// Queries the joint positions, once in each cycle. Connects for the duration of the measurement.
    pub(super) fn measure(target: &Target, time: Duration) -> Result<Self, Failure> {
        let mut client = target.client()?;
        let (since, period) = (Instant::now(), ServoConfig::new().period());
        let (mut replies, mut times) = (Vec::new(), Times::default());
        loop {
            let sent = Instant::now();
            client.get_joint_pos()?;
            replies.push(sent.elapsed());
            if since.elapsed() >= time {
                times.add(replies);
                return Ok(Self { robot: target.title().to_owned(), times });
            }
            thread::sleep(period.saturating_sub(sent.elapsed()));
        }
    }
}

/// Times in ascending order.
#[derive(Debug, Default)]
pub(super) struct Times(Vec<Duration>);

impl Times {
    pub(super) fn add(&mut self, times: impl IntoIterator<Item = Duration>) {
        self.0.extend(times);
        self.0.sort_unstable();
    }

    pub(super) fn count(&self) -> usize {
        self.0.len()
    }

    /// Returns the time within which this many of a hundred are; zero if there are none.
    pub(super) fn within(&self, percent: usize) -> Duration {
        let place = (self.0.len() * percent).div_ceil(100).max(1) - 1;
        self.0.get(place).copied().unwrap_or_default()
    }

    /// Returns the number of times that are this long or longer.
    pub(super) fn at_least(&self, time: Duration) -> usize {
        self.0.len() - self.0.partition_point(|one| *one < time)
    }
}

/// Returns a time in microseconds.
pub(super) fn micros(time: Duration) -> f64 {
    time.as_secs_f64() * 1e6
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn percentiles_are_of_all_that_was_added() {
        let mut times = Times::default();
        assert_eq!((times.within(99), times.at_least(Duration::ZERO)), (Duration::ZERO, 0));
        times.add((51..=100).map(Duration::from_millis));
        times.add((1..=50).map(Duration::from_millis));
        let within = [50, 90, 99, 100].map(|percent| times.within(percent).as_millis());
        assert_eq!((times.count(), within), (100, [50, 90, 99, 100]));
        assert_eq!((times.at_least(Duration::from_millis(8)), times.at_least(Duration::from_millis(101))), (93, 0));
    }
}
