//! Thread of a program under test.

use std::io::{self, ErrorKind};
use std::panic;
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use jaka_clock::Clock;

/// Thread of a program under test. It may hang, so the wait for its end uses the system's clock, with any clock of the
/// controller.
pub(super) struct ProgramThread<T> {
    thread: JoinHandle<T>,
    /// Receiver that disconnects at the end of the program.
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

    /// Returns the result of the program, or resumes its panic.
    ///
    /// # Errors
    /// [`ErrorKind::TimedOut`] if the program takes longer; its thread continues.
    pub(super) fn join(self, limit: Duration) -> io::Result<T> {
        if self.ended.recv_timeout(limit) == Err(RecvTimeoutError::Timeout) {
            return Err(io::Error::new(ErrorKind::TimedOut, "the program under test has not ended in time"));
        }
        self.thread.join().or_else(|payload| panic::resume_unwind(payload))
    }
}
