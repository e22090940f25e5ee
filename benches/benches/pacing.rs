//! Lateness of set-points: sessions that sleep until the cycle, sessions that spin before it, and a bare loop, in turn.
//!
//! Options: `--seconds N` for each turn (1), `--rounds N` (10), `--spin MICROSECONDS` (200).

use std::error::Error;
use std::io::{ErrorKind, Read, Write};
use std::net::TcpStream;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use jaka_benches::system::canned::SET_POINT;
use jaka_benches::system::child::{Addresses, Server};
use jaka_benches::system::figures::median;
use jaka_benches::system::report::{self, Target};
use jaka_benches::system::{options, process};
use jaka_robot::{Client, Config, Monitor, Report, Robot, RobotConfig, ServoConfig};

const PERIOD: Duration = Duration::from_millis(8);

/// Answers are late by this many set-points in the last part.
const LATE: &str = "5";

type Failure = Box<dyn Error>;

/// Figures of one method of pacing over all rounds. Times are in microseconds.
#[derive(Default)]
struct Way {
    name: &'static str,
    /// Lateness of each set-point.
    late: Vec<f64>,
    /// Drift of the cycles from the clock as a share, one value a session.
    drift: Vec<f64>,
    passed_over: u64,
    most_outstanding: usize,
    cpu: Duration,
    wall: Duration,
}

fn main() -> Result<(), Failure> {
    let seconds = options::number("--seconds", 1)?;
    let rounds = options::number("--rounds", 10)?;
    let spin = Duration::from_micros(options::number("--spin", 200)?.into());
    let servers = [&[][..], &[LATE]].map(|late| Server::start(env!("CARGO_BIN_EXE_canned"), late, None));
    let [prompt, late] = servers;
    let (prompt, late) = (prompt?, late?);
    let time = Duration::from_secs(seconds.into());
    let mut ways = [
        "bare loop, sleeping",
        "session, sleeping",
        "session, spinning",
        "spinning, late answers",
        "spinning, beside 60 KB",
    ]
    .map(|name| Way { name, ..Way::default() });
    for round in 0..rounds {
        for turn in 0..5 {
            let way = (round + turn) as usize % 5;
            match way {
                0 => ways[way].bare(prompt.robots()[0], time)?,
                1 => ways[way].session(prompt.robots()[0], Duration::ZERO, time, false)?,
                2 => ways[way].session(prompt.robots()[0], spin, time, false)?,
                3 => ways[way].session(late.robots()[0], spin, time, false)?,
                _ => ways[way].session(prompt.robots()[0], spin, time, true)?,
            }
        }
    }
    let run =
        format!("{rounds} rounds of {seconds} s of each, a set-point each {PERIOD:?}, spinning {spin:?} before it");
    print(&mut ways, &run);
    Ok(())
}

impl Way {
    /// A loop that sleeps to absolute times, writes, and reads what has come.
    fn bare(&mut self, robot: Addresses, time: Duration) -> Result<(), Failure> {
        let mut stream = TcpStream::connect(robot.commands)?;
        stream.set_nodelay(true)?;
        stream.set_nonblocking(true)?;
        let mut buffer = vec![0; 8 << 10];
        let (cpu, start) = (process::thread_cpu(), Instant::now());
        let mut lateness = Vec::new();
        for due in (0..).map(|cycle| PERIOD * cycle).take_while(|due| *due < time) {
            let answers = stream.read(&mut buffer).or_else(|error| match error.kind() {
                ErrorKind::WouldBlock => Ok(0),
                _ => Err(error),
            });
            thread::sleep((start + due).saturating_duration_since(Instant::now()));
            lateness.push((due, micros(start.elapsed()) - micros(due)));
            stream.write_all(SET_POINT)?;
            std::hint::black_box(&buffer[..answers?]);
        }
        self.ran(start, cpu, &lateness);
        self.late.extend(lateness.iter().map(|(_, late)| late));
        Ok(())
    }

