//! Kinematics and present position.

use jaka_sim::Model;
use jaka_sync::kinematics::KineInverse;

use super::arm::{Arm, assert_close, refused, shift};

effects! {
    kine_forward => forward_kinematics_agree_with_the_arm,
    kine_inverse => inverse_kinematics_agree_with_the_arm,
    get_joint_pos => joints_are_where_they_were_put,
    get_tcp_pos => the_pose_follows_from_joints_and_frames,
    get_dh_param => the_parameters_are_the_models,
}

/// Joints away from the start, and not singular.
const ELSEWHERE: [f64; 6] = [20.0, 70.0, 80.0, 100.0, -75.0, 15.0];

fn forward_kinematics_agree_with_the_arm(arm: &mut Arm) {
    let before = arm.pose();
    let there = arm.client.kine_forward(ELSEWHERE).expect("it answers").pose;
    // It computes, and moves nothing.
    assert_close(arm.pose(), before, 0.0);
    arm.controller.set_state(|state| state.joint_position = ELSEWHERE.into());
    // The packet has five decimals, the reply six.
    assert_close(arm.pose(), there, 1e-5);
}

fn inverse_kinematics_agree_with_the_arm(arm: &mut Arm) {
    let before = arm.joints();
    arm.controller.set_state(|state| state.joint_position = ELSEWHERE.into());
    let request = KineInverse::new(before, arm.pose());
    let reply = arm.client.kine_inverse(&request).expect("the arm is there");
    // Of a pose that has five decimals.
    assert_close(reply.joint_position, ELSEWHERE, 1e-5);
    refused(arm.client.kine_inverse(&{
        let mut changed = request;
        changed.pose = shift(5000.0, 0.0, 0.0);
        changed
    }));
}

fn joints_are_where_they_were_put(arm: &mut Arm) {
    arm.controller.set_state(|state| state.joint_position = ELSEWHERE.into());
    assert_eq!(arm.client.get_joint_pos().expect("it answers").joint_position, ELSEWHERE.into());
    assert_close(arm.joints(), ELSEWHERE, 0.0);
}

fn the_pose_follows_from_joints_and_frames(arm: &mut Arm) {
    let before = arm.client.get_tcp_pos().expect("it answers").pose;
    assert_close(arm.pose(), before, 0.0);
    arm.controller.set_state(|state| state.user_frames[0].offset.y = 100.0);
    let after = arm.client.get_tcp_pos().expect("it answers").pose;
    assert!((before.y - after.y - 100.0).abs() < 1e-9);
    arm.controller.set_state(|state| state.joint_position.0[0] = 90.0);
    assert_ne!(arm.client.get_tcp_pos().expect("it answers").pose, after);
}

fn the_parameters_are_the_models(arm: &mut Arm) {
    let reply = arm.client.get_dh_param().expect("it answers");
    let model = Model::default();
    assert_eq!((reply.alpha, reply.a, reply.d), (*model.alpha(), *model.a(), *model.d()));
    assert_close(reply.joint_home_offset, *model.joint_home_offset(), 0.0);
    assert!(reply.a.iter().any(|length| length.abs() > 100.0));
}
