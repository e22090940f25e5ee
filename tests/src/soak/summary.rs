//! What came of it.

use std::fmt;

use super::resources::{Handles, growth};
use super::tally::Tally;

/// How many samples of the memory its trend takes at least.
const SAMPLES: usize = 10;

/// So many samples at the beginning are left out of the trend, or a fifth of all where that is more.
const WARM_UP: usize = 12;

/// By how much the memory may grow over the whole time behind the warm-up, in KiB.
const GROWTH: f64 = 1024.0;

/// What came of a soak.
#[derive(Debug, Clone)]
pub struct Summary {
    pub(super) seed: u64,
    pub(super) rounds: u32,
    pub(super) tally: Tally,
    pub(super) faults: Tally,
    pub(super) findings: Vec<String>,
    /// What was held before the first round, at rest after the last, and at most.
    pub(super) handles: [Handles; 3],
    /// At rest after each round, in KiB.
    memory: Vec<u32>,
}

impl Summary {
    pub(super) fn new(seed: u64) -> Self {
        let (tally, faults) = (Tally::default(), Tally::default());
        let handles = [Handles::now(), Handles::default(), Handles::default()];
        Self { seed, rounds: 0, tally, faults, findings: Vec::new(), handles, memory: Vec::new() }
    }

    /// A round is over, and nothing is connected.
    pub(super) fn at_rest(&mut self, memory: u32, most: Handles) {
        let first = self.handles[0];
        let now = first.settle();
        if now != first {
            self.findings.push(format!("after round {} there are {now}, and {first} before the first", self.rounds));
        }
        self.handles = [first, now, most];
        self.memory.push(memory);
    }

    /// All that is wrong; empty if nothing is.
    pub fn findings(&self) -> Vec<String> {
        let grown = self.growth().filter(|growth| *growth > GROWTH);
        let grown = grown.map(|growth| format!("the memory has grown by {growth:.0} KiB, and may by {GROWTH} KiB"));
        self.findings.iter().cloned().chain(grown).collect()
    }

    /// How often what happened, such as `commands` or `timeouts`.
    pub fn count(&self, what: &str) -> u64 {
        self.tally.get(what)
    }

    /// By how much the memory has grown behind the warm-up, in KiB; `None` where the time was too short to tell.
    fn growth(&self) -> Option<f64> {
        let samples = self.memory.get(WARM_UP.max(self.memory.len() / 5)..)?;
        (samples.len() >= SAMPLES).then(|| growth(samples))
    }

    /// The most important figures so far, in a line.
    pub(super) fn line(&self) -> String {
        let figures = ["commands", "accepted", "refused", "timeouts", "connections broken"];
        let figures = figures.map(|what| format!("{} {what}", self.tally.get(what)));
        let memory = self.memory.last().copied().unwrap_or_default();
        let (rounds, findings) = (self.rounds, self.findings.len());
        format!("{rounds} rounds, {}, {memory} KiB, {}, {findings} findings", figures.join(", "), self.handles[1])
    }
}

impl fmt::Display for Summary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "seed {}, {} rounds", self.seed, self.rounds)?;
        writeln!(f, "{}", self.tally)?;
        writeln!(f, "faults: {}", self.faults)?;
        let [first, last, most] = self.handles;
        writeln!(f, "held: {first} at first, {last} at last, {most} at most")?;
        let ends = [self.memory.first(), self.memory.last(), self.memory.iter().max()];
        let [first, last, most] = ends.map(|kib| kib.copied().unwrap_or_default());
        writeln!(f, "memory at rest: {first} KiB at first, {last} KiB at last, {most} KiB at most")?;
        match self.growth() {
            Some(growth) => writeln!(f, "trend of the memory behind the warm-up: {growth:+.0} of {GROWTH:+} KiB")?,
            None => writeln!(f, "too short for a trend of the memory")?,
        }
        let findings = self.findings();
        findings.iter().try_for_each(|finding| writeln!(f, "WRONG: {finding}"))?;
        write!(f, "{}", if findings.is_empty() { "nothing is wrong" } else { "something is wrong" })
    }
}
