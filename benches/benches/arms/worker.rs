//! One turn: a process of its own, so that its memory is its own.

use std::io::Write;
use std::process::{Command, Stdio};
use std::sync::{Arc, Barrier};
use std::thread;
use std::time::Duration;

use jaka_benches::system::child::Addresses;
use jaka_benches::system::{options, process};

use super::{Failure, Tally, bare, session};

/// Sum of the counts of all arms over some turns, with the CPU time and the wall time that they took.
#[derive(Debug, Default)]
pub(crate) struct Figures {
    tally: Tally,
    cpu: Duration,
    wall: Duration,
    /// Memory of the arms in KiB, and number of threads: maxima over all turns.
    resident: u64,
    threads: u64,
}

/// Runs the arms of a turn, whose addresses are on standard input, and prints the figures.
pub(crate) fn run(role: &str) -> Result<(), Failure> {
    let seconds = options::number("--seconds", 5)?;
    let time = Duration::from_secs(seconds.into());
    let robots: Vec<_> =
        std::io::stdin().lines().map_while(Result::ok).filter_map(|line| Addresses::read(&line)).collect();
    let before = process::resident().unwrap_or_default();
    // All arms are connected before the first moves; their cycles are spread over a period, and the turn's end is
    // awaited.
    let stages = Arc::new([(); 3].map(|()| Barrier::new(robots.len() + 1)));
    let arm = |(number, robot): (usize, &Addresses)| {
        let (robot, stages, is_bare) = (*robot, Arc::clone(&stages), role == "bare");
        let offset = session::PERIOD * u32::try_from(number)? / u32::try_from(robots.len())?;
        let run = move || {
            if is_bare { bare::run(robot, offset, time, &stages) } else { session::run(robot, offset, time, &stages) }
        };
        Ok::<_, Failure>(thread::Builder::new().spawn(run)?)
    };
    let threads: Vec<_> = robots.iter().enumerate().map(arm).collect::<Result<_, _>>()?;
    stages[0].wait();
    let cpu = process::cpu().unwrap_or_default();
    stages[1].wait();
    let cpu = process::cpu().unwrap_or_default().saturating_sub(cpu);
    let (resident, count) = (process::resident().unwrap_or_default(), process::threads().unwrap_or_default());
    stages[2].wait();
    let mut sum = Tally::default();
    for thread in threads {
        sum.add(thread.join().map_err(|_| "an arm's thread panicked")??);
    }
    let Tally { cycles, lost, late, answered, packets } = sum;
    let (cpu, resident, count) = (cpu.as_micros(), resident - before, count - 1);
    println!("{cycles} {lost} {late} {answered} {packets} {cpu} {resident} {count}");
    Ok(())
}

/// Starts a turn and waits for its figures.
pub(crate) fn start(role: &str, robots: &[Addresses], seconds: u32) -> Result<Figures, Failure> {
    let mut command = Command::new(std::env::current_exe()?);
    command.args(["--role", role, "--seconds", &seconds.to_string()]);
    let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn()?;
    let mut input = child.stdin.take().ok_or("no standard input")?;
    for Addresses { commands, status } in robots {
        writeln!(input, "{commands} {status}")?;
    }
    drop(input);
    let output = child.wait_with_output()?;
    let text = String::from_utf8(output.stdout)?;
    let numbers: Vec<u64> = text.split_whitespace().map(str::parse).collect::<Result<_, _>>()?;
    let [cycles, lost, late, answered, packets, cpu, resident, threads] = numbers[..] else {
        return Err(format!("a turn failed: {text}").into());
    };
    Ok(Figures {
        tally: Tally { cycles, lost, late, answered, packets },
        cpu: Duration::from_micros(cpu),
        wall: Duration::from_secs(seconds.into()),
        resident,
        threads,
    })
}

#[expect(clippy::cast_precision_loss, reason = "figures to read")]
impl Figures {
    pub(crate) fn add(&mut self, other: &Self) {
        self.tally.add(other.tally);
        self.cpu += other.cpu;
        self.wall += other.wall;
        self.resident = self.resident.max(other.resident);
        self.threads = self.threads.max(other.threads);
    }

    /// The share of the set-points due that were never sent.
    pub(crate) fn lost_share(&self) -> f64 {
        self.tally.lost as f64 / (self.tally.cycles + self.tally.lost).max(1) as f64
    }

    pub(crate) fn print_head() {
        println!(
            "  {:>4} {:<11} {:>8} {:>8} {:>8} {:>9} {:>8} {:>10} {:>10} {:>8}",
            "arms", "", "cycles", "lost", "late", "answered", "packets", "CPU % each", "KiB each", "threads"
        );
    }

    pub(crate) fn print(&self, name: &str, arms: u32) {
        let Tally { cycles, lost, late, answered, packets } = self.tally;
        let cpu = 100.0 * self.cpu.as_secs_f64() / self.wall.as_secs_f64() / f64::from(arms);
        let memory = self.resident as f64 / f64::from(arms);
        let threads = self.threads as f64 / f64::from(arms);
        println!(
            "  {arms:>4} {name:<11} {cycles:>8} {lost:>8} {late:>8} {answered:>9} {packets:>8} {cpu:>10.3} {memory:>10.0} {threads:>8.1}"
        );
    }
}
