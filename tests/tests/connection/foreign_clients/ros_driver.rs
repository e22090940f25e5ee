//! `RobotControlAndMachineVisionLaboratory/jaka_controller_tcp_ros`, a ROS node in C++ for firmware 1.4.11, which is
//! older than any that the simulator has: here it talks to 1.5.14.
//!
//! It builds requests by concatenation with `std::to_string`, so that each number that may have a fraction has six
//! decimals, of a `float`. It reads a reply by one `recv` of 8192 bytes, and looks into the reply to `get_data` alone:
//! a refusal goes unnoticed. The end of a motion is the reply to `wait_complete`.

use std::fmt::Write as _;
use std::time::Duration;

use jaka_sim::{Firmware, Model};
use jaka_tests::{Arm, CYCLE, LONG};
use serde_json::{Map, Value};

use super::{Wire, are_close, object, six};

/// Size of the client's buffer, and of its one read of a reply.
const READ: usize = 8192;

const WAIT: &str = r#"{"cmdName":"wait_complete"}"#;
const GET_DATA: &str = r#"{"cmdName":"get_data"}"#;

/// `std::to_string` of a `float`.
fn text(number: f32) -> String {
    format!("{:.6}", f64::from(number))
}

fn list(numbers: [f32; 6]) -> String {
    numbers.map(text).join(",")
}

/// An arm of the repository's kind, a Zu 7.
fn arm(firmware: Firmware) -> Arm {
    let model = Model::named("zu7").expect("it is published").clone();
    let arm = Arm::stepped().without_power().no_packets();
    arm.controller(|controller| controller.model(model).firmware(firmware)).start()
}

/// Sends a request whose reply the client reads and does not look at.
fn blind(wire: &mut Wire<'_>, request: &str) -> String {
    wire.ask(request, READ)
}

