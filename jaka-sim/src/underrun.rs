//! Reaction of the arm when set-points stop.

use std::fmt;
use std::str::FromStr;
use std::time::Duration;

use crate::ScriptError;
use crate::fault::read_time;

/// Reaction of the arm in servo mode if a cycle has no set-point, and the last set-point had speed.
///
/// No source documents the reaction of real controllers: each of these is a guess, and a program must be safe with
/// each. A set-point that repeats the previous one leaves no speed, and nothing happens after it.
///
/// The text form, as for `jaka sim --underrun`, is `hold`, `fault 40ms` or `run-out 300`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub enum Underrun {
    /// Holds the last set-point. `hold` as a text.
    #[default]
    Hold,
    /// Holds the last set-point. If none comes for this time, an error event ends servo mode: `0x1n8614` of the fastest
    /// joint. `fault 40ms` as a text, `fault` for at once.
    Fault(Duration),
    /// Continues at the last speed; the fastest joint brakes with this deceleration, in deg/s². `run-out 300` as a
    /// text.
    ///
    /// The arm stops at the end of a joint's range. It follows a new set-point from its present position.
    RunOut(f64),
}

impl fmt::Display for Underrun {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Hold => f.write_str("hold"),
            Self::Fault(after) if after.is_zero() => f.write_str("fault"),
            Self::Fault(after) => write!(f, "fault {after:?}"),
            Self::RunOut(deceleration) => write!(f, "run-out {deceleration}"),
        }
    }
}

impl FromStr for Underrun {
    type Err = ScriptError;

    /// Reads the text form.
    ///
    /// # Errors
    /// The word is unknown, the time is invalid, or the deceleration is not a number greater than 0.
    fn from_str(text: &str) -> Result<Self, ScriptError> {
        let words: Vec<_> = text.split_whitespace().collect();
        let read = match *words {
            ["hold"] => Some(Self::Hold),
            ["fault"] => Some(Self::Fault(Duration::ZERO)),
            ["fault", after] => read_time(after).map(Self::Fault),
            ["run-out", number] => {
                number.parse().ok().filter(|number: &f64| *number > 0.0 && number.is_finite()).map(Self::RunOut)
            }
            _ => None,
        };
        read.ok_or_else(|| {
            ScriptError::of_text(text, "expected one of `hold`, `fault`, `fault 40ms` and `run-out 300`")
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_has_a_text() {
        let forty = Duration::from_millis(40);
        for underrun in
            [Underrun::Hold, Underrun::Fault(Duration::ZERO), Underrun::Fault(forty), Underrun::RunOut(300.0)]
        {
            assert_eq!(underrun.to_string().parse(), Ok(underrun));
        }
        for text in ["", "holds", "hold 1s", "fault 3", "fault 1s 2s", "run-out", "run-out 0", "run-out inf"] {
            assert!(text.parse::<Underrun>().is_err(), "{text}");
        }
        assert_eq!(
            "run-out".parse::<Underrun>().expect_err("a number is missing").to_string(),
            "`run-out`: expected one of `hold`, `fault`, `fault 40ms` and `run-out 300`"
        );
    }
}
