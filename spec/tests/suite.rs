//! All tests through the public interface.

mod events;
mod lookup;
mod packs;
mod reports;