    /// A session, beside another handle that sends a request of 60 KB every 50 ms if `is_shared`.
    fn session(&mut self, robot: Addresses, spin: Duration, time: Duration, is_shared: bool) -> Result<(), Failure> {
        let monitor: Monitor = Monitor::connect_with(&Config::new(), robot.status)?;
        let client = Client::connect(robot.commands)?;
        let mut other = client.try_clone()?;
        let mut robot = Robot::new(client, monitor).expect("it is the only robot");
        robot.configure(&RobotConfig::new().allow_motion_without_status())?;
        let mut session =
            robot.enter_servo_mode(ServoConfig::new().max_unanswered(Duration::from_secs(30)).busy_wait(spin))?;
        let ended = Arc::new(AtomicBool::new(!is_shared));
        let is_over = Arc::clone(&ended);
        let sending = thread::spawn(move || {
            let long = format!(r#"{{"cmdName":"get_joint_pos","pad":"{}"}}"#, "x".repeat(60_000));
            while !is_over.load(Ordering::SeqCst) {
                other.call_text(&long, Duration::from_secs(1))?;
                thread::sleep(Duration::from_millis(50));
            }
            Ok::<_, jaka_sync::Error>(())
        });
        let (cpu, start) = (process::thread_cpu(), Instant::now());
        let mut late = Vec::new();
        while session.time() < time {
            let due = session.time();
            session.send_joint_offset([0.0; 6])?;
            late.push((due, micros(start.elapsed()) - micros(due)));
        }
        let run_time = start.elapsed();
        self.ran(start, cpu, &late);
        ended.store(true, Ordering::SeqCst);
        sending.join().map_err(|_| "the other handle's thread panicked")??;
        let report = session.land()?.report;
        self.late.extend(lateness(&report));
        self.passed_over += u64::try_from(run_time.as_nanos() / PERIOD.as_nanos())?.saturating_sub(report.cycles);
        self.most_outstanding = self.most_outstanding.max(report.most_outstanding);
        Ok(())
    }

    /// Adds what a session took, and how late its cycles were.
    fn ran(&mut self, start: Instant, cpu: Option<Duration>, lateness: &[(Duration, f64)]) {
        self.cpu +=
            process::thread_cpu().zip(cpu).map_or(Duration::ZERO, |(after, before)| after.saturating_sub(before));
        self.wall += start.elapsed();
        let third = lateness.len() / 3;
        let middle =
            |part: &[(Duration, f64)]| median(&mut part.iter().map(|(_, lateness)| *lateness).collect::<Vec<_>>());
        let (first, last) = (&lateness[..third], &lateness[lateness.len() - third..]);
        if let Some(((begin, _), (end, _))) = first.first().zip(last.first()) {
            self.drift.push((middle(last) - middle(first)) / (micros(*end) - micros(*begin)));
        }
    }

    fn percentile(&mut self, share: f64) -> f64 {
        self.late.sort_unstable_by(f64::total_cmp);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, clippy::cast_precision_loss)]
        let place = (share * self.late.len().saturating_sub(1) as f64).round() as usize;
        self.late.get(place).copied().unwrap_or(f64::NAN)
    }

    fn cpu_percent(&self) -> f64 {
        100.0 * self.cpu.as_secs_f64() / self.wall.as_secs_f64()
    }
}

/// The lateness of each set-point, which the report has in whole microseconds: rounded up here.
fn lateness(report: &Report) -> impl Iterator<Item = f64> {
    #[expect(clippy::cast_precision_loss)]
    let share = |cycle: u64| cycle as f64 / report.cycles.saturating_sub(1).max(1) as f64;
    (0..report.cycles).map(move |cycle| micros(report.lateness(share(cycle))) + 1.0)
}

fn print(ways: &mut [Way; 5], run: &str) {
    report::title("Servo pacing", run);
    println!("  {:<24} {:>8} {:>8} {:>8} {:>8} us {:>7}", "", "p50", "p90", "p99", "maximum", "CPU");
    for way in &mut *ways {
        let [p50, p90, p99, most] = [0.5, 0.9, 0.99, 1.0].map(|share| way.percentile(share));
        println!("  {:<24} {p50:>8.1} {p90:>8.1} {p99:>8.1} {most:>8.1} {:>8.2} %", way.name, way.cpu_percent());
    }
    let [bare, sleeping, spinning, late, shared] = ways;
    let ratio = |share| (spinning.percentile(share), sleeping.percentile(share));
    let [p50, p90] = [0.5, 0.9].map(ratio).map(|(spinning, sleeping)| spinning / sleeping);
    report::figure(
        "p50 of sleeping sessions relative to the bare loop",
        sleeping.percentile(0.5) / bare.percentile(0.5),
    );
    report::figure("CPU of sleeping sessions relative to the bare loop", sleeping.cpu_percent() / bare.cpu_percent());
    report::verdict("p50 of lateness, spinning relative to sleeping", p50, Target::AtMost(0.05));
    report::verdict("p90 of lateness, spinning relative to sleeping", p90, Target::AtMost(0.25));
    report::verdict("CPU, spinning, percent of a core", spinning.cpu_percent(), Target::AtMost(2.5));
    for way in [sleeping, spinning] {
        let drift = 100.0 * median(&mut way.drift);
        report::verdict(&format!("drift, percent: {}", way.name), drift.abs(), Target::AtMost(0.01));
    }
    println!("  {LATE} answers late: at most {} were outstanding", late.most_outstanding);
    #[expect(clippy::cast_precision_loss)]
    report::figure("  cycles passed over, answers late", late.passed_over as f64);
    report::figure("  p90 relative to that with prompt answers", late.percentile(0.9) / spinning.percentile(0.9));
    report::figure(
        "60 KB of another handle: p99 relative to none",
        shared.percentile(0.99) / spinning.percentile(0.99),
    );
}

fn micros(time: Duration) -> f64 {
    time.as_secs_f64() * 1e6
}
