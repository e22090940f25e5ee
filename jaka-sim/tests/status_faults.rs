//! Faults of the status port: periods, and plans.

use std::time::Duration;

use crate::common::{Peer, simulated};
use jaka_sim::{Controller, FaultPlan, StatusFault};

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
fn a_plan_may_begin_with_one() {
    let plan = "status instead \"hello\"".parse::<FaultPlan>().unwrap_or_else(|error| panic!("{error}"));
    let controller = Controller::builder().faults(plan).start().expect("loopback has ports");
    assert_eq!(Peer::status(&controller).receive_bytes(10), b"hellohello");
}
