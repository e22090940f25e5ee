//! `jaka replay`: recordings that are served in place of a robot until Ctrl-C.

#![allow(clippy::needless_raw_string_hashes, reason = "expect-test writes them")]
#![cfg(unix)]

use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::process::{Child, ChildStdout};
use std::thread;
use std::time::Duration;

use expect_test::expect;

use crate::common::{end, interrupt, started};
use crate::program::{Run, command, jaka, scratch};
use crate::transcripts::recording;

/// A replay at work, and the options that name it.
fn serve(path: &str, options: &[&str]) -> (Child, BufReader<ChildStdout>, [String; 6]) {
    let ports = ["--commands", "0", "--status", "0"];
    let (child, out, line) = started(&mut command(["replay", path].iter().chain(&ports).chain(options)));
    let mut ports = line.split([':', ',', '\n']).filter_map(|word| word.parse::<u16>().ok());
    let mut port = || ports.next().expect("there are two").to_string();
    let robot = ["-r", "127.0.0.1", "--command-port", &port(), "--status-port", &port()].map(str::to_owned);
    (child, out, robot)
}

fn call<'a>(name: &'a str, robot: &'a [String]) -> Run {
    jaka(["call", name].into_iter().chain(robot.iter().map(String::as_str)))
}

/// A recording of one `jaka call get_version`.
fn version(name: &str) -> String {
    let path = scratch(name);
    fs::remove_file(&path).ok();
    let path = path.display().to_string();
    assert_eq!(jaka(["call", "get_version", "--sim", "--record", &path]).code, Some(0));
    path
}

/// Interrupts a replay, and returns its output after the addresses.
fn finish(child: Child, out: BufReader<ChildStdout>) -> String {
    interrupt(&child);
    rest(child, out)
}

/// Output until its end, errors and exit code.
fn rest(mut child: Child, mut out: BufReader<ChildStdout>) -> String {
    let (mut text, mut errors) = (String::new(), String::new());
    out.read_to_string(&mut text).unwrap();
    child.stderr.take().unwrap().read_to_string(&mut errors).unwrap();
    format!("{text}{errors}exit code {:?}\n", end(child).code())
}

#[test]
fn the_recorded_session_is_served() {
    let (child, out, robot) = serve(&version("serve.jsonl"), &[]);
    assert_eq!(call("get_version", &robot).text(), "version  1.5.14_13_X64\nexit code 0\n");
    assert_eq!(finish(child, out), "exit code Some(0)\n");
}

#[test]
fn another_request_than_the_recorded_one_is_reported() {
    let (child, mut out, robot) = serve(&version("deviates.jsonl"), &["--timing", "immediate"]);
    assert_eq!(call("get_joint_pos", &robot).code, Some(4));
    let mut line = String::new();
    out.read_line(&mut line).unwrap();
    expect![[r#"
        deviation: expected the recorded request `{"cmdName":"get_version"}`, but received `{"cmdName":"get_joint_pos"}`
        error: 1 deviation from the recording
        exit code Some(7)
    "#]]
    .assert_eq(&(line + &finish(child, out)));
}

#[test]
fn all_deviations_are_written_however_slow_the_reader_is() {
    let (child, out, robot) = serve(&version("slow.jsonl"), &["--mode", "matching"]);
    let mut client = TcpStream::connect(format!("127.0.0.1:{}", robot[3])).unwrap();
    // More than a pipe has room for.
    let name = "x".repeat(2000);
    for _ in 0..100 {
        write!(client, "{{\"cmdName\":\"{name}\"}}").unwrap();
        assert!(client.read(&mut [0; 1000]).unwrap() > 0, "it is answered");
    }
    interrupt(&child);
    // Before a short wait the program has no reason to give up. This makes the test slower, and never wrong.
    thread::sleep(Duration::from_millis(1500));
    let found = rest(child, out);
    assert_eq!(found.matches("deviation: ").count(), 100);
    assert!(found.ends_with("error: 100 deviations from the recording\nexit code Some(7)\n"), "{found}");
}

#[test]
fn matching_answers_in_any_order() {
    let path = recording("session.jsonl");
    let (child, out, robot) = serve(&path, &["--mode", "matching", "--timing", "immediate"]);
    assert_eq!(call("enable_robot", &robot).code, Some(2), "it is asked about");
    let yes: Vec<_> = robot.iter().cloned().chain(["--yes".to_owned()]).collect();
    assert_eq!(call("enable_robot", &yes).code, Some(1));
    assert_eq!(call("get_version", &robot).text(), "version  1.7\nexit code 0\n");
    assert_eq!(call("get_version", &robot).code, Some(1), "there is one reply");
    let found = finish(child, out);
    expect![[r#"
        deviation: the recording has no unused reply to `{"cmdName":"get_version"}`
        error: 1 deviation from the recording
        exit code Some(7)
    "#]]
    .assert_eq(&found);
}
