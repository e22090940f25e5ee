//! Listener with a wake-up.

use std::io;
use std::net::{IpAddr, SocketAddr, TcpListener, TcpStream};
use std::sync::Mutex;
use std::time::Duration;

use jaka_clock::{Clock, Signal, Socket, lock};

/// Timeout for a connection on loopback, which takes a second and more with a long backlog.
pub(crate) const CONNECT_TIMEOUT: Duration = Duration::from_secs(60);

/// Delay after a failed `accept`, for example without a free file descriptor.
const RETRY_DELAY: Duration = Duration::from_millis(20);

/// TCP listener with one accepting thread.
///
/// std can neither wake `accept` nor report whether its backlog is empty. So the listener connects to itself to wake
/// up; it recognises these connections by their address. The backlog is in order of arrival: when the listener accepts
/// a wake-up, it has accepted all earlier connections.
#[derive(Debug)]
pub(crate) struct Listener {
    socket: TcpListener,
    address: SocketAddr,
    state: Mutex<ListenerState>,
    /// Signal in real time.
    changed: Signal,
    time: Clock,
}

#[derive(Debug, Default)]
struct ListenerState {
    /// Local addresses of wake-up connections not accepted yet.
    wake_ups: Vec<SocketAddr>,
    /// Whether the listener accepts no further connection.
    closed: bool,
    /// Whether the accepting thread has ended.
    stopped: bool,
}

impl Listener {
    /// Listens at an address, on a free port if `port` is 0.
    pub(crate) fn bind(address: IpAddr, port: u16, time: &Clock) -> io::Result<Self> {
        let socket = TcpListener::bind((address, port))?;
        let address = socket.local_addr()?;
        if let Some(clock) = time.as_simulated() {
            clock.listen(address);
        }
        Ok(Self { socket, address, state: Mutex::default(), changed: Signal::default(), time: time.clone() })
    }

    pub(crate) fn address(&self) -> SocketAddr {
        self.address
    }

    /// Passes on each connection until the listener is closed. An error of one connection means its loss, and does not
    /// affect the others.
    pub(crate) fn accept_all(&self, client: &str, mut admit: impl FnMut(Socket) -> io::Result<()>) {
        while let Some((stream, peer)) = self.accept() {
            let accepted = Socket::accepted(stream, peer, &self.time);
            // A simulated time advances only after that.
            if let Err(error) = accepted.and_then(|(socket, _work)| admit(socket)) {
                log::trace!(target: "jaka_sim", "{client} lost: {error}");
            }
        }
    }

    /// Waits for the next connection; returns `None` once the listener is closed.
    fn accept(&self) -> Option<(TcpStream, SocketAddr)> {
        loop {
            let accepted = self.socket.accept();
            let mut state = lock(&self.state);
            if state.closed {
                return None;
            }
            match accepted {
                Ok((_, peer)) if state.wake_ups.contains(&peer) => {
                    state.wake_ups.retain(|wake_up| *wake_up != peer);
                    self.changed.notify_all();
                }
                Ok(accepted) => return Some(accepted),
                Err(_) => {
                    drop(state);
                    drop(self.changed.wait_until(&self.state, RETRY_DELAY, |state| state.closed));
                }
            }
        }
    }

    /// Waits until every connection made so far is accepted. If the system has no socket left to wait with, covers only
    /// the connections accepted so far.
    pub(crate) fn wait_until_accepted(&self) {
        // Holds the lock while connecting, so that the accepting thread knows the wake-up.
        let mut state = lock(&self.state);
        let wake_up = TcpStream::connect_timeout(&self.address, CONNECT_TIMEOUT);
        let Ok((address, _wake_up)) = wake_up.and_then(|stream| Ok((stream.local_addr()?, stream))) else { return };
        state.wake_ups.push(address);
        drop(state);
        let is_accepted = |state: &ListenerState| state.stopped || !state.wake_ups.contains(&address);
        drop(self.changed.wait_until(&self.state, Duration::MAX, is_accepted));
    }

    /// Stops accepting, and wakes the accepting thread. Returns an error if the thread could not be woken.
    pub(crate) fn close(&self) -> io::Result<()> {
        lock(&self.state).closed = true;
        self.changed.notify_all();
        if let Some(clock) = self.time.as_simulated() {
            clock.stop_listening(self.address);
        }
        TcpStream::connect_timeout(&self.address, CONNECT_TIMEOUT).map(drop)
    }

    /// Records that the accepting thread ends.
    pub(crate) fn stop(&self) {
        lock(&self.state).stopped = true;
        self.changed.notify_all();
    }
}

#[cfg(test)]
mod tests {
    use std::thread;

    use super::*;

    #[test]
    fn connections_before_a_wake_up_are_accepted_before_it() {
        let listener = Listener::bind(IpAddr::from([127, 0, 0, 1]), 0, &Clock::default()).expect("loopback has ports");
        let accepted = Mutex::new(0);
        thread::scope(|scope| {
            scope.spawn(|| {
                while listener.accept().is_some() {
                    *lock(&accepted) += 1;
                }
                listener.stop();
            });
            for count in 1..20 {
                let _stream = TcpStream::connect(listener.address()).expect("it listens");
                listener.wait_until_accepted();
                assert_eq!(*lock(&accepted), count);
            }
            listener.close().expect("it listens");
        });
        assert_eq!(*lock(&accepted), 19);
        // After the end, no call waits.
        listener.wait_until_accepted();
    }
}
