//! All tests through the public interface.

mod arguments;
mod checks;
mod envelope;
mod events;
mod firmware;
mod in_place;
mod ledger;
mod lenient;
mod places;
