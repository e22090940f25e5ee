//! Progress of a probe, and its interruption.

use std::io::{IsTerminal, Write, stderr};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::arm::interrupt::on_first_interrupt;
use crate::terminal::output;

/// Progress of a probe, shown on a terminal until Ctrl-C.
#[derive(Debug)]
pub(super) struct ProbeProgress {
    interrupted: Arc<AtomicBool>,
    is_shown: bool,
}

impl ProbeProgress {
    /// Handles Ctrl-C from now on: it ends the questions. A second one ends the program at once.
    pub(super) fn begin() -> Self {
        let interrupted = Arc::new(AtomicBool::new(false));
        let flag = Arc::clone(&interrupted);
        on_first_interrupt(move || flag.store(true, Ordering::Relaxed));
        Self { interrupted, is_shown: stderr().is_terminal() && !output::is_quiet() }
    }

    pub(super) fn is_interrupted(&self) -> bool {
        self.interrupted.load(Ordering::Relaxed)
    }

    /// Shows the next question, in place of the last one.
    pub(super) fn show(&self, number: usize, count: usize, what: &str) {
        self.write(&format!("\r\x1b[K{}/{count} {what}", number + 1));
    }

    /// Removes the shown question.
    pub(super) fn clear(&self) {
        self.write("\r\x1b[K");
    }

    /// Writes to the terminal. The reader may be gone.
    fn write(&self, text: &str) {
        if self.is_shown {
            let mut out = stderr();
            out.write_all(text.as_bytes()).and_then(|()| out.flush()).ok();
        }
    }
}
