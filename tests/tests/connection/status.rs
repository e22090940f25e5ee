//! The status port.

use std::time::Duration;

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
fn packets_show_the_state() {
    let (controller, mut status) = quiet();
    controller.set_state(|state| {
        state.powered = true;
        state.enabled = true;
        state.joint_position = [1.5, -2.0, 3.0, 0.0, 0.0, 0.25].into();
    });
    controller.publish();
    let packet = status.next_packet().expect("a packet comes");
    assert_eq!((packet.powered_on, packet.enabled), (Some(true), Some(true)));
    assert_eq!(packet.joint_actual_position, Some([1.5, -2.0, 3.0, 0.0, 0.0, 0.25].into()));
    let length = status.packet_text().expect("it is kept").len();
    assert_eq!(packet.length, i64::try_from(length).ok());
}

jaka_sync::status_subset! {
    /// A choice of fields.
    pub struct Choice { joint_actual_position, digital_inputs, enabled }
}

#[test]
fn a_choice_of_fields_is_what_the_packet_says() {
    let (controller, mut status) = quiet();
    for n in 0..3 {
        controller.set_state(|state| {
            state.powered = true;
            state.enabled = n == 1;
            state.joint_position = [f64::from(n); 6].into();
            state.digital_inputs[0] = n == 2;
        });
        controller.publish();
        let choice: Choice = status.next_packet_as().expect("a packet comes");
        assert_eq!((choice.enabled, choice.joint_actual_position), (Some(n == 1), Some([f64::from(n); 6].into())));
        assert_eq!(choice.digital_inputs.as_ref().map(|inputs| inputs[0]), Some(n == 2));
    }
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
fn a_silent_controller_is_a_timeout_and_the_stream_goes_on() {
    let timeout = Duration::from_millis(50);
    let controller = Arm::simulated().no_packets().config(|config| config.reply_timeout(timeout)).start();
    let mut status = controller.stream();
    status.next_packet().expect("the first packet comes at once");
    let began = controller.clock().elapsed();
    let slow = status.next_packet().expect_err("no other comes");
    assert_eq!(controller.clock().elapsed().saturating_sub(began), timeout);
    assert!(slow.is_timeout());
    let expected = format!("no status packet from {} within 50ms; ", controller.status_addr());
    assert!(slow.to_string().starts_with(&expected), "{slow}");
    controller.publish();
    status.newest_packet().expect("it has come");
}

#[test]
fn packets_cut_anywhere_and_packets_in_one_piece() {
    let (controller, mut status) = quiet();
    controller.send_status(b"{\"len\": 42, \"ena");
    controller.send_status(b"bled\": true}{\"len\": 43}");
    assert_eq!(status.next_packet().expect("the pieces are put together").enabled, Some(true));
    assert_eq!(status.next_packet().expect("the second one follows").length, Some(43));
}

#[test]
fn a_field_that_does_not_fit_is_absent_and_reported() {
    let (controller, mut status) = quiet();
    controller.send_status(b"{\"len\": 42, \"enabled\": \"perhaps\"}");
    let packet = status.next_packet().expect("the packet stays");
    assert_eq!((packet.length, packet.enabled), (Some(42), None));
    let unfit: Vec<_> = status.unfit().iter().map(ToString::to_string).collect();
    assert_eq!(unfit, ["field `enabled`: expected a truth value, found `\"perhaps\"`"]);
    assert_eq!(status.packet_text(), Some("{\"len\": 42, \"enabled\": \"perhaps\"}"));
    controller.publish();
    status.next_packet().expect("the next one fits");
    assert_eq!(status.unfit(), []);
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

#[test]
fn a_closed_stream_says_so() {
    let (controller, mut status) = quiet();
    controller.disconnect();
    assert!(status.next_packet().is_err_and(|error| error.is_disconnected()));
    assert!(status.newest_packet().is_err_and(|error| error.is_disconnected()));
}
