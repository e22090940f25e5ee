//! Turns and deadlines of sending, and a reply that is lost.

use std::io::{Read, Write};
use std::sync::Arc;

use jaka_proto::exchange::TextOnly;

use super::*;
use crate::StopHandle;

/// A deadline that is short, and long enough for a busy machine to begin.
const SHORT: Duration = Duration::from_millis(300);

/// More bytes than any buffer between the two ends holds.
const HUGE: usize = 1 << 20;

/// Kind of the system's error for a send that failed.
fn cause<T: std::fmt::Debug>(sent: Result<T, Error>) -> io::ErrorKind {
    match sent.expect_err("it cannot be sent").kind() {
        ErrorKind::Disconnected { sent: true, cause, .. } => match &**cause {
            Disconnect::Write(source) => source.kind(),
            other => panic!("{other}"),
        },
        other => panic!("{other}"),
    }
}

/// Sends a command of this length.
fn send(link: &Link, timeout: Duration, len: usize) -> Result<Sent<'static>, Error> {
    let pad = "x".repeat(len);
    let write = &mut |out: &mut Writer| out.raw(&format!("{{\"cmdName\":\"y\",\"pad\":\"{pad}\"}}"));
    send_named(link, "y", timeout, write)
}

/// Fills the buffers between the two ends without the link.
fn fill(link: &Link) -> usize {
    let stream = link.state.lock().stream.clone().expect("it is open");
    stream.set_nonblocking(true).expect("it is open");
    let (mut filled, mut refused) = (0, 0);
    // Bytes on their way make room once more where they arrive, after a time of the system. Attempts are counted, and
    // not the time, in which this thread may be held up; a sleep that is longer only makes it surer.
    while refused < 500 {
        match stream.system().write(&[b' '; 4096]) {
            Ok(len) => (filled, refused) = (filled + len, 0),
            Err(error) => {
                assert_eq!(error.kind(), io::ErrorKind::WouldBlock);
                refused += 1;
                thread::sleep(Duration::from_millis(2));
            }
        }
    }
    let nonblocking = link.state.lock().mode == Mode::Nonblocking;
    stream.set_nonblocking(nonblocking).expect("it is open");
    filled
}

/// In each mode at once: they wait most of the time.
fn in_each_mode(check: fn(Mode)) {
    thread::scope(|scope| [Mode::Blocking, Mode::Nonblocking].map(|mode| drop(scope.spawn(move || check(mode)))));
}

#[test]
fn what_the_system_takes_piece_by_piece_arrives_whole() {
    for mode in [Mode::Blocking, Mode::Nonblocking] {
        let (link, mut server) = connection(mode);
        let reading = thread::spawn(move || {
            let mut bytes = String::new();
            server.read_to_string(&mut bytes).map(|_| bytes)
        });
        send(&link, ENDLESS, HUGE).expect("it is sent");
        assert_eq!(post(&link, ENDLESS, 400).expect("it is sent"), 400);
        drop(link);
        let mut expected = Writer::new();
        expected.raw(&format!("{{\"cmdName\":\"y\",\"pad\":\"{}\"}}", "x".repeat(HUGE)));
        (0..400).for_each(|index| write(index, &mut expected));
        let arrived = reading.join().expect("the thread does not panic").expect("it is text");
        assert!(arrived == expected.as_str(), "{} of {} bytes", arrived.len(), expected.as_str().len());
    }
}

#[test]
fn a_command_of_which_nothing_was_sent_by_its_deadline_did_not_run_and_the_connection_lives() {
    in_each_mode(|mode| {
        let (link, mut server) = connection(mode);
        let filled = fill(&link);
        let since = Instant::now();
        for _ in 0..2 {
            let error = send(&link, SHORT, 10).expect_err("nobody reads");
            assert!(matches!(error.kind(), ErrorKind::NotSentInTime { .. }), "{error:?}");
            assert!(error.is_timeout() && !error.may_have_run() && !error.is_disconnected());
            assert_eq!(error.to_string(), "`y` could not be sent within 300ms; it did not run");
        }
        let error = post(&link, SHORT, 3).expect_err("nobody reads");
        assert!(matches!(error.kind(), ErrorKind::NotSentInTime { .. }), "{error:?}");
        assert!(since.elapsed() > SHORT * 3 / 2, "{:?}", since.elapsed());
        assert_eq!(outstanding(&link), (0, 0));
        server.read_exact(&mut vec![0; filled]).expect("the link writes");
        let sent = send(&link, LONG, 10).expect("there is room");
        server.read_exact(&mut [0; 34]).expect("the link writes");
        server.write_all(reply("y", 0, "").as_bytes()).expect("the link reads");
        link.wait(&sent, &mut String::new(), &mut TextOnly).expect("it is answered");
    });
}

