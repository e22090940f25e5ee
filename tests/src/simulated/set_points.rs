//! A proxy to a command port that takes part in a simulated time, and sees the set-points on the wire.

use std::net::SocketAddr;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use jaka_proto::framing::Framer;
use jaka_sim::SimulatedClock;
use serde_json::Value;

use super::forwarded::forwarded;

/// A proxy to a command port for one client. It knows nothing of who makes the set-points.
#[derive(Debug)]
pub struct SetPoints {
    address: SocketAddr,
    seen: Arc<Mutex<SetPointsSeen>>,
}

/// Counts and times of the set-points that the proxy has seen. Its size does not grow.
#[derive(Debug, Clone, Default)]
pub struct SetPointsSeen {
    /// Number of set-points.
    pub count: u64,
    /// Shortest time from one set-point to the next.
    pub shortest: Option<Duration>,
    /// Longest time from one set-point to the next.
    pub longest: Option<Duration>,
    /// Number of set-points that differ from the expected one of the same number from 0.
    pub unexpected: u64,
    last: Option<Duration>,
}

impl SetPoints {
    /// Begins to listen, for one client of this controller. `is_expected` judges the joint positions of each set-point,
    /// by its number from 0.
    ///
    /// # Panics
    /// Loopback has no free port.
    pub fn watch(
        clock: &SimulatedClock,
        controller: SocketAddr,
        is_expected: impl Fn(u64, [f64; 6]) -> bool + Send + 'static,
    ) -> Self {
        let (now, seen) = (clock.clone(), Arc::<Mutex<SetPointsSeen>>::default());
        let (theirs, mut framer) = (Arc::clone(&seen), Framer::new(1 << 16));
        let see = move |bytes: &mut Vec<u8>| see(&mut framer, bytes, &mut lock(&theirs), now.elapsed(), &is_expected);
        let address = forwarded(clock, controller, see, |_| ());
        Self { address, seen }
    }

    /// Address on which the proxy listens.
    pub fn address(&self) -> SocketAddr {
        self.address
    }

    /// Set-points seen so far.
    pub fn seen(&self) -> SetPointsSeen {
        lock(&self.seen).clone()
    }
}

fn lock(seen: &Mutex<SetPointsSeen>) -> std::sync::MutexGuard<'_, SetPointsSeen> {
    seen.lock().unwrap_or_else(PoisonError::into_inner)
}

fn see(
    framer: &mut Framer,
    bytes: &[u8],
    seen: &mut SetPointsSeen,
    now: Duration,
    is_expected: impl Fn(u64, [f64; 6]) -> bool,
) {
    let mut rest = bytes;
    while !rest.is_empty() {
        let space = framer.spare();
        let count = space.len().min(rest.len());
        space[..count].copy_from_slice(&rest[..count]);
        framer.filled(count);
        rest = &rest[count..];
        while let Some(frame) = framer.next_frame().expect("requests are whole") {
            let request: Value = serde_json::from_slice(frame).expect("requests are JSON");
            if request["cmdName"] == "servo_j" {
                let joints = std::array::from_fn(|joint| request["jointPosition"][joint].as_f64().expect("a number"));
                seen.unexpected += u64::from(!is_expected(seen.count, joints));
                seen.set_point(now);
            }
        }
    }
}

impl SetPointsSeen {
    fn set_point(&mut self, now: Duration) {
        self.count += 1;
        if let Some(last) = self.last.replace(now) {
            let gap = now.saturating_sub(last);
            self.shortest = Some(self.shortest.map_or(gap, |shortest| shortest.min(gap)));
            self.longest = Some(self.longest.map_or(gap, |longest| longest.max(gap)));
        }
    }
}
