//! The vendor's client library, SDK 1.0.19 and 2.1.14: commands and keys that it sent to a recording server, and keys
//! of replies that it reads.
//!
//! The names of keys are evidence. Blanks, the order of members and the values here are ours. The library is not part
//! of this repository.

use std::time::Duration;

use jaka_sim::Firmware;
use jaka_tests::{Arm, ArmBuilder, CYCLE, LONG};
use serde_json::{Map, Value};

use super::{Wire, are_close, object, six};

/// More than any reply has.
const READ: usize = 65536;

/// Time for which the simulator has an event of information in the error code.
const INFORMATION: Duration = Duration::from_millis(256);

const GET_DATA: &str = r#"{"cmdName":"get_data"}"#;

/// Queries of SDK 2.1.14 with the keys that it reads in their replies.
const QUERIES: &[(&str, &[&str])] = &[
    (r#"{"cmdName":"is_on_limit"}"#, &["on_limit"]),
    // For its own index 1, which counts from 0.
    (r#"{"cmdName":"get_analog_input","type":0,"index":2}"#, &["value"]),
    (r#"{"cmdName":"get_rapid_rate"}"#, &["value"]),
    (r#"{"cmdName":"get_drag_status"}"#, &["status"]),
    (r#"{"cmdName":"get_tio_pin_mode","pinType":0}"#, &["pinMode"]),
    (r#"{"cmdName":"get_rs485_chn_comm","chn_id":1}"#, &["slaveId", "baudrate", "databit", "stopbit", "parity"]),
    (
        r#"{"cmdName":"get_motion_state"}"#,
        &["motion_line", "inpos", "err_add_line", "queue", "active_queue", "queue_full"],
    ),
    (r#"{"cmdName":"emergency_stop_status"}"#, &["emergency_stop"]),
];

/// Commands of SDK 2.1.14 in whose replies no key is known that it reads.
const COMMANDS: &[&str] = &[
    r#"{"cmdName":"get_installation_angle"}"#,
    r#"{"cmdName":"set_torque_sensor_filter","torqueSensorFilter":10.0}"#,
    r#"{"cmdName":"set_ft_ctrl_frame","ftFrame":1}"#,
    r#"{"cmdName":"zero_end_sensor"}"#,
];

/// Motions of SDK 2.1.14 with the keys that the document does not have.
const MOTIONS: &[&str] = &[
    r#"{"cmdName":"joint_move","relFlag":1,"jointPosition":[5.0,0.0,0.0,0.0,0.0,0.0],"speed":50.0,"accel":200.0,"tol":0.0,"executing_line_id":7}"#,
    r#"{"cmdName":"moveL","relFlag":1,"cartPosition":[0.0,0.0,10.0,0.0,0.0,0.0],"speed":50.0,"accel":200.0,"tol":0.0,"ori_vel":90.0,"ori_acc":360.0}"#,
    r#"{"cmdName":"movc","relFlag":1,"pos_mid":[5.0,5.0,0.0,0.0,0.0,0.0],"pos_end":[10.0,0.0,0.0,0.0,0.0,0.0],"speed":50.0,"accel":200.0,"tol":0.0,"circle_cnt":0,"circle_mode":0}"#,
];

fn arm(firmware: Firmware) -> ArmBuilder {
    Arm::stepped().no_packets().controller(|controller| controller.firmware(firmware))
}

/// The reply to a request that is carried out.
#[track_caller]
fn accepted(wire: &mut Wire<'_>, request: &str) -> Map<String, Value> {
    let name = object(request).expect("it is JSON")["cmdName"].clone();
    let reply = object(&wire.ask(request, READ)).expect("it is JSON");
    assert_eq!((&reply["errorCode"], &reply["cmdName"]), (&"0".into(), &name), "{request}: {reply:?}");
    reply
}

/// SDK 2.1.14, bytes at a recording server: commands that it sends and keys that it reads, found by offering one key at
/// a time.
#[test]
fn newer_firmware_has_the_keys_that_sdk_2_1_14_reads() {
    let arm = arm(Firmware::Newer).start();
    let mut wire = Wire::connect(&arm);
    for (request, keys) in QUERIES {
        let reply = accepted(&mut wire, request);
        for key in *keys {
            let is_read = reply.get(*key).is_some_and(|value| value.is_number() || value.is_boolean());
            assert!(is_read, "{key} of {reply:?}");
        }
    }
    for request in COMMANDS {
        accepted(&mut wire, request);
    }
}

/// SDK 2.1.14, the same: three kinds of motion, and what `get_motion_state` says while they run.
#[test]
fn newer_firmware_takes_the_motions_of_sdk_2_1_14() {
    let arm = arm(Firmware::Newer).start();
    let mut wire = Wire::connect(&arm);
    for request in MOTIONS {
        let before = arm.state().joint_position.0;
        accepted(&mut wire, request);
        arm.advance(CYCLE);
        let motion = accepted(&mut wire, r#"{"cmdName":"get_motion_state"}"#);
        assert_eq!((&motion["inpos"], &motion["queue_full"]), (&false.into(), &false.into()), "{motion:?}");
        arm.advance(LONG);
        let motion = accepted(&mut wire, r#"{"cmdName":"get_motion_state"}"#);
        assert_eq!((&motion["inpos"], &motion["err_add_line"]), (&true.into(), &0.into()), "{motion:?}");
        assert!(!are_close(arm.state().joint_position.0, before, 0.1), "{request}");
    }
}

/// A poll of a blocking move of SDK 1.0.19.
#[derive(Debug, PartialEq)]
struct Poll {
    since_start: Duration,
    error_code: String,
    in_position: bool,
}

/// Sends a move, and asks by `get_data` with each period of packets until the arm is in position, whatever the code is.
///
/// The library takes each code but `"0x0"` for a failure of the move.
fn blocking_move(wire: &mut Wire<'_>, request: &str) -> Vec<Poll> {
    let period = Firmware::default().status_period();
    accepted(wire, request);
    let start = wire.arm.elapsed();
    let mut polls = Vec::new();
    loop {
        let reply = accepted(wire, GET_DATA);
        let error_code = reply["errcode"].as_str().expect("the code is a text").to_owned();
        let in_position = reply["inpos"].as_bool().expect("it is a truth value");
        let since_start = wire.arm.elapsed().saturating_sub(start);
        polls.push(Poll { since_start, error_code, in_position });
        if in_position {
            return polls;
        }
        assert!(since_start < LONG, "the arm does not arrive");
        wire.arm.advance(period);
    }
}

const MOVE: &str = r#"{"cmdName":"joint_move","relFlag":0,"jointPosition":[10.0,90.0,90.0,90.0,-90.0,0.0],"speed":20.0,"accel":200.0}"#;
const START: [f64; 6] = [0.0, 90.0, 90.0, 90.0, -90.0, 0.0];

/// SDK 1.0.19, a blocking move of an arm that was enabled before: no poll has another code than `"0x0"`, so that it
/// succeeds.
#[test]
fn a_blocking_move_of_sdk_1_0_19_succeeds() {
    let arm = arm(Firmware::default()).at(START).start();
    arm.advance(Duration::from_secs(1));
    let mut wire = Wire::connect(&arm);
    let polls = blocking_move(&mut wire, MOVE);
    assert!(polls.len() > 2 && polls.iter().all(|poll| poll.error_code == "0x0"), "{polls:?}");
    let reply = accepted(&mut wire, GET_DATA);
    let joints = six(&reply, "joint_actual_position").expect("it has the key");
    assert!(are_close(joints, [10.0, 90.0, 90.0, 90.0, -90.0, 0.0], 1e-4), "{joints:?}");
}

/// SDK 1.0.19, a blocking move in the moment in which the arm is enabled: the event of enabling stands in the error
/// code, so that the library takes the move for a failure. That it stands for 256 ms is the simulator's opinion: in
/// captures it stands in one or a few packets. Later polls have no other code than `"0x0"`, and neither has the last
/// one.
#[test]
fn a_blocking_move_of_sdk_1_0_19_fails_as_long_as_enabling_stands_in_the_error_code() {
    let arm = arm(Firmware::default()).without_power().at(START).start();
    let mut wire = Wire::connect(&arm);
    accepted(&mut wire, r#"{"cmdName":"power_on"}"#);
    accepted(&mut wire, r#"{"cmdName":"enable_robot"}"#);
    let polls = blocking_move(&mut wire, MOVE);
    let (early, late): (Vec<_>, Vec<_>) = polls.iter().partition(|poll| poll.since_start < INFORMATION);
    assert!(early.iter().all(|poll| poll.error_code == "0x10f0004"), "{early:?}");
    assert!(late.len() > 2 && late.iter().all(|poll| poll.error_code == "0x0"), "{late:?}");
    assert!(late.last().is_some_and(|poll| poll.in_position), "{late:?}");

    // The event belongs to enabling: a further move has none.
    let polls = blocking_move(&mut wire, &MOVE.replace("[10.0,", "[0.0,"));
    assert!(polls.len() > 2 && polls.iter().all(|poll| poll.error_code == "0x0"), "{polls:?}");
}
