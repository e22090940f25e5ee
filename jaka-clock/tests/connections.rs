//! Bytes between ends that take part, and from strangers.

use std::io::{ErrorKind, Read, Write};
use std::net::{Shutdown, TcpListener, TcpStream};
use std::thread;
use std::time::Duration;

use jaka_clock::{Channel, SimulatedClock};

const HOUR: Duration = Duration::from_secs(3600);

/// An end that takes part.
struct End {
    stream: TcpStream,
    channel: Channel,
}

impl End {
    fn read(&self, patience: Duration) -> Result<Vec<u8>, ErrorKind> {
        let mut space = [0; 4096];
        let count = self.channel.read(&self.stream, &mut space, Some(patience)).map_err(|error| error.kind())?;
        Ok(space[..count].to_vec())
    }

    fn write(&self, bytes: &[u8], patience: Duration) -> Result<usize, ErrorKind> {
        self.channel.write(&self.stream, bytes, Some(patience)).map_err(|error| error.kind())
    }
}

fn listener() -> TcpListener {
    TcpListener::bind("127.0.0.1:0").expect("loopback has free ports")
}

/// Both ends of a connection.
fn ends(clock: &SimulatedClock) -> [End; 2] {
    let listener = listener();
    let stream = TcpStream::connect(listener.local_addr().expect("it is bound")).expect("it listens");
    let near = End { channel: clock.connected(&stream).expect("it is connected"), stream };
    let (stream, peer) = listener.accept().expect("the client waits");
    let (channel, _work) = clock.accepted(&stream, peer).expect("it is connected");
    [near, End { stream, channel }]
}

#[test]
fn bytes_come_at_the_time_at_which_they_are_written() {
    let clock = SimulatedClock::new();
    let [near, far] = ends(&clock);
    let place = clock.participant();
    thread::scope(|scope| {
        scope.spawn(|| {
            place.run(|| {
                for _ in 0..1000 {
                    clock.sleep(Duration::from_millis(8));
                    far.write(b"a packet", HOUR).expect("there is room");
                }
                clock.sleep(Duration::from_secs(1));
                drop(far);
            });
        });
        for count in 1..=1000 {
            assert_eq!(near.read(HOUR).expect("it comes"), b"a packet");
            assert_eq!(clock.elapsed(), Duration::from_millis(8) * count);
        }
        // Nothing for a while, and then the end.
        assert_eq!(near.read(Duration::from_millis(999)), Err(ErrorKind::WouldBlock));
        assert_eq!(near.read(HOUR), Ok(Vec::new()));
        assert_eq!(clock.elapsed(), Duration::from_secs(9));
    });
}

#[test]
fn what_does_not_wait_finds_all_that_was_written() {
    let clock = SimulatedClock::new();
    let [near, far] = ends(&clock);
    near.channel.set_nonblocking(true);
    for _ in 0..1000 {
        assert_eq!(near.read(HOUR), Err(ErrorKind::WouldBlock));
        far.write(b"x", HOUR).expect("there is room");
        assert_eq!(near.read(HOUR).expect("it was written"), b"x");
    }
    assert_eq!(clock.elapsed(), Duration::ZERO);
}

#[test]
fn a_connection_that_is_to_be_accepted_keeps_time_from_going_on() {
    let (clock, listener) = (SimulatedClock::new(), listener());
    let address = listener.local_addr().expect("it is bound");
    clock.listen(address);
    thread::scope(|scope| {
        scope.spawn(|| {
            thread::sleep(Duration::from_millis(100));
            let (stream, peer) = listener.accept().expect("the client waits");
            let (channel, _work) = clock.accepted(&stream, peer).expect("it is connected");
            channel.write_all(&stream, b"welcome", None).expect("there is room");
        });
        let stream = TcpStream::connect(address).expect("it listens");
        let near = End { channel: clock.connected(&stream).expect("it is connected"), stream };
        assert_eq!(near.read(Duration::from_millis(1)).expect("it comes"), b"welcome");
        assert_eq!(clock.elapsed(), Duration::ZERO);
    });
    // One that is never accepted keeps it only until nobody accepts any more.
    let stream = TcpStream::connect(address).expect("it listens");
    let near = End { channel: clock.connected(&stream).expect("it is connected"), stream };
    clock.stop_listening(address);
    drop(listener);
    clock.sleep(Duration::from_secs(1));
    // The system says that it has ended.
    assert_ne!(near.read(HOUR).map(|bytes| bytes.len()), Err(ErrorKind::WouldBlock));
}

#[test]
fn a_writer_waits_for_room_until_the_other_end_reads() {
    let clock = SimulatedClock::new();
    let [near, far] = ends(&clock);
    let mut written = 0;
    while let Ok(count) = near.write(&vec![0; 1 << 16], Duration::from_secs(1)) {
        written += count;
    }
    assert_eq!(clock.elapsed(), Duration::from_secs(1));
    // More than the system has room for, also where it makes more room by itself.
    let more = vec![0; 1 << 24];
    let place = clock.participant();
    let (sent, read) = thread::scope(|scope| {
        let reader = scope.spawn(|| {
            place.run(|| {
                clock.sleep(Duration::from_secs(10));
                let mut read = 0;
                while read < written + more.len() {
                    match far.read(HOUR) {
                        Ok(bytes) => read += bytes.len(),
                        Err(_) => break,
                    }
                }
                read
            })
        });
        let sent = near.channel.write_all(&near.stream, &more, Some(HOUR));
        (sent, clock.outside(|| reader.join()))
    });
    sent.expect("there is room in the end");
    assert_eq!(read.expect("it does not panic"), written + more.len());
    assert_eq!(clock.elapsed(), Duration::from_secs(11));
}

#[test]
fn a_shutdown_wakes_who_reads_at_both_ends() {
    let clock = SimulatedClock::new();
    let [near, far] = ends(&clock);
    let places = [clock.participant(), clock.participant()];
    thread::scope(|scope| {
        for (end, place) in [&near, &far].into_iter().zip(places) {
            scope.spawn(move || place.run(|| assert_eq!(end.read(HOUR), Ok(Vec::new()))));
        }
        clock.sleep(Duration::from_secs(2));
        near.channel.shutdown(&near.stream, Shutdown::Both).expect("it is open");
    });
    assert_eq!(clock.elapsed(), Duration::from_secs(2));
}

#[test]
fn bytes_of_a_stranger_come_before_time_goes_on() {
    let (clock, listener) = (SimulatedClock::new(), listener());
    let stream = TcpStream::connect(listener.local_addr().expect("it is bound")).expect("it listens");
    let near = End { channel: clock.connected(&stream).expect("it is connected"), stream };
    let (mut far, _) = listener.accept().expect("the client waits");
    thread::scope(|scope| {
        scope.spawn(|| {
            for _ in 0..10 {
                far.read_exact(&mut [0; 5]).expect("it comes");
                thread::sleep(Duration::from_millis(10));
                far.write_all(b"answer").expect("there is room");
            }
        });
        for _ in 0..10 {
            near.write(b"query", HOUR).expect("there is room");
            assert_eq!(near.read(Duration::from_millis(1)).expect("it comes"), b"answer");
        }
    });
    assert_eq!(clock.elapsed(), Duration::ZERO);
    // One that is silent keeps nobody for long.
    assert_eq!(near.read(HOUR), Err(ErrorKind::WouldBlock));
    assert_eq!(clock.elapsed(), HOUR);
    drop(far);
    assert_eq!(near.read(HOUR), Ok(Vec::new()));
}
