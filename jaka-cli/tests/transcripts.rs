//! Lines of commands with what they print: `transcripts/*.txt`.
//!
//! Each line there that begins with `$ jaka ` is run as it stands, in that folder, and what the program prints follows
//! it, then its exit code. A new case is such a line: `UPDATE_EXPECT=1 cargo test -p jaka-cli --test suite transcripts`
//! writes the rest. Lines that begin with `# ` stay.

use std::fs;
use std::path::Path;

use expect_test::expect_file;

use crate::program::{command, jaka, run, words};

/// Runs the lines of a transcript by `printed`, and compares the file. Compares nothing if a line cannot be run.
pub(crate) fn check(name: &str, printed: impl Fn(&str) -> Option<String>) {
    let path = folder().join(name);
    let text = fs::read_to_string(&path).expect("the transcript is there");
    let mut parts = Vec::new();
    for line in text.lines() {
        if let Some(words) = line.strip_prefix("$ jaka ") {
            let Some(printed) = printed(words) else { return };
            parts.push(format!("{line}\n{printed}"));
        } else if line.starts_with("# ") {
            parts.push(format!("{line}\n"));
        }
    }
    assert!(!parts.is_empty(), "{name} has lines");
    expect_file![path].assert_eq(&parts.join("\n"));
}

fn folder() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/transcripts"))
}

/// A recording of the folder.
pub(crate) fn recording(name: &str) -> String {
    folder().join(name).display().to_string()
}

/// Output of the program for these words, which quotes hold together as in a shell.
fn printed(line: &str) -> String {
    let mut command = command(words(line));
    command.current_dir(folder());
    run(command, "").text()
}

fn check_printed(name: &str) {
    check(name, |line| Some(printed(line)));
}

#[test]
fn calls_are_checked_before_they_are_sent() {
    check_printed("call_requests.txt");
}

#[test]
fn what_no_arm_does_is_refused() {
    check_printed("no_arm_does.txt");
}

#[test]
fn replies_are_shown_by_the_spec() {
    check_printed("call_replies.txt");
}

#[test]
fn packs_change_calls() {
    check_printed("call_packs.txt");
}

#[test]
fn what_is_wrong_on_a_line_has_one_form() {
    check_printed("mistakes.txt");
}

#[test]
fn status_has_a_table() {
    check_printed("status.txt");
}

#[test]
fn codes_and_refusals_are_explained() {
    check_printed("explain.txt");
}

#[test]
fn helps_say_what_commands_do() {
    check_printed("help.txt");
    assert_eq!(jaka(["call"]).out, jaka(["call", "--list"]).out);
    assert!(jaka(["--version"]).out.starts_with("jaka "));
}

#[test]
fn recordings_are_shown_and_exported() {
    check_printed("recordings.txt");
}

#[test]
fn specs_and_packs_are_checked_and_compared() {
    check_printed("spec.txt");
}
