//! Time from the call of a stop to the wire while a program sends as much as it can, or moves the arm by set-points.
//! The witness is a plain socket that knows nothing of this SDK. It reports the arrival of the bytes of `stop_program`,
//! or of the first set-point that is shorter than the one before it.
//!
//! Option: `--stops N`, 2000 by default.

use std::error::Error;
use std::io::{Read, Write};
use std::net::{TcpListener, TcpStream};
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, Receiver, Sender};
use std::thread;
use std::time::{Duration, Instant};

use jaka_benches::system::figures::{Contender, Samples};
use jaka_benches::system::{options, report};
use jaka_robot::{Robot, ServoConfig};
use jaka_sync::io::SetDigitalOutput;
use jaka_sync::power::GetVersion;
use jaka_sync::types::Switch;
use jaka_sync::{Client, Command, Monitor};
use serde_json::Value;

type Failure = Box<dyn Error + Send + Sync>;
type ClientError = jaka_sync::Error;

/// Number of commands in the long pipeline.
const COMMANDS: usize = 100_000;

/// Between one stop and the next.
const PAUSE: Duration = Duration::from_millis(1);

/// The bound at the 99th percentile, in milliseconds.
const BOUND: f64 = 20.0;

/// Work of a program during the stops, until the flag tells it to end.
type Load = fn(&mut Client, &AtomicBool) -> Result<(), ClientError>;

const LOADS: [(&str, Load); 5] = [
    ("nothing else", |_, _| Ok(())),
    ("one call after the other", calls),
    ("a pipeline of 100,000 commands", long_pipeline),
    ("pipelines that are dropped", dropped_pipelines),
    ("replies that are odd", odd_replies),
];

/// Robots that take packets at 1 kHz, each with the time that the program's observer takes for each packet.
const OBSERVERS: [(&str, Duration); 2] =
    [("a robot, packets at 1 kHz", Duration::ZERO), ("the same, observer of 5 ms", Duration::from_millis(5))];

/// Most stops of a session, each of which takes 2 s.
const IN_SESSION: u32 = 60;

/// Step of a session's set-points, in degrees each 8 ms.
const STEP: f64 = 0.1;

/// Growth of the first steps, in degrees: 70 deg/s².
const GAIN: f64 = 0.0045;

const PACKET: &[u8] =
    br#"{"len": 120, "emergency_stop": 0, "protective_stop": 0, "powered_on": 1, "enabled": true, "inpos": false}"#;

/// Replies of the peer without a valid version: half a surrogate pair, a value that is no number, and bytes that are no
/// UTF-8.
const ODD: [&[u8]; 3] = [
    br#"{"errorCode":"2","errorMsg":"call \ud83d failed","cmdName":"get_version"}"#,
    br#"{"errorCode":"0","errorMsg":"","version":NaN,"cmdName":"get_version"}"#,
    b"{\"errorCode\":\"2\",\"errorMsg\":\"\xcd\xa3\xd6\xb9\",\"cmdName\":\"get_version\"}",
];

fn main() -> Result<(), Box<dyn Error>> {
    let stops = options::number("--stops", 2000)?;
    report::title("Stops on the wire, loopback", format_args!("{stops} stops with each load"));
    let mut contenders = Vec::new();
    for (name, load) in LOADS {
        let samples = measure(stops, load).map_err(|failure| failure.to_string())?;
        let mut contender = Contender::new(name, |_| Ok(()));
        contender.samples = samples;
        contenders.push(contender);
    }
    for (name, observer) in OBSERVERS {
        let mut contender = Contender::new(name, |_| Ok(()));
        contender.samples = beside_packets(stops, observer).map_err(|failure| failure.to_string())?;
        contenders.push(contender);
    }
    let mut session = Contender::new("a session that moves the arm", |_| Ok(()));
    session.samples = in_session(stops.min(IN_SESSION)).map_err(|failure| failure.to_string())?;
    contenders.push(session);
    report::percentiles(&contenders);
    for Contender { name, samples, .. } in &contenders {
        report::verdict(&format!("{name}, p99, ms"), samples.percentile(0.99) / 1000.0, BOUND);
    }
    Ok(())
}

