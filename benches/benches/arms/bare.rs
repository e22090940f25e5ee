//! An arm as a hand-written program has it that knows no more than what to write and when: one thread sleeps to
//! absolute times, writes and reads what is there; another reads status packets. Nothing is decoded.

use std::io::{self, ErrorKind, Read, Write};
use std::net::{Shutdown, TcpStream};
use std::sync::Barrier;
use std::thread;
use std::time::{Duration, Instant};

use jaka_benches::system::canned::SET_POINT;
use jaka_benches::system::child::Addresses;

use super::Tally;
use super::session::PERIOD;

const SERVO_ON: &[u8] = br#"{"cmdName":"servo_move","relFlag":1}"#;
const SERVO_OFF: &[u8] = br#"{"cmdName":"servo_move","relFlag":0}"#;

pub(crate) fn run(robot: Addresses, offset: Duration, time: Duration, stages: &[Barrier; 3]) -> Result<Tally, String> {
    let connected = connect(robot);
    stages[0].wait();
    thread::sleep(offset);
    let ran = connected.and_then(|(commands, status)| servo(commands, time).map(|tally| (tally, status)));
    stages[1].wait();
    stages[2].wait();
    let (mut tally, (status, reader)) = ran.map_err(|error| error.to_string())?;
    // An error says that it is closed already.
    let _ = status.shutdown(Shutdown::Both);
    tally.packets = reader.join().map_err(|_| "the status thread panicked")?;
    Ok(tally)
}

type Status = (TcpStream, thread::JoinHandle<u64>);

fn connect(robot: Addresses) -> io::Result<(TcpStream, Status)> {
    let commands = TcpStream::connect(robot.commands)?;
    commands.set_nodelay(true)?;
    let status = TcpStream::connect(robot.status)?;
    let mut theirs = status.try_clone()?;
    let reader = thread::spawn(move || {
        let mut buffer = vec![0; 8 << 10];
        let mut packets = 0;
        // A packet ends with its last brace; nearly each read ends with one.
        while let Some(len) = theirs.read(&mut buffer).ok().filter(|len| *len > 0) {
            packets += u64::from(buffer[len - 1] == b'}');
        }
        packets
    });
    Ok((commands, (status, reader)))
}

fn servo(mut stream: TcpStream, time: Duration) -> io::Result<Tally> {
    let mut buffer = vec![0; 8 << 10];
    switch(&mut stream, SERVO_ON)?;
    stream.set_nonblocking(true)?;
    let (mut tally, mut cycle, mut answers) = (Tally::default(), 0, 0);
    let start = Instant::now();
    while PERIOD * cycle < time {
        answers += arrived(&mut stream, &mut buffer)?;
        let due = start + PERIOD * cycle;
        thread::sleep(due.saturating_duration_since(Instant::now()));
        let late = due.elapsed();
        stream.write_all(SET_POINT)?;
        let missed = u32::try_from(late.as_nanos() / PERIOD.as_nanos()).unwrap_or(0);
        tally.cycles += 1;
        tally.lost += u64::from(missed);
        tally.late += u64::from(late > PERIOD / 2);
        cycle += 1 + missed;
    }
    thread::sleep(PERIOD);
    answers += arrived(&mut stream, &mut buffer)?;
    tally.answered = answers;
    stream.set_nonblocking(false)?;
    switch(&mut stream, SERVO_OFF)?;
    Ok(tally)
}

/// Switches servo mode, and waits for the end of the reply.
fn switch(stream: &mut TcpStream, request: &[u8]) -> io::Result<()> {
    stream.write_all(request)?;
    let mut byte = [0];
    while byte != *b"}" {
        stream.read_exact(&mut byte)?;
    }
    Ok(())
}

/// Reads what has come, once, and counts the answers in it.
fn arrived(stream: &mut TcpStream, buffer: &mut [u8]) -> io::Result<u64> {
    match stream.read(buffer) {
        Ok(len) => Ok(buffer[..len].iter().map(|byte| u64::from(*byte == b'}')).sum()),
        Err(error) if error.kind() == ErrorKind::WouldBlock => Ok(0),
        Err(error) => Err(error),
    }
}
