//! All tests through the public interface.

mod arguments;
mod checks;
mod construct;
mod envelope;
mod events;
mod exchange;
mod firmware;
mod in_place;
mod lenient;
mod places;
