//! Ctrl-C, and the signals by which a system ends programs.

use std::io;
use std::io::stdout;
use std::sync::mpsc::{self, RecvTimeoutError};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;
use std::{process, thread};

use jaka_robot::{FollowHandle, RobotStop};

use crate::failure::{Failure, fact, not_taken};
use crate::recordings::record;
use crate::terminal::{exit, logging, output, raw};

/// Patience with a program that is about to end, where it ends with the same code.
const PATIENCE: Duration = Duration::from_secs(1);

/// Patience with a program that writes what it has before it ends.
const LONG_PATIENCE: Duration = Duration::from_secs(60);

/// Time within which a controller usually answers a stop.
const SOON: Duration = Duration::from_millis(500);

/// Calls `call` on the first Ctrl-C, and on the signals by which a system ends programs. It makes the program end with
/// all that is left to write. A further one, or a minute, ends the program with success.
pub(crate) fn on_interrupt(call: impl FnOnce() + Send + 'static) {
    let mut call = Some(call);
    handle(move || match call.take() {
        Some(call) => {
            call();
            thread::spawn(|| {
                thread::sleep(LONG_PATIENCE);
                end(0);
            });
        }
        None => end(0),
    });
}

/// Calls `call` on the first Ctrl-C; a further one ends the program at once.
pub(crate) fn on_first_interrupt(call: impl FnOnce() + Send + 'static) {
    let mut call = Some(call);
    handle(move || match call.take() {
        Some(call) => call(),
        None => end(exit::INTERRUPTED),
    });
}

/// Ends the program with this code on Ctrl-C, but not in the middle of what it writes.
pub(crate) fn end_on_interrupt(code: u8) {
    handle(move || {
        // Not here, since the reader of the output may never continue.
        thread::spawn(move || end_whole(code));
        thread::sleep(PATIENCE);
        end(code);
    });
}

/// Ends the program with this code, but not in the middle of what it writes.
pub(crate) fn end_whole(code: u8) -> ! {
    let _whole = stdout().lock();
    end(code)
}

/// Stage of the requests to the robot, for the handler of Ctrl-C. On Ctrl-C, the program prints the meaning of the
/// stage, and stops a motion that it waits for.
#[derive(Debug, Clone, Default)]
pub(crate) struct UnderWay(Arc<Mutex<Stage>>);

/// Stage of the requests to the robot.
#[derive(Debug, Default)]
pub(crate) enum Stage {
    #[default]
    NothingSent,
    /// This may have been sent, such as "`power_on` or `enable_robot`", and nothing is known of it.
    Sent(String),
    /// One step goes out after the other, until this is called.
    Steps(RobotStop),
    /// A motion goes out, or is waited for, which this stops.
    Moving(RobotStop),
    /// A trajectory is followed: first it is stopped along it, then as a motion.
    Following(FollowHandle, RobotStop),
    /// All that was sent has been answered, and the program ends.
    Answered,
    /// All that was sent has been answered, and the next request is awaited.
    Idle,
}

impl UnderWay {
    /// Handles Ctrl-C from now on.
    pub(crate) fn begin() -> Self {
        let under_way = Self::default();
        let handled = under_way.clone();
        handle(move || handled.interrupt());
        under_way
    }

    /// Sets the stage. If a stop is on its way, waits until its outcome has been printed.
    pub(crate) fn set(&self, stage: Stage) {
        *self.lock() = stage;
    }

    fn interrupt(&self) {
        // Kept until all is said.
        let mut stage = self.lock();
        match &*stage {
            Stage::NothingSent => end_with(exit::INTERRUPTED, "interrupted; nothing was sent that changes anything"),
            Stage::Sent(what) => end_with(
                exit::MAY_HAVE_RUN,
                &format!("interrupted: {what} may have run; check the robot's state before you go on"),
            ),
            Stage::Steps(stop) => {
                stop_steps(stop);
                *stage = Stage::Sent("what was sent".to_owned());
            }
            Stage::Moving(stop) => stop_arm(stop),
            Stage::Idle => end_with(exit::INTERRUPTED, "interrupted; no command is outstanding"),
            Stage::Following(handle, stop) => {
                // Where it has ended by itself, that is told.
                if handle.stop().is_ok() {
                    output::urgent_note(
                        "interrupted: the arm stops on its trajectory; interrupt again to send `stop_program`, too",
                    );
                }
                let stop = stop.clone();
                *stage = Stage::Moving(stop);
            }
            // The program is about to end, unless the reader of its output never continues.
            Stage::Answered => {
                drop(stage);
                thread::sleep(PATIENCE);
                end(exit::INTERRUPTED)
            }
        }
    }

    /// Every change is made whole before the lock is left.
    fn lock(&self) -> MutexGuard<'_, Stage> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Keeps further steps back. The call that sends them says which were accepted, once those that went out have been
/// answered.
fn stop_steps(stop: &RobotStop) {
    output::urgent_note("interrupted: no further step is sent");
    // A controller may answer it only after the step before. Without an answer, too, no step follows.
    stop.stop().ok();
}

/// Stops the arm, and says whether the controller has taken the stop. If it has, the wait for the motion ends.
fn stop_arm(stop: &RobotStop) {
    let (answered, waiting) = mpsc::channel::<()>();
    thread::spawn(move || {
        if waiting.recv_timeout(SOON) == Err(RecvTimeoutError::Timeout) {
            output::urgent_note("interrupted: the stop has no answer yet; if the arm goes on, use the emergency stop");
        }
    });
    let stopped = stop.stop();
    drop(answered);
    match stopped {
        Ok(()) => output::urgent_note("interrupted: the controller has taken the stop (`stop_program`)"),
        Err(error) => end_with(
            exit::NOT_STOPPED,
            &format!("interrupted, but {}: {}", not_taken(error.may_have_run()), fact(error.kind(), &error)),
        ),
    }
}

/// The handler of a command that runs in a test is called by the test.
#[cfg(test)]
fn handle(call: impl FnMut() + Send + 'static) {
    crate::tests::handle(call);
}

#[cfg(not(test))]
fn handle(call: impl FnMut() + Send + 'static) {
    *handler() = Some(Box::new(call));
}

/// Handler of signals, once a command has set one.
static HANDLER: Mutex<Option<Box<dyn FnMut() + Send>>> = Mutex::new(None);

fn handler() -> MutexGuard<'static, Option<Box<dyn FnMut() + Send>>> {
    HANDLER.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Catches signals from now on. Until a command says what they mean to it, they end the program.
pub(crate) fn begin() -> Result<(), Failure> {
    let signalled = || match &mut *handler() {
        Some(call) => call(),
        None => end(exit::INTERRUPTED),
    };
    ctrlc::set_handler(signalled).map_err(|error| Failure::local("cannot catch Ctrl-C", io::Error::other(error)))
}

fn end_with(code: u8, text: &str) -> ! {
    output::error(text);
    end(code)
}

/// Ends the program, with another code if what it recorded cannot be written.
fn end(code: u8) -> ! {
    raw::end();
    logging::finish();
    if let Err(failure) = record::finish() {
        exit::report(&failure);
        process::exit(exit::LOCAL.into());
    }
    process::exit(code.into())
}
