#![doc = include_str!("../docs/overview.md")]

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
