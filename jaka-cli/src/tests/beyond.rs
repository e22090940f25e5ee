//! Each command beyond the document, as its bytes go over the wire.

use super::without_robot;

/// A line for `jaka call`, and the request as public clients send it.
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

#[test]
fn the_table_has_every_one_of_them() {
    let spec = jaka_spec::builtin().expect("the built-in spec is correct");
    for command in spec.commands().filter(|command| command.evidence.is_some()) {
        assert!(TABLE.iter().any(|(line, _)| line[0] == command.wire), "{}", command.wire);
    }
}
