//! Text form of fault plans.

use std::fmt;
use std::str::FromStr;

use super::token_reader::TokenReader;
use super::tokens::{self, Name, Token};
use super::{Fault, FaultPlan, ScriptError, SplitMix64, StatusFault};

impl FromStr for FaultPlan {
    type Err = ScriptError;

    /// Reads the text form of a plan.
    ///
    /// # Errors
    /// A word does not fit, or is missing.
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

/// Reads the remaining faults of a line.
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
        for (replies, faults) in &self.chances {
            let seed = self.generator.as_ref().map_or(0, |generator| generator.seed);
            lines.push(format!("random {seed} 1/{replies} {}", list(faults)));
        }
        lines.extend(self.always.iter().map(|fault| format!("always {fault}")));
        if self.status != StatusFault::None {
            lines.push(format!("status {}", self.status));
        }
        f.write_str(&lines.join("\n"))
    }
}

fn list<'f>(faults: impl IntoIterator<Item = &'f Fault>) -> String {
    let texts: Vec<_> = faults.into_iter().map(Fault::to_string).collect();
    texts.join(", ")
}
