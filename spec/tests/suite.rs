//! All tests through the public interface.

mod errors;
mod events;
mod lookup;
mod packs;
mod unfit;
