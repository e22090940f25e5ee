//! Runs the program, away from the user's own environment.

use std::io::{BufRead, BufReader};
use std::path::PathBuf;
use std::process::{Child, ChildStdout, Command, ExitStatus, Output, Stdio};
use std::sync::mpsc;
use std::thread;
use std::time::Duration;

/// Longer than anything takes.
const LONG: Duration = Duration::from_secs(60);

/// The program with these arguments.
pub(crate) fn jaka(args: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_jaka"));
    leave_the_user(command.args(args).stdin(Stdio::null()));
    command
}

/// Away from the user's own environment.
pub(crate) fn leave_the_user(command: &mut Command) {
    let nowhere = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("nowhere");
    command.env("HOME", &nowhere);
    for name in [
        "JAKA_ROBOT",
        "JAKA_CONFIG",
        "JAKA_PACK",
        "XDG_CONFIG_HOME",
        "APPDATA",
        "NO_COLOR",
        "CLICOLOR",
        "CLICOLOR_FORCE",
    ] {
        command.env_remove(name);
    }
}

/// What it printed on standard output, on standard error, and its exit code.
pub(crate) fn output(command: &mut Command) -> (String, String, Option<i32>) {
    let Output { status, stdout, stderr } = command.output().unwrap();
    (String::from_utf8(stdout).unwrap(), String::from_utf8(stderr).unwrap(), status.code())
}

/// What it printed on standard error, and its exit code.
#[allow(dead_code, reason = "not every test file needs it")]
pub(crate) fn failure(command: &mut Command) -> String {
    let (stdout, stderr, code) = output(command);
    assert_eq!(stdout, "");
    format!("{stderr}exit code {code:?}")
}

/// The program at work, and the first line that it printed.
#[allow(dead_code, reason = "not every test file needs it")]
pub(crate) fn started(command: &mut Command) -> (Child, BufReader<ChildStdout>, String) {
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let mut out = BufReader::new(child.stdout.take().unwrap());
    let mut line = String::new();
    out.read_line(&mut line).unwrap();
    (child, out, line)
}

/// Presses Ctrl-C.
#[cfg(unix)]
#[allow(dead_code, reason = "not every test file needs it")]
pub(crate) fn interrupt(child: &Child) {
    let killed = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(killed.success());
}

/// How it ended, which must be soon.
#[allow(dead_code, reason = "not every test file needs it")]
pub(crate) fn end(mut child: Child) -> ExitStatus {
    let (sender, ended) = mpsc::channel();
    thread::spawn(move || sender.send(child.wait().unwrap()));
    ended.recv_timeout(LONG).expect("the program ends")
}
