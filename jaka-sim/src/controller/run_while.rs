//! A program under test, and what its test does with the controller meanwhile.

use std::io::{self, ErrorKind};
use std::panic;
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use super::Controller;

impl Controller {
    /// Runs a program in a thread of its own while this thread does something with the controller, and returns what the
    /// program returns when both have ended.
    ///
    /// The program may take `limit` after this thread is ready, in real time whatever the clock is; one that takes
    /// longer is left to itself. With a [simulated clock](crate::Builder::clock) both begin at the same time.
    ///
    /// ```
    /// use std::io::{Read, Write};
    /// use std::net::TcpStream;
    /// use std::time::Duration;
    ///
    /// use jaka_sim::{Controller, Fault};
    ///
    /// let controller = Controller::start()?;
    /// controller.inject(Fault::Hold);
    /// let limit = Duration::from_secs(60);
    /// let mut client = TcpStream::connect(controller.command_addr())?;
    /// let program = move || {
    ///     client.write_all(br#"{"cmdName": "get_version"}"#)?;
    ///     client.read(&mut [0; 200])
    /// };
    /// let read = controller.run_while(limit, program, |controller| {
    ///     assert!(controller.wait_for_requests(1, limit));
    ///     controller.release();
    /// });
    /// assert!(read?? > 0);
    /// # Ok::<(), std::io::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ErrorKind::TimedOut`] if the program takes longer; or a thread cannot be started.
    ///
    /// # Panics
    /// The program panics: with the same payload.
    pub fn run_while<T: Send + 'static>(
        &self,
        limit: Duration,
        program: impl FnOnce() -> T + Send + 'static,
        meanwhile: impl FnOnce(&Self),
    ) -> io::Result<T> {
        let time = self.shared.time();
        // This thread takes part in a simulated time before the program's does.
        let run = time.participating(|| {
            let (running, ended) = mpsc::channel::<()>();
            let thread = thread::Builder::new().name("program under test".to_owned());
            let thread = thread.spawn(time.participating(move || {
                let _running = running;
                program()
            }))?;
            meanwhile(self);
            time.outside(|| end(thread, &ended, limit))
        });
        run()
    }
}

/// What a thread returns, which drops the other end of the channel when it ends.
fn end<T>(thread: JoinHandle<T>, ended: &Receiver<()>, limit: Duration) -> io::Result<T> {
    if ended.recv_timeout(limit) == Err(RecvTimeoutError::Timeout) {
        return Err(io::Error::new(ErrorKind::TimedOut, "the program under test has not ended in time"));
    }
    thread.join().or_else(|payload| panic::resume_unwind(payload))
}
