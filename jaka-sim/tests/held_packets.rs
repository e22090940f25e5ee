//! A link that loses packets themselves, which no fault inside the simulator can show: the systems at both ends send them again.

#![cfg(target_os = "linux")]

#[path = "common/netns.rs"]
mod netns;

use std::io::ErrorKind;
use std::time::{Duration, Instant};

use crate::common::{LIMIT, Peer, assert_accepted, json, request};
use netns::{Namespace, skipped};

/// For how long the link is down at least: longer than a packet takes to be sent again on one that is up.
const DOWN: Duration = Duration::from_millis(600);

/// True if nothing comes for so long.
fn is_quiet_for(peer: &Peer, time: Duration) -> bool {
    peer.stream.set_read_timeout(Some(time)).expect("a timeout can be set");
    let peeked = peer.stream.peek(&mut [0]).map_err(|error| error.kind());
    peer.stream.set_read_timeout(Some(LIMIT)).expect("a timeout can be set");
    matches!(peeked, Err(ErrorKind::WouldBlock | ErrorKind::TimedOut))
}

/// The packets that have come by now, and the part of one.
fn drain(peer: &mut Peer) {
    while !is_quiet_for(peer, Duration::from_millis(200)) {
        peer.receive();
    }
}

#[test]
fn what_is_sent_while_the_link_is_down_arrives_when_it_is_up() {
    let mut namespace = match Namespace::new() {
        Ok(namespace) => namespace,
        Err(reason) => return skipped("what_is_sent_while_the_link_is_down_arrives_when_it_is_up", &reason),
    };
    let [commands, status] = namespace.start(&["--fast", "--period", "200"]).expect("the program starts");
    let (mut commands, mut status) = (Peer::connect(commands), Peer::connect(status));
    assert_accepted(&commands.call("get_version"), "get_version");
    assert_eq!(json(&status.receive())["powered_on"], json("0"));

    namespace.down().expect("a link that is up can be taken down");
    let began = Instant::now();
    commands.send(request("power_on") + &request("enable_robot"));
    drain(&mut status);
    // No proxy, and no fault of the simulator: nothing acknowledges what was sent.
    assert!(is_quiet_for(&commands, DOWN) && is_quiet_for(&status, DOWN));
    namespace.up().expect("the link can be taken up");
    let was_down = began.elapsed();

    assert_accepted(&json(&commands.receive()), "power_on");
    assert_accepted(&json(&commands.receive()), "enable_robot");
    // First comes what is old: packets that were made before the requests arrived.
    assert_eq!(json(&status.receive())["powered_on"], json("0"));
    let mut old = 1;
    while json(&status.receive())["powered_on"] == json("0") {
        old += 1;
        assert!(began.elapsed() < was_down + LIMIT);
    }
    assert!(old >= 3, "{old} packets of {was_down:?}");
    assert_accepted(&commands.call("get_version"), "get_version");
}
