//! Every fault, as a client meets it.

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
fn each_reply_takes_one_fault() {
    let (_controller, mut peer) = with([Fault::None, Fault::Nameless, Fault::None]);
    assert_accepted(&peer.call(PAYLOAD), PAYLOAD);
    let nameless = peer.call(PAYLOAD);
    assert_eq!((&nameless["cmdName"], &nameless["errorCode"]), (&json("null"), &"0".into()));
    assert_accepted(&peer.call(PAYLOAD), PAYLOAD);
    assert_accepted(&peer.call(PAYLOAD), PAYLOAD);
}

#[test]
fn a_dropped_reply_never_comes() {
    let (controller, mut peer) = with([Fault::Drop]);
    peer.send(request("power_on"));
    assert!(controller.wait_for_requests(1, LIMIT));
    assert!(controller.state().powered);
    peer.assert_quiet();
}

#[test]
fn a_held_reply_comes_when_it_is_released() {
    let (controller, mut peer) = with([Fault::Hold]);
    peer.send(request("power_on"));
    assert!(controller.wait_for_requests(1, LIMIT));
    controller.release();
    assert_accepted(&json(&peer.receive()), "power_on");
    controller.release();
    peer.assert_quiet();
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
fn pieces_make_up_the_reply() {
    let reply = payload();
    for sizes in [vec![1; 40], vec![10, 0, 20], vec![], vec![100_000], vec![reply.len(), 1]] {
        let (_controller, mut peer) = with([Fault::Pieces(sizes)]);
        peer.send(request(PAYLOAD));
        assert_eq!(peer.receive(), reply);
        peer.assert_quiet();
    }
}

#[test]
fn a_reply_waits_for_the_next_one() {
    let (controller, mut peer) = with([Fault::WithNext, Fault::WithNext]);
    for (count, command) in (1..).zip(["power_on", "enable_robot"]) {
        peer.send(request(command));
        assert!(controller.wait_for_requests(count, LIMIT));
        controller.release();
    }
    assert!(!peer.has_something());
    peer.send(request(PAYLOAD));
    for command in ["power_on", "enable_robot", PAYLOAD] {
        assert_accepted(&json(&peer.receive()), command);
    }
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
fn a_reply_may_come_twice() {
    let (_controller, mut peer) = with([Fault::Twice]);
    peer.send(request(PAYLOAD));
    assert_eq!([peer.receive(), peer.receive()], [payload(), payload()]);
    peer.assert_quiet();
}

#[test]
fn a_reply_may_have_another_name() {
    let (_controller, mut peer) = with([Fault::Renamed("fly \"away\"".to_owned())]);
    let reply = peer.call(PAYLOAD);
    assert_eq!((&reply["cmdName"], &reply["mass"]), (&"fly \"away\"".into(), &json("1")));
}

#[test]
fn other_bytes_may_come_with_a_reply_or_for_it() {
    let reply = payload();
    let cases = [
        (Fault::Before(b"\0\xff".to_vec()), [b"\0\xff", reply.as_bytes()].concat()),
        (Fault::After(b"{}".to_vec()), [reply.as_bytes(), b"{}"].concat()),
        (Fault::Instead(b"(0, [])".to_vec()), b"(0, [])".to_vec()),
    ];
    for (fault, bytes) in cases {
        let (_controller, mut peer) = with([fault]);
        peer.send(request(PAYLOAD));
        assert_eq!(peer.receive_bytes(bytes.len()), bytes);
        peer.assert_quiet();
    }
}

#[test]
fn a_connection_may_end_in_place_of_a_reply_or_in_it() {
    let reply = payload();
    for (fault, count) in [(Fault::Close, 0), (Fault::CloseAfter(0), 0), (Fault::CloseAfter(17), 17)] {
        let (controller, mut peer) = with([Fault::None, fault]);
        assert_accepted(&peer.call("power_on"), "power_on");
        peer.send(request(PAYLOAD));
        let mut rest = Vec::new();
        peer.stream.read_to_end(&mut rest).expect("the end is not an error");
        assert_eq!(rest, &reply.as_bytes()[..count]);
        assert_eq!(controller.requests().len(), 2);
        assert_accepted(&Peer::commands(&controller).call(PAYLOAD), PAYLOAD);
    }
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

#[test]
fn an_oversized_reply_is_the_same_json() {
    let reply = payload();
    for size in [0, reply.len(), reply.len() + 1, 300_000] {
        let (_controller, mut peer) = with([Fault::Oversized(size)]);
        peer.send(request(PAYLOAD));
        let oversized = peer.receive();
        assert_eq!((oversized.len(), json(&oversized)), (size.max(reply.len()), json(&reply)));
    }
}
