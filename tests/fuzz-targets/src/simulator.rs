//! Whatever a client sends to a simulated controller.

use std::io::{self, ErrorKind, Read, Write};
use std::net::{Shutdown, TcpStream};
use std::time::Duration;

use jaka_proto::framing::Framer;
use jaka_proto::messages::status::RobotStatus;
use jaka_proto::wire::{Decode, Reader};
use jaka_proto::{Envelope, Request};
use jaka_sim::Controller;

/// Timeout for the requests on a busy machine, after which the test fails.
const LIMIT: Duration = Duration::from_secs(20);

/// Time of the controller between two lines.
const STEP: Duration = Duration::from_millis(400);

/// The most bytes and lines of an input, so that it takes little time.
const MOST_BYTES: usize = 16 << 10;
const MOST_LINES: usize = 50;

/// The lines are sent one by one, with some of the controller's time in between. Each request is carried out, each
/// reply is JSON, and the status packet after the last line decodes.
///
/// # Panics
/// One of these is not so.
pub fn simulator(data: &[u8]) {
    if data.len() > MOST_BYTES {
        return;
    }
    let builder = Controller::builder().stepped_clock().status_period(Duration::MAX);
    let controller = builder.start().expect("loopback has free ports");
    let client = TcpStream::connect(controller.command_addr()).expect("the controller listens");
    client.set_nodelay(true).expect("a socket sends at once");
    let mut replies = client.try_clone().expect("a socket can be shared");
    let replies = std::thread::scope(|scope| {
        let reader = scope.spawn(move || {
            let mut bytes = Vec::new();
            replies.read_to_end(&mut bytes).map(|_| bytes)
        });
        send(data, &controller, &client);
        reader.join().expect("reading does not panic")
    });
    check_replies(&replies.unwrap_or_default());
    check_status(&controller);
}

/// Sends the lines, up to a request that ends the session, and then the end of the stream.
fn send(data: &[u8], controller: &Controller, mut client: &TcpStream) {
    let (mut framer, mut requests) = (Framer::new(MOST_BYTES), 0);
    for line in data.split_inclusive(|byte| *byte == b'\n').take(MOST_LINES) {
        if client.write_all(line).is_err() {
            break;
        }
        framer.push(line);
        let (count, is_last) = count_requests(&mut framer);
        requests += count;
        assert!(controller.wait_for_requests(requests, LIMIT), "not all requests were carried out");
        if is_last {
            break;
        }
        controller.advance(STEP);
    }
    // An error says that the controller has ended the connection.
    client.shutdown(Shutdown::Write).ok();
}

/// The requests in the framer up to the one that ends the session, and whether that has come.
fn count_requests(framer: &mut Framer) -> (usize, bool) {
    let mut count = 0;
    loop {
        match framer.next_frame() {
            Ok(Some(frame)) => {
                count += 1;
                let request = std::str::from_utf8(frame).ok().and_then(|text| Request::read(text).ok());
                if request.is_some_and(|request| request.info().ends_session) {
                    return (count, true);
                }
            }
            Ok(None) => return (count, false),
            Err(_) => drop(framer.resync()),
        }
    }
}

fn check_replies(bytes: &[u8]) {
    let mut framer = Framer::default();
    framer.push(bytes);
    while let Some(frame) = framer.next_frame().expect("replies are frames") {
        let text = std::str::from_utf8(frame).expect("replies are text");
        let envelope = Envelope::read(text).unwrap_or_else(|error| panic!("{error}: {text}"));
        assert!(envelope.code.is_ok(), "{text}");
    }
    assert!(framer.is_idle(), "a reply is cut off");
}

fn check_status(controller: &Controller) {
    let packet = read_packet(controller).expect("a packet comes on connecting");
    let status = RobotStatus::decode(&mut Reader::new(&packet)).unwrap_or_else(|error| panic!("{error}: {packet}"));
    let position = status.joint_actual_position.expect("the arm has a position");
    assert!(position.0.iter().all(|degrees| degrees.abs() < 1e4), "{position:?}");
}

fn read_packet(controller: &Controller) -> io::Result<String> {
    let mut stream = TcpStream::connect(controller.status_addr())?;
    stream.set_read_timeout(Some(LIMIT))?;
    let mut framer = Framer::default();
    loop {
        if let Some(frame) = framer.next_frame().map_err(io::Error::other)? {
            return String::from_utf8(frame.to_vec()).map_err(io::Error::other);
        }
        match stream.read(framer.spare()) {
            Ok(0) => return Err(ErrorKind::UnexpectedEof.into()),
            Ok(count) => framer.filled(count),
            // libFuzzer sends itself signals.
            Err(error) if error.kind() == ErrorKind::Interrupted => {}
            Err(error) => return Err(error),
        }
    }
}
