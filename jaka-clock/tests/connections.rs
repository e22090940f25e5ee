//! Bytes between ends that take part, and from strangers.

use std::io::{ErrorKind, Read, Write};
use std::net::{Shutdown, SocketAddr, TcpListener, TcpStream};
use std::sync::mpsc;
use std::thread;
use std::time::Duration;

use jaka_clock::{Clock, Listener, SimulatedClock, Socket, Stream};

const HOUR: Duration = Duration::from_secs(3600);

/// Limit for what a test waits for in real time.
const LIMIT: Duration = Duration::from_secs(60);

/// Number of bytes that can be on their way to an end that does not read.
const WINDOW: usize = 1 << 20;

/// Free port of loopback.
fn anywhere() -> SocketAddr {
    SocketAddr::from(([127, 0, 0, 1], 0))
}

fn listener(clock: &SimulatedClock) -> Listener {
    clock.bind(anywhere()).expect("loopback has free ports")
}

/// Both ends of a connection.
fn ends(clock: &SimulatedClock) -> [Stream; 2] {
    let listener = listener(clock);
    let near = clock.connect(listener.local_addr()).expect("it listens");
    [near, listener.accept().expect("the client waits")]
}

/// An end that takes part, and one that does not.
fn end_and_stranger(clock: &SimulatedClock) -> (Stream, TcpStream) {
    let listener = TcpListener::bind(anywhere()).expect("loopback has free ports");
    let near = clock.connect(listener.local_addr().expect("it is bound")).expect("it listens");
    let (stranger, _) = listener.accept().expect("the client waits");
    stranger.set_read_timeout(Some(LIMIT)).expect("it is a time");
    (near, stranger)
}

fn read(end: &mut Stream, timeout: Option<Duration>) -> Result<Vec<u8>, ErrorKind> {
    end.set_timeout(timeout);
    let mut space = [0; 4096];
    let count = end.read(&mut space).map_err(|error| error.kind())?;
    Ok(space[..count].to_vec())
}

/// Writes until there was no room for a second, and counts what was written.
fn fill(end: &mut Stream, piece: usize) -> usize {
    end.set_timeout(Some(Duration::from_secs(1)));
    let mut written = 0;
    loop {
        match end.write(&vec![0; piece]) {
            Ok(count) => written += count,
            Err(error) => {
                assert_eq!(error.kind(), ErrorKind::WouldBlock);
                return written;
            }
        }
    }
}

#[test]
fn bytes_come_at_the_time_at_which_they_are_written() {
    let clock = SimulatedClock::new();
    let [mut near, mut far] = ends(&clock);
    let place = clock.participant();
    thread::scope(|scope| {
        scope.spawn(|| {
            place.run(|| {
                for _ in 0..1000 {
                    clock.sleep(Duration::from_millis(8));
                    far.write_all(b"a packet").expect("there is room");
                }
                clock.sleep(Duration::from_secs(1));
                drop(far);
            });
        });
        for count in 1..=1000 {
            assert_eq!(read(&mut near, Some(HOUR)).expect("it comes"), b"a packet");
            assert_eq!(clock.elapsed(), Duration::from_millis(8) * count);
        }
        // Nothing for a while, and then the end.
        assert_eq!(read(&mut near, Some(Duration::from_millis(999))), Err(ErrorKind::WouldBlock));
        assert_eq!(read(&mut near, Some(HOUR)), Ok(Vec::new()));
        assert_eq!(clock.elapsed(), Duration::from_secs(9));
    });
}

#[test]
fn what_does_not_wait_finds_all_that_was_written() {
    let clock = SimulatedClock::new();
    let listener = TcpListener::bind(anywhere()).expect("loopback has free ports");
    let stream = TcpStream::connect(listener.local_addr().expect("it is bound")).expect("it listens");
    let time = Clock::simulated(&clock);
    let near = Socket::connected(stream, &time).expect("it is connected");
    let (far_stream, peer) = listener.accept().expect("the client waits");
    let (far, _work) = Socket::accepted(far_stream, peer, &time).expect("it is connected");
    near.set_nonblocking(true).expect("it is open");
    let mut space = [0; 8];
    for _ in 0..1000 {
        assert_eq!(near.peek().map_err(|error| error.kind()), Err(ErrorKind::WouldBlock));
        let nothing = near.read(&mut space, Some(HOUR));
        assert_eq!(nothing.map_err(|error| error.kind()), Err(ErrorKind::WouldBlock));
        far.write_all(b"x", Some(HOUR)).expect("there is room");
        assert_eq!(near.peek().expect("it was written"), 1);
        assert_eq!(near.read(&mut space, Some(HOUR)).expect("it was written"), 1);
    }
    far.shutdown(Shutdown::Both).expect("it is open");
    assert_eq!(near.peek().expect("it has ended"), 0);
    assert_eq!(clock.elapsed(), Duration::ZERO);
}

#[test]
fn a_connection_that_is_to_be_accepted_keeps_time_from_going_on() {
    let clock = SimulatedClock::new();
    let listener = listener(&clock);
    thread::scope(|scope| {
        scope.spawn(|| {
            // The read begins before: later, it would only be easier.
            thread::sleep(Duration::from_millis(50));
            let mut far = listener.accept().expect("the client waits");
            far.write_all(b"welcome").expect("there is room");
        });
        let mut near = clock.connect(listener.local_addr()).expect("it listens");
        assert_eq!(read(&mut near, Some(Duration::from_millis(1))).expect("it comes"), b"welcome");
        assert_eq!(clock.elapsed(), Duration::ZERO);
    });
    // One that is never accepted keeps it only until nobody accepts any more.
    let mut near = clock.connect(listener.local_addr()).expect("it listens");
    drop(listener);
    clock.sleep(Duration::from_secs(1));
    // Its end takes no time.
    assert_ne!(read(&mut near, Some(HOUR)), Err(ErrorKind::WouldBlock));
    assert_eq!(clock.elapsed(), Duration::from_secs(1));
}

