//! Fault plans as a text.

use std::error::Error;
use std::fmt;
use std::str::FromStr;

use super::token_reader::TokenReader;
use super::tokens::{self, Name, Token};
use super::{Fault, FaultPlan, LinkEvent, SplitMix64, StatusFault};

/// What is wrong with a text that says what the simulator does, such as that of a [`FaultPlan`], a [`Trip`](crate::Trip) or a
/// [`Habit`](crate::Habit), and where.
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

    /// An error of a text that is one thing alone.
    pub(crate) fn of_text(text: &str, reason: impl Into<String>) -> Self {
        Self { line: None, word: text.trim().to_owned(), reason: reason.into() }
    }

    pub(super) fn without_line(self) -> Self {
        Self { line: None, ..self }
    }

    /// The number of the line of a [`FaultPlan`], from 1.
    pub fn line(&self) -> Option<usize> {
        self.line
    }

    /// The word that does not fit, or the last one where something is missing.
    pub fn word(&self) -> &str {
        &self.word
    }
}

impl fmt::Display for ScriptError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.line.map_or(Ok(()), |line| write!(f, "line {line}: "))?;
        write!(f, "`{}`: {}", self.word, self.reason)
    }
}

impl Error for ScriptError {}

/// Texts as errors list them.
pub(crate) fn quoted(texts: &[impl fmt::Display]) -> String {
    let texts: Vec<_> = texts.iter().map(|text| format!("`{text}`")).collect();
    texts.join(", ")
}

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
            Some("always") => self.inject_always(args.skip().last_item(Fault::read)?),
            Some("link") => self.links.push(args.skip().last_item(TokenReader::link_event)?),
            Some("status") => self.status = args.skip().last_item(StatusFault::read)?,
            _ => self.script.extend(faults(args)?),
        }
        Ok(())
    }

    fn read_seed(&mut self, args: &mut TokenReader<'_, '_>) -> Result<(), ScriptError> {
        let seed = args.number("a seed")?;
        let other = self.generator.get_or_insert_with(|| SplitMix64::new(seed)).seed;
        if other == seed {
            return Ok(());
        }
        Err(args.unfit(format!("the seed is already {other}, and a plan has only one")))
    }
}

/// The faults that are left in a line.
fn faults(mut args: TokenReader<'_, '_>) -> Result<Vec<Fault>, ScriptError> {
    let mut faults = vec![Fault::read(&mut args)?];
    while !args.is_empty() {
        args.mark(",")?;
        faults.push(Fault::read(&mut args)?);
    }
    Ok(faults)
}

impl fmt::Display for FaultPlan {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut lines = Vec::new();
        if !self.script.is_empty() {
            lines.push(list(&self.script));
        }
        for (command, fault) in &self.commands {
            lines.push(format!("for {}: {fault}", Name(command)));
        }
        for chance in &self.chances {
            let seed = self.generator.as_ref().map_or(0, |generator| generator.seed);
            lines.push(format!("random {seed} 1/{} {}", chance.one_in, list(&chance.faults)));
        }
        lines.extend(self.always.iter().map(|fault| format!("always {fault}")));
        if self.status != StatusFault::None {
            lines.push(format!("status {}", self.status));
        }
        lines.extend(self.links.iter().map(LinkEvent::to_string));
        f.write_str(&lines.join("\n"))
    }
}

fn list<'f>(faults: impl IntoIterator<Item = &'f Fault>) -> String {
    let texts: Vec<_> = faults.into_iter().map(Fault::to_string).collect();
    texts.join(", ")
}
