//! A panic of what a program gives to the connection: what reads a reply, or writes a request.

use std::io::Write;
use std::panic::{self, AssertUnwindSafe};
use std::sync::Arc;

use jaka_proto::Envelope;
use jaka_proto::exchange::{ReadReply, TextOnly};
use jaka_proto::wire::DecodeError;

use super::*;
use crate::StopHandle;

struct Panicking;

impl ReadReply for Panicking {
    fn read<'a>(&mut self, _text: &'a str) -> Result<Option<Envelope<'a>>, DecodeError> {
        panic!("as the test wants")
    }
}

fn send(link: &Link, name: &'static str) -> Sent<'static> {
    let write = &mut |out: &mut Writer| out.raw(&format!("{{\"cmdName\":\"{name}\"}}"));
    send_named(link, name, LONG, write).expect("it goes out")
}

fn panics<T>(act: impl FnOnce() -> T) -> bool {
    panic::catch_unwind(AssertUnwindSafe(act)).is_err()
}

/// All that are asked for are answered, each to its own.
fn assert_usable(link: &Link, server: &mut TcpStream) {
    for (name, message) in [("a", "1"), ("b", "2"), ("a", "3")] {
        let sent = send(link, name);
        server.write_all(reply(name, 0, message).as_bytes()).expect("the link reads");
        let mut text = String::new();
        link.wait(&sent, &mut text, &mut TextOnly).expect("it is answered");
        assert_eq!(text, reply(name, 0, message));
    }
    assert_eq!(link.state.lock().exchange.outstanding(), 0);
}

#[test]
fn a_panic_while_a_reply_is_read_leaves_the_connection_to_the_others() {
    let (link, mut server) = connection(Mode::Blocking);
    let sent = send(&link, "a");
    server.write_all(reply("a", 0, "").as_bytes()).expect("the link reads");
    assert!(panics(|| link.wait(&sent, &mut String::new(), &mut Panicking)));
    assert_usable(&link, &mut server);
}

#[test]
fn a_panic_over_the_reply_to_another_thread_does_not_take_it_away() {
    let (link, mut server) = connection(Mode::Blocking);
    let (first, second) = (send(&link, "a"), send(&link, "b"));
    post(&link, LONG, 1).expect("it goes out");
    server.write_all([reply("a", 0, "1"), reply("b", 0, "2")].concat().as_bytes()).expect("the link reads");
    // The first reply is the other's, and is read as this one's.
    assert!(panics(|| link.wait(&second, &mut String::new(), &mut Panicking)));
    let mut text = String::new();
    link.wait(&first, &mut text, &mut TextOnly).expect("it is answered");
    assert_eq!(text, reply("a", 0, "1"));
    link.wait(&second, &mut text, &mut TextOnly).expect("the panic was over another reply");
    server.write_all(reply("x", 0, "").as_bytes()).expect("the link reads");
    assert_eq!(link.wait_for_posted(OWNER, 0, LONG).0.accepted, 1);
    assert_usable(&link, &mut server);
}

#[test]
fn a_panic_while_a_request_is_written_sends_nothing_and_leaves_the_turn_to_the_others() {
    let (link, mut server) = connection(Mode::Blocking);
    assert!(panics(|| send_named(&link, "a", LONG, &mut |_| panic!("as the test wants"))));
    let second_panics = &mut |index: usize, out: &mut Writer| match index {
        0 => out.raw("{\"cmdName\":\"x\"}"),
        _ => panic!("as the test wants"),
    };
    let posted = Outgoing::of(&link.clock, &X, LONG).posted_for(OWNER);
    assert!(panics(|| link.transmit(&posted, OPEN, 3, second_panics)));
    let gate: Gate<'_, Error> = Some(&|| panic!("as the test wants"));
    assert!(panics(|| link.send_through(
        &Outgoing::named(&link.clock, "a", Cow::Borrowed("a"), LONG),
        gate,
        &mut |_| ()
    )));
    assert_eq!(outstanding(&link), (0, 0));
    assert_usable(&link, &mut server);
}

#[test]
fn a_stop_goes_out_after_a_panic() {
    let (link, mut server) = connection(Mode::Blocking);
    let link = Arc::new(link);
    let sent = send(&link, "a");
    server.write_all([reply("a", 0, ""), reply("stop_program", 0, "")].concat().as_bytes()).expect("the link reads");
    assert!(panics(|| link.wait(&sent, &mut String::new(), &mut Panicking)));
    // Its reply is there before it: no such request is outstanding, and it says so.
    let error = StopHandle::new(Arc::clone(&link), LONG).stop().expect_err("no such request is outstanding");
    assert!(error.is_disconnected() && !error.may_have_run(), "{error}");
    let text = link.broken().expect("it is broken").to_string();
    assert_eq!(text, "a reply to `stop_program` came, but no such request is outstanding");
}
