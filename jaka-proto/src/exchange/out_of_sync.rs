//! Why replies can no longer be attributed.

use std::fmt;

use crate::text::Visible;

/// Why the replies of a connection can no longer be attributed to its requests.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum OutOfSync {
    /// A reply came to a command that was not sent, or that was answered already.
    Unsolicited {
        /// `cmdName` of the reply.
        command: String,
    },
    /// A reply came to a request before any of it was sent.
    BeforeSent,
    /// A reply names no command, and is not the refusal of the only request that is outstanding.
    Nameless,
    /// A request was not answered in time, after a reply of its name was taken for that to an older request: it may have been its own.
    Ambiguous {
        /// `cmdName` of both.
        command: String,
    },
}

impl fmt::Display for OutOfSync {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unsolicited { command } => {
                write!(f, "a reply to `{}` came, but no such request is outstanding", Visible(command))
            }
            Self::BeforeSent => f.write_str("a reply came to a request before any of it was sent"),
            Self::Nameless => f.write_str("a reply came that names no command"),
            Self::Ambiguous { command } => {
                write!(f, "one of two replies to `{}` is lost, and it is not known which", Visible(command))
            }
        }
    }
}

impl std::error::Error for OutOfSync {}
