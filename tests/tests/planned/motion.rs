//! The simulated arm's motion, with a clock that the test moves on.

use std::time::Duration;

use jaka_sim::{Builder, Delays, Firmware};
use jaka_sync::frames::{SetToolOffsets, SetUserOffsets};
use jaka_sync::kinematics::KineInverse;
use jaka_sync::motion::{EndMove, Jog, JogFrame, JointMove, LineMode, MoveC, MoveL};
use jaka_sync::program::ProgramState;
use jaka_sync::servo::{ServoJ, ServoP};
use jaka_sync::types::{MoveMode, Pose, Switch};
use jaka_sync::{Client, ErrorCode, StatusStream};
use jaka_tests::{Arm, ArmBuilder, CYCLE};

fn stepped() -> ArmBuilder {
    Arm::stepped().no_packets()
}

fn joints(client: &mut Client) -> [f64; 6] {
    client.get_joint_pos().expect("it answers").joint_position.0
}

fn pose(client: &mut Client) -> [f64; 6] {
    client.get_tcp_pos().expect("it answers").pose.into()
}

/// Lets time go on until the arm is in position, and says for how long it was not. Calls `each` after each cycle.
fn run(arm: &Arm, mut each: impl FnMut()) -> Duration {
    let mut cycles = 0;
    while !arm.state().in_position {
        arm.advance(CYCLE);
        each();
        cycles += 1;
        assert!(cycles < 100_000, "the motion never ends");
    }
    CYCLE * cycles
}

#[track_caller]
fn assert_close(a: [f64; 6], b: [f64; 6], tolerance: f64) {
    assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() <= tolerance), "{a:?} is not {b:?}");
}

fn place([x, y, z, ..]: [f64; 6]) -> [f64; 3] {
    [x, y, z]
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
}

fn by_joint(mode: MoveMode, position: [f64; 6], speed: f64, acceleration: f64) -> JointMove {
    JointMove::new(mode, position, speed).acceleration(acceleration)
}

#[test]
fn power_and_enabling_take_their_time() {
    let real = |controller: Builder| controller.firmware(Firmware::Newer).delays(Delays::REAL);
    let (arm, mut client) = stepped().without_power().controller(real).with_client();
    client.power_on().expect("it answers at once");
    assert!(!client.get_robot_state().expect("it answers").powered_on);
    assert!(client.enable_robot().is_err_and(|error| error.is_refused()));
    arm.advance(Duration::from_secs(7));
    assert!(!client.get_robot_state().expect("it answers").powered_on);
    arm.advance(Duration::from_millis(1010));
    assert!(client.get_robot_state().expect("it answers").powered_on);
    client.enable_robot().expect("it answers at once");
    assert!(!client.get_robot_state().expect("it answers").enabled);
    arm.advance(Duration::from_secs(4));
    assert!(client.get_robot_state().expect("it answers").enabled);
    // Switched off before it is on, it stays off.
    client.disable_robot().expect("it answers");
    client.enable_robot().expect("it answers");
    client.disable_robot().expect("it answers");
    arm.advance(Duration::from_secs(30));
    assert!(!client.get_robot_state().expect("it answers").enabled);
}

#[test]
fn profiles_take_the_time_of_theory() {
    let (arm, mut client) = stepped().with_client();
    for (angle, speed, acceleration, rate) in
        [(30.0, 10.0, 20.0, 1.0), (1.0, 100.0, 50.0, 1.0), (-45.0, 90.0, 720.0, 1.0), (20.0, 10.0, 40.0, 0.25)]
    {
        client.set_rapid_rate(rate).expect("it answers");
        let before = joints(&mut client);
        let offset = [angle, angle / 2.0, 0.0, 0.0, 0.0, 0.0];
        client.joint_move(&by_joint(MoveMode::Relative, offset, speed, acceleration)).expect("it is reachable");
        let taken = run(&arm, || ()).as_secs_f64();
        let way = f64::abs(angle);
        let peak = speed.min((way * acceleration).sqrt());
        let theory = (way / peak + peak / acceleration) / rate;
        assert!((taken - theory).abs() <= CYCLE.as_secs_f64() + 1e-9, "{taken} s instead of {theory} s");
        let after = joints(&mut client);
        assert_close(after, std::array::from_fn(|i| before[i] + offset[i]), 1e-9);
    }
}

