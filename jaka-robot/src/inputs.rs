//! Inputs of the controller as status packets show them, and their numbering by a program.

use std::fmt;

#[cfg(doc)]
use jaka_proto::messages::status::RobotStatus;

use crate::cause::Field;
use crate::error::OptionName;
use crate::{Error, NotShown, Snapshot};

/// Number from which a program counts inputs, 0 or 1: said once, so that no call has to guess.
///
/// Packets of port 10000 list inputs without numbers. Here a number is the place in such a list, counted from the
/// number of the variant: with [`FromOne`](Self::FromOne), 3 is the third input of the list. A pendant, the print on a
/// cabinet and the indices of commands (4.25) may count differently, by controller: switch the input by hand and look
/// at a packet (`jaka status`) before anything relies on it. The first eight inputs of the cabinet's list are its own,
/// of which the controller occupies the first; the document calls the others Modbus inputs (4.26).
///
/// ```
/// use jaka_robot::Numbering;
///
/// const IO: Numbering = Numbering::FromOne;
/// assert_eq!(IO.tool(2).to_string(), "digital input 2 of the tool (counted from 1)");
/// assert_eq!(IO.cabinet(3).rises().to_string(), "digital input 3 of the cabinet (counted from 1) goes high");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Numbering {
    /// The first input is number 0.
    FromZero,
    /// The first input is number 1.
    FromOne,
}

impl Numbering {
    /// A digital input in the list of the cabinet ([`RobotStatus::digital_inputs`]).
    pub const fn cabinet(self, number: usize) -> Input {
        Input(InputPlace { side: Side::Cabinet, number, numbering: self })
    }

    /// A digital input of the tool ([`RobotStatus::tool_digital_inputs`]).
    pub const fn tool(self, number: usize) -> Input {
        Input(InputPlace { side: Side::Tool, number, numbering: self })
    }

    /// An analog input of the cabinet ([`RobotStatus::analog_inputs`]).
    pub const fn cabinet_analog(self, number: usize) -> AnalogInput {
        AnalogInput(InputPlace { side: Side::Cabinet, number, numbering: self })
    }

    /// An analog input of the tool ([`RobotStatus::tool_analog_inputs`]).
    pub const fn tool_analog(self, number: usize) -> AnalogInput {
        AnalogInput(InputPlace { side: Side::Tool, number, numbering: self })
    }
}

/// Place of an input.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
struct InputPlace {
    side: Side,
    number: usize,
    numbering: Numbering,
}

jaka_proto::worded! {
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    enum Side {
        Cabinet => "cabinet",
        Tool => "tool",
    }
}

/// A digital input, from a [`Numbering`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Input(InputPlace);

/// An analog input, from a [`Numbering`]. The document states no unit for its value.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct AnalogInput(InputPlace);

/// Kind of a condition: something is so, or becomes so from one packet to the next.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum When {
    Level,
    Edge,
}

/// A level or an edge of a digital input, to wait for or to guard a motion by.
///
/// An edge is seen between two packets. An edge that reverts before the next packet, some 30 to 100 ms later, is
/// missed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InputCondition(pub(crate) InputTest);

/// A level or an edge of an analog input, to wait for or to guard a motion by. Edges as of [`InputCondition`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AnalogCondition(pub(crate) InputTest);

/// Test of an input.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct InputTest {
    place: InputPlace,
    wanted: Wanted,
    pub(crate) when: When,
}

/// Wanted state of an input: the level of a digital one, or the range of an analog one's value.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Wanted {
    High,
    Low,
    Above(f64),
    Below(f64),
}

impl Input {
    /// Condition that the input is high.
    pub const fn is_high(self) -> InputCondition {
        InputCondition(self.0.test(Wanted::High, When::Level))
    }

    /// Condition that the input is low.
    pub const fn is_low(self) -> InputCondition {
        InputCondition(self.0.test(Wanted::Low, When::Level))
    }

    /// Condition that the input goes from low to high.
    pub const fn rises(self) -> InputCondition {
        InputCondition(self.0.test(Wanted::High, When::Edge))
    }

    /// Condition that the input goes from high to low.
    pub const fn falls(self) -> InputCondition {
        InputCondition(self.0.test(Wanted::Low, When::Edge))
    }
}

impl AnalogInput {
    /// Condition that the input's value is above a threshold.
    pub const fn is_above(self, threshold: f64) -> AnalogCondition {
        AnalogCondition(self.0.test(Wanted::Above(threshold), When::Level))
    }

    /// Condition that the input's value is below a threshold.
    pub const fn is_below(self, threshold: f64) -> AnalogCondition {
        AnalogCondition(self.0.test(Wanted::Below(threshold), When::Level))
    }