#[test]
fn a_command_that_is_sent_in_part_by_its_deadline_breaks_the_connection() {
    in_each_mode(|mode| {
        let (link, _server) = connection(mode);
        let error = loop {
            let since = Instant::now();
            let error = send(&link, SHORT, HUGE).expect_err("nobody reads");
            assert!(since.elapsed() < LONG, "{:?}", since.elapsed());
            // This thread may have been held up until the deadline: then nothing was sent.
            if !matches!(error.kind(), ErrorKind::NotSentInTime { .. }) {
                break error;
            }
            assert!(link.broken().is_none());
        };
        assert_eq!(cause::<()>(Err(error)), io::ErrorKind::TimedOut);
        assert!(link.broken().is_some());
    });
}

#[test]
fn a_stop_ends_at_its_deadline_while_another_thread_cannot_send_on() {
    let (link, _server) = connection(Mode::Blocking);
    let link = Arc::new(link);
    let sending = {
        let link = Arc::clone(&link);
        thread::spawn(move || send(&link, ENDLESS, HUGE).map(drop))
    };
    until(|| link.state.lock().outbound.is_none());
    let since = Instant::now();
    let error = StopHandle::new(Arc::clone(&link), SHORT).stop().expect_err("it has no turn");
    assert!(matches!(error.kind(), ErrorKind::NotSentInTime { .. }), "{error:?}");
    assert!((SHORT..LONG).contains(&since.elapsed()), "{:?}", since.elapsed());
    link.reset(Disconnect::Panicked);
    assert!(sending.join().expect("it does not panic").is_err());
}

#[test]
fn a_stop_that_waits_goes_out_before_other_commands_that_wait() {
    let (link, mut server) = connection(Mode::Blocking);
    let link = Arc::new(link);
    // As a thread that sends holds the turn.
    let outbound = link.state.lock().outbound.take();
    let calling = {
        let link = Arc::clone(&link);
        thread::spawn(move || send(&link, LONG, 10).map(drop))
    };
    until(|| link.state.sleepers() == 1);
    let stop = StopHandle::new(Arc::clone(&link), LONG);
    let stopping = thread::spawn(move || stop.stop());
    until(|| link.state.sleepers() == 2);
    let mut state = link.state.lock();
    state.outbound = outbound;
    link.state.wake();
    drop(state);
    let mut first = [0; 26];
    server.read_exact(&mut first).expect("both are sent");
    assert_eq!(String::from_utf8_lossy(&first), "{\"cmdName\":\"stop_program\"}"[..26]);
    server.write_all(reply("stop_program", 0, "").as_bytes()).expect("the link reads");
    stopping.join().expect("it does not panic").expect("it is answered");
    calling.join().expect("it does not panic").expect("it goes out afterwards");
}

#[cfg(target_os = "linux")]
#[test]
fn the_cause_of_a_failed_send_is_the_first_one() {
    let (link, server) = connection(Mode::Nonblocking);
    SockRef::from(&server).set_linger(Some(Duration::ZERO)).expect("the socket is open");
    drop(server);
    until(|| link.peer_addr().is_err());
    // A second try would say that the pipe is broken.
    assert_eq!(cause(post(&link, LONG, 1)), io::ErrorKind::ConnectionReset);
}

#[test]
fn a_lost_reply_is_reported_before_anything_after_it_is_attributed() {
    let (link, mut server) = connection(Mode::Blocking);
    let send = |name| send_named(&link, name, LONG, &mut |out| write(0, out)).expect("it goes out");
    let (first, second) = (send("a"), send("b"));
    // The answer to the later command, and after it one that comes too late.
    server.write_all([reply("b", 0, ""), reply("a", 0, "")].concat().as_bytes()).expect("the link reads");
    let lost = link.wait(&first, &mut String::new(), &mut TextOnly);
    assert!(matches!(lost.as_ref().map_err(Error::kind), Err(ErrorKind::ReplyLost { .. })), "{lost:?}");
    assert!(link.broken().is_none(), "the next thread that waits finds it");
    link.wait(&second, &mut String::new(), &mut TextOnly).expect("it was answered");
}

#[test]
fn while_a_stop_is_on_its_way_out_no_other_command_begins_to_go_out() {
    let listener = TcpListener::bind("127.0.0.1:0").expect("loopback has free ports");
    let stream = TcpStream::connect(listener.local_addr().expect("it is bound")).expect("it listens");
    let link = Link::new(stream, Tap::default(), &Config::new());
    let send = |role| {
        let outgoing = Outgoing::named(&link.clock, "x", Cow::Borrowed("x"), Duration::from_millis(1)).in_role(role);
        link.take_turn(&outgoing).map(|(turn, state)| {
            // The turn locks the state when it is dropped.
            drop(state);
            drop(turn);
        })
    };
    let stop = link.pass_first();
    let error = send(None).expect_err("the stop goes first");
    assert!(matches!(error.kind(), ErrorKind::NotSentInTime { .. }), "{error:?}");
    send(Some(Role::Stop)).expect("nobody else sends");
    drop(stop);
    send(None).expect("nobody else sends");
}
