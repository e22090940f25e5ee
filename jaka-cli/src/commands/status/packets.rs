//! Packets at the requested rate.

use std::collections::BTreeSet;
use std::fmt;
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

use jaka_dynamic::Node;
use jaka_sync::{Config, Error, ErrorKind, StatusStream};

use super::now;
use super::until::Until;
use crate::failure::Failure;
use crate::packets::packed_status::PackedStatus;
use crate::terminal::output;
use crate::text::number::seconds;
use crate::text::utc;

/// Packet to be printed.
#[derive(Debug)]
pub(super) struct Packet {
    /// Unix time of its reading, in seconds.
    pub(super) time: f64,
    /// Packet by the spec, with packs.
    pub(super) tree: Node<'static>,
}

/// Item that is due for printing.
#[derive(Debug)]
pub(super) enum Due<T> {
    Packet(T),
    Overdue(Overdue),
}

/// Time without packets, after which the last packet is out of date.
#[derive(Debug)]
pub(super) struct Overdue {
    /// Unix time of the report, in seconds.
    pub(super) time: f64,
    /// Unix time at which the last packet was read, in seconds.
    since: f64,
    lasts: Duration,
    /// Whether this is the first report of this time without packets.
    pub(super) is_news: bool,
}

impl fmt::Display for Overdue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let since = utc::date_and_time(Duration::from_secs_f64(self.since));
        write!(f, "no status packet since {since}, for {:.1} s", self.lasts.as_secs_f64())
    }
}

/// Packets from a stream, one each period, or all of them if the period is zero; or the packet that meets a condition.
#[derive(Debug)]
pub(super) struct PacketSource {
    stream: StatusStream,
    /// Period of printed packets; `None` to print only the packet of the condition.
    period: Option<Duration>,
    until: Option<Until>,
    due: Option<Instant>,
    silence: Silence,
    /// Fields reported not to fit.
    told: BTreeSet<String>,
}

/// Time without packets, and its limits.
#[derive(Debug)]
struct Silence {
    /// Time at which the last packet was read, or the connection was opened.
    since: Instant,
    /// Unix time of the last packet, in seconds.
    last: Option<f64>,
    /// Whether it was reported.
    was_told: bool,
    /// Age from which a packet is out of date.
    stale_after: Duration,
    /// Timeout for a packet.
    patience: Duration,
}

impl PacketSource {
    /// Creates a source from a stream that waits for at most [`POLL`](super::until::POLL), connected with this config.
    pub(super) fn new(stream: StatusStream, config: &Config, period: Option<Duration>, until: Option<Until>) -> Self {
        let (stale_after, patience) = (config.get_stale_after(), config.get_reply_timeout());
        let silence = Silence { since: now(), last: None, was_told: false, stale_after, patience };
        Self { stream, period, until, due: None, silence, told: BTreeSet::new() }
    }

    /// Whether the last packet meets the condition.
    pub(super) fn is_last(&self) -> bool {
        self.until.as_ref().is_some_and(Until::is_met)
    }

    /// Returns the next packet that is due, or that meets the condition.
    pub(super) fn next(&mut self) -> Result<Due<Packet>, Failure> {
        loop {
            let status: PackedStatus = match self.stream.next_packet_as() {
                Err(error) => match self.nothing_came(error)? {
                    Some(overdue) => return Ok(Due::Overdue(overdue)),
                    None => continue,
                },
                Ok(status) => status,
            };
            self.came();
            let is_due = self.is_due();
            if !is_due && self.until.is_none() {
                continue;
            }
            self.tell_unfit(&status);
            let tree = status.tree()?;
            let may_be_old = self.stream.follows_silence();
            if let Some(until) = self.until.as_mut().filter(|_| !may_be_old) {
                until.packet(&tree)?;
            }
            if is_due || self.is_last() {
                return Ok(Due::Packet(Packet { time: unix_time(), tree }));
            }
        }
    }

    /// Reports each field that does not fit once: it is missing from the output.
    fn tell_unfit(&mut self, status: &PackedStatus) {
        let unfit = self.stream.unfit().iter().chain(&status.unfit);
        for error in unfit.filter(|error| self.told.insert(error.field().to_owned())) {
            output::warning(&format!("{error}; it is left out"));
        }
    }

    /// Returns the text of the next packet that is due, even if it does not fit the spec.
    pub(super) fn next_text(&mut self) -> Result<Due<String>, Failure> {
        loop {
            match self.stream.next_packet() {
                Err(error) if !matches!(error.kind(), ErrorKind::UnexpectedStatus { .. }) => {
                    if let Some(overdue) = self.nothing_came(error)? {
                        return Ok(Due::Overdue(overdue));
                    }
                }
                _ => {
                    self.came();
                    if self.is_due() {
                        return Ok(Due::Packet(self.stream.packet_text().unwrap_or_default().to_owned()));
                    }
                }
            }
        }
    }

    /// Records the arrival of a packet.
    fn came(&mut self) {
        let silence = &mut self.silence;
        let lasted = now().saturating_duration_since(silence.since);
        (silence.since, silence.last) = (now(), Some(unix_time()));
        if std::mem::take(&mut silence.was_told) && self.prints_all() {
            let lasted = lasted.as_secs_f64();
            output::warning(&format!(
                "status packets resumed after {lasted:.1} s; the first ones may be old, held back by the network"
            ));
        }
    }

    /// Handles a moment without packets. Returns an item if one is due because of it. Returns an error after the
    /// timeout.
    fn nothing_came(&mut self, error: Error) -> Result<Option<Overdue>, Failure> {
        let ErrorKind::StatusTimeout { address, .. } = error.kind() else { return Err(error.into()) };
        let lasts = now().saturating_duration_since(self.silence.since);
        if let Some(until) = self.until.as_ref().filter(|until| until.is_limited()) {
            until.check_time()?;
        } else if lasts >= self.silence.patience {
            let (address, after) = (address.clone(), self.silence.patience);
            return Err(Error::from(ErrorKind::StatusTimeout { address, after }).into());
        }
        let Some(since) = self.silence.last.filter(|_| lasts > self.silence.stale_after) else { return Ok(None) };
        let is_due = if self.prints_all() { !self.silence.was_told } else { self.tick() };
        let mut is_news = || !std::mem::replace(&mut self.silence.was_told, true);
        Ok(is_due.then(|| Overdue { time: unix_time(), since, lasts, is_news: is_news() }))
    }

    /// Whether the packet that has just come is due. Earlier ones are read and dropped, so that no printed packet is
    /// old and the controller is not delayed.
    fn is_due(&mut self) -> bool {
        (self.prints_all() || !self.stream.follows_silence()) && self.tick()
    }

    fn prints_all(&self) -> bool {
        self.period == Some(Duration::ZERO)
    }

    /// Whether an item is due now.
    fn tick(&mut self) -> bool {
        let (Some(period), now) = (self.period, now()) else { return false };
        let is_due = self.due.is_none_or(|due| now >= due);
        if is_due {
            // The times are multiples of the period, unless one was missed. A period beyond the range of times never
            // ends.
            let next = self.due.unwrap_or(now).checked_add(period);
            self.due = next.map(|next| next.max(now));
        }
        is_due
    }
}

/// Returns the present Unix time, to the millisecond.
fn unix_time() -> f64 {
    seconds(SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default())
}
