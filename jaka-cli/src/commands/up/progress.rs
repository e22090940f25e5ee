//! How far powering and enabling have come, as status packets show it.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use jaka_sync::status::RobotStatus;
use jaka_sync::{Robot, Subscription};

use crate::output;

/// How many packets may wait: none is needed but the newest.
const QUEUE: usize = 4;

/// Tells each step when it begins and when it is done: since when power is being switched on, if there is more to tell.
#[derive(Debug)]
pub(super) struct Progress(Arc<Mutex<Option<Instant>>>);

impl Progress {
    /// Tells the first step, and follows the packets for as long as the steps may take.
    pub(super) fn begin(robot: &Robot, patience: Duration) -> Self {
        let packets = robot.monitor().subscribe(QUEUE);
        let progress = Self(Arc::default());
        let Some(first) = robot.monitor().last_known_packet() else { return progress };
        match (first.status.emergency_stop, first.status.powered_on, first.status.enabled) {
            (Some(true), ..) => {}
            (_, Some(false), _) => {
                output::note("switching the power on");
                *progress.lock() = Some(Instant::now());
                let follower = Self(Arc::clone(&progress.0));
                thread::spawn(move || follower.follow(&packets, patience));
            }
            (_, _, Some(false)) => output::note("enabling the arm, which has power"),
            _ => {}
        }
        progress
    }

    /// Tells when the arm has power, if that is not told yet.
    pub(super) fn has_power(&self) {
        if let Some(since) = self.lock().take() {
            output::note(&format!("the arm has power, after {:.1} s; enabling it", since.elapsed().as_secs_f64()));
        }
    }

    /// There is nothing more to tell.
    pub(super) fn end(&self) {
        *self.lock() = None;
    }

    fn follow(&self, packets: &Subscription<RobotStatus>, patience: Duration) {
        while let Some(packet) = packets.next_packet_within(patience) {
            if packet.status.powered_on == Some(true) {
                return self.has_power();
            }
        }
    }

    fn lock(&self) -> MutexGuard<'_, Option<Instant>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
