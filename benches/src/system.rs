//! Shared code of the system benchmarks: a server that answers printed messages, and figures of interleaved rounds.

pub mod canned;
pub mod child;
pub mod figures;
pub mod options;
pub mod report;
