//! Mixed traffic with random faults for an hour, or as long as wanted, with the simulators in another process:
//! `cargo run --release -p jaka-tests --example soak -- --minutes 60 --seed 7`.
//!
//! Prints a line a minute and a summary, and ends with 1 where something is wrong. `docs/reliability.md` says what is checked.

use std::error::Error;
use std::process::{Command, ExitCode};
use std::time::{Duration, SystemTime};
use std::{env, io};

use jaka_tests::soak::{self, Host, Length, Options};

/// Has the process run the simulators of another.
const SIMULATORS: &str = "--simulators";

/// Has glibc's allocator keep one heap. With one for each thread, as is usual, the holes in them grow for a long time where threads
/// come and go, and hide whether the program itself holds more and more.
const ONE_HEAP: (&str, &str) = ("MALLOC_ARENA_MAX", "1");

fn main() -> Result<ExitCode, Box<dyn Error>> {
    if env::var_os(ONE_HEAP.0).is_none() {
        let mut again = Command::new(env::current_exe()?);
        let status = again.args(env::args_os().skip(1)).env(ONE_HEAP.0, ONE_HEAP.1).status()?;
        return Ok(if status.success() { ExitCode::SUCCESS } else { ExitCode::FAILURE });
    }
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
    let options = Options { seed: seed.map_or_else(any_seed, Ok)?, arms: 4, operations: 250, length };
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
