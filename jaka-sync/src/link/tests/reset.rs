//! A reset: what is queued is not delivered. The witness is a plain socket that reads nothing until the connection is
//! reset.

use std::io::Read;
use std::sync::Arc;

use jaka_proto::exchange::TextOnly;

use super::*;
use crate::StopHandle;

/// Number of commands of some 4 KB each that are queued for sending.
const QUEUED: usize = 40;

/// Greatest number of bytes that the network between the ends may have taken: the witness's receive buffer, and what
/// its end accounts for it.
const TAKEN: usize = 64 << 10;

/// A connection with commands that wait for the other end to read, which it does not.
fn with_a_queue() -> (Arc<Link>, TcpStream) {
    let (stream, server) = sockets(1 << 20);
    let link = Arc::new(Link::new(stream, Tap::default(), &Config::new().reply_timeout(LONG)));
    post(&link, LONG, QUEUED).expect("the system takes it");
    (link, server)
}

/// Reads to the end of the stream; returns the number of bytes and the outcome of the last read.
fn read_to_end(mut server: TcpStream) -> (usize, io::Result<()>) {
    server.set_read_timeout(Some(LONG)).expect("it is a time");
    let mut bytes = Vec::new();
    let end = server.read_to_end(&mut bytes);
    (bytes.len(), end.map(drop))
}

fn assert_discarded(server: TcpStream) {
    let (arrived, end) = read_to_end(server);
    assert_eq!(end.expect_err("it is reset").kind(), io::ErrorKind::ConnectionReset);
    assert!(arrived < TAKEN, "{arrived} bytes arrived");
}

fn cause() -> Disconnect {
    Disconnect::Ended { by: "a test".to_owned() }
}

#[test]
fn the_witness_sees_what_an_orderly_end_delivers() {
    let (link, server) = with_a_queue();
    link.break_off(&mut link.state.lock(), cause());
    drop(link);
    let (arrived, end) = read_to_end(server);
    end.expect("the end is orderly");
    assert!(arrived > QUEUED * 4000, "{arrived} bytes arrived");
}

#[test]
fn a_reset_discards_what_is_queued_while_stop_handles_live() {
    let (link, server) = with_a_queue();
    let stop = StopHandle::new(Arc::clone(&link), LONG);
    link.reset(cause());
    assert_discarded(server);
    let error = stop.stop().expect_err("the connection is reset");
    assert!(error.is_disconnected() && !error.may_have_run(), "{error}");
    assert_eq!(link.broken().expect("it is broken").to_string(), cause().to_string());
    assert!(link.peer_addr().is_err());
}

#[test]
fn a_reset_discards_what_is_queued_while_a_thread_reads() {
    let (link, server) = with_a_queue();
    let reading = {
        let link = Arc::clone(&link);
        thread::spawn(move || {
            let sent = send_named(&link, "y", ENDLESS, &mut |out| out.raw("{\"cmdName\":\"y\"}"))?;
            link.wait(&sent, &mut String::new(), &mut TextOnly)
        })
    };
    until(|| link.state.lock().inbound.is_none());
    link.reset(cause());
    assert_discarded(server);
    let error = reading.join().expect("it does not panic").expect_err("the connection is reset");
    assert!(
        matches!(error.kind(), ErrorKind::Disconnected { sent: true, cause, .. } if matches!(**cause, Disconnect::Ended { .. }))
    );
}

#[test]
fn a_reset_after_an_orderly_end_still_discards_and_the_first_cause_stays() {
    let (link, server) = with_a_queue();
    link.break_off(&mut link.state.lock(), Disconnect::Panicked);
    link.reset(cause());
    assert_discarded(server);
    assert!(matches!(*link.broken().expect("it is broken"), Disconnect::Panicked));
}

#[test]
fn a_reset_discards_what_is_queued_while_a_thread_writes() {
    let (stream, server) = sockets(4096);
    let link = Arc::new(Link::new(stream, Tap::default(), &Config::new()));
    let writing = {
        let link = Arc::clone(&link);
        thread::spawn(move || post(&link, ENDLESS, 1000))
    };
    // The queued bytes stay queued, since the other end does not read. Where the thread is held up, it does not write
    // yet, and this proves less.
    let mut last = (0, Instant::now());
    until(|| {
        let outstanding = link.outstanding(OWNER);
        if outstanding != last.0 {
            last = (outstanding, Instant::now());
        }
        last.1.elapsed() >= Duration::from_millis(300)
    });
    let before = Instant::now();
    link.reset(cause());
    assert!(before.elapsed() < LONG);
    let error = writing.join().expect("it does not panic").expect_err("the connection is reset");
    assert!(
        matches!(error.kind(), ErrorKind::Disconnected { cause, .. } if matches!(**cause, Disconnect::Ended { .. })),
        "{error:?}"
    );
    assert_discarded(server);
}
