//! Commands that run in the test program, on arms in simulated time, so that all times in their output are exact.

mod beyond;
mod causes;
mod check;
mod document;
mod failures;
mod files;
mod follow;
mod motions;
mod numbers;
mod probe;
mod rest;
mod status;

use std::cell::RefCell;
use std::io::{self, Write};
use std::net::SocketAddr;
use std::path::PathBuf;
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};
use std::{fs, thread};

use jaka_dynamic::Node;
use jaka_sync::{Config, SimulatedClock};
use jaka_tests::Arm;
use jaka_tests::simulated::beside;
use serde_json::Value;

use crate::Cli;
use crate::builtin::of_status;
use crate::failure::Failure;
use crate::failure::command_line::is_help;
use crate::target::Target;
use crate::terminal::exit;

/// Handler of Ctrl-C, once a command has set one.
type Handler = Arc<Mutex<Option<Box<dyn FnMut() + Send>>>>;

thread_local! {
    /// Handler of this thread's command.
    static HANDLER: RefCell<Handler> = RefCell::default();
    /// Config and addresses of the robot of this thread's commands.
    static ROBOT: RefCell<Option<(Config, [String; 2])>> = const { RefCell::new(None) };
    /// Output and errors of this thread.
    static PRINTED: RefCell<[Vec<u8>; 2]> = const { RefCell::new([Vec::new(), Vec::new()]) };
}

/// Returns the status packet of this JSON.
pub(crate) fn packet(json: Value) -> Node<'static> {
    Node::status(of_status(), json)
}

/// Exit code, output and errors of a command.
#[derive(Debug)]
pub(crate) struct Run {
    pub(crate) code: u8,
    pub(crate) out: String,
    pub(crate) err: String,
}

impl Run {
    /// Returns all of it in one text, for snapshots.
    pub(crate) fn text(&self) -> String {
        format!("{}{}exit code {}\n", self.out, self.err, self.code)
    }
}

/// Runs a command on an arm.
pub(crate) fn jaka<S: AsRef<str>>(arm: &Arm, words: impl IntoIterator<Item = S>) -> Run {
    jaka_at(arm.config(), [arm.command_addr(), arm.status_addr()], words)
}

/// Runs a command on the ports at these addresses, for commands and for status packets.
pub(crate) fn jaka_at<S: AsRef<str>>(
    config: Config,
    addresses: [SocketAddr; 2],
    words: impl IntoIterator<Item = S>,
) -> Run {
    ROBOT.set(Some((config, addresses.map(|address| address.to_string()))));
    let run = without_robot(words);
    ROBOT.set(None);
    run
}

/// Runs a command that needs no robot.
pub(crate) fn without_robot<S: AsRef<str>>(words: impl IntoIterator<Item = S>) -> Run {
    let words = ["jaka".to_owned()].into_iter().chain(words.into_iter().map(|word| word.as_ref().to_owned()));
    PRINTED.take();
    let ended =
        Cli::read(&words.map(Into::into).collect::<Vec<_>>()).map_err(Failure::from).and_then(|cli| cli.command.run());
    let code = ended.err().map_or(0, |failure| {
        match &failure {
            Failure::CommandLine(error) if is_help(error) => {
                write!(stdout(), "{}", error.render()).expect("it is kept");
            }
            _ => drop(exit::report(&failure)),
        }
        exit::code(&failure)
    });
    let [out, err] = PRINTED.take().map(|bytes| String::from_utf8(bytes).expect("it prints UTF-8"));
    Run { code, out, err }
}

/// Runs a command on an arm, and presses Ctrl-C after `before`, which waits in the arm's time.
pub(crate) fn interrupted<S: AsRef<str>>(
    arm: &Arm,
    words: impl IntoIterator<Item = S>,
    before: impl FnOnce() + Send,
) -> Run {
    interrupted_and(arm, words, before, || {})
}

/// Runs a command on an arm, presses Ctrl-C after `before`, and then does `after`; both wait in the arm's time.
pub(crate) fn interrupted_and<S: AsRef<str>>(
    arm: &Arm,
    words: impl IntoIterator<Item = S>,
    before: impl FnOnce() + Send,
    after: impl FnOnce() + Send,
) -> Run {
    let handler = Handler::default();
    HANDLER.set(Arc::clone(&handler));
    let mut told = String::new();
    let press = || {
        before();
        let mut handler = handler.lock().expect("no other has panicked with it").take().expect("Ctrl-C is handled");
        handler();
        let [_, err] = PRINTED.take();
        told = String::from_utf8(err).expect("it prints UTF-8");
        after();
    };
    let run = jaka_beside(arm, press, words);
    Run { err: told + &run.err, ..run }
}

/// Runs a command on an arm while another thread runs `other`, which waits in the arm's time.
pub(crate) fn jaka_beside<S: AsRef<str>>(
    arm: &Arm,
    other: impl FnOnce() + Send,
    words: impl IntoIterator<Item = S>,
) -> Run {
    let here = arm.clock().participant();
    here.run(|| beside(arm.clock(), other, || jaka(arm, words)))
}

/// Takes the handler of Ctrl-C of this thread's command.
pub(crate) fn handle(call: impl FnMut() + Send + 'static) {
    HANDLER.with_borrow(|handler| *handler.lock().expect("no other has panicked with it") = Some(Box::new(call)));
}

/// Returns the robot of this thread's command.
pub(crate) fn target(timeout: Option<Duration>) -> Option<Target> {
    let robot = ROBOT.with_borrow(Clone::clone);
    robot.map(|(config, addresses)| Target::at(config, addresses, timeout))
}

/// Returns the current time of this thread's command.
pub(crate) fn now() -> Instant {
    let robot = |robot: &Option<(Config, _)>| robot.as_ref()?.0.get_clock().map(SimulatedClock::now);
    ROBOT.with_borrow(robot).unwrap_or_else(Instant::now)
}

/// Returns the standard output of this thread's command.
pub(crate) fn stdout() -> Printed {
    Printed(0)
}

/// Returns the standard error of this thread's command.
pub(crate) fn stderr() -> Printed {
    Printed(1)
}

/// Stream that keeps its text, without colours.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Printed(usize);

impl Printed {
    pub(crate) fn lock(self) -> Self {
        self
    }
}

impl Write for Printed {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let plain = anstream::adapter::strip_bytes(bytes).into_vec();
        PRINTED.with_borrow_mut(|printed| printed[self.0].extend(plain));
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Returns the path of a new file of this name, in the test's own folder.
pub(crate) fn scratch(name: &str) -> PathBuf {
    let test = thread::current().name().unwrap_or("unnamed").replace("::", "-");
    let folder = std::env::temp_dir().join(format!("jaka-cli-{}-{test}", std::process::id()));
    fs::create_dir_all(&folder).expect("it can be made");
    let path = folder.join(name);
    fs::remove_file(&path).ok();
    path
}
