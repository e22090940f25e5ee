//! Shapes of status packets.

use std::path::{Path, PathBuf};
use std::time::Duration;
use std::{fs, io};

use crate::common::{Peer, json};
use jaka_proto::messages::status::RobotStatus;
use jaka_proto::wire::{Decode, Reader, Typed};
use jaka_sim::{Builder, Controller, Delays, Firmware, State};

fn start(firmware: Firmware) -> Controller {
    at_rest().firmware(firmware).start().expect("loopback has ports")
}

/// A controller whose time stands still, so that packets come when they are asked for.
fn at_rest() -> Builder {
    Controller::builder().delays(Delays::NONE).stepped_clock()
}

fn typed(packet: &str) -> RobotStatus {
    RobotStatus::decode(&mut Reader::new(packet)).expect("the packet fits the spec")
}

#[test]
fn the_length_counts_the_blanks_and_what_a_message_has() {
    for firmware in Firmware::ALL {
        let controller = start(*firmware);
        let mut peer = Peer::status(&controller);
        peer.receive();
        for message in ["", "a, b: \"c\\", "关节, 1"] {
            controller.set_state(|state| state.error_message = message.to_owned());
            controller.publish();
            let packet = peer.receive();
            let blank = if *firmware == Firmware::Document { "" } else { " " };
            assert!(packet.starts_with(&format!("{{\"len\":{blank}{},", packet.len())), "{firmware}: {packet}");
            assert_eq!(typed(&packet).error_message.as_deref(), Some(message));
        }
    }
}

#[test]
fn packets_fit_the_spec_and_show_the_state() {
    for firmware in Firmware::ALL {
        let controller = start(*firmware);
        let mut commands = Peer::commands(&controller);
        for (kind, index) in [(0, 100), (3, 1), (4, 127), (5, 63), (6, 63)] {
            let fields = format!("\"type\":{kind},\"index\":{index},\"value\":1");
            commands.ask(&format!("{{\"cmdName\":\"set_digital_output\",{fields}}}"));
        }
        controller.set_state(|state| {
            state.powered = true;
            state.joint_position = [1.0, 2.0, 3.0, 4.0, 5.0, 6.5].into();
            if let Some(last) = state.digital_inputs.last_mut() {
                *last = true;
            }
        });
        let text = Peer::status(&controller).receive();
        let (status, state) = (typed(&text), controller.state());
        assert_eq!(status.length, i64::try_from(text.len()).ok());
        assert_eq!(status.joint_actual_position, Some(state.joint_position));
        assert_eq!((status.powered_on, &status.digital_inputs), (Some(true), &Some(state.digital_inputs.clone())));
        assert_eq!(status.digital_outputs.map(|pins| (pins[99], pins[100])), Some((false, true)));
        assert!(matches!(status.monitor_data, Some(Typed::Known(_))));
        assert!(matches!(status.torque_sensor, Some(Typed::Known(_))));
        let has_extio = matches!(firmware, Firmware::Newer | Firmware::Document);
        assert_eq!(matches!(status.extio, Some(Typed::Known(_))), has_extio);
        if *firmware == Firmware::Newer {
            assert_newer(&typed(&text), &state);
        }
    }
}

fn assert_newer(status: &RobotStatus, state: &State) {
    assert_eq!(status.joint_commanded_position, Some(state.joint_position));
    // Packets have five decimals.
    let pose = status.commanded_position.map(<[f64; 6]>::from).expect("newer packets have it");
    let near = pose.iter().zip(<[f64; 6]>::from(state.tcp_pose)).all(|(shown, is)| (shown - is).abs() <= 0.5e-5);
    assert!(near, "{pose:?} of {:?}", state.tcp_pose);
    let last = |pins: &Option<Typed<Vec<bool>>>| pins.as_ref().and_then(Typed::known)?.iter().position(|on| *on);
    assert_eq!(last(&status.relay_outputs), Some(1));
    assert_eq!(last(&status.modbus_slave_digital_outputs), Some(127));
    assert_eq!(last(&status.profinet_device_digital_outputs), Some(63));
    assert_eq!(last(&status.ethernet_ip_adapter_digital_outputs), Some(63));
}

#[test]
fn a_firmware_has_a_period_and_a_name() {
    let periods = Firmware::ALL.iter().map(|firmware| (firmware.to_string(), firmware.status_period().as_millis()));
    let expected = [("1.5.14", 30), ("newer", 50), ("document", 50)].map(|(name, ms)| (name.to_owned(), ms));
    assert_eq!(periods.collect::<Vec<_>>(), expected);
    for firmware in Firmware::ALL {
        assert_period(at_rest().firmware(*firmware), firmware.status_period());
    }
    let period = Duration::from_millis(16);
    assert_period(at_rest().firmware(Firmware::V1_5_14).status_period(period), period);
    assert_period(at_rest().status_period(period).firmware(Firmware::Newer), period);
}

