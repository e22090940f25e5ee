//! A client and many stop handles at once, with a server that answers when it likes: every call ends, and no query gets
//! the reply to another.
//!
//! All share a simulated clock, so that a timeout passes only where no thread has anything to do. The order in which
//! the threads act is left to chance.

use std::io::{self, Read, Write};
use std::net::Shutdown;
use std::sync::mpsc;
use std::thread;
use std::time::Duration;

use jaka_proto::framing::Framer;
use jaka_sim::SimulatedClock;
use jaka_sim::jaka_clock::Stream;
use jaka_sync::{Client, Config, Error, ErrorKind, StopHandle};
use proptest::prelude::RngCore;
use proptest::test_runner::{RngAlgorithm, TestRng};
use serde_json::{Value, json};

/// Number of connections, times `JAKA_RELIABILITY`.
const CONNECTIONS: u32 = 8;

/// Number of threads with a stop handle.
const HANDLES: usize = 6;

/// Number of replies after which the server ends a connection.
const REPLIES: u32 = 1000;

/// Timeout of calls. Few wait so long: one whose reply is lost ends when a later one is answered.
const TIMEOUT: Duration = Duration::from_millis(50);

/// Real time in which all calls of a connection must end.
const LIMIT: Duration = Duration::from_secs(120);

/// Ends of calls on a connection.
#[derive(Debug, Default)]
struct Tally {
    answered: u32,
    timeouts: u32,
    lost: u32,
}

/// Calls until the connection is broken, and then once more: nothing is sent any more.
fn call_on(mut call: impl FnMut(u32) -> Result<(), Error>) -> Tally {
    let mut tally = Tally::default();
    for number in 0.. {
        match call(number).as_ref().map_err(Error::kind) {
            Ok(()) => tally.answered += 1,
            Err(ErrorKind::Timeout { .. } | ErrorKind::NotSentInTime { .. }) => tally.timeouts += 1,
            Err(ErrorKind::ReplyLost { .. }) => tally.lost += 1,
            Err(ErrorKind::Disconnected { .. }) => break,
            Err(other) => panic!("no call may end with {other:?}"),
        }
    }
    let error = call(0).expect_err("the connection is broken");
    assert!(error.is_disconnected() && !error.may_have_run(), "{error:?}");
    tally
}

/// Queries of two names, each with a number that its reply must have.
fn query_on(mut client: Client) -> Tally {
    call_on(|number| {
        let name = ["query_a", "query_b"][number as usize % 2];
        let reply = client.call_raw(name, &json!({"number": number}))?;
        assert_eq!((reply["cmdName"].as_str(), &reply["number"]), (Some(name), &json!(number)), "it is another's");
        Ok(())
    })
}

fn stop_on(stop: &StopHandle) -> Tally {
    call_on(|_| stop.stop())
}

/// Answers in order: some replies at once, some late, several in one write or one in several, and some never. Gives
/// back how many it has answered.
fn serve(stream: &mut Stream, random: &mut TestRng) -> u32 {
    let (mut framer, mut out, mut answered) = (Framer::default(), Vec::new(), 0);
    // Where all wait, they are answered.
    stream.set_timeout(Some(TIMEOUT / 50));
    while answered < REPLIES {
        while let Some(request) = framer.next_frame().expect("clients send requests") {
            if !random.next_u32().is_multiple_of(200) {
                out.extend(reply_to(request));
                answered += 1;
            }
        }
        if random.next_u32().is_multiple_of(3) {
            let cut = random.next_u32() as usize % (out.len() + 1);
            let sent: Vec<u8> = out.drain(..cut).collect();
            // The client may have broken the connection.
            if stream.write_all(&sent).is_err() {
                return answered;
            }
        }
        match stream.read(framer.spare()) {
            Ok(0) => return answered,
            Ok(count) => framer.filled(count),
            Err(error) if matches!(error.kind(), io::ErrorKind::WouldBlock | io::ErrorKind::TimedOut) => {
                if stream.write_all(&std::mem::take(&mut out)).is_err() {
                    return answered;
                }
            }
            Err(_) => return answered,
        }
    }
    answered
}

/// The request's own name and number, if it has one.
fn reply_to(request: &[u8]) -> Vec<u8> {
    let mut reply: Value = serde_json::from_slice(request).expect("clients send JSON");
    reply["errorCode"] = "0".into();
    reply.to_string().into_bytes()
}

#[test]
fn every_call_ends_and_no_query_gets_the_reply_to_another() {
    let mut random = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    for connection in 0..CONNECTIONS * jaka_tests::reliability_times() {
        let clock = SimulatedClock::new();
        let listener = clock.bind("127.0.0.1:0".parse().expect("an address")).expect("loopback has free ports");
        let client = Client::connect_with(&Config::new().clock(&clock).reply_timeout(TIMEOUT), listener.local_addr());
        let client = client.expect("it listens");
        let mut stream = listener.accept().expect("the client has connected");
        let (ended, ends) = mpsc::channel();
        for _ in 0..HANDLES {
            let (stop, ended, place) = (client.stop_handle(), ended.clone(), clock.participant());
            thread::spawn(move || place.run(|| ended.send(stop_on(&stop))));
        }
        let place = clock.participant();
        thread::spawn(move || place.run(|| ended.send(query_on(client))));
        let answered = serve(&mut stream, &mut random);
        // It may have been closed by the client.
        stream.shutdown(Shutdown::Both).ok();
        let end = || clock.outside(|| ends.recv_timeout(LIMIT)).expect("every thread ends, and none panics");
        let tallies: Vec<Tally> = (0..=HANDLES).map(|_| end()).collect();
        let sum = tallies.iter().map(|tally| tally.answered).sum::<u32>();
        assert!(sum <= answered, "connection {connection}: {answered} replies were given to {sum} calls: {tallies:?}");
        println!("connection {connection}: {answered} replies, {tallies:?}");
    }
}
