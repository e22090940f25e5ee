//! `docs/any-language.md`: clients in another language, which know nothing of this code, talk to `jaka sim` on both
//! ports.

use std::path::Path;
use std::process::Command;
use std::{env, fs};

use jaka_tests::skipped;

const PAGE: &str = include_str!("../../docs/any-language.md");
/// Module that each of the programs imports.
const MODULE: &str = "simulated_robot.py";
const PROGRAMS: [&str; 4] = ["first_motion.py", "protective_stop.py", "power_loss.py", "slow_status.py"];

fn folder() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/any_language"))
}

/// Runs a program of the page, as its reader does: with `jaka` in the path.
fn run(name: &str) {
    let version = Command::new("python3").arg("--version").output();
    if !version.is_ok_and(|output| output.status.success()) {
        skipped(&format!("{name}, a client in Python"), "there is no python3 here");
        return;
    }
    let jaka = Path::new(env!("CARGO_BIN_EXE_jaka")).parent().expect("it is in a folder").to_owned();
    let paths = env::var_os("PATH").expect("there is one");
    let path = env::join_paths([jaka].into_iter().chain(env::split_paths(&paths))).expect("they have no colon");
    let mut python = Command::new("python3");
    // Nothing is written next to the sources.
    python.arg("-B").arg(folder().join(name)).env("PATH", path).env_remove("JAKA_PACK").env_remove("JAKA_CONFIG");
    let ended = python.output().expect("python3 runs");
    let [out, errors] = [&ended.stdout, &ended.stderr].map(|text| String::from_utf8_lossy(text));
    assert!(ended.status.success() && out.is_empty() && errors.is_empty(), "{out}{errors}");
}

#[test]
fn a_python_client_moves_the_arm() {
    run("first_motion.py");
}

#[test]
fn a_python_client_tests_a_protective_stop() {
    run("protective_stop.py");
}

#[test]
fn a_python_client_tests_a_power_loss() {
    run("power_loss.py");
}

#[test]
fn a_python_client_tests_a_slow_status() {
    run("slow_status.py");
}

#[test]
fn the_page_has_the_programs_as_they_run() {
    let blocks: Vec<_> = PAGE.split("\n```python\n").skip(1).filter_map(|rest| rest.split("```\n").next()).collect();
    let files = [MODULE].into_iter().chain(PROGRAMS).map(|name| fs::read_to_string(folder().join(name)));
    let files: Vec<_> = files.collect::<Result<_, _>>().expect("they are there");
    assert_eq!(blocks, files);
}
