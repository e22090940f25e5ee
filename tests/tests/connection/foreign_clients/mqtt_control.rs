//! `nkawa/JAKA_Zu5s_MQTT_Control`, a Python client of a Zu 5s with firmware 1.5.14.
//!
//! The repository has transcripts of four runs, and one status packet. These are the tests of its packets.

use std::fmt::Write as _;
use std::net::TcpStream;

use jaka_proto::framing::Framer;
use jaka_sim::Firmware;
use jaka_tests::{Arm, LONG};
use serde_json::Value;

use super::{next_frame, object};

/// Keys of the recorded packet in their order, each with the shape of its value, where `[135 int]` is an array of 135
/// whole numbers, and the length of its text; and that text, where it is the recorded one. Python's `json.dumps` of the
/// record has 3208 bytes, as `len` says, so that these are the lengths on the wire.
const PACKET: &str = include_str!("packet.jsonl");

/// `nkawa/JAKA_Zu5s_MQTT_Control`, `src/check_jkrc_feedback.py`: keys, order, lengths, nesting, number formats and
/// blanks of its packet, of an arm in the same state.
///
/// Numbers that the simulator takes from elsewhere have other lengths: measurements, which it has the same for each
/// joint, the pose, which follows from a tool and a user frame that the record does not show, and functions with an
/// input, which are those of the document.
#[test]
fn the_packet_is_as_the_recorded_one() {
    let arm = feedback_arm();
    let mut stream = TcpStream::connect(arm.status_addr()).expect("the controller listens");
    stream.set_read_timeout(Some(LONG)).expect("a timeout can be set");
    let packet = next_frame(&mut stream, &mut Framer::default());
    let packet = String::from_utf8(packet).expect("the controller sends UTF-8");
    let values = object(&packet).expect("`json.loads` takes it");
    let recorded: Vec<Value> = PACKET.lines().map(|line| serde_json::from_str(line).expect("it is JSON")).collect();
    assert_eq!(values.len(), recorded.len(), "{packet}");
    let mut rest = packet.as_str();
    let mut differs = Vec::new();
    for (index, recorded) in recorded.iter().enumerate() {
        let key = recorded["key"].as_str().expect("it has a key");
        let begin = if index == 0 { "{" } else { ", " };
        rest = rest.strip_prefix(&format!("{begin}\"{key}\": ")).unwrap_or_else(|| panic!("`{key}` before {rest:.40}"));
        let text = spaced(&values[key], &mut rest);
        assert_eq!(shape(&values[key]), recorded["shape"], "{key}");
        if recorded["length"] != text.len() {
            differs.push(key);
        }
        assert_eq!(text, recorded["text"].as_str().unwrap_or(text), "{key}");
    }
    assert_eq!(rest, "}");
    assert_eq!(values["len"], packet.len());
    assert_eq!(differs, ["monitor_data", "actual_position"]);
}

/// `nkawa/JAKA_Zu5s_MQTT_Control`, `src/jaka_control/jkrc_feedback.py`: packets end for it where the next one begins
/// with `{"len":`, so that it is one packet behind, and shows nothing before the second. It ignores `len`.
#[test]
fn packets_are_found_by_the_beginning_of_the_next_one() {
    let arm = feedback_arm();
    let mut stream = TcpStream::connect(arm.status_addr()).expect("the controller listens");
    stream.set_read_timeout(Some(LONG)).expect("a timeout can be set");
    let (mut framer, mut buffer) = (Framer::default(), Vec::new());
    let mut shown = Vec::new();
    for first_joint in [-263.0, -264.5, -266.0] {
        arm.set_state(|state| state.joint_position.0[0] = first_joint);
        arm.wait_until_accepted();
        arm.publish();
        // The packet that a reader gets on connecting comes before.
        loop {
            let packet = next_frame(&mut stream, &mut framer);
            buffer.extend_from_slice(&packet);
            let text = String::from_utf8_lossy(&packet);
            let values = object(&text).expect("it is JSON");
            if values["joint_actual_position"][0] == first_joint {
                break;
            }
        }
        // The client cuts off what comes before the second beginning.
        let mut text = String::from_utf8(std::mem::take(&mut buffer)).expect("the controller sends UTF-8");
        while let Some(end) = text[1..].find(r#"{"len":"#).map(|end| end + 1) {
            let unit = object(&text[..end]).expect("`json.loads` takes it");
            shown.push(unit["joint_actual_position"][0].as_f64().expect("it is a number"));
            text.drain(..end);
        }
        buffer = text.into_bytes();
        assert!(!shown.contains(&first_joint), "{shown:?}");
    }
    shown.dedup();
    assert!(shown.ends_with(&[-263.0, -264.5]), "{shown:?}");
}

/// An arm in the state of the recorded packet.
fn feedback_arm() -> Arm {
    let at = [-263.40236, 106.90883, 75.54514, 89.82753, -93.42602, -13.40708];
    let arm = Arm::stepped().without_power().no_packets().at(at);
    let arm = arm.controller(|controller| controller.firmware(Firmware::V1_5_14)).start();
    arm.set_state(|state| {
        state.user_frame_id = 1;
        state.torque_sensor.address = "192.168.2.100".into();
        state.torque_sensor.port = 8080;
        state.torque_sensor.payload.mass = 0.449;
        state.torque_sensor.payload.centroid = [0.0, 0.0, 20.0].into();
    });
    arm
}

/// The text of a value at the beginning of a message, with one blank behind each comma and colon.
fn spaced<'m>(value: &Value, rest: &mut &'m str) -> &'m str {
    let mut dumped = String::new();
    let mut in_text = false;
    for c in value.to_string().chars() {
        in_text ^= c == '"';
        dumped.push(c);
        if !in_text && matches!(c, ',' | ':') {
            dumped.push(' ');
        }
    }
    let (text, after) = rest.split_at_checked(dumped.len()).unwrap_or((rest, ""));
    assert_eq!(text, dumped);
    *rest = after;
    text
}

/// The shape of a value: scalars by their kind, where elements that follow one another alike are counted.
fn shape(value: &Value) -> String {
    let Value::Array(elements) = value else {
        return match value {
            Value::Bool(_) => "bool",
            Value::Number(number) if number.is_f64() => "float",
            Value::Number(_) => "int",
            Value::String(_) => "text",
            _ => panic!("no packet of this firmware has {value}"),
        }
        .to_owned();
    };
    let mut text = String::new();
    let shapes: Vec<_> = elements.iter().map(shape).collect();
    for run in shapes.chunk_by(|a, b| a == b) {
        let begin = if text.is_empty() { "" } else { ", " };
        let count = if run.len() == 1 { String::new() } else { format!("{} ", run.len()) };
        write!(text, "{begin}{count}{}", run[0]).expect("a text has room");
    }
    format!("[{text}]")
}
