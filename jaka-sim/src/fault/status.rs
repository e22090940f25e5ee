//! Faults of the status port.

use std::time::Duration;

use super::garbage;
use super::kinds::kinds;

/// Counts of the packets and bytes sent to a reader since its fault was set.
#[derive(Debug, Default)]
pub(crate) struct Sent {
    /// Packets, including the present one.
    pub(crate) packets: u64,
    /// Bytes of the previous packets.
    pub(crate) bytes: usize,
}

/// Writes for one packet.
#[derive(Debug, Default)]
pub(crate) struct PacketWrites {
    /// Bytes of each write.
    pub(crate) pieces: Vec<Vec<u8>>,
    /// Whether the controller closes the connection after the writes.
    pub(crate) close: bool,
}

impl PacketWrites {
    fn one(bytes: impl Into<Vec<u8>>) -> Self {
        Self { pieces: vec![bytes.into()], close: false }
    }
}

kinds! {
    /// Fault of the packets of the status port, for all readers and until another fault is set.
    ///
    /// [`Controller::status_fault`](crate::Controller::status_fault) sets it, and [`FaultPlan::status`] from the start.
    /// It applies to the periodic packets and those of [`Controller::publish`](crate::Controller::publish), and not to
    /// the bytes of [`Controller::send_status`](crate::Controller::send_status). Each reader has its own counts, from
    /// the time at which the fault is set or the reader connects.
    ///
    /// [`FaultPlan::status`]: crate::FaultPlan::status
    #[derive(Debug, Clone, PartialEq, Eq, Default)]
    #[non_exhaustive]
    pub enum StatusFault("a fault of the status port", |_| "unknown fault of the status port");

    /// Returns the writes for a packet with this fault.
    pub(crate) fn writes(&self, packet: &[u8], sent: &Sent) -> PacketWrites;

    /// No fault: packets are correct. `none` in a script.
    #[default]
    None: "none" => PacketWrites::one(packet);

    /// Keeps connections open without packets. `silent` in a script.
    Silent: "silent" => PacketWrites::default();

    /// Sends packets with this period, in real time. `slow 2s` in a script.
    Slow(_period: Duration as time = Duration::from_millis(80)): "slow" => PacketWrites::one(packet);

    /// Writes each packet in pieces of this many bytes. `split 7` in a script.
    ///
    /// Each piece is a separate segment; the reader's kernel may merge them.
    Pieces(size: usize as count = 3): "split" => {
        PacketWrites { pieces: packet.chunks((*size).max(1)).map(<[u8]>::to_vec).collect(), close: false }
    };

    /// Sends random bytes before each packet, in the same write. `garbage 40 7` in a script.
    ///
    /// Braces and quotes among them hide later packets from a reader that counts braces.
    Garbage {
        /// Number of bytes before each packet; at most 256 MiB.
        bytes: usize as count = 300,
        /// Seed of the random bytes. Equal seeds give each reader equal bytes, which differ from packet to packet.
        seed: u64 as seed = 3,
    }: "garbage" => PacketWrites::one([&garbage(*bytes, seed.wrapping_add(sent.packets)), packet].concat());

    /// Sends only this many bytes of each packet. `cut 100` in a script.
    ///
    /// The reader sees the start of the next packet within the cut one.
    Cut(count: usize as count = 100): "cut" => PacketWrites::one(&packet[..packet.len().min(*count)]);

    /// Sends these bytes instead of each packet. `instead "joint_actual_position:(0, 0)\n"` in a script.
    Instead(bytes: Vec<u8> as bytes = b"{}".to_vec()): "instead" => PacketWrites::one(bytes.as_slice());

    /// Closes the connection after this many bytes of packets. `close-after 5000` in a script.
    ///
    /// The same applies to each reader that reconnects. With 0 the controller closes the connection when the first
    /// packet is due.
    CloseAfter(count: usize as count = 100): "close-after" => {
        let left = count.saturating_sub(sent.bytes);
        let part = &packet[..packet.len().min(left)];
        PacketWrites { pieces: vec![part.to_vec()], close: part.len() == left }
    };
}

impl StatusFault {
    /// Returns the period of packets, which is `usual` without a fault.
    pub(crate) fn period(&self, usual: Duration) -> Duration {
        if let Self::Slow(period) = self { *period } else { usual }
    }
}
