//! Files and targets that a command line names.

use std::path::Path;

/// The files that the line writes.
pub(super) fn written(line: &str) -> Vec<&str> {
    let words: Vec<_> = line.split(' ').collect();
    let after = words.windows(2).filter(|pair| matches!(pair[0], "--draft" | "--record" | "-o" | ">"));
    let files: Vec<_> = after.map(|pair| pair[1]).collect();
    let recorded = line.strip_prefix("jaka record ").and_then(|rest| rest.split(' ').next());
    files.into_iter().chain(recorded).collect()
}

/// First name on the line of something that does not exist; lines of `jaka` are run instead.
pub(super) fn missing(root: &Path, line: &str) -> Option<String> {
    let words: Vec<_> = line.split(' ').collect();
    match words[..] {
        ["jaka" | "rustup" | "printf", ..] => None,
        ["cargo", command, ..] => missing_of_cargo(root, command, &words[2..]),
        [script, ..] if script.contains('/') => (!root.join(script).exists()).then(|| script.to_owned()),
        _ => Some(format!("no such command: {line}")),
    }
}

fn missing_of_cargo(root: &Path, command: &str, words: &[&str]) -> Option<String> {
    if !["run", "test", "bench", "install", "doc"].contains(&command) {
        return Some(format!("cargo {command}"));
    }
    // What follows `--` is not cargo's.
    let mut pairs = words.windows(2).take_while(|pair| pair[0] != "--");
    pairs.find_map(|pair| missing_of_option(root, pair[0], pair[1]))
}

fn missing_of_option(root: &Path, option: &str, value: &str) -> Option<String> {
    let places = match option {
        "--example" => vec![format!("jaka-robot/examples/{value}.rs"), format!("tests/examples/{value}.rs")],
        "--bench" => vec![format!("benches/benches/{value}.rs"), format!("benches/benches/{value}")],
        "--bin" => vec![format!("benches/src/bin/{value}.rs")],
        "--test" => {
            vec![format!("tests/tests/{value}.rs"), format!("tests/tests/{value}"), format!("benches/tests/{value}.rs")]
        }
        "--path" | "--manifest-path" => vec![value.to_owned()],
        "-p" => vec![folder_of(value).to_owned()],
        _ => return None,
    };
    places.iter().all(|place| !root.join(place).exists()).then(|| value.to_owned())
}

/// Folders have the names of their crates, but for these.
fn folder_of(package: &str) -> &str {
    match package {
        "jaka-spec" => "spec",
        "jaka-tests" => "tests",
        other => other,
    }
}
