//! Status packets as CSV on standard output; all else goes to standard error.
//!
//! `cargo run --example monitor_csv > status.csv` writes three seconds of a simulated arm that moves;
//! `cargo run --example monitor_csv 10.5.5.100 60` a minute of a robot. There it only reads, from the status port, so
//! that it disturbs no other program.

mod common;

use std::env::args;
use std::error::Error;
use std::io::{ErrorKind, Write, stdout};
use std::process::ExitCode;
use std::time::{Duration, Instant};

use jaka_robot::motion::JointMove;
use jaka_robot::status::RobotStatus;
use jaka_robot::{Client, Config, Monitor, Snapshot};

/// A second of packets at the rate of the fastest firmware: standard output may be slow for this long.
const CAPACITY: usize = 125;

fn main() -> ExitCode {
    common::end(run())
}

fn run() -> Result<(), Box<dyn Error>> {
    let target = common::target()?;
    let seconds = args().nth(2).map_or(Ok(if target.is_simulated { 3 } else { 10 }), |seconds| seconds.parse())?;
    let monitor: Monitor = Monitor::connect_with(&Config::new(), &target.status)?;
    // Only a simulated arm is moved. It goes on when its client is gone.
    let _client = target.is_simulated.then(|| set_going(&target.commands)).transpose()?;
    match write_csv(&monitor, Duration::from_secs(seconds), &mut stdout().lock()) {
        // A reader that closes the pipe has seen enough: `monitor_csv | head`.
        Err(error) if is_broken_pipe(&*error) => Ok(()),
        result => result,
    }
}

fn write_csv(monitor: &Monitor, time: Duration, out: &mut impl Write) -> Result<(), Box<dyn Error>> {
    let packets = monitor.subscribe(CAPACITY);
    writeln!(
        out,
        "time_s,j1_deg,j2_deg,j3_deg,j4_deg,j5_deg,j6_deg,x_mm,y_mm,z_mm,rx_deg,ry_deg,rz_deg,speed_mm_s,in_position"
    )?;
    let start = Instant::now();
    let mut rows = 0;
    while let Some(left) = time.checked_sub(start.elapsed()) {
        let Some(packet) = packets.next_packet_within(left) else { break };
        writeln!(out, "{}", row(&packet, start))?;
        rows += 1;
    }
    eprintln!("{rows} packets written, {} dropped", packets.dropped());
    if let Some(cause) = monitor.disconnect_cause() {
        return Err(format!("the status connection ended: {cause}").into());
    }
    if rows == 0 {
        return Err(format!("no packet came within {time:?}").into());
    }
    Ok(())
}

/// The cells of a packet. A key that it does not have stays empty: a zero would be a claim.
fn row(packet: &Snapshot<RobotStatus>, start: Instant) -> String {
    let status = &packet.status;
    let joints = status.joint_actual_position.map(|joints| joints.0);
    let pose = status.actual_position.map(<[f64; 6]>::from);
    let mut cells = vec![format!("{:.3}", packet.received.saturating_duration_since(start).as_secs_f64())];
    for values in [joints, pose] {
        cells.extend((0..6).map(|i| values.map_or(String::new(), |values| format!("{:.4}", values[i]))));
    }
    cells.push(status.tcp_speed.map_or(String::new(), |speed| format!("{speed:.2}")));
    cells.push(status.in_position.map_or(String::new(), |is| u8::from(is).to_string()));
    cells.join(",")
}

/// Moves a simulated arm, so that there is something to see.
fn set_going(address: &str) -> Result<Client, jaka_robot::Error> {
    let mut client = Client::connect(address)?;
    client.power_on()?;
    client.enable_robot()?;
    let joint_position = [10.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    client.joint_move(&JointMove::relative(joint_position, 8.0).acceleration(20.0))?;
    Ok(client)
}

fn is_broken_pipe(error: &(dyn Error + 'static)) -> bool {
    error.downcast_ref::<std::io::Error>().is_some_and(|error| error.kind() == ErrorKind::BrokenPipe)
}