/// Asserts that packets come in this period, and neither more nor fewer.
fn assert_period(options: Builder, period: Duration) {
    let controller = options.start().expect("loopback has ports");
    let mut peer = Peer::status(&controller);
    peer.receive();
    controller.advance(period * 4 + period / 2);
    controller.send_status(b"{}");
    for _ in 0..4 {
        assert!(typed(&peer.receive()).length.is_some());
    }
    assert_eq!(peer.receive(), "{}");
}

#[test]
fn inputs_that_are_asked_for_are_those_of_the_packet() {
    for firmware in Firmware::ALL {
        let controller = start(*firmware);
        let inputs = Peer::commands(&controller).call("get_digital_input_status")["din_status"].clone();
        let functions = Peer::commands(&controller).call("get_funcdi_status")["funcdi_status"].clone();
        let packet = json(&Peer::status(&controller).receive());
        assert_eq!(inputs, packet["din"]);
        assert_eq!(functions[12], packet["funcdi"][12]);
    }
}

#[test]
fn keys_of_status_packets_that_a_pack_adds_are_sent_and_can_be_set() {
    let text = "[[extend]]\ntarget = 'RobotStatus'\n[[extend.field]]\nwire = 'zz_fan'\ntype = 'float[2]'\noptional = true\ndoc = 'D.'\n";
    let builder = at_rest().pack(pack("status_keys", text)).status_period(Duration::MAX);
    let controller = builder.start().expect("the pack is correct");
    let mut reader = Peer::status(&controller);
    let packet = reader.receive();
    // After the keys of the firmware, with a value of its type.
    assert!(packet.ends_with("\"netState\": 1, \"zz_fan\": [0.0, 0.0]}"), "{packet}");
    let keys = [
        ("zz_fan".to_owned(), json("[1.5,2]")),
        ("rapidrate".to_owned(), json("\"1\"")),
        ("inpos".to_owned(), json("null")),
    ];
    controller.set_status(keys);
    controller.publish();
    let packet = reader.receive();
    for text in ["\"zz_fan\": [1.5, 2]}", "\"rapidrate\": \"1\", ", "\"inpos\": null, "] {
        assert!(packet.contains(text), "{text}: {packet}");
    }
    assert_eq!(json(&packet)["len"], packet.len());
}

/// A pack of this text.
fn pack(name: &str, text: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name).with_extension("toml");
    fs::write(&path, format!("title = 'T'\n{text}")).expect("the folder is there");
    path
}

