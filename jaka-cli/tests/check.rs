//! `jaka check`, as its users run it: `src/tests/check.rs` has what it finds.

#![allow(clippy::needless_raw_string_hashes, reason = "expect-test writes them")]

use expect_test::expect;
use jaka_tests::Arm;
use serde_json::Value;

use crate::program::{self, address_of, command, run};

#[test]
fn the_seat_is_not_taken_without_consent() {
    let controller = Arm::real_time().start();
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
    let report = program::jaka(["check", "--sim", "--json"]);
    let code = report.code;
    let report: Value = serde_json::from_str(&report.out).unwrap_or_else(|_| panic!("{}", report.text()));
    let power = report["findings"].as_array().expect("it is one").iter().find(|finding| finding["item"] == "power");
    assert_eq!(power.expect("each item has one")["advice"], "switch it on: `power_on`");
    assert_eq!((&report["verdict"], code), (&"look".into(), Some(8)));
}

/// Checks a controller that has a stop in words of its own, and an error code that is a number, by a pack.
fn checked_with(pack: &str) -> program::Run {
    let file = program::scratch("check_pack.toml");
    std::fs::write(&file, format!("title = 'T'\n{pack}")).expect("the folder is there");
    let controller = Arm::real_time().start();
    controller.set_status([("protective_stop".to_owned(), "free".into()), ("errcode".to_owned(), 0.5.into())]);
    controller.publish();
    let words = ["check", "--yes", "--pack", &file.display().to_string()].map(str::to_owned);
    program::jaka(words.into_iter().chain(address_of(&controller)))
}

/// Finding on status packets, with its advice.
fn status_packets(report: &program::Run) -> String {
    let mut lines = report.out.lines().skip_while(|line| !line.starts_with("status packets"));
    lines.by_ref().take(2).map(|line| line.trim().to_owned() + "\n").collect()
}

const STOP_IN_WORDS: &str =
    "[[override]]\ntarget = 'RobotStatus'\nfield = 'protective_stop'\nwritten = ['free', 'halted']\n";

#[test]
fn packets_are_read_by_packs() {
    let report = checked_with(STOP_IN_WORDS);
    expect![[r#"
        status packets   wrong          cannot be read: field `error_code`: expected a string, found `0.5`
        a `Robot` refuses motions while it cannot tell whether the arm is stopped: `jaka probe` compares the packet with the spec
    "#]].assert_eq(&status_packets(&report));
    assert_eq!(report.code, Some(9), "{}", report.text());
    let report = checked_with(&format!("{STOP_IN_WORDS}[robot_status]\nerror_code = 'absent'\n"));
    expect![[r#"
        status packets   look           absent, as declared: error_code
        look at the pendant for errors of the controller: packets do not show them
    "#]]
    .assert_eq(&status_packets(&report));
    assert_eq!(report.code, Some(8), "{}", report.text());
    let report = checked_with(&format!("{STOP_IN_WORDS}[robot_status]\nerror_code = 'program'\n"));
    expect![[r#"
        status packets   wrong          cannot be read: field `error_code`: expected text, found `0.5`; cannot be read: field `error_code`: expected a field that the pack names in `[robot_status]`, found `program`
        a `Robot` refuses motions while it cannot tell whether the arm is stopped: `jaka probe` compares the packet with the spec
    "#]].assert_eq(&status_packets(&report));
    assert_eq!(report.code, Some(9), "{}", report.text());
}
