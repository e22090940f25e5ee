#![doc = include_str!("../docs/overview.md")]
// On the host of the documentation each item says which feature it needs.
#![cfg_attr(docsrs, feature(doc_cfg))]

mod clock;
mod signal;
#[cfg(feature = "simulated")]
mod simulated;
mod socket;

pub use clock::{Clock, Stopwatch};
pub use signal::{Signal, lock};
#[cfg(feature = "simulated")]
pub use simulated::{Listener, Participant, SimulatedClock, Stream, Work};
pub use socket::Socket;
