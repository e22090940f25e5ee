//! Sequels of a reply: the end of a connection; and the reply that follows the end of a motion.

use std::time::Duration;

use crate::common::{LIMIT, Peer, assert_accepted, fresh, json, request, stepped};
use jaka_sim::{Controller, Fault};

/// The name in the reply to `wait_complete`, as the document prints it.
const WAITED: &str = " wait_complete";

/// A client whose arm is about to turn joint 1 by 30 degrees, for 1.75 s, and its controller.
fn moving() -> (Controller, Peer) {
    let controller = stepped();
    let mut peer = Peer::commands(&controller);
    let turn = r#"{"cmdName":"joint_move","relFlag":1,"jointPosition":[30,0,0,0,0,0],"speed":20,"accel":80}"#;
    assert_accepted(&peer.ask(turn), "joint_move");
    (controller, peer)
}

#[test]
fn the_connection_ends_after_a_late_reply_and_without_a_lost_one() {
    let controller = fresh();
    controller.inject(Fault::Delay(Duration::from_millis(20)));
    let mut peer = Peer::commands(&controller);
    assert_accepted(&peer.call("quit"), "quit");
    assert_eq!(peer.read_to_end(), b"");
    controller.inject(Fault::Drop);
    let mut peer = Peer::commands(&controller);
    peer.send(request("shutdown"));
    assert_eq!(peer.read_to_end(), b"");
}

#[test]
fn a_reply_that_is_held_back_keeps_the_connection() {
    let controller = fresh();
    controller.inject(Fault::Hold);
    let mut peer = Peer::commands(&controller);
    peer.send(request("quit"));
    assert!(controller.wait_for_requests(1, LIMIT));
    controller.release();
    assert_accepted(&json(&peer.receive()), "quit");
}

#[test]
fn a_stop_ends_the_wait_and_is_answered_after_it() {
    let (controller, mut peer) = moving();
    peer.send(request("wait_complete") + &request("stop_program"));
    assert!(controller.wait_for_requests(3, LIMIT));
    controller.advance(Duration::from_secs(1));
    assert!(controller.state().in_position);
    assert_accepted(&json(&peer.receive()), WAITED);
    assert_accepted(&json(&peer.receive()), "stop_program");
}
