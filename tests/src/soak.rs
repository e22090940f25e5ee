//! Mixed traffic with random faults for any length of time: the simulator sees the commands that were sent, each reply
//! goes to its caller, and memory, handles and threads do not grow.
//!
//! Several arms, each a thread with a client, a monitor, two stop handles, a status stream and now and then a recorder,
//! against simulators with faults on both ports. The traffic comes in rounds. Between them nothing is connected, and
//! each arm's account is compared with the requests that its simulator saw.

mod account;
mod arm;
mod background;
mod calls;
mod faults;
mod held;
mod host;
mod orders;
mod random;
mod resources;
mod servo;
mod session;
mod summary;
mod tally;

use std::alloc::System;
use std::collections::BTreeMap;
use std::io::{self, Write};
use std::sync::{Arc, mpsc};
use std::thread;
use std::time::{Duration, Instant};

use jaka_proto::Envelope;
use jaka_sim::Fault;
use jaka_sync::program::StopProgram;
use stats_alloc::StatsAlloc;

use self::arm::{Arm, Done, Place};
use self::background::{Findings, Rate};
pub use self::host::{Host, serve};
use self::random::Random;
use self::resources::Peak;
pub use self::resources::resident;
pub use self::summary::Summary;

/// Timeout for a round, far above its usual duration.
const LIMIT: Duration = Duration::from_secs(900);

/// Options of a soak.
#[derive(Debug, Clone)]
pub struct Options {
    /// The traffic and the faults follow from it, as far as threads allow.
    pub seed: u64,
    /// Number of arms.
    pub arms: u32,
    /// Number of operations of each arm in a round.
    pub operations: u32,
    /// End of the soak.
    pub length: Length,
    /// Allocator of this process.
    pub allocator: &'static StatsAlloc<System>,
}

/// End of a soak.
#[derive(Debug, Clone, Copy)]
pub enum Length {
    /// After this many rounds.
    Rounds(u32),
    /// With the round in which the time is up.
    Time(Duration),
}

impl Length {
    fn is_over(self, rounds: u32, time: Duration) -> bool {
        match self {
            Self::Rounds(count) => rounds >= count,
            Self::Time(limit) => time >= limit,
        }
    }
}

/// Runs the soak, writes a line a minute, and returns the summary.
///
/// # Errors
/// The lines cannot be written.
///
/// # Panics
/// The simulators are gone.
pub fn run(options: &Options, host: Host, out: &mut impl Write) -> io::Result<Summary> {
    let host = Arc::new(host);
    let peak = Arc::new(Peak::default());
    let mut summary = Summary::new(options.seed);
    let (since, mut minutes) = (Instant::now(), 0);
    while !options.length.is_over(summary.rounds, since.elapsed()) {
        if !round(options, &host, &peak, &mut summary) {
            break;
        }
        summary.at_rest(options.allocator, peak.most());
        let passed = since.elapsed().as_secs() / 60;
        if passed > minutes {
            minutes = passed;
            writeln!(out, "minute {minutes}: {}", summary.line())?;
        }
    }
    Ok(summary)
}

/// One round of all arms; false if one of them does not end.
fn round(options: &Options, host: &Arc<Host>, peak: &Arc<Peak>, summary: &mut Summary) -> bool {
    let (round, findings) = (summary.rounds, Findings::default());
    let ports = host.begin(options.seed, round, options.arms);
    let (done, results) = mpsc::channel();
    for (arm, ports) in (0..).zip(ports) {
        let time = ports.time.clone();
        let (host, findings, peak) = (Arc::clone(host), findings.clone(), Arc::clone(peak));
        let place = Place { host, arm, ports, rate: Rate::default(), findings, peak };
        let program = Arm::new(place, Random::new(options.seed, [round, arm, 0]));
        let (done, operations) = (done.clone(), options.operations);
        thread::spawn(time.participating(move || done.send((arm, program.run(operations)))));
    }
    // Where an arm panics, the last sender is gone before its result.
    drop(done);
    let mut all_end = true;
    for _ in 0..options.arms {
        if let Ok((arm, result)) = results.recv_timeout(LIMIT) {
            settle(options, host, arm, &result, &findings, summary);
        } else {
            findings.add(format!("an arm has panicked, or does not end within {LIMIT:?}"));
            all_end = false;
            break;
        }
    }
    host.end();
    let findings = findings.take().into_iter().map(|finding| format!("round {round}: {finding}"));
    summary.findings.extend(findings);
    summary.rounds += 1;
    all_end
}

/// Compares an arm's account with what its simulator saw.
fn settle(options: &Options, host: &Host, arm: u32, done: &Done, findings: &Findings, summary: &mut Summary) {
    let seen = host.requests(arm);
    for finding in account::check(&done.connections, &seen, &crate::text(&StopProgram::new())) {
        findings.add(format!("arm {arm}: {finding}"));
    }
    summary.tally.join(&done.tally);
    summary.tally.add("requests seen", u64::try_from(seen.len()).unwrap_or_default());
    summary.faults.join(&done.faults);
    let script = faults::script(options.seed, summary.rounds, arm);
    let mut script: BTreeMap<_, _> = script.into_iter().map(|(name, faults)| (name, faults.into_iter())).collect();
    for text in &seen {
        let command = Envelope::read(text).ok().and_then(|envelope| envelope.command).unwrap_or_default();
        let fault = script.get_mut(&*command).and_then(Iterator::next);
        if let Some(fault) = fault.filter(|fault| *fault != Fault::None) {
            summary.faults.one(&faults::kind(&fault));
        }
    }
}