#[test]
fn a_writer_waits_for_room_until_the_other_end_reads() {
    let clock = SimulatedClock::new();
    let [mut near, mut far] = ends(&clock);
    assert_eq!((fill(&mut near, 1 << 16), clock.elapsed()), (WINDOW, Duration::from_secs(1)));
    let more = vec![0; 1 << 24];
    let place = clock.participant();
    let (sent, read) = thread::scope(|scope| {
        let reader = scope.spawn(|| {
            place.run(|| {
                clock.sleep(Duration::from_secs(10));
                let mut read_so_far = 0;
                while read_so_far < WINDOW + more.len() {
                    read_so_far += read(&mut far, Some(HOUR)).expect("it comes").len();
                }
                read_so_far
            })
        });
        near.set_timeout(Some(HOUR));
        let sent = near.write_all(&more);
        (sent, clock.outside(|| reader.join()))
    });
    sent.expect("there is room in the end");
    assert_eq!(read.expect("it does not panic"), WINDOW + more.len());
    assert_eq!(clock.elapsed(), Duration::from_secs(11));
}

#[test]
fn each_connection_has_the_same_room() {
    let clock = SimulatedClock::new();
    for (count, piece) in (1..).zip([100, 3500, 1 << 16, 1 << 24]) {
        let [mut near, mut far] = ends(&clock);
        assert_eq!((fill(&mut near, piece), clock.elapsed()), (WINDOW, Duration::from_secs(count)));
        // What was read makes room for as much.
        far.read_exact(&mut [0; 1000]).expect("it was written");
        assert_eq!(near.write(&vec![0; piece]).expect("there is room"), piece.min(1000));
        assert_eq!(clock.elapsed(), Duration::from_secs(count));
    }
    // Also before it is accepted.
    let listener = listener(&clock);
    let mut near = clock.connect(listener.local_addr()).expect("it listens");
    assert_eq!(near.write(&vec![0; 1 << 24]).expect("there is room"), WINDOW);
}

#[test]
fn a_shutdown_wakes_who_reads_at_both_ends() {
    let clock = SimulatedClock::new();
    let ends = ends(&clock);
    let places = [clock.participant(), clock.participant()];
    thread::scope(|scope| {
        for (mut end, place) in ends.iter().zip(places) {
            scope.spawn(move || place.run(|| assert_eq!(end.read(&mut [0]).expect("it ends"), 0)));
        }
        clock.sleep(Duration::from_secs(2));
        ends[0].shutdown(Shutdown::Both).expect("it is open");
    });
    assert_eq!(clock.elapsed(), Duration::from_secs(2));
}

#[test]
fn bytes_of_a_stranger_come_before_time_goes_on() {
    let clock = SimulatedClock::with_grace(LIMIT);
    let (mut near, mut far) = end_and_stranger(&clock);
    thread::scope(|scope| {
        scope.spawn(|| {
            for _ in 0..10 {
                far.read_exact(&mut [0; 5]).expect("it comes");
                // As slow as a stranger can be, as long as it takes less than the grace.
                thread::sleep(Duration::from_millis(10));
                far.write_all(b"answer").expect("there is room");
            }
        });
        for _ in 0..10 {
            near.write_all(b"query").expect("there is room");
            assert_eq!(read(&mut near, Some(Duration::from_millis(1))).expect("it comes"), b"answer");
        }
    });
    assert_eq!(clock.elapsed(), Duration::ZERO);
}

#[test]
fn a_stranger_that_is_silent_or_does_not_read_keeps_nobody_for_long() {
    let clock = SimulatedClock::new();
    let (mut near, far) = end_and_stranger(&clock);
    assert_eq!(read(&mut near, Some(HOUR)), Err(ErrorKind::WouldBlock));
    assert_eq!(clock.elapsed(), HOUR);
    // The system has room for more than the clock would give, and may get more in a moment: it takes a second at least.
    assert!(fill(&mut near, 1 << 16) > 0);
    assert!(clock.elapsed() >= HOUR + Duration::from_secs(1));
    drop(far);
    // It has not read all.
    assert_eq!(read(&mut near, None), Err(ErrorKind::ConnectionReset));
}

#[test]
fn a_connection_that_was_accepted_and_ended_before_its_program_goes_on_keeps_no_time() {
    let clock = SimulatedClock::new();
    let listener = TcpListener::bind(anywhere()).expect("loopback has free ports");
    let address = listener.local_addr().expect("it is bound");
    clock.listen(address);
    let near = TcpStream::connect(address).expect("it listens");
    let (far, peer) = listener.accept().expect("the client waits");
    let time = Clock::simulated(&clock);
    drop(Socket::accepted(far, peer, &time).expect("it is connected"));
    let (done, result) = mpsc::channel();
    let theirs = clock.clone();
    thread::spawn(move || {
        let near = Socket::connected(near, &time).expect("it is connected");
        let read = near.read(&mut [0], Some(HOUR)).expect("it has ended");
        theirs.sleep(HOUR);
        done.send((read, theirs.elapsed()))
    });
    assert_eq!(result.recv_timeout(Duration::from_secs(60)).expect("time goes on"), (0, HOUR));
}
