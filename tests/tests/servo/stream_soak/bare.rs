//! Loops that do nothing but write set-points in time.

use std::io::{Read, Write};
use std::net::{TcpListener, TcpStream};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

/// Bytes of the length of a `servo_j` command.
const SET_POINT: [u8; 180] = [b' '; 180];

pub(super) struct BareLoops(Vec<JoinHandle<(u64, f64)>>);

impl BareLoops {
    pub(super) fn start(count: u32, period: Duration, over: &Arc<AtomicBool>) -> Self {
        let listener = TcpListener::bind(("127.0.0.1", 0)).expect("loopback has free ports");
        let address = listener.local_addr().expect("it listens");
        let start = |_| {
            let writer = TcpStream::connect(address).expect("it listens");
            let (reader, _) = listener.accept().expect("it was connected");
            thread::spawn(move || drain(reader));
            let over = Arc::clone(over);
            thread::spawn(move || run(writer, period, &over))
        };
        Self((0..count).map(start).collect())
    }

    /// Waits for the loops, and returns the number of set-points that they wrote and of periods without one.
    pub(super) fn join(self) -> (u64, f64) {
        let each = self.0.into_iter().map(|bare| bare.join().expect("it writes"));
        each.fold((0, 0.0), |(written, lost), (more, less)| (written + more, lost + less))
    }
}

/// Sends as a session does: a late cycle delays the following ones.
fn run(mut writer: TcpStream, period: Duration, over: &AtomicBool) -> (u64, f64) {
    writer.set_nodelay(true).expect("a socket");
    let (start, mut due, mut written) = (Instant::now(), Instant::now(), 0_u32);
    while !over.load(Ordering::Relaxed) {
        thread::sleep(due.saturating_duration_since(Instant::now()));
        writer.write_all(&SET_POINT).expect("it is read");
        written += 1;
        let late = due.elapsed();
        due += period + if late >= period { late } else { Duration::ZERO };
    }
    (written.into(), start.elapsed().as_secs_f64() / period.as_secs_f64() - f64::from(written))
}

fn drain(mut reader: TcpStream) {
    let mut bytes = [0; 4096];
    while let Ok(1..) = reader.read(&mut bytes) {}
}
