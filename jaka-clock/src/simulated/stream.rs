//! Connections of programs and tests that take part in the time of a clock.

use std::io::{self, Read, Write};
use std::net::{Shutdown, SocketAddr, TcpListener, TcpStream};
use std::time::Duration;

use super::{Channel, SimulatedClock};

/// Connection of a program that takes part in the time of a clock, from [`SimulatedClock::connect`] or
/// [`Listener::accept`].
///
/// A plain [`TcpStream`] to jaka-sim or jaka-sync takes no part: its bytes come when the system says so, in real time.
/// This one's come at an exact time. A read or write takes as long as [`set_timeout`](Self::set_timeout) says, and
/// fails with [`WouldBlock`](io::ErrorKind::WouldBlock) then.
///
/// ```
/// use std::io::{Read, Write};
/// use std::time::Duration;
/// use jaka_clock::SimulatedClock;
///
/// let clock = SimulatedClock::new();
/// let listener = clock.bind("127.0.0.1:0".parse().expect("an address"))?;
/// let mut near = clock.connect(listener.local_addr())?;
/// let mut far = listener.accept()?;
/// far.write_all(b"a packet")?;
/// near.read_exact(&mut [0; 8])?;
/// near.set_timeout(Some(Duration::from_secs(3600)));
/// assert!(near.read(&mut [0]).is_err());
/// assert_eq!(clock.elapsed(), Duration::from_secs(3600));
/// # Ok::<(), std::io::Error>(())
/// ```
#[derive(Debug)]
pub struct Stream {
    system: TcpStream,
    /// Dropped after the socket.
    channel: Channel,
    timeout: Option<Duration>,
}

/// Listener of a program that takes part in the time of a clock, from [`SimulatedClock::bind`].
#[derive(Debug)]
pub struct Listener {
    system: TcpListener,
    address: SocketAddr,
    clock: SimulatedClock,
}

impl SimulatedClock {
    /// Connects, as a program that takes part.
    ///
    /// # Errors
    /// The system's.
    pub fn connect(&self, address: SocketAddr) -> io::Result<Stream> {
        self.take_part();
        let system = TcpStream::connect(address)?;
        let channel = self.connected(&system)?;
        Stream::new(system, channel)
    }

    /// Listens, as a participating program. Time stands still while a connection of another participant waits to be
    /// accepted.
    ///
    /// # Errors
    /// The system's.
    pub fn bind(&self, address: SocketAddr) -> io::Result<Listener> {
        let system = TcpListener::bind(address)?;
        let address = system.local_addr()?;
        self.listen(address);
        Ok(Listener { system, address, clock: self.clone() })
    }
}

impl Listener {
    /// Address that it listens at.
    pub fn local_addr(&self) -> SocketAddr {
        self.address
    }

    /// Waits for a connection; time may advance meanwhile. The thread participates from then on.
    ///
    /// # Errors
    /// The system's.
    pub fn accept(&self) -> io::Result<Stream> {
        let (system, peer) = self.clock.outside(|| self.system.accept())?;
        let (channel, _work) = self.clock.accepted(&system, peer)?;
        self.clock.take_part();
        Stream::new(system, channel)
    }
}

impl Drop for Listener {
    fn drop(&mut self) {
        self.clock.stop_listening(self.address);
    }
}

impl Stream {
    fn new(system: TcpStream, channel: Channel) -> io::Result<Self> {
        system.set_nodelay(true)?;
        Ok(Self { system, channel, timeout: None })
    }

    /// Sets the time that a read or write may take, in the time of the clock; none at first.
    pub fn set_timeout(&mut self, timeout: Option<Duration>) {
        self.timeout = timeout;
    }

    /// Ends the connection in a direction or both.
    ///
    /// # Errors
    /// The system's: it has ended already.
    pub fn shutdown(&self, how: Shutdown) -> io::Result<()> {
        self.channel.shutdown(&self.system, how)
    }

    /// Socket of the system, for its options.
    pub fn system(&self) -> &TcpStream {
        &self.system
    }
}

impl Read for &Stream {
    fn read(&mut self, space: &mut [u8]) -> io::Result<usize> {
        self.channel.read(&self.system, space, self.timeout)
    }
}

impl Write for &Stream {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.channel.write(&self.system, bytes, self.timeout)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Read for Stream {
    fn read(&mut self, space: &mut [u8]) -> io::Result<usize> {
        (&*self).read(space)
    }
}

impl Write for Stream {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        (&*self).write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
