//! Unknown states of a robot.

use std::error::Error as StdError;
use std::sync::Arc;
use std::time::Duration;

use jaka_proto::wire::DecodeError;

use crate::{Disconnect, Remedy};

jaka_proto::worded! {
    /// Reason why the state of a robot is unknown.
    #[derive(Debug, Clone)]
    #[non_exhaustive]
    pub enum StatusProblem {
        /// No status packet has come since the monitor connected.
        Missing {
            /// Address of the connection, with the port.
            address: String,
        } =>
            "no status packet received from {address}",
        /// No status packet has come for longer than [`Config::stale_after`](crate::Config::stale_after).
        Stale {
            /// Time since the last one came.
            age: Duration,
        } => "the last status packet came {age:.1?} ago",
        /// Packets have just resumed after a silence; the first may be old ones that the network had held back.
        Resuming => "status packets have just resumed after a silence, and may be old",
        /// The status connection has ended for good.
        Ended {
            /// Cause of the end.
            cause: Arc<Disconnect>,
        } => "the status connection has ended ({cause})",
        /// The status connection was lost, and the monitor is connecting again.
        Reconnecting =>
            "the status connection was lost, and the monitor is reconnecting",
        /// The newest packet cannot be read, or does not show whether the arm is stopped.
        Unreadable {
            /// Error, with the field that it concerns.
            source: DecodeError,
        } => "the newest status packet does not show whether the arm is stopped: {source}",
    }
}

impl StatusProblem {
    /// Remedy.
    pub fn remedy(&self) -> Remedy {
        match self {
            Self::Missing { .. } => Remedy::CheckStatusPort,
            Self::Stale { .. } => Remedy::CheckNetwork,
            Self::Resuming => Remedy::TryAgain,
            Self::Ended { .. } => Remedy::ConnectStatusAgain,
            Self::Reconnecting => Remedy::WaitForPackets,
            Self::Unreadable { .. } => Remedy::None,
        }
    }
}

/// The text includes the cause of [`Ended`](Self::Ended), so the source is the source of that cause.
impl StdError for StatusProblem {
    fn source(&self) -> Option<&(dyn StdError + 'static)> {
        if let Self::Ended { cause } = self { cause.source() } else { None }
    }
}
