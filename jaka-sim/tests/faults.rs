//! Faults of replies that concern several replies or connections. The fault matrix of the whole project has each alone.

use std::io::{ErrorKind, Read};

use crate::common::{LIMIT, Peer, assert_accepted, fresh, json, request};
use jaka_sim::{Controller, Fault};

const PAYLOAD: &str = "get_payload";

/// The reply to [`PAYLOAD`].
fn payload() -> String {
    let controller = fresh();
    let mut peer = Peer::commands(&controller);
    peer.send(request(PAYLOAD));
    peer.receive()
}

/// A client, and a controller with these faults.
fn with(faults: impl IntoIterator<Item = Fault>) -> (Controller, Peer) {
    let controller = fresh();
    for fault in faults {
        controller.inject(fault);
    }
    let peer = Peer::commands(&controller);
    (controller, peer)
}

#[test]
fn held_replies_come_before_the_next_one() {
    let (_controller, mut peer) = with([Fault::Hold, Fault::Drop, Fault::Hold]);
    let commands = ["power_on", "enable_robot", "get_robot_state", "get_version"];
    for command in commands {
        peer.send(request(command));
    }
    for command in ["power_on", "get_robot_state", "get_version"] {
        assert_accepted(&json(&peer.receive()), command);
    }
    peer.assert_quiet();
}

#[test]
fn replies_that_wait_go_with_whatever_is_next() {
    let (controller, mut peer) = with([Fault::WithNext, Fault::Hold, Fault::WithNext, Fault::Pieces(vec![1, 2])]);
    let commands = ["power_on", "enable_robot", "get_robot_state", "get_version"];
    peer.send(commands.map(request).concat());
    for command in commands {
        assert_accepted(&json(&peer.receive()), command);
    }
    assert!(controller.wait_for_requests(4, LIMIT));
}

#[test]
fn a_reset_is_a_reset() {
    for pieces in [1, 2, 19] {
        let (controller, mut peer) = with([Fault::None, Fault::None, Fault::Reset]);
        // The request that is reset comes with those before it, or in pieces.
        let text = request("power_on").repeat(3);
        let (head, tail) = text.split_at(text.len() / pieces);
        peer.send(head);
        peer.send(tail);
        let mut rest = Vec::new();
        let error = peer.stream.read_to_end(&mut rest).expect_err("the reset is an error");
        assert_eq!(error.kind(), ErrorKind::ConnectionReset);
        assert!(controller.wait_for_requests(3, LIMIT));
        assert_accepted(&Peer::commands(&controller).call("get_version"), "get_version");
    }
}

#[test]
fn a_refusal_takes_a_fault_too() {
    let (_controller, mut peer) = with([Fault::Twice, Fault::Renamed("jog".to_owned()), Fault::Drop]);
    peer.send(request("enable_robot") + &request("fly") + "x");
    assert_eq!(json(&peer.receive())["cmdName"], "enable_robot");
    assert_eq!(json(&peer.receive())["errorCode"], "2");
    let renamed = json(&peer.receive());
    assert_eq!((&renamed["cmdName"], &renamed["errorCode"]), (&"jog".into(), &"1".into()));
    peer.assert_quiet();
}

#[test]
fn faults_outlive_a_connection_and_held_replies_do_not() {
    let (controller, mut peer) = with([Fault::Hold, Fault::Twice]);
    peer.send(request("power_on"));
    assert!(controller.wait_for_requests(1, LIMIT));
    drop(peer);
    let mut peer = Peer::commands(&controller);
    peer.send(request(PAYLOAD));
    assert_eq!([peer.receive(), peer.receive()], [payload(), payload()]);
    peer.assert_quiet();
}

#[test]
fn garbage_is_random_and_the_same_each_time() {
    let garbage = |seed| {
        let (_controller, mut peer) = with([Fault::Garbage { bytes: 300, seed }]);
        peer.send(request(PAYLOAD));
        let bytes = peer.receive_bytes(300);
        peer.assert_quiet();
        bytes
    };
    assert_eq!(garbage(7), garbage(7));
    assert_ne!(garbage(7), garbage(8));
}
