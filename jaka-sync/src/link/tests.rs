mod panics;
mod question;
mod reset;
mod sending;

use std::borrow::Cow;
use std::net::{TcpListener, TcpStream};
use std::thread;
use std::time::Instant;

use jaka_proto::exchange::Owner;
use jaka_proto::wire::Writer;
use jaka_proto::{Effect, Role};
use socket2::SockRef;

use super::state::Mode;
use super::*;
use crate::ErrorKind;

/// Far longer than anything takes unless something is wrong.
const LONG: Duration = Duration::from_secs(60);

/// Time of a call that something else ends.
const ENDLESS: Duration = Duration::from_secs(24 * 3600);

/// A command of 4 KB, each another.
fn write(index: usize, out: &mut Writer) {
    out.raw(&format!("{{\"cmdName\":\"x\",\"index\":{index},\"pad\":\"{}\"}}", "x".repeat(4000)));
}

/// Both ends of a connection: the system buffers this much for this end to send, and little for the other to receive.
fn sockets(send_buffer: usize) -> (TcpStream, TcpStream) {
    let listener = TcpListener::bind("127.0.0.1:0").expect("loopback has free ports");
    SockRef::from(&listener).set_recv_buffer_size(4096).expect("it can be small");
    let stream = TcpStream::connect(listener.local_addr().expect("it is bound")).expect("it listens");
    SockRef::from(&stream).set_send_buffer_size(send_buffer).expect("it can be set");
    let (server, _) = listener.accept().expect("the client waits");
    server.set_read_timeout(Some(LONG)).expect("it is a time");
    (stream, server)
}

/// A connection whose system holds little, and its other end.
fn connection(mode: Mode) -> (Link, TcpStream) {
    let (stream, server) = sockets(4096);
    let link = Link::new(stream, Tap::default(), &Config::new().reply_timeout(LONG));
    Link::switch(&mut link.state.lock(), mode).expect("the socket is open");
    (link, server)
}

/// A command that the spec does not have. Every controller has set-points: none waits until one is answered.
static X: CommandInfo = {
    let mut info = CommandInfo::usual("x", "", "", Effect::Motion);
    info.role = Some(Role::SetPoint);
    info
};

/// Owner of the posted commands.
const OWNER: Owner = Owner(1);

/// Posts this many commands.
fn post(link: &Link, timeout: Duration, count: usize) -> Result<usize, Error> {
    let (mut sent, mut outstanding) = (0, 0);
    while sent < count {
        let outgoing = Outgoing::of(&link.clock, &X, timeout).posted_for(OWNER);
        let posting = link.transmit(&outgoing, OPEN, count - sent, &mut |index, out| write(sent + index, out))?;
        (sent, outstanding) = (sent + posting.sent, posting.outstanding);
    }
    Ok(outstanding)
}

/// A reply to the command.
fn reply(name: &str, code: u8, message: &str) -> String {
    format!("{{\"errorCode\":\"{code}\",\"errorMsg\":\"{message}\",\"cmdName\":\"{name}\"}}")
}

/// Waits until a condition holds that other threads or the system make true.
fn until(mut holds: impl FnMut() -> bool) {
    let since = Instant::now();
    while !holds() {
        assert!(since.elapsed() < LONG, "it has not come true within {LONG:?}");
        thread::yield_now();
    }
}

/// Numbers of outstanding requests, and of posted ones among them.
fn outstanding(link: &Link) -> (usize, usize) {
    let state = link.state.lock();
    (state.exchange.outstanding(), state.exchange.posted_outstanding(OWNER))
}

/// Sends a command.
fn send_named(
    link: &Link,
    name: &'static str,
    timeout: Duration,
    write: &mut dyn FnMut(&mut Writer),
) -> Result<Sent<'static>, Error> {
    link.send(&Outgoing::named(&link.clock, name, Cow::Borrowed(name), timeout).in_role(X.role), write)
}
