//! One reader of status packets.

use std::collections::VecDeque;
use std::io;
use std::mem;
use std::ops::ControlFlow;
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use super::packet_writer::{PacketWriter, period};
use super::recorded_packets::{RecordedPackets, RecordedStep};
use crate::link::{Links, Wire};
use crate::lock::lock;
use crate::replay::ReplaySession;
use crate::socket::Socket;
use crate::time::{Signal, Time};
use crate::{Port, StatusFault};

/// How long a write may take. The connection holds packets of many seconds.
const WRITE_TIMEOUT: Duration = Duration::from_secs(1);

/// One reader, which is sent a packet each period and messages in between.
#[derive(Debug)]
pub(crate) struct Reader {
    wire: Arc<Wire>,
    outbox: Mutex<Outbox>,
    changed: Signal,
    time: Time,
}

#[derive(Debug, Default)]
struct Outbox {
    /// What is wrong from now on.
    fault: Option<StatusFault>,
    /// What is to be written. Each caller that posts a message waits for it, so there are never many.
    messages: VecDeque<Message>,
    posted: u64,
    written: u64,
    rescheduled: bool,
    closed: bool,
}

/// What is to be written between the periodic packets.
#[derive(Debug, Clone)]
pub(super) enum Message {
    /// A packet, with what is wrong with packets.
    Packet(Arc<[u8]>),
    /// Bytes, which are written as they are.
    Bytes(Arc<[u8]>),
}

enum Job {
    Fault(StatusFault),
    Message(Message),
    Packet,
    /// The time of the next packet may have changed.
    Reschedule,
    End,
}

impl Reader {
    pub(super) fn new(mut socket: Socket, links: &Arc<Links>, fault: StatusFault) -> io::Result<Self> {
        socket.set_write_timeout(WRITE_TIMEOUT)?;
        let wire = Wire::new(socket, Port::Status, links)?;
        let outbox = Outbox { fault: Some(fault), ..Outbox::default() };
        let (changed, time) = (Signal::new(links.time()), links.time().clone());
        Ok(Self { wire, outbox: Mutex::new(outbox), changed, time })
    }

    /// Writes a packet at once, and then one each period if a period is given, until the connection ends.
    pub(crate) fn run(&self, period: Option<Duration>, packet: impl Fn() -> Vec<u8>) {
        self.end(self.write(period, packet));
    }

    /// Writes the packets of a recording, until it or the connection ends.
    pub(crate) fn replay(&self, packets: RecordedPackets, session: &ReplaySession) {
        self.end(self.write_recorded(packets, session));
    }

    fn end(&self, written: io::Result<()>) {
        if let Err(error) = written {
            log::trace!(target: "jaka_sim", "status reader lost: {error}");
        }
        self.close();
    }

    fn write_recorded(&self, mut packets: RecordedPackets, session: &ReplaySession) -> io::Result<()> {
        let mut writer = self.first_outlet();
        loop {
            match self.next_job(packets.due(session)) {
                Job::Packet => match packets.take() {
                    Some(RecordedStep::Packet(packet)) => writer.send_packet(&packet)?,
                    Some(RecordedStep::End) => return Ok(()),
                    None => {}
                },
                job => {
                    if self.do_job(job, &mut writer)?.is_break() {
                        return Ok(());
                    }
                }
            }
        }
    }

    fn first_outlet(&self) -> PacketWriter<'_> {
        let fault = lock(&self.outbox).fault.take();
        PacketWriter::new(&self.wire, fault.unwrap_or_default())
    }

    /// Does a job other than the periodic packet.
    fn do_job<'s>(&'s self, job: Job, writer: &mut PacketWriter<'s>) -> io::Result<ControlFlow<()>> {
        match job {
            Job::Fault(fault) => *writer = PacketWriter::new(&self.wire, fault),
            Job::Message(message) => {
                match message {
                    Message::Packet(packet) => writer.send_packet(&packet)?,
                    Message::Bytes(bytes) => writer.send(&bytes)?,
                }
                lock(&self.outbox).written += 1;
                self.changed.notify_all();
            }
            Job::Packet | Job::Reschedule => {}
            Job::End => return Ok(ControlFlow::Break(())),
        }
        Ok(ControlFlow::Continue(()))
    }

    fn write(&self, usual: Option<Duration>, packet: impl Fn() -> Vec<u8>) -> io::Result<()> {
        let mut writer = self.first_outlet();
        writer.send_packet(&packet())?;
        let mut last = self.time.now();
        loop {
            let period = usual.map(|usual| period(writer.fault(), usual));
            let due = period.and_then(|period| last.checked_add(period));
            match self.next_job(due) {
                Job::Packet => {
                    writer.send_packet(&packet())?;
                    // One period after the last was due, unless that time has passed.
                    last = due.filter(|due| Some(self.time.since(*due)) < period).unwrap_or_else(|| self.time.now());
                }
                job => {
                    if self.do_job(job, &mut writer)?.is_break() {
                        return Ok(());
                    }
                }
            }
        }
    }

    fn next_job(&self, due: Option<Instant>) -> Job {
        let left = due.map_or(Duration::MAX, |due| self.time.until(due));
        let ready = |outbox: &Outbox| {
            outbox.closed || outbox.rescheduled || outbox.fault.is_some() || !outbox.messages.is_empty()
        };
        let mut outbox = self.changed.wait(&self.outbox, left, ready);
        if outbox.closed {
            return Job::End;
        }
        if let Some(fault) = outbox.fault.take() {
            return Job::Fault(fault);
        }
        if mem::take(&mut outbox.rescheduled) {
            return Job::Reschedule;
        }
        outbox.messages.pop_front().map_or(Job::Packet, Job::Message)
    }

    /// Has the thread compute again when the next packet is due.
    pub(super) fn reschedule(&self) {
        lock(&self.outbox).rescheduled = true;
        self.changed.notify_all();
    }

    /// Sets what is wrong with the packets from now on.
    pub(super) fn set_fault(&self, fault: StatusFault) {
        lock(&self.outbox).fault = Some(fault);
        self.changed.notify_all();
    }

    /// Has something written, and gives its number to wait for.
    pub(super) fn post(&self, message: Message) -> u64 {
        let mut outbox = lock(&self.outbox);
        if !outbox.closed {
            outbox.messages.push_back(message);
        }
        outbox.posted += 1;
        self.changed.notify_all();
        outbox.posted
    }

    /// Waits until the bytes with this number are written, or never will be.
    pub(super) fn wait_for(&self, number: u64) {
        let done = |outbox: &Outbox| outbox.closed || outbox.written >= number;
        drop(self.changed.wait(&self.outbox, Duration::MAX, done));
    }

    /// Ends the connection, as its link lets it, and wakes the thread.
    pub(super) fn close(&self) {
        let mut outbox = lock(&self.outbox);
        outbox.closed = true;
        outbox.messages.clear();
        self.changed.notify_all();
        drop(outbox);
        self.wire.close();
    }
}
