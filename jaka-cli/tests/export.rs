//! `jaka export`: a recording's status packets as a table.

#![allow(clippy::needless_raw_string_hashes, reason = "expect-test writes them")]

use std::fs;

use expect_test::expect;

use crate::program::{jaka, scratch};

/// Packets of two connections, one with a field that does not fit, and a message that is not a packet.
const SESSION: &str = r#"{"jaka_recording":1,"started":1763726000.5,"software":"a test"}
{"time":0.001,"port":"command","connection":1,"event":"sent","text":"{\"cmdName\":\"get_version\"}"}
{"time":0.006,"port":"status","connection":2,"event":"received","text":"{\"enabled\":true,\"joint_actual_position\":[1.5,2,3,4,5,6],\"din\":[1],\"errmsg\":\"=1+1\"}"}
{"time":0.206,"port":"status","connection":2,"event":"received","text":"{\"enabled\":false,\"curr_tcp_trans_vel\":12.5,\"din\":[0,1],\"errmsg\":\"\u001b, <\"}"}
{"time":0.21,"port":"status","connection":2,"event":"received","hex":"7bff7d"}
{"time":1000.206,"port":"status","connection":3,"event":"received","text":"{\"enabled\":\"perhaps\"}"}
"#;

/// Result of the export of a recording of this text.
fn export(session: &str, options: &[&str]) -> String {
    let path = scratch("session.jsonl");
    fs::write(&path, session).unwrap();
    let path = path.display().to_string();
    let text = jaka(["export", &path].iter().chain(options)).text();
    text.replace(&path, "session.jsonl")
}

#[test]
fn columns_have_units_and_hold_all_parts_of_all_packets() {
    expect![[r#"
        time (s),unix_time (s),connection,enabled,joint_actual_position[0] (deg),joint_actual_position[1] (deg),joint_actual_position[2] (deg),joint_actual_position[3] (deg),joint_actual_position[4] (deg),joint_actual_position[5] (deg),digital_inputs[0],digital_inputs[1],tcp_speed (mm/s),error_message
        0.006000,1763726000.506000,2,true,1.5,2,3,4,5,6,true,,,'=1+1
        0.206000,1763726000.706000,2,false,,,,,,,false,true,12.5,"\u{1b}, <"
        1000.206000,1763727000.706000,3,,,,,,,,,,,
        warning: field `enabled`: expected a truth value, found `"perhaps"`; it is left out
        warning: 1 message of the status port cannot be read as packets, and are left out
        exit code 0
    "#]]
    .assert_eq(&export(SESSION, &["--fields", "enabled,joint_actual_position,din,tcp_speed,errmsg"]));
}

#[test]
fn json_has_the_same_columns() {
    expect![[r#"
        {"time (s)":0.006000,"unix_time (s)":1763726000.506000,"connection":2,"enabled":true,"actual_position.x (mm)":null,"digital_inputs[1]":null,"error_message":"=1+1"}
        {"time (s)":0.206000,"unix_time (s)":1763726000.706000,"connection":2,"enabled":false,"actual_position.x (mm)":null,"digital_inputs[1]":true,"error_message":"\u001b, <"}
        {"time (s)":1000.206000,"unix_time (s)":1763727000.706000,"connection":3,"enabled":null,"actual_position.x (mm)":null,"digital_inputs[1]":null,"error_message":null}
        warning: field `enabled`: expected a truth value, found `"perhaps"`; it is left out
        warning: 1 message of the status port cannot be read as packets, and are left out
        exit code 0
    "#]].assert_eq(&export(
        SESSION,
        &["--fields", "enabled,actual_position.x,digital_inputs[1],errmsg", "--format", "jsonl"],
    ));
}

#[test]
fn the_usual_fields_are_those_of_status_and_all_are_all() {
    let header = |options: &[&str]| export(SESSION, options).lines().next().unwrap().to_owned();
    assert!(header(&[]).ends_with("current_tool_id,current_user_frame_id"), "{}", header(&[]));
    let all = header(&["--fields", "all"]);
    assert!(all.contains("joint_commanded_position[5] (deg)") && all.contains("monitor_data"), "{all}");
}

#[test]
fn a_file_is_written_and_never_the_recording() {
    let (session, table) = (scratch("session.jsonl"), scratch("session.csv"));
    fs::write(&session, SESSION).unwrap();
    let to =
        |path: &std::path::Path| jaka([&"export".as_ref(), &session.as_os_str(), &"-o".as_ref(), &path.as_os_str()]);
    assert_eq!((to(&table).code, to(&table).out.as_str()), (Some(0), ""));
    assert_eq!(fs::read_to_string(&table).unwrap().lines().count(), 4);
    let refused = to(&session);
    assert_eq!(refused.code, Some(2));
    assert!(refused.err.ends_with("session.jsonl is the recording, which is not overwritten\n"), "{}", refused.err);
    assert_eq!(fs::read_to_string(&session).unwrap(), SESSION);
    assert_eq!(to(&scratch("")).code, Some(6));
}

#[test]
fn what_is_not_a_recording_is_an_error_and_one_without_packets_is_a_header() {
    expect![[r#"
        error: session.jsonl: line 1 of the recording cannot be read: not JSON: expected a value at byte 0, where the text ends
        exit code 2
    "#]].assert_eq(&export("", &[]));
    expect![[r#"
        time (s),unix_time (s),connection,enabled
        warning: session.jsonl: the file ends in the middle of a line: line 2 of the recording cannot be read: not JSON: expected the end of a string at byte 16, where the text ends
        exit code 0
    "#]].assert_eq(&export(&SESSION[..80], &["--fields", "enabled"]));
    expect![[r#"
        error: there is no status field `enabeld`; similar names: `enabled`
        exit code 2
    "#]]
    .assert_eq(&export(SESSION, &["--fields", "enabeld"]));
}
