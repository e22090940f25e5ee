//! The end of a test whose simulated time stands still.

use std::io::{Write, stderr};
use std::process;
use std::sync::mpsc::{self, RecvTimeoutError, Sender};
use std::thread;
use std::time::Duration;

use jaka_sim::SimulatedClock;

/// Seconds of real time after which a standstill is a deadlock: far more than any computation of a test takes.
const PATIENCE: u32 = 300;

/// Ends the process with a message if the time of a clock stands still for [`PATIENCE`] before this is dropped. A test
/// with a deadlock fails so, and does not hang.
#[derive(Debug)]
pub(crate) struct Standstill {
    /// Its end ends the thread.
    _dropped: Sender<()>,
}

impl Standstill {
    /// Watches the clock on behalf of this thread's test.
    pub(crate) fn end_test(clock: &SimulatedClock) -> Self {
        let (sender, receiver) = mpsc::channel::<()>();
        let (clock, test) = (clock.clone(), thread::current().name().unwrap_or("a thread").to_owned());
        thread::spawn(move || {
            let (mut last, mut seconds) = (clock.elapsed(), 0);
            // A pause of the process counts as one second, however long it is.
            while receiver.recv_timeout(Duration::from_secs(1)) == Err(RecvTimeoutError::Timeout) {
                let now = clock.elapsed();
                seconds = if now == last && is_used(&clock) { seconds + 1 } else { 0 };
                last = now;
                if seconds == PATIENCE {
                    // Not by a macro, whose output the test harness would keep.
                    let _ = writeln!(stderr(), "{test}: deadlock: the simulated time stands still: {clock:#?}");
                    process::exit(101);
                }
            }
        });
        Self { _dropped: sender }
    }
}

/// True unless the time may stand still for ever: nobody is at work, and only servants wait, as after the end of a
/// test's program.
fn is_used(clock: &SimulatedClock) -> bool {
    let state = format!("{clock:#?}");
    !state.contains("at_work: 0,") || state.contains("moves_time: Yes")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_clock_that_no_program_uses_stands_still_without_a_deadlock() {
        let clock = SimulatedClock::new();
        assert!(!is_used(&clock));
        let (servant, theirs) = (clock.servant(), clock.clone());
        assert!(is_used(&clock), "a thread is about to begin");
        let serving = thread::spawn(move || servant.run(|| theirs.sleep(Duration::from_secs(1))));
        while is_used(&clock) {
            thread::yield_now();
        }
        // From now on this thread takes part.
        clock.sleep(Duration::from_secs(2));
        assert!(is_used(&clock));
        serving.join().expect("it does not panic");
    }
}