/// Sends a motion and `wait_complete`, and returns the reply to the motion when that to `wait_complete` has come.
fn moved(wire: &mut Wire<'_>, request: &str) -> String {
    let reply = blind(wire, request);
    wire.send(WAIT);
    let end = wire.arm.elapsed() + LONG;
    while !wire.arm.state().at_rest {
        assert!(wire.arm.elapsed() < end, "{request}");
        assert_eq!(wire.peek(), None, "the arm still moves");
        wire.arm.advance(Duration::from_millis(200));
    }
    // The document's reply has a blank before the name.
    assert_eq!(wire.recv(READ), r#"{"errorCode": "0", "errorMsg": "", "cmdName": " wait_complete"}"#);
    reply
}

/// The positions that the client takes from a reply to `get_data`, of which it needs six each.
fn positions(reply: &str) -> Option<([f64; 6], [f64; 6])> {
    let reply: Map<String, Value> = object(reply)?;
    Some((six(&reply, "joint_actual_position")?, six(&reply, "actual_position")?))
}

/// `RobotControlAndMachineVisionLaboratory/jaka_controller_tcp_ros`, `src/robot_client_tcp_test.cpp` and
/// `src/libs/robot_client_tcp.cpp`: power, enabling, an output, the speed rate, five motions, outputs of the third
/// kind, ten times `get_data`, and what the destructor sends.
#[test]
fn the_test_program_moves_the_arm() {
    let arm = arm(Firmware::default());
    let mut wire = Wire::connect(&arm);
    for request in [r#"{"cmdName":"power_on"}"#, r#"{"cmdName":"enable_robot"}"#] {
        blind(&mut wire, request);
    }
    assert!(arm.state().powered && arm.state().enabled);
    blind(&mut wire, r#"{"cmdName":"set_analog_output","type":0,"index":7,"value":1.000000}"#);
    blind(&mut wire, r#"{"cmdName":"rapid_rate","rate_value":0.600000}"#);
    assert!((arm.state().rapid_rate - 0.6).abs() < 1e-9);

    let turn = r#"{"cmdName":"joint_move","jointPosition":[0.000000,90.000000,0.000000,90.000000,-90.000000,45.000000],"speed":50.000000,"relFlag":0}"#;
    assert!(moved(&mut wire, turn).starts_with(r#"{"errorCode": "0", "#));
    assert!(are_close(arm.state().joint_position.0, [0.0, 90.0, 0.0, 90.0, -90.0, 45.0], 1e-6));
    let low = [-313.956, 116.25, 469.512, -157.792, 20.705, 49.107];
    let high = [-313.956, 116.25, 520.52, -157.792, 20.705, 49.107];
    assert_eq!(list(low), "-313.955994,116.250000,469.511993,-157.792007,20.705000,49.106998");
    for pose in [low, high, low, high] {
        let request = format!(r#"{{"cmdName":"end_move","endPosition":[{}],"speed":50.000000}}"#, list(pose));
        let reply = moved(&mut wire, &request);
        assert!(reply.starts_with(r#"{"errorCode": "0", "#), "{reply}");
    }

    for (index, value) in [(0, 256.0), (2, 255.0), (1, 0.0), (0, 2304.0)] {
        let mut request = format!(r#"{{"cmdName":"set_analog_output","type":2,"index":{index},"value":"#);
        write!(request, "{}}}", text(value)).expect("a text has room");
        blind(&mut wire, &request);
    }
    for _ in 0..10 {
        let (joints, pose) = positions(&wire.ask(GET_DATA, READ)).expect("the reply fits into the buffer");
        assert!(are_close(pose, high.map(f64::from), 0.01), "{pose:?}");
        assert!(are_close(joints, arm.state().joint_position.0, 1e-5), "{joints:?}");
        arm.advance(Duration::from_millis(200));
    }
    for request in [r#"{"cmdName":"disable_robot"}"#, r#"{"cmdName":"power_off"}"#] {
        blind(&mut wire, request);
    }
    assert!(!arm.state().powered && !arm.state().enabled);
}

/// `RobotControlAndMachineVisionLaboratory/jaka_controller_tcp_ros`, `src/libs/robot_client_tcp.cpp`: the client does
/// not look at the code of a reply, so that a motion that was refused has ended for it as soon as it asks.
#[test]
fn a_refused_motion_has_ended_for_it() {
    let arm = arm(Firmware::default());
    let mut wire = Wire::connect(&arm);
    let turn = r#"{"cmdName":"joint_move","jointPosition":[0.000000,0.000000,0.000000,0.000000,0.000000,45.000000],"speed":50.000000,"relFlag":0}"#;
    let before = arm.state().joint_position;
    assert_eq!(
        moved(&mut wire, turn),
        r#"{"errorCode": "2", "errorMsg": "call joint_move failed", "cmdName": "joint_move"}"#
    );
    assert_eq!((arm.state().joint_position, arm.elapsed()), (before, Duration::ZERO));
}

/// `RobotControlAndMachineVisionLaboratory/jaka_controller_tcp_ros`, `src/libs/robot_client_tcp.cpp`: jogs by an
/// increment select tool 0 first, whatever was selected, and send mode 2 whatever the caller says. The end is the reply
/// to `wait_complete`.
#[test]
fn a_jog_selects_the_flange_first() {
    let arm = arm(Firmware::default());
    arm.set_state(|state| (state.powered, state.enabled, state.tool_frame_id) = (true, true, 1));
    let before = arm.state().joint_position.0;
    let mut wire = Wire::connect(&arm);
    blind(&mut wire, r#"{"cmdName":"set_tool_id","tool_id":0}"#);
    assert_eq!(arm.state().tool_frame_id, 0);
    let jog = r#"{"cmdName":"jog","jog_mode":2,"coord_map":1,"jnum":5,"jogvel":20.000000,"poscmd":10.000000}"#;
    assert!(moved(&mut wire, jog).starts_with(r#"{"errorCode": "0", "#));
    let turned = arm.state().joint_position.0[5] - before[5];
    assert!((turned - 10.0).abs() < 1e-6, "{turned}");
    // It stops a jog in the same way.
    blind(&mut wire, r#"{"cmdName":"set_tool_id","tool_id":0}"#);
    let stop = blind(&mut wire, r#"{"cmdName":"jog","jog_mode":0,"coord_map":1,"jnum":5}"#);
    assert!(stop.starts_with(r#"{"errorCode": "0", "#), "{stop}");
}

/// `RobotControlAndMachineVisionLaboratory/jaka_controller_tcp_ros`, `src/libs/robot_client_tcp.cpp`: the reply to
/// `get_data` of newer firmware fills the client's buffer, so that its terminating zero goes behind it. What is left
/// comes before the next reply: the client asks again and again, and never has a pose.
#[test]
fn the_packet_of_newer_firmware_does_not_fit_into_its_buffer() {
    let arm = arm(Firmware::Newer);
    let mut wire = Wire::connect(&arm);
    let first = wire.ask(GET_DATA, READ);
    assert_eq!(first.len(), READ);
    assert!(first.starts_with(r#"{"errorCode": "0", "#) && positions(&first).is_none());
    let mut left = wire.arrived.len();
    assert!(left > 0);
    for _ in 0..20 {
        let reply = wire.ask(GET_DATA, READ);
        assert!(positions(&reply).is_none() && !reply.starts_with(r#"{"errorCode""#), "{reply:.80}");
        assert!(wire.arrived.len() > left, "what is left grows");
        left = wire.arrived.len();
        arm.advance(CYCLE);
    }
}
