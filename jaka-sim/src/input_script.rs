//! Inputs that change by themselves.

use std::io;
use std::time::Duration;

use crate::State;

/// How an input changes by itself as the controller's time goes on, for [`Builder::input`](crate::Builder::input) and
/// [`Controller::input`](crate::Controller::input).
///
/// Inputs are given by their place in the list of the [`State`] and of status packets, from 0. Outside of the times that are given, an
/// input stays as it is.
///
/// ```
/// use std::time::Duration;
///
/// use jaka_sim::{AnalogInput, Controller, DigitalInput};
///
/// let part = DigitalInput::cabinet(3).high_at(Duration::from_secs(2)).low_at(Duration::from_secs(5));
/// let pressure = AnalogInput::tool(0).value_at(Duration::from_secs(1), 2.5);
/// let controller = Controller::builder().stepped_clock().input(part).input(pressure).start()?;
/// controller.advance(Duration::from_secs(3));
/// assert!(controller.state().digital_inputs[3]);
/// assert_eq!(controller.state().tool_analog_inputs[0], 2.5);
/// // From now on:
/// controller.input(DigitalInput::tool(1).high_at(Duration::from_millis(100)))?;
/// # Ok::<(), std::io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct InputScript(pub(crate) Vec<(Duration, InputChange)>);

/// A digital input, by its place in its list from 0, and when it changes.
#[derive(Debug, Clone, PartialEq)]
#[must_use = "a script does nothing until a controller has it"]
pub struct DigitalInput {
    side: Side,
    index: usize,
    levels: Vec<(Duration, bool)>,
}

/// An analog input, by its place in its list from 0, and when it changes.
#[derive(Debug, Clone, PartialEq)]
#[must_use = "a script does nothing until a controller has it"]
pub struct AnalogInput {
    side: Side,
    index: usize,
    values: Vec<(Duration, f64)>,
}

/// Where an input is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Side {
    Cabinet,
    Tool,
}

/// One change of an input.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum InputChange {
    Digital(Side, usize, bool),
    Analog(Side, usize, f64),
}

impl DigitalInput {
    /// An input in the list of the cabinet.
    pub fn cabinet(index: usize) -> Self {
        Self { side: Side::Cabinet, index, levels: Vec::new() }
    }

    /// An input of the tool.
    pub fn tool(index: usize) -> Self {
        Self { side: Side::Tool, index, levels: Vec::new() }
    }

    /// Goes high at a time.
    pub fn high_at(mut self, time: Duration) -> Self {
        self.levels.push((time, true));
        self
    }

    /// Goes low at a time.
    pub fn low_at(mut self, time: Duration) -> Self {
        self.levels.push((time, false));
        self
    }
}

impl AnalogInput {
    /// An input of the cabinet.
    pub fn cabinet(index: usize) -> Self {
        Self { side: Side::Cabinet, index, values: Vec::new() }
    }

    /// An input of the tool.
    pub fn tool(index: usize) -> Self {
        Self { side: Side::Tool, index, values: Vec::new() }
    }

    /// Has a value from a time on.
    pub fn value_at(mut self, time: Duration, value: f64) -> Self {
        self.values.push((time, value));
        self
    }
}

impl From<DigitalInput> for InputScript {
    fn from(DigitalInput { side, index, levels }: DigitalInput) -> Self {
        let change = |(at, is_high)| (at, InputChange::Digital(side, index, is_high));
        Self(levels.into_iter().map(change).collect())
    }
}

impl From<AnalogInput> for InputScript {
    fn from(AnalogInput { side, index, values }: AnalogInput) -> Self {
        let change = |(at, value)| (at, InputChange::Analog(side, index, value));
        Self(values.into_iter().map(change).collect())
    }
}

impl InputChange {
    pub(crate) fn check(self, state: &State) -> io::Result<()> {
        let (kind, side, index, count) = match self {
            Self::Digital(Side::Cabinet, index, _) => ("digital", "cabinet", index, state.digital_inputs.len()),
            Self::Digital(Side::Tool, index, _) => ("digital", "tool", index, state.tool_digital_inputs.len()),
            Self::Analog(Side::Cabinet, index, _) => ("analog", "cabinet", index, state.analog_inputs.len()),
            Self::Analog(Side::Tool, index, _) => ("analog", "tool", index, state.tool_analog_inputs.len()),
        };
        if index < count {
            return Ok(());
        }
        let text = format!("the {side} has {count} {kind} inputs, from 0, and not one with number {index}");
        Err(io::Error::new(io::ErrorKind::InvalidInput, text))
    }

    pub(crate) fn make(self, state: &mut State) {
        match self {
            Self::Digital(Side::Cabinet, index, is_high) => set(&mut state.digital_inputs, index, is_high),
            Self::Digital(Side::Tool, index, is_high) => set(&mut state.tool_digital_inputs, index, is_high),
            Self::Analog(Side::Cabinet, index, value) => set(&mut state.analog_inputs, index, value),
            Self::Analog(Side::Tool, index, value) => set(&mut state.tool_analog_inputs, index, value),
        }
    }
}

/// The list may have been made shorter since.
fn set<T>(list: &mut [T], index: usize, value: T) {
    if let Some(place) = list.get_mut(index) {
        *place = value;
    }
}
