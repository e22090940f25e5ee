//! `jaka status`, with a simulated controller.

#![allow(clippy::needless_raw_string_hashes, reason = "expect-test writes them")]

use std::io::{BufRead, BufReader};

use expect_test::expect;
use jaka_tests::Arm;

#[cfg(unix)]
use crate::common::interrupt;
use crate::common::{end, failure, jaka, output, started};

/// Output of the program, which must succeed.
fn printed(args: &[&str]) -> String {
    let (stdout, stderr, code) = output(&mut jaka(&[&["status"], args].concat()));
    assert_eq!((&*stderr, code), ("", Some(0)));
    stdout
}

/// Output of the program for a controller whose status packets have this `errcode`.
fn printed_with_code(code: &str, args: &[&str]) -> String {
    let controller = Arm::real_time().without_power().start();
    controller.set_state(|state| code.clone_into(&mut state.error_code));
    let port = controller.status_addr().port().to_string();
    printed(&[&["--robot", "127.0.0.1", "--status-port", &port, "--fields", "errcode"], args].concat())
}

#[test]
fn the_event_has_its_severity_and_meaning() {
    let codes = ["0x10f0005", "0xF0034", "0x10f0020", "0x0f0030", "0x0f9999", "0x0", "", "fine"];
    let lines: Vec<_> = codes.iter().map(|code| printed_with_code(code, &[])).collect();
    expect![[r#"
        error_code  0x10f0005 (information: the robot is disabled)
        error_code  0xF0034 (error: a collision was detected)
          cause     a safety function was triggered, or a safety signal or a safety setting changed (general: no source states it for this code)
          remedy    look for obstacles around the arm and for signs of a collision; check whether the robot's serial number and model are recognised correctly; check the settings of payload and mounting angle
        error_code  0x10f0020 (warning: reduced mode is on)
          cause     a safety function was triggered, or a safety signal or a safety setting changed (general: no source states it for this code)
          remedy    find out which signal, contact or person triggered it; look at the arm; check the wiring and the safety settings before anything moves (general: no source states it for this code)
        error_code  0x0f0030 (error: the joint speed limit is set to 0)
          cause     a value is missing, outside its range, or does not match the robot (general: no source states it for this code)
          remedy    check in the app's safety settings whether the joint speed limit is 0 °/s
        error_code  0x0f9999 (severity unknown)
        error_code  0x0
        error_code  ""
        error_code  fine (not an event code)
    "#]]
    .assert_eq(&lines.concat());
}

#[test]
fn json_has_the_severity_and_meaning_of_the_event() {
    let line = |code| {
        let text = printed_with_code(code, &["--format", "json"]);
        text.split_once(',').unwrap().1.to_owned()
    };
    let lines = ["0x10f0005", "0x0f0030", "0x0f9999", "0x0", "fine"].map(line);
    expect![[r#"
        "error_code":"0x10f0005","event_severity":"information","event_meaning":"the robot is disabled","event_cause":null,"event_remedy":"nothing has to be done (general: no source states it for this code)"}
        "error_code":"0x0f0030","event_severity":"error","event_meaning":"the joint speed limit is set to 0","event_cause":"a value is missing, outside its range, or does not match the robot (general: no source states it for this code)","event_remedy":"check in the app's safety settings whether the joint speed limit is 0 °/s"}
        "error_code":"0x0f9999","event_severity":"unknown","event_meaning":null,"event_cause":null,"event_remedy":null}
        "error_code":"0x0","event_severity":null,"event_meaning":null,"event_cause":null,"event_remedy":null}
        "error_code":"fine","event_severity":"unknown","event_meaning":null,"event_cause":null,"event_remedy":null}
    "#]]
    .assert_eq(&lines.concat());
}

