//! Tool frames and user frames.

use jaka_sync::frames::{SetToolOffsets, SetUserOffsets};

use super::arm::{Arm, assert_close, shift};

effects! {
    set_tool_offsets => a_tool_frame_is_set,
    set_tool_id => a_tool_frame_in_use_moves_the_tool_centre_point,
    get_tool_offsets => tool_frames_are_read,
    set_user_offsets => a_user_frame_is_set,
    set_user_id => a_user_frame_in_use_changes_the_view,
    get_user_offsets => user_frames_are_read,
}

fn a_tool_frame_is_set(arm: &mut Arm) {
    let offset = shift(1.0, 2.0, 120.0);
    arm.client.set_tool_offsets(&SetToolOffsets::new(offset, 4, "gripper")).expect("it answers");
    assert_eq!(arm.client.get_tool_offsets().expect("it answers").offsets[4], offset);
    assert_eq!(arm.controller.state().tool_frames[4].name, "gripper");
}

fn a_tool_frame_in_use_moves_the_tool_centre_point(arm: &mut Arm) {
    let flange = arm.pose();
    arm.controller.set_state(|state| state.tool_frames[4].offset = shift(0.0, 0.0, 120.0));
    assert_close(arm.pose(), flange, 0.0);
    arm.client.set_tool_id(4).expect("it answers");
    assert_eq!(arm.status().current_tool_id, Some(4));
    // The flange points down.
    let mut tool = flange;
    tool[2] -= 120.0;
    assert_close(arm.pose(), tool, 1e-6);
    arm.client.set_tool_id(0).expect("it answers");
    assert_close(arm.pose(), flange, 1e-9);
}

fn tool_frames_are_read(arm: &mut Arm) {
    arm.controller.set_state(|state| state.tool_frames[9].offset = shift(3.0, 2.0, 1.0));
    let offsets = arm.client.get_tool_offsets().expect("it answers").offsets;
    assert_eq!((offsets.len(), offsets[9]), (11, shift(3.0, 2.0, 1.0)));
}

fn a_user_frame_is_set(arm: &mut Arm) {
    let offset = shift(100.0, -50.0, 10.0);
    arm.client.set_user_offsets(&SetUserOffsets::new(offset, 2, "table")).expect("it answers");
    assert_eq!(arm.client.get_user_offsets().expect("it answers").offsets[2], offset);
    assert_eq!(arm.controller.state().user_frames[2].name, "table");
}

fn a_user_frame_in_use_changes_the_view(arm: &mut Arm) {
    let base = arm.pose();
    arm.controller.set_state(|state| state.user_frames[2].offset = shift(100.0, -50.0, 10.0));
    assert_close(arm.pose(), base, 0.0);
    arm.client.set_user_id(2).expect("it answers");
    assert_eq!(arm.status().current_user_frame_id, Some(2));
    let [x, y, z, rx, ry, rz] = base;
    assert_close(arm.pose(), [x - 100.0, y + 50.0, z - 10.0, rx, ry, rz], 1e-6);
    arm.client.set_user_id(0).expect("it answers");
    assert_close(arm.pose(), base, 1e-9);
}

fn user_frames_are_read(arm: &mut Arm) {
    arm.controller.set_state(|state| state.user_frames[9].offset = shift(3.0, 2.0, 1.0));
    let offsets = arm.client.get_user_offsets().expect("it answers").offsets;
    assert_eq!((offsets.len(), offsets[9]), (11, shift(3.0, 2.0, 1.0)));
}