/// Measures the time from the call of a stop to the wire under a load.
fn measure(stops: u32, load: Load) -> Result<Samples, Failure> {
    let listener = TcpListener::bind("127.0.0.1:0")?;
    let mut client = Client::connect(listener.local_addr()?)?;
    let (arrived, arrivals) = mpsc::channel();
    let (peer, _) = listener.accept()?;
    let witness = thread::spawn(move || watch(peer, &arrived));
    let (stop, ended) = (client.stop_handle(), AtomicBool::new(false));
    let samples = thread::scope(|scope| {
        let loading = scope.spawn(|| {
            while !ended.load(Ordering::SeqCst) {
                load(&mut client, &ended)?;
                thread::yield_now();
            }
            Ok::<(), ClientError>(())
        });
        let samples = times(stops, || stop.stop(), &arrivals);
        ended.store(true, Ordering::SeqCst);
        loading.join().map_err(|_| "the load panicked")??;
        samples
    });
    drop(client);
    witness.join().map_err(|_| "the witness panicked")??;
    samples
}

/// Times of the stops of a robot that takes packets at 1 kHz, with a program's observer that takes a time for each.
fn beside_packets(stops: u32, observer: Duration) -> Result<Samples, Failure> {
    with_robot(Duration::from_millis(1), watch, |robot, arrivals| {
        robot.monitor().observe(move |_| {
            thread::sleep(observer);
            ControlFlow::Continue(())
        });
        let stop = robot.stop_handle();
        times(stops, || stop.stop(), arrivals)
    })
}

/// Times of the stops of a session whose set-points move all joints at one speed. Each begins at another moment of the
/// period.
fn in_session(stops: u32) -> Result<Samples, Failure> {
    with_robot(Duration::from_millis(8), watch_session, |mut robot, arrivals| {
        let (stop, mut samples) = (robot.stop_handle(), Samples::default());
        for number in 0..stops {
            robot.acknowledge();
            let mut session = robot.enter_servo_mode(ServoConfig::new())?;
            let moment = Duration::from_micros(100_000 + u64::from(number) * 1700 % 8000);
            let called = thread::scope(|scope| {
                let stopping = scope.spawn(|| {
                    thread::sleep(moment);
                    let called = Instant::now();
                    stop.stop().map(|()| called)
                });
                let offsets = (1..).map(|cycle| [(f64::from(cycle) * GAIN).min(STEP); 6]);
                let mut ends = offsets.filter_map(|offset| session.send_joint_offset(offset).err());
                ends.next();
                // Brakes. Its errors are the stop, and the rest that these packets do not show.
                drop(session.land());
                stopping.join().map_err(|_| "the stop panicked")
            })??;
            samples.push(arrivals.recv()?.saturating_duration_since(called));
        }
        Ok(samples)
    })
}

/// Gives `act` a robot whose requests `witness` gets, and that takes a packet each period.
fn with_robot(
    period: Duration,
    witness: fn(TcpStream, &Sender<Instant>) -> Result<(), Failure>,
    act: impl FnOnce(Robot, &Receiver<Instant>) -> Result<Samples, Failure>,
) -> Result<Samples, Failure> {
    let (commands, status) = (TcpListener::bind("127.0.0.1:0")?, TcpListener::bind("127.0.0.1:0")?);
    let (client, monitor) = (Client::connect(commands.local_addr()?)?, Monitor::connect(status.local_addr()?)?);
    let (arrived, arrivals) = mpsc::channel();
    let (peer, mut packets) = (commands.accept()?.0, status.accept()?.0);
    packets.set_nodelay(true)?;
    let witness = thread::spawn(move || witness(peer, &arrived));
    let sending = thread::spawn(move || {
        while packets.write_all(PACKET).is_ok() {
            thread::sleep(period);
        }
    });
    let samples = act(Robot::new(client, monitor).expect("it is the only robot"), &arrivals);
    sending.join().map_err(|_| "the packets' thread panicked")?;
    witness.join().map_err(|_| "the witness panicked")??;
    samples
}

fn times<E: Error + Send + Sync + 'static>(
    stops: u32,
    stop: impl Fn() -> Result<(), E>,
    arrivals: &Receiver<Instant>,
) -> Result<Samples, Failure> {
    let mut samples = Samples::default();
    for _ in 0..stops {
        let called = Instant::now();
        stop()?;
        samples.push(arrivals.recv()?.saturating_duration_since(called));
        thread::sleep(PAUSE);
    }
    Ok(samples)
}

