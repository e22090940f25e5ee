//! Options that have one of a few values.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

/// A value's name, what is said of it, and what it stands for.
pub(crate) type Choice<T> = (&'static str, &'static str, T);

/// The parser of an option that has one of these values.
pub(crate) fn one_of<T: Copy + Send + Sync>(choices: &'static [Choice<T>]) -> impl TypedValueParser<Value = T> {
    let known = choices.iter().map(|(name, help, _)| PossibleValue::new(*name).help(*help));
    PossibleValuesParser::new(known).try_map(|given| {
        let chosen = choices.iter().find(|(name, ..)| *name == given);
        chosen.map(|(.., value)| *value).ok_or("not one of the values")
    })
}
