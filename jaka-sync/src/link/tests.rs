mod question;
mod reset;

use std::io::Read;
use std::net::TcpListener;
use std::thread;

use socket2::SockRef;

use super::*;

/// More than any buffer between the two ends holds.
const COMMANDS: usize = 4000;

/// A command of 4 KB, each another.
fn write(index: usize, out: &mut Writer) {
    out.raw(&format!("{{\"cmdName\":\"x\",\"index\":{index},\"pad\":\"{}\"}}", "x".repeat(4000)));
}

/// Both ends of a connection: the system holds so much for this end to send, and little for the other to receive.
fn sockets(send_buffer: usize) -> (TcpStream, TcpStream) {
    let listener = TcpListener::bind("127.0.0.1:0").expect("loopback has free ports");
    SockRef::from(&listener).set_recv_buffer_size(4096).expect("it can be small");
    let stream = TcpStream::connect(listener.local_addr().expect("it is bound")).expect("it listens");
    SockRef::from(&stream).set_send_buffer_size(send_buffer).expect("it can be set");
    let (server, _) = listener.accept().expect("the client waits");
    (stream, server)
}

/// A connection whose system holds little, and its other end.
fn connection(mode: Mode) -> (Link, TcpStream) {
    let (stream, server) = sockets(4096);
    let link = Link::new(stream, Tap::default(), &Config::new());
    Link::switch(&mut link.lock(), mode).expect("the socket is open");
    (link, server)
}

/// What the system said where a send failed.
fn cause(sent: Result<usize, Error>) -> ErrorKind {
    match sent.expect_err("it cannot be sent") {
        Error::Disconnected { sent: true, cause, .. } => match &*cause {
            Disconnect::Write(source) => source.kind(),
            other => panic!("{other}"),
        },
        other => panic!("{other}"),
    }
}

#[test]
fn what_the_system_takes_piece_by_piece_arrives_whole() {
    for mode in [Mode::Blocking, Mode::Nonblocking] {
        let (link, mut server) = connection(mode);
        let reading = thread::spawn(move || {
            let mut bytes = String::new();
            server.read_to_string(&mut bytes).map(|_| bytes)
        });
        assert_eq!(link.post("x", None, COMMANDS, &mut write).expect("it is sent"), COMMANDS);
        drop(link);
        let mut expected = Writer::new();
        (0..COMMANDS).for_each(|index| write(index, &mut expected));
        let arrived = reading.join().expect("the thread does not panic").expect("it is text");
        assert!(arrived == expected.as_str(), "{} of {} bytes", arrived.len(), expected.as_str().len());
    }
}

#[test]
fn a_send_waits_for_the_write_timeout_where_the_system_takes_nothing_at_first() {
    let limit = Duration::from_millis(50);
    let (link, _server) = connection(Mode::Nonblocking);
    link.lock().stream.as_ref().expect("it is open").set_write_timeout(Some(limit)).expect("it is a time");
    let stream = link.lock().stream.clone().expect("it is open");
    let full = (0..COMMANDS).find_map(|_| (&*stream).write(&[b' '; 4096]).err());
    assert_eq!(full.expect("nobody reads").kind(), ErrorKind::WouldBlock);
    let since = Instant::now();
    let kind = cause(link.post("x", None, 1, &mut write));
    assert!(matches!(kind, ErrorKind::WouldBlock | ErrorKind::TimedOut), "{kind}");
    assert!(since.elapsed() > limit / 2, "{:?}", since.elapsed());
}

#[cfg(target_os = "linux")]
#[test]
fn the_cause_of_a_failed_send_is_the_first_one() {
    let (link, server) = connection(Mode::Nonblocking);
    SockRef::from(&server).set_linger(Some(Duration::ZERO)).expect("the socket is open");
    drop(server);
    let since = Instant::now();
    while link.peer_addr().is_ok() && since.elapsed() < Duration::from_secs(60) {
        thread::yield_now();
    }
    // A second try would say that the pipe is broken.
    assert_eq!(cause(link.post("x", None, 1, &mut write)), ErrorKind::ConnectionReset);
}
