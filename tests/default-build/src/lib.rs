//! jaka-sync with its default features: the program of the README compiles, and `tests/arm.rs` moves an arm.

/// The README, whose program is compiled.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
pub struct Readme;
