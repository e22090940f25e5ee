//! The status port.

use std::fmt::Display;
use std::sync::Arc;
use std::time::Duration;

use jaka_clock::Clock;
use jaka_proto::messages::status::RobotStatus;
use jaka_proto::wire::{Decode, DecodeError, Reader};

use crate::packets::{Packets, Silence};
use crate::receive::Chunk;
use crate::{Config, Disconnect, Error, ErrorKind};

/// Reader of the status packets that a controller sends on port 10000.
///
/// Packets come every 30 to 100 ms, depending on firmware, and wait in the system's buffer until they are read. Use
/// [`newest_packet`](Self::newest_packet) if only the present state matters, and [`next_packet`](Self::next_packet) if
/// every packet does. Several readers can be connected at once.
///
/// A field that does not fit the spec is absent, and [`unfit`](Self::unfit) lists it. Bytes that do not belong to a
/// complete packet are skipped up to the next packet.
///
/// ```no_run
/// use jaka_sync::StatusStream;
///
/// let mut status = StatusStream::connect("10.5.5.100")?;
/// let now = status.newest_packet()?;
/// println!("{:?} {:?}", now.joint_actual_position, now.in_position);
/// # Ok::<(), jaka_sync::Error>(())
/// ```
#[derive(Debug)]
#[must_use = "dropping a stream closes its connection"]
pub struct StatusStream {
    packets: Packets,
    timeout: Duration,
    clock: Clock,
    unfit: Vec<DecodeError>,
    silence: Silence,
    stale_after: Duration,
    follows_silence: bool,
    broken: Option<Arc<Disconnect>>,
}

impl StatusStream {
    /// Connects to a controller's status port: `10.5.5.100`, or an address with a port.
    ///
    /// # Errors
    /// [`ErrorKind::Connect`] if no controller answers there within the connect timeout.
    pub fn connect(address: impl Display) -> Result<Self, Error> {
        Self::connect_with(&Config::new(), address)
    }

    /// Connects to a controller's status port by a configuration.
    ///
    /// # Errors
    /// As [`connect`](Self::connect).
    pub fn connect_with(config: &Config, address: impl Display) -> Result<Self, Error> {
        Ok(Self {
            packets: Packets::connect(&address.to_string(), config)?,
            timeout: config.reply_timeout,
            clock: config.clock.clone(),
            unfit: Vec::new(),
            silence: Silence::default(),
            stale_after: config.stale_after,
            follows_silence: false,
            broken: None,
        })
    }

    /// Returns the next packet that has not been read yet, which may be old.
    ///
    /// # Errors
    /// - [`StatusTimeout`](ErrorKind::StatusTimeout): no packet within the reply timeout.
    /// - [`UnexpectedStatus`](ErrorKind::UnexpectedStatus): a packet is not a JSON object, or your own [`Decode`]
    ///   refuses it; its text is kept.
    /// - [`Disconnected`](ErrorKind::Disconnected): the stream is broken for good.
    pub fn next_packet(&mut self) -> Result<RobotStatus, Error> {
        self.next_packet_as()
    }

    /// Reads the packet of [`next_packet`](Self::next_packet) as another type: a [pack](crate::pack!)'s status packet
    /// with keys of newer firmware, or your own subset of keys.
    ///
    /// # Errors
    /// As [`next_packet`](Self::next_packet).
    pub fn next_packet_as<S: Decode>(&mut self) -> Result<S, Error> {
        self.receive()?;
        self.read_packet()
    }

    /// Returns the newest packet that has arrived, and drops older ones. Waits for one if none has arrived.
    ///
    /// # Errors
    /// As [`next_packet`](Self::next_packet).
    pub fn newest_packet(&mut self) -> Result<RobotStatus, Error> {
        self.newest_packet_as()
    }

    /// Reads the packet of [`newest_packet`](Self::newest_packet) as another type: see
    /// [`next_packet_as`](Self::next_packet_as).
    ///
    /// # Errors
    /// As [`next_packet`](Self::next_packet).
    pub fn newest_packet_as<S: Decode>(&mut self) -> Result<S, Error> {
        self.receive_newest()?;
        self.read_packet()
    }

