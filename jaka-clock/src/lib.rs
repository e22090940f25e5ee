#![doc = include_str!("../docs/overview.md")]

mod channel;
mod clock;
mod seat;
mod state;

pub use channel::Channel;
pub use clock::{Participant, SimulatedClock, Work};
