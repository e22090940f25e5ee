//! Shapes of status packets.

use std::time::Duration;

use crate::common::{Peer, json};
use jaka_proto::messages::status::RobotStatus;
use jaka_proto::wire::{Decode, Reader, Typed, Value};
use jaka_sim::{Builder, Controller, Delays, Firmware, State};
use jaka_spec::Spec;

/// The last key of the document's sample.
const LAST_OF_DOCUMENT: &str = "netState";

fn start(firmware: Firmware) -> Controller {
    at_rest().firmware(firmware).start().expect("loopback has ports")
}

/// A controller whose time stands still, so that packets come when they are asked for.
fn at_rest() -> Builder {
    Controller::builder().delays(Delays::NONE).stepped_clock()
}

fn spec() -> Spec {
    jaka_spec::builtin().expect("the spec is correct")
}

/// The keys of the spec's packet, in its order.
fn packet_keys(spec: &Spec) -> Vec<String> {
    spec.status_fields().iter().map(|field| field.wire.clone()).collect()
}

fn keys(text: &str) -> Vec<String> {
    let mut reader = Reader::new(text);
    let mut keys = Vec::new();
    reader.begin_object().expect("the text is an object");
    while let Some(key) = reader.next_key().expect("the text is JSON") {
        keys.push(key.into_owned());
        reader.skip().expect("the text is JSON");
    }
    keys
}

fn typed(packet: &str) -> RobotStatus {
    RobotStatus::decode(&mut Reader::new(packet)).expect("the packet fits the spec")
}

/// Lengths of arrays in a packet.
fn lengths(packet: &Value, keys: &[&str]) -> Vec<usize> {
    keys.iter().map(|key| packet[key].as_array().map_or(0, Vec::len)).collect()
}

#[test]
fn packets_have_the_keys_of_their_firmware() {
    let all = packet_keys(&spec());
    let document = all.iter().position(|key| key == LAST_OF_DOCUMENT).map(|last| all[..=last].to_vec());
    let document = document.expect("the spec has the document's keys");
    let old: Vec<_> = document.iter().filter(|key| *key != "extio").cloned().collect();
    for (firmware, expected) in [(Firmware::V1_5_14, old), (Firmware::Document, document), (Firmware::Newer, all)] {
        let packet = Peer::status(&start(firmware)).receive();
        assert_eq!(keys(&packet), expected, "{firmware}");
    }
}

#[test]
fn packets_have_the_lengths_of_their_firmware() {
    let common = ["din", "dout", "ain", "aout", "tio_din", "tio_dout", "tio_ain", "homed", "drag_near_limit", "funcdi"];
    let expected = [
        (Firmware::V1_5_14, [136, 136, 64, 64, 8, 8, 1, 9, 6, 13], 10),
        (Firmware::Document, [144, 144, 66, 66, 8, 8, 1, 9, 6, 15], 10),
        (Firmware::Newer, [200, 200, 128, 128, 8, 8, 2, 9, 6, 15], 11),
    ];
    for (firmware, counts, row) in expected {
        let packet = json(&Peer::status(&start(firmware)).receive());
        assert_eq!(lengths(&packet, &common), counts, "{firmware}");
        let rows = packet["monitor_data"][5].as_array().expect("the joints have rows");
        assert_eq!(rows.iter().map(|row| row.as_array().map_or(0, Vec::len)).collect::<Vec<_>>(), [row; 6]);
    }
}

#[test]
fn newer_packets_have_fieldbuses_and_what_is_at_the_tool() {
    let packet = json(&Peer::status(&start(Firmware::Newer)).receive());
    let bus = |bus: &str| {
        let pins = ["din", "dout", "ain", "aout"].map(|pins| format!("{bus}_{pins}"));
        lengths(&packet, &pins.each_ref().map(String::as_str))
    };
    assert_eq!(bus("mb_slave"), [128, 128, 64, 64]);
    assert_eq!(bus("pn_dev"), [64, 64, 64, 64]);
    assert_eq!(bus("eip_adpt"), [64, 64, 48, 48]);
    let tool = ["tio_key", "instVel", "relay_io", "tio_rs_signals", "joint_position", "position"];
    assert_eq!(lengths(&packet, &tool), [3, 6, 2, 8, 6, 6]);
}

#[test]
fn packets_have_the_size_and_the_blanks_of_their_firmware() {
    let expected = [
        (Firmware::V1_5_14, 1_500..3_600, "{\"len\": "),
        (Firmware::Document, 1_500..5_000, "{\"len\":"),
        (Firmware::Newer, 5_001..15_000, "{\"len\": "),
    ];
    for (firmware, sizes, head) in expected {
        let controller = start(firmware);
        let mut peer = Peer::status(&controller);
        peer.receive();
        for message in ["", "a, b: \"c\\", "关节, 1"] {
            controller.set_state(|state| state.error_message = message.to_owned());
            controller.publish();
            let packet = peer.receive();
            assert!(sizes.contains(&packet.len()), "{firmware}: {}", packet.len());
            assert!(packet.starts_with(&format!("{head}{},", packet.len())), "{firmware}: {packet}");
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
        assert_eq!(matches!(status.extio, Some(Typed::Known(_))), *firmware != Firmware::V1_5_14);
        if *firmware == Firmware::Newer {
            assert_newer(&typed(&text), &state);
        }
    }
}

fn assert_newer(status: &RobotStatus, state: &State) {
    assert_eq!(status.joint_commanded_position, Some(state.joint_position));
    assert_eq!(status.commanded_position, Some(state.tcp_pose));
    let last = |pins: &Option<Typed<Vec<bool>>>| pins.as_ref().and_then(Typed::known)?.iter().position(|on| *on);
    assert_eq!(last(&status.relay_outputs), Some(1));
    assert_eq!(last(&status.modbus_slave_digital_outputs), Some(127));
    assert_eq!(last(&status.profinet_device_digital_outputs), Some(63));
    assert_eq!(last(&status.ethernet_ip_adapter_digital_outputs), Some(63));
}

#[test]
fn a_firmware_has_a_period_and_a_name() {
    let periods = Firmware::ALL.iter().map(|firmware| (firmware.to_string(), firmware.status_period().as_millis()));
    let expected = [("1.5.14", 30), ("document", 50), ("newer", 50)].map(|(name, ms)| (name.to_owned(), ms));
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
