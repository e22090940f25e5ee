//! Unknown states of a robot.

use std::error::Error as StdError;
use std::sync::Arc;
use std::time::Duration;

use jaka_proto::wire::DecodeError;

use crate::Disconnect;

jaka_proto::worded! {
    /// Why the state of a robot is not known.
    #[derive(Debug, Clone)]
    #[non_exhaustive]
    pub enum StatusProblem {
        /// No status packet has come since the monitor connected.
        Missing {
            /// Where it is connected to, with the port.
            address: String,
        } =>
            "no status packet has come from {address}; check that this is the status port, 10000, and that the controller has started",
        /// No status packet has come for longer than [`Config::stale_after`](crate::Config::stale_after).
        Stale {
            /// How long ago the last one came.
            age: Duration,
        } => "the last status packet came {age:.1?} ago; check the network, and wait until packets come again",
        /// Packets have just resumed after a silence; the first may be old ones that the network had held back.
        Resuming => "status packets have just resumed after a silence, and may be old; try again in a moment",
        /// The status connection has ended for good.
        Ended {
            /// Why.
            cause: Arc<Disconnect>,
        } => "the status connection has ended ({cause}); make a new `Robot`, or set `Config::reconnect`",
        /// The status connection was lost, and the monitor is connecting again.
        Reconnecting =>
            "the status connection was lost, and the monitor is reconnecting; wait until packets come again",
        /// The newest packet cannot be read, or does not show whether the arm is stopped.
        Unreadable {
            /// Which field, and why.
            source: DecodeError,
        } => "the newest status packet does not show whether the arm is stopped: {source}",
    }
}

/// The cause of [`Ended`](Self::Ended) is part of this one's text: its source is the source of that.
impl StdError for StatusProblem {
    fn source(&self) -> Option<&(dyn StdError + 'static)> {
        if let Self::Ended { cause } = self { cause.source() } else { None }
    }
}
