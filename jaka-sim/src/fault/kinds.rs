//! Table macro for kinds of faults, trips, habits and happenings, one row for each kind.

use std::fmt;
use std::time::Duration;

use super::tokens::Name;

/// Generates an enum from a table of kinds, with the text form and the effect of each.
///
/// A row is `Kind(argument: Type as reader = example, …): "word" => effect`. The reader is a method of
/// [`TokenReader`](super::token_reader::TokenReader), with the default for a missing argument as in `reader(usual)`.
/// The example is the argument in `one_of_each`. The effect is the value of the function declared before the rows. A
/// kind with an incomplete row does not compile.
macro_rules! kinds {
    (
        $(#[$meta:meta])*
        pub enum $Kinds:ident($what:literal, $unknown:expr);

        $(#[$effect_meta:meta])*
        pub(crate) fn $effect:ident(&self, $($input:ident: $Input:ty),*) -> $Effect:ty;

        $(
            $(#[$kind_meta:meta])*
            $Kind:ident
                $(( $($arg:ident: $Arg:ty as $read:ident $(($usual:expr))? = $example:expr),+ ))?
                $({ $(
                    $(#[$field_meta:meta])*
                    $field:ident: $Field:ty as $field_read:ident = $field_example:expr
                ),* $(,)? })?
                : $word:literal => $value:expr;
        )*
    ) => {
        $(#[$meta])*
        pub enum $Kinds {
            $( $(#[$kind_meta])* $Kind $(( $($Arg),+ ))? $({ $( $(#[$field_meta])* $field: $Field ),* })? ),*
        }

        impl $Kinds {
            /// Returns one of each kind, in their order and with usual arguments, for tests of all kinds.
            pub fn one_of_each() -> Vec<Self> {
                vec![$( Self::$Kind $(( $($example),+ ))? $({ $($field: $field_example),* })? ),*]
            }

            $(#[$effect_meta])*
            pub(crate) fn $effect(&self, $($input: $Input),*) -> $Effect {
                match self {
                    $( Self::$Kind $(( $($arg),+ ))? $({ $($field),* })? => $value ),*
                }
            }

            pub(crate) fn read(tokens: &mut $crate::fault::TokenReader<'_, '_>) -> Result<Self, $crate::ScriptError> {
                Ok(match tokens.word($what)?.text {
                    $( $word => Self::$Kind $(( $(tokens.$read($($usual)?)?),+ ))? $({ $($field: tokens.$field_read()?),* })?, )*
                    other => return Err(tokens.unfit($unknown(other))),
                })
            }
        }

        /// Writes the text form, as in a script.
        impl std::fmt::Display for $Kinds {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                use $crate::fault::Argument as _;
                match self {
                    $( Self::$Kind $(( $($arg),+ ))? $({ $($field),* })? => {
                        f.write_str($word)?;
                        $( $( $arg.write(f)?; )+ )?
                        $( $( $field.write(f)?; )* )?
                        Ok(())
                    } )*
                }
            }
        }

        impl std::str::FromStr for $Kinds {
            type Err = $crate::ScriptError;

            /// Reads the text form.
            ///
            /// # Errors
            /// A word does not fit, or is missing.
            fn from_str(text: &str) -> Result<Self, $crate::ScriptError> {
                $crate::fault::TokenReader::read_all(text, Self::read)
            }
        }
    };
}

pub(crate) use kinds;

/// Argument that follows the word of a kind in its text form.
pub(crate) trait Argument {
    /// Writes the argument after a blank.
    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result;
}

impl Argument for Duration {
    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, " {self:?}")
    }
}

macro_rules! numbers {
    ($($Number:ty),*) => {
        $(impl Argument for $Number {
            fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, " {self}")
            }
        })*
    };
}

numbers!(usize, u64, f64);

impl Argument for Option<Duration> {
    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.iter().try_for_each(|time| time.write(f))
    }
}

impl Argument for Vec<usize> {
    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.iter().try_for_each(|size| size.write(f))
    }
}

impl Argument for Vec<u8> {
    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, " \"{}\"", self.escape_ascii())
    }
}

impl Argument for String {
    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, " {}", Name(self))
    }
}
