//! The vendor's client library, SDK 1.0.19: its blocking moves.
//!
//! The names of keys are evidence. Blanks, the order of members and the values here are ours. The library is not part
//! of this repository.

use std::time::Duration;

use jaka_sim::Firmware;
use jaka_tests::{Arm, ArmBuilder, LONG};
use serde_json::{Map, Value};

use super::{Wire, are_close, object, six};

/// More than any reply has.
const READ: usize = 65536;

/// Time for which the simulator has an event of information in the error code.
const INFORMATION: Duration = Duration::from_millis(256);

const GET_DATA: &str = r#"{"cmdName":"get_data"}"#;

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