    /// Condition that the input's value goes above a threshold.
    pub const fn rises_above(self, threshold: f64) -> AnalogCondition {
        AnalogCondition(self.0.test(Wanted::Above(threshold), When::Edge))
    }

    /// Condition that the input's value goes below a threshold.
    pub const fn falls_below(self, threshold: f64) -> AnalogCondition {
        AnalogCondition(self.0.test(Wanted::Below(threshold), When::Edge))
    }
}

impl InputTest {
    /// True if the input has the wanted state.
    pub(crate) fn holds(&self, packet: &Snapshot) -> Result<bool, NotShown> {
        Ok(match self.wanted {
            Wanted::High => self.place.level(packet)?,
            Wanted::Low => !self.place.level(packet)?,
            Wanted::Above(threshold) => self.place.value(packet)? > threshold,
            Wanted::Below(threshold) => self.place.value(packet)? < threshold,
        })
    }

    pub(crate) fn check(&self) -> Result<(), Error> {
        self.place.check()?;
        match self.wanted {
            Wanted::Above(threshold) | Wanted::Below(threshold) if !threshold.is_finite() => {
                Err(OptionName::new("AnalogCondition", "threshold").refuse(threshold, "a finite number"))
            }
            _ => Ok(()),
        }
    }

    /// Text for the input in a packet.
    pub(crate) fn says(&self, packet: &Snapshot) -> Option<String> {
        if let Wanted::Above(_) | Wanted::Below(_) = self.wanted {
            return Some(format!("{} is at {}", AnalogInput(self.place), self.place.value(packet).ok()?));
        }
        let level = if self.place.level(packet).ok()? { "high" } else { "low" };
        Some(format!("{} is {level}", Input(self.place)))
    }
}

impl InputPlace {
    const fn test(self, wanted: Wanted, when: When) -> InputTest {
        InputTest { place: self, wanted, when }
    }

    /// The level of a digital input in a packet.
    fn level(self, packet: &Snapshot) -> Result<bool, NotShown> {
        let status = &packet.status;
        let (list, name) = match self.side {
            Side::Cabinet => (&status.digital_inputs, "digital_inputs"),
            Side::Tool => (&status.tool_digital_inputs, "tool_digital_inputs"),
        };
        self.read(list.as_ref(), Field { packet, name })
    }

    /// The value of an analog input in a packet.
    fn value(self, packet: &Snapshot) -> Result<f64, NotShown> {
        let status = &packet.status;
        let (list, name) = match self.side {
            Side::Cabinet => (&status.analog_inputs, "analog_inputs"),
            Side::Tool => (&status.tool_analog_inputs, "tool_analog_inputs"),
        };
        self.read(list.as_ref(), Field { packet, name })
    }

    /// Its place in a list, counted from 0; none for a number 0 that is counted from 1.
    fn index(self) -> Option<usize> {
        match self.numbering {
            Numbering::FromZero => Some(self.number),
            Numbering::FromOne => self.number.checked_sub(1),
        }
    }

    fn check(self) -> Result<(), Error> {
        let number = OptionName::new("Numbering", "number");
        let invalid = || number.refuse(self.number, "at least 1, since inputs are counted from 1");
        self.index().map(drop).ok_or_else(invalid)
    }

    fn read<T: Copy>(self, list: Option<&Vec<T>>, field: Field<'_>) -> Result<T, NotShown> {
        let list = field.shown(list)?;
        let too_short = || NotShown::TooShort { field: field.name.to_owned(), count: list.len() };
        self.index().and_then(|index| list.get(index)).copied().ok_or_else(too_short)
    }
}

impl fmt::Display for InputPlace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let first = match self.numbering {
            Numbering::FromZero => 0,
            Numbering::FromOne => 1,
        };
        write!(f, "input {} of the {} (counted from {first})", self.number, self.side)
    }
}

impl fmt::Display for Input {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "digital {}", self.0)
    }
}

impl fmt::Display for AnalogInput {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "analog {}", self.0)
    }
}

impl fmt::Display for InputTest {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let verb = if self.when == When::Edge { "goes" } else { "is" };
        let (digital, analog) = (Input(self.place), AnalogInput(self.place));
        match self.wanted {
            Wanted::High => write!(f, "{digital} {verb} high"),
            Wanted::Low => write!(f, "{digital} {verb} low"),
            Wanted::Above(threshold) => write!(f, "{analog} {verb} above {threshold}"),
            Wanted::Below(threshold) => write!(f, "{analog} {verb} below {threshold}"),
        }
    }
}

impl fmt::Display for InputCondition {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl fmt::Display for AnalogCondition {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}