    /// Text of the packet that was read last, as it was received; with `\udcNN` for each byte that is not UTF-8.
    pub fn packet_text(&self) -> Option<&str> {
        (!self.packets.text.is_empty()).then_some(&*self.packets.text)
    }

    /// Fields of the packet read last that do not fit the spec, each once, with the expected and the found value. They
    /// are absent in the value that was read. Usually empty.
    ///
    /// [`DecodeError::is_in`] compares an error with a field's name.
    pub fn unfit(&self) -> &[DecodeError] {
        &self.unfit
    }

    /// True if the packet read last was read within 100 ms after none had been read for longer than
    /// [`Config::stale_after`]: it may be an old one that the network, or the system's buffer, had held back.
    pub fn follows_silence(&self) -> bool {
        self.follows_silence
    }

    fn read_packet<S: Decode>(&mut self) -> Result<S, Error> {
        self.follows_silence = self.silence.is_followed_by(self.clock.now(), self.stale_after);
        let mut reader = Reader::new(&self.packets.text);
        let found = S::decode(&mut reader).and_then(|found| reader.end().map(|()| found));
        self.unfit = reader.take_unfit();
        found.map_err(|source| self.packets.tap.attach(ErrorKind::UnexpectedStatus { source }.into()))
    }

    /// Waits for a packet and keeps its text.
    fn receive(&mut self) -> Result<(), Error> {
        self.check()?;
        let since = self.clock.stopwatch();
        loop {
            if self.take_next()? {
                return Ok(());
            }
            let left = since.left_of(self.timeout);
            if left.is_zero() {
                let (tap, after) = (&self.packets.tap, self.timeout);
                return Err(tap.attach(ErrorKind::StatusTimeout { address: tap.address(), after }.into()));
            }
            if let Err(cause) = self.packets.read(left) {
                return Err(self.break_off(cause));
            }
        }
    }

    /// Keeps the text of the newest packet, and waits for one if none has arrived.
    fn receive_newest(&mut self) -> Result<(), Error> {
        if self.drain()? { Ok(()) } else { self.receive() }
    }

    /// Reads all that has arrived, without waiting, and keeps the newest packet; false if there is none.
    fn drain(&mut self) -> Result<bool, Error> {
        self.check()?;
        let mut found = self.take_newest()?;
        self.nonblocking(true)?;
        // Without the limit, a controller that sends faster than this reads would hold the thread here for ever.
        let since = self.clock.stopwatch();
        while since.passed() < self.timeout {
            match self.packets.read(self.timeout) {
                Ok(Chunk::All | Chunk::Part) => found |= self.take_newest()?,
                Ok(Chunk::TimeUp) => break,
                Err(cause) => return Err(self.break_off(cause)),
            }
        }
        self.nonblocking(false)?;
        Ok(found)
    }

    fn nonblocking(&mut self, nonblocking: bool) -> Result<(), Error> {
        self.packets.stream.set_nonblocking(nonblocking).map_err(|error| self.break_off(Disconnect::Read(error)))
    }

    fn take_newest(&mut self) -> Result<bool, Error> {
        let mut found = false;
        while self.take_next()? {
            found = true;
        }
        Ok(found)
    }

    /// Keeps the text of the next packet that has arrived in full, if there is one.
    fn take_next(&mut self) -> Result<bool, Error> {
        self.packets.next().map_err(|cause| self.break_off(cause))
    }

    fn check(&self) -> Result<(), Error> {
        let broken = self.broken.as_ref();
        broken.map_or(Ok(()), |cause| Err(self.disconnected(Arc::clone(cause))))
    }

    fn break_off(&mut self, cause: Disconnect) -> Error {
        self.packets.record_rest();
        self.packets.tap.broken(&cause);
        let cause = Arc::clone(self.broken.get_or_insert_with(|| Arc::new(cause)));
        self.disconnected(cause)
    }

    fn disconnected(&self, cause: Arc<Disconnect>) -> Error {
        let tap = &self.packets.tap;
        let address = tap.address();
        tap.attach(ErrorKind::Disconnected { address, command: None, sent: false, cause }.into())
    }
}

impl Drop for StatusStream {
    fn drop(&mut self) {
        self.packets.tap.left();
    }
}
