//! `jaka check`: finds each planted fault, and nothing else.

#![allow(clippy::needless_raw_string_hashes, reason = "expect-test writes them")]

mod arm;
mod ports;
mod states;

use expect_test::{Expect, expect};
use jaka_sim::Controller;
use jaka_tests::Arm;
use serde_json::{Value, json};

use super::{Run, jaka};

/// Returns an arm without faults.
fn healthy() -> Arm {
    Arm::simulated().start()
}

fn check(arm: &Arm, options: &[&str]) -> Run {
    jaka(arm, ["check"].iter().chain(options))
}

/// Returns the findings of a report in JSON: errors, and items to look at.
fn findings(report: &Run) -> Vec<Value> {
    let report: Value = serde_json::from_str(&report.out).unwrap_or_else(|_| panic!("{}", report.text()));
    let findings = report["findings"].as_array().expect("it is one").clone();
    let is_found = |finding: &Value| matches!(finding["verdict"].as_str(), Some("look" | "wrong"));
    findings.into_iter().filter(is_found).collect()
}

/// Returns the report of a run as lines, without ports.
fn found(report: &Run) -> String {
    let text = |value: &Value| value.as_str().expect("it is a text").to_owned();
    let lines = findings(report).into_iter().map(|finding| {
        let [item, verdict, seen, advice] = ["item", "verdict", "seen", "advice"].map(|key| text(&finding[key]));
        format!("{item}: {verdict}: {seen}\n  {advice}\n")
    });
    without_ports(&lines.collect::<String>())
}

fn without_ports(text: &str) -> String {
    let mut parts = text.split("127.0.0.1:");
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |text, part| text + "127.0.0.1:PORT" + part.trim_start_matches(|c: char| c.is_ascii_digit()))
}

/// Returns the report on an arm with a fault.
fn report_of(fault: impl FnOnce(&Controller)) -> Run {
    let controller = healthy();
    fault(&controller);
    check(&controller, &["--yes", "--json"])
}

/// Plants a fault in a healthy arm, and checks that it is the only finding, and that the exit code is that of the
/// verdict.
fn assert_found(fault: impl FnOnce(&Controller), expected: &Expect) {
    assert_report(&report_of(fault), expected);
}

/// Plants each fault in an arm of its own, and compares the findings of all.
fn assert_each_found(faults: &[&dyn Fn(&Controller)], expected: &Expect) {
    let findings = faults.iter().map(|fault| {
        let report = report_of(fault);
        assert_code(&report);
        found(&report)
    });
    expected.assert_eq(&findings.collect::<String>());
}

fn assert_report(report: &Run, expected: &Expect) {
    expected.assert_eq(&found(report));
    assert_code(report);
}

/// Checks that the exit code is that of the worst verdict.
fn assert_code(report: &Run) {
    let json: Value = serde_json::from_str(&report.out).unwrap_or_else(|_| panic!("{}", report.text()));
    let code = match json["verdict"].as_str() {
        Some("nothing_found") => 0,
        Some("look") => 8,
        Some("wrong") => 9,
        other => panic!("{other:?}"),
    };
    assert_eq!(report.code, code, "{}", report.text());
}

#[test]
fn nothing_is_found_on_a_healthy_arm() {
    let controller = healthy();
    let report = check(&controller, &["--yes"]);
    expect![[r#"
        command port     nothing found  127.0.0.1:PORT answers
        status port      nothing found  packets arrive
        firmware         nothing found  1.5.14_13_X64
        power            nothing found  the arm has power
        enabled          nothing found  the arm is enabled
        emergency stop   nothing found  not pressed
        protective stop  nothing found  not active
        event            nothing found  none
        servo mode       nothing found  off
        drag mode        nothing found  off
        program          nothing found  no program runs
        tool frame       nothing found  0, the centre of the flange
        user frame       nothing found  0, the robot's base
        payload          nothing found  1 kg
        rapid rate       nothing found  1 of 1
        collision level  nothing found  3
        soft limit       nothing found  not hit
        status packets   nothing found  complete
        status rate      nothing found  33 packets in a second
        round trip       nothing found  100 queries: 50 % within 0.0ns, 99 % within 0.0ns
        model            nothing found  poses agree with Zu 5, Pro 5, S5, C5
        DH parameters    nothing found  equal or close to those of a Zu 5
        limits           nothing found  the arm is within the limits of Zu 5, Pro 5, S5, C5

        Look at the pendant for these, which no query reads:
        remote control     acceptance of motions from this program
        mounting           direction of the mounting; poses and kinematics depend on it
        network exception  reaction of the arm to a lost connection (4.75)
        soft limits        joint ranges, speeds and zones in the controller itself

        0 wrong, 0 to look at, 0 not checked.
        "Nothing found" is not "safe": states and settings were read, and nothing is known of the cell, the people in it, the tool, and where the arm will move.
        exit code 0
    "#]].assert_eq(&without_ports(&report.text()));
}

#[test]
fn the_report_in_json_has_one_shape() {
    let controller = healthy();
    let report = check(&controller, &["--yes", "--json"]);
    let mut report: Value = serde_json::from_str(&report.out).expect("it is JSON");
    let findings = report["findings"].take();
    let items: Vec<_> = findings.as_array().expect("it is one").iter().map(|finding| finding["item"].clone()).collect();
    expect![[r#"["command_port","status_port","firmware","power","enabled","emergency_stop","protective_stop","event","servo_mode","drag_mode","program","tool_frame","user_frame","payload","rapid_rate","collision_level","soft_limit","status_packets","status_rate","round_trip","model","dh_parameters","limits"]"#]].assert_eq(&json!(items).to_string());
    expect![[r#"
        {
          "advice": null,
          "item": "command_port",
          "seen": "127.0.0.1:PORT answers",
          "verdict": "nothing_found"
        }"#]]
    .assert_eq(&without_ports(&format!("{:#}", findings[0])));
    report["jaka"] = json!("VERSION");
    expect![[r#"
        {
          "at_the_pendant": [
            {
              "item": "remote_control",
              "what": "acceptance of motions from this program"
            },
            {
              "item": "mounting",
              "what": "direction of the mounting; poses and kinematics depend on it"
            },
            {
              "item": "network_exception",
              "what": "reaction of the arm to a lost connection (4.75)"
            },
            {
              "item": "soft_limits",
              "what": "joint ranges, speeds and zones in the controller itself"
            }
          ],
          "findings": null,
          "jaka": "VERSION",
          "note": "\"Nothing found\" is not \"safe\": states and settings were read, and nothing is known of the cell, the people in it, the tool, and where the arm will move.",
          "robot": "127.0.0.1",
          "verdict": "nothing_found"
        }"#]].assert_eq(&format!("{report:#}"));
}
