//! Servo mode.

use jaka_sync::ErrorCode;
use jaka_sync::servo::{ServoJ, ServoP, SetServoMoveFilter};
use jaka_sync::types::Switch;
use jaka_tests::CYCLE;

use super::arm::{Arm, assert_close, disabled, raised, refused, servo_mode, turn, turned};

effects! {
    is_in_servomove => servo_mode_is_told,
    servo_move => servo_mode_decides_what_moves,
    servo_j => joints_follow_set_points,
    servo_p => the_tool_follows_set_points,
    set_servo_move_filter => the_filter_is_set_outside_servo_mode,
}

fn a_turn() -> ServoJ {
    ServoJ::relative(turned([0.0; 6], 0.5)).step_count(2)
}

fn servo_mode_is_told(arm: &mut Arm) {
    assert!(!arm.client.is_in_servomove().expect("it answers").in_servo_mode);
    arm.controller.set_state(servo_mode);
    assert!(arm.client.is_in_servomove().expect("it answers").in_servo_mode);
    // Servo mode ends with a collision.
    arm.controller.collide();
    assert!(!arm.client.is_in_servomove().expect("it answers").in_servo_mode);
}

fn servo_mode_decides_what_moves(arm: &mut Arm) {
    arm.client.set_servo_mode(Switch::On).expect("the arm is enabled");
    refused(arm.client.joint_move(&turn(1.0)));
    arm.client.servo_j(&a_turn()).expect("servo mode is on");
    arm.client.set_servo_mode(Switch::Off).expect("it answers");
    refused(arm.client.servo_j(&a_turn()));
    arm.client.joint_move(&turn(1.0)).expect("servo mode is off");
    arm.refuses(disabled, |client| client.set_servo_mode(Switch::On));
}

fn joints_follow_set_points(arm: &mut Arm) {
    let start = arm.joints();
    let error = arm.client.servo_j(&a_turn()).expect_err("servo mode is off");
    assert_eq!(error.refusal().map(|refusal| refusal.code), Some(ErrorCode(-1)));
    arm.controller.set_state(servo_mode);
    arm.client.servo_j(&a_turn()).expect("servo mode is on");
    arm.controller.advance(CYCLE);
    assert_close(arm.joints(), turned(start, 0.25), 1e-9);
    arm.controller.advance(CYCLE);
    assert_close(arm.joints(), turned(start, 0.5), 1e-9);
}

fn the_tool_follows_set_points(arm: &mut Arm) {
    let pose = raised(arm.pose(), 0.5);
    let request = ServoP::absolute(pose);
    refused(arm.client.servo_p(&request));
    arm.controller.set_state(servo_mode);
    arm.client.servo_p(&request).expect("servo mode is on");
    arm.controller.advance(CYCLE);
    assert_close(arm.pose(), pose, 0.01);
}

fn the_filter_is_set_outside_servo_mode(arm: &mut Arm) {
    let filter = SetServoMoveFilter::joint_low_pass(12.5);
    arm.client.set_servo_move_filter(&filter).expect("servo mode is off");
    assert_eq!(arm.controller.state().servo_filter, filter);
    arm.refuses(servo_mode, |client| client.set_servo_move_filter(&SetServoMoveFilter::disabled()));
    assert_eq!(arm.controller.state().servo_filter, filter);
}
