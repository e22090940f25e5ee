//! Threads that own an arm and send set-points while the program does something else.

use std::sync::Arc;
use std::time::Duration;
use std::{mem, thread};

use jaka_clock::Clock;
use jaka_sync::layer::Watched;

use crate::error::SessionEnd;
use crate::servo_session::LentArm;
use crate::{Cause, Error, ErrorKind};

/// A thread that has a lent arm. The wait for its end runs in the clock's time.
#[derive(Debug)]
pub(crate) struct ServoThread<T> {
    end: Arc<OneShot<T>>,
    /// True if its end has been waited for.
    pub(crate) was_awaited: bool,
}

/// Sender of the result of the beginning, or of its error.
pub(crate) type Begun<B> = Sender<Result<B, Error>>;

impl<T: Send + 'static> ServoThread<T> {
    /// Starts the work, and waits for its beginning. Without one, the work ends without a result.
    pub(crate) fn start<B: Send + 'static>(
        name: &str,
        mut lent: LentArm,
        work: impl FnOnce(&mut LentArm, &Begun<B>) -> Option<T> + Send + 'static,
    ) -> Result<(Self, B), Error> {
        let clock = lent.arm.clock().clone();
        let ((begun, given), (end, ended)) = (one_shot(&clock), one_shot(&clock));
        let act = move || {
            let done = work(&mut lent, &given);
            // A caller that waits has the connection for itself.
            drop(lent);
            if let Some(done) = done {
                ended.send(done);
            }
        };
        let spawned = thread::Builder::new().name(name.to_owned()).spawn(clock.participating(act));
        spawned.map_err(|source| Error::from(ErrorKind::Thread { source }))?;
        let begun = begun.receive().ok_or_else(panicked)??;
        Ok((Self { end, was_awaited: false }, begun))
    }

    /// Waits for the end.
    pub(crate) fn join(&mut self) -> Result<T, Error> {
        self.was_awaited = true;
        self.end.receive().ok_or_else(panicked)
    }
}

fn panicked() -> Error {
    SessionEnd::new(Cause::Failed, "its thread has panicked").into_error()
}

/// One-shot channel: one thread sends a value, another waits for it.
#[derive(Debug)]
struct OneShot<T>(Watched<Slot<T>>);

#[derive(Debug)]
enum Slot<T> {
    Pending,
    Sent(T),
    /// The value was taken, or the sender was dropped.
    Closed,
}

fn one_shot<T>(clock: &Clock) -> (Arc<OneShot<T>>, Sender<T>) {
    let channel = Arc::new(OneShot(Watched::new(clock, Slot::Pending)));
    (Arc::clone(&channel), Sender(channel))
}

impl<T> OneShot<T> {
    /// Waits for the value; `None` if the sender was dropped before, or the value was taken.
    fn receive(&self) -> Option<T> {
        let slot = self
            .0
            .wait_for(Duration::MAX, |slot| (!matches!(slot, Slot::Pending)).then(|| mem::replace(slot, Slot::Closed)));
        if let Some(Slot::Sent(value)) = slot { Some(value) } else { None }
    }

    fn fill(&self, with: Slot<T>) {
        let mut slot = self.0.lock();
        if matches!(*slot, Slot::Pending) {
            *slot = with;
        }
        drop(slot);
        self.0.wake();
    }
}

/// Sender of a one-shot channel. The receiver notices a drop without a value, such as by a panic.
#[derive(Debug)]
pub(crate) struct Sender<T>(Arc<OneShot<T>>);

impl<T> Sender<T> {
    pub(crate) fn send(&self, value: T) {
        self.0.fill(Slot::Sent(value));
    }
}

impl<T> Drop for Sender<T> {
    fn drop(&mut self) {
        self.0.fill(Slot::Closed);
    }
}
