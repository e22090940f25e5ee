//! Readers of status packets.

mod packet_writer;
mod reader;
mod recorded_packets;

use std::collections::VecDeque;
use std::io;
use std::sync::{Arc, Mutex};
use std::thread::JoinHandle;
use std::time::Duration;

use jaka_clock::{Socket, lock};

use self::reader::Message;
pub(crate) use self::reader::Reader;
pub(crate) use self::recorded_packets::RecordedPackets;
use crate::StatusFault;
use crate::clock;
use crate::link::Links;

/// Greatest number of readers, so that connections cannot use up threads and memory.
const MAX_READERS: usize = 256;

/// List of readers, each with its own thread so that none waits for another.
#[derive(Debug)]
pub(crate) struct Readers {
    list: Arc<Mutex<ReaderList>>,
}

#[derive(Debug)]
struct ReaderList {
    readers: VecDeque<(Arc<Reader>, JoinHandle<()>)>,
    /// Fault of the sent packets.
    fault: StatusFault,
}

impl Readers {
    pub(crate) fn new(fault: StatusFault) -> Self {
        Self { list: Arc::new(Mutex::new(ReaderList { readers: VecDeque::new(), fault })) }
    }

    /// Sets the fault of all later packets.
    pub(crate) fn set_fault(&self, fault: StatusFault) {
        let mut list = lock(&self.list);
        for (reader, _) in &list.readers {
            reader.post(Message::Fault(fault.clone()));
        }
        list.fault = fault;
    }

    /// Returns the period of packets, which is `usual` without a fault.
    pub(crate) fn period(&self, usual: Duration) -> Duration {
        packet_writer::period(&lock(&self.list).fault, usual)
    }

    /// Sends a packet with the present fault to all readers, and waits until each reader has got it or is dropped
    /// because it does not read.
    pub(crate) fn send_packet(&self, packet: Vec<u8>) {
        self.post(&Message::Packet(packet.into()));
    }

    /// Sends bytes unchanged to all readers, and waits as [`send_packet`](Self::send_packet) does.
    pub(crate) fn send(&self, bytes: &[u8]) {
        self.post(&Message::Bytes(bytes.into()));
    }

    fn post(&self, message: &Message) {
        let readers: Vec<_> = lock(&self.list).readers.iter().map(|(reader, _)| Arc::clone(reader)).collect();
        let posted: Vec<_> = readers.iter().map(|reader| reader.post(message.clone())).collect();
        for (reader, number) in readers.iter().zip(posted) {
            reader.wait_for(number);
        }
    }

    /// Lets each thread compute the time of its next packet again.
    pub(crate) fn reschedule(&self) {
        for (reader, _) in &lock(&self.list).readers {
            reader.post(Message::Reschedule);
        }
    }

    /// Closes all connections, and waits for their threads.
    pub(crate) fn close(&self) {
        let readers = std::mem::take(&mut lock(&self.list).readers);
        for (reader, _) in &readers {
            reader.close();
        }
        readers.into_iter().for_each(close);
    }

    /// Adds a reader with a thread that runs this, until it ends.
    ///
    /// Drops the oldest reader if there are too many. The controller notices that a reader has left only when it writes
    /// to it; then it closes the socket.
    pub(crate) fn add(
        &self,
        socket: Socket,
        links: &Arc<Links>,
        run: impl FnOnce(&Reader) + Send + 'static,
    ) -> io::Result<()> {
        let mut list = lock(&self.list);
        list.readers.retain(|(_, thread)| !thread.is_finished());
        let oldest = if list.readers.len() < MAX_READERS { None } else { list.readers.pop_front() };
        let reader = Arc::new(Reader::new(socket, links, list.fault.clone())?);
        let (theirs, of_all) = (Arc::clone(&reader), Arc::clone(&self.list));
        let thread = clock::spawn(links.time(), "status", move || {
            run(&theirs);
            lock(&of_all).readers.retain(|(reader, _)| !Arc::ptr_eq(reader, &theirs));
        })?;
        list.readers.push_back((reader, thread));
        drop(list);
        oldest.into_iter().for_each(close);
        Ok(())
    }
}

/// Closes a connection, and waits for its thread.
fn close((reader, thread): (Arc<Reader>, JoinHandle<()>)) {
    reader.close();
    // The panic hook has reported a panic of the thread, which concerns one connection.
    drop(thread.join());
}
