//! Reader of status packets.

use std::collections::VecDeque;
use std::io;
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use jaka_clock::{Clock, Signal, Socket, lock};

use super::packet_writer::{PacketWriter, period};
use super::recorded_packets::{RecordedPackets, RecordedStep};
use crate::link::{Links, Wire};
use crate::replay::ReplaySession;
use crate::{Port, StatusFault};

/// Reader that gets a packet each period and messages in between.
#[derive(Debug)]
pub(crate) struct Reader {
    wire: Arc<Wire>,
    /// Fault of the first packets.
    fault: StatusFault,
    outbox: Mutex<Outbox>,
    changed: Signal,
    time: Clock,
}

#[derive(Debug, Default)]
struct Outbox {
    /// Messages to write; never many, since each caller waits for its message.
    messages: VecDeque<Message>,
    posted: u64,
    done: u64,
    closed: bool,
}

/// Message to a reader's thread, which the thread handles between the periodic packets.
#[derive(Debug, Clone)]
pub(super) enum Message {
    /// Sets the fault of all later packets.
    Fault(StatusFault),
    /// Writes a packet with the present fault.
    Packet(Arc<[u8]>),
    /// Writes bytes unchanged.
    Bytes(Arc<[u8]>),
    /// The time of the next packet may have changed.
    Reschedule,
}

enum NextTask {
    Message(Message),
    Packet,
    End,
}

impl Reader {
    pub(super) fn new(socket: Socket, links: &Arc<Links>, fault: StatusFault) -> io::Result<Self> {
        let wire = Wire::new(socket, Port::Status, links)?;
        let (changed, time) = (Signal::new(links.time()), links.time().clone());
        Ok(Self { wire, fault, outbox: Mutex::default(), changed, time })
    }

    /// Writes a packet at once, and then one each period if there is a period, until the connection ends.
    pub(crate) fn run(&self, period: Option<Duration>, packet: impl Fn() -> Vec<u8>) {
        self.end(self.write(period, packet));
    }

    /// Writes the packets of a recording, until the recording or the connection ends.
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
        let mut writer = PacketWriter::new(&self.wire, self.fault.clone());
        loop {
            match self.next(packets.due(session)) {
                NextTask::Packet => match packets.take() {
                    Some(RecordedStep::Packet(packet)) => writer.send_packet(&packet)?,
                    Some(RecordedStep::End) => return Ok(()),
                    None => {}
                },
                NextTask::Message(message) => self.handle(message, &mut writer)?,
                NextTask::End => return Ok(()),
            }
        }
    }

    fn handle<'s>(&'s self, message: Message, writer: &mut PacketWriter<'s>) -> io::Result<()> {
        match message {
            Message::Fault(fault) => *writer = PacketWriter::new(&self.wire, fault),
            Message::Packet(packet) => writer.send_packet(&packet)?,
            Message::Bytes(bytes) => writer.send(&bytes)?,
            Message::Reschedule => {}
        }
        lock(&self.outbox).done += 1;
        self.changed.notify_all();
        Ok(())
    }

    fn write(&self, usual: Option<Duration>, packet: impl Fn() -> Vec<u8>) -> io::Result<()> {
        let mut writer = PacketWriter::new(&self.wire, self.fault.clone());
        writer.send_packet(&packet())?;
        let mut last = self.time.now();
        loop {
            let period = usual.map(|usual| period(writer.fault(), usual));
            let due = period.and_then(|period| last.checked_add(period));
            match self.next(due) {
                NextTask::Packet => {
                    writer.send_packet(&packet())?;
                    // One period after the last due time, unless that time has passed.
                    last = due.filter(|due| Some(self.time.elapsed(*due)) < period).unwrap_or_else(|| self.time.now());
                }
                NextTask::Message(message) => self.handle(message, &mut writer)?,
                NextTask::End => return Ok(()),
            }
        }
    }

    fn next(&self, due: Option<Instant>) -> NextTask {
        let left = due.map_or(Duration::MAX, |due| self.time.left(due));
        let ready = |outbox: &Outbox| outbox.closed || !outbox.messages.is_empty();
        let mut outbox = self.changed.wait_until(&self.outbox, left, ready);
        if outbox.closed {
            return NextTask::End;
        }
        outbox.messages.pop_front().map_or(NextTask::Packet, NextTask::Message)
    }

    /// Posts a message to the thread, and returns its number to wait for.
    pub(super) fn post(&self, message: Message) -> u64 {
        let mut outbox = lock(&self.outbox);
        if !outbox.closed {
            outbox.messages.push_back(message);
        }
        outbox.posted += 1;
        self.changed.notify_all();
        outbox.posted
    }

    /// Waits until the message with this number is done or discarded.
    pub(super) fn wait_for(&self, number: u64) {
        let done = |outbox: &Outbox| outbox.closed || outbox.done >= number;
        drop(self.changed.wait_until(&self.outbox, Duration::MAX, done));
    }

    /// Ends the connection, subject to its link, and wakes the thread.
    pub(super) fn close(&self) {
        let mut outbox = lock(&self.outbox);
        outbox.closed = true;
        outbox.messages.clear();
        self.changed.notify_all();
        drop(outbox);
        self.wire.close();
    }
}