#[test]
fn no_joint_is_faster_than_asked() {
    let (arm, mut client) = stepped().with_client();
    let offset = [40.0, -20.0, 10.0, 5.0, 30.0, -35.0];
    client.joint_move(&by_joint(MoveMode::Relative, offset, 25.0, 100.0)).expect("it is reachable");
    let mut last = arm.state().joint_position.0;
    run(&arm, || {
        let now = arm.state().joint_position.0;
        let fastest = last.iter().zip(now).map(|(last, now)| (now - last).abs()).fold(0.0, f64::max);
        assert!(fastest / CYCLE.as_secs_f64() <= 25.0 + 1e-6);
        last = now;
    });
}

#[test]
fn motions_queue() {
    let (arm, mut client) = stepped().with_client();
    let start = joints(&mut client);
    for angle in [10.0, -25.0, 5.0] {
        let offset = [angle, 0.0, 0.0, 0.0, 0.0, 0.0];
        client.joint_move(&by_joint(MoveMode::Relative, offset, 20.0, 100.0)).expect("it is reachable");
    }
    let mut furthest = (f64::MIN, f64::MAX);
    run(&arm, || {
        let at = arm.state().joint_position.0[0] - start[0];
        furthest = (furthest.0.max(at), furthest.1.min(at));
    });
    assert!((furthest.0 - 10.0).abs() < 1e-6 && (furthest.1 + 15.0).abs() < 1e-6, "{furthest:?}");
    assert_close(joints(&mut client), std::array::from_fn(|i| start[i] - if i == 0 { 10.0 } else { 0.0 }), 1e-9);
}

#[test]
fn a_straight_line_is_straight() {
    let (arm, mut client) = stepped().with_client();
    let start = pose(&mut client);
    let offset = Pose { x: 60.0, y: -120.0, z: 80.0, rx: 10.0, ry: -15.0, rz: 20.0 };
    let request = MoveL::relative(offset, 100.0).acceleration(400.0);
    client.move_l(&request).expect("it is reachable");
    let direction: [f64; 3] = [60.0, -120.0, 80.0];
    let way = distance(direction, [0.0; 3]);
    let mut furthest: f64 = 0.0;
    let taken = run(&arm, || {
        let at = place(arm.state().tcp_pose.into());
        let done: f64 = (0..3).map(|i| (at[i] - start[i]) * direction[i] / way).sum();
        let on_line = std::array::from_fn(|i| start[i] + direction[i] * done / way);
        furthest = furthest.max(distance(at, on_line));
        assert!(arm.state().tcp_speed <= 100.5);
    });
    assert!(furthest < 0.1, "{furthest} mm off the line");
    assert!((taken.as_secs_f64() - (way / 100.0 + 100.0 / 400.0)).abs() <= CYCLE.as_secs_f64() + 1e-9);
    let end = pose(&mut client);
    assert!(distance(place(end), std::array::from_fn(|i| start[i] + direction[i])) < 0.01);
    // Back to the pose itself, orientation too.
    let mut back = request;
    back.mode = LineMode::Absolute;
    back.pose = start.into();
    client.move_l(&back).expect("it came from there");
    run(&arm, || ());
    assert_close(pose(&mut client), start, 0.01);
}

#[test]
fn an_arc_is_round_and_goes_through_its_three_points() {
    let (arm, mut client) = stepped().with_client();
    let start = pose(&mut client);
    // A quarter turn of radius 50 about a point next to the start.
    let on_circle = |angle: f64| {
        let mut pose = start;
        pose[0] += 50.0 * angle.cos() - 50.0;
        pose[1] += 50.0 * angle.sin();
        Pose::from(pose)
    };
    let (mid, end) = (std::f64::consts::FRAC_PI_4, std::f64::consts::FRAC_PI_2);
    let request = MoveC::absolute(on_circle(mid), on_circle(end), 40.0, 200.0, 0.0);
    client.move_c(&request).expect("it is reachable");
    let centre = [start[0] - 50.0, start[1], start[2]];
    let mut nearest_to_middle = f64::MAX;
    let mut furthest: f64 = 0.0;
    let taken = run(&arm, || {
        let at = place(arm.state().tcp_pose.into());
        furthest = furthest.max((distance(at, centre) - 50.0).abs());
        nearest_to_middle = nearest_to_middle.min(distance(at, place(on_circle(mid).into())));
    });
    assert!(furthest < 0.1, "{furthest} mm off the circle");
    assert!(nearest_to_middle < 0.5, "the middle point was missed by {nearest_to_middle} mm");
    assert_close(pose(&mut client), on_circle(end).into(), 0.01);
    let way = 50.0 * end;
    assert!((taken.as_secs_f64() - (way / 40.0 + 40.0 / 200.0)).abs() <= CYCLE.as_secs_f64() + 1e-9);
    // Three points on a line make no circle.
    let mut straight = request;
    straight.mid_pose = on_circle(end);
    straight.end_pose = on_circle(end);
    assert!(client.move_c(&straight).is_err_and(|error| error.is_refused()));
}

