//! What is wrong with a file.

use jaka_spec::Error;

use super::TrajectoryFileError;

/// What has been wrong so far.
#[derive(Debug)]
pub(super) struct Report<'t> {
    text: &'t str,
    file_name: &'t str,
    /// Where lines start, so that many errors do not take long.
    lines: Vec<usize>,
    errors: TrajectoryFileError,
}

/// Of what was found at most so many characters are shown.
const SHOWN: usize = 40;

impl<'t> Report<'t> {
    pub(super) fn new(text: &'t str, file_name: &'t str) -> Self {
        let after_breaks = text.match_indices('\n').map(|(at, _)| at + 1);
        Self {
            text,
            file_name,
            lines: std::iter::once(0).chain(after_breaks).collect(),
            errors: TrajectoryFileError::default(),
        }
    }

    /// An error at an offset in bytes.
    pub(super) fn error(&mut self, at: usize, message: impl Into<String>) {
        let (text, path, lines) = (self.text, self.file_name, &self.lines);
        self.errors.push(|| {
            let line = lines.partition_point(|start| *start <= at).max(1);
            let before = text.get(lines[line - 1]..at).unwrap_or_default();
            let column = before.chars().count() + 1;
            Error { path: path.to_owned(), line, column, message: message.into() }
        });
    }

    /// An error at a line and column.
    pub(super) fn error_at(&mut self, line: usize, column: usize, message: impl Into<String>) {
        let path = self.file_name;
        self.errors.push(|| Error { path: path.to_owned(), line, column, message: message.into() });
    }

    /// An error about what was found in place of something.
    pub(super) fn found(&mut self, at: usize, what: &str, found: &str, expected: &str) {
        let short: String = found.chars().take(SHOWN).collect();
        let rest = if short.len() < found.len() { "..." } else { "" };
        self.error(at, format!("{what}: found `{short}{rest}`, expected {expected}"));
    }

    /// The points, if nothing is wrong.
    pub(super) fn finish<T>(self, points: T) -> Result<T, TrajectoryFileError> {
        self.errors.finish().map(|()| points)
    }
}
