//! Threads with a robot of their own, whose set-points go out while the program does something else.

use std::sync::mpsc::{self, SyncSender};
use std::thread::{self, JoinHandle};

use crate::clock::{Clock, HandOver};
use crate::{Error, ErrorKind, MotionStatus, Robot};

/// A thread that has a lent robot. The time at which it ends is handed over to who waits for it.
#[derive(Debug)]
pub(crate) struct ServoThread<T> {
    /// None once it has been waited for. It ends with nothing where the work does not begin.
    thread: Option<JoinHandle<(Option<T>, HandOver)>>,
    clock: Clock,
}

/// Tells the caller once that the work has begun, or why it does not begin.
pub(crate) struct Begun<B> {
    ready: SyncSender<(Result<B, Error>, HandOver)>,
    clock: Clock,
}

impl<B> Begun<B> {
    /// Whether anybody waits for it: nobody does where the caller's thread has ended.
    pub(crate) fn tell(&self, begun: Result<B, Error>) -> bool {
        self.ready.send((begun, self.clock.hand_over())).is_ok()
    }
}

impl<T: Send + 'static> ServoThread<T> {
    /// Starts the work, and waits until it has begun.
    pub(crate) fn start<S: MotionStatus, B: Send + 'static>(
        name: &str,
        mut robot: Robot<S>,
        work: impl FnOnce(&mut Robot<S>, &Begun<B>) -> Option<T> + Send + 'static,
    ) -> Result<(Self, B), Error> {
        let clock = robot.clock().clone();
        let place = clock.participant();
        let (ready, begun) = mpsc::sync_channel(1);
        let tells = Begun { ready, clock: clock.clone() };
        let spawned = thread::Builder::new().name(name.to_owned()).spawn(move || {
            let tells = tells;
            place.run(|| (work(&mut robot, &tells), robot.clock().hand_over()))
        });
        let thread = spawned.map_err(|source| Error::from(ErrorKind::Thread { source }))?;
        let mut started = Self { thread: Some(thread), clock };
        match started.clock.outside(|| begun.recv()) {
            Ok((begun, _now)) => Ok((started, begun?)),
            Err(mpsc::RecvError) => Err(started.join().err().unwrap_or_else(panicked)),
        }
    }
}

impl<T> ServoThread<T> {
    /// Whether it has not been waited for.
    pub(crate) fn runs(&self) -> bool {
        self.thread.is_some()
    }

    /// Waits for the end.
    pub(crate) fn join(&mut self) -> Result<T, Error> {
        let ended = self.thread.take().and_then(|thread| self.clock.outside(|| thread.join()).ok());
        ended.and_then(|(ended, _now)| ended).ok_or_else(panicked)
    }
}

fn panicked() -> Error {
    ErrorKind::SessionEnded { because: "its thread has panicked".to_owned() }.into()
}
