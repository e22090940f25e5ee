//! Reader for the tokens of one script line.

use std::str::FromStr;
use std::time::Duration;

use super::ScriptError;
use super::tokens::{self, Token};

/// Units of time, and their number in a second.
const UNITS: [(&str, f64); 5] = [("ms", 1e3), ("us", 1e6), ("µs", 1e6), ("ns", 1e9), ("s", 1.0)];

/// Remaining tokens.
#[derive(Debug)]
pub(crate) struct TokenReader<'w, 's> {
    rest: &'w [Token<'s>],
    last: Option<&'w Token<'s>>,
}

impl<'w, 's> TokenReader<'w, 's> {
    pub(super) fn new(tokens: &'w [Token<'s>]) -> Self {
        Self { rest: tokens, last: None }
    }

    /// Reads a whole text as one item.
    pub(crate) fn read_all<T>(
        text: &str,
        read: impl FnOnce(&mut TokenReader<'_, '_>) -> Result<T, ScriptError>,
    ) -> Result<T, ScriptError> {
        let read = tokens::lines(text).and_then(|lines| {
            let tokens: Vec<_> = lines.into_iter().flatten().collect();
            TokenReader::new(&tokens).last_item(read)
        });
        read.map_err(ScriptError::without_line)
    }

    /// Reads an item that must be the last one in a line.
    pub(super) fn last_item<T>(
        &mut self,
        read: impl FnOnce(&mut Self) -> Result<T, ScriptError>,
    ) -> Result<T, ScriptError> {
        let item = read(self)?;
        self.rest.first().map_or(Ok(item), |token| Err(token.error("expected the end of the line")))
    }

    /// Skips the first word of the line, which gives its kind.
    pub(super) fn skip(&mut self) -> &mut Self {
        self.advance();
        self
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.rest.is_empty()
    }

    /// Reads a comma or a colon.
    pub(super) fn mark(&mut self, mark: &str) -> Result<(), ScriptError> {
        let wanted = format!("`{mark}`");
        if self.word(&wanted)?.text == mark { Ok(()) } else { Err(self.unfit(format!("expected {wanted}"))) }
    }

    pub(crate) fn number<T: FromStr>(&mut self, what: &str) -> Result<T, ScriptError> {
        let word = self.word(what)?;
        word.text.parse().map_err(|_| word.error(format!("expected {what}")))
    }

    /// Reads odds such as `1/20`, and returns 20.
    pub(super) fn odds(&mut self) -> Result<u64, ScriptError> {
        let word = self.word("odds such as 1/20")?;
        let times = word.text.strip_prefix("1/").and_then(|times| times.parse().ok());
        times.ok_or_else(|| word.error("expected odds such as 1/20"))
    }

    pub(super) fn name(&mut self) -> Result<String, ScriptError> {
        let word = self.word("a command")?;
        let Some(bytes) = &word.quoted else { return Ok(word.text.to_owned()) };
        String::from_utf8(bytes.clone()).map_err(|_| word.error("a name must be UTF-8"))
    }

    /// Returns an error at the last word read.
    pub(crate) fn unfit(&self, reason: impl Into<String>) -> ScriptError {
        match self.last {
            Some(word) => word.error(reason),
            None => ScriptError::new(1, "", reason),
        }
    }

    pub(super) fn bytes(&mut self) -> Result<Vec<u8>, ScriptError> {
        let word = self.word("bytes in quotes")?;
        word.quoted.clone().ok_or_else(|| word.error("expected bytes in quotes"))
    }

    pub(super) fn count(&mut self) -> Result<usize, ScriptError> {
        self.number("a number of bytes")
    }

    pub(super) fn rate(&mut self) -> Result<u64, ScriptError> {
        self.number("a number of bytes a second")
    }

    pub(super) fn seed(&mut self) -> Result<u64, ScriptError> {
        if self.at_item_end() { Ok(0) } else { self.number("a seed") }
    }

    pub(super) fn sizes(&mut self) -> Result<Vec<usize>, ScriptError> {
        let mut sizes = Vec::new();
        while !self.at_item_end() {
            sizes.push(self.count()?);
        }
        Ok(sizes)
    }

    pub(crate) fn time(&mut self) -> Result<Duration, ScriptError> {
        const WANTED: &str = "a time such as 200ms or 1.5s";
        let word = self.word(WANTED)?;
        read_time(word.text).ok_or_else(|| word.error(format!("expected {WANTED}")))
    }

    pub(crate) fn time_or(&mut self, usual: Duration) -> Result<Duration, ScriptError> {
        Ok(self.optional_time()?.unwrap_or(usual))
    }

    pub(crate) fn optional_time(&mut self) -> Result<Option<Duration>, ScriptError> {
        if self.at_item_end() { Ok(None) } else { self.time().map(Some) }
    }

    pub(crate) fn threshold(&mut self) -> Result<f64, ScriptError> {
        const WANTED: &str = "a threshold, a number from 0";
        let most: f64 = self.number(WANTED)?;
        if most >= 0.0 && most.is_finite() { Ok(most) } else { Err(self.unfit(format!("expected {WANTED}"))) }
    }

    fn at_item_end(&self) -> bool {
        self.rest.first().is_none_or(|word| word.text == ",")
    }

    pub(crate) fn word(&mut self, what: &str) -> Result<&'w Token<'s>, ScriptError> {
        self.advance().ok_or_else(|| self.unfit(format!("expected {what} next")))
    }

    fn advance(&mut self) -> Option<&'w Token<'s>> {
        let (first, rest) = self.rest.split_first()?;
        self.rest = rest;
        self.last = Some(first);
        Some(first)
    }
}

/// Reads a time with its unit, such as `200ms`.
pub(crate) fn read_time(text: &str) -> Option<Duration> {
    let (number, per_second) = UNITS.iter().find_map(|(unit, times)| Some((text.strip_suffix(unit)?, times)))?;
    Duration::try_from_secs_f64(number.parse::<f64>().ok()? / per_second).ok()
}

#[cfg(test)]
mod tests;
