//! The program on a terminal of its own.

use std::io::Write;
use std::process::{Child, Command, Stdio};

use crate::common::leave_the_user;

/// The program at work on a terminal; none where the machine has no `script` of util-linux, which is told. Its standard input is what is typed.
pub(crate) fn start_on_terminal(line: &str) -> Option<Child> {
    let line = format!("stty rows 40 cols 120; exec '{}' {line}", env!("CARGO_BIN_EXE_jaka"));
    let mut command = Command::new("script");
    command.args(["--quiet", "--return", "--flush", "--echo", "never", "--command", &line, "/dev/null"]);
    leave_the_user(&mut command);
    command.env("NO_COLOR", "1").env("SHELL", "/bin/sh").env("TERM", "xterm");
    let started = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn();
    if started.is_err() {
        jaka_tests::skipped("what the program does on a terminal", "`script` of util-linux is missing");
    }
    started.ok()
}

/// What the program shows where this is typed, and its exit code.
pub(crate) fn on_terminal(line: &str, typed: &str) -> Option<(String, Option<i32>)> {
    let mut child = start_on_terminal(line)?;
    child.stdin.take().expect("it is piped").write_all(typed.as_bytes()).expect("it is read");
    let output = child.wait_with_output().expect("it ends");
    let shown = String::from_utf8(output.stdout).expect("it writes UTF-8").replace("\r\n", "\n");
    Some((shown, output.status.code()))
}
