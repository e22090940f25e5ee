//! The links between the ports and their clients, with what is wrong with them.
//!
//! A connection is a [`Wire`]. As long as no link has ever had a fault, a wire writes to its socket and reads from it, and the only
//! addition is one atomic load. After the first fault, what a wire sends can wait in a queue, for a thread that is spawned when the
//! first bytes wait; what it receives waits where it is read, in the thread that reads.

mod inbound;
mod queue;
mod state;
mod wire;

pub(crate) use self::inbound::{Inbound, Received};
pub(crate) use self::state::Links;
pub(crate) use self::wire::Wire;
