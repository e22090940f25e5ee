//! The program on a terminal of its own, as `script` of util-linux gives it one.

#![cfg(target_os = "linux")]

use std::io::Write;
use std::process::{Child, Command, Stdio};

use crate::common::{ended, leave_the_user};

/// The program.
pub(crate) const JAKA: &str = env!("CARGO_BIN_EXE_jaka");

/// A script of a shell on a terminal, which is its standard input, output and error. What it shows comes out of the
/// command, and what comes in is typed.
pub(crate) fn terminal(script: &str) -> Command {
    let line = format!("stty rows 40 cols 120; {script}");
    let mut command = Command::new("script");
    command.args(["--quiet", "--return", "--flush", "--echo", "never", "--command", &line, "/dev/null"]);
    leave_the_user(&mut command);
    command.env("NO_COLOR", "1").env("SHELL", "/bin/sh").env("TERM", "xterm").stdin(Stdio::piped());
    command
}

/// The command at work; `None` if the machine has no `script` of util-linux, which is told.
pub(crate) fn started(mut command: Command) -> Option<Child> {
    let started = command.spawn();
    if started.is_err() {
        jaka_tests::skipped("what the program does on a terminal", "`script` of util-linux is missing");
    }
    started.ok()
}

/// Runs the program on a terminal where this is typed. Returns the text that it shows, and its exit code.
pub(crate) fn on_terminal(line: &str, typed: &str) -> Option<(String, Option<i32>)> {
    let mut command = terminal(&format!("exec '{JAKA}' {line}"));
    command.stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = started(command)?;
    child.stdin.take().expect("it is piped").write_all(typed.as_bytes()).expect("it is read");
    let (shown, _, code) = ended(child);
    Some((shown.replace("\r\n", "\n"), code))
}
