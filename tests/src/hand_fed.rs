//! A robot whose controller is two plain sockets: the test writes its packets, and sees each byte that comes.

use std::fmt::Debug;
use std::io::{self, Read, Write};
use std::net::{SocketAddr, TcpListener, TcpStream};
use std::time::Duration;

use jaka_robot::jaka_clock::{SimulatedClock, Stream};
use jaka_robot::{Client, Config, Monitor, Robot};
use serde_json::{Deserializer, Value};

use crate::LONG;

/// The controller's ends of a robot's two connections: plain sockets, or sockets in the time of a simulated clock.
#[derive(Debug)]
pub struct HandFed<S = TcpStream> {
    /// Commands come here, and their replies go.
    pub commands: S,
    /// Packets go here.
    pub status: S,
}

/// The controller's end of a connection in the time of a simulated clock. A read or write waits for at most [`LONG`].
#[derive(Debug)]
pub struct ClockedSocket(Stream);

/// Connects something to a port of loopback, and accepts it there. A read of the port's end waits for at most [`LONG`].
///
/// # Panics
/// It does not connect.
pub fn accepted<T, E: Debug>(connect: impl FnOnce(SocketAddr) -> Result<T, E>) -> (TcpStream, T) {
    let listener = TcpListener::bind("127.0.0.1:0").expect("loopback has free ports");
    let connected = connect(listener.local_addr().expect("it is bound")).expect("the port listens");
    let (stream, _) = listener.accept().expect("it is connected");
    stream.set_read_timeout(Some(LONG)).expect("it is a time");
    stream.set_nodelay(true).expect("it is connected");
    (stream, connected)
}

impl HandFed {
    /// A controller, and a robot that is connected to it, and for which packets are stale after a time. Time is real.
    ///
    /// # Panics
    /// Loopback has no free ports.
    pub fn new(stale_after: Duration) -> (Self, Robot) {
        let config = Config::new().stale_after(stale_after).reply_timeout(LONG).connect_timeout(LONG);
        let (status, monitor) = accepted(|address| Monitor::connect_with(&config, address));
        let (commands, client) = accepted(|address| Client::connect_with(&config, address));
        (Self { commands, status }, Robot::new(client, monitor).expect("it is the only robot"))
    }
}

impl HandFed<ClockedSocket> {
    /// A controller and its robot in simulated time. The calling thread takes part in it: another one is run by
    /// [`beside`](crate::simulated::beside).
    ///
    /// # Panics
    /// Loopback has no free ports.
    pub fn by_clock(clock: &SimulatedClock, stale_after: Duration) -> (Self, Robot) {
        let config = Config::new().clock(clock).stale_after(stale_after).reply_timeout(LONG).connect_timeout(LONG);
        let (status, monitor): (_, Monitor) =
            ClockedSocket::accepted(clock, |address| Monitor::connect_with(&config, address));
        let (commands, client) = ClockedSocket::accepted(clock, |address| Client::connect_with(&config, address));
        (Self { commands, status }, Robot::new(client, monitor).expect("it is the only robot"))
    }
}

impl<S: Read + Write> HandFed<S> {
    /// Sends a packet of an arm that is enabled and at rest, with more keys.
    ///
    /// # Panics
    /// The connection is lost.
    pub fn packet(&mut self, keys: &str) {
        let keys = if keys.is_empty() { String::new() } else { format!(", {keys}") };
        let packet = format!(
            r#"{{"len": 100, "emergency_stop": 0, "protective_stop": 0, "powered_on": 1, "enabled": true, "inpos": true{keys}}}"#
        );
        self.status.write_all(packet.as_bytes()).expect("the robot is connected");
    }

    /// Sends a packet as [`packet`](Self::packet) does, and waits until the robot has it.
    ///
    /// # Panics
    /// As [`packet`](Self::packet), or the packet does not come.
    pub fn packet_to(&mut self, robot: &Robot, keys: &str) {
        let packets = robot.monitor().subscribe(1);
        self.packet(keys);
        packets.next_packet_within(LONG).expect("the packet comes");
    }

    /// The next request.
    ///
    /// # Panics
    /// None comes.
    pub fn request(&mut self) -> Value {
        // Nothing is read beyond its end.
        let mut requests = Deserializer::from_reader(&mut self.commands).into_iter();
        requests.next().expect("the robot is connected").expect("a request comes")
    }

    /// Accepts a command, with more keys in the reply.
    ///
    /// # Panics
    /// The connection is lost.
    pub fn reply(&mut self, command: &str, keys: &str) {
        let keys = if keys.is_empty() { String::new() } else { format!(", {keys}") };
        let reply = format!(r#"{{"errorCode": "0", "errorMsg": "", "cmdName": "{command}"{keys}}}"#);
        self.commands.write_all(reply.as_bytes()).expect("the robot is connected");
    }

    /// All that comes on the command port until the robot has left.
    ///
    /// # Panics
    /// It does not leave.
    pub fn received(mut self) -> String {
        let mut text = String::new();
        self.commands.read_to_string(&mut text).expect("the robot leaves");
        text
    }
}

impl ClockedSocket {
    /// Connects something that goes by the clock to a port of loopback, and accepts it there.
    ///
    /// # Panics
    /// It does not connect.
    pub fn accepted<T, E: Debug>(
        clock: &SimulatedClock,
        connect: impl FnOnce(SocketAddr) -> Result<T, E>,
    ) -> (Self, T) {
        let listener = clock.bind(([127, 0, 0, 1], 0).into()).expect("loopback has free ports");
        let connected = connect(listener.local_addr()).expect("the port listens");
        let mut stream = listener.accept().expect("it is connected");
        stream.set_timeout(Some(LONG));
        (Self(stream), connected)
    }

    /// Text that has come and was not read. No time passes.
    ///
    /// # Panics
    /// It is not text.
    pub fn waiting(&mut self) -> String {
        self.0.set_timeout(Some(Duration::ZERO));
        let (mut bytes, mut space) = (Vec::new(), [0; 4096]);
        while let Ok(count @ 1..) = self.0.read(&mut space) {
            bytes.extend_from_slice(&space[..count]);
        }
        self.0.set_timeout(Some(LONG));
        String::from_utf8(bytes).expect("requests are text")
    }

    /// Ends the connection by a reset, without its orderly end.
    ///
    /// # Panics
    /// The system does not know of resets.
    pub fn reset(self) {
        socket2::SockRef::from(self.0.system()).set_linger(Some(Duration::ZERO)).expect("it is a socket");
    }
}

impl Read for ClockedSocket {
    fn read(&mut self, space: &mut [u8]) -> io::Result<usize> {
        self.0.read(space)
    }
}

impl Write for ClockedSocket {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
