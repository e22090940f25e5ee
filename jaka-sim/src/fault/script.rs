//! Fault plans as a text.

use std::error::Error;
use std::fmt;
use std::str::FromStr;

use super::token_reader::TokenReader;
use super::tokens::{self, Token};
use super::{Fault, FaultPlan, LinkFault, StatusFault};

/// What is wrong with the text of a [`FaultPlan`], a [`Fault`], a [`StatusFault`] or a [`LinkFault`], and where.
///
/// ```
/// # use jaka_sim::FaultPlan;
/// let error = "drop\ndely 200ms".parse::<FaultPlan>().unwrap_err();
/// assert_eq!(error.to_string(), "line 2: `dely`: there is no such fault");
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ScriptError {
    line: usize,
    word: String,
    reason: String,
}

impl ScriptError {
    pub(super) fn new(line: usize, word: &str, reason: impl Into<String>) -> Self {
        Self { line, word: word.to_owned(), reason: reason.into() }
    }

    /// The number of the line, from 1.
    pub fn line(&self) -> usize {
        self.line
    }

    /// The word that does not fit, or the last one where something is missing.
    pub fn word(&self) -> &str {
        &self.word
    }
}

impl fmt::Display for ScriptError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}: `{}`: {}", self.line, self.word, self.reason)
    }
}

impl Error for ScriptError {}

impl FromStr for FaultPlan {
    type Err = ScriptError;

    /// Reads the text form of a plan.
    ///
    /// # Errors
    /// A word does not fit, or one is missing.
    fn from_str(script: &str) -> Result<Self, ScriptError> {
        let mut plan = Self::new();
        for tokens in tokens::lines(script)? {
            plan.read_line(&tokens)?;
        }
        Ok(plan)
    }
}

impl FaultPlan {
    fn read_line(&mut self, tokens: &[Token<'_>]) -> Result<(), ScriptError> {
        let mut args = TokenReader::new(tokens);
        match tokens.first().map(|word| word.text) {
            Some("for") => {
                let command = args.skip().name()?;
                args.mark(":")?;
                self.commands.extend(faults(args)?.into_iter().map(|fault| (command.clone(), fault)));
            }
            Some("random") => {
                self.read_seed(args.skip())?;
                let one_in = args.odds()?;
                *self = std::mem::take(self).one_in(one_in, faults(args)?);
            }
            Some("always") => self.inject_always(one(args.skip(), TokenReader::fault)?),
            Some("link") => self.links.push(one(args.skip(), TokenReader::link_event)?),
            Some("status") => self.status = one(args.skip(), TokenReader::status_fault)?,
            _ => self.script.extend(faults(args)?),
        }
        Ok(())
    }

    fn read_seed(&mut self, args: &mut TokenReader<'_, '_>) -> Result<(), ScriptError> {
        let seed = args.number("a seed")?;
        match self.seed {
            Some(other) if other != seed => {
                Err(args.unfit(format!("the seed has been {other}, and there is only one")))
            }
            Some(_) => Ok(()),
            None => {
                self.set_seed(seed);
                Ok(())
            }
        }
    }
}

/// The faults that are left in a line.
fn faults(mut args: TokenReader<'_, '_>) -> Result<Vec<Fault>, ScriptError> {
    let mut faults = vec![args.fault()?];
    while !args.is_empty() {
        args.mark(",")?;
        faults.push(args.fault()?);
    }
    Ok(faults)
}

/// What has to be the last thing in a line.
fn one<'w, 's, T>(
    args: &mut TokenReader<'w, 's>,
    read: impl FnOnce(&mut TokenReader<'w, 's>) -> Result<T, ScriptError>,
) -> Result<T, ScriptError> {
    let item = read(args)?;
    args.end()?;
    Ok(item)
}

/// The tokens of a text that has one thing in it.
fn all_words(text: &str) -> Result<Vec<Token<'_>>, ScriptError> {
    Ok(tokens::lines(text)?.into_iter().flatten().collect())
}

impl FromStr for Fault {
    type Err = ScriptError;

    /// Reads the text form of a fault.
    ///
    /// # Errors
    /// A word does not fit, or one is missing.
    fn from_str(text: &str) -> Result<Self, ScriptError> {
        one(&mut TokenReader::new(&all_words(text)?), TokenReader::fault)
    }
}

impl FromStr for StatusFault {
    type Err = ScriptError;

    /// Reads the text form of a fault.
    ///
    /// # Errors
    /// A word does not fit, or one is missing.
    fn from_str(text: &str) -> Result<Self, ScriptError> {
        one(&mut TokenReader::new(&all_words(text)?), TokenReader::status_fault)
    }
}

impl FromStr for LinkFault {
    type Err = ScriptError;

    /// Reads the text form of a fault.
    ///
    /// # Errors
    /// A word does not fit, or one is missing.
    fn from_str(text: &str) -> Result<Self, ScriptError> {
        one(&mut TokenReader::new(&all_words(text)?), TokenReader::link_fault)
    }
}
