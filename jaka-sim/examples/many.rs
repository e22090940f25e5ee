//! Measures the number of controllers that one process can serve: starts some, has a reader take the packets of each,
//! and prints the packets received, the time between them and the CPU time.
//!
//! `cargo run --release -p jaka-sim --example many [CONTROLLERS] [HERTZ] [SECONDS]`, by default 100 at 50 Hz for 10 s.

use std::error::Error;
use std::io::Read;
use std::net::TcpStream;
use std::process::ExitCode;
use std::thread;
use std::time::{Duration, Instant};

use jaka_proto::framing::Framer;
use jaka_sim::Controller;

fn main() -> ExitCode {
    let Err(error) = run() else { return ExitCode::SUCCESS };
    eprintln!("{error}");
    ExitCode::FAILURE
}

fn run() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let count: usize = arguments.next().map_or(Ok(100), |text| text.parse())?;
    let hertz: u32 = arguments.next().map_or(Ok(50), |text| text.parse())?;
    let seconds: u64 = arguments.next().map_or(Ok(10), |text| text.parse())?;
    let period = Duration::from_secs(1) / hertz;
    let started = Instant::now();
    let start = || Controller::builder().status_period(period).start();
    let controllers: Vec<_> = (0..count).map(|_| start()).collect::<Result<_, _>>()?;
    println!("{count} controllers started in {:?}", started.elapsed());

    let cpu = cpu_seconds();
    let until = Instant::now() + Duration::from_secs(seconds);
    let readers: Vec<_> = controllers.iter().map(|controller| reader(controller, until)).collect();
    let gaps = readers.into_iter().map(|reader| reader.join().map_err(|_| "a reader panicked")?);
    let mut gaps: Vec<Duration> = gaps.collect::<Result<Vec<_>, _>>()?.concat();
    let cpu = cpu_seconds().zip(cpu).map(|(after, before)| after - before);
    report(&mut gaps, count, period, seconds, cpu);
    Ok(())
}

/// Takes packets until the time is over, and gives the time between each two of them.
fn reader(controller: &Controller, until: Instant) -> thread::JoinHandle<Result<Vec<Duration>, String>> {
    let address = controller.status_addr();
    thread::spawn(move || {
        let mut stream = TcpStream::connect(address).map_err(|error| error.to_string())?;
        let mut framer = Framer::default();
        let mut arrivals = Vec::new();
        while Instant::now() < until {
            let len = stream.read(framer.spare()).map_err(|error| error.to_string())?;
            framer.filled(len);
            while framer.next_frame().map_err(|error| error.to_string())?.is_some() {
                arrivals.push(Instant::now());
            }
        }
        Ok(arrivals.windows(2).map(|pair| pair[1] - pair[0]).collect())
    })
}

#[expect(clippy::cast_precision_loss, reason = "figures to read")]
fn report(gaps: &mut [Duration], count: usize, period: Duration, seconds: u64, cpu: Option<f64>) {
    gaps.sort();
    let expected = count as f64 * seconds as f64 / period.as_secs_f64();
    println!("{} packets, {:.1} % of those due", gaps.len(), 100.0 * gaps.len() as f64 / expected);
    let at = |share: usize| gaps.get(gaps.len().saturating_sub(1) * share / 1000).copied().unwrap_or_default();
    println!("time between packets, {period:?} asked: median {:?}, p99 {:?}, p99.9 {:?}", at(500), at(990), at(999));
    match cpu {
        Some(cpu) => println!("CPU, readers included: {:.0} % of a core", 100.0 * cpu / seconds as f64),
        None => println!("CPU: not known on this system"),
    }
}

/// CPU time of this process, where /proc tells; its clock ticks 100 times a second on every usual system.
fn cpu_seconds() -> Option<f64> {
    let text = std::fs::read_to_string("/proc/self/stat").ok()?;
    let fields: Vec<_> = text.rsplit(')').next()?.split_whitespace().collect();
    let ticks = |index: usize| fields.get(index).and_then(|field| field.parse::<f64>().ok());
    Some((ticks(11)? + ticks(12)?) / 100.0)
}