#[test]
fn end_move_goes_to_a_pose_by_joints() {
    let (arm, mut client) = stepped().with_client();
    let mut target = pose(&mut client);
    target[1] += 150.0;
    target[2] += 50.0;
    client.end_move(&EndMove::new(target, 30.0).acceleration(90.0)).expect("it is reachable");
    run(&arm, || ());
    assert_close(pose(&mut client), target, 0.01);
}

#[test]
fn unreachable_targets_are_refused_as_the_document_shows() {
    let (_arm, mut client) = stepped().with_client();
    let far = Pose { x: 5000.0, y: 0.0, z: 0.0, rx: 0.0, ry: 0.0, rz: 0.0 };
    let reference_joint_position = client.get_joint_pos().expect("it answers").joint_position;
    let error = client.kine_inverse(&KineInverse::new(reference_joint_position, far)).expect_err("it is too far");
    let refusal = error.refusal().expect("the controller refuses");
    assert_eq!((refusal.code, refusal.message.as_str()), (ErrorCode(2), "call kine_inverse failed"));
    assert!(client.end_move(&EndMove::new(far, 10.0)).is_err_and(|e| e.is_refused()));
    let line = MoveL::absolute(far, 10.0);
    assert!(client.move_l(&line).is_err_and(|error| error.is_refused()));
    let beyond = by_joint(MoveMode::Absolute, [0.0, 0.0, 300.0, 0.0, 0.0, 0.0], 10.0, 10.0);
    assert!(client.joint_move(&beyond).is_err_and(|error| error.is_refused()));
}

#[test]
fn kinematics_agree_with_one_another() {
    let (_arm, mut client) = stepped().with_client();
    let at = client.get_joint_pos().expect("it answers").joint_position;
    let tcp = pose(&mut client);
    assert_close(client.kine_forward(at).expect("it answers").pose.into(), tcp, 1e-9);
    let request = KineInverse::new(at, tcp);
    assert_close(client.kine_inverse(&request).expect("it is there").joint_position.0, at.0, 1e-6);
    let dh = client.get_dh_param().expect("it answers");
    assert!(dh.a.iter().chain(&dh.d).any(|length| length.abs() > 100.0), "the lengths are those of an arm: {dh:?}");
}

#[test]
fn frames_change_the_pose_and_the_targets() {
    let (arm, mut client) = stepped().with_client();
    let flange = pose(&mut client);
    let tool = Pose { x: 0.0, y: 0.0, z: 120.0, rx: 0.0, ry: 0.0, rz: 0.0 };
    client.set_tool_offsets(&SetToolOffsets::new(tool, 4, "gripper")).expect("it answers");
    client.set_tool_id(4).expect("it answers");
    assert!((distance(place(pose(&mut client)), place(flange)) - 120.0).abs() < 1e-6);
    let user = Pose { x: 100.0, y: -50.0, z: 10.0, rx: 0.0, ry: 0.0, rz: 90.0 };
    client.set_user_offsets(&SetUserOffsets::new(user, 2, "table")).expect("it answers");
    client.set_user_id(2).expect("it answers");
    let seen = pose(&mut client);
    // A relative move follows the axes of the user frame: its x is the base's y.
    let offset = Pose { x: 30.0, y: 0.0, z: 0.0, rx: 0.0, ry: 0.0, rz: 0.0 };
    let line = MoveL::relative(offset, 50.0);
    client.move_l(&line).expect("it is reachable");
    run(&arm, || ());
    assert!((pose(&mut client)[0] - seen[0] - 30.0).abs() < 0.01);
    client.set_tool_id(0).expect("it answers");
    client.set_user_id(0).expect("it answers");
    let moved = pose(&mut client);
    assert!((moved[1] - flange[1] - 30.0).abs() < 0.01 && (moved[0] - flange[0]).abs() < 0.01, "{moved:?} {flange:?}");
}

