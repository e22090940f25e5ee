#![doc = include_str!("../docs/overview.md")]

mod channel;
mod clock;
mod seat;
mod state;
mod stream;

pub use channel::Channel;
pub use clock::{Participant, SimulatedClock, Work};
pub use stream::{Listener, Stream};
