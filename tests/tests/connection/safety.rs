//! `tests/promises.md`: each promise on it names a test that exists; with tests of the promises that no other file
//! tests.

use std::fs;
use std::path::Path;

use jaka_proto::Envelope;
use jaka_robot::motion::JointMove;
use jaka_robot::power::GetVersion;
use jaka_robot::types::JointPosition;
use jaka_robot::{Cause, Command, ErrorKind, Monitor};
use jaka_sim::Controller;
use jaka_tests::{Arm, LONG};

fn page() -> String {
    fs::read_to_string(folder().join("promises.md")).expect("the page is there")
}

/// The folder of the page.
fn folder() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The links of a text: their labels and their targets.
fn links(text: &str) -> impl Iterator<Item = (&str, &str)> {
    text.split("](").zip(text.split("](").skip(1)).filter_map(|(before, after)| {
        let shown = before.rsplit('[').next()?;
        Some((shown, after.split(')').next()?))
    })
}

/// The rows of the tables of promises: the promise, and the cell of its tests.
fn promises(page: &str) -> Vec<(&str, &str)> {
    let part = page.split("\n# ").find(|part| part.starts_with("What it promises")).expect("the page has the part");
    let rows = part.lines().filter_map(|line| line.strip_prefix("| ")?.strip_suffix(" |")?.rsplit_once(" | "));
    rows.filter(|(promise, _)| *promise != "promise").collect()
}

/// Finds a problem with the tests of a promise; none if they are correct.
fn problem(cell: &str) -> Option<String> {
    if links(cell).next().is_none() {
        return Some("it has no test".to_owned());
    }
    links(cell).find_map(|(name, path)| {
        let name = name.trim_matches('`');
        let file = fs::read_to_string(folder().join(path)).unwrap_or_default();
        let is_test = file.split("#[test]").skip(1).any(|code| {
            let function = code.split("fn ").nth(1).unwrap_or_default();
            function.split('(').next() == Some(name)
        });
        (!is_test).then(|| format!("there is no test `{name}` in {path}"))
    })
}

#[test]
fn each_promise_has_a_test() {
    let page = page();
    let promises = promises(&page);
    assert!(promises.len() >= 25, "the page was read: {promises:?}");
    for (promise, tests) in promises {
        assert_eq!(problem(tests), None, "{promise}");
    }
}

#[test]
fn a_promise_without_a_test_is_noticed() {
    let page =
        "x\n# What it promises\n| promise | test |\n|---|---|\n| A. | |\n| B. | [`b`](../c.rs) |\n\n# Else\n| D. | |";
    assert_eq!(promises(page).last(), Some(&("B.", "[`b`](../c.rs)")));
    let safety = "tests/connection/safety.rs";
    for (cell, is_wrong) in [
        (String::new(), true),
        ("`nothing_is_sent_on_its_own`".to_owned(), true),
        (format!("[`nothing_is_sent_on_its_own`]({safety})"), false),
        (format!("[`promises`]({safety})"), true),
        (format!("[`nothing`]({safety})"), true),
        (format!("[`nothing_is_sent_on_its_own`]({safety}), [`b`](../c.rs)"), true),
    ] {
        assert_eq!(problem(&cell).is_some(), is_wrong, "{cell}");
    }
}

/// Names of the commands that arrived after the first `before` requests.
fn since(controller: &Controller, before: usize) -> Vec<String> {
    let requests = controller.requests();
    let name = |text: &String| Envelope::read(text).ok()?.command.map(std::borrow::Cow::into_owned);
    requests[before..].iter().filter_map(name).collect()
}

#[test]
fn nothing_is_sent_on_its_own() {
    let (controller, mut robot) = Arm::simulated().without_power().with_robot();
    robot.power_up(LONG).expect("it powers up at once");
    let before = controller.requests().len();
    let joint_position = [100.0, 90.0, 90.0, 90.0, -90.0, 0.0];
    let motion = JointMove::absolute(joint_position, 20.0);
    robot.start(&motion).expect("it is reachable");
    controller.collide();
    assert!(robot.wait(LONG).cause() == Cause::ProtectiveStop);
    controller.press_emergency_stop();
    controller.release_emergency_stop();
    let error = robot.start(&motion).expect_err("nobody has looked");
    assert!(matches!(error.kind(), ErrorKind::NotAcknowledged { .. }), "{error:?}");
    // The connection keeps the order: what was sent before has come when this is answered.
    robot.client().get_version().expect("it answers");
    assert_eq!(since(&controller, before), [JointMove::INFO.name, GetVersion::INFO.name]);
    // Neither does it say goodbye.
    drop(robot);
    assert!(controller.wait_for_disconnect(LONG), "the connection is closed");
    assert_eq!(since(&controller, before).len(), 2);
    assert!(controller.state().powered && controller.state().protective_stop);
}

#[test]
fn a_lost_connection_leaves_an_accepted_motion_running() {
    let (controller, mut client) = Arm::simulated().with_client();
    let joint_position = [5.0, 90.0, 90.0, 90.0, -90.0, 0.0];
    let motion = JointMove::absolute(joint_position, 90.0).acceleration(700.0);
    client.call(&motion).expect("it is reachable");
    let before = controller.requests().len();
    controller.disconnect();
    let error = client.get_version().expect_err("the connection is lost");
    assert!(error.is_disconnected(), "{error:?}");
    let monitor: Monitor = controller.monitor();
    let is_there = |at: JointPosition| (at.0[0] - 5.0).abs() < 1e-6;
    monitor.wait_until(|status| status.joint_actual_position.is_some_and(is_there), LONG).expect("the arm goes on");
    assert_eq!(since(&controller, before), Vec::<String>::new(), "nothing is sent again");
}
