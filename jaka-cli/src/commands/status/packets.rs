//! Packets at the pace that is asked for.

use std::sync::Arc;
use std::thread;
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

use jaka_sync::proto::wire::{Decode, DecodeError, Reader};
use jaka_sync::{Error, Monitor, Snapshot, Subscription};

/// Some seconds of packets of the fastest firmware: standard output may be slow for so long.
const CAPACITY: usize = 1000;

/// A packet's own text.
#[derive(Debug)]
pub(super) struct RawText(pub(super) String);

impl Decode for RawText {
    fn decode(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        Ok(Self(reader.raw()?.to_owned()))
    }
}

/// Packets from a monitor, one each period, or all of them if that is zero.
#[derive(Debug)]
pub(super) struct Packets<'m, S> {
    monitor: &'m Monitor<S>,
    queue: Subscription<S>,
    period: Duration,
    due: Option<Instant>,
}

impl<'m, S: Decode + Send + Sync + 'static> Packets<'m, S> {
    pub(super) fn new(monitor: &'m Monitor<S>, period: Duration) -> Self {
        Self { monitor, queue: monitor.subscribe(CAPACITY), period, due: None }
    }

    /// The next packet that is due. None is old: with a period, it comes after that has passed.
    pub(super) fn next(&mut self) -> Result<Arc<Snapshot<S>>, Error> {
        if self.period.is_zero() {
            return self.queued();
        }
        if let Some(due) = self.due {
            thread::sleep(due.saturating_duration_since(Instant::now()));
        }
        let packet = self.monitor.next()?;
        // A period that is too long to count ends never.
        let due = self.due.unwrap_or(packet.received).checked_add(self.period);
        self.due = due.map(|due| due.max(packet.received));
        Ok(packet)
    }

    /// The next packet that has not been taken from the queue.
    fn queued(&self) -> Result<Arc<Snapshot<S>>, Error> {
        loop {
            if let Some(packet) = self.queue.try_next() {
                return Ok(packet);
            }
            // Each packet is in the queue before the monitor tells of it; also those before the connection ended.
            if let Err(error) = self.monitor.next() {
                return self.queue.try_next().ok_or(error);
            }
        }
    }
}

/// The Unix time at which a packet came, in seconds.
pub(super) fn unix_time<S>(packet: &Snapshot<S>) -> f64 {
    let came = SystemTime::now().checked_sub(packet.age()).unwrap_or(UNIX_EPOCH);
    let time = came.duration_since(UNIX_EPOCH).unwrap_or_default();
    (time.as_secs_f64() * 1000.0).round() / 1000.0
}
