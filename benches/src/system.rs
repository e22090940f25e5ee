//! Shared code of the system benchmarks: a server that answers printed messages, figures of interleaved rounds, and
//! figures that the system reports about a process.

pub mod canned;
pub mod child;
pub mod figures;
pub mod options;
pub mod process;
pub mod report;
