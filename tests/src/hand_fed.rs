//! A robot whose controller is two plain sockets: the test writes its packets, and sees each byte that comes.

use std::io::{Read, Write};
use std::net::{TcpListener, TcpStream};
use std::time::{Duration, Instant};

use jaka_sync::{Config, Monitor, Robot};

/// The controller's ends of a robot's two connections.
#[derive(Debug)]
pub struct HandFed {
    /// Where commands come, and their replies go.
    pub commands: TcpStream,
    /// Where packets go.
    pub status: TcpStream,
}

/// Longer than anything takes.
const LONG: Duration = Duration::from_secs(30);

impl HandFed {
    /// A controller, and a robot that is connected to it, and for which packets are stale after a time.
    ///
    /// # Panics
    /// Loopback has no free ports.
    pub fn new(stale_after: Duration) -> (Self, Robot) {
        let listen = || TcpListener::bind("127.0.0.1:0").expect("loopback has free ports");
        let (commands, status) = (listen(), listen());
        let config = Config::new().stale_after(stale_after).reply_timeout(LONG);
        let address = |listener: &TcpListener| listener.local_addr().expect("it is bound");
        let monitor: Monitor = config.connect_monitor(address(&status)).expect("it listens");
        let client = config.connect_client(address(&commands)).expect("it listens");
        let accept = |listener: TcpListener| listener.accept().expect("it is connected").0;
        let controller = Self { commands: accept(commands), status: accept(status) };
        controller.commands.set_nodelay(true).expect("it is connected");
        (controller, Robot::new(client, monitor))
    }

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

    /// The same, and waits until the robot has it.
    ///
    /// # Panics
    /// As [`packet`](Self::packet), or the packet does not come.
    pub fn packet_to(&mut self, robot: &Robot, keys: &str) {
        let number = |robot: &Robot| robot.monitor().last_known_packet().map_or(0, |newest| newest.number);
        let (before, since) = (number(robot), Instant::now());
        self.packet(keys);
        while number(robot) == before {
            assert!(since.elapsed() < LONG, "the packet does not come");
            std::thread::yield_now();
        }
    }

    /// All that comes on the command port until the robot has left.
    ///
    /// # Panics
    /// It does not leave.
    pub fn received(mut self) -> String {
        self.commands.set_read_timeout(Some(LONG)).expect("it is a duration");
        let mut text = String::new();
        self.commands.read_to_string(&mut text).expect("the robot leaves");
        text
    }
}
