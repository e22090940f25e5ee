//! A link that loses packets themselves, which no fault inside the simulator can show: the systems at both ends send
//! them again.
//!
//! It is not part of the usual run: `cargo test -p jaka-cli --test suite held_packets -- --ignored`.

#![cfg(target_os = "linux")]

mod netns;

use std::io::{ErrorKind, Write};
use std::net::{SocketAddr, TcpStream};
use std::time::{Duration, Instant};

use jaka_sync::proto::framing::Framer;
use jaka_tests::LONG;
use serde_json::Value;

use self::netns::{Namespace, skipped};
use crate::common;

/// For how long the link is down at least: longer than a packet takes to be sent again on one that is up.
const DOWN: Duration = Duration::from_millis(600);

/// A client that speaks JSON and no more.
struct Peer {
    stream: TcpStream,
    framer: Framer,
}

impl Peer {
    fn connect(address: SocketAddr) -> Self {
        let stream = TcpStream::connect(address).expect("the controller listens");
        stream.set_read_timeout(Some(LONG)).expect("a timeout can be set");
        stream.set_nodelay(true).expect("an option can be set");
        Self { stream, framer: Framer::default() }
    }

    fn send(&mut self, command: &str) {
        write!(self.stream, "{{\"cmdName\":\"{command}\"}}").expect("the connection is open");
    }

    fn receive(&mut self) -> Value {
        loop {
            if let Some(frame) = self.framer.next_frame().expect("the controller sends frames") {
                return serde_json::from_slice(frame).expect("the controller sends JSON");
            }
            self.read();
        }
    }

    fn read(&mut self) {
        let count = common::read(&self.stream, self.framer.spare()).expect("bytes come");
        assert!(count > 0, "the connection has ended");
        self.framer.filled(count);
    }

    fn assert_accepted(&mut self, command: &str) {
        let reply = self.receive();
        assert_eq!((&reply["errorCode"], &reply["cmdName"]), (&"0".into(), &command.into()), "{reply}");
    }

    fn has_power(&mut self) -> bool {
        self.receive()["powered_on"] != 0
    }
}

/// True if nothing comes for this long.
fn is_quiet_for(peer: &Peer, time: Duration) -> bool {
    peer.stream.set_read_timeout(Some(time)).expect("a timeout can be set");
    let peeked = loop {
        match peer.stream.peek(&mut [0]).map_err(|error| error.kind()) {
            Err(ErrorKind::Interrupted) => {}
            peeked => break peeked,
        }
    };
    peer.stream.set_read_timeout(Some(LONG)).expect("a timeout can be set");
    matches!(peeked, Err(ErrorKind::WouldBlock | ErrorKind::TimedOut))
}

/// Takes what has come by now, of which the last message may be a part.
fn drain(peer: &mut Peer) {
    while !is_quiet_for(peer, Duration::from_millis(200)) {
        peer.read();
    }
}

#[test]
#[ignore = "a machine that holds it up takes the link down for longer than connections last"]
fn what_is_sent_while_the_link_is_down_arrives_when_it_is_up() {
    let mut namespace = match Namespace::new() {
        Ok(namespace) => namespace,
        Err(reason) => return skipped("what_is_sent_while_the_link_is_down_arrives_when_it_is_up", &reason),
    };
    let [commands, status] = namespace.start(&["--fast", "--period", "200"]).expect("the program starts");
    let (mut commands, mut status) = (Peer::connect(commands), Peer::connect(status));
    commands.send("get_version");
    commands.assert_accepted("get_version");
    assert!(!status.has_power());

    namespace.down().expect("a link that is up can be taken down");
    let began = Instant::now();
    commands.send("power_on");
    commands.send("enable_robot");
    drain(&mut status);
    // No proxy, and no fault of the simulator: nothing acknowledges what was sent.
    assert!(is_quiet_for(&commands, DOWN) && is_quiet_for(&status, DOWN));
    namespace.up().expect("the link can be taken up");

    commands.assert_accepted("power_on");
    commands.assert_accepted("enable_robot");
    // Packets that were made before the requests arrived come first, if there are any.
    while !status.has_power() {
        assert!(began.elapsed() < LONG, "packets show no power");
    }
    commands.send("get_version");
    commands.assert_accepted("get_version");
}
