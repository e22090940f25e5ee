//! Orders of the handles, and progress of the run.

use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::Instant;

use crate::error::SessionEnd;

/// Orders of the handles, and progress of the run. No thread waits for another here.
#[derive(Debug)]
pub(super) struct Orders {
    /// The bits of a number from 0 to 1.
    scale: AtomicU64,
    is_paused: AtomicBool,
    /// True if a pause begins by a stop.
    pauses_by_stop: AtomicBool,
    is_stopped: AtomicBool,
    deadline: Option<Instant>,
    /// The bits of the trajectory time of the last set-point in seconds, and of the rate.
    time_s: AtomicU64,
    rate: AtomicU64,
    ended: OnceLock<SessionEnd>,
}

impl Orders {
    pub(super) fn new(scale: f64, deadline: Option<Instant>) -> Self {
        Self {
            scale: AtomicU64::new(scale.to_bits()),
            is_paused: AtomicBool::new(false),
            pauses_by_stop: AtomicBool::new(false),
            is_stopped: AtomicBool::new(false),
            deadline,
            time_s: AtomicU64::new(0),
            rate: AtomicU64::new(0),
            ended: OnceLock::new(),
        }
    }

    pub(super) fn set_scale(&self, scale: f64) {
        self.scale.store(scale.to_bits(), Ordering::SeqCst);
    }

    pub(super) fn pause(&self) {
        self.pauses_by_stop.store(false, Ordering::SeqCst);
        self.is_paused.store(true, Ordering::SeqCst);
    }

    pub(super) fn pause_by_stop(&self) {
        self.pauses_by_stop.store(true, Ordering::SeqCst);
        self.is_paused.store(true, Ordering::SeqCst);
    }

    pub(super) fn resume(&self) {
        self.is_paused.store(false, Ordering::SeqCst);
    }

    pub(super) fn stop(&self) {
        self.is_stopped.store(true, Ordering::SeqCst);
    }

    pub(super) fn is_stopped(&self) -> bool {
        self.is_stopped.load(Ordering::SeqCst)
    }

    pub(super) fn is_overdue(&self, now: Instant) -> bool {
        self.deadline.is_some_and(|deadline| now >= deadline)
    }

    /// True if a stop is requested.
    pub(super) fn is_to_brake(&self) -> bool {
        self.is_stopped() || self.is_paused.load(Ordering::SeqCst) && self.pauses_by_stop.load(Ordering::SeqCst)
    }

    /// Requested rate: 0 in a pause.
    pub(super) fn scale(&self) -> f64 {
        if self.is_paused.load(Ordering::SeqCst) { 0.0 } else { f64::from_bits(self.scale.load(Ordering::SeqCst)) }
    }

    pub(super) fn followed(&self, time_s: f64, rate: f64) {
        self.time_s.store(time_s.to_bits(), Ordering::SeqCst);
        self.rate.store(rate.to_bits(), Ordering::SeqCst);
    }

    /// The trajectory time of the last set-point, in seconds, and the rate.
    pub(super) fn progress(&self) -> (f64, f64) {
        let load = |bits: &AtomicU64| f64::from_bits(bits.load(Ordering::SeqCst));
        (load(&self.time_s), load(&self.rate))
    }

    /// Ends the run: no trajectory time passes any more. The first reason counts.
    pub(super) fn end(&self, end: SessionEnd) {
        self.rate.store(0.0_f64.to_bits(), Ordering::SeqCst);
        let _ = self.ended.set(end);
    }

    /// Reason why the run has ended, if it has.
    pub(super) fn ended(&self) -> Option<&SessionEnd> {
        self.ended.get()
    }
}
