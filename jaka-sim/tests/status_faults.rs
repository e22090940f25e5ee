//! Faults of the status port that a monitor must survive.

use std::time::Duration;

use crate::common::{Peer, fresh, json, simulated};
use jaka_sim::{Controller, FaultPlan, StatusFault};

/// A reader with its first packet, and a controller that sends further packets only on request.
fn reader() -> (Controller, Peer, String) {
    let controller = fresh();
    let mut peer = Peer::status(&controller);
    let packet = peer.receive();
    (controller, peer, packet)
}

#[test]
fn no_packet_comes() {
    let (controller, mut peer, packet) = reader();
    controller.status_fault(StatusFault::Silent);
    controller.publish();
    let mut late = Peer::status(&controller);
    controller.publish();
    // Only what the owner sends comes, and no packet was received before.
    controller.send_status(b"{}");
    assert_eq!([peer.receive(), late.receive()], ["{}", "{}"]);
    controller.status_fault(StatusFault::None);
    controller.publish();
    assert_eq!([peer.receive(), late.receive()], [packet.clone(), packet]);
}

#[test]
fn packets_come_with_another_period() {
    let period = Duration::from_millis(150);
    let (clock, controller) = simulated();
    let mut peer = Peer::simulated_status(&controller);
    peer.receive();
    controller.status_fault(StatusFault::Slow(period));
    for count in 1..=4 {
        peer.receive();
        assert_eq!(clock.elapsed(), period * count);
    }
    controller.status_fault(StatusFault::Slow(Duration::MAX));
    controller.status_fault(StatusFault::Slow(Duration::ZERO));
    for _ in 0..50 {
        peer.receive();
    }
    // One each millisecond is the most.
    assert_eq!(clock.elapsed(), period * 4 + Duration::from_millis(50));
}

#[test]
fn a_stepped_clock_is_slow_too() {
    let builder = Controller::builder().stepped_clock().status_period(Duration::from_millis(80));
    let controller = builder.faults(FaultPlan::new().status(StatusFault::Slow(Duration::from_secs(2))));
    let controller = controller.start().expect("loopback has ports");
    let mut peer = Peer::status(&controller);
    peer.receive();
    controller.advance(Duration::from_secs(7));
    controller.send_status(b"{}");
    let count = std::iter::from_fn(|| Some(peer.receive())).take_while(|message| message != "{}").count();
    assert_eq!(count, 3);
}

#[test]
fn packets_come_in_pieces() {
    let (controller, mut peer, packet) = reader();
    for size in [0, 1, 7, 100_000] {
        controller.status_fault(StatusFault::Pieces(size));
        controller.publish();
        assert_eq!(peer.receive(), packet);
    }
}

#[test]
fn garbage_comes_before_packets() {
    let (controller, mut peer, packet) = reader();
    let mut noise = || {
        controller.status_fault(StatusFault::Garbage { bytes: 40, seed: 7 });
        [(); 2].map(|()| {
            controller.publish();
            let noise = peer.receive_bytes(40);
            assert_eq!(peer.receive_bytes(packet.len()), packet.as_bytes());
            noise
        })
    };
    let first = noise();
    assert_ne!(first[0], first[1]);
    assert_eq!(noise(), first);
}

#[test]
fn packets_are_cut() {
    let (controller, mut peer, packet) = reader();
    controller.status_fault(StatusFault::Cut(9));
    controller.publish();
    controller.status_fault(StatusFault::Cut(100_000));
    controller.publish();
    assert_eq!(peer.receive_bytes(9 + packet.len()), [&packet[..9], &packet].concat().into_bytes());
}

#[test]
fn other_bytes_come_for_packets() {
    let (controller, mut peer, packet) = reader();
    let text = b"joint_actual_position:(0.0, 0.0)\n";
    controller.status_fault(StatusFault::Instead(text.to_vec()));
    controller.publish();
    controller.status_fault(StatusFault::None);
    controller.publish();
    assert_eq!(peer.receive_bytes(text.len()), text);
    assert_eq!(peer.receive(), packet);
}

#[test]
fn connections_end_within_a_packet() {
    let (controller, mut peer, packet) = reader();
    let count = packet.len() + 17;
    controller.status_fault(StatusFault::CloseAfter(count));
    for _ in 0..3 {
        controller.publish();
    }
    assert_eq!(peer.read_to_end(), [&packet, &packet[..17]].concat().into_bytes());
    // The next connection ends as well, until the fault does.
    let mut peer = Peer::status(&controller);
    controller.publish();
    assert_eq!(peer.read_to_end().len(), count);
    controller.status_fault(StatusFault::None);
    assert_eq!(json(&Peer::status(&controller).receive())["len"], packet.len());
    controller.status_fault(StatusFault::CloseAfter(0));
    assert_eq!(Peer::status(&controller).read_to_end(), b"");
}

#[test]
fn a_plan_may_begin_with_one() {
    let plan = "status instead \"hello\"".parse::<FaultPlan>().unwrap_or_else(|error| panic!("{error}"));
    let controller = Controller::builder().faults(plan).start().expect("loopback has ports");
    assert_eq!(Peer::status(&controller).receive_bytes(10), b"hellohello");
}
