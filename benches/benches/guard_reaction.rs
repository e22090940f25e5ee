//! Time from a status packet that trips a guard until the stop is on the wire. The witness has the
//! controller's ends of both connections as plain sockets, and knows nothing of this SDK: it says when it has sent the
//! packet, and when the bytes of `stop_program` have come.
//!
//! Option: `--trips N`, 300 by default.

use std::error::Error;
use std::io::{ErrorKind, Read, Write};
use std::net::{SocketAddr, TcpListener, TcpStream};
use std::ops::ControlFlow;
use std::sync::mpsc::{self, Receiver, Sender};
use std::thread;
use std::time::{Duration, Instant};

use jaka_benches::system::figures::{Contender, Samples};
use jaka_benches::system::{options, report};
use jaka_robot::motion::JointMove;
use jaka_robot::{Client, Monitor, MotionExt as _, Numbering, Robot};

type Failure = Box<dyn Error + Send + Sync>;

/// The bound at the 99th percentile, in milliseconds.
const BOUND: f64 = 1.0;

/// The time between two packets.
const PERIOD: Duration = Duration::from_millis(8);

/// Number of packets of a motion before the one that trips the guard.
const BEFORE: usize = 3;

/// Names of the runs, each with the time that the program's own observer takes for each packet.
const OBSERVERS: [(&str, Duration); 2] =
    [("run under a guard", Duration::ZERO), ("the same, with an observer that takes 5 ms", Duration::from_millis(5))];

fn main() -> Result<(), Box<dyn Error>> {
    let trips = options::number("--trips", 300)?;
    report::title("From a packet to the stop on the wire, loopback", format_args!("{trips} trips each"));
    let mut limit = Contender::new("by hand, one thread", |_| Ok(()));
    limit.samples = measure(trips, bare).map_err(|failure| failure.to_string())?;
    let mut contenders = vec![limit];
    for (name, observer) in OBSERVERS {
        let mut contender = Contender::new(name, |_| Ok(()));
        let program = |commands, status, trips| guarded(commands, status, trips, observer);
        contender.samples = measure(trips, program).map_err(|failure| failure.to_string())?;
        contenders.push(contender);
    }
    report::percentiles(&contenders);
    for Contender { name, samples, .. } in &contenders {
        report::verdict(&format!("{name}, p99, ms"), samples.percentile(0.99) / 1000.0, BOUND);
    }
    Ok(())
}

/// Measures the time from the packet to the stop on the wire. The program gets the addresses of the command port and
/// the status port.
fn measure(
    trips: u32,
    program: impl FnOnce(SocketAddr, SocketAddr, u32) -> Result<(), Failure>,
) -> Result<Samples, Failure> {
    let (commands, status) = (TcpListener::bind("127.0.0.1:0")?, TcpListener::bind("127.0.0.1:0")?);
    let addresses = (commands.local_addr()?, status.local_addr()?);
    let (arrived, arrivals) = mpsc::channel();
    let answering = thread::spawn(move || answer(commands.accept()?.0, &arrived));
    let witness = thread::spawn(move || watch(status.accept()?.0, &arrivals, trips));
    let outcome = program(addresses.0, addresses.1, trips);
    // A program whose witness has failed sees a lost connection.
    let samples = witness.join().map_err(|_| "the witness panicked")??;
    outcome?;
    answering.join().map_err(|_| "the controller panicked")??;
    Ok(samples)
}

