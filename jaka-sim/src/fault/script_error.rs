//! Errors in texts that configure the simulator.

use std::error::Error;
use std::fmt;

/// Error in a text that configures the simulator, such as a [`FaultPlan`](crate::FaultPlan), a [`Trip`](crate::Trip) or
/// a [`Habit`](crate::Habit), with its position.
///
/// ```
/// # use jaka_sim::FaultPlan;
/// let error = "drop\ndely 200ms".parse::<FaultPlan>().unwrap_err();
/// assert_eq!(error.to_string(), "line 2: `dely`: unknown fault");
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ScriptError {
    line: Option<usize>,
    word: String,
    reason: String,
}

impl ScriptError {
    pub(super) fn new(line: usize, word: &str, reason: impl Into<String>) -> Self {
        Self { line: Some(line), word: word.to_owned(), reason: reason.into() }
    }

    /// Creates an error for a text with a single item.
    pub(crate) fn of_text(text: &str, reason: impl Into<String>) -> Self {
        Self { line: None, word: text.trim().to_owned(), reason: reason.into() }
    }

    pub(super) fn without_line(self) -> Self {
        Self { line: None, ..self }
    }
}

impl fmt::Display for ScriptError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.line.map_or(Ok(()), |line| write!(f, "line {line}: "))?;
        write!(f, "`{}`: {}", self.word, self.reason)
    }
}

impl Error for ScriptError {}

/// Quotes texts for a list in an error message.
pub(crate) fn quoted(texts: &[impl fmt::Display]) -> String {
    let texts: Vec<_> = texts.iter().map(|text| format!("`{text}`")).collect();
    texts.join(", ")
}
