//! Writes status packets to a reader, with their fault.

use std::io::{self, ErrorKind};
use std::sync::Arc;
use std::time::Duration;

use crate::StatusFault;
use crate::fault::garbage;
use crate::link::Wire;

/// The least time between two packets.
pub(super) const LEAST_PERIOD: Duration = Duration::from_millis(1);

/// Writes packets to a reader, with their fault.
#[derive(Debug)]
pub(super) struct PacketWriter<'s> {
    wire: &'s Arc<Wire>,
    fault: StatusFault,
    /// Packets and bytes of them since the fault was set.
    packets: u64,
    bytes: usize,
}

/// The time between two packets, which is `usual` if nothing is wrong.
pub(super) fn period(fault: &StatusFault, usual: Duration) -> Duration {
    let period = if let StatusFault::Slow(period) = fault { *period } else { usual };
    period.max(LEAST_PERIOD)
}

impl<'s> PacketWriter<'s> {
    pub(super) fn new(wire: &'s Arc<Wire>, fault: StatusFault) -> Self {
        Self { wire, fault, packets: 0, bytes: 0 }
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
        self.packets = self.packets.wrapping_add(1);
        match self.fault {
            StatusFault::Silent => Ok(()),
            StatusFault::Pieces(size) => packet.chunks(size.max(1)).try_for_each(|piece| self.wire.send(piece)),
            StatusFault::Garbage { bytes, seed } => {
                let noise = garbage(bytes, seed.wrapping_add(self.packets));
                self.wire.send(&[&noise, packet].concat())
            }
            StatusFault::Cut(count) => self.wire.send(&packet[..packet.len().min(count)]),
            StatusFault::Instead(ref bytes) => self.wire.send(bytes),
            StatusFault::CloseAfter(count) => self.send_up_to(count, packet),
            StatusFault::None | StatusFault::Slow(_) => self.wire.send(packet),
        }
    }

    fn send_up_to(&mut self, count: usize, packet: &[u8]) -> io::Result<()> {
        let left = count.saturating_sub(self.bytes);
        let part = &packet[..packet.len().min(left)];
        self.wire.send(part)?;
        self.bytes += part.len();
        if self.bytes < count { Ok(()) } else { Err(io::Error::new(ErrorKind::ConnectionAborted, "closed by a fault")) }
    }
}
