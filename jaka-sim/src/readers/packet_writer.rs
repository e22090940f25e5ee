//! Writer of status packets with a fault.

use std::io::{self, ErrorKind};
use std::sync::Arc;
use std::time::Duration;

use crate::StatusFault;
use crate::fault::{PacketWrites, Sent};
use crate::link::Wire;

/// Shortest period of packets.
pub(super) const LEAST_PERIOD: Duration = Duration::from_millis(1);

/// Writer of packets to a reader, with the present fault.
#[derive(Debug)]
pub(super) struct PacketWriter<'s> {
    wire: &'s Arc<Wire>,
    fault: StatusFault,
    /// Counts since the fault was set.
    sent: Sent,
}

/// Returns the period of packets, which is `usual` without a fault.
pub(super) fn period(fault: &StatusFault, usual: Duration) -> Duration {
    fault.period(usual).max(LEAST_PERIOD)
}

impl<'s> PacketWriter<'s> {
    pub(super) fn new(wire: &'s Arc<Wire>, fault: StatusFault) -> Self {
        Self { wire, fault, sent: Sent::default() }
    }

    pub(super) fn fault(&self) -> &StatusFault {
        &self.fault
    }

    /// Writes bytes unchanged.
    pub(super) fn send(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.wire.send(bytes)
    }

    /// Writes a packet with the present fault. An error means that the connection ends.
    pub(super) fn send_packet(&mut self, packet: &[u8]) -> io::Result<()> {
        self.sent.packets = self.sent.packets.wrapping_add(1);
        let PacketWrites { pieces, close } = self.fault.writes(packet, &self.sent);
        for piece in &pieces {
            self.wire.send(piece)?;
            self.sent.bytes += piece.len();
        }
        if close { Err(io::Error::new(ErrorKind::ConnectionAborted, "closed by a fault")) } else { Ok(()) }
    }
}
