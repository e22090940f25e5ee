//! Terminal mode with single keys, without Enter, until the program ends.

use std::borrow::Cow;
use std::io;
use std::panic;
use std::sync::atomic::{AtomicBool, Ordering};

use ratatui::crossterm::terminal::{disable_raw_mode, enable_raw_mode};

static IS_RAW: AtomicBool = AtomicBool::new(false);

/// Guard of the terminal mode with single keys. A panic and the end of the program restore the terminal, too.
#[derive(Debug)]
pub(crate) struct Raw(());

impl Raw {
    pub(crate) fn begin() -> io::Result<Self> {
        let usual = panic::take_hook();
        panic::set_hook(Box::new(move |info| {
            end();
            usual(info);
        }));
        enable_raw_mode()?;
        IS_RAW.store(true, Ordering::Relaxed);
        Ok(Self(()))
    }
}

impl Drop for Raw {
    fn drop(&mut self) {
        end();
    }
}

/// Restores the terminal, if necessary.
pub(crate) fn end() {
    if IS_RAW.swap(false, Ordering::Relaxed) {
        // The terminal may be gone.
        disable_raw_mode().ok();
    }
}

/// Adds carriage returns to text in the mode with single keys, in which a line end does not return to column 1.
pub(crate) fn with_returns(text: &[u8]) -> Cow<'_, [u8]> {
    if IS_RAW.load(Ordering::Relaxed) { returned(text).into() } else { text.into() }
}

fn returned(text: &[u8]) -> Vec<u8> {
    text.split_inclusive(|byte| *byte == b'\n')
        .flat_map(|line| match line.strip_suffix(b"\n") {
            Some(line) => [line, b"\r\n"].concat(),
            None => line.to_vec(),
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_line_goes_back_to_its_begin() {
        for (text, expected) in [("a\nb\n\n", "a\r\nb\r\n\r\n"), ("a\nb", "a\r\nb"), ("", "")] {
            assert_eq!(returned(text.as_bytes()), expected.as_bytes(), "{text:?}");
        }
        assert_eq!(*with_returns(b"a\n"), *b"a\n", "a terminal as usual needs none");
    }
}
