//! Port 10000: any number of readers, who get the state again and again.

mod extio;
mod packet;
mod reader;

use std::io;
use std::net::TcpStream;
use std::sync::{Arc, Mutex};
use std::thread::{self, JoinHandle};

use self::packet::packet;
use self::reader::Reader;
use crate::lock::lock;
use crate::shared::Shared;

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
    let reader = Arc::new(Reader::new(guest)?);
    let (theirs, host) = (Arc::clone(&reader), Arc::clone(shared));
    let thread = thread::Builder::new().name("jaka-sim status".to_owned());
    let thread = thread.spawn(move || theirs.run(host.options.status_period, || packet(&lock(&host.state))))?;
    shared.readers.add(reader, thread);
    Ok(())
}

/// The readers, each with a thread of its own so that none waits for another.
#[derive(Debug, Default)]
pub(crate) struct Readers {
    list: Mutex<Vec<(Arc<Reader>, JoinHandle<()>)>>,
}

impl Readers {
    /// Sends the present state to all.
    pub(crate) fn publish(&self, shared: &Shared) {
        let packet = packet(&lock(&shared.state));
        self.send(&packet);
    }

    /// Sends bytes to all, and waits until they have them; or have been dropped, because they do not read.
    pub(crate) fn send(&self, bytes: &[u8]) {
        let letter: Arc<[u8]> = bytes.into();
        let readers: Vec<_> = lock(&self.list).iter().map(|(reader, _)| Arc::clone(reader)).collect();
        let posted: Vec<_> = readers.iter().map(|reader| reader.post(Arc::clone(&letter))).collect();
        for (reader, number) in readers.iter().zip(posted) {
            reader.wait_for(number);
        }
    }

    /// Closes all connections, and waits for their threads.
    pub(crate) fn close(&self) {
        let readers = std::mem::take(&mut *lock(&self.list));
        for (reader, _) in &readers {
            reader.close();
        }
        for (_, thread) in readers {
            // A panic there has been reported, and concerns one connection.
            drop(thread.join());
        }
    }

    /// Adds a reader, and forgets those who have gone.
    fn add(&self, reader: Arc<Reader>, thread: JoinHandle<()>) {
        let mut list = lock(&self.list);
        list.retain(|(_, thread)| !thread.is_finished());
        list.push((reader, thread));
    }
}
