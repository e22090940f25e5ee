//! Reaction of the controller to a stop in servo mode.

use std::str::FromStr;

use crate::ScriptError;
use crate::fault::quoted;

jaka_proto::worded! {
    /// Reaction of the controller to `stop_program` in servo mode. It accepts the stop in each case.
    ///
    /// No source documents the reaction of real controllers: each of these is a guess, and a program must be safe with
    /// each.
    ///
    /// The text form, as for `jaka sim --stop-in-servo`, is `discard`, `ignore`, `leave` or `fault`.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum StopInServo {
        /// Discards the waiting set-points. The arm holds its position at once, and follows later set-points. `discard`
        /// as a text.
        Discard => "discard",
        /// Ignores the stop. The arm follows its set-points. `ignore` as a text.
        Ignore => "ignore",
        /// Leaves servo mode. The fastest joint brakes with 180 deg/s², as a motion without an acceleration does. The
        /// controller refuses later set-points as outside servo mode. `leave` as a text.
        Leave => "leave",
        /// Ends servo mode with an error event, `0x1n8614` of the fastest joint, and halts the arm at once, as a
        /// [`Trip`](crate::Trip) does. The controller refuses later set-points as outside servo mode. `fault` as a
        /// text.
        Fault => "fault",
    }
}

impl StopInServo {
    /// Each reaction.
    pub const ALL: [Self; 4] = [Self::Discard, Self::Ignore, Self::Leave, Self::Fault];
}

impl FromStr for StopInServo {
    type Err = ScriptError;

    /// Reads the text form.
    ///
    /// # Errors
    /// The word is unknown.
    fn from_str(text: &str) -> Result<Self, ScriptError> {
        let found = Self::ALL.into_iter().find(|reaction| reaction.to_string() == text.trim());
        found.ok_or_else(|| ScriptError::of_text(text, format!("expected one of {}", quoted(&Self::ALL))))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_has_a_text() {
        for reaction in StopInServo::ALL {
            assert_eq!(reaction.to_string().parse(), Ok(reaction));
        }
        assert_eq!(
            "hold".parse::<StopInServo>().expect_err("it is unknown").to_string(),
            "`hold`: expected one of `discard`, `ignore`, `leave`, `fault`"
        );
    }
}
