//! `jaka check`, as its users run it: each planted fault is found, and nothing else.

#![allow(clippy::needless_raw_string_hashes, reason = "expect-test writes them")]

mod arm;
mod ports;
mod states;

use expect_test::{Expect, expect};
use jaka_sim::{Controller, Delays};
use serde_json::{Value, json};

use crate::common::output;
use crate::program::{Run, address_of, command, jaka, run};

/// An arm with which nothing is wrong.
fn healthy() -> Controller {
    let controller = Controller::builder().delays(Delays::NONE).start().expect("loopback has free ports");
    make_ready(&controller);
    controller
}

fn make_ready(controller: &Controller) {
    controller.set_state(|state| (state.powered, state.enabled) = (true, true));
}

fn check(controller: &Controller, options: &[&str]) -> Run {
    jaka(["check"].iter().chain(options).map(|&option| option.to_owned()).chain(address_of(controller)))
}

/// The findings of a report in JSON: what is wrong, and what to look at. How fast replies and packets come depends on this machine, and
/// has tests of its own.
fn findings(report: &Run) -> Vec<Value> {
    let report: Value = serde_json::from_str(&report.out).unwrap_or_else(|_| panic!("{}", report.text()));
    let findings = report["findings"].as_array().expect("it is one").clone();
    let is_found = |finding: &Value| matches!(finding["verdict"].as_str(), Some("look" | "wrong"));
    let is_timed = |finding: &Value| matches!(finding["item"].as_str(), Some("round_trip" | "status_rate"));
    findings.into_iter().filter(|finding| is_found(finding) && !is_timed(finding)).collect()
}

/// The same as lines, without ports.
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

/// Plants a fault in a healthy arm: exactly this is found, and the exit code is that of the verdict.
fn assert_found(fault: impl FnOnce(&Controller), expected: &Expect) {
    let controller = healthy();
    fault(&controller);
    assert_report(&check(&controller, &["--yes", "--json"]), expected);
}

fn assert_report(report: &Run, expected: &Expect) {
    expected.assert_eq(&found(report));
    assert_code(report);
}

/// The exit code is that of the worst verdict.
fn assert_code(report: &Run) {
    let json: Value = serde_json::from_str(&report.out).unwrap_or_else(|_| panic!("{}", report.text()));
    let code = match json["verdict"].as_str() {
        Some("nothing_found") => 0,
        Some("look") => 8,
        Some("wrong") => 9,
        other => panic!("{other:?}"),
    };
    assert_eq!(report.code, Some(code), "{}", report.text());
}

