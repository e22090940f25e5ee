//! One reader of status packets.

use std::collections::VecDeque;
use std::io;
use std::mem;
use std::net::TcpStream;
use std::ops::ControlFlow;
use std::sync::{Arc, Condvar, Mutex};
use std::time::{Duration, Instant};

use super::outlet::{Outlet, period};
use super::replayed::{Packets, Turn};
use crate::link::{Links, Wire};
use crate::lock::{lock, wait};
use crate::replay::Stage;
use crate::{Port, StatusFault};

/// How long the connection of a reader may be full. It holds packets of many seconds.
const PATIENCE: Duration = Duration::from_secs(1);

/// One reader, who gets packets in time and letters in between.
#[derive(Debug)]
pub(super) struct Reader {
    wire: Arc<Wire>,
    mail: Mutex<Mail>,
    changed: Condvar,
}

#[derive(Debug, Default)]
struct Mail {
    /// What is wrong from now on.
    fault: Option<StatusFault>,
    /// What is to be written. Whoever posts a letter waits for it, so there are never many.
    letters: VecDeque<Letter>,
    posted: u64,
    written: u64,
    woken: bool,
    closed: bool,
}

/// What is to be written out of turn.
#[derive(Debug, Clone)]
pub(super) enum Letter {
    /// A packet, with what is wrong with packets.
    Packet(Arc<[u8]>),
    /// Bytes, which are written as they are.
    Bytes(Arc<[u8]>),
}

enum Job {
    Fault(StatusFault),
    Letter(Letter),
    Packet,
    /// The time of the next packet may have changed.
    LookAnew,
    End,
}

impl Reader {
    pub(super) fn new(stream: TcpStream, links: &Arc<Links>, fault: StatusFault) -> io::Result<Self> {
        stream.set_write_timeout(Some(PATIENCE))?;
        let wire = Wire::new(stream, Port::Status, links)?;
        let mail = Mail { fault: Some(fault), ..Mail::default() };
        Ok(Self { wire, mail: Mutex::new(mail), changed: Condvar::new() })
    }

    /// Writes a packet at once, and then one each period, if there is one, until the connection ends.
    pub(super) fn run(&self, period: Option<Duration>, packet: impl Fn() -> Vec<u8>) {
        self.end(self.write(period, packet));
    }

    /// Writes the packets of a recording, until it or the connection ends.
    pub(super) fn replay(&self, packets: Packets, stage: &Stage) {
        self.end(self.write_recorded(packets, stage));
    }

    fn end(&self, written: io::Result<()>) {
        if let Err(error) = written {
            log::trace!(target: "jaka_sim", "status reader lost: {error}");
        }
        self.close();
    }

    fn write_recorded(&self, mut packets: Packets, stage: &Stage) -> io::Result<()> {
        let mut outlet = self.first_outlet();
        loop {
            match self.next_job(packets.due(stage)) {
                Job::Packet => match packets.take() {
                    Some(Turn::Packet(packet)) => outlet.send_packet(&packet)?,
                    Some(Turn::End) => return Ok(()),
                    None => {}
                },
                job => {
                    if self.do_job(job, &mut outlet)?.is_break() {
                        return Ok(());
                    }
                }
            }
        }
    }

    fn first_outlet(&self) -> Outlet<'_> {
        let fault = lock(&self.mail).fault.take();
        Outlet::new(&self.wire, fault.unwrap_or_default())
    }

    /// Does what is not a packet in its turn.
    fn do_job<'s>(&'s self, job: Job, outlet: &mut Outlet<'s>) -> io::Result<ControlFlow<()>> {
        match job {
            Job::Fault(fault) => *outlet = Outlet::new(&self.wire, fault),
            Job::Letter(letter) => {
                match letter {
                    Letter::Packet(packet) => outlet.send_packet(&packet)?,
                    Letter::Bytes(bytes) => outlet.send(&bytes)?,
                }
                lock(&self.mail).written += 1;
                self.changed.notify_all();
            }
            Job::Packet | Job::LookAnew => {}
            Job::End => return Ok(ControlFlow::Break(())),
        }
        Ok(ControlFlow::Continue(()))
    }

    fn write(&self, usual: Option<Duration>, packet: impl Fn() -> Vec<u8>) -> io::Result<()> {
        let mut outlet = self.first_outlet();
        outlet.send_packet(&packet())?;
        let mut last = Instant::now();
        loop {
            let period = usual.map(|usual| period(outlet.fault(), usual));
            let due = period.and_then(|period| last.checked_add(period));
            match self.next_job(due) {
                Job::Packet => {
                    outlet.send_packet(&packet())?;
                    // By the beat, unless it has been missed.
                    last = due.filter(|due| Some(due.elapsed()) < period).unwrap_or_else(Instant::now);
                }
                job => {
                    if self.do_job(job, &mut outlet)?.is_break() {
                        return Ok(());
                    }
                }
            }
        }
    }

    fn next_job(&self, due: Option<Instant>) -> Job {
        let left = due.map_or(Duration::MAX, |due| due.saturating_duration_since(Instant::now()));
        let ready = |mail: &Mail| mail.closed || mail.woken || mail.fault.is_some() || !mail.letters.is_empty();
        let mut mail = wait(&self.changed, lock(&self.mail), left, ready);
        if mail.closed {
            return Job::End;
        }
        if let Some(fault) = mail.fault.take() {
            return Job::Fault(fault);
        }
        if mem::take(&mut mail.woken) {
            return Job::LookAnew;
        }
        mail.letters.pop_front().map_or(Job::Packet, Job::Letter)
    }

    /// Has the time of the next packet looked at anew.
    pub(super) fn wake(&self) {
        lock(&self.mail).woken = true;
        self.changed.notify_all();
    }

    /// Sets what is wrong with the packets from now on.
    pub(super) fn set_fault(&self, fault: StatusFault) {
        lock(&self.mail).fault = Some(fault);
        self.changed.notify_all();
    }

    /// Has something written, and gives its number to wait for.
    pub(super) fn post(&self, letter: Letter) -> u64 {
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

    /// Ends the connection, as its link lets it, and wakes the thread.
    pub(super) fn close(&self) {
        let mut mail = lock(&self.mail);
        mail.closed = true;
        mail.letters.clear();
        self.changed.notify_all();
        drop(mail);
        self.wire.close();
    }
}
