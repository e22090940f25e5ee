//! Jog and planned motion.

use std::thread;

use jaka_sync::motion::{EndMove, Jog, JogFrame, MoveC, MoveL};
use jaka_tests::LONG;

use super::arm::{Arm, assert_close, disabled, raised, servo_mode, shift, turn, turned};

effects! {
    jog => a_jog_moves_one_axis_until_it_is_stopped,
    joint_move => joints_move_by_an_offset,
    end_move => the_tool_reaches_a_pose_by_joints,
    moveL => the_tool_moves_along_a_line,
    movc => the_tool_moves_along_an_arc,
    wait_complete => the_reply_comes_when_the_motion_has_ended,
}

fn a_jog_moves_one_axis_until_it_is_stopped(arm: &mut Arm) {
    let start = arm.joints();
    let (frame, axis) = (JogFrame::Joint, 0);
    arm.client.jog(&Jog::continuous(frame, axis, -10.0)).expect("the arm is enabled");
    arm.wait(2);
    assert_close(arm.joints(), turned(start, -20.0), 1e-6);
    arm.client.jog(&Jog::stop(frame, axis)).expect("it answers");
    arm.wait(2);
    assert_close(arm.joints(), turned(start, -20.0), 1e-6);
    arm.refuses(servo_mode, |client| client.jog(&Jog::continuous(frame, axis, 10.0)));
}

fn joints_move_by_an_offset(arm: &mut Arm) {
    let start = arm.joints();
    arm.client.joint_move(&turn(30.0)).expect("the arm is enabled");
    arm.wait(1);
    assert_eq!(arm.status().in_position, Some(false));
    arm.wait(1);
    assert_close(arm.joints(), turned(start, 30.0), 1e-9);
    assert_eq!(arm.status().in_position, Some(true));
    arm.refuses(disabled, |client| client.joint_move(&turn(1.0)));
}

fn the_tool_reaches_a_pose_by_joints(arm: &mut Arm) {
    let target = raised(arm.pose(), 50.0);
    let request = EndMove::new(target, 30.0);
    arm.client.end_move(&request).expect("it is reachable");
    arm.wait(10);
    assert_close(arm.pose(), target, 0.01);
    arm.refuses(servo_mode, |client| client.end_move(&request));
}

fn the_tool_moves_along_a_line(arm: &mut Arm) {
    let start = arm.pose();
    let pose = shift(0.0, 0.0, 60.0);
    let request = MoveL::relative(pose, 30.0).acceleration(300.0);
    arm.client.move_l(&request).expect("it is reachable");
    arm.wait(1);
    // The 0.1 s of acceleration brings it half as far as the speed would.
    assert_close(arm.pose(), raised(start, 28.5), 0.1);
    assert!(arm.status().tcp_speed.is_some_and(|speed| (speed - 30.0).abs() < 0.1));
    arm.wait(5);
    assert_close(arm.pose(), raised(start, 60.0), 0.01);
    arm.refuses(disabled, |client| client.move_l(&request));
}

fn the_tool_moves_along_an_arc(arm: &mut Arm) {
    let start = arm.pose();
    // Half a circle of radius 20 mm, up and to the side.
    let request = MoveC::relative(shift(0.0, 20.0, 20.0), shift(0.0, 0.0, 40.0), 20.0, 400.0, 0.0);
    arm.client.move_c(&request).expect("it is reachable");
    arm.wait(1);
    let pose = arm.pose();
    let radius = f64::hypot(pose[1] - start[1], pose[2] - start[2] - 20.0);
    assert!((radius - 20.0).abs() < 0.1 && pose[1] - start[1] > 10.0, "{pose:?} from {start:?}");
    arm.wait(5);
    assert_close(arm.pose(), raised(start, 40.0), 0.01);
    arm.refuses(servo_mode, |client| client.move_c(&request));
}

fn the_reply_comes_when_the_motion_has_ended(arm: &mut Arm) {
    let end = turned(arm.joints(), 30.0);
    arm.client.joint_move(&turn(30.0)).expect("the arm is enabled");
    let sent = arm.controller.requests().len();
    let Arm { controller, client } = arm;
    let reached = thread::scope(|scope| {
        let waiting = scope.spawn(|| {
            #[expect(deprecated, reason = "it is a command of the spec")]
            client.wait_complete().expect("it answers");
            controller.state().joint_position
        });
        assert!(controller.wait_for_requests(sent + 1, LONG));
        controller.advance(LONG);
        waiting.join().expect("the thread does not panic")
    });
    assert_close(reached, end, 1e-9);
}
