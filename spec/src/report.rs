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
    /// What is wrong, with the command and field named.
    pub message: String,
}

/// In one line, whatever the file holds.
impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { path, line, column, message } = self;
        // A pack's own text is in it.
        write!(f, "{}:{line}:{column}: {}", shown(path), shown(message))
    }
}

impl std::error::Error for Error {}

/// Everything that is wrong with a spec, by file and line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Errors(pub(crate) Vec<Error>);

impl Errors {
    /// The errors, one by one.
    pub fn iter(&self) -> std::slice::Iter<'_, Error> {
        self.0.iter()
    }
}

/// In the order in which they come.
impl FromIterator<Error> for Errors {
    fn from_iter<I: IntoIterator<Item = Error>>(errors: I) -> Self {
        Self(errors.into_iter().collect())
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
        let lines: Vec<_> = self.0.iter().map(Error::to_string).collect();
        f.write_str(&lines.join("\n"))
    }
}

impl std::error::Error for Errors {}

/// A place in one of the sources.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct At<'s> {
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

/// Where errors are collected.
#[derive(Debug, Default)]
pub(crate) struct Report(RefCell<Vec<Error>>);

impl Report {
    pub(crate) fn error(&self, at: At<'_>, message: impl Into<String>) {
        self.0.borrow_mut().push(at.error(message));
    }

    /// All errors, or nothing if there are none.
    pub(crate) fn finish(self) -> Result<(), Errors> {
        let mut errors = self.0.into_inner();
        errors.sort();
        errors.dedup();
        if errors.is_empty() { Ok(()) } else { Err(Errors(errors)) }
    }
}
