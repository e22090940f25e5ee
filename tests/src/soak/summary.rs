//! Summary of a soak.

use std::alloc::System;
use std::fmt;

use stats_alloc::StatsAlloc;

use super::resources::{Handles, allocated, resident};
use super::tally::Tally;

/// Maximum growth of the memory at rest since the first round, in bytes: the figures themselves take some.
const GROWTH: u64 = 2048;

/// Summary of a soak.
#[derive(Debug, Clone)]
pub struct Summary {
    pub(super) seed: u64,
    pub(super) rounds: u32,
    pub(super) tally: Tally,
    pub(super) faults: Tally,
    pub(super) findings: Vec<String>,
    /// Handles before the first round, at rest after the last round, and at the peak.
    pub(super) handles: [Handles; 3],
    /// Bytes that were allocated at rest after the first round, after the last, and at most.
    allocated: Option<[u64; 3]>,
}

impl Summary {
    pub(super) fn new(seed: u64) -> Self {
        let (tally, faults) = (Tally::default(), Tally::default());
        let handles = [Handles::now(), Handles::default(), Handles::default()];
        Self { seed, rounds: 0, tally, faults, findings: Vec::new(), handles, allocated: None }
    }

    /// A round is over, and nothing is connected.
    pub(super) fn at_rest(&mut self, allocator: &StatsAlloc<System>, most: Handles) {
        let first = self.handles[0];
        let now = first.settle();
        if now != first {
            self.findings.push(format!("after round {} there are {now}, and {first} before the first", self.rounds));
        }
        self.handles = [first, now, most];
        let now = allocated(allocator);
        let [first, _, most] = self.allocated.unwrap_or([now; 3]);
        self.allocated = Some([first, now, most.max(now)]);
    }

    /// All that is wrong; empty if nothing is.
    pub fn findings(&self) -> Vec<String> {
        let [first, last, _] = self.allocated.unwrap_or_default();
        let grown =
            (last > first + GROWTH).then(|| format!("{last} bytes are allocated at last, and {first} at first"));
        self.findings.iter().cloned().chain(grown).collect()
    }

    /// Number of events of a kind, such as `commands` or `timeouts`.
    pub fn count(&self, what: &str) -> u64 {
        self.tally.get(what)
    }

    /// The most important figures so far, in a line.
    pub(super) fn line(&self) -> String {
        let figures = ["commands", "accepted", "refused", "timeouts", "connections broken"];
        let figures = figures.map(|what| format!("{} {what}", self.tally.get(what)));
        let [_, allocated, _] = self.allocated.unwrap_or_default();
        let memory = format!("{allocated} bytes allocated, {} KiB resident", resident());
        let (rounds, figures, findings) = (self.rounds, figures.join(", "), self.findings.len());
        format!("{rounds} rounds, {figures}, {memory}, {}, {findings} findings", self.handles[1])
    }
}

impl fmt::Display for Summary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "seed {}, {} rounds", self.seed, self.rounds)?;
        writeln!(f, "{}", self.tally)?;
        writeln!(f, "faults: {}", self.faults)?;
        let [first, last, most] = self.handles;
        writeln!(f, "held: {first} at first, {last} at last, {most} at most")?;
        let [first, last, most] = self.allocated.unwrap_or_default();
        writeln!(
            f,
            "allocated at rest: {first} bytes at first, {last} at last, {most} at most; {} KiB resident",
            resident()
        )?;
        let findings = self.findings();
        findings.iter().try_for_each(|finding| writeln!(f, "WRONG: {finding}"))?;
        write!(f, "{}", if findings.is_empty() { "nothing is wrong" } else { "something is wrong" })
    }
}
