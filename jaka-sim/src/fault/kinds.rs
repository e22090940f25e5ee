//! Kinds of faults, one row each.

use std::fmt;
use std::time::Duration;

use super::tokens::{Name, Quoted};

/// Makes an enum of a table of faults, with the text form of each and what it does.
///
/// A row is `Kind(argument: Type as reader = example): "word" => effect`, where the reader is a method of
/// [`TokenReader`](super::token_reader::TokenReader), the example is the one in `one_of_each`, and the effect is the value of the
/// function that is declared before the rows. A kind whose row lacks a part does not compile.
macro_rules! fault_kinds {
    (
        $(#[$meta:meta])*
        pub enum $Fault:ident($what:literal, $unknown:expr);

        $(#[$effect_meta:meta])*
        pub(crate) fn $effect:ident(&self, $($input:ident: $Input:ty),*) -> $Effect:ty;

        $(
            $(#[$kind_meta:meta])*
            $Kind:ident
                $(($arg:ident: $Arg:ty as $read:ident = $example:expr))?
                $({ $(
                    $(#[$field_meta:meta])*
                    $field:ident: $Field:ty as $field_read:ident = $field_example:expr
                ),* $(,)? })?
                : $word:literal => $value:expr;
        )*
    ) => {
        $(#[$meta])*
        pub enum $Fault {
            $( $(#[$kind_meta])* $Kind $(($Arg))? $({ $( $(#[$field_meta])* $field: $Field ),* })? ),*
        }

        impl $Fault {
            /// One fault of each kind, [`None`](Self::None) first, for tests that go through all of them.
            pub fn one_of_each() -> Vec<Self> {
                vec![$( Self::$Kind $(($example))? $({ $($field: $field_example),* })? ),*]
            }

            $(#[$effect_meta])*
            pub(crate) fn $effect(&self, $($input: $Input),*) -> $Effect {
                match self {
                    $( Self::$Kind $(($arg))? $({ $($field),* })? => $value ),*
                }
            }

            pub(super) fn read(tokens: &mut TokenReader<'_, '_>) -> Result<Self, ScriptError> {
                Ok(match tokens.word($what)?.text {
                    $( $word => Self::$Kind $((tokens.$read()?))? $({ $($field: tokens.$field_read()?),* })?, )*
                    other => return Err(tokens.unfit($unknown(other))),
                })
            }
        }

        /// The text form, as in a script.
        impl fmt::Display for $Fault {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                match self {
                    $( Self::$Kind $(($arg))? $({ $($field),* })? => {
                        f.write_str($word)?;
                        $( $arg.write(f)?; )?
                        $( $( $field.write(f)?; )* )?
                        Ok(())
                    } )*
                }
            }
        }

        impl FromStr for $Fault {
            type Err = ScriptError;

            /// Reads the text form.
            ///
            /// # Errors
            /// A word does not fit, or one is missing.
            fn from_str(text: &str) -> Result<Self, ScriptError> {
                TokenReader::read_all(text, Self::read)
            }
        }
    };
}

pub(super) use fault_kinds;

/// What follows the word of a fault in its text form.
pub(super) trait Argument {
    /// Writes it, after a blank.
    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result;
}

impl Argument for Duration {
    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, " {self:?}")
    }
}

impl Argument for usize {
    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, " {self}")
    }
}

impl Argument for u64 {
    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, " {self}")
    }
}

impl Argument for Vec<usize> {
    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.iter().try_for_each(|size| size.write(f))
    }
}

impl Argument for Vec<u8> {
    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, " {}", Quoted(self))
    }
}

impl Argument for String {
    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, " {}", Name(self))
    }
}
