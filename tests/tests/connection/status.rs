//! Readers of the status port. `odd_status` has packets that do not fit, and the fault matrix each fault of them.

use jaka_sync::{Disconnect, ErrorKind, StatusStream};
use jaka_tests::Arm;

/// A controller that sends packets only when told to, except the first one.
fn quiet() -> (Arm, StatusStream) {
    let controller = Arm::simulated().without_power().no_packets().start();
    let mut status = controller.stream();
    status.next_packet().expect("the first packet comes at once");
    (controller, status)
}

#[test]
fn the_newest_packet_is_the_newest() {
    let (controller, mut status) = quiet();
    for n in 0..20 {
        controller.set_state(|state| state.joint_position = [f64::from(n); 6].into());
        controller.publish();
    }
    let mut last = status.newest_packet().expect("packets wait").joint_actual_position;
    // All packets are sent, but the last ones may still be on their way through loopback.
    while last != Some([19.0; 6].into()) {
        last = status.newest_packet().expect("the others follow").joint_actual_position;
    }
}

#[test]
fn the_next_packet_is_each_in_turn() {
    let (controller, mut status) = quiet();
    for n in 0..20 {
        controller.set_state(|state| state.joint_position = [f64::from(n); 6].into());
        controller.publish();
    }
    for n in 0..20 {
        let packet = status.next_packet().expect("a packet comes");
        assert_eq!(packet.joint_actual_position, Some([f64::from(n); 6].into()));
    }
}

#[test]
fn text_lines_of_very_old_firmware_are_reported_clearly() {
    let (controller, mut status) = quiet();
    controller.send_status(b"joint_actual_position:(0,0,0,0,0,0)\n");
    for _ in 0..2 {
        let error = status.next_packet().expect_err("that is not a packet");
        let ErrorKind::Disconnected { command: None, cause, .. } = error.kind() else {
            panic!("it is told apart: {error:?}")
        };
        assert!(matches!(**cause, Disconnect::Frame(_)));
        assert!(cause.to_string().contains("a form of very old versions"), "{cause}");
    }
}
