//! The links between the ports and their clients, with what is wrong with them.
//!
//! A connection is a [`Wire`]. As long as no link has ever had a fault, a wire writes to its socket and reads from it, and one
//! atomic load is all that is added. From then on, what a wire sends can wait in a queue, for a thread that is spawned when the
//! first bytes wait; what it receives waits where it is read, in the thread that reads.

mod inbound;
mod queue;
mod state;
mod wire;

use std::fmt;

pub(crate) use self::inbound::{Inbound, Received};
pub(crate) use self::state::Links;
pub(crate) use self::wire::Wire;

/// A port of the controller.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[expect(clippy::exhaustive_enums, reason = "a controller has these two")]
pub enum Port {
    /// The port that takes commands: 10001 of a real controller.
    Command,
    /// The port that sends status packets: 10000 of a real controller.
    Status,
}

/// A direction of what passes between a port and its clients.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[expect(clippy::exhaustive_enums, reason = "a connection has these two")]
pub enum Direction {
    /// What clients send: requests. Clients of the status port have nothing to send, so that only an end is on this way.
    ToController,
    /// What clients receive: replies and status packets.
    ToClient,
}

impl Port {
    /// Both ports.
    pub const ALL: [Self; 2] = [Self::Command, Self::Status];
}

impl Direction {
    /// Both directions.
    pub const ALL: [Self; 2] = [Self::ToController, Self::ToClient];
}

/// As in the script of a [`FaultPlan`](crate::FaultPlan): `command` or `status`.
impl fmt::Display for Port {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Command => "command",
            Self::Status => "status",
        })
    }
}

/// As in the script of a [`FaultPlan`](crate::FaultPlan): `to-controller` or `to-client`.
impl fmt::Display for Direction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::ToController => "to-controller",
            Self::ToClient => "to-client",
        })
    }
}
