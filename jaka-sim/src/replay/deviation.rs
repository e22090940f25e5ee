//! Where a client deviates from the recording.

use std::fmt;

use jaka_proto::recording::Port;

/// Where a client deviates from the recording, so that it has no answer.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Deviation {
    /// Another request came than the recorded one. The connection was closed.
    OtherRequest {
        /// The recorded request.
        expected: String,
        /// The request that came.
        received: String,
    },
    /// A request came where the recorded client sent nothing more. The connection was closed.
    FurtherRequest {
        /// The request that came.
        received: String,
    },
    /// The client ended its connection before it sent what the recorded one sent.
    MissingRequest {
        /// The recorded request.
        expected: String,
    },
    /// A request came to which no reply is left. It was refused.
    NoReplyLeft {
        /// The request that came.
        received: String,
    },
    /// The recording lacks entries, since its file could not be written as fast. The connection was closed there.
    Gap {
        /// How many entries are missing.
        count: u64,
    },
    /// A connection was made that the recording does not have. It was closed.
    Connection {
        /// The port.
        port: Port,
        /// How many connections to it the recording has.
        recorded: usize,
    },
}

impl fmt::Display for Deviation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OtherRequest { expected, received } => {
                write!(f, "expected the recorded request `{expected}`, but received `{received}`")
            }
            Self::FurtherRequest { received } => {
                write!(f, "received `{received}`, but no further request was recorded")
            }
            Self::MissingRequest { expected } => {
                write!(f, "expected the recorded request `{expected}`, but the client disconnected")
            }
            Self::NoReplyLeft { received } => write!(f, "the recording has no unused reply to `{received}`"),
            Self::Gap { count } => write!(f, "{count} entries are missing in the recording at this point"),
            Self::Connection { port, recorded } => {
                write!(f, "a connection to the {} port, of which the recording has {recorded}", port.word())
            }
        }
    }
}
