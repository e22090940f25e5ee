//! A sine for joint 6 in servo mode, with the lateness of its set-points compared with that of a loop that does nothing
//! else.
//!
//! `cargo run --release --example servo_sine -- [ADDRESS] [--seconds N] [--spin MICROSECONDS]`; without an address
//! against a simulated controller. On a robot it powers the arm and turns joint 6 by 2 degrees to and fro; it asks
//! before.

mod common;

use std::error::Error;
use std::f64::consts::TAU;
use std::ops::ControlFlow;
use std::process::ExitCode;
use std::time::{Duration, Instant};

use jaka_robot::ServoConfig;
use jaka_robot::types::JointPosition;

/// Degrees to each side, and seconds for one turn: 4 deg/s at most, so slow that the arm may start from standstill at
/// any of its points, where this thread got no processor for a while.
const AMPLITUDE: f64 = 2.0;
const PERIOD: f64 = 4.0;

fn main() -> ExitCode {
    common::end(run())
}

fn run() -> Result<(), Box<dyn Error>> {
    let number = |name: &str| std::env::args().skip_while(|arg| arg != name).nth(1).map(|text| text.parse::<u64>());
    let seconds = number("--seconds").transpose()?.unwrap_or(5);
    let spin = Duration::from_micros(number("--spin").transpose()?.unwrap_or(0));
    let target = common::target_at(std::env::args().nth(1).filter(|address| !address.starts_with("--")))?;
    target.ask("The arm will be powered and joint 6 will turn by 2 deg. Clear the area.")?;
    let mut robot = target.robot()?;
    robot.power_up(Duration::from_secs(60))?;

    println!("\nTurning joint 6 for {seconds} s");
    let start = robot.client().get_joint_pos()?.joint_position;
    let config = ServoConfig::new().busy_wait(spin);
    let mut session = robot.enter_servo_mode(&config)?;
    let end = Duration::from_secs(seconds);
    session.run(
        |time, _status| {
            if time < end { ControlFlow::Continue(sine(start, time)) } else { ControlFlow::Break(()) }
        },
    )?;
    let report = session.land()?.report;
    println!(
        "  {} set-points, {} accepted, {} refused, {} unanswered, {} late, at most {} answers outstanding",
        report.cycles, report.accepted, report.refused, report.unanswered, report.late_cycles, report.most_outstanding
    );
    let bare = bare_loop(config.period(), report.cycles, spin);
    println!("  lateness        p50        p90        p99        maximum");
    let row = |name: &str, at: &dyn Fn(f64) -> Duration| {
        println!("  {name:<11} {:>10?} {:>10?} {:>10?} {:>10?}", at(0.5), at(0.9), at(0.99), at(1.0));
    };
    row("session", &|share| report.lateness(share));
    row("bare loop", &|share| percentile(&bare, share));
    Ok(())
}

/// Starts at rest: the amplitude grows over the first turn. The landing brakes it.
fn sine(start: JointPosition, time: Duration) -> JointPosition {
    let t = time.as_secs_f64();
    let mut joints = start;
    joints.0[5] += AMPLITUDE * (t / PERIOD).min(1.0) * (TAU * t / PERIOD).sin();
    joints
}

/// Runs a loop with the same pacing and no robot, and returns the lateness of its cycles on this machine, sorted.
fn bare_loop(period: Duration, cycles: u64, spin: Duration) -> Vec<Duration> {
    let start = Instant::now();
    let mut late = Vec::new();
    for cycle in 0..u32::try_from(cycles).unwrap_or(u32::MAX) {
        let due = start + period * cycle;
        std::thread::sleep(due.saturating_duration_since(Instant::now()).saturating_sub(spin));
        while Instant::now() < due {
            std::hint::spin_loop();
        }
        late.push(Duration::from_micros(u64::try_from(due.elapsed().as_micros()).unwrap_or(u64::MAX)));
    }
    late.sort_unstable();
    late
}

fn percentile(sorted: &[Duration], share: f64) -> Duration {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, clippy::cast_precision_loss)]
    let place = (share * sorted.len().saturating_sub(1) as f64).round() as usize;
    sorted.get(place).copied().unwrap_or_default()
}
