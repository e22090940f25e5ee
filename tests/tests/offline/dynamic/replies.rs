//! Replies and status packets, held against the spec.

use expect_test::expect;
use jaka_dynamic::Node;
use jaka_tests::{Printed, printed};
use serde_json::{Value, json};

use super::{SPEC, command, lines, success};

#[test]
fn the_documents_replies_are_those_of_the_spec() {
    let replies = printed().into_iter().filter(|message| !message.is_request);
    let found: Vec<_> = replies.flat_map(|message| departures(&message)).collect();
    expect![[r#"
        4.41: lenient: `cmdName` is " wait_complete"; expected is `wait_complete`
        4.42: lenient: `cmdName` is " set_payload "; expected is `set_payload`
    "#]]
    .assert_eq(&lines(&found));
}

/// The departures of a reply that the document prints, each with its section.
fn departures(message: &Printed) -> Vec<String> {
    let section = Some(message.section.as_str());
    let command = SPEC.commands().find(|command| command.section.as_deref() == section).expect("a section of the spec");
    let reply = serde_json::from_str(&message.text).expect("the document prints JSON");
    let departures = Node::reply(&SPEC, command, reply).departures();
    departures.iter().map(|departure| format!("{}: {departure}", message.section)).collect()
}

/// The departures of replies, each with its command.
fn departures_of(replies: &[(&str, Value)]) -> String {
    let of = |(wire, reply): &(&str, Value)| {
        format!("{wire}:\n{}", lines(&Node::reply(&SPEC, command(wire), reply.clone()).departures()))
    };
    replies.iter().map(of).collect()
}

#[test]
fn refusals_are_held_against_the_envelope() {
    let replies = [
        ("get_joint_pos", json!({"errorCode": 2, "errorMsg": "call get_joint_pos failed"})),
        ("get_joint_pos", json!({"errorCode": "0x2", "cmdName": "get_tcp_pos", "errorMsg": ""})),
        ("get_joint_pos", json!({"errorCode": "none", "cmdName": 5, "errorMsg": []})),
        ("get_joint_pos", json!({"cmdName": " get_joint_pos ", "joint_pos": 1})),
        ("get_joint_pos", json!([])),
        ("get_extio_status", json!("(0, [], {'state': 0})")),
    ];
    expect![[r#"
        get_joint_pos:
        lenient: `errorCode` is 2; expected is text of decimal digits
        lenient: `cmdName` is missing; expected is `get_joint_pos`
        get_joint_pos:
        lenient: `errorCode` is "0x2"; expected is text of decimal digits
        unreadable: `cmdName` is "get_tcp_pos"; expected is `get_joint_pos`
        get_joint_pos:
        unreadable: `errorCode` is "none"; expected is text of decimal digits
        lenient: `errorMsg` is []; expected is text
        lenient: `cmdName` is 5; expected is `get_joint_pos`
        get_joint_pos:
        unreadable: `errorCode` is missing; expected is text of decimal digits
        lenient: `errorMsg` is missing; expected is text
        lenient: `cmdName` is " get_joint_pos "; expected is `get_joint_pos`
        get_joint_pos:
        unreadable: the message is []; expected is an object
        get_extio_status:
        lenient: the message is "(0, [], {'state': 0})"; expected is an object
    "#]]
    .assert_eq(&departures_of(&replies));
}

#[test]
fn keys_types_lengths_ranges_and_values_are_distinguished() {
    let extio =
        "(1, [{'setup': (0, 'io', (9600, 8), {'ai': (0, 0), 'do': (0,), 'ao': 5})}], {'state': 'True', 'di': (2, 2)})";
    let replies = [
        ("get_joint_pos", json!({"joint_pos": ["1", 2, 3, 4, 5, true, 7], "loads": [[0.5], [1]]})),
        ("get_joint_pos", json!({"joint_pos": null, "names": ["a"], "extra": [{}], "on": [true, 0]})),
        ("get_robot_state", json!({"enable": true, "power": "1"})),
        ("get_tio_vout_param", json!({"tio_vout_ena": 2, "tio_vout_vol": 0.0})),
        ("get_torsenosr_brand", json!({"sensor_brand": 9})),
        ("get_funcdi_status", json!({"funcdi_status": [[-1, -1, 0], [8, "2"], [0], 1]})),
        ("get_extio_status", json!({"extio_status": extio})),
        ("get_extio_status", json!({"extio_status": "(1, "})),
        ("get_admit_ctrl_config", json!({"admitConfig": [[0, 5.0, 0.0, 0.0, 0]]})),
    ]
    .map(|(wire, fields)| (wire, success(wire, fields)));
    expect![[r#"
        get_joint_pos:
        lenient: `loads` is not in the spec; it looks like `float[][]`: [[0.5],[1]]
        unreadable: `joint_pos` has another length; expected is an array of 6, each a number (in deg): ["1",2,3,4,5,true,7]
        lenient: `joint_pos[0]` is "1"; expected is a number (in deg)
        unreadable: `joint_pos[5]` is true; expected is a number (in deg)
        get_joint_pos:
        lenient: `extra` is not in the spec; it looks like `json[]`: [{}]
        lenient: `names` is not in the spec; it looks like `text[]`: ["a"]
        lenient: `on` is not in the spec; it looks like `json`: [true,0]
        unreadable: `joint_pos` is missing; expected is an array of 6, each a number (in deg)
        get_robot_state:
        lenient: `enable` is true; expected is "robot_disabled" or "robot_enabled"
        lenient: `power` is "1"; expected is "powered_off" or "powered_on"
        get_tio_vout_param:
        lenient: `tio_vout_ena` is 2; expected is a whole number, 0 to 1
        lenient: `tio_vout_vol` is 0.0; expected is a whole number, 0 to 1
        get_torsenosr_brand:
        lenient: `sensor_brand` is 9; the spec lists 1 (Sony), 2 (BoschSensortec) or 3 (StMicroelectronics)
        get_funcdi_status:
        lenient: `funcdi_status[0]` has another length; expected is an array [kind, index]: [-1,-1,0]
        lenient: `funcdi_status[1].kind` is 8; the spec lists -1 (Unassigned), 0 (Cabinet), 1 (Tool) or 2 (Modbus)
        lenient: `funcdi_status[1].index` is "2"; expected is a whole number
        unreadable: `funcdi_status[2].index` is missing; expected is a whole number
        unreadable: `funcdi_status[3]` is 1; expected is an array [kind, index]
        get_extio_status:
        lenient: `extio_status.modules[0].setup.connection.slave_id` is missing; expected is a whole number
        lenient: `extio_status.modules[0].setup.connection.data_bits` is missing; expected is a whole number
        lenient: `extio_status.modules[0].setup.connection.parity` is missing; expected is any JSON
        lenient: `extio_status.modules[0].setup.connection.stop_bit_length` is missing; expected is a whole number
        unreadable: `extio_status.modules[0].setup.pins.do.count` is missing; expected is a whole number
        unreadable: `extio_status.modules[0].setup.pins.ao` is 5; expected is an array [start, count]
        unreadable: `extio_status.modules[0].setup.pins.di` is missing; expected is an array [start, count]
        unreadable: `extio_status.modules[0].pinmap` is missing; expected is an object
        lenient: `extio_status.state.state` is "True"; expected is 0 or 1
        unreadable: `extio_status.state.di[0]` is 2; expected is 0 or 1 (and 1 more like it)
        get_extio_status:
        unreadable: `extio_status` is "(1, "; expected is text with a Python literal
        get_admit_ctrl_config:
        lenient: `admitConfig[0][0]` is 0; expected is an array [enabled, user_force, rebound, constant_force, normal_track] (and 4 more like it)
    "#]].assert_eq(&departures_of(&replies));
}

#[test]
fn status_packets_are_held_against_their_type() {
    let packet = json!({
        "len": "120", "joint_actual_position": [0, 1, 2, 3, 4, 5], "actual_position": [0, 1, 2, 3, 4, 5, 6],
        "din": [0, 1, "1", true, 2], "task_state": 7, "enabled": 1, "torqsensor": [0], "speed": 0.5,
        "extio": {"mode": 0}, "errcode": 0, "ain": ["0", "0.5", 1, "x"], "funcdi": [["0", 1], ["1", "2"]],
    });
    expect![[r#"
        lenient: `speed` is not in the spec; it looks like `float`: 0.5
        lenient: `len` is "120"; expected is a whole number (in bytes)
        lenient: `extio.status` is missing; expected is an array [digital_inputs, digital_outputs, analog_inputs, analog_outputs]
        lenient: `extio.setup` is missing; expected is an array, each an array that begins with 0 (Rtu) or 1 (Tcp)
        lenient: `extio.num` is missing; expected is a whole number
        lenient: `extio.pinmap` is missing; expected is an array, each an array [digital_inputs, digital_outputs, analog_inputs, analog_outputs]
        unreadable: `errcode` is 0; expected is text
        lenient: `torqsensor.settings` is 0; expected is an array that begins with 0 (Tcp) or 1 (Serial)
        lenient: `torqsensor.state` is missing; expected is an array [working, error_code, contact_force, raw_reading, unconditional_contact_force]
        unreadable: `actual_position` has another length; expected is an array [x, y, z, rx, ry, rz]: [0,1,2,3,4,5,6]
        lenient: `din[2]` is "1"; expected is 0 or 1 (and 1 more like it)
        unreadable: `din[4]` is 2; expected is 0 or 1
        lenient: `ain[0]` is "0"; expected is a number (and 1 more like it)
        unreadable: `ain[3]` is "x"; expected is a number
        lenient: `task_state` is 7; the spec lists 1 (PoweredOff), 2 (PoweredOn), 3 (Disabled) or 4 (Enabled)
        lenient: `enabled` is 1; expected is false or true
        lenient: `funcdi[0].kind` is "0"; expected is -1 (Unassigned), 0 (Cabinet), 1 (Tool) or 2 (Modbus) (and 1 more like it)
        lenient: `funcdi[1].index` is "2"; expected is a whole number
    "#]].assert_eq(&lines(&Node::status(&SPEC, packet).departures()));
    expect![[r"
        unreadable: the message is 1; expected is an object
    "]]
    .assert_eq(&lines(&Node::status(&SPEC, json!(1)).departures()));
}

#[test]
fn an_array_that_is_too_long_is_shown_whole() {
    let state = json!([1, 0, [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [1, 2, 3, 4, 5, 6]]);
    let packet = json!({"torqsensor": [[0, ["10.0.0.1", 5], [0.0, [0.0, 0.0, 0.0]], 7], state]});
    expect![[r#"
        lenient: `torqsensor.settings` has another length; expected is an array that begins with 0 (Tcp) or 1 (Serial): [0,["10.0.0.1",5],[0.0,[0.0,0.0,0.0]],7]
    "#]]
    .assert_eq(&lines(&Node::status(&SPEC, packet).departures()));
}
