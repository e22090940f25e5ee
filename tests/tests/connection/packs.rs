//! Packs end to end: a crate that depends on jaka-sync alone, and the simulator that knows the same packs.

use std::path::PathBuf;

use jaka_pack_user::changed::{self, ChangedCommands as _, ToolVoltage};
use jaka_pack_user::later::{self, LaterCommands as _};
use jaka_pack_user::newer::{self, NewerCommands as _};
use jaka_pack_user::{is_stopped, move_with_zone, queued};
use jaka_robot::status::RobotStatus;
use jaka_robot::{Monitor, Robot};
use jaka_sim::{Builder, Controller};
use jaka_tests::{Arm, LONG};
use serde_json::{Value, json};

fn pack(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("pack-user").join(name)
}

fn arm() -> Arm {
    Arm::simulated().without_power().controller(|sim| sim.pack(pack("newer.toml")).pack(pack("changed.toml"))).start()
}

/// The last request that the controller received.
fn last_request(controller: &Controller) -> Value {
    let requests = controller.requests();
    serde_json::from_str(requests.last().expect("something was sent")).expect("requests are JSON")
}

#[test]
fn commands_of_a_pack_are_called_and_answered() {
    let arm = arm();
    let mut robot = arm.client();
    let state = robot.demo_motion_state().expect("the pack's example is the answer");
    let newer::DemoMotionStateReply { in_position, paused, queue, active_queue, .. } = state;
    assert_eq!((in_position, paused, queue, active_queue), (true, false, 3, 1));
    assert_eq!(queued(&mut robot).expect("the same"), 3);
    assert!(!is_stopped(&mut robot).expect("without an example, the answer is no"));
    robot.set_demo_period(20).expect("the simulator accepts it");
    assert_eq!(last_request(&arm), json!({"cmdName": "demo_set_period", "demo_period": 20}));
}

#[test]
fn commands_of_a_pack_work_on_a_robot_and_through_references() {
    let arm = arm();
    let mut robot = arm.robot();
    assert_eq!(robot.demo_motion_state().expect("it is answered").queue, 3);
    assert!(!is_stopped(&mut &mut robot).expect("it is answered"));
}

#[test]
fn a_test_decides_what_is_answered() {
    let arm = arm();
    arm.set_reply("demo_stop_state", [("emergency_stop".to_owned(), 1.into())]);
    assert!(is_stopped(&mut arm.client()).expect("it is answered"));
}

#[test]
fn a_range_of_a_pack_holds_before_anything_is_sent() {
    let arm = arm();
    let error = arm.client().set_demo_period(0).expect_err("the pack forbids it");
    assert_eq!(error.to_string(), "`demo_set_period` was not sent: field `period` is 0, allowed is at least 1 ms");
    assert_eq!(arm.requests(), Vec::<String>::new());
}

#[test]
fn the_simulator_checks_and_refuses_what_a_pack_adds() {
    let arm = arm();
    let mut robot = arm.client();
    let error = robot.call_raw("demo_set_period", &json!({"demo_period": 0})).expect_err("out of range");
    assert!(error.is_refused(), "{error:?}");
    let error = move_with_zone(&mut robot, [0.0; 6], 5.0).expect_err("the arm has no power");
    assert!(error.is_refused(), "{error:?}");
}

#[test]
fn a_changed_command_sends_what_the_pack_adds() {
    let arm = arm();
    let mut robot = arm.client();
    robot.power_on().expect("it has power at once");
    robot.enable_robot().expect("it is enabled at once");
    move_with_zone(&mut robot, [10.0, 90.0, 90.0, 90.0, -90.0, 0.0], 5.0).expect("the motion is accepted");
    assert_eq!(last_request(&arm)["zone"], 5.0);
}

#[test]
fn a_motion_of_a_pack_is_waited_for() {
    let arm = arm();
    let mut robot = arm.robot();
    robot.power_up(LONG).expect("it has power at once");
    let request = changed::JointMove::absolute([5.0, 90.0, 90.0, 90.0, -90.0, 0.0], 90.0).zone(1.0);
    let end = robot.run(&request, LONG).expect("the motion is accepted");
    end.reached().expect("the arm reaches its target");
    let requests = arm.requests();
    let motion = requests.iter().find(|request| request.contains("joint_move")).expect("it was sent");
    assert_eq!(serde_json::from_str::<Value>(motion).expect("requests are JSON")["zone"], 1.0);
}

#[test]
fn a_widened_range_holds_in_the_client_and_in_the_simulator() {
    let arm = arm();
    let mut robot = arm.client();
    assert!(robot.set_rapid_rate(1.4).is_err_and(|error| error.is_invalid_argument()));
    robot.set_rapid_rate_changed(1.4).expect("the pack widens the range, for the simulator too");
    assert!(robot.set_rapid_rate_changed(1.6).is_err_and(|error| error.is_invalid_argument()));
}

#[test]
fn a_settled_field_is_typed() {
    let arm = arm();
    let request = changed::SetTioVoutParam::new(1, ToolVoltage::V12);
    arm.client().set_tio_vout_param_changed(&request).expect("the simulator accepts it");
    assert_eq!(last_request(&arm)["tio_vout_vol"], 1);
}