#[test]
fn keys_units_words_and_shapes_that_a_pack_changes_are_followed() {
    let text = "[[override]]\ntarget = 'get_joint_pos'\nreply = 'joint_pos'\nwire = 'joints'\n\
                [[override]]\ntarget = 'rapid_rate'\nrequest = 'rate_value'\nwire = 'rate'\n\
                [[override]]\ntarget = 'get_payload'\nreply = 'mass'\nunit = 'g'\n\
                [[type]]\nname = 'Named'\nkind = 'object'\ndoc = 'D.'\n\
                [[type.field]]\nwire = 'x'\ntype = 'float'\nunit = 'mm'\ndoc = 'D.'\n\
                [[type.field]]\nwire = 'y'\ntype = 'float'\nunit = 'mm'\ndoc = 'D.'\n\
                [[type.field]]\nwire = 'z'\ntype = 'float'\nunit = 'mm'\ndoc = 'D.'\n\
                [[override]]\ntarget = 'get_payload'\nreply = 'centroid'\ntype = 'Named'\n\
                [[override]]\ntarget = 'set_payload'\nrequest = 'centroid'\ntype = 'Named'\n\
                [[override]]\ntarget = 'RobotStatus'\nfield = 'enabled'\nwire = 'drives'\nwritten = ['off', 'on']\n\
                [[override]]\ntarget = 'RobotStatus'\nfield = 'rapidrate'\nwire = 'rate'\n";
    let controller = at_rest().pack(pack("followed", text)).start().expect("the pack is correct");
    controller.set_state(|state| (state.powered, state.enabled) = (true, true));
    let mut peer = Peer::commands(&controller);
    assert_eq!(peer.ask("{\"cmdName\":\"rapid_rate\",\"rate\":0.5}")["errorCode"], *"0");
    assert!((controller.state().rapid_rate - 0.5).abs() < 1e-12);
    // The key of the built-in spec is that of no field any more.
    assert_ne!(peer.ask("{\"cmdName\":\"rapid_rate\",\"rate_value\":0.25}")["errorCode"], *"0");
    assert!((controller.state().rapid_rate - 0.5).abs() < 1e-12);
    let reply = peer.call("get_joint_pos");
    assert_eq!(reply["joints"].as_array().map(Vec::len), Some(6), "{reply}");
    assert_eq!(reply.get("joint_pos"), None, "{reply}");
    controller.set_state(|state| state.payload.mass = 2.5);
    assert_eq!(peer.call("get_payload")["mass"], json("2500.0"));
    let set = r#"{"cmdName":"set_payload","mass":2,"centroid":{"x":1,"y":2,"z":3}}"#;
    assert_eq!(peer.ask(set)["errorCode"], *"0");
    assert_eq!(peer.call("get_payload")["centroid"], json(r#"{"x":1.0,"y":2.0,"z":3.0}"#));
    let packet = Peer::status(&controller).receive();
    assert!(packet.contains("\"drives\": \"on\"") && packet.contains("\"rate\": 0.5"), "{packet}");
    assert!(!packet.contains("\"enabled\"") && !packet.contains("\"rapidrate\""), "{packet}");
}

/// The place of a key among the others does not follow from its name in Rust.
#[test]
fn a_field_that_a_pack_calls_otherwise_in_rust_is_sent_as_before() {
    let text = "[[override]]\ntarget = 'RobotStatus'\nfield = 'joint_actual_position'\nname = 'joints'\n\
                [robot_status]\njoint_actual_position = 'joints'\n";
    let packet = |builder: Builder| {
        let controller = builder.firmware(Firmware::Newer).start().expect("the pack is correct");
        Peer::status(&controller).receive()
    };
    assert_eq!(packet(at_rest().pack(pack("renamed", text))), packet(at_rest()));
}

#[test]
fn what_a_pack_types_otherwise_is_refused_by_name_since_the_state_has_no_value_for_it() {
    let reply = "[[override]]\ntarget = 'get_joint_pos'\nreply = 'joint_pos'\ntype = 'text'\n";
    let unit = "[[override]]\ntarget = 'get_payload'\nreply = 'mass'\nunit = 'lb'\n";
    let request = "[[override]]\ntarget = 'rapid_rate'\nrequest = 'rate_value'\ntype = 'text'\n";
    for (name, text, message, key) in [
        ("retyped", reply, "{\"cmdName\":\"get_joint_pos\"}", "`joint_pos`"),
        ("unit", unit, "{\"cmdName\":\"get_payload\"}", "`mass`"),
        ("request", request, "{\"cmdName\":\"rapid_rate\",\"rate_value\":\"slow\"}", "`rate_value`"),
    ] {
        let controller = at_rest().pack(pack(name, text)).start().expect("the pack is correct");
        let mut peer = Peer::commands(&controller);
        let reply = peer.ask(message);
        assert_ne!(reply["errorCode"], *"0", "{reply}");
        assert!(reply["errorMsg"].as_str().is_some_and(|text| text.contains(key)), "{reply}");
        assert!((controller.state().rapid_rate - 1.0).abs() < 1e-12);
        // All else is followed.
        assert_eq!(peer.call("get_version")["errorCode"], *"0");
    }
    let status = "[[override]]\ntarget = 'RobotStatus'\nfield = 'rapidrate'\ntype = 'text'\n";
    let error = at_rest().pack(pack("of_status", status)).start().expect_err("it cannot be followed");
    assert_eq!(error.kind(), io::ErrorKind::Unsupported);
    assert!(error.to_string().contains("`rapidrate`"), "{error}");
}

#[test]
fn a_value_that_a_pack_does_not_allow_in_a_reply_is_not_replaced_by_another() {
    let text = "[[override]]\ntarget = 'get_payload'\nreply = 'mass'\ntype = 'int'\n";
    let controller = at_rest().pack(pack("narrower", text)).start().expect("the pack is correct");
    let mut peer = Peer::commands(&controller);
    for (mass, code) in [("2", "0"), ("2.5", "2")] {
        peer.ask(&format!("{{\"cmdName\":\"set_payload\",\"mass\":{mass},\"centroid\":[0,0,0]}}"));
        let reply = peer.call("get_payload");
        assert_eq!(reply["errorCode"], *code, "{mass}: {reply}");
        assert_eq!(reply.get("mass").is_some(), code == "0", "{mass}: {reply}");
    }
}
