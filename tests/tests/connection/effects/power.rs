//! Power, enabling and the controller's state.

use jaka_sync::Client;
use jaka_sync::status::TaskState;
use jaka_tests::LONG;

use super::arm::{Arm, disabled, refused, turn};

effects! {
    power_on => power_lets_the_arm_be_enabled,
    power_off => power_off_ends_all,
    enable_robot => an_enabled_arm_moves,
    disable_robot => a_disabled_arm_stands_still,
    shutdown => shutdown_ends_both_connections,
    get_robot_state => the_state_is_that_of_the_arm,
    get_version => the_version_is_the_controllers,
}

fn power_lets_the_arm_be_enabled(arm: &mut Arm) {
    arm.refuses(|state| state.powered = false, Client::enable_robot);
    assert_eq!(arm.status().task_state, Some(TaskState::PoweredOff));
    assert_eq!(arm.client.power_on().expect("it answers").powered_on, Some(true));
    let status = arm.status();
    assert_eq!((status.powered_on, status.task_state), (Some(true), Some(TaskState::Disabled)));
    arm.client.enable_robot().expect("the arm has power");
}

fn power_off_ends_all(arm: &mut Arm) {
    arm.client.power_off().expect("it answers");
    let status = arm.status();
    assert_eq!((status.powered_on, status.enabled), (Some(false), Some(false)));
    refused(arm.client.enable_robot());
}

fn an_enabled_arm_moves(arm: &mut Arm) {
    arm.refuses(disabled, |client| client.joint_move(&turn(1.0)));
    assert_eq!(arm.client.enable_robot().expect("the arm has power").enabled, Some(true));
    let status = arm.status();
    assert_eq!((status.enabled, status.task_state), (Some(true), Some(TaskState::Enabled)));
    arm.client.joint_move(&turn(1.0)).expect("the arm is enabled");
}

fn a_disabled_arm_stands_still(arm: &mut Arm) {
    arm.client.joint_move(&turn(40.0)).expect("the arm is enabled");
    arm.wait(1);
    // Firmware 1.5.14 acknowledges it while the arm moves.
    arm.client.disable_robot().expect("it answers");
    arm.wait(1);
    let status = arm.status();
    assert_eq!((status.powered_on, status.enabled, status.in_position), (Some(true), Some(false), Some(true)));
    arm.wait(1);
    assert_eq!(arm.status().joint_actual_position, status.joint_actual_position);
    refused(arm.client.joint_move(&turn(1.0)));
}

fn shutdown_ends_both_connections(arm: &mut Arm) {
    let (mut stream, _) = arm.stream();
    arm.client.shutdown().expect("it answers");
    assert!(stream.next_packet().is_err_and(|error| error.is_disconnected()));
    assert!(arm.client.get_version().is_err_and(|error| error.is_disconnected()));
    assert!(arm.controller.wait_for_disconnect(LONG));
    assert!(!arm.controller.state().powered);
}

fn the_state_is_that_of_the_arm(arm: &mut Arm) {
    for (powered_on, enabled) in [(true, true), (true, false), (false, false)] {
        arm.controller.set_state(|state| (state.powered, state.enabled) = (powered_on, enabled));
        let state = arm.client.get_robot_state().expect("it answers");
        assert_eq!((state.powered_on, state.enabled), (powered_on, enabled));
    }
}

fn the_version_is_the_controllers(arm: &mut Arm) {
    arm.controller.set_state(|state| "1.7.1_33".clone_into(&mut state.version));
    assert_eq!(arm.client.get_version().expect("it answers").version, "1.7.1_33");
}
