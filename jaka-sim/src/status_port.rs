//! Port 10000: any number of readers, who get the state again and again.

mod extio;
mod outlet;
mod packet;
mod reader;
mod replayed;

use std::collections::VecDeque;
use std::io;
use std::net::TcpStream;
use std::sync::{Arc, Mutex};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use self::packet::packet;
use self::reader::{Letter, Reader};
use self::replayed::Packets;
use crate::link::{Links, Wire};
use crate::lock::lock;
use crate::shared::Shared;
use crate::{Port, StatusFault};

/// How many readers there can be, so that no number of connections uses up threads and memory.
const MAX_READERS: usize = 256;

/// Lets readers in until the door is closed.
pub(crate) fn run(shared: &Arc<Shared>) {
    while let Some(guest) = shared.status_door.next_guest() {
        if let Err(error) = admit(guest, shared) {
            log::trace!(target: "jaka_sim", "status reader lost: {error}");
        }
    }
    shared.readers.close();
    shared.status_door.desert();
}

fn admit(guest: TcpStream, shared: &Arc<Shared>) -> io::Result<()> {
    log::trace!(target: "jaka_sim", "status reader connected");
    let host = Arc::clone(shared);
    if let Some(stage) = &shared.stage {
        let Some(script) = stage.next_reader() else {
            Wire::new(guest, Port::Status, &shared.links)?.close();
            return Ok(());
        };
        let packets = Packets::new(script, host.options.period());
        return shared.readers.add(guest, &shared.links, move |reader| {
            if let Some(stage) = &host.stage {
                reader.replay(packets, stage);
            }
        });
    }
    // With a stepped clock, packets go out as it is stepped.
    let period = Some(host.options.period()).filter(|_| !host.options.stepped);
    let run = move |reader: &Reader| reader.run(period, || packet(&host.world().state, host.options.firmware));
    shared.readers.add(guest, &shared.links, run)
}

/// Closes a connection, and waits for its thread.
fn close((reader, thread): (Arc<Reader>, JoinHandle<()>)) {
    reader.close();
    // A panic there has been reported, and concerns one connection.
    drop(thread.join());
}

/// The readers, each with a thread of its own so that none waits for another.
#[derive(Debug)]
pub(crate) struct Readers {
    room: Mutex<Room>,
}

#[derive(Debug)]
struct Room {
    list: VecDeque<(Arc<Reader>, JoinHandle<()>)>,
    /// What is wrong with the packets that go out.
    fault: StatusFault,
}

impl Readers {
    pub(crate) fn new(fault: StatusFault) -> Self {
        Self { room: Mutex::new(Room { list: VecDeque::new(), fault }) }
    }

    /// Sets what is wrong with the packets from now on.
    pub(crate) fn set_fault(&self, fault: StatusFault) {
        let mut room = lock(&self.room);
        for (reader, _) in &room.list {
            reader.set_fault(fault.clone());
        }
        room.fault = fault;
    }

    /// The time between two packets, which is this one if nothing is wrong.
    pub(crate) fn period(&self, usual: Duration) -> Duration {
        outlet::period(&lock(&self.room).fault, usual)
    }

    /// Sends the present state to all; nothing in a replay, in which there is none.
    pub(crate) fn publish(&self, shared: &Shared) {
        if shared.stage.is_some() {
            return;
        }
        let packet = packet(&shared.world().state, shared.options.firmware);
        self.post(&Letter::Packet(packet.into()));
    }

    /// Sends bytes to all, and waits until they have them; or have been dropped, because they do not read.
    pub(crate) fn send(&self, bytes: &[u8]) {
        self.post(&Letter::Bytes(bytes.into()));
    }

    fn post(&self, letter: &Letter) {
        let readers: Vec<_> = lock(&self.room).list.iter().map(|(reader, _)| Arc::clone(reader)).collect();
        let posted: Vec<_> = readers.iter().map(|reader| reader.post(letter.clone())).collect();
        for (reader, number) in readers.iter().zip(posted) {
            reader.wait_for(number);
        }
    }

    /// Has all look anew when their next packet is due.
    pub(crate) fn wake(&self) {
        lock(&self.room).list.iter().for_each(|(reader, _)| reader.wake());
    }

    /// Closes all connections, and waits for their threads.
    pub(crate) fn close(&self) {
        let readers = std::mem::take(&mut lock(&self.room).list);
        for (reader, _) in &readers {
            reader.close();
        }
        readers.into_iter().for_each(close);
    }

    /// Adds a reader with a thread that does this, and forgets those who have gone.
    ///
    /// Where there are too many, the oldest is dropped. It may have gone too: that is noticed on writing only.
    fn add(&self, guest: TcpStream, links: &Arc<Links>, run: impl FnOnce(&Reader) + Send + 'static) -> io::Result<()> {
        let mut room = lock(&self.room);
        room.list.retain(|(_, thread)| !thread.is_finished());
        let oldest = if room.list.len() < MAX_READERS { None } else { room.list.pop_front() };
        let reader = Arc::new(Reader::new(guest, links, room.fault.clone())?);
        let theirs = Arc::clone(&reader);
        let thread = thread::Builder::new().name("jaka-sim status".to_owned()).spawn(move || run(&theirs))?;
        room.list.push_back((reader, thread));
        drop(room);
        oldest.into_iter().for_each(close);
        Ok(())
    }
}
