//! Collision detection and protective stop.

use super::arm::{Arm, refused, turn};

effects! {
    protective_stop_status => a_collision_is_told,
    set_clsn_sensitivity => the_collision_level_is_given_back,
    get_clsn_sensitivity => the_collision_level_is_read,
    clear_error => the_arm_leaves_a_protective_stop,
}

fn a_collision_is_told(arm: &mut Arm) {
    assert!(!arm.client.protective_stop_status().expect("it answers").protective_stop);
    arm.controller.collide();
    assert!(arm.client.protective_stop_status().expect("it answers").protective_stop);
}

fn the_collision_level_is_given_back(arm: &mut Arm) {
    for level in [5, 0, 2] {
        arm.client.set_clsn_sensitivity(level).expect("it answers");
        assert_eq!(arm.client.get_clsn_sensitivity().expect("it answers").level, level);
    }
    let beyond = arm.client.set_clsn_sensitivity(6);
    assert!(beyond.is_err_and(|error| error.is_invalid_argument()));
    assert_eq!(arm.controller.state().collision_level, 2);
}

fn the_collision_level_is_read(arm: &mut Arm) {
    arm.controller.set_state(|state| state.collision_level = 4);
    assert_eq!(arm.client.get_clsn_sensitivity().expect("it answers").level, 4);
}

fn the_arm_leaves_a_protective_stop(arm: &mut Arm) {
    arm.controller.collide();
    refused(arm.client.joint_move(&turn(1.0)));
    let status = arm.status();
    assert_eq!(
        (status.protective_stop, status.error_message.as_deref()),
        (Some(true), Some("a collision was detected"))
    );
    arm.client.clear_error().expect("it answers");
    let status = arm.status();
    assert_eq!((status.protective_stop, status.error_code.as_deref()), (Some(false), Some("0x0")));
    arm.client.joint_move(&turn(1.0)).expect("the protective stop is left");
}
