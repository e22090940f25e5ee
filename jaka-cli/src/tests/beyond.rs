//! Bytes of commands on the wire: those of each example of the spec, and those sent by public clients.

use jaka_dynamic::arguments;
use jaka_spec::{Command, Spec};
use jaka_tests::{compact, same, spec};
use serde_json::Value;

use super::without_robot;
use crate::commands::call;

/// Lines for `jaka call`, and the requests as sent by public clients.
///
/// Written by hand, apart from the spec, to find a key that is wrong in the spec and in its example. A new command
/// needs no row.
const TABLE: &[(&[&str], &str)] = &[
    (&["get_data"], r#"{"cmdName":"get_data"}"#),
    (&["get_motion_state"], r#"{"cmdName":"get_motion_state"}"#),
    (&["emergency_stop_status"], r#"{"cmdName":"emergency_stop_status"}"#),
    (&["get_drag_status"], r#"{"cmdName":"get_drag_status"}"#),
    (&["get_rapid_rate"], r#"{"cmdName":"get_rapid_rate"}"#),
    (&["get_curr_tool_id"], r#"{"cmdName":"get_curr_tool_id"}"#),
    (&["get_curr_user_id"], r#"{"cmdName":"get_curr_user_id"}"#),
    (&["get_actual_tcp_pos"], r#"{"cmdName":"get_actual_tcp_pos"}"#),
    (&["get_actual_joint_pos"], r#"{"cmdName":"get_actual_joint_pos"}"#),
    (
        &["get_digital_output", "--kind", "cabinet", "--index", "1"],
        r#"{"cmdName":"get_digital_output","type":0,"index":1}"#,
    ),
    (&["get_digital_input", "--kind", "0", "--index", "1"], r#"{"cmdName":"get_digital_input","type":0,"index":1}"#),
    (
        &["get_analog_output", "--kind", "cabinet", "--index", "1"],
        r#"{"cmdName":"get_analog_output","type":0,"index":1}"#,
    ),
    (
        &["send_tio_rs_command", "--channel", "1", "--bytes", "1,3,0,0,0,1"],
        r#"{"cmdName":"send_tio_rs_command","chn_id":1,"cmdBuf":[1,3,0,0,0,1]}"#,
    ),
    (&["get_tio_pin_mode", "--pin-type", "0"], r#"{"cmdName":"get_tio_pin_mode","pinType":0}"#),
    (
        &["set_tio_pin_mode", "--pin-type", "0", "--pin-mode", "1"],
        r#"{"cmdName":"set_tio_pin_mode","pinType":0,"pinMode":1}"#,
    ),
    (&["get_rs485_chn_mode", "--channel", "1"], r#"{"cmdName":"get_rs485_chn_mode","chnId":1}"#),
    (
        &["set_rs485_chn_mode", "--channel", "1", "--mode", "0"],
        r#"{"cmdName":"set_rs485_chn_mode","chnId":1,"chnMode":0}"#,
    ),
    (&["get_rs485_chn_comm", "--channel", "1"], r#"{"cmdName":"get_rs485_chn_comm","chn_id":1}"#),
    (
        &[
            "set_rs485_chn_comm",
            "--channel",
            "1",
            "--slave-id",
            "2",
            "--baud-rate",
            "115200",
            "--data-bits",
            "8",
            "--stop-bits",
            "1",
            "--parity",
            "even",
        ],
        r#"{"cmdName":"set_rs485_chn_comm","chn_id":1,"slaveId":2,"baudrate":115200,"databit":8,"stopbit":1,"parity":69}"#,
    ),
    (&["get_rs485_signal_list"], r#"{"cmdName":"get_rs485_signal_list"}"#),
    (&["get_tio_signals"], r#"{"cmdName":"get_tio_signals"}"#),
    (
        &[
            "add_tio_rs_signal",
            "--name",
            "force",
            "--channel",
            "1",
            "--signal-type",
            "0",
            "--address",
            "1",
            "--frequency",
            "10",
        ],
        r#"{"cmdName":"add_tio_rs_signal","tio_signal_name":"force","tio_signal_chnId":1,"tio_signal_sigType":0,"tio_signal_sigAddr":1,"frequency":10}"#,
    ),
    (&["del_tio_rs_signal", "--name", "force"], r#"{"cmdName":"del_tio_rs_signal","tio_signal_name":"force"}"#),
    (
        &["torque_feedforward", "--currents", "0,0,0,0,0,0", "--mode", "controller"],
        r#"{"cmdName":"torque_feedforward","grvCurrent":[0,0,0,0,0,0],"includeGrvFlag":0}"#,
    ),
    (&["set_motion_planner", "--planner", "s"], r#"{"cmdName":"set_motion_planner","type":1}"#),
    (
        &["set_motion_limit_warning_range", "--level", "3"],
        r#"{"cmdName":"set_motion_limit_warning_range","range_level":3}"#,
    ),
    (&["get_motion_limit_warning_range"], r#"{"cmdName":"get_motion_limit_warning_range"}"#),
    (
        &["set_installation_angle", "--angle-x", "0", "--angle-z", "0"],
        r#"{"cmdName":"set_installation_angle","angleX":0,"angleZ":0}"#,
    ),
    (&["set_port10000_delay_ms", "--delay", "50"], r#"{"cmdName":"set_port10000_delay_ms","port10000_delay_ms":50}"#),
    (&["get_port10000_delay_ms"], r#"{"cmdName":"get_port10000_delay_ms"}"#),
    (
        &["setOptionalInfoConfig", "--section", "ATTROPTIONALDATA", "--entry", "joint_actual_position", "--value", "1"],
        r#"{"cmdName":"setOptionalInfoConfig","section":"ATTROPTIONALDATA","key":"joint_actual_position","value":1}"#,
    ),
    (
        &["setOptionalInfoConfig", "--section", "PORTCONFIG", "--entry", "port10000_delay_ms", "--value", "\"50\""],
        r#"{"cmdName":"setOptionalInfoConfig","section":"PORTCONFIG","key":"port10000_delay_ms","value":"50"}"#,
    ),
    (
        &["getOptionalInfoConfig", "--section", "PORTCONFIG", "--entry", "port10000_delay_ms"],
        r#"{"cmdName":"getOptionalInfoConfig","section":"PORTCONFIG","key":"port10000_delay_ms"}"#,
    ),
];

#[test]
fn the_bytes_are_those_that_clients_send() {
    for (line, request) in TABLE {
        let run = without_robot([&["call"], *line, &["--dry-run"]].concat());
        assert_eq!((&*run.out, run.code), (&*format!("{request}\n"), 0), "{line:?}: {}", run.err);
    }
}

/// Returns the line for `jaka call` with the fields of a request, each by its option in the help.
fn line(spec: &Spec, command: &Command, described: &clap::Command, request: &Value) -> Vec<String> {
    let mut line = vec!["call".to_owned(), command.wire.clone(), "--dry-run".to_owned()];
    let arguments = arguments(spec, command);
    // The tag of a request with variants comes first.
    let variant = arguments.first().and_then(|tag| {
        let listed = tag.values.iter().find(|listed| request.get(&tag.wire) == Some(&listed.wire));
        listed.map(|listed| listed.name.clone())
    });
    let is_in_variant =
        |variants: &[String]| variants.is_empty() || variant.as_ref().is_some_and(|name| variants.contains(name));
    for argument in arguments.iter().filter(|argument| is_in_variant(&argument.variants)) {
        let Some(value) = request.get(&argument.wire) else { continue };
        let json = value.to_string();
        let texts = [value.as_str().unwrap_or(&json), &json];
        let Some(text) = texts.iter().find(|text| argument.value(spec, text).is_ok_and(|read| same(&read, value)))
        else {
            continue;
        };
        let id = format!("field {}", argument.name);
        let option = described.get_arguments().find(|arg| *arg.get_id() == id).and_then(clap::Arg::get_long);
        line.push(format!("--{}={text}", option.expect("each field has an option")));
    }
    line
}

#[test]
fn each_request_of_the_spec_can_be_given_by_options() {
    let spec = spec();
    let all = call::all(&spec);
    let mut count = 0;
    for command in spec.commands() {
        let described = all.find_subcommand(&command.wire).expect("each is described");
        for example in command.examples.iter().filter_map(|example| example.request.as_deref()) {
            let request: Value = serde_json::from_str(example).expect("examples are JSON");
            let line = line(&spec, command, described, &request);
            let run = without_robot(&line);
            assert_eq!(run.out.trim_end(), compact(example), "{line:?}: {}", run.err);
            count += 1;
        }
    }
    assert!(count >= spec.commands().count(), "{count}");
}
