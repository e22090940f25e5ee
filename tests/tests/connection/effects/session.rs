//! The connection.

use jaka_tests::LONG;

use super::arm::{Arm, assert_close, turn, turned};

effects! {
    quit => the_connection_ends_and_nothing_else,
}

fn the_connection_ends_and_nothing_else(arm: &mut Arm) {
    let end = turned(arm.joints(), 30.0);
    let (mut stream, _) = arm.stream();
    arm.client.joint_move(&turn(30.0)).expect("the arm is enabled");
    arm.client.quit().expect("it answers");
    assert!(arm.client.get_version().is_err_and(|error| error.is_disconnected()));
    assert!(arm.controller.wait_for_disconnect(LONG));
    arm.wait(5);
    arm.controller.publish();
    let status = stream.next_packet().expect("the status port serves on");
    assert_eq!((status.powered_on, status.enabled), (Some(true), Some(true)));
    assert_close(status.joint_actual_position.expect("the packet has joints"), end, 1e-9);
}
