//! Flows of clients of others against a simulated controller, as bytes: what they send, in their order and with their
//! blanks, how they find the end of a reply, and which keys they read.
//!
//! The clients are described, not copied. Where one would misread a reply or wait for ever, its test says so. Time goes
//! on when a test says so.

mod inspection;
mod mqtt_control;
mod ros_driver;
mod transcripts;
mod vendor_library;

use std::io::{ErrorKind, Read, Write};
use std::net::TcpStream;

use jaka_proto::framing::Framer;
use jaka_tests::{Arm, LONG};
use serde_json::{Map, Value};

/// A client's connection to the command port.
struct Wire<'a> {
    arm: &'a Arm,
    stream: TcpStream,
    framer: Framer,
    sent: usize,
    /// How many requests have no reply yet.
    outstanding: usize,
    /// Bytes that have arrived, and that the client has not read.
    arrived: Vec<u8>,
}

impl<'a> Wire<'a> {
    fn connect(arm: &'a Arm) -> Self {
        let stream = TcpStream::connect(arm.command_addr()).expect("the controller listens");
        stream.set_read_timeout(Some(LONG)).expect("a timeout can be set");
        let (framer, arrived) = (Framer::default(), Vec::new());
        Self { arm, stream, framer, sent: 0, outstanding: 0, arrived }
    }

    /// Sends these bytes, and returns when the controller has carried them out.
    fn send(&mut self, bytes: &str) {
        self.stream.write_all(bytes.as_bytes()).expect("it is connected");
        (self.sent, self.outstanding) = (self.sent + 1, self.outstanding + 1);
        assert!(self.arm.wait_for_requests(self.sent, LONG), "{bytes}");
        assert_eq!(self.arm.requests().last().map(String::as_str), Some(bytes));
    }

    /// One read of at most so many bytes, by a client that is so slow that all replies have arrived.
    ///
    /// How TCP cuts them does not matter here: the clients count on a reply that comes in one piece.
    fn recv(&mut self, most: usize) -> String {
        while self.outstanding > 0 {
            let frame = self.next_frame();
            self.arrived.extend(frame);
            self.outstanding -= 1;
        }
        assert!(!self.arrived.is_empty(), "the client would wait for ever");
        let count = most.min(self.arrived.len());
        String::from_utf8(self.arrived.drain(..count).collect()).expect("the controller sends UTF-8")
    }

    /// Sends a request, and reads once.
    fn ask(&mut self, bytes: &str, most: usize) -> String {
        self.send(bytes);
        self.recv(most)
    }

    /// A byte that has come and that nobody has taken.
    fn peek(&self) -> Option<u8> {
        self.stream.set_nonblocking(true).expect("an option can be set");
        let mut byte = [0];
        let peeked = self.stream.peek(&mut byte);
        self.stream.set_nonblocking(false).expect("an option can be set");
        peeked.ok().filter(|count| *count > 0).map(|_| byte[0])
    }

    fn next_frame(&mut self) -> Vec<u8> {
        next_frame(&mut self.stream, &mut self.framer)
    }
}

/// The next message of a connection.
fn next_frame(stream: &mut TcpStream, framer: &mut Framer) -> Vec<u8> {
    loop {
        if let Some(frame) = framer.next_frame().expect("the controller sends frames") {
            return frame.to_vec();
        }
        match stream.read(framer.spare()) {
            Ok(0) => panic!("the connection has ended"),
            Ok(count) => framer.filled(count),
            Err(error) if error.kind() == ErrorKind::Interrupted => {}
            Err(error) => panic!("a message comes: {error}"),
        }
    }
}

/// A reply by a JSON parser that takes one object and nothing behind it, as Python's.
fn object(text: &str) -> Option<Map<String, Value>> {
    serde_json::from_str(text).ok()
}

/// Six numbers at a key.
fn six(reply: &Map<String, Value>, key: &str) -> Option<[f64; 6]> {
    let numbers: Vec<_> = reply.get(key)?.as_array()?.iter().filter_map(Value::as_f64).collect();
    numbers.try_into().ok()
}

/// True if no two of these differ by more.
fn are_close(a: [f64; 6], b: [f64; 6], tolerance: f64) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() <= tolerance)
}
