//! All tests of the clock.

mod connections;
mod time;
