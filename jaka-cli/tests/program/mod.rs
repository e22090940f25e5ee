//! Runs the program with input, options made from controllers, and its results as text.

use std::ffi::OsStr;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::{fs, thread};

use jaka_sim::Controller;

use crate::common;

/// Result of a run.
#[derive(Debug)]
pub(crate) struct Run {
    /// The exit code.
    pub(crate) code: Option<i32>,
    /// Standard output.
    pub(crate) out: String,
    /// Standard error.
    pub(crate) err: String,
}

impl Run {
    /// Exit code, output and errors in one text, for snapshots.
    pub(crate) fn text(&self) -> String {
        format!("{}{}exit code {}\n", self.out, self.err, self.code.unwrap_or(-1))
    }
}

/// The words of a command line; those between single quotes are one.
pub(crate) fn words(line: &str) -> Vec<&str> {
    let parts = line.split('\'').enumerate();
    parts.flat_map(|(at, part)| if at % 2 == 1 { vec![part] } else { part.split_whitespace().collect() }).collect()
}

/// The program with these arguments.
pub(crate) fn command<S: AsRef<OsStr>>(arguments: impl IntoIterator<Item = S>) -> Command {
    let mut command = common::jaka(&[]);
    command.args(arguments);
    command
}

/// Runs the program without input.
pub(crate) fn jaka<S: AsRef<OsStr>>(arguments: impl IntoIterator<Item = S>) -> Run {
    run(command(arguments), "")
}

/// Runs the program with this on standard input.
pub(crate) fn run(mut command: Command, input: &str) -> Run {
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().expect("the program starts");
    // It need not read its input.
    let _ = child.stdin.take().expect("it is piped").write_all(input.as_bytes());
    result(child)
}

/// Result of a run whose output is piped.
pub(crate) fn result(child: Child) -> Run {
    let (out, err, code) = common::ended(child);
    Run { code, out, err }
}

/// The options that name a controller.
pub(crate) fn address_of(controller: &Controller) -> Vec<String> {
    let (commands, status) = (controller.command_addr(), controller.status_addr());
    let words = format!("--robot {} --command-port {} --status-port {}", commands.ip(), commands.port(), status.port());
    words.split(' ').map(str::to_owned).collect()
}

/// The program at work on a controller, with a line of words; its output is piped.
pub(crate) fn started_at(controller: &Controller, line: &str) -> Child {
    let mut command = command(line.split(' ').map(str::to_owned).chain(address_of(controller)));
    command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the program starts")
}

/// Waits until a motion of the joints comes.
pub(crate) fn wait_for_motion(controller: &Controller) {
    common::wait_until("a motion comes", || controller.requests().iter().any(|request| request.contains("joint_move")));
}

/// Text of a run that has stopped the arm, without the lines that a slow machine causes: no reply to the stop yet, no
/// rest yet.
pub(crate) fn without_late_answer(run: &Run) -> String {
    let late =
        ["note: interrupted: no reply to the stop yet", "warning: it is not known whether", "warning: the arm still"];
    let is_late = |line: &&str| late.iter().any(|late| line.starts_with(late));
    run.text().split_inclusive('\n').filter(|line| !is_late(line)).collect()
}

/// A pack of the workspace's tests.
pub(crate) fn pack(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/pack-user");
    folder.join(name).display().to_string()
}

/// A file of this name that a test may write, in a folder of the test's own: other tests use the same names at the same
/// time.
pub(crate) fn scratch(name: &str) -> PathBuf {
    let test = thread::current().name().unwrap_or("unnamed").replace("::", "-");
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(test);
    fs::create_dir_all(&folder).unwrap();
    folder.join(name)
}
