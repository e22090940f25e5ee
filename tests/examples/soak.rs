//! Mixed traffic with random faults for an hour, or as long as wanted, with the simulators in another process:
//! `cargo run --release -p jaka-tests --example soak -- --minutes 60 --seed 7`.
//!
//! Prints a line a minute and a summary, and ends with 1 where something is wrong. `docs/reliability.md` says what is
//! checked.

use std::alloc::System;
use std::error::Error;
use std::process::{Command, ExitCode};
use std::time::{Duration, SystemTime};
use std::{env, io};

use jaka_tests::soak::{self, Host, Length, Options};
use stats_alloc::{INSTRUMENTED_SYSTEM, StatsAlloc};

/// Has the process run the simulators of another.
const SIMULATORS: &str = "--simulators";

#[global_allocator]
static ALLOCATOR: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let (mut minutes, mut seed) = (60.0, None);
    let mut arguments = env::args().skip(1);
    while let Some(argument) = arguments.next() {
        let mut value = || arguments.next().ok_or_else(|| format!("{argument} lacks its value"));
        match argument.as_str() {
            SIMULATORS => return soak::serve().map(|()| ExitCode::SUCCESS).map_err(Into::into),
            "--minutes" => minutes = value()?.parse()?,
            "--seed" => seed = Some(value()?.parse()?),
            other => return Err(format!("no option `{other}`; there are --minutes and --seed").into()),
        }
    }
    let length = Length::Time(Duration::try_from_secs_f64(minutes * 60.0)?);
    let options =
        Options { seed: seed.map_or_else(any_seed, Ok)?, arms: 4, operations: 250, length, allocator: ALLOCATOR };
    println!("seed {}, {} arms, {minutes} minutes", options.seed, options.arms);
    let mut simulators = Command::new(env::current_exe()?);
    simulators.arg(SIMULATORS);
    let summary = soak::run(&options, Host::elsewhere(simulators)?, &mut io::stdout())?;
    println!("{summary}");
    Ok(if summary.findings().is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Another one each time.
fn any_seed() -> Result<u64, Box<dyn Error>> {
    let now = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH)?;
    Ok(now.as_secs())
}