#[test]
fn a_status_packet_with_the_pack_s_keys() {
    let arm = arm();
    let monitor: Monitor<changed::RobotStatus> = arm.monitor();
    let plain: Monitor<RobotStatus> = arm.monitor();
    // The simulator sends the key, with zero until it is set.
    let status = monitor.wait_until(|_| true, LONG).expect("a packet comes");
    assert_eq!(status.status.brake_state, Some(0));
    let plain = plain.wait_until(|_| true, LONG).expect("a packet comes");
    assert_eq!(status.status.digital_inputs, plain.status.digital_inputs);
    arm.set_status([("brake_state".to_owned(), json!(2))]);
    let found = monitor.wait_until(|status| status.brake_state == Some(2), LONG);
    let packet = found.expect("the packet with the value comes");
    assert_eq!(packet.status.joint_actual_position, Some(arm.state().joint_position));
    assert_eq!(arm.stream().next_packet_as::<changed::RobotStatus>().expect("a packet comes").brake_state, Some(2));
}

#[test]
fn a_pack_stands_on_others() {
    let packs = ["newer.toml", "changed.toml", "later.toml"].map(pack);
    let arm =
        Arm::simulated().without_power().controller(|controller| packs.into_iter().fold(controller, Builder::pack));
    let arm = arm.start();
    let mut robot = arm.client();
    arm.set_reply("demo_motion_state", [("blend".to_owned(), 2.5.into())]);
    let state: later::DemoMotionStateReply = robot.demo_motion_state_later().expect("it is answered");
    assert_eq!((state.queue, state.blend), (3, Some(2.5)));
    assert_eq!(robot.demo_motion_state().expect("the pack below is as it was").queue, 3);
    arm.set_reply("demo_tool_voltage", [("voltage".to_owned(), 1.into())]);
    let voltage: ToolVoltage = robot.demo_tool_voltage().expect("its type is the one of the pack below").voltage;
    assert_eq!(voltage, ToolVoltage::V12);
    let turn = later::Jog::turn(3);
    assert!(robot.jog_later(&turn).is_err_and(|error| error.is_refused()), "the arm has no power");
    assert_eq!(last_request(&arm), json!({"cmdName": "jog", "jog_mode": 9, "jnum": 3}));
}

#[test]
fn a_robot_tells_by_a_pack_s_status_how_a_motion_goes() {
    let arm = arm();
    let mut robot =
        Robot::with_monitor(arm.client(), arm.monitor::<changed::RobotStatus>()).expect("it is the only robot");
    robot.power_up(LONG).expect("it has power at once");
    let request = changed::JointMove::absolute([5.0, 90.0, 90.0, 90.0, -90.0, 0.0], 90.0);
    robot.run(&request, LONG).expect("it is accepted").reached().expect("the arm reaches its target");
    let newest: Option<i64> = robot.monitor().last_known_packet().expect("there are packets").status.brake_state;
    assert_eq!(newest, Some(0), "the pack's own key is there, too");
    arm.collide();
    let stopped = |status: &changed::RobotStatus| status.protective_stop == Some(true);
    robot.monitor().wait_until(stopped, LONG).expect("the packet shows it");
    let error = robot.run(&request, LONG).expect_err("it is in a protective stop");
    assert!(matches!(error.kind(), jaka_robot::ErrorKind::NotAcknowledged { .. }), "{error}");
}

#[test]
fn codes_of_a_pack_have_names() {
    assert_eq!(changed::meaning(changed::OVERLOAD), Some("The payload is too heavy for the motion."));
    assert_eq!(changed::meaning(jaka_robot::ErrorCode::CALL_FAILED), jaka_robot::ErrorCode::CALL_FAILED.meaning());
}

#[test]
fn a_wrong_pack_is_an_error_at_the_start() {
    let error = Controller::builder().pack("nowhere.toml").start().expect_err("there is no such file");
    assert!(error.to_string().starts_with("cannot read the pack `nowhere.toml`: "), "{error}");
}

#[test]
fn a_field_that_this_firmware_does_not_have_is_refused_by_its_pack_s_word() {
    let arm = arm();
    let mut robot = arm.client();
    robot.check_firmware().expect("the controller says its version");
    let error = move_with_zone(&mut robot, [0.0; 6], 5.0).expect_err("firmware 1.5.14 has no zones");
    assert_eq!(
        error.to_string(),
        "`joint_move` was not sent: the controller's firmware 1.5.14 does not have its field `zone`; firmware 1.7.1 and \
         later has"
    );
}

#[test]
fn a_reply_can_have_the_keys_of_the_status_packet() {
    let arm = arm();
    let mut robot = arm.client();
    let answer = |key: &str, value: Value| arm.set_reply("read_whole_state", [(key.to_owned(), value)]);
    answer("brake_state", 2.into());
    let state: changed::RobotStatus = robot.read_whole_state().expect("it is answered");
    assert_eq!((state.brake_state, state.enabled), (Some(2), Some(false)));
    assert_eq!(state.joint_actual_position, Some(arm.state().joint_position));
    answer("brake_state", "on".into());
    let error = robot.read_whole_state().expect_err("nothing is left out of a reply");
    let source = std::error::Error::source(&error).expect("the reply does not fit").to_string();
    assert!(source.starts_with("field `brake_state`: expected a whole number"), "{source}");
}
