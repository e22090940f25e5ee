//! What the benchmarks of the system share: a server that answers printed messages, figures of interleaved rounds, and
//! what the system reports about a process.

pub mod canned;
pub mod child;
pub mod figures;
pub mod options;
pub mod process;
pub mod report;
