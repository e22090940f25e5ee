//! Targets of fuzzing: functions that take any bytes and panic if a check fails.
//!
//! The binaries in `fuzz/` run them on inputs that libFuzzer makes up. `tests/tests/connection/corpora.rs` runs them on
//! the inputs in `tests/corpora/`. `docs/fuzzing.md` has the commands.

mod builtin;
mod fault_plan;
mod framing;
mod json;
mod pack;
mod python;
mod recording;
mod replies;
mod requests;
mod simulator;
mod spec_file;
mod status;

pub use fault_plan::fault_plan;
pub use framing::framing;
pub use json::json;
pub use pack::pack;
pub use python::python;
pub use recording::recording;
pub use replies::replies;
pub use requests::requests;
pub use simulator::simulator;
pub use spec_file::spec_file;
pub use status::status;

/// A fuzz target.
#[derive(Debug, Clone, Copy)]
pub struct Target {
    /// The name of its binary in `fuzz/` and of its folder in `tests/corpora/`.
    pub name: &'static str,
    /// Checks one input.
    pub check: fn(&[u8]),
}

/// All targets.
pub const TARGETS: &[Target] = &[
    Target { name: "fault_plan", check: fault_plan },
    Target { name: "framing", check: framing },
    Target { name: "json", check: json },
    Target { name: "pack", check: pack },
    Target { name: "python", check: python },
    Target { name: "recording", check: recording },
    Target { name: "replies", check: replies },
    Target { name: "requests", check: requests },
    Target { name: "simulator", check: simulator },
    Target { name: "spec_file", check: spec_file },
    Target { name: "status", check: status },
];
