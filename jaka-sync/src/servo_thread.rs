//! Threads with a robot of their own, whose set-points go out while the program does something else.

use std::sync::Arc;
use std::time::Duration;
use std::{mem, thread};

use crate::clock::Clock;
use crate::servo_session::SessionEnd;
use crate::sync::Watched;
use crate::{Cause, Error, ErrorKind, MotionStatus, Robot};

/// A thread that has a lent robot. Who waits for it waits in the clock's time.
#[derive(Debug)]
pub(crate) struct ServoThread<T> {
    end: Arc<Mailbox<T>>,
    /// Whether its end has been waited for.
    pub(crate) was_awaited: bool,
}

/// Gives the caller once what the work has begun with, or why it does not begin.
pub(crate) type Begun<B> = Giver<Result<B, Error>>;

impl<T: Send + 'static> ServoThread<T> {
    /// Starts the work, and waits until it has begun. It ends with nothing where it does not begin.
    pub(crate) fn start<S: MotionStatus, B: Send + 'static>(
        name: &str,
        mut robot: Robot<S>,
        work: impl FnOnce(&mut Robot<S>, &Begun<B>) -> Option<T> + Send + 'static,
    ) -> Result<(Self, B), Error> {
        let clock = robot.clock().clone();
        let place = clock.participant();
        let ((begun, given), (end, ended)) = (mailbox(&clock), mailbox(&clock));
        let act = move || {
            let done = work(&mut robot, &given);
            // Who waits has the connection for itself.
            drop(robot);
            if let Some(done) = done {
                ended.give(done);
            }
        };
        let spawned = thread::Builder::new().name(name.to_owned()).spawn(move || place.run(act));
        spawned.map_err(|source| Error::from(ErrorKind::Thread { source }))?;
        let begun = begun.take().ok_or_else(panicked)??;
        Ok((Self { end, was_awaited: false }, begun))
    }

    /// Waits for the end.
    pub(crate) fn join(&mut self) -> Result<T, Error> {
        self.was_awaited = true;
        self.end.take().ok_or_else(panicked)
    }
}

fn panicked() -> Error {
    SessionEnd::new(Cause::Failed, "its thread has panicked").into_error()
}

/// What a thread gives another once.
type Mailbox<T> = Watched<Letter<T>>;

#[derive(Debug)]
enum Letter<T> {
    Awaited,
    Here(T),
    /// It was taken, or nobody gives it any more.
    Gone,
}

fn mailbox<T>(clock: &Clock) -> (Arc<Mailbox<T>>, Giver<T>) {
    let mailbox = Arc::new(Mailbox::new(clock, Letter::Awaited));
    (Arc::clone(&mailbox), Giver(mailbox))
}

impl<T> Mailbox<T> {
    /// What was given; none where the giver has ended, or it was taken.
    fn take(&self) -> Option<T> {
        let letter = self.wait_for(Duration::MAX, |letter| {
            (!matches!(letter, Letter::Awaited)).then(|| mem::replace(letter, Letter::Gone))
        });
        if let Some(Letter::Here(given)) = letter { Some(given) } else { None }
    }

    fn put(&self, letter: Letter<T>) {
        let mut place = self.lock();
        if matches!(*place, Letter::Awaited) {
            *place = letter;
        }
        drop(place);
        self.wake();
    }
}

/// Gives something once. Whoever waits for it learns where it is dropped instead, such as by a panic.
#[derive(Debug)]
pub(crate) struct Giver<T>(Arc<Mailbox<T>>);

impl<T> Giver<T> {
    pub(crate) fn give(&self, given: T) {
        self.0.put(Letter::Here(given));
    }
}

impl<T> Drop for Giver<T> {
    fn drop(&mut self) {
        self.0.put(Letter::Gone);
    }
}

/// Does this when it is dropped, also by a panic.
pub(crate) struct OnDrop<F: Fn()>(pub(crate) F);

impl<F: Fn()> Drop for OnDrop<F> {
    fn drop(&mut self) {
        (self.0)();
    }
}
