//! Errors of text files, each at its line and column.

use std::fmt;

use jaka_proto::text::Visible;

/// Error in a file, with its position.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct FileError {
    /// Name of the file, as it was given.
    pub path: String,
    /// Line, from 1.
    pub line: usize,
    /// Column in characters, from 1; in CSV that of the line's start.
    pub column: usize,
    /// Description of the error.
    pub message: String,
}

/// Errors in a file, each at its line and column: the first hundred that were found, in the order of the lines, and the
/// number of the others.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct FileErrors {
    first: Vec<FileError>,
    more: usize,
}

/// Errors found in a file so far.
#[derive(Debug)]
pub(crate) struct Report<'t> {
    text: &'t str,
    file_name: &'t str,
    /// Starts of lines, which make many errors quick.
    lines: Vec<usize>,
    errors: FileErrors,
}

/// Greatest number of characters of the text that an error shows.
#[cfg(feature = "trajectory-files")]
const SHOWN: usize = 40;

/// Greatest number of errors that are kept.
const MOST: usize = 100;

impl FileErrors {
    /// Returns the errors one by one: the first hundred that were found.
    pub fn iter(&self) -> std::slice::Iter<'_, FileError> {
        self.first.iter()
    }

    /// Returns the number of errors beyond the first hundred.
    pub fn more(&self) -> usize {
        self.more
    }
}

impl<'t> Report<'t> {
    pub(crate) fn new(text: &'t str, file_name: &'t str) -> Self {
        let after_breaks = text.match_indices('\n').map(|(at, _)| at + 1);
        let lines = std::iter::once(0).chain(after_breaks).collect();
        Self { text, file_name, lines, errors: FileErrors::default() }
    }

    /// Reports an error at an offset in bytes. An offset within a character counts as its start.
    pub(crate) fn error(&mut self, at: usize, message: impl Into<String>) {
        let FileErrors { first, more } = &mut self.errors;
        if first.len() == MOST {
            *more += 1;
            return;
        }
        let line = self.lines.partition_point(|start| *start <= at).max(1);
        let start = self.lines[line - 1];
        let before = (start..=at).rev().find_map(|end| self.text.get(start..end)).unwrap_or_default();
        let (path, column) = (self.file_name.to_owned(), before.chars().count() + 1);
        let error = FileError { path, line, column, message: message.into() };
        if !first.contains(&error) {
            first.push(error);
        }
    }

    /// Reports a text that is not the expected one.
    #[cfg(feature = "trajectory-files")]
    pub(crate) fn found(&mut self, at: usize, what: &str, found: &str, expected: &str) {
        let short: String = found.chars().take(SHOWN).collect();
        let rest = if short.len() < found.len() { "..." } else { "" };
        self.error(at, format!("{what}: found `{short}{rest}`, expected {expected}"));
    }

    /// Returns the result of reading, if there are no errors.
    pub(crate) fn finish<T>(mut self, read: T) -> Result<T, FileErrors> {
        self.errors.first.sort();
        if self.errors.first.is_empty() { Ok(read) } else { Err(self.errors) }
    }
}

/// Writes the error in one line, for any content of the file.
impl fmt::Display for FileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { path, line, column, message } = self;
        write!(f, "{}:{line}:{column}: {}", Visible(path), Visible(message))
    }
}

impl fmt::Display for FileErrors {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let lines: Vec<_> = self.first.iter().map(FileError::to_string).collect();
        f.write_str(&lines.join("\n"))?;
        if self.more > 0 { write!(f, "\nand {} more errors", self.more) } else { Ok(()) }
    }
}

impl std::error::Error for FileError {}

impl std::error::Error for FileErrors {}

impl<'a> IntoIterator for &'a FileErrors {
    type Item = &'a FileError;
    type IntoIter = std::slice::Iter<'a, FileError>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}