#[test]
fn a_stop_brakes_and_forgets_what_waits() {
    let (arm, mut client) = stepped().with_client();
    let start = joints(&mut client);
    for _ in 0..2 {
        let offset = [60.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        client.joint_move(&by_joint(MoveMode::Relative, offset, 30.0, 60.0)).expect("it is reachable");
    }
    arm.advance(Duration::from_secs(1));
    let at = joints(&mut client)[0];
    client.stop_program().expect("it answers");
    let taken = run(&arm, || ());
    // From 30 deg/s at 60 deg/s²: half a second, and 7.5 degrees.
    assert!((taken.as_secs_f64() - 0.5).abs() <= 2.0 * CYCLE.as_secs_f64(), "{taken:?}");
    assert!((joints(&mut client)[0] - at - 7.5).abs() < 0.3);
    arm.advance(Duration::from_secs(10));
    assert!(joints(&mut client)[0] - start[0] < 60.0);
    client.joint_move(&by_joint(MoveMode::Absolute, start, 30.0, 60.0)).expect("the arm can move again");
    run(&arm, || ());
    assert_close(joints(&mut client), start, 1e-9);
}

#[test]
fn in_position_falls_late_and_not_at_all_for_a_move_of_no_length() {
    let (arm, mut client) = stepped().controller(|controller| controller.delays(Delays::REAL)).with_client();
    let offset = [20.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    client.joint_move(&by_joint(MoveMode::Relative, offset, 20.0, 100.0)).expect("it is reachable");
    arm.advance(Duration::from_millis(80));
    assert!(arm.state().in_position);
    arm.advance(Duration::from_millis(40));
    assert!(!arm.state().in_position);
    run(&arm, || ());
    client.joint_move(&by_joint(MoveMode::Relative, [0.0; 6], 20.0, 100.0)).expect("it is accepted");
    for _ in 0..100 {
        arm.advance(CYCLE);
        assert!(arm.state().in_position);
    }
}

#[test]
fn jogs_in_all_modes_and_frames() {
    let (arm, mut client) = stepped().with_client();
    let start = joints(&mut client);
    client.jog(&Jog::continuous(JogFrame::Joint, 1, -10.0)).expect("the arm is enabled");
    let again = client.jog(&Jog::continuous(JogFrame::Joint, 1, 5.0));
    assert!(again.is_err_and(|error| error.is_refused()), "it must be stopped first");
    arm.advance(Duration::from_secs(1));
    client.jog(&Jog::stop(JogFrame::Joint, 1)).expect("it answers");
    run(&arm, || ());
    assert!((joints(&mut client)[1] - start[1] + 10.0).abs() < 0.2);
    client.jog(&Jog::absolute(JogFrame::Joint, 1, 20.0, start[1])).expect("it goes");
    run(&arm, || ());
    assert_close(joints(&mut client), start, 1e-9);
    client.jog(&Jog::increment(JogFrame::Joint, 5, 20.0, -7.0)).expect("it goes");
    run(&arm, || ());
    assert!((joints(&mut client)[5] - start[5] + 7.0).abs() < 1e-9);

    let before = pose(&mut client);
    client.jog(&Jog::increment(JogFrame::World, 1, 50.0, 25.0)).expect("it goes");
    run(&arm, || ());
    assert!((pose(&mut client)[1] - before[1] - 25.0).abs() < 0.01);
    client.jog(&Jog::absolute(JogFrame::World, 1, 50.0, before[1])).expect("it goes");
    run(&arm, || ());
    assert_close(pose(&mut client), before, 0.01);
    // The tool points down, so forward along its z is down.
    client.jog(&Jog::continuous(JogFrame::Tool, 2, 20.0)).expect("it goes");
    arm.advance(Duration::from_secs(1));
    client.jog(&Jog::stop(JogFrame::Tool, 2)).expect("it answers");
    assert!((distance(place(pose(&mut client)), place(before)) - 20.0).abs() < 0.3);
}

#[test]
fn a_jog_ends_at_the_soft_limit() {
    let (arm, mut client) = stepped().with_client();
    client.jog(&Jog::continuous(JogFrame::Joint, 0, 90.0)).expect("the arm is enabled");
    arm.advance(Duration::from_secs(60));
    assert!(arm.state().in_position);
    assert!(joints(&mut client)[0] > 90.0);
}

#[test]
fn servo_set_points_move_within_their_cycles() {
    let (arm, mut client) = stepped().with_client();
    let start = joints(&mut client);
    let step = |angle: f64| ServoJ::relative([angle, 0.0, 0.0, 0.0, 0.0, 0.0]);
    let error = client.servo_j(&step(0.1)).expect_err("servo mode is off");
    let refusal = error.refusal().expect("the controller refuses");
    assert_eq!(refusal.code, ErrorCode(-1));
    assert_eq!(refusal.message, "servoj command can only be excuted in servo move mode");

    client.set_servo_mode(Switch::On).expect("it answers");
    assert!(client.is_in_servomove().expect("it answers").in_servo_mode);
    for _ in 0..10 {
        client.servo_j(&step(0.5).step_count(1)).expect("servo mode is on");
        arm.advance(CYCLE);
    }
    assert!((joints(&mut client)[0] - start[0] - 5.0).abs() < 1e-9);
    // 1.5 degrees in a cycle are 187.5 deg/s: no effect. In two cycles they are fine.
    client.servo_j(&step(1.5).step_count(1)).expect("it still answers");
    arm.advance(CYCLE * 4);
    assert!((joints(&mut client)[0] - start[0] - 5.0).abs() < 1e-9);
    client.servo_j(&step(1.5).step_count(2)).expect("servo mode is on");
    arm.advance(CYCLE);
    assert!((joints(&mut client)[0] - start[0] - 5.75).abs() < 1e-9);
    arm.advance(CYCLE);
    assert!((joints(&mut client)[0] - start[0] - 6.5).abs() < 1e-9);

    let mut target = pose(&mut client);
    target[2] += 0.5;
    let request = ServoP::absolute(target).step_count(1);
    client.servo_p(&request).expect("servo mode is on");
    arm.advance(CYCLE);
    assert_close(pose(&mut client), target, 0.01);
    assert!(client.joint_move(&by_joint(MoveMode::Absolute, start, 10.0, 10.0)).is_err_and(|e| e.is_refused()));
    client.set_servo_mode(Switch::Off).expect("it answers");
    client.joint_move(&by_joint(MoveMode::Absolute, start, 10.0, 10.0)).expect("servo mode is off");
}

#[test]
fn programs_play_pause_and_resume() {
    let (arm, mut client) = stepped().with_client();
    let start = joints(&mut client);
    assert!(client.load_program("no_such_program.jks").is_err_and(|error| error.is_refused()));
    client.load_program("test.jks").expect("every controller has it");
    client.play_program().expect("the arm is enabled");
    let state = |client: &mut Client| client.get_program_state().expect("it answers").program_state;
    assert_eq!(state(&mut client), ProgramState::Running);
    arm.advance(Duration::from_millis(300));
    client.pause_program().expect("it answers");
    let paused = joints(&mut client);
    assert!((paused[0] - start[0]).abs() > 0.1);
    arm.advance(Duration::from_secs(5));
    assert_close(joints(&mut client), paused, 0.0);
    assert_eq!(state(&mut client), ProgramState::Paused);
    assert!(arm.state().program_state == ProgramState::Paused);
    client.resume_program().expect("it answers");
    arm.advance(Duration::from_secs(5));
    assert_eq!(state(&mut client), ProgramState::Idle);
    assert_close(joints(&mut client), start, 1e-9);
}

#[test]
fn recorded_trajectories_are_replayed() {
    use jaka_sync::trajectory::{GenerateTrajExeFile, SetTrajSampleMode};
    let (arm, mut client) = stepped().with_client();
    let start = joints(&mut client);
    let sample = |mode| SetTrajSampleMode::new(mode, "arch");
    client.set_traj_sample_mode(&sample(Switch::On)).expect("it answers");
    client.joint_move(&by_joint(MoveMode::Relative, [8.0, 0.0, 0.0, 0.0, 4.0, 0.0], 20.0, 80.0)).expect("it goes");
    run(&arm, || ());
    let end = joints(&mut client);
    client.set_traj_sample_mode(&sample(Switch::Off)).expect("it answers");
    client.call(&GenerateTrajExeFile::new("arch")).expect("it was recorded");
    client.joint_move(&by_joint(MoveMode::Absolute, start, 20.0, 80.0)).expect("it goes");
    run(&arm, || ());
    client.load_program("track/arch.jks").expect("it was generated");
    client.play_program().expect("the arm is enabled");
    arm.advance(Duration::from_secs(120));
    assert_close(joints(&mut client), end, 1e-6);
}

#[test]
fn a_payload_is_identified_by_a_motion() {
    use jaka_sync::force::IdentifyStatus;
    use jaka_sync::payload::SetPayload;
    let (arm, mut client) = stepped().with_client();
    client.set_payload(&SetPayload::new(1.5, [1.0, 2.0, 30.0])).expect("it answers");
    let mut end = joints(&mut client);
    end[5] += 45.0;
    client.start_torq_sensor_payload_identify(end).expect("it is reachable");
    let status = |client: &mut Client| client.get_torq_sensor_identify_status().expect("it answers").status;
    assert_eq!(status(&mut client), IdentifyStatus::NotDone);
    run(&arm, || ());
    arm.advance(CYCLE);
    assert_eq!(status(&mut client), IdentifyStatus::Done);
    assert_close(joints(&mut client), end, 1e-9);
    let found = client.get_torq_sensor_payload_identify_result().expect("it answers");
    assert_eq!((found.mass, found.centroid), (1.5, [1.0, 2.0, 30.0].into()));
    end[5] -= 45.0;
    client.start_torq_sensor_payload_identify(end).expect("it is reachable");
    arm.collide();
    assert_eq!(status(&mut client), IdentifyStatus::Failed);
}

#[test]
fn collisions_emergency_stops_and_lost_power_end_motion() {
    let (arm, mut client) = stepped().with_client();
    let go = by_joint(MoveMode::Relative, [30.0, 0.0, 0.0, 0.0, 0.0, 0.0], 20.0, 80.0);
    let back = by_joint(MoveMode::Relative, [-0.5, 0.0, 0.0, 0.0, 0.0, 0.0], 20.0, 80.0);
    client.joint_move(&go).expect("it is reachable");
    arm.advance(Duration::from_millis(500));
    arm.collide();
    let at = joints(&mut client);
    arm.advance(Duration::from_secs(5));
    assert_close(joints(&mut client), at, 0.0);
    assert!(client.protective_stop_status().expect("it answers").protective_stop);
    assert!(client.joint_move(&back).is_err_and(|error| error.is_refused()));
    client.clear_error().expect("it answers");
    client.joint_move(&back).expect("the protective stop is left");
    run(&arm, || ());

    arm.press_emergency_stop();
    assert!(!client.get_robot_state().expect("it answers").enabled);
    client.enable_robot().expect("it answers");
    assert!(!client.get_robot_state().expect("it answers").enabled);
    arm.release_emergency_stop();
    client.enable_robot().expect("it answers");
    client.joint_move(&back).expect("the arm is enabled again");
    arm.cut_power();
    let state = client.get_robot_state().expect("it answers");
    assert!(!state.powered_on && !state.enabled);
    assert!(client.joint_move(&back).is_err_and(|error| error.is_refused()));
}

#[test]
fn status_packets_follow_the_motion() {
    let period = Duration::from_millis(40);
    let (arm, mut client) = Arm::stepped().status_period(period).with_client();
    let mut status = StatusStream::connect_with(&arm.config(), arm.status_addr()).expect("the controller listens");
    status.next_packet().expect("the first packet comes at once");
    let start = joints(&mut client)[0];
    client.joint_move(&by_joint(MoveMode::Relative, [10.0, 0.0, 0.0, 0.0, 0.0, 0.0], 20.0, 80.0)).expect("it goes");
    let next = |_| {
        arm.advance(period);
        status.next_packet().expect("a packet comes")
    };
    let packets: Vec<_> = (0..50).map(next).collect();
    let angles: Vec<_> = packets.iter().filter_map(|packet| Some(packet.joint_actual_position?.0[0])).collect();
    assert!(angles.is_sorted() && (angles[49] - start - 10.0).abs() < 1e-9);
    assert_eq!(packets[5].in_position, Some(false));
    assert!(packets[5].tcp_speed.is_some_and(|speed| speed > 1.0));
    assert_eq!((packets[49].in_position, packets[49].tcp_speed), (Some(true), Some(0.0)));
}
