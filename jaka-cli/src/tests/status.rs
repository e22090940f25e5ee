//! Packets of `jaka status` that are overdue, or held back by a network.

use std::time::Duration;

use expect_test::expect;
use jaka_sim::Port;
use jaka_tests::Arm;

use super::{Run, jaka_beside};

/// Runs a line with a link that delivers nothing from 1.2 s to 3.5 s; meanwhile the arm is disabled.
fn run(line: &str) -> Run {
    run_until(Duration::from_millis(3_500), line)
}

/// Runs a line with a link that delivers nothing from 1.2 s until this time; meanwhile the arm is disabled.
fn run_until(released: Duration, line: &str) -> Run {
    let arm = Arm::simulated().start();
    let held = || {
        arm.clock().sleep(Duration::from_millis(1_200));
        arm.link(Port::Status).to_client().hold();
        arm.clock().sleep(Duration::from_secs(1));
        arm.set_state(|state| state.enabled = false);
        arm.clock().sleep(released.saturating_sub(Duration::from_millis(2_200)));
        arm.link(Port::Status).to_client().release();
    };
    let run = jaka_beside(&arm, held, line.split(' '));
    Run { out: without_times(&run.out), err: without_times(&run.err), ..run }
}

/// Returns the text with `TIME` in place of each date and time.
fn without_times(text: &str) -> String {
    let parts: Vec<_> = text.split(" UTC").collect();
    let (last, before) = parts.split_last().expect("a text has a part");
    let masked = before.iter().map(|part| format!("{}TIME", &part[..part.len() - "2025-11-21 11:53:20".len()]));
    masked.chain([(*last).to_owned()]).collect()
}

/// Returns the values of `enabled` in the lines of JSON.
fn enabled(run: &Run) -> Vec<bool> {
    let is_enabled = |line: &str| {
        let json: serde_json::Value = serde_json::from_str(line).expect("each line is an object");
        json["enabled"].as_bool().or(json["enabled"].as_i64().map(|number| number != 0)).expect("packets have it")
    };
    run.out.lines().map(is_enabled).collect()
}

#[test]
fn a_table_that_is_due_without_a_packet_says_since_when_none_has_come() {
    let run = run("status --watch -n 3 --fields enabled");
    expect![["
        TIME
        enabled  true

        TIME
        enabled  true

        TIME
        no status packet since TIME, for 0.9 s

        TIME
        no status packet since TIME, for 1.9 s

        TIME
        enabled  false

        exit code 0
    "]]
    .assert_eq(&run.text());
}

#[test]
fn lines_of_packets_are_followed_by_a_warning_where_none_comes() {
    let run = run("status --watch -n 3 --fields enabled --format json");
    assert_eq!((enabled(&run), run.code), (vec![true, true, false], 0), "{run:?}");
    expect![["
        warning: no status packet since TIME, for 0.9 s
    "]]
    .assert_eq(&run.err);
    for options in ["--raw", "--fields enabled --format csv"] {
        let other = self::run(&format!("status --watch -n 3 {options}"));
        assert_eq!((&other.err, other.code), (&run.err, 0), "{options}: {other:?}");
    }
}

/// Tests a third packet that is due at 3.0 s, a moment before the link delivers held packets.
#[test]
fn a_packet_that_may_be_old_is_not_the_one_that_is_due() {
    let run = run_until(Duration::from_millis(3_020), "status --watch -n 3 --fields enabled --format json");
    assert_eq!((enabled(&run), run.code), (vec![true, true, false], 0), "{run:?}");
}

/// Tests that each packet is printed, also one that may be old.
#[test]
fn of_all_packets_those_that_may_be_old_are_announced() {
    let run = run("status --watch 0 -n 120 --raw");
    let enabled = enabled(&run);
    assert!(enabled.len() == 120 && !enabled[119], "{run:?}");
    expect![["
        warning: no status packet since TIME, for 0.6 s
        warning: status packets resumed after 2.3 s; the first ones may be old, held back by the network
    "]]
    .assert_eq(&run.err);
}

#[test]
fn a_packet_that_may_be_old_does_not_end_a_wait() {
    let arm = Arm::simulated().start();
    let held = || {
        arm.clock().sleep(Duration::from_secs(1));
        arm.link(Port::Status).to_client().hold();
        arm.set_state(|state| state.enabled = false);
        arm.clock().sleep(Duration::from_secs(1));
        arm.set_state(|state| state.enabled = true);
        arm.clock().sleep(Duration::from_secs(1));
        arm.link(Port::Status).to_client().release();
    };
    let run = jaka_beside(&arm, held, ["status", "--until", "!enabled", "--timeout", "6", "--fields", "enabled"]);
    assert_eq!((run.code, &*run.out), (27, ""), "{run:?}");
    assert!(run.err.contains("`!enabled` was not true within 6s; the last packet: enabled true"), "{run:?}");
}

#[test]
fn packets_that_stay_away_end_it() {
    let arm = Arm::simulated().start();
    let held = || {
        arm.clock().sleep(Duration::from_millis(1_200));
        arm.link(Port::Status).to_client().hold();
    };
    let run = jaka_beside(&arm, held, ["status", "--watch", "--fields", "enabled", "--format", "csv"]);
    assert!(run.code != 0 && run.err.contains(" within 5s\nhint: check that this is the status port"), "{run:?}");
}
