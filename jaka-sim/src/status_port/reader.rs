//! One reader of status packets.

use std::collections::VecDeque;
use std::io::{self, Write};
use std::net::{Shutdown, TcpStream};
use std::sync::{Arc, Condvar, Mutex};
use std::time::{Duration, Instant};

use crate::lock::{lock, wait};

/// How long the connection of a reader may be full. It holds packets of many seconds.
const PATIENCE: Duration = Duration::from_secs(1);

/// The least time between two packets.
const LEAST_PERIOD: Duration = Duration::from_millis(1);

/// One reader, who gets packets in time and letters in between.
#[derive(Debug)]
pub(super) struct Reader {
    stream: TcpStream,
    mail: Mutex<Mail>,
    changed: Condvar,
}

#[derive(Debug, Default)]
struct Mail {
    /// What is to be written. Whoever posts a letter waits for it, so there are never many.
    letters: VecDeque<Arc<[u8]>>,
    posted: u64,
    written: u64,
    closed: bool,
}

enum Job {
    Letter(Arc<[u8]>),
    Packet,
    End,
}

impl Reader {
    pub(super) fn new(stream: TcpStream) -> io::Result<Self> {
        stream.set_nodelay(true)?;
        stream.set_write_timeout(Some(PATIENCE))?;
        Ok(Self { stream, mail: Mutex::default(), changed: Condvar::new() })
    }

    /// Writes a packet at once, and then one each period, until the connection ends.
    pub(super) fn run(&self, period: Duration, packet: impl Fn() -> Vec<u8>) {
        if let Err(error) = self.write(period.max(LEAST_PERIOD), packet) {
            log::trace!(target: "jaka_sim", "status reader lost: {error}");
        }
        self.close();
    }

    fn write(&self, period: Duration, packet: impl Fn() -> Vec<u8>) -> io::Result<()> {
        (&self.stream).write_all(&packet())?;
        let mut due = Instant::now().checked_add(period);
        loop {
            match self.next_job(due) {
                Job::Letter(letter) => {
                    (&self.stream).write_all(&letter)?;
                    lock(&self.mail).written += 1;
                    self.changed.notify_all();
                }
                Job::Packet => {
                    (&self.stream).write_all(&packet())?;
                    due = Instant::now().checked_add(period);
                }
                Job::End => return Ok(()),
            }
        }
    }

    fn next_job(&self, due: Option<Instant>) -> Job {
        let left = due.map_or(Duration::MAX, |due| due.saturating_duration_since(Instant::now()));
        let ready = |mail: &Mail| mail.closed || !mail.letters.is_empty();
        let mut mail = wait(&self.changed, lock(&self.mail), left, ready);
        if mail.closed {
            return Job::End;
        }
        mail.letters.pop_front().map_or(Job::Packet, Job::Letter)
    }

    /// Has bytes written, and gives their number to wait for.
    pub(super) fn post(&self, letter: Arc<[u8]>) -> u64 {
        let mut mail = lock(&self.mail);
        if !mail.closed {
            mail.letters.push_back(letter);
        }
        mail.posted += 1;
        self.changed.notify_all();
        mail.posted
    }

    /// Waits until the bytes with this number are written, or never will be.
    pub(super) fn wait_for(&self, number: u64) {
        let done = |mail: &Mail| mail.closed || mail.written >= number;
        drop(wait(&self.changed, lock(&self.mail), Duration::MAX, done));
    }

    /// Ends the connection, and wakes the thread.
    pub(super) fn close(&self) {
        let mut mail = lock(&self.mail);
        mail.closed = true;
        mail.letters.clear();
        self.changed.notify_all();
        // An error says that it has ended already.
        self.stream.shutdown(Shutdown::Both).ok();
    }
}
