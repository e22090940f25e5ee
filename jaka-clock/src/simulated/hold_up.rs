//! Threads that are held up, as a scheduler does it.

use std::cell::Cell;
use std::sync::{Mutex, PoisonError};
use std::thread;

thread_local! {
    /// True after a sleep, until the next reading of the clock.
    static HAS_SLEPT: Cell<bool> = const { Cell::new(false) };
}

/// Acts of threads between two of their instructions, by the names of the threads.
#[derive(Default)]
pub(super) struct HoldUps(Mutex<Vec<HoldUp>>);

struct HoldUp {
    thread: String,
    act: Box<dyn FnOnce() + Send>,
}

impl HoldUps {
    pub(super) fn add(&self, thread: &str, act: impl FnOnce() + Send + 'static) {
        self.lock().push(HoldUp { thread: thread.to_owned(), act: Box::new(act) });
    }

    /// Records that this thread has read the clock. The first time after a sleep, the first hold-up that is meant for
    /// it takes place.
    pub(super) fn has_read(&self) {
        if !HAS_SLEPT.replace(false) {
            return;
        }
        let mut hold_ups = self.lock();
        let this = thread::current();
        let place = hold_ups.iter().position(|hold_up| this.name() == Some(&*hold_up.thread));
        let hold_up = place.map(|place| hold_ups.remove(place));
        drop(hold_ups);
        if let Some(hold_up) = hold_up {
            (hold_up.act)();
        }
    }

    fn lock(&self) -> std::sync::MutexGuard<'_, Vec<HoldUp>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Records that this thread has slept.
pub(super) fn has_slept() {
    HAS_SLEPT.set(true);
}
