//! Thread of a program under test.

use std::io::{self, ErrorKind};
use std::panic;
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use jaka_clock::Clock;

/// Thread of a program under test. It may hang: the wait for its end is by the system's clock, whatever the
/// controller's is.
pub(super) struct ProgramThread<T> {
    thread: JoinHandle<T>,
    /// Disconnected at the program's end.
    ended: Receiver<()>,
}

impl<T: Send + 'static> ProgramThread<T> {
    /// Starts the program, which takes part in a simulated time.
    pub(super) fn spawn(time: &Clock, program: impl FnOnce() -> T + Send + 'static) -> io::Result<Self> {
        let (running, ended) = mpsc::channel::<()>();
        let thread = thread::Builder::new().name("program under test".to_owned());
        let thread = thread.spawn(time.participating(move || {
            let _running = running;
            program()
        }))?;
        Ok(Self { thread, ended })
    }

    /// Result of the program, or its panic.
    ///
    /// # Errors
    /// [`ErrorKind::TimedOut`]: the program takes longer. It is left to itself.
    pub(super) fn join(self, limit: Duration) -> io::Result<T> {
        if self.ended.recv_timeout(limit) == Err(RecvTimeoutError::Timeout) {
            return Err(io::Error::new(ErrorKind::TimedOut, "the program under test has not ended in time"));
        }
        self.thread.join().or_else(|payload| panic::resume_unwind(payload))
    }
}
