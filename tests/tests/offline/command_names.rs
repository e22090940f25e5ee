//! Commands that sources name, where the spec could say what they mean: roles, changes and motions are data.

use std::collections::{BTreeMap, BTreeSet};

use jaka_tests::spec;

use crate::architecture::{code, read, root, sources};

/// Files that name commands other than by a typed call, with the reason.
const NAMED: &[(&str, &str, &str)] = &[
    (
        "jaka-cli/src/arm/acting.rs",
        "get_joint_pos get_robot_state get_tcp_pos is_in_servomove",
        "the queries that a robot sends by itself, which a pack must not change",
    ),
    ("jaka-cli/src/arm/rest.rs", "get_joint_pos", "the query for rest, which a pack must not change"),
    ("jaka-cli/src/commands/jitter/report.rs", "get_joint_pos", "the query that it has sent, for the report"),
    ("jaka-cli/src/commands/probe/finding.rs", "get_version", "the reply that names the firmware"),
    ("jaka-cli/src/commands/up.rs", "power_on", "the step that the progress is about"),
    ("jaka-cli/src/commands/monitor/dashboard/keys.rs", "quit", "a word of the help for keys"),
    (
        "jaka-cli/src/commands/report/session/lateness.rs",
        "servo_j servo_move servo_p",
        "typed set-points with their step counts",
    ),
    ("jaka-cli/src/commands/report/session/packets.rs", "drag_status", "a key of the status packet"),
    ("jaka-robot/src/arm/position.rs", "get_joint_pos get_tcp_pos", "the queries that it sends"),
    ("jaka-robot/src/follow/start.rs", "servo_move", "the command before which it checks, for an error"),
    ("jaka-robot/src/guard/set_points.rs", "servo_j", "the command of the set-points, for an error"),
    ("jaka-robot/src/limits.rs", "kine_forward servo_j servo_p", "the commands that it sends, for errors"),
    ("jaka-robot/src/power_steps.rs", "disable_robot enable_robot power_off power_on", "the steps that it sends"),
    ("jaka-robot/src/preflight/packets.rs", "rapid_rate", "a key of the status packet"),
    (
        "jaka-robot/src/servo_session/enter.rs",
        "servo_j servo_move set_servo_move_filter",
        "the commands that it sends, and the set-points",
    ),
    ("jaka-robot/src/servo_session/generated.rs", "servo_j", "the command of the set-points, for an error"),
    ("jaka-robot/src/servo_session/land.rs", "servo_j", "the set-points that it sends"),
    ("jaka-robot/src/servo_session/leave.rs", "is_in_servomove servo_j servo_move", "the commands that it sends"),
    ("jaka-robot/src/servo_session/rates.rs", "servo_j servo_p", "the command of the set-points, for an error"),
    ("jaka-robot/src/servo_session/session.rs", "servo_j", "the set-points that it sends"),
    ("jaka-sync/src/client.rs", "get_version", "the query that it sends"),
    ("jaka-sync/src/motion_status.rs", "drag_status", "a key of the status packet"),
    ("jaka-sync/src/stop.rs", "stop_program", "the built-in stop, the only one that stop handles send"),
];

/// Crates whose decisions follow from the spec. The simulator's own behaviour names its commands.
const CRATES: [&str; 5] = ["jaka-proto", "jaka-dynamic", "jaka-sync", "jaka-robot", "jaka-cli"];

#[test]
fn commands_are_named_where_there_is_a_reason() {
    let found = named();
    let expected: BTreeMap<_, BTreeSet<_>> = NAMED
        .iter()
        .map(|(file, names, _)| ((*file).to_owned(), names.split(' ').map(str::to_owned).collect()))
        .collect();
    assert_eq!(found, expected);
    assert!(NAMED.iter().all(|(.., reason)| !reason.is_empty()));
}

/// The commands that each file names: by the `INFO` of its type, by a pattern of a request, or by a text.
fn named() -> BTreeMap<String, BTreeSet<String>> {
    let spec = spec();
    let mut found = BTreeMap::new();
    for folder in CRATES {
        let files = sources(&root().join(folder).join("src"));
        for file in files.iter().filter(|file| !file.ends_with("interleavings.rs")) {
            let code = code(&read(file));
            let code: String = code.lines().filter(|line| !line.trim_start().starts_with("#[doc(alias")).collect();
            let is_in = |command: &&jaka_spec::Command| {
                let ty = command.request_type();
                [format!("{ty}::INFO"), format!("Request::{ty}"), format!("\"{}\"", command.wire)]
                    .iter()
                    .any(|part| holds(&code, part))
            };
            let commands: BTreeSet<_> = spec.commands().filter(is_in).map(|command| command.wire.clone()).collect();
            if !commands.is_empty() {
                let path = file.strip_prefix(root()).expect("it is below").display().to_string().replace('\\', "/");
                found.insert(path, commands);
            }
        }
    }
    found
}

/// True if the code has this part, not as the end of a longer name.
fn holds(code: &str, part: &str) -> bool {
    code.match_indices(part).any(|(at, _)| {
        let before = code[..at].chars().next_back();
        let after = code[at + part.len()..].chars().next();
        let is_name = |sign: Option<char>| sign.is_some_and(|sign| sign.is_alphanumeric() || sign == '_');
        !is_name(before) && !is_name(after)
    })
}
