//! `jaka jitter`, as its users run it. What it measures depends on the machine: nothing here does.

#![allow(clippy::needless_raw_string_hashes, reason = "expect-test writes them")]

use expect_test::expect;
use jaka_tests::Arm;
use serde_json::Value;

use crate::program::{Run, address_of, command, run};

fn jitter(options: &[&str]) -> Run {
    run(command(["jitter"].iter().chain(options)), "")
}

fn report(run: &Run) -> Value {
    assert_eq!(run.code, Some(0), "{}", run.text());
    serde_json::from_str(&run.out).unwrap_or_else(|_| panic!("{}", run.text()))
}

fn keys(value: &Value) -> String {
    value.as_object().expect("it is an object").keys().map(String::as_str).collect::<Vec<_>>().join(" ")
}

/// Percentiles go up.
fn assert_percentiles(figures: &Value) {
    let of = |key: &str| figures[key].as_f64().unwrap_or_else(|| panic!("{figures} has no {key}"));
    assert!(figures["count"].as_u64() > Some(0), "{figures}");
    assert!(0.0 <= of("p50_us") && of("p50_us") <= of("p90_us") && of("p90_us") <= of("p99_us"), "{figures}");
    assert!(of("p99_us") <= of("max_us"), "{figures}");
}

#[test]
fn every_way_is_measured_or_says_why_not() {
    let report = report(&jitter(&["--seconds", "1", "--sim", "--json"]));
    assert_eq!(keys(&report), "advice jaka lateness period_us round_trip");
    assert_eq!(report["period_us"], 8000.0);
    let ways = report["lateness"].as_array().expect("it is one");
    let names: Vec<_> = ways.iter().map(|way| format!("{} {}", way["busy_wait_us"], way["priority"])).collect();
    assert_eq!(names, ["0.0 null", "200.0 null", "0.0 20", "200.0 20"]);
    for way in ways {
        // Only a priority may be refused.
        if way["priority"].is_null() || way["refused"].is_null() {
            assert_eq!(
                keys(way),
                "busy_wait_us count late_by_a_period late_by_three max_us p50_us p90_us p99_us priority"
            );
            assert_percentiles(way);
            let late = |key: &str| way[key].as_u64().expect("it is a number");
            assert!(late("late_by_three") <= late("late_by_a_period"), "{way}");
        } else {
            assert_eq!(keys(way), "busy_wait_us priority refused");
            let why = way["refused"].as_str().expect("it is a text");
            assert!(why.contains("the real-time priority 20"), "{why}");
        }
    }
    assert_eq!(keys(&report["round_trip"]), "count max_us p50_us p90_us p99_us query robot");
    assert_eq!(report["round_trip"]["robot"], "simulated Zu 5");
    assert_percentiles(&report["round_trip"]);
    let advice = report["advice"].as_array().expect("it is one");
    let items: Vec<_> =
        advice.iter().filter_map(|advice| advice["item"].as_str()).filter(|item| *item != "gaps").collect();
    assert_eq!(items, ["busy_wait", "priority", "core", "network", "seconds"], "a second is short");
    for advice in advice {
        assert_eq!(keys(advice), "item text verdict");
        assert!(["leave", "change"].iter().any(|verdict| advice["verdict"] == *verdict), "{advice}");
    }
}

#[test]
fn people_read_two_tables_and_what_to_change() {
    let run = jitter(&["--seconds", "0.2", "--sim"]);
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{}", run.text());
    let parts: Vec<_> = run.out.split("\n\n").collect();
    let [lateness, rows, replies, times, advice, items] = parts[..] else { panic!("{}", run.out) };
    assert_eq!(lateness, "Lateness of cycles of 8ms on this machine, in µs");
    let columns: Vec<_> = rows.lines().next().unwrap_or_default().split("  ").map(str::trim).collect();
    let columns: Vec<_> = columns.into_iter().filter(|column| !column.is_empty()).collect();
    assert_eq!(columns, ["cycles", "p50", "p90", "p99", "max", "8ms or more", "24ms or more"]);
    let names: Vec<_> = rows.lines().skip(1).map(|row| row.chars().take(30).collect::<String>()).collect();
    let names: Vec<_> = names.iter().map(|name| name.trim()).collect();
    assert_eq!(names, ["asleep", "spinning 200µs", "asleep, priority 20", "spinning 200µs, priority 20"]);
    assert_eq!(replies, "Time until replies of simulated Zu 5 to `get_joint_pos`, in µs");
    assert_eq!(times.lines().count(), 2);
    assert_eq!(advice, "Recommendations");
    assert!(items.starts_with("busy_wait  "), "{items}");
}

#[test]
fn a_robot_is_only_asked_with_consent() {
    let controller = Arm::real_time().without_power().start();
    let words = |options: &[&str]| {
        let options = ["jitter", "--seconds", "0.1", "--json"].iter().chain(options).map(|&word| word.to_owned());
        options.chain(address_of(&controller)).collect::<Vec<_>>()
    };
    expect![[r#"
        error: nothing was measured: another program that is connected to the command port may be disconnected, and there is no terminal to ask on; use --yes to connect anyway
        exit code 2
    "#]]
    .assert_eq(&run(command(words(&[])), "y\n").text());
    assert!(controller.requests().is_empty());
    assert!(report(&run(command(words(&["--yes"])), ""))["round_trip"].is_object());
    let requests = controller.requests();
    assert!(!requests.is_empty() && requests.iter().all(|request| request.contains("get_joint_pos")), "{requests:?}");
}

#[test]
fn a_robot_of_the_environment_is_left_alone() {
    let mut program = command(["jitter", "--seconds", "0.1", "--json"]);
    // It would be asked for with consent.
    program.env("JAKA_ROBOT", "127.0.0.1");
    let report = report(&run(program, ""));
    assert!(report["round_trip"].is_null());
    assert_eq!(report["advice"][3]["verdict"], "not_measured");
}
