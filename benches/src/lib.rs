//! What the benchmarks share.

pub mod system;
