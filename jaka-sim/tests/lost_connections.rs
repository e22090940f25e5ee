//! Connections that are open and dead, and ports that another client has taken.

use std::io::{ErrorKind, Write};

use crate::common::{LIMIT, Peer, assert_accepted, fresh, request};
use jaka_sim::{Controller, Delays, Fault, Takeover};

/// A client whose connection is half open, and its controller.
fn half_open() -> (Controller, Peer) {
    let controller = fresh();
    controller.inject(Fault::HalfOpen);
    let mut peer = Peer::commands(&controller);
    peer.send(request("power_on") + &request("get_version"));
    assert!(controller.wait_for_requests(1, LIMIT));
    (controller, peer)
}

#[test]
fn a_half_open_connection_ends_with_the_controller_and_with_the_client() {
    let (controller, mut peer) = half_open();
    drop(controller);
    assert_eq!(peer.read_to_end(), b"");
    let (controller, peer) = half_open();
    drop(peer);
    assert!(controller.wait_for_disconnect(LIMIT));
}

#[test]
fn a_half_open_connection_fills_up() {
    let (controller, mut peer) = half_open();
    peer.stream.set_nonblocking(true).expect("an option can be set");
    let full = (0..1024).find_map(|_| peer.stream.write_all(&vec![b' '; 64 << 10]).err());
    assert_eq!(full.map(|error| error.kind()), Some(ErrorKind::WouldBlock));
    peer.stream.set_nonblocking(false).expect("an option can be set");
    drop(controller);
    peer.read_to_end();
}

#[test]
fn another_client_holds_the_port() {
    let controller =
        Controller::builder().delays(Delays::NONE).takeover(Takeover::Refuse).start().expect("loopback has ports");
    for _ in 0..10 {
        let mut peer = Peer::commands(&controller);
        controller.inject(Fault::Takeover);
        peer.send(request("power_on"));
        assert_eq!(peer.read_to_end(), b"");
        for _ in 0..3 {
            assert_eq!(Peer::commands(&controller).read_to_end(), b"");
        }
        controller.release();
        assert!(controller.wait_for_disconnect(LIMIT));
        let mut peer = Peer::commands(&controller);
        assert_accepted(&peer.call("get_version"), "get_version");
        controller.take_over().expect("the controller listens");
        assert_eq!(peer.read_to_end(), b"");
        assert_eq!(Peer::commands(&controller).read_to_end(), b"");
        controller.release();
        assert!(controller.wait_for_disconnect(LIMIT));
    }
}
