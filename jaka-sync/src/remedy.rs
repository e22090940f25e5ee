//! Remedies for errors of connections.

use std::fmt;

jaka_proto::worded! {
    /// Remedy for an [`Error`](crate::Error) of a connection or a [`StatusProblem`](crate::StatusProblem). A program
    /// with its own wording matches on it.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    pub enum Remedy {
        /// Nothing is known to help.
        None => "",
        /// Check the address, the network, and that the controller is on.
        CheckAddress => "check the address, the network, and that the controller is on",
        /// Check the network, and that the controller is on.
        CheckNetwork => "check the network, and that the controller is on",
        /// Check the address, that the controller is on, and that no other client occupies its command port, which
        /// serves one.
        FreeSeat =>
            "check the address, that the controller is on, and that no other client, such as the vendor's app, is connected to the command port",
        /// Check that the address belongs to the status port, and that the controller has started.
        CheckStatusPort => "check that this is the status port, 10000, and that the controller has started",
        /// Connect to the status port again.
        ConnectStatusAgain => "connect again, or set `Config::reconnect`",
        /// Wait for status packets.
        WaitForPackets => "wait for more status packets",
        /// Try again in a moment.
        TryAgain => "try again in a moment",
    }
}

impl Remedy {
    /// Appends the remedy to a fact.
    pub(crate) fn append(self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self == Self::None { Ok(()) } else { write!(f, "; {self}") }
    }
}
