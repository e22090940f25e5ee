//! Status of an arm, from the packets of its status port.

use std::sync::Arc;
use std::time::Duration;

use jaka_proto::wire::DecodeError;

use super::trouble::{self, Stop};
use crate::{Disconnect, Error, ErrorKind, Snapshot, StatusProblem};

/// Newest packet, in the built-in type, and the state of the port since.
#[derive(Debug)]
pub(super) struct Status {
    newest: Option<Arc<Snapshot>>,
    /// Reason why the newest packet could not be decoded, until one can.
    unreadable: Option<DecodeError>,
    is_reconnecting: bool,
    ended: Option<Arc<Disconnect>>,
    address: String,
    stale_after: Duration,
}

impl Status {
    /// Status of a port at this address; packets older than this time are stale.
    pub(super) fn new(address: String, stale_after: Duration) -> Self {
        Self { newest: None, unreadable: None, is_reconnecting: false, ended: None, address, stale_after }
    }

    /// Takes a packet from before, unless one has come meanwhile.
    pub(super) fn begin(&mut self, packet: Arc<Snapshot>) {
        self.newest.get_or_insert(packet);
    }

    /// Takes a packet, and returns the previous one, so that the caller drops it without a lock.
    pub(super) fn take(&mut self, packet: Arc<Snapshot>) -> Option<Arc<Snapshot>> {
        (self.unreadable, self.is_reconnecting) = (None, false);
        self.newest.replace(packet)
    }

    /// Takes the reason why the newest packet cannot be decoded.
    pub(super) fn take_unreadable(&mut self, source: DecodeError) {
        self.unreadable = Some(source);
    }

    /// Takes note of a connection that is being made again.
    pub(super) fn take_reconnecting(&mut self) {
        self.is_reconnecting = true;
    }

    /// Takes the cause of the end of the port.
    pub(super) fn take_end(&mut self, cause: Arc<Disconnect>) {
        self.ended = Some(cause);
    }

    pub(super) fn address(&self) -> &str {
        &self.address
    }

    /// Newest packet, which may be old.
    pub(super) fn newest(&self) -> Option<&Arc<Snapshot>> {
        self.newest.as_ref()
    }

    /// Cause of the end of the port, if it has ended.
    pub(super) fn ended(&self) -> Option<&Arc<Disconnect>> {
        self.ended.as_ref()
    }

    /// Newest packet, if the port is connected and the packet is fresh. Its age is that of this moment.
    pub(super) fn fresh_packet(&self) -> Result<&Arc<Snapshot>, StatusProblem> {
        if let Some(cause) = &self.ended {
            return Err(StatusProblem::Ended { cause: Arc::clone(cause) });
        }
        if self.is_reconnecting {
            return Err(StatusProblem::Reconnecting);
        }
        if let Some(source) = &self.unreadable {
            return Err(StatusProblem::Unreadable { source: source.clone() });
        }
        let newest = self.newest.as_ref().ok_or_else(|| StatusProblem::Missing { address: self.address.clone() })?;
        let age = newest.age();
        if age > self.stale_after {
            return Err(StatusProblem::Stale { age });
        }
        if newest.follows_silence { Err(StatusProblem::Resuming) } else { Ok(newest) }
    }

    /// Newest packet, as [`fresh_packet`](Self::fresh_packet), if it shows whether the arm is stopped.
    pub(super) fn fresh_status(&self) -> Result<&Arc<Snapshot>, StatusProblem> {
        let newest = self.fresh_packet()?;
        newest.unreadable().map_or(Ok(newest), |source| Err(StatusProblem::Unreadable { source }))
    }
}

/// Fails if a packet shows a stop or drag mode, also after the acknowledgement of earlier packets.
pub(super) fn check_stops(newest: &Snapshot) -> Result<(), Error> {
    trouble::stop(&newest.status).map_or(Ok(()), |stop| Err(not_ready(stop)))
}

/// Fails if a packet shows that no set-point may brake the arm.
pub(super) fn check_braking(newest: &Snapshot) -> Result<(), Error> {
    trouble::stop(&newest.status).filter(|stop| !stop.lets_brake()).map_or(Ok(()), |stop| Err(not_ready(stop)))
}

fn not_ready(stop: Stop) -> Error {
    ErrorKind::NotReady { occurrence: stop.cause().into() }.into()
}

/// Error for actions that need a known status.
pub(crate) fn unknown(problem: StatusProblem) -> Error {
    ErrorKind::StatusUnknown { problem }.into()
}