/// Accepts each request, and says when a stop has come.
fn watch(mut peer: TcpStream, arrived: &Sender<Instant>) -> Result<(), Failure> {
    peer.set_nodelay(true)?;
    let (mut bytes, mut chunk, mut replies, mut odd) = (Vec::new(), vec![0; 64 << 10], Vec::new(), 0);
    loop {
        let len = peer.read(&mut chunk)?;
        let now = Instant::now();
        if len == 0 {
            return Ok(());
        }
        bytes.extend_from_slice(&chunk[..len]);
        replies.clear();
        // The requests hold no objects.
        while let Some(end) = bytes.iter().position(|byte| *byte == b'}') {
            let request = String::from_utf8(bytes.drain(..=end).collect())?;
            let name = request.split('"').nth(3).ok_or("a request names no command")?;
            if name == "stop_program" {
                arrived.send(now)?;
            }
            if name == GetVersion::INFO.name {
                replies.extend_from_slice(ODD[odd % ODD.len()]);
                odd += 1;
                continue;
            }
            write!(replies, "{{\"errorCode\":\"0\",\"errorMsg\":\"\",\"cmdName\":\"{name}\"}}")?;
        }
        peer.write_all(&replies)?;
    }
}

/// Accepts each request, and says when a session's first set-point has come that is shorter than the others, or the
/// stop if there was none.
fn watch_session(mut peer: TcpStream, arrived: &Sender<Instant>) -> Result<(), Failure> {
    peer.set_nodelay(true)?;
    let (mut bytes, mut chunk) = (Vec::new(), vec![0; 4096]);
    let (mut joint, mut last, mut is_ending, mut is_in_servo_mode) = (0.0, 0.0, false, false);
    loop {
        // A program that leaves without reading all replies resets the connection.
        let len = peer.read(&mut chunk).unwrap_or(0);
        let now = Instant::now();
        if len == 0 {
            return Ok(());
        }
        bytes.extend_from_slice(&chunk[..len]);
        while let Some(end) = bytes.iter().position(|byte| *byte == b'}') {
            let request: Value = serde_json::from_slice(&bytes.drain(..=end).collect::<Vec<_>>())?;
            let name = request["cmdName"].as_str().ok_or("a request names no command")?;
            let mut more = String::new();
            match name {
                "servo_j" => {
                    let step = request["jointPosition"][0].as_f64().ok_or("a set-point has no joints")?;
                    if step < last && !is_ending {
                        arrived.send(now)?;
                        is_ending = true;
                    }
                    (joint, last) = (joint + step, step);
                }
                "stop_program" if !is_ending => {
                    arrived.send(now)?;
                    is_ending = true;
                }
                "servo_move" => {
                    is_in_servo_mode = request["relFlag"] == 1;
                    if is_in_servo_mode {
                        (last, is_ending) = (0.0, false);
                    }
                }
                "is_in_servomove" => more = format!(",\"in_servomove\":{is_in_servo_mode}"),
                "get_joint_pos" => more = format!(",\"joint_pos\":{:?}", [joint; 6]),
                _ => {}
            }
            write!(peer, "{{\"errorCode\":\"0\",\"errorMsg\":\"\",\"cmdName\":\"{name}\"{more}}}")?;
        }
    }
}

fn output(number: usize) -> SetDigitalOutput {
    let index = i64::try_from(number % 8).unwrap_or_default();
    SetDigitalOutput::cabinet(index, Switch::On)
}

fn calls(client: &mut Client, ended: &AtomicBool) -> Result<(), ClientError> {
    (0..1000)
        .filter(|_| !ended.load(Ordering::SeqCst))
        .try_for_each(|number| client.set_digital_output(&output(number)))
}

/// None of these replies breaks the connection.
fn odd_replies(client: &mut Client, ended: &AtomicBool) -> Result<(), ClientError> {
    let answered = |client: &mut Client| match client.get_version() {
        Err(error) if error.is_disconnected() => Err(error),
        // Refused, or a reply that does not fit.
        _ => Ok(()),
    };
    (0..1000).filter(|_| !ended.load(Ordering::SeqCst)).try_for_each(|_| answered(client))
}

fn long_pipeline(client: &mut Client, ended: &AtomicBool) -> Result<(), ClientError> {
    let outputs: Vec<_> = (0..COMMANDS).map(output).collect();
    let mut pipeline = client.pipeline(COMMANDS);
    for some in outputs.chunks(COMMANDS / 10) {
        if ended.load(Ordering::SeqCst) {
            break;
        }
        pipeline.send_all(some)?;
    }
    pipeline.finish().map(drop)
}

fn dropped_pipelines(client: &mut Client, ended: &AtomicBool) -> Result<(), ClientError> {
    for _ in 0..1000 {
        if ended.load(Ordering::SeqCst) {
            break;
        }
        let mut pipeline = client.pipeline(8);
        (0..9).try_for_each(|number| pipeline.send(&output(number)))?;
    }
    Ok(())
}
