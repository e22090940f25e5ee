//! Status packets.

use std::thread;
use std::time::Duration;

use crate::common::{Peer, fresh, json, simulated, stepped};
use jaka_proto::messages::status::RobotStatus;
use jaka_proto::wire::{Decode, Reader, Typed, Value};

/// The keys of the document's sample, in its order, and the lengths of its arrays.
const SAMPLE: [(&str, usize); 36] = [
    ("len", 0),
    ("drag_status", 0),
    ("extio", 0),
    ("errcode", 0),
    ("errmsg", 0),
    ("monitor_data", 6),
    ("torqsensor", 2),
    ("joint_actual_position", 6),
    ("actual_position", 6),
    ("din", 144),
    ("dout", 144),
    ("ain", 66),
    ("aout", 66),
    ("tio_din", 8),
    ("tio_dout", 8),
    ("tio_ain", 1),
    ("task_state", 0),
    ("homed", 9),
    ("task_mode", 0),
    ("interp_state", 0),
    ("enabled", 0),
    ("paused", 0),
    ("rapidrate", 0),
    ("current_tool_id", 0),
    ("current_user_id", 0),
    ("on_soft_limit", 0),
    ("emergency_stop", 0),
    ("drag_near_limit", 6),
    ("funcdi", 15),
    ("powered_on", 0),
    ("inpos", 0),
    ("motion_mode", 0),
    ("curr_tcp_trans_vel", 0),
    ("protective_stop", 0),
    ("point_key", 0),
    ("netState", 0),
];

fn typed(packet: &str) -> RobotStatus {
    RobotStatus::decode(&mut Reader::new(packet)).expect("the packet fits the spec")
}

#[test]
fn a_packet_looks_like_the_documents_sample() {
    let controller = fresh();
    let packet = Peer::status(&controller).receive();
    let mut reader = Reader::new(&packet);
    let mut keys = Vec::new();
    reader.begin_object().expect("the packet is an object");
    while let Some(key) = reader.next_key().expect("the packet is JSON") {
        let value = json(reader.raw().expect("the packet is JSON"));
        keys.push((key.into_owned(), value.as_array().map_or(0, Vec::len)));
    }
    assert_eq!(keys, SAMPLE.map(|(key, len)| (key.to_owned(), len)));
    assert_eq!(json(&packet)["len"], packet.len());
    let status = typed(&packet);
    assert!(matches!(status.extio, Some(Typed::Known(_))));
    assert!(matches!(status.monitor_data, Some(Typed::Known(_))));
    assert!(matches!(status.torque_sensor, Some(Typed::Known(_))));
    assert!(matches!(status.function_inputs, Some(Typed::Known(_))));
}

#[test]
fn a_packet_shows_the_state() {
    let controller = stepped();
    let mut commands = Peer::commands(&controller);
    let requests = [
        r#"{"cmdName":"set_digital_output","type":0,"index":143,"value":1}"#,
        r#"{"cmdName":"set_digital_output","type":1,"index":7,"value":1}"#,
        r#"{"cmdName":"set_analog_output","type":0,"index":7,"value":4.32}"#,
        r#"{"cmdName":"rapid_rate","rate_value":0.5}"#,
        r#"{"cmdName":"set_tool_id","tool_id":3}"#,
        r#"{"cmdName":"set_user_id","user_frame_id":4}"#,
        r#"{"cmdName":"torque_control_enable","enable_flag":1}"#,
        r#"{"cmdName":"play_program"}"#,
        r#"{"cmdName":"pause_program"}"#,
    ];
    for request in requests {
        assert_eq!(commands.ask(request)["errorCode"], "0", "{request}");
    }
    controller.set_state(|state| {
        state.joint_position = [6.0, 5.0, 4.0, 3.0, 2.0, 1.0].into();
        state.digital_inputs[1] = true;
        state.error_code = "0x10f0005".to_owned();
        state.error_message = "joint 1: \"limit\"".to_owned();
    });
    let packet = json(&Peer::status(&controller).receive());
    let expected = [
        ("joint_actual_position", "[6,5,4,3,2,1]"),
        ("rapidrate", "0.5"),
        ("current_tool_id", "3"),
        ("current_user_id", "4"),
        ("drag_status", "true"),
        ("task_mode", "4"),
        ("task_state", "4"),
        ("interp_state", "2"),
        ("paused", "true"),
        ("enabled", "true"),
        ("powered_on", "1"),
        ("protective_stop", "0"),
        ("errcode", "\"0x10f0005\""),
        ("errmsg", "\"joint 1: \\\"limit\\\"\""),
    ];
    for (key, value) in expected {
        assert_eq!(packet[key], json(value), "{key}");
    }
    let ones = |key: &str| packet[key].as_array().map(|pins| pins.iter().filter(|pin| **pin == 1).count());
    assert_eq!((ones("din"), ones("dout"), ones("tio_dout")), (Some(1), Some(1), Some(1)));
    assert_eq!((&packet["din"][1], &packet["dout"][143], &packet["tio_dout"][7]), (&on(), &on(), &on()));
    assert_eq!(packet["aout"][7], json("4.32"));

    // A protective stop ends the program.
    controller.collide();
    let packet = json(&Peer::status(&controller).receive());
    assert_eq!((&packet["protective_stop"], &packet["interp_state"]), (&on(), &json("0")));
}

fn on() -> Value {
    json("1")
}

#[test]
fn the_length_is_right_whatever_the_state() {
    let controller = fresh();
    let mut peer = Peer::status(&controller);
    for length in (0..9_000).step_by(450) {
        controller.set_state(|state| state.error_message = "\n".repeat(length));
        controller.publish();
    }
    peer.receive();
    for _ in (0..9_000).step_by(450) {
        let packet = peer.receive();
        assert_eq!(json(&packet)["len"], packet.len());
    }
}

#[test]
fn readers_share_what_is_published() {
    let controller = fresh();
    let mut readers = [Peer::status(&controller), Peer::status(&controller), Peer::status(&controller)];
    controller.set_state(|state| state.powered = true);
    controller.publish();
    controller.send_status(b"{\"odd\": 1}");
    controller.set_state(|state| state.powered = false);
    controller.publish();
    for reader in &mut readers {
        // The first packet is that of the connection, before or after the first change.
        reader.receive();
        assert_eq!(json(&reader.receive())["powered_on"], 1);
        assert_eq!(reader.receive(), "{\"odd\": 1}");
        assert_eq!(json(&reader.receive())["powered_on"], 0);
    }
}

#[test]
fn a_reader_who_does_not_read_is_dropped_and_delays_no_other() {
    // More than the kernel takes for a reader who does not read.
    const MUCH: usize = 64 << 20;
    let (clock, controller) = simulated();
    let mut slow = Peer::simulated_status(&controller);
    slow.receive();
    let mut reader = Peer::simulated_status(&controller);
    reader.receive();
    let place = clock.participant();
    thread::scope(|scope| {
        let sender = scope.spawn(|| place.run(|| controller.send_status(&vec![b' '; MUCH])));
        // The other one gets all of it while the first is waited for.
        assert_eq!(reader.receive_bytes(MUCH).len(), MUCH);
        assert_eq!(clock.elapsed(), Duration::ZERO);
        clock.outside(|| sender.join()).expect("nothing fails there");
    });
    assert_eq!(clock.elapsed(), Duration::from_secs(1));
    assert!(slow.read_to_end().len() < MUCH);
    controller.publish();
    assert_eq!(typed(&reader.receive()).powered_on, Some(false));
}
