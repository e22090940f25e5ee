//! What can happen to the arm.

use std::fmt;
use std::io;
use std::str::FromStr;
use std::time::Duration;

use super::{ScriptError, quoted, read_time};
use crate::State;
use crate::input_script::{InputChange, Side};

jaka_proto::worded! {
    /// What happens to the arm or to a digital input, which is given by its place in the list of the [`State`], from 0.
    ///
    /// [`Controller::at`](crate::Controller::at) and [`Builder::at`](crate::Builder::at) have it happen. It has a text
    /// form, as `jaka sim --schedule` takes it.
    ///
    /// ```
    /// use jaka_sim::ArmFault;
    ///
    /// assert_eq!("input 3 high".parse(), Ok(ArmFault::InputHigh(3)));
    /// assert_eq!(ArmFault::PressEmergencyStop.to_string(), "press-emergency-stop");
    /// ```
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    #[non_exhaustive]
    pub enum ArmFault {
        /// A collision: a protective stop and the error `0xf0034`, until `clear_error`. `collide` as a text.
        Collide => "collide",
        /// The emergency stop is pressed: the arm is not enabled, and cannot be. `press-emergency-stop` as a text.
        PressEmergencyStop => "press-emergency-stop",
        /// The emergency stop is released. The arm stays disabled until it is enabled again. `release-emergency-stop`
        /// as a text.
        ReleaseEmergencyStop => "release-emergency-stop",
        /// The arm loses its power. `cut-power` as a text.
        CutPower => "cut-power",
        /// An input of the cabinet goes high. `input 3 high` as a text.
        InputHigh(index: usize) => "input {index} high",
        /// An input of the cabinet goes low. `input 3 low` as a text.
        InputLow(index: usize) => "input {index} low",
        /// An input of the tool goes high. `tool-input 0 high` as a text.
        ToolInputHigh(index: usize) => "tool-input {index} high",
        /// An input of the tool goes low. `tool-input 0 low` as a text.
        ToolInputLow(index: usize) => "tool-input {index} low",
    }
}

impl ArmFault {
    /// One of each kind, those of inputs for the one with this number, for tests that go through all of them.
    pub fn one_of_each(input: usize) -> Vec<Self> {
        vec![
            Self::Collide,
            Self::PressEmergencyStop,
            Self::ReleaseEmergencyStop,
            Self::CutPower,
            Self::InputHigh(input),
            Self::InputLow(input),
            Self::ToolInputHigh(input),
            Self::ToolInputLow(input),
        ]
    }

    /// The one at the beginning of a text, and what follows it.
    fn read(text: &str) -> Option<(Self, String)> {
        let input = text.split(' ').nth(1).and_then(|index| index.parse().ok()).unwrap_or_default();
        Self::one_of_each(input).into_iter().find_map(|fault| {
            let rest = text.strip_prefix(&fault.to_string())?;
            (rest.is_empty() || rest.starts_with(' ')).then(|| (fault, rest.to_owned()))
        })
    }

    /// What it does.
    pub(crate) fn happening(self) -> Happening {
        let input = |side, index, is_high| Happening::Input(InputChange::Digital(side, index, is_high));
        match self {
            Self::Collide => Happening::Arm(State::collide),
            Self::PressEmergencyStop => Happening::Arm(|state| state.emergency_stop = true),
            Self::ReleaseEmergencyStop => Happening::Arm(|state| state.emergency_stop = false),
            Self::CutPower => Happening::Arm(|state| state.powered = false),
            Self::InputHigh(index) => input(Side::Cabinet, index, true),
            Self::InputLow(index) => input(Side::Cabinet, index, false),
            Self::ToolInputHigh(index) => input(Side::Tool, index, true),
            Self::ToolInputLow(index) => input(Side::Tool, index, false),
        }
    }
}

/// A change of the state, and of what.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Happening {
    Arm(fn(&mut State)),
    Input(InputChange),
}

impl Happening {
    /// An input that the controller does not have is an error.
    pub(crate) fn check(self, state: &State) -> io::Result<()> {
        match self {
            Self::Arm(_) => Ok(()),
            Self::Input(change) => change.check(state),
        }
    }

