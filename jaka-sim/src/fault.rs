//! Faults of replies, status packets and links, and their text forms.

mod kinds;
mod link;
mod plan;
mod rename;
mod reply;
mod script;
mod script_error;
mod split_mix;
mod status;
mod token_reader;
mod tokens;

pub(crate) use self::kinds::{Argument, kinds};
pub use self::link::LinkFault;
pub(crate) use self::link::Passage;
pub use self::plan::FaultPlan;
pub(crate) use self::reply::Delivery;
pub use self::reply::Fault;
pub use self::script_error::ScriptError;
pub(crate) use self::script_error::quoted;
pub(crate) use self::split_mix::SplitMix64;
pub use self::status::StatusFault;
pub(crate) use self::status::{PacketWrites, Sent};
pub(crate) use self::token_reader::{TokenReader, read_time};

/// Greatest number of bytes that a fault generates: 256 MiB.
const MOST_BYTES: usize = 256 << 20;

/// Returns random bytes; equal seeds give equal bytes.
fn garbage(bytes: usize, seed: u64) -> Vec<u8> {
    SplitMix64::new(seed).bytes(bytes.min(MOST_BYTES))
}
