//! Errors with a place, collected so that one run shows all of them.

use std::cell::RefCell;
use std::fmt;
use std::ops::Range;

use crate::Source;
use crate::prose::shown;

/// One thing that is wrong with a spec, and where.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Error {
    /// The file, as the [`Source`] names it.
    pub path: String,
    /// Line, from 1.
    pub line: usize,
    /// Column in characters, from 1.
    pub column: usize,
    /// Description of the error, with the command and field named.
    pub message: String,
}

/// In one line, for any content of the file.
impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { path, line, column, message } = self;
        // A pack's own text is in it.
        write!(f, "{}:{line}:{column}: {}", shown(path), shown(message))
    }
}

impl std::error::Error for Error {}

/// Errors of a file or of a spec: the first hundred that were found, by file and line, and the number of the others.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Errors {
    first: Vec<Error>,
    more: usize,
}

impl Errors {
    /// Number of errors that are kept.
    pub const MOST: usize = 100;

    /// The errors, one by one: the first hundred that were found.
    pub fn iter(&self) -> std::slice::Iter<'_, Error> {
        self.first.iter()
    }

    /// Number of errors beyond the first hundred.
    pub fn more(&self) -> usize {
        self.more
    }

    /// Adds an error, or only counts it if a hundred are here.
    pub fn push(&mut self, error: impl FnOnce() -> Error) {
        if self.first.len() == Self::MOST {
            self.more += 1;
            return;
        }
        let error = error();
        if !self.first.contains(&error) {
            self.first.push(error);
        }
    }

    /// This as an error, by file and line, if there is one.
    ///
    /// # Errors
    /// There is one.
    pub fn finish(mut self) -> Result<(), Self> {
        self.first.sort();
        if self.first.is_empty() { Ok(()) } else { Err(self) }
    }

    /// The errors, and a last one that counts the others if there are some.
    pub(crate) fn into_list(self) -> Vec<Error> {
        let Self { mut first, more } = self;
        if let Some(last) = first.last().filter(|_| more > 0) {
            first.push(Error { message: format!("and {more} more"), ..last.clone() });
        }
        first
    }
}

impl<'a> IntoIterator for &'a Errors {
    type Item = &'a Error;
    type IntoIter = std::slice::Iter<'a, Error>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

impl fmt::Display for Errors {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let lines: Vec<_> = self.first.iter().map(Error::to_string).collect();
        f.write_str(&lines.join("\n"))?;
        if self.more > 0 { write!(f, "\nand {} more errors", self.more) } else { Ok(()) }
    }
}

impl std::error::Error for Errors {}

/// A place in one of the sources.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct At<'s> {
    pub(crate) source: Source<'s>,
    pub(crate) offset: usize,
}

impl<'s> At<'s> {
    pub(crate) fn new(source: Source<'s>, span: &Range<usize>) -> Self {
        Self { source, offset: span.start }
    }

    pub(crate) fn error(self, message: impl Into<String>) -> Error {
        let (line, column) = self.line_and_column();
        Error { path: self.source.path.to_owned(), line, column, message: message.into() }
    }

    fn line_and_column(self) -> (usize, usize) {
        let before = self.source.text.get(..self.offset).unwrap_or(self.source.text);
        let line_start = before.rfind('\n').map_or(0, |i| i + 1);
        (before.matches('\n').count() + 1, before[line_start..].chars().count() + 1)
    }
}

impl fmt::Display for At<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (line, column) = self.line_and_column();
        write!(f, "{}:{line}:{column}", self.source.path)
    }
}

/// Collector of errors.
#[derive(Debug, Default)]
pub(crate) struct Report(RefCell<Errors>);

impl Report {
    pub(crate) fn error(&self, at: At<'_>, message: impl Into<String>) {
        self.0.borrow_mut().push(|| at.error(message));
    }

    /// All errors, or nothing if there are none.
    pub(crate) fn finish(self) -> Result<(), Errors> {
        self.0.into_inner().finish()
    }
}
