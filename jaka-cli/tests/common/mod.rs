//! Runs the program, away from the user's own environment.

use std::io::{self, BufRead, BufReader, ErrorKind, Read};
use std::net::TcpStream;
use std::path::PathBuf;
use std::process::{Child, ChildStdout, Command, ExitStatus, Stdio};
use std::sync::mpsc::{self, RecvTimeoutError, Sender};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use jaka_tests::LONG;

/// Limit for a run: longer than any takes, and than the program waits for a robot of the tests.
const LIMIT: Duration = Duration::from_secs(120);

/// The program with these arguments.
pub(crate) fn jaka(args: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_jaka"));
    leave_the_user(command.args(args).stdin(Stdio::null()));
    command
}

/// Away from the user's own environment, and patient with simulated arms.
pub(crate) fn leave_the_user(command: &mut Command) {
    let nowhere = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("nowhere");
    command.env("HOME", &nowhere).env("JAKA_CONFIG", concat!(env!("CARGO_MANIFEST_DIR"), "/tests/patient.toml"));
    for name in ["JAKA_ROBOT", "JAKA_PACK", "XDG_CONFIG_HOME", "APPDATA", "NO_COLOR", "CLICOLOR", "CLICOLOR_FORCE"] {
        command.env_remove(name);
    }
}

/// Ends a program that runs for too long, so that nobody waits for it for ever.
#[derive(Debug)]
pub(crate) struct Watchdog {
    done: Sender<()>,
    thread: JoinHandle<bool>,
}

impl Watchdog {
    pub(crate) fn watch(child: &Child) -> Self {
        let (done, ended) = mpsc::channel();
        let id = child.id().to_string();
        let thread = thread::spawn(move || {
            let is_late = ended.recv_timeout(LIMIT) == Err(RecvTimeoutError::Timeout);
            is_late && Command::new("kill").args(["-KILL", &id]).status().is_ok_and(|status| status.success())
        });
        Self { done, thread }
    }

    /// True if it had to end the program. To be called before that can be forgotten by the system.
    pub(crate) fn has_bitten(self) -> bool {
        drop(self.done);
        self.thread.join().expect("it does not panic")
    }
}

/// Runs the program. Returns its standard output, its standard error and its exit code.
pub(crate) fn output(command: &mut Command) -> (String, String, Option<i32>) {
    ended(command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the program starts"))
}

/// Output, errors and exit code of a program at work whose output is piped.
pub(crate) fn ended(child: Child) -> (String, String, Option<i32>) {
    let watchdog = Watchdog::watch(&child);
    let output = child.wait_with_output().expect("it is a child");
    let [out, err] =
        [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).expect("the program writes UTF-8"));
    assert!(!watchdog.has_bitten(), "the program does not end within {LIMIT:?}; it has printed {out:?} and {err:?}");
    (out, err, output.status.code())
}

/// Reads what has come. A read that has a timeout is interrupted where its process is stopped and goes on.
pub(crate) fn read(mut stream: &TcpStream, room: &mut [u8]) -> io::Result<usize> {
    loop {
        match stream.read(room) {
            Err(error) if error.kind() == ErrorKind::Interrupted => {}
            done => return done,
        }
    }
}

/// Waits until something is so that the program or the arm brings about.
pub(crate) fn wait_until(what: &str, mut is_so: impl FnMut() -> bool) {
    let since = Instant::now();
    while !is_so() {
        assert!(since.elapsed() < LONG, "not in {LONG:?}: {what}");
        // This makes a test slower, and never wrong.
        thread::sleep(Duration::from_millis(5));
    }
}

/// Runs the program, which prints nothing on standard output. Returns its standard error and its exit code.
pub(crate) fn failure(command: &mut Command) -> String {
    let (stdout, stderr, code) = output(command);
    assert_eq!(stdout, "");
    format!("{stderr}exit code {code:?}")
}

/// The program at work, and the first line that it printed.
pub(crate) fn started(command: &mut Command) -> (Child, BufReader<ChildStdout>, String) {
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let watchdog = Watchdog::watch(&child);
    let mut out = BufReader::new(child.stdout.take().unwrap());
    let mut line = String::new();
    out.read_line(&mut line).unwrap();
    assert!(!watchdog.has_bitten(), "the program prints nothing within {LIMIT:?}");
    (child, out, line)
}

/// Presses Ctrl-C.
#[cfg(unix)]
pub(crate) fn interrupt(child: &Child) {
    let killed = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(killed.success());
}

/// Exit status of a program at work.
pub(crate) fn end(mut child: Child) -> ExitStatus {
    let watchdog = Watchdog::watch(&child);
    let status = child.wait().expect("it is a child");
    assert!(!watchdog.has_bitten(), "the program does not end within {LIMIT:?}");
    status
}
