//! What can be wrong on the status port.

use std::time::Duration;

/// Something wrong with the packets of the status port, for all readers and until another fault is set.
///
/// [`Controller::status_fault`](crate::Controller::status_fault) sets it, and [`FaultPlan::status`] from the start. It
/// concerns the packets that come in time and those of [`Controller::publish`](crate::Controller::publish), and not the
/// bytes of [`Controller::send_status`](crate::Controller::send_status). What counts, counts for each reader by itself,
/// from when the fault is set or the reader connects.
///
/// [`FaultPlan::status`]: crate::FaultPlan::status
#[derive(Debug, Clone, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum StatusFault {
    /// Nothing: packets are as they should be. `none` in a script.
    #[default]
    None,
    /// Connections stay open, and no packet comes. `silent` in a script.
    Silent,
    /// Packets come with this period, in real time. `slow 2s` in a script.
    Slow(Duration),
    /// Each packet is written in pieces of so many bytes. `split 7` in a script.
    ///
    /// Each piece is a segment of its own; the reader's kernel may put them together again.
    Pieces(usize),
    /// Random bytes come before each packet, in the same write. `garbage 40 7` in a script.
    ///
    /// Braces and quotes among them hide the packets that follow from a reader who counts braces.
    Garbage {
        /// How many before each packet; at most 256 MiB.
        bytes: usize,
        /// The same seed gives each reader the same bytes, which differ from packet to packet.
        seed: u64,
    },
    /// Of each packet only so many bytes come. `cut 100` in a script.
    ///
    /// The next packet begins within the one before it, as the reader sees it.
    Cut(usize),
    /// These bytes come in place of each packet. `instead "joint_actual_position:(0, 0)\n"` in a script.
    Instead(Vec<u8>),
    /// The connection is closed after so many bytes of packets. `close-after 5000` in a script.
    ///
    /// So is that of each reader who connects anew, after as many. With 0 it is closed when the first packet is due.
    CloseAfter(usize),
}