#[test]
fn json_has_an_object_a_line() {
    let text = printed(&[
        "--sim",
        "--format",
        "json",
        "--fields",
        "inpos,task_mode,relay_io,din[3]",
        "-n",
        "2",
        "--watch",
        "0",
    ]);
    let lines: Vec<serde_json::Value> = text.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!(lines.len(), 2);
    assert!(lines[0]["time_s"].as_f64() <= lines[1]["time_s"].as_f64());
    let rest = lines[0].as_object().unwrap().iter().filter(|(name, _)| *name != "time_s");
    let rest: Vec<_> = rest.map(|(name, value)| format!("{name}: {value}\n")).collect();
    expect![[r#"
        digital_inputs[3]: false
        in_position: true
        relay_outputs: null
        task_mode: 1
    "#]]
    .assert_eq(&rest.concat());
}

#[test]
fn csv_has_a_column_for_each_element() {
    let text = printed(&[
        "--sim",
        "--format",
        "csv",
        "--fields",
        "joint_actual_position,position,errcode",
        "-n",
        "2",
        "--watch",
        "0",
    ]);
    let without_time = |line: &str| line.split_once(',').unwrap().1.to_owned() + "\n";
    let lines: Vec<_> = text.lines().map(without_time).collect();
    expect![[r#"
        joint_actual_position[0],joint_actual_position[1],joint_actual_position[2],joint_actual_position[3],joint_actual_position[4],joint_actual_position[5],commanded_position.x,commanded_position.y,commanded_position.z,commanded_position.rx,commanded_position.ry,commanded_position.rz,error_code
        0,90,90,90,-90,0,,,,,,,0x0
        0,90,90,90,-90,0,,,,,,,0x0
    "#]].assert_eq(&lines.concat());
}

#[test]
fn raw_is_what_came() {
    let text = printed(&["--sim", "--raw"]);
    let length = serde_json::from_str::<serde_json::Value>(&text).unwrap()["len"].as_u64();
    assert_eq!(length, u64::try_from(text.trim_end().len()).ok());
}

#[test]
fn it_ends_with_success_when_the_reader_is_gone() {
    let (mut child, out, line) = started(&mut jaka(&["status", "--sim", "--watch", "0", "--fields", "enabled"]));
    assert!(line.starts_with("20") && line.ends_with(" UTC\n"), "the time comes first: {line}");
    drop(out);
    let errors = child.stderr.take().unwrap();
    assert_eq!(end(child).code(), Some(0));
    assert_eq!(BufReader::new(errors).lines().count(), 0);
}

#[cfg(unix)]
#[test]
fn it_ends_in_peace_when_interrupted() {
    let (child, _out, _) = started(&mut jaka(&["status", "--sim", "--watch"]));
    interrupt(&child);
    assert_eq!(end(child).code(), Some(0));
}

#[test]
fn a_lost_connection_is_reported() {
    let controller = Arm::real_time().without_power().start();
    let port = controller.status_addr().port().to_string();
    let args = ["status", "--robot", "127.0.0.1", "--status-port", &port, "--watch", "0", "--fields", "enabled"];
    let (mut child, mut out, _) = started(&mut jaka(&args));
    controller.disconnect();
    let mut rest = String::new();
    while out.read_line(&mut rest).unwrap() > 0 {}
    let errors: Vec<_> = BufReader::new(child.stderr.take().unwrap()).lines().map(Result::unwrap).collect();
    expect![[r#"
        error: the status connection to 127.0.0.1:PORT is broken: the controller closed the connection
        hint: check the network; try `jaka stop`: commands may still pass"#]]
    .assert_eq(&errors.join("\n").replace(&port, "PORT"));
    assert_eq!(end(child).code(), Some(5));
}

/// A controller that sends no packets on its own but the first, and the arguments to reach it.
fn quiet_controller() -> (Arm, [String; 6]) {
    let controller = Arm::real_time().without_power().no_packets().start();
    let port = controller.status_addr().port().to_string();
    (controller, ["status", "-r", "127.0.0.1", "--watch=0", "--status-port", &port].map(str::to_owned))
}

#[test]
fn raw_is_what_came_also_where_it_does_not_fit() {
    let (controller, args) = quiet_controller();
    let (child, mut out, _) = started(jaka(&[]).args(args).args(["--raw", "--count", "2"]));
    controller.send_status(br#"{"enabled": [ ]}"#);
    let mut line = String::new();
    out.read_line(&mut line).unwrap();
    assert_eq!(line, "{\"enabled\": [ ]}\n");
    assert_eq!(end(child).code(), Some(0));
}

#[test]
fn a_field_that_does_not_fit_is_reported_once_and_the_rest_is_printed() {
    let (controller, args) = quiet_controller();
    let (mut child, mut out, _) = started(jaka(&[]).args(args).args(["--fields", "enabled,protective_stop", "-n3"]));
    for _ in 0..2 {
        controller.send_status(br#"{"len": 40, "enabled": [ ], "protective_stop": 1}"#);
    }
    let mut rest = String::new();
    while out.read_line(&mut rest).unwrap() > 0 {}
    assert_eq!(rest.matches("protective_stop").count(), 3, "{rest}");
    assert_eq!(rest.matches("true").count(), 2, "{rest}");
    let errors: Vec<_> = BufReader::new(child.stderr.take().unwrap()).lines().map(Result::unwrap).collect();
    expect!["warning: field `enabled`: expected a truth value, found `[ ]`; it is left out"]
        .assert_eq(&errors.join("\n"));
    assert_eq!(end(child).code(), Some(0));
}

#[test]
fn a_packet_that_cannot_be_read_is_reported() {
    let (controller, args) = quiet_controller();
    let (mut child, _out, _) = started(jaka(&[]).args(args).args(["--fields", "enabled"]));
    controller.send_status(br#"{"enabled" true}"#);
    let errors: Vec<_> = BufReader::new(child.stderr.take().unwrap()).lines().map(Result::unwrap).collect();
    expect!["error: a status packet does not fit the spec: not JSON: expected `:` at byte 11, found `true}`"]
        .assert_eq(&errors.join("\n"));
    assert_eq!(end(child).code(), Some(5));
}

#[test]
fn a_condition_is_waited_for() {
    let controller = Arm::real_time().without_power().start();
    let port = controller.status_addr().port().to_string();
    let args = ["status", "-r", "127.0.0.1", "--status-port", &port, "-f", "enabled", "--timeout", "60", "--watch=0"];
    let (child, mut out, _) = started(jaka(&args).args(["--until", "enabled && !protective_stop"]));
    let mut line = String::new();
    out.read_line(&mut line).unwrap();
    assert_eq!(line, "enabled  false\n");
    controller.set_state(|state| (state.powered, state.enabled) = (true, true));
    let lines: Vec<_> = out.lines().map(Result::unwrap).filter(|line| line.starts_with("enabled")).collect();
    assert_eq!(lines.iter().filter(|line| *line == "enabled  true").count(), 1, "it ends with the first: {lines:?}");
    assert_eq!(end(child).code(), Some(0));
    let args = [&args[..args.len() - 1], &["--until", "enabled"]].concat();
    assert_eq!(printed(&args[1..]), "enabled  true\n", "without --watch that packet alone is printed");
}

#[test]
fn a_condition_that_does_not_come_in_time_is_a_failure() {
    let failed = failure(&mut jaka(&["status", "--sim", "--timeout", "1", "--until", "enabled || rapid_rate > 1"]));
    // What the last packet showed is told, if one has come: the unit tests of the condition have it.
    assert!(failed.starts_with("error: `enabled || rapid_rate > 1` was not true within 1s; "), "{failed}");
    assert!(failed.ends_with("\nexit code Some(27)"), "{failed}");
    let (controller, args) = quiet_controller();
    // Also where no packet comes any more.
    let (_, stderr, code) = output(jaka(&[]).args(args).args(["--timeout", "1", "--until", "enabled"]));
    assert!(stderr.starts_with("error: `enabled` was not true within 1s; "), "{stderr}");
    assert_eq!(code, Some(27));
    drop(controller);
}

#[cfg(unix)]
#[test]
fn an_interrupt_before_the_condition_is_not_a_success() {
    let (child, _out, _) = started(&mut jaka(&["status", "--sim", "--watch", "--until", "enabled"]));
    interrupt(&child);
    assert_eq!(end(child).code(), Some(130));
}

/// A pack that changes the status packet.
const PACK: &str = r#"
title = "Newer"

[[override]]
target = "RobotStatus"
field = "inpos"
wire = "at_target"

[[override]]
target = "RobotStatus"
field = "protective_stop"
written = ["free", "stopped"]

[[override]]
target = "RobotStatus"
field = "rapidrate"
type = "text"

[[extend]]
target = "RobotStatus"

[[extend.field]]
wire = "demo_brakes"
name = "brakes"
type = "int"
optional = true
doc = "State of the brakes."

[[event]]
severity = "warning"
codes = ["0x7F0001"]
meaning = "the demonstration is over"
"#;

/// Output of the program for a packet, with the pack.
fn printed_with_pack(packet: &str, fields: &str) -> String {
    let pack = crate::program::scratch("status_pack.toml");
    std::fs::write(&pack, PACK).unwrap();
    let listener = std::net::TcpListener::bind("127.0.0.1:0").unwrap();
    let port = listener.local_addr().unwrap().port().to_string();
    std::thread::scope(|scope| {
        let sent = scope.spawn(move || {
            let (mut reader, _) = listener.accept().unwrap();
            std::io::Write::write_all(&mut reader, packet.as_bytes()).unwrap();
            reader
        });
        let pack = pack.display().to_string();
        let args = ["--robot", "127.0.0.1", "--status-port", &port, "--pack", &pack, "--fields", fields];
        let (stdout, stderr, code) = output(&mut jaka(&[&["status"][..], &args].concat()));
        drop(sent.join());
        format!("{stdout}{stderr}{code:?}")
    })
}

#[test]
fn a_pack_says_how_packets_are_read() {
    let packet = r#"{"at_target": true, "protective_stop": "stopped", "rapidrate": "full", "demo_brakes": 3,
        "enabled": true, "errcode": "0x7f0001"}"#;
    let fields = "in_position,protective_stop,rapid_rate,brakes,demo_brakes,enabled,error_code";
    expect![[r"
        in_position      true
        protective_stop  true
        rapid_rate       full
        brakes           3
        brakes           3
        enabled          true
        error_code       0x7f0001 (warning: the demonstration is over)
        Some(0)"]]
    .assert_eq(&printed_with_pack(packet, fields));
    let packet =
        r#"{"inpos": true, "protective_stop": "maybe", "demo_brakes": "on", "powered_on": "perhaps", "enabled": 1}"#;
    expect![[r#"
        in_position      –
        protective_stop  –
        brakes           –
        powered_on       –
        enabled          true
        warning: field `protective_stop`: expected "free" or "stopped", found `"maybe"`; it is left out
        warning: field `brakes`: expected a whole number, found `"on"`; it is left out
        warning: field `powered_on`: expected a truth value, found `"perhaps"`; it is left out
        Some(0)"#]]
    .assert_eq(&printed_with_pack(packet, "in_position,protective_stop,brakes,powered_on,enabled"));
}