/// One thread that reads packets and writes the stop, with nothing between: what the machine can do.
fn bare(commands: SocketAddr, status: SocketAddr, trips: u32) -> Result<(), Failure> {
    let (mut commands, mut status) = (TcpStream::connect(commands)?, TcpStream::connect(status)?);
    commands.set_nodelay(true)?;
    let (mut chunk, mut done, mut is_moving) = (vec![0; 4096], 0, false);
    while done < trips {
        let len = status.read(&mut chunk)?;
        let text = String::from_utf8_lossy(&chunk[..len]);
        if is_moving && text.contains("\"din\": [1]") {
            commands.write_all(br#"{"cmdName":"stop_program"}"#)?;
            (done, is_moving) = (done + 1, false);
        } else if !is_moving && text.contains("\"inpos\": true") {
            commands.write_all(br#"{"cmdName":"joint_move"}"#)?;
            is_moving = true;
        }
    }
    Ok(())
}

/// A motion of a robot under a guard, with an observer of the program's own that takes a time for each packet.
fn guarded(commands: SocketAddr, status: SocketAddr, trips: u32, observer: Duration) -> Result<(), Failure> {
    let (client, monitor) = (Client::connect(commands)?, Monitor::connect(status)?);
    monitor.observe(move |_| {
        thread::sleep(observer);
        ControlFlow::Continue(())
    });
    let mut robot = Robot::new(client, monitor).expect("it is the only robot");
    let motion = JointMove::absolute([10.0; 6], 10.0);
    for _ in 0..trips {
        // The input stays high for some packets, at the start of the next motion as well.
        robot.wait_for_input(Numbering::FromZero.cabinet(0).is_low(), Duration::from_secs(5))?;
        robot.run(&motion.guard(Numbering::FromZero.cabinet(0).rises()), Duration::from_secs(5))?.guarded()?;
    }
    Ok(())
}

/// Message that arrived on the command port.
#[derive(PartialEq)]
enum Arrived {
    Motion,
    Stop(Instant),
}

/// Sends packets, and measures the time until the stop after each packet that trips the guard.
fn watch(mut status: TcpStream, arrivals: &Receiver<Arrived>, trips: u32) -> Result<Samples, Failure> {
    status.set_nodelay(true)?;
    let (mut samples, mut moving) = (Samples::default(), None);
    while samples.len() < trips as usize {
        thread::sleep(PERIOD);
        match arrivals.try_recv() {
            Ok(Arrived::Motion) => moving = Some(0),
            Ok(Arrived::Stop(_)) => return Err("a stop came that nothing called for".into()),
            Err(_) => {}
        }
        let Some(packets) = &mut moving else {
            status.write_all(&packet(true, false))?;
            continue;
        };
        *packets += 1;
        if *packets <= BEFORE {
            status.write_all(&packet(false, false))?;
            continue;
        }
        let sent = Instant::now();
        status.write_all(&packet(false, true))?;
        let Arrived::Stop(at) = arrivals.recv()? else { return Err("another motion came, and no stop".into()) };
        samples.push(at.saturating_duration_since(sent));
        moving = None;
    }
    // The program waits for the arm's rest, and closes the connection then.
    while status.write_all(&packet(true, false)).is_ok() {
        thread::sleep(PERIOD);
    }
    Ok(samples)
}

fn packet(in_position: bool, input: bool) -> Vec<u8> {
    let (input, flags) = (u8::from(input), "\"emergency_stop\": 0, \"protective_stop\": 0, \"powered_on\": 1");
    format!("{{\"len\": 120, {flags}, \"enabled\": true, \"inpos\": {in_position}, \"din\": [{input}]}}").into_bytes()
}

/// Accepts each request, and says when a motion or a stop has come.
fn answer(mut commands: TcpStream, arrived: &Sender<Arrived>) -> Result<(), Failure> {
    commands.set_nodelay(true)?;
    let (mut bytes, mut chunk) = (Vec::new(), vec![0; 4096]);
    loop {
        // A program that leaves without reading all replies resets the connection.
        let len = match commands.read(&mut chunk) {
            Err(error) if error.kind() == ErrorKind::ConnectionReset => 0,
            read => read?,
        };
        let now = Instant::now();
        if len == 0 {
            return Ok(());
        }
        bytes.extend_from_slice(&chunk[..len]);
        // The requests hold no objects.
        while let Some(end) = bytes.iter().position(|byte| *byte == b'}') {
            let request = String::from_utf8(bytes.drain(..=end).collect())?;
            let name = request.split('"').nth(3).ok_or("a request names no command")?;
            let more = if name == "get_joint_pos" { ",\"joint_pos\":[0,0,0,0,0,0]" } else { "" };
            // The witness has left after the last stop.
            match name {
                "stop_program" => drop(arrived.send(Arrived::Stop(now))),
                "joint_move" => drop(arrived.send(Arrived::Motion)),
                _ => {}
            }
            write!(commands, "{{\"errorCode\":\"0\",\"errorMsg\":\"\",\"cmdName\":\"{name}\"{more}}}")?;
        }
    }
}