#[test]
fn nothing_is_found_on_a_healthy_arm() {
    let controller = healthy();
    // Where the machine is so busy that replies are slow, this is found, rightly.
    let reports = (0..10).map(|_| check(&controller, &["--yes"]));
    let report = reports.into_iter().find(|report| report.code == Some(0)).expect("nothing is found");
    let figures = |line: &str| match line.split_once("nothing found  ") {
        Some((item, _)) if item.starts_with("status rate") => format!("{item}nothing found  RATE"),
        Some((item, _)) if item.starts_with("round trip") => format!("{item}nothing found  TIMES"),
        _ => line.to_owned(),
    };
    let text: Vec<_> = without_ports(&report.text()).lines().map(figures).collect();
    expect![[r#"
        command port     nothing found  127.0.0.1:PORT answers
        status port      nothing found  packets come
        firmware         nothing found  1.5.14_13_X64
        power            nothing found  the arm has power
        enabled          nothing found  the arm is enabled
        emergency stop   nothing found  not pressed
        protective stop  nothing found  not in one
        event            nothing found  0x10f0004 (information: the robot is enabled), "the robot is enabled"
        servo mode       nothing found  off
        drag mode        nothing found  off
        program          nothing found  none runs
        tool frame       nothing found  0, the centre of the flange
        user frame       nothing found  0, the robot's base
        payload          nothing found  1 kg
        rapid rate       nothing found  1 of 1
        collision level  nothing found  3
        soft limit       nothing found  not hit
        status packets   nothing found  whole
        status rate      nothing found  RATE
        round trip       nothing found  TIMES
        model            nothing found  poses are those of Zu 5, Pro 5, S5, C5
        DH parameters    nothing found  those of a Zu 5, or near them
        limits           nothing found  the arm is within those of Zu 5, Pro 5, S5, C5

        Look at the pendant for what no query tells:
        remote control     whether the controller takes motions from this program
        mounting           how the arm is mounted: poses and kinematics follow it
        network exception  what the arm does when the connection is lost (4.75)
        soft limits        the joint ranges, speeds and zones that the controller itself keeps

        0 wrong, 0 to look at, 0 not checked.
        "Nothing found" is not "safe": states and settings were read, and nothing is known of the cell, the people in it, the tool, and where the arm will move.
        exit code 0"#]].assert_eq(&text.join("\n"));
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
    (report["jaka"], report["verdict"]) = (json!("VERSION"), json!("VERDICT"));
    expect![[r#"
        {
          "at_the_pendant": [
            {
              "item": "remote_control",
              "what": "whether the controller takes motions from this program"
            },
            {
              "item": "mounting",
              "what": "how the arm is mounted: poses and kinematics follow it"
            },
            {
              "item": "network_exception",
              "what": "what the arm does when the connection is lost (4.75)"
            },
            {
              "item": "soft_limits",
              "what": "the joint ranges, speeds and zones that the controller itself keeps"
            }
          ],
          "findings": null,
          "jaka": "VERSION",
          "note": "\"Nothing found\" is not \"safe\": states and settings were read, and nothing is known of the cell, the people in it, the tool, and where the arm will move.",
          "robot": "127.0.0.1",
          "verdict": "VERDICT"
        }"#]].assert_eq(&format!("{report:#}"));
}

#[test]
fn the_seat_is_not_taken_without_consent() {
    let controller = healthy();
    let words = ["check".to_owned()].into_iter().chain(address_of(&controller));
    let refused = run(command(words), "y\n");
    expect![[r#"
        error: nothing was checked: another program that is connected to the command port may be disconnected, and there is no terminal to ask on; use --yes to connect anyway
        exit code 2
    "#]].assert_eq(&refused.text());
    assert!(controller.requests().is_empty());
}

#[test]
fn a_simulated_arm_needs_no_consent() {
    let report = jaka(["check", "--sim", "--json"]);
    expect![[r#"
        power: look: the arm has no power
          switch it on: `power_on`
    "#]]
    .assert_eq(&found(&report));
    assert_eq!(report.code, Some(8));
}

#[test]
fn the_help_has_an_example() {
    let (help, _, code) = output(&mut crate::common::jaka(&["check", "--help"]));
    assert_eq!(code, Some(0));
    assert!(help.contains("Examples:\n  jaka check -r 10.5.5.100\n"), "{help}");
    let help = help.split("Robot:").next().unwrap_or_default();
    expect![[r#"
        Look at a robot before it is used: ports, power, stops, payload, rates, model; nothing is changed

        Each item is `nothing found`, `look`, `wrong` or `not checked`, with what was seen and what to do.
        Only reads: it sends queries, and reads status packets for a second. The command port serves one
        client: another program that is connected there may be disconnected, so this asks first.

        Usage: jaka check [OPTIONS]

        Options:
              --json
                  Print one JSON object: `robot`, `verdict`, `findings`, `at_the_pendant` and `note`

              --model <NAME>
                  The arm's model, such as zu5 [default: whichever published one agrees with the controller]

              --limits <FILE>
                  The arm's limits, with its model: a TOML file

          -y, --yes
                  Connect to the command port without asking

          -h, --help
                  Print help (see a summary with '-h')

    "#]]
    .assert_eq(help);
}
