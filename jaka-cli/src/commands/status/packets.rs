//! Packets at the requested rate.

use std::io::{Write, stderr};
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

use jaka_sync::{Error, ErrorKind, StatusStream};
use serde_json::Value;

use crate::failure::Failure;
use crate::packed_status::PackedStatus;

/// A packet, ready to be printed.
#[derive(Debug)]
pub(super) struct Packet {
    /// The Unix time at which it was read, in seconds.
    pub(super) time: f64,
    /// Its JSON as the codec writes it, whatever form the controller used.
    pub(super) json: Value,
}

/// Packets from a stream, one each period, or all of them if that is zero.
#[derive(Debug)]
pub(super) struct Packets {
    stream: StatusStream,
    period: Duration,
    due: Option<Instant>,
    /// Fields that were reported not to fit.
    told: Vec<String>,
}

impl Packets {
    pub(super) fn new(stream: StatusStream, period: Duration) -> Self {
        Self { stream, period, due: None, told: Vec::new() }
    }

    /// The next packet that is due.
    pub(super) fn next(&mut self) -> Result<Packet, Failure> {
        let status: PackedStatus = self.next_due(StatusStream::next_packet_as)?;
        self.tell_unfit(&status);
        let json =
            status.json().map_err(|error| Failure::local("the packet cannot be written as JSON", error.into()))?;
        Ok(Packet { time: unix_time(), json })
    }

    /// Reports each field that does not fit once: it is missing from what is printed.
    fn tell_unfit(&mut self, status: &PackedStatus) {
        for error in self.stream.unfit().iter().chain(&status.unfit) {
            if !self.told.iter().any(|told| told == error.field()) {
                self.told.push(error.field().to_owned());
                // If standard error cannot be written, the packet is still printed.
                writeln!(stderr(), "jaka: warning: {error}; it is left out").ok();
            }
        }
    }

    /// The text of the next packet that is due, even if it does not fit the spec.
    pub(super) fn next_text(&mut self) -> Result<String, Failure> {
        self.next_due(|stream| match stream.next_packet() {
            Err(error) if !matches!(error.kind(), ErrorKind::UnexpectedStatus { .. }) => Err(error),
            _ => Ok(()),
        })?;
        Ok(self.stream.packet_text().unwrap_or_default().to_owned())
    }

    /// Reads until a packet is due. Those before are read and dropped, so that none is old and the controller is not held up.
    fn next_due<T>(&mut self, read: impl Fn(&mut StatusStream) -> Result<T, Error>) -> Result<T, Error> {
        loop {
            let found = read(&mut self.stream)?;
            let now = Instant::now();
            if self.due.is_none_or(|due| now >= due) {
                // The times are multiples of the period, unless one was missed. A period that is too long to count never ends.
                let next = self.due.unwrap_or(now).checked_add(self.period);
                self.due = next.map(|next| next.max(now));
                return Ok(found);
            }
        }
    }
}

/// Now, to the millisecond.
fn unix_time() -> f64 {
    let time = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
    (time.as_secs_f64() * 1000.0).round() / 1000.0
}
