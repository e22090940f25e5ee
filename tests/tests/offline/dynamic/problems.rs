//! Problems of requests, in words.

use expect_test::{Expect, expect};
use jaka_dynamic::AdvisoryRanges;
use serde_json::{Value, json};

use super::{SPEC, command, lines, object};

fn check_problems(wire: &str, fields: Value, expected: &Expect) {
    let problems = jaka_dynamic::request(&SPEC, command(wire), &object(fields), AdvisoryRanges::Enforced);
    expected.assert_eq(&lines(&problems.expect_err("the request has problems")));
}

#[test]
fn every_problem_is_reported_together() {
    check_problems(
        "joint_move",
        json!({}),
        &expect![[r"
            field `mode` is missing; allowed is 0 (Absolute) or 1 (Relative)
            field `joint_position` is missing; allowed is an array of 6, each a number (in deg)
            field `speed` is missing; allowed is a number, more than 0, at most 265 deg/s
        "]],
    );
    check_problems(
        "joint_move",
        json!({"mode": 2, "joint_position": [0, 1, "2", 3, null, 5], "sped": 20, "speed": -1, "accel": "fast"}),
        &expect![[r#"
            there is no field `sped`; did you mean `speed`?
            field `mode` is 2; allowed is 0 (Absolute) or 1 (Relative)
            field `joint_position[2]` is "2"; allowed is a number (in deg)
            field `joint_position[4]` is null; allowed is a number (in deg)
            field `speed` is -1; allowed is a number, more than 0, at most 265 deg/s
            field `acceleration` is "fast"; allowed is a number, more than 0, at most 720 deg/s²
        "#]],
    );
}

#[test]
fn a_field_may_be_given_once() {
    check_problems(
        "end_move",
        json!({"pose": [1, 2, 3, 4, 5], "endPosition": [1, 2, 3, 4, 5, 6], "speed": 1}),
        &expect![[r"
            field `pose` is given twice, also as [1,2,3,4,5]
        "]],
    );
}

#[test]
fn structs_as_arrays_and_as_objects_are_complete() {
    let fields = |pose: Value| json!({"pose": pose, "speed": 1});
    check_problems(
        "end_move",
        fields(json!([1, 2, 3, 4, 5, 6, 7])),
        &expect![[r"
        field `pose` is [1,2,3,4,5,6,7]; allowed is an array [x, y, z, rx, ry, rz]
    "]],
    );
    check_problems(
        "end_move",
        fields(json!({"x": 1, "y": 2, "z": 3, "rx": true, "ry": 5, "rotation": 6})),
        &expect![[r"
            there is no field `pose.rotation`; the fields are `x`, `y`, `z`, `rx`, `ry`, `rz`
            field `pose.rx` is true; allowed is a number (in deg)
            field `pose.rz` is missing; allowed is a number (in deg)
        "]],
    );
    check_problems(
        "end_move",
        fields(json!(12)),
        &expect![[r"
        field `pose` is 12; allowed is an array [x, y, z, rx, ry, rz]
    "]],
    );
}

#[test]
fn tags_and_their_fields_belong_together() {
    check_problems(
        "jog",
        json!({"coord_map": 0}),
        &expect![[r"
        field `jog_mode` is missing; allowed is 0 (Stop), 1 (Continuous), 2 (Increment) or 3 (Absolute)
    "]],
    );
    check_problems(
        "jog",
        json!({"jog_mode": "fly", "frame": 0}),
        &expect![[r#"
        field `jog_mode` is "fly"; allowed is 0 (Stop), 1 (Continuous), 2 (Increment) or 3 (Absolute)
    "#]],
    );
    check_problems(
        "jog",
        json!({"jog_mode": "stop", "frame": 7, "axis": 6, "velocity": 10}),
        &expect![[r"
            there is no field `velocity`; the fields are `frame`, `axis`
            field `frame` is 7; allowed is 0 (World), 1 (Joint) or 2 (Tool)
            field `axis` is 6; allowed is a whole number, 0 to 5
        "]],
    );
}

#[test]
fn text_may_be_limited_to_ascii() {
    check_problems(
        "load_program",
        json!({"program_name": "拧螺丝"}),
        &expect![[r#"
        field `program_name` is "拧螺丝"; allowed is text of printable ASCII
    "#]],
    );
    check_problems(
        "load_program",
        json!({"program_name": 5}),
        &expect![[r"
        field `program_name` is 5; allowed is text of printable ASCII
    "]],
    );
}

#[test]
fn whole_numbers_are_whole() {
    check_problems(
        "set_clsn_sensitivity",
        json!({"level": 2.5}),
        &expect![[r"
        field `level` is 2.5; allowed is a whole number, 0 to 5
    "]],
    );
    check_problems(
        "set_clsn_sensitivity",
        json!({"level": 9, "speed": 1}),
        &expect![[r"
            there is no field `speed`; the fields are `level`
            field `level` is 9; allowed is a whole number, 0 to 5; this is advisory
        "]],
    );
}

#[test]
fn what_newer_firmware_takes_can_be_let_through() {
    let fields = json!({"kind": "relay", "index": 0, "value": 1});
    check_problems(
        "set_digital_output",
        fields.clone(),
        &expect![[r#"
            field `kind` is "relay"; allowed is 0 (Cabinet), 1 (Tool) or 2 (Extension); this is advisory
        "#]],
    );
    let text = jaka_dynamic::request(&SPEC, command("set_digital_output"), &object(fields), AdvisoryRanges::Ignored);
    assert_eq!(text.as_deref(), Ok(r#"{"cmdName":"set_digital_output","type":3,"index":0,"value":1}"#));
}

#[test]
fn a_command_without_fields_has_none() {
    check_problems(
        "power_on",
        json!({"now": true}),
        &expect![[r"
        there is no field `now`; there are no fields
    "]],
    );
}
