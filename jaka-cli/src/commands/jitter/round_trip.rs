//! How long a robot's replies take.

use std::thread;
use std::time::{Duration, Instant};

use jaka_sync::ServoConfig;

use super::times::Times;
use crate::failure::Failure;
use crate::target::Target;

/// How long replies took.
#[derive(Debug)]
pub(super) struct RoundTrip {
    pub(super) robot: String,
    pub(super) times: Times,
}

impl RoundTrip {
    /// Asks where the joints are, once in each cycle. Connects for as long as that takes.
    pub(super) fn measure(target: &Target, time: Duration) -> Result<Self, Failure> {
        let mut client = target.client()?;
        let (since, period) = (Instant::now(), ServoConfig::new().period());
        let mut times = Vec::new();
        loop {
            let sent = Instant::now();
            client.get_joint_pos()?;
            times.push(sent.elapsed());
            if since.elapsed() >= time {
                let mut sorted = Times::default();
                sorted.add(times);
                return Ok(Self { robot: target.title().to_owned(), times: sorted });
            }
            thread::sleep(period.saturating_sub(sent.elapsed()));
        }
    }
}
