//! Replies that come later, at their exact times.

use std::io::{ErrorKind, Read};
use std::time::Duration;

use crate::common::{LIMIT, Peer, assert_accepted, json, request, simulated};
use jaka_sim::jaka_clock::Stream;
use jaka_sim::{Controller, Fault, SimulatedClock};

const DELAY: Duration = Duration::from_millis(200);
const AGES: Duration = Duration::from_secs(3600);

/// A client that has sent this request and been carried out, and a controller with these faults.
fn asked(faults: impl IntoIterator<Item = Fault>, request: &str) -> (SimulatedClock, Controller, Peer<Stream>) {
    let (clock, controller) = simulated();
    faults.into_iter().for_each(|fault| controller.inject(fault));
    let mut peer = Peer::simulated_commands(&controller);
    peer.send(request);
    assert!(controller.wait_for_requests(1, LIMIT));
    assert_eq!(clock.elapsed(), Duration::ZERO);
    (clock, controller, peer)
}

#[test]
fn later_replies_wait_and_keep_their_faults() {
    let faults = [Fault::Delay(DELAY), Fault::Twice, Fault::Delay(Duration::ZERO), Fault::Drop];
    let (clock, controller, mut peer) = asked(faults, &request("power_on"));
    let commands = ["enable_robot", "get_version", "get_payload", "get_joint_pos"];
    peer.send(commands.map(request).concat());
    // They are carried out at once.
    assert!(controller.wait_for_requests(5, LIMIT));
    assert!(controller.state().enabled);
    assert_eq!(clock.elapsed(), Duration::ZERO);
    for command in ["power_on", "enable_robot", "enable_robot", "get_version", "get_joint_pos"] {
        assert_accepted(&json(&peer.receive()), command);
        assert_eq!(clock.elapsed(), DELAY);
    }
}

#[test]
fn replies_are_sent_while_requests_come() {
    let (clock, _controller, mut peer) = asked([Fault::Delay(DELAY)], &request("get_version"));
    // The late reply comes although the controller is never idle.
    while peer.is_quiet_for(Duration::from_millis(1)) {
        peer.send(request("get_version"));
    }
    assert_eq!(clock.elapsed(), DELAY);
}

#[test]
fn a_connection_may_end_late() {
    let (clock, _controller, mut peer) = asked([Fault::Delay(DELAY), Fault::CloseAfter(5)], &request("power_on"));
    peer.send(request("get_version"));
    assert_accepted(&json(&peer.receive()), "power_on");
    assert_eq!(peer.read_to_end().len(), 5);
    assert_eq!(clock.elapsed(), DELAY);

    let (clock, controller, mut peer) = asked([Fault::Delay(DELAY), Fault::Reset], &request("power_on"));
    peer.send(request("get_version"));
    assert!(controller.wait_for_requests(2, LIMIT));
    let mut rest = Vec::new();
    let error = peer.stream.read_to_end(&mut rest).expect_err("the reset is an error");
    assert_eq!((error.kind(), clock.elapsed()), (ErrorKind::ConnectionReset, DELAY));
}

#[test]
fn no_thread_waits_for_a_late_reply() {
    let ends: [fn(Controller, Peer<Stream>); 4] = [
        |controller, mut peer| {
            drop(controller);
            assert_eq!(peer.read_to_end(), b"");
        },
        |controller, peer| {
            drop(peer);
            assert!(controller.wait_for_disconnect(LIMIT));
        },
        |controller, mut peer| {
            assert_accepted(&Peer::simulated_commands(&controller).call("get_version"), "get_version");
            assert_eq!(peer.read_to_end(), b"");
        },
        |controller, mut peer| {
            controller.disconnect();
            assert_eq!(peer.read_to_end(), b"");
        },
    ];
    for end in ends {
        for delay in [AGES, Duration::MAX] {
            let (clock, controller, peer) = asked([Fault::Delay(delay)], &request("power_on"));
            end(controller, peer);
            assert_eq!(clock.elapsed(), Duration::ZERO);
        }
    }
}
