//! Writes status packets to a reader, with their fault.

use std::io::{self, ErrorKind};
use std::sync::Arc;
use std::time::Duration;

use crate::StatusFault;
use crate::fault::{PacketWrites, Sent};
use crate::link::Wire;

/// The least time between two packets.
pub(super) const LEAST_PERIOD: Duration = Duration::from_millis(1);

/// Writes packets to a reader, with their fault.
#[derive(Debug)]
pub(super) struct PacketWriter<'s> {
    wire: &'s Arc<Wire>,
    fault: StatusFault,
    /// Since the fault was set.
    sent: Sent,
}

/// The time between two packets, which is `usual` if nothing is wrong.
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

    /// Writes bytes as they are.
    pub(super) fn send(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.wire.send(bytes)
    }

    /// Writes a packet as its fault says. An error says that the connection ends.
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
