//! Packets at the requested rate.

use std::collections::BTreeSet;
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

use jaka_sync::{ErrorKind, StatusStream};
use serde_json::Value;

use super::until::Until;
use crate::failure::Failure;
use crate::output;
use crate::packed_status::PackedStatus;

/// A packet, ready to be printed.
#[derive(Debug)]
pub(super) struct Packet {
    /// The Unix time at which it was read, in seconds.
    pub(super) time: f64,
    /// Its JSON as the codec writes it, whatever form the controller used.
    pub(super) json: Value,
}

/// Packets from a stream, one each period, or all of them if that is zero; or the one that shows what is waited for.
#[derive(Debug)]
pub(super) struct Packets {
    stream: StatusStream,
    /// None if only the one is wanted that is waited for.
    period: Option<Duration>,
    until: Option<Until>,
    due: Option<Instant>,
    /// Fields that were reported not to fit.
    told: BTreeSet<String>,
}

impl Packets {
    pub(super) fn new(stream: StatusStream, period: Option<Duration>, until: Option<Until>) -> Self {
        Self { stream, period, until, due: None, told: BTreeSet::new() }
    }

    /// True if the last packet shows what is waited for.
    pub(super) fn is_last(&self) -> bool {
        self.until.as_ref().is_some_and(Until::is_met)
    }

    /// The next packet that is due, or that shows what is waited for.
    pub(super) fn next(&mut self) -> Result<Packet, Failure> {
        loop {
            let status: PackedStatus = match self.stream.next_packet_as() {
                Err(error) if self.until.as_ref().is_some_and(|until| until.outlasts(&error)) => {
                    self.until.as_ref().map_or(Ok(()), Until::check_time)?;
                    continue;
                }
                read => read?,
            };
            let is_due = self.is_due();
            if !is_due && self.until.is_none() {
                continue;
            }
            self.tell_unfit(&status);
            let json = status.json()?;
            if let Some(until) = &mut self.until {
                until.packet(&json)?;
            }
            if is_due || self.is_last() {
                return Ok(Packet { time: unix_time(), json });
            }
        }
    }

    /// Reports each field that does not fit once: it is missing from what is printed.
    fn tell_unfit(&mut self, status: &PackedStatus) {
        let unfit = self.stream.unfit().iter().chain(&status.unfit);
        for error in unfit.filter(|error| self.told.insert(error.field().to_owned())) {
            output::warning(&format!("{error}; it is left out"));
        }
    }

    /// The text of the next packet that is due, even if it does not fit the spec.
    pub(super) fn next_text(&mut self) -> Result<String, Failure> {
        loop {
            match self.stream.next_packet() {
                Err(error) if !matches!(error.kind(), ErrorKind::UnexpectedStatus { .. }) => return Err(error.into()),
                _ if self.is_due() => return Ok(self.stream.packet_text().unwrap_or_default().to_owned()),
                _ => {}
            }
        }
    }

    /// Whether the packet that has just come is due. Those before are read and dropped, so that none is old and the controller is not held up.
    fn is_due(&mut self) -> bool {
        let (Some(period), now) = (self.period, Instant::now()) else { return false };
        let is_due = self.due.is_none_or(|due| now >= due);
        if is_due {
            // The times are multiples of the period, unless one was missed. A period that is too long to count never ends.
            let next = self.due.unwrap_or(now).checked_add(period);
            self.due = next.map(|next| next.max(now));
        }
        is_due
    }
}

/// Now, to the millisecond.
fn unix_time() -> f64 {
    let time = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
    (time.as_secs_f64() * 1000.0).round() / 1000.0
}
