//! Ctrl-C, and the signals with which a system ends programs.

use std::io;
use std::io::stdout;
use std::sync::mpsc::{self, RecvTimeoutError};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;
use std::{mem, process, thread};

use jaka_robot::{FollowHandle, RobotStop};

use crate::failure::{Failure, fact, not_taken};
use crate::recordings::record;
use crate::terminal::{exit, logging, output};

/// Time for a program to end by itself, if it ends with the same code.
const PATIENCE: Duration = Duration::from_secs(1);

/// Time for a program to write its results before it ends.
const LONG_PATIENCE: Duration = Duration::from_secs(60);

/// Time within which a controller usually answers a stop.
const SOON: Duration = Duration::from_millis(500);

/// Calls `call` on the first Ctrl-C, and on the signals with which a system ends programs. The call makes the program
/// write its results and end. A further signal, or a minute, ends the program with success.
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

/// Ends the program with this code on Ctrl-C, but not in the middle of its output.
pub(crate) fn end_on_interrupt(code: u8) {
    handle(move || {
        // Uses another thread, since the reader of the output may never continue.
        thread::spawn(move || {
            let _whole = stdout().lock();
            end(code)
        });
        thread::sleep(PATIENCE);
        end(code);
    });
}

/// Stage of the requests to the robot, for the handler of Ctrl-C. On Ctrl-C, the program prints the meaning of the
/// stage, and stops a motion that it waits for.
#[derive(Debug, Clone, Default)]
pub(crate) struct UnderWay(Arc<Mutex<Progress>>);

#[derive(Debug, Default)]
struct Progress {
    stage: Stage,
    /// True if Ctrl-C has stopped the arm: a stop was sent, or the arm is braked along a trajectory.
    is_stopped: bool,
}

/// Stage of the requests to the robot.
#[derive(Debug, Default)]
pub(crate) enum Stage {
    #[default]
    NothingSent,
    /// These requests may have been sent, such as "`power_on` or `enable_robot`", with unknown results.
    Sent(String),
    /// Steps go out one after the other, until this handle stops them.
    Steps(RobotStop),
    /// A motion goes out, or the program waits for its end; this handle stops it.
    Moving(RobotStop),
    /// A trajectory is followed: Ctrl-C first stops it along its path, then as a motion.
    Following(FollowHandle, RobotStop),
    /// The controller has accepted the stop of `jaka stop`, which waits until the arm is at rest.
    Stopped,
    /// All requests have been answered, and the program ends.
    Answered,
    /// All requests have been answered, and the program waits for the next one.
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

    /// Sets the stage. During a stop, waits until its outcome has been printed.
    pub(crate) fn set(&self, stage: Stage) {
        self.lock().stage = stage;
    }

    /// True if Ctrl-C has stopped the arm.
    pub(crate) fn is_stopped(&self) -> bool {
        self.lock().is_stopped
    }

    /// Ends the requests, unless Ctrl-C has stopped the arm since the last call: true then. The arm may still brake,
    /// and a further Ctrl-C stops it again.
    pub(crate) fn finish(&self) -> bool {
        let mut progress = self.lock();
        let is_stopped = mem::take(&mut progress.is_stopped);
        if !is_stopped {
            progress.stage = Stage::Answered;
        }
        is_stopped
    }

    fn interrupt(&self) {
        // Keeps the lock until the text is printed.
        let mut progress = self.lock();
        let Progress { stage, is_stopped } = &mut *progress;
        match stage {
            Stage::NothingSent => end_with(exit::INTERRUPTED, "interrupted; no command that changes anything was sent"),
            Stage::Sent(what) => end_with(
                exit::MAY_HAVE_RUN,
                &format!("interrupted: {what} may have run; check the robot's state before you go on"),
            ),
            Stage::Steps(stop) => {
                stop_steps(stop);
                *is_stopped = true;
                *stage = Stage::Sent("the steps already sent".to_owned());
            }
            Stage::Moving(stop) => {
                stop_arm(stop);
                *is_stopped = true;
            }
            Stage::Stopped => end_with(
                exit::NOT_STOPPED,
                "interrupted; the arm was not seen at rest and may still move, use the emergency stop",
            ),
            Stage::Idle => end_with(exit::INTERRUPTED, "interrupted; no command is outstanding"),
            Stage::Following(handle, stop) => {
                // If the trajectory has ended by itself, the command reports that.
                if handle.stop().is_ok() {
                    output::urgent_note(
                        "interrupted: the arm stops on its trajectory; interrupt again to send `stop_program`, too",
                    );
                }
                *is_stopped = true;
                *stage = Stage::Moving(stop.clone());
            }
            // The program is about to end, unless the reader of its output never continues.
            Stage::Answered => {
                drop(progress);
                thread::sleep(PATIENCE);
                end(exit::INTERRUPTED)
            }
        }
    }

    /// Locks the stage, also after a panic: each change completes before the lock is released.
    fn lock(&self) -> MutexGuard<'_, Progress> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Prevents further steps. The call that sends them reports the accepted steps, once those already sent have been
/// answered.
fn stop_steps(stop: &RobotStop) {
    output::urgent_note("interrupted: no further step is sent");
    // A controller may answer the stop only after the previous step. Without an answer, too, no step follows.
    stop.stop().ok();
}

/// Stops the arm, and prints whether the controller has accepted the stop. If it has, the wait for the motion ends.
fn stop_arm(stop: &RobotStop) {
    let (answered, waiting) = mpsc::channel::<()>();
    thread::spawn(move || {
        if waiting.recv_timeout(SOON) == Err(RecvTimeoutError::Timeout) {
            output::urgent_note(
                "interrupted: no reply to the stop yet; if the arm keeps moving, use the emergency stop",
            );
        }
    });
    let stopped = stop.stop();
    drop(answered);
    match stopped {
        Ok(()) => output::urgent_note("interrupted: the controller accepted the stop (`stop_program`)"),
        Err(error) => end_with(
            exit::NOT_STOPPED,
            &format!("interrupted, but {}: {}", not_taken(error.may_have_run()), fact(error.kind(), &error)),
        ),
    }
}

/// In a test, the test calls the handler of the command.
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

/// Catches signals from now on. They end the program until a command sets its handler.
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

/// Ends the program, with another code if its recording cannot be written.
fn end(code: u8) -> ! {
    logging::finish();
    if let Err(failure) = record::finish() {
        exit::report(&failure);
        process::exit(exit::LOCAL.into());
    }
    process::exit(code.into())
}
