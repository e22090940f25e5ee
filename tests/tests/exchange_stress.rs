//! A client and many stop handles at once, with a server that answers when it likes: every call ends, and no query gets the
//! reply to another.

use std::io::{self, Read, Write};
use std::net::{Shutdown, TcpListener, TcpStream};
use std::sync::mpsc;
use std::thread;
use std::time::Duration;

use jaka_proto::framing::Framer;
use jaka_sync::{Client, Config, Error, ErrorKind, StopHandle};
use proptest::prelude::RngCore;
use proptest::test_runner::{RngAlgorithm, TestRng};
use serde_json::{Value, json};

/// How many connections, times `JAKA_RELIABILITY`.
const CONNECTIONS: u32 = 8;

/// How many threads have a stop handle.
const HANDLES: usize = 6;

/// How many replies a connection has before the server ends it.
const REPLIES: u32 = 1000;

/// How long a call waits. Few do: one whose reply is lost ends when a later one is answered.
const TIMEOUT: Duration = Duration::from_millis(50);

/// How long all calls of a connection may take.
const LIMIT: Duration = Duration::from_secs(120);

/// What calls on a connection ended with.
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

/// Answers in order: some replies at once, some late, several in one write or one in several, and some never. Gives back how
/// many it has answered.
fn serve(mut stream: &TcpStream, random: &mut TestRng) -> u32 {
    let (mut framer, mut out, mut answered) = (Framer::default(), Vec::new(), 0);
    // Where all wait, they are answered.
    stream.set_read_timeout(Some(TIMEOUT / 50)).expect("the time is not zero");
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
        let listener = TcpListener::bind("127.0.0.1:0").expect("loopback has free ports");
        let address = listener.local_addr().expect("it is bound");
        let client = Config::new().reply_timeout(TIMEOUT).connect_client(address).expect("it listens");
        let (stream, _) = listener.accept().expect("the client has connected");
        let (ended, ends) = mpsc::channel();
        for _ in 0..HANDLES {
            let (stop, ended) = (client.stop_handle(), ended.clone());
            thread::spawn(move || ended.send(stop_on(&stop)));
        }
        thread::spawn(move || ended.send(query_on(client)));
        let answered = serve(&stream, &mut random);
        // It may have been closed by the client.
        stream.shutdown(Shutdown::Both).ok();
        let tallies: Vec<Tally> =
            (0..=HANDLES).map(|_| ends.recv_timeout(LIMIT).expect("every thread ends, and none panics")).collect();
        let sum = tallies.iter().map(|tally| tally.answered).sum::<u32>();
        assert!(sum <= answered, "connection {connection}: {answered} replies were given to {sum} calls: {tallies:?}");
        println!("connection {connection}: {answered} replies, {tallies:?}");
    }
}
