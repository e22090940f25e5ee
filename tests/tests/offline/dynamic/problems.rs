//! Problems of requests, in words.

use expect_test::expect;
use jaka_dynamic::AdvisoryRanges;
use serde_json::json;

use super::{SPEC, command, lines, object};

#[test]
fn every_problem_is_reported_together() {
    let told = [
        ("joint_move", json!({})),
        (
            "joint_move",
            json!({"mode": 2, "joint_position": [0, 1, "2", 3, null, 5], "sped": 20, "speed": -1, "accel": "fast"}),
        ),
        ("end_move", json!({"pose": [1, 2, 3, 4, 5], "endPosition": [1, 2, 3, 4, 5, 6], "speed": 1})),
        ("end_move", json!({"pose": [1, 2, 3, 4, 5, 6, 7], "speed": 1})),
        ("end_move", json!({"pose": {"x": 1, "y": 2, "z": 3, "rx": true, "ry": 5, "rotation": 6}, "speed": 1})),
        ("end_move", json!({"pose": 12, "speed": 1})),
        ("jog", json!({"coord_map": 0})),
        ("jog", json!({"jog_mode": "fly", "frame": 0})),
        ("jog", json!({"jog_mode": "stop", "frame": 7, "axis": 6, "velocity": 10})),
        ("load_program", json!({"program_name": "拧螺丝"})),
        ("load_program", json!({"program_name": 5})),
        ("set_clsn_sensitivity", json!({"level": 2.5})),
        ("set_clsn_sensitivity", json!({"level": 9, "speed": 1})),
        ("set_digital_output", json!({"kind": "relay", "index": 0, "value": 1})),
        ("power_on", json!({"now": true})),
    ]
    .map(|(wire, fields)| {
        let problems = jaka_dynamic::request(&SPEC, command(wire), &object(fields), AdvisoryRanges::Enforced);
        format!("{wire}:\n{}", lines(&problems.expect_err("the request has problems")))
    });
    expect![[r#"
        joint_move:
        field `mode` is missing; allowed is 0 (Absolute) or 1 (Relative)
        field `joint_position` is missing; allowed is an array of 6, each a number (in deg)
        field `speed` is missing; allowed is a number, more than 0, at most 265 deg/s
        joint_move:
        there is no field `sped`; did you mean `speed`?
        field `mode` is 2; allowed is 0 (Absolute) or 1 (Relative)
        field `joint_position[2]` is "2"; allowed is a number (in deg)
        field `joint_position[4]` is null; allowed is a number (in deg)
        field `speed` is -1; allowed is a number, more than 0, at most 265 deg/s
        field `acceleration` is "fast"; allowed is a number, more than 0, at most 720 deg/s²
        end_move:
        field `pose` is given twice, also as [1,2,3,4,5]
        end_move:
        field `pose` is [1,2,3,4,5,6,7]; allowed is an array [x, y, z, rx, ry, rz]
        end_move:
        there is no field `pose.rotation`; the fields are `x`, `y`, `z`, `rx`, `ry`, `rz`
        field `pose.rx` is true; allowed is a number (in deg)
        field `pose.rz` is missing; allowed is a number (in deg)
        end_move:
        field `pose` is 12; allowed is an array [x, y, z, rx, ry, rz]
        jog:
        field `jog_mode` is missing; allowed is 0 (Stop), 1 (Continuous), 2 (Increment) or 3 (Absolute)
        jog:
        field `jog_mode` is "fly"; allowed is 0 (Stop), 1 (Continuous), 2 (Increment) or 3 (Absolute)
        jog:
        there is no field `velocity`; the fields are `frame`, `axis`
        field `frame` is 7; allowed is 0 (World), 1 (Joint) or 2 (Tool)
        field `axis` is 6; allowed is a whole number, 0 to 5
        load_program:
        field `program_name` is "拧螺丝"; allowed is text of printable ASCII
        load_program:
        field `program_name` is 5; allowed is text of printable ASCII
        set_clsn_sensitivity:
        field `level` is 2.5; allowed is a whole number, 0 to 5
        set_clsn_sensitivity:
        there is no field `speed`; the fields are `level`
        field `level` is 9; allowed is a whole number, 0 to 5; this is advisory
        set_digital_output:
        field `kind` is "relay"; allowed is 0 (Cabinet), 1 (Tool) or 2 (Extension); this is advisory
        power_on:
        there is no field `now`; there are no fields
    "#]]
    .assert_eq(&told.concat());
}

#[test]
fn what_newer_firmware_takes_can_be_let_through() {
    let fields = object(json!({"kind": "relay", "index": 0, "value": 1}));
    let text = jaka_dynamic::request(&SPEC, command("set_digital_output"), &fields, AdvisoryRanges::Ignored);
    assert_eq!(text.as_deref(), Ok(r#"{"cmdName":"set_digital_output","type":3,"index":0,"value":1}"#));
}