    pub(crate) fn make(self, state: &mut State) {
        match self {
            Self::Arm(change) => change(state),
            Self::Input(change) => change.make(state),
        }
    }
}

/// An [`ArmFault`] and the controller's time since its start at which it happens: `collide at 2s` as a text, and without a time at once.
///
/// ```
/// use jaka_sim::{ArmEvent, Controller};
///
/// let mut builder = Controller::builder();
/// for event in "collide at 2s, input 3 high at 1500ms".split(',') {
///     let ArmEvent { fault, at } = event.parse()?;
///     builder = builder.at(at, fault);
/// }
/// # Ok::<(), jaka_sim::ScriptError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ArmEvent {
    /// What happens.
    pub fault: ArmFault,
    /// When, in the controller's time since its start.
    pub at: Duration,
}

impl FromStr for ArmFault {
    type Err = ScriptError;

    /// Reads the text form.
    ///
    /// # Errors
    /// It is none of these.
    fn from_str(text: &str) -> Result<Self, ScriptError> {
        let found = Self::read(&words(text)).filter(|(_, rest)| rest.is_empty()).map(|(fault, _)| fault);
        found.ok_or_else(|| unknown(text))
    }
}

impl FromStr for ArmEvent {
    type Err = ScriptError;

    /// Reads the text form.
    ///
    /// # Errors
    /// There is no such fault, or what follows it is not a time.
    fn from_str(text: &str) -> Result<Self, ScriptError> {
        let (fault, rest) = ArmFault::read(&words(text)).ok_or_else(|| unknown(text))?;
        let at = if rest.is_empty() { Some(Duration::ZERO) } else { rest.strip_prefix(" at ").and_then(read_time) };
        let wanted = || format!("a time may follow, as in `{fault} at 2s` or `… at 500ms`");
        Ok(Self { fault, at: at.ok_or_else(|| ScriptError::of_text(&fault.to_string(), wanted()))? })
    }
}

impl fmt::Display for ArmEvent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} at {:?}", self.fault, self.at)
    }
}

/// The error of a text that does not begin with one of these.
fn unknown(text: &str) -> ScriptError {
    ScriptError::of_text(text, format!("expected one of {}", quoted(&ArmFault::one_of_each(0))))
}

/// A text with one blank between two words.
fn words(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_has_a_text() {
        for fault in ArmFault::one_of_each(7) {
            let event = ArmEvent { fault, at: Duration::from_millis(1500) };
            assert_eq!(fault.to_string().parse(), Ok(fault));
            assert_eq!(event.to_string().parse(), Ok(event));
            assert_eq!(fault.to_string().parse(), Ok(ArmEvent { fault, at: Duration::ZERO }));
        }
        let at = |time| Ok(ArmEvent { fault: ArmFault::InputLow(3), at: Duration::from_millis(time) });
        assert_eq!(" input  3 low   at  2s ".parse(), at(2000));
        assert_eq!("input 3 low at 250ms".parse(), at(250));
    }

    #[test]
    fn an_error_says_what_there_is() {
        let read = |text: &str| text.parse::<ArmEvent>().expect_err(text).to_string();
        assert_eq!(
            read(" crash "),
            "`crash`: expected one of `collide`, `press-emergency-stop`, `release-emergency-stop`, `cut-power`, `input 0 high`, \
             `input 0 low`, `tool-input 0 high`, `tool-input 0 low`"
        );
        assert_eq!(read("collide at 2"), "`collide`: a time may follow, as in `collide at 2s` or `… at 500ms`");
        for bad in [
            "",
            "at 2s",
            "collide at",
            "collide at -1s",
            "collide at nans",
            "collide at 2s 3s",
            "collide 2s",
            "collide 0",
        ] {
            assert!(bad.parse::<ArmEvent>().is_err(), "{bad}");
        }
        for bad in ["input 3", "input x high", "input -1 high", "input 3 on", "input 03 high", "input 3 high low"] {
            assert!(bad.parse::<ArmFault>().is_err(), "{bad}");
        }
    }
}
