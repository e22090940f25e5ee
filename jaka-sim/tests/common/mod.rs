//! A client on a socket, and controllers for it.

#![allow(dead_code, reason = "each test file uses its share of it")]

pub(crate) mod servo;

use std::io::{ErrorKind, Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::time::Duration;

use jaka_proto::framing::Framer;
use jaka_proto::wire::Value;
use jaka_sim::jaka_clock::Stream;
use jaka_sim::{Builder, Controller, Delays, Firmware, SimulatedClock};

/// Limit for what a test waits for.
pub(crate) const LIMIT: Duration = Duration::from_secs(60);

/// Says on standard error that a check was not made, past the test harness, which captures `eprintln!` alone. Fails
/// where the environment has `CI`.
pub(crate) fn skipped(check: &str, why: &str) {
    let text = format!("NOT CHECKED: {check}: {why}");
    // The reader may be gone.
    writeln!(std::io::stderr().lock(), "{text}").ok();
    let is_ci = std::env::var_os("CI").is_some_and(|value| !value.is_empty() && value != "false");
    assert!(!is_ci, "{text}, and CI does not pass without it");
}

/// A client that speaks JSON and no more: on a socket of the system, or on one that takes part in a simulated time.
#[derive(Debug)]
pub(crate) struct Peer<S = TcpStream> {
    pub(crate) stream: S,
    framer: Framer,
}

impl Peer {
    pub(crate) fn connect(address: SocketAddr) -> Self {
        let stream = TcpStream::connect(address).expect("the controller listens");
        stream.set_read_timeout(Some(LIMIT)).expect("a timeout can be set");
        stream.set_write_timeout(Some(LIMIT)).expect("a timeout can be set");
        stream.set_nodelay(true).expect("an option can be set");
        Self { stream, framer: Framer::default() }
    }

    /// A command client of the controller.
    pub(crate) fn commands(controller: &Controller) -> Self {
        Self::connect(controller.command_addr())
    }

    /// A status reader of the controller.
    pub(crate) fn status(controller: &Controller) -> Self {
        Self::connect(controller.status_addr())
    }

    /// True if bytes or the end have come.
    pub(crate) fn has_something(&self) -> bool {
        self.stream.set_nonblocking(true).expect("an option can be set");
        let peeked = self.stream.peek(&mut [0]).map_err(|error| error.kind());
        self.stream.set_nonblocking(false).expect("an option can be set");
        peeked != Err(ErrorKind::WouldBlock)
    }
}

impl Peer<Stream> {
    /// A command client of the controller, in its simulated time.
    pub(crate) fn simulated_commands(controller: &Controller) -> Self {
        Self::simulated(controller, controller.command_addr())
    }

    /// A status reader of the controller, in its simulated time.
    pub(crate) fn simulated_status(controller: &Controller) -> Self {
        Self::simulated(controller, controller.status_addr())
    }

    fn simulated(controller: &Controller, address: SocketAddr) -> Self {
        let clock = controller.clock().expect("it has a simulated clock");
        let mut stream = clock.connect(address).expect("the controller listens");
        stream.set_timeout(Some(LIMIT));
        Self { stream, framer: Framer::default() }
    }

    /// True if neither bytes nor an end come for so long.
    pub(crate) fn is_quiet_for(&mut self, time: Duration) -> bool {
        assert!(self.framer.is_idle());
        self.stream.set_timeout(Some(time));
        let read = self.stream.read(self.framer.spare());
        self.stream.set_timeout(Some(LIMIT));
        if let Ok(count) = read {
            self.framer.filled(count);
        }
        read.is_err_and(|error| error.kind() == ErrorKind::WouldBlock)
    }
}

impl<S: Read + Write> Peer<S> {
    pub(crate) fn send(&mut self, bytes: impl AsRef<[u8]>) {
        self.stream.write_all(bytes.as_ref()).expect("the connection is open");
    }

    /// The next message.
    pub(crate) fn receive(&mut self) -> String {
        loop {
            if let Some(frame) = self.framer.next_frame().expect("the controller sends frames") {
                return String::from_utf8(frame.to_vec()).expect("the controller sends UTF-8");
            }
            match self.stream.read(self.framer.spare()) {
                Ok(0) => panic!("the connection has ended"),
                Ok(count) => self.framer.filled(count),
                // The process was stopped for a moment.
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                Err(error) => panic!("a message comes: {error}"),
            }
        }
    }

    /// So many bytes that come next, whatever they are.
    pub(crate) fn receive_bytes(&mut self, count: usize) -> Vec<u8> {
        assert!(self.framer.is_idle());
        let mut bytes = vec![0; count];
        self.stream.read_exact(&mut bytes).expect("bytes come");
        bytes
    }

    /// Sends a request, and gives its reply.
    pub(crate) fn ask(&mut self, request: &str) -> Value {
        self.send(request);
        json(&self.receive())
    }

    /// Sends a command that has no fields, and gives its reply.
    pub(crate) fn call(&mut self, command: &str) -> Value {
        self.ask(&request(command))
    }

    /// Bytes before the end of the connection.
    pub(crate) fn read_to_end(&mut self) -> Vec<u8> {
        let mut rest = self.framer.partial().to_vec();
        match self.stream.read_to_end(&mut rest) {
            Ok(_) => {}
            Err(error) => assert_eq!(error.kind(), ErrorKind::ConnectionReset, "the connection ends"),
        }
        rest
    }

    /// Asserts that nothing has come: a later exchange is answered first.
    pub(crate) fn assert_quiet(&mut self) {
        let reply = self.call("get_version");
        assert_eq!(reply["cmdName"], "get_version");
    }
}

/// A request without fields.
pub(crate) fn request(command: &str) -> String {
    format!("{{\"cmdName\":\"{command}\"}}")
}

pub(crate) fn json(text: &str) -> Value {
    text.parse().unwrap_or_else(|error| panic!("{error}: {text}"))
}

/// Options of a controller that changes its state at once and writes as the document does: whole numbers without a
/// fraction, which compare with those of a test.
pub(crate) fn document() -> Builder {
    Controller::builder().delays(Delays::NONE).firmware(Firmware::Document)
}

/// Starts a controller whose arm is enabled.
pub(crate) fn enabled(builder: Builder) -> Controller {
    let controller = builder.start().expect("loopback has ports");
    controller.set_state(|state| (state.powered, state.enabled) = (true, true));
    controller
}

/// Options of a controller whose time the test moves on, and that sends no packets but those asked for.
fn still() -> Builder {
    document().stepped_clock().status_period(Duration::MAX)
}

/// A controller as it starts, whose time the test moves on.
pub(crate) fn fresh() -> Controller {
    still().start().expect("loopback has ports")
}

/// A controller whose arm is enabled, and whose time the test moves on.
pub(crate) fn stepped() -> Controller {
    enabled(still())
}

/// A controller as it starts, without packets but those asked for, and its simulated time.
pub(crate) fn simulated() -> (SimulatedClock, Controller) {
    let clock = SimulatedClock::new();
    let controller = document().status_period(Duration::MAX).clock(&clock).start().expect("loopback has ports");
    (clock, controller)
}

pub(crate) fn assert_accepted(reply: &Value, command: &str) {
    assert_eq!((&reply["errorCode"], &reply["cmdName"]), (&"0".into(), &command.into()), "{reply}");
}

pub(crate) fn assert_refused(reply: &Value, command: &str) {
    let message = format!("call {command} failed");
    let expected = format!("{{\"errorCode\":\"2\",\"errorMsg\":\"{message}\",\"cmdName\":\"{command}\"}}");
    assert_eq!(*reply, json(&expected));
}

pub(crate) fn assert_unknown(reply: &Value) {
    assert_eq!(*reply, json(r#"{"errorCode":"1","errorMsg":"Exception:function call failed"}"#));
}
