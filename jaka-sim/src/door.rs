//! A listener that can be woken.

use std::io;
use std::net::{IpAddr, SocketAddr, TcpListener, TcpStream};
use std::sync::{Condvar, Mutex};
use std::time::Duration;

use crate::lock::{lock, wait};

/// How long the kernel may take for a connection on loopback.
const KNOCK: Duration = Duration::from_secs(2);

/// How long to wait after an `accept` that failed, for want of descriptors perhaps.
const REST: Duration = Duration::from_millis(20);

/// A listener on loopback, at which one thread waits.
///
/// std can neither wake `accept` nor say whether somebody is still in its queue. So the door has a bell: a connection
/// to itself, told from guests by its address. The queue is in order of arrival: when the bell is heard, all who came
/// before it have been let in.
#[derive(Debug)]
pub(crate) struct Door {
    listener: TcpListener,
    address: SocketAddr,
    bells: Mutex<Bells>,
    changed: Condvar,
}

#[derive(Debug, Default)]
struct Bells {
    /// Bells rung and not heard yet, by the address they ring from.
    ringing: Vec<SocketAddr>,
    /// Nobody else is let in.
    closed: bool,
    /// Nobody listens any more.
    deserted: bool,
}

impl Door {
    /// Listens at an address, on a free port if `port` is 0.
    pub(crate) fn open(address: IpAddr, port: u16) -> io::Result<Self> {
        let listener = TcpListener::bind((address, port))?;
        let address = listener.local_addr()?;
        Ok(Self { listener, address, bells: Mutex::default(), changed: Condvar::new() })
    }

    pub(crate) fn address(&self) -> SocketAddr {
        self.address
    }

    /// Waits for the next guest; `None` once the door is closed.
    pub(crate) fn next_guest(&self) -> Option<TcpStream> {
        loop {
            let accepted = self.listener.accept();
            let mut bells = lock(&self.bells);
            if bells.closed {
                return None;
            }
            match accepted {
                Ok((_bell, peer)) if bells.ringing.contains(&peer) => {
                    bells.ringing.retain(|bell| *bell != peer);
                    self.changed.notify_all();
                }
                Ok((guest, _)) => return Some(guest),
                Err(_) => drop(wait(&self.changed, bells, REST, |bells| bells.closed)),
            }
        }
    }

    /// Waits until all who have connected so far have been let in.
    pub(crate) fn settle(&self) -> io::Result<()> {
        // The lock is held while connecting, so that the bell is known when it is heard.
        let mut bells = lock(&self.bells);
        let bell = TcpStream::connect_timeout(&self.address, KNOCK)?;
        let address = bell.local_addr()?;
        bells.ringing.push(address);
        drop(wait(&self.changed, bells, Duration::MAX, |bells| bells.deserted || !bells.ringing.contains(&address)));
        Ok(())
    }

    /// Lets nobody else in, and wakes who waits. An error says that the thread could not be woken.
    pub(crate) fn close(&self) -> io::Result<()> {
        lock(&self.bells).closed = true;
        self.changed.notify_all();
        TcpStream::connect_timeout(&self.address, KNOCK).map(drop)
    }

    /// Says that nobody listens any more.
    pub(crate) fn desert(&self) {
        lock(&self.bells).deserted = true;
        self.changed.notify_all();
    }
}

#[cfg(test)]
mod tests {
    use std::thread;

    use super::*;

    #[test]
    fn the_bell_is_heard_after_the_guests_before_it() {
        let door = Door::open(IpAddr::from([127, 0, 0, 1]), 0).expect("loopback has ports");
        let seen = Mutex::new(0);
        thread::scope(|scope| {
            scope.spawn(|| {
                while door.next_guest().is_some() {
                    *lock(&seen) += 1;
                }
                door.desert();
            });
            for guests in 1..20 {
                let _guest = TcpStream::connect(door.address()).expect("the door listens");
                door.settle().expect("the door listens");
                assert_eq!(*lock(&seen), guests);
            }
            door.close().expect("the door listens");
        });
        assert_eq!(*lock(&seen), 19);
        door.settle().expect("a deserted door keeps nobody waiting");
    }
}
