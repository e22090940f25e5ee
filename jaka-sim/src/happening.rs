//! Events of the arm, of inputs and of links, and their times.

use std::fmt;
use std::io;
use std::str::FromStr;
use std::time::Duration;

use jaka_proto::worded;

use crate::fault::{Argument, TokenReader, kinds, quoted};
use crate::link::Links;
use crate::link_selector::{BOTH, LinkSelector};
use crate::{Direction, LinkFault, Port, ScriptError, State};

worded! {
    /// Level of a digital input, displayed as in a text.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[expect(clippy::exhaustive_enums, reason = "a digital input has these two")]
    pub enum Level {
        /// Off.
        Low => "low",
        /// On.
        High => "high",
    }
}

kinds! {
    /// Event of the arm, of an input or of the links: at a time by [`Builder::at`](crate::Builder::at) and
    /// [`Controller::at`](crate::Controller::at), on a condition by [`Controller::when`](crate::Controller::when).
    ///
    /// An index of an input is its place in the list of the [`State`] and of status packets, from 0. A value stays
    /// until the next change.
    ///
    /// An event has a text form, as for `jaka sim --schedule`.
    ///
    /// ```
    /// use jaka_sim::{Happening, Level};
    ///
    /// assert_eq!("input 3 high".parse(), Ok(Happening::Input(3, Level::High)));
    /// assert_eq!(Happening::PressEmergencyStop.to_string(), "press-emergency-stop");
    /// ```
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub enum Happening("what can happen", unknown);

    /// Applies the event. Ignores an input that the controller does not have.
    pub(crate) fn happen(&self, state: &mut State, links: &Links) -> ();

    /// Collision: a protective stop and the error `0xf0034`, until `clear_error`. `collide` as a text.
    Collide: "collide" => state.collide();

    /// Press of the emergency stop: the arm is disabled, and cannot be enabled. `press-emergency-stop` as a text.
    PressEmergencyStop: "press-emergency-stop" => state.emergency_stop = true;

    /// Release of the emergency stop. The arm stays disabled until it is enabled again. `release-emergency-stop` as a
    /// text.
    ReleaseEmergencyStop: "release-emergency-stop" => state.emergency_stop = false;

    /// Loss of the arm's power. `cut-power` as a text.
    CutPower: "cut-power" => state.powered = false;

    /// New level of a digital input of the cabinet. `input 3 high` as a text.
    Input(index: usize as index = 3, level: Level as level = Level::High): "input" => {
        set(&mut state.digital_inputs, *index, *level == Level::High);
    };

    /// New level of a digital input of the tool. `tool-input 0 low` as a text.
    ToolInput(index: usize as index = 0, level: Level as level = Level::Low): "tool-input" => {
        set(&mut state.tool_digital_inputs, *index, *level == Level::High);
    };

    /// New value of an analog input of the cabinet, in the unit of status packets. `analog-input 3 2.5` as a text.
    AnalogInput(index: usize as index = 3, value: f64 as value = 2.5): "analog-input" => {
        set(&mut state.analog_inputs, *index, *value);
    };

    /// New value of an analog input of the tool, in the unit of status packets. `tool-analog-input 0 2.5` as a text.
    ToolAnalogInput(index: usize as index = 0, value: f64 as value = 2.5): "tool-analog-input" => {
        set(&mut state.tool_analog_inputs, *index, *value);
    };

    /// New fault of links, or its end. `link status to-client hold` as a text, or `link both both none`.
    Link {
        /// Port of the links; both ports if `None`.
        port: Option<Port> as port = Some(Port::Status),
        /// Direction of the links; both directions if `None`.
        direction: Option<Direction> as direction = Some(Direction::ToClient),
        /// Fault.
        fault: LinkFault as link_fault = LinkFault::Hold,
    }: "link" => links.set(LinkSelector { port: *port, direction: *direction }, *fault);
}

impl Happening {
    /// Returns an error for an input that the controller does not have.
    pub(crate) fn check(&self, state: &State) -> io::Result<()> {
        let (kind, side, index, count) = match self {
            Self::Input(index, _) => ("digital", "cabinet", *index, state.digital_inputs.len()),
            Self::ToolInput(index, _) => ("digital", "tool", *index, state.tool_digital_inputs.len()),
            Self::AnalogInput(index, _) => ("analog", "cabinet", *index, state.analog_inputs.len()),
            Self::ToolAnalogInput(index, _) => ("analog", "tool", *index, state.tool_analog_inputs.len()),
            Self::Collide
            | Self::PressEmergencyStop
            | Self::ReleaseEmergencyStop
            | Self::CutPower
            | Self::Link { .. } => return Ok(()),
        };
        if index < count {
            return Ok(());
        }
        let text = format!("the {side} has {count} {kind} inputs, from 0, and not one with number {index}");
        Err(io::Error::new(io::ErrorKind::InvalidInput, text))
    }
}

/// Applies a fault to all links, in both directions.
impl From<LinkFault> for Happening {
    fn from(fault: LinkFault) -> Self {
        Self::Link { port: None, direction: None, fault }
    }
}

fn unknown(_word: &str) -> String {
    format!("expected one of {}", quoted(&Happening::one_of_each()))
}

/// Sets an element. The list may be shorter than at the check.
fn set<T>(list: &mut [T], index: usize, value: T) {
    if let Some(place) = list.get_mut(index) {
        *place = value;
    }
}

impl Argument for Level {
    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, " {self}")
    }
}

impl Argument for LinkFault {
    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, " {self}")
    }
}

impl Argument for Option<Port> {
    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write_chosen(self.as_ref(), f)
    }
}

impl Argument for Option<Direction> {
    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write_chosen(self.as_ref(), f)
    }
}

fn write_chosen(chosen: Option<&impl fmt::Display>, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    match chosen {
        Some(chosen) => write!(f, " {chosen}"),
        None => write!(f, " {BOTH}"),
    }
}

impl TokenReader<'_, '_> {
    fn index(&mut self) -> Result<usize, ScriptError> {
        self.number("the number of an input, from 0")
    }

    fn level(&mut self) -> Result<Level, ScriptError> {
        let levels = [Level::High, Level::Low];
        let wanted = levels.map(|level| format!("`{level}`")).join(" or ");
        let word = self.word(&wanted)?.text;
        let level = levels.into_iter().find(|level| level.to_string() == word);
        level.ok_or_else(|| self.unfit(format!("expected {wanted}")))
    }

    fn value(&mut self) -> Result<f64, ScriptError> {
        const WANTED: &str = "a number";
        let value: f64 = self.number(WANTED)?;
        if value.is_finite() { Ok(value) } else { Err(self.unfit(format!("expected {WANTED}"))) }
    }

    fn port(&mut self) -> Result<Option<Port>, ScriptError> {
        self.chosen(Port::ALL, "`command`, `status` or `both`")
    }

    fn direction(&mut self) -> Result<Option<Direction>, ScriptError> {
        self.chosen(Direction::ALL, "`to-controller`, `to-client` or `both`")
    }

    /// Reads the name of one of the items; `None` for both.
    fn chosen<T: ToString>(&mut self, items: [T; 2], what: &str) -> Result<Option<T>, ScriptError> {
        let word = self.word(what)?.text;
        let found = items.into_iter().find(|item| item.to_string() == word);
        if found.is_some() || word == BOTH { Ok(found) } else { Err(self.unfit(format!("expected {what}"))) }
    }

    fn link_fault(&mut self) -> Result<LinkFault, ScriptError> {
        LinkFault::read(self)
    }
}

/// Event and its time since the start of the controller: `collide at 2s` as a text, and at once without a time.
///
/// ```
/// use jaka_sim::{Controller, Scheduled};
///
/// let mut builder = Controller::builder();
/// for text in "collide at 2s, input 3 high at 1500ms, link status to-client hold".split(',') {
///     let Scheduled { happening, at } = text.parse()?;
///     builder = builder.at(at, happening);
/// }
/// # Ok::<(), jaka_sim::ScriptError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scheduled {
    /// Event.
    pub happening: Happening,
    /// Time since the start, by the controller's clock.
    pub at: Duration,
}

impl FromStr for Scheduled {
    type Err = ScriptError;

    /// Reads the text form.
    ///
    /// # Errors
    /// The event is unknown, or the text after it is not a time.
    fn from_str(text: &str) -> Result<Self, ScriptError> {
        TokenReader::read_all(text, |tokens| {
            let happening = Happening::read(tokens)?;
            if tokens.is_empty() {
                return Ok(Self { happening, at: Duration::ZERO });
            }
            if tokens.word("")?.text == "at" {
                return Ok(Self { happening, at: tokens.time()? });
            }
            Err(tokens.unfit(format!("a time may follow, as in `{happening} at 2s`")))
        })
    }
}

impl fmt::Display for Scheduled {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} at {:?}", self.happening, self.at)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_has_a_text() {
        let mut all = Happening::one_of_each();
        all.extend([Happening::Input(7, Level::Low), Happening::ToolInput(1, Level::High), LinkFault::None.into()]);
        for (port, direction) in [(Some(Port::Command), None), (None, Some(Direction::ToController))] {
            let faults = LinkFault::one_of_each().into_iter();
            all.extend(faults.map(|fault| Happening::Link { port, direction, fault }));
        }
        for happening in all {
            let scheduled = Scheduled { happening, at: Duration::from_millis(1500) };
            assert_eq!(happening.to_string().parse(), Ok(happening));
            assert_eq!(scheduled.to_string().parse(), Ok(scheduled));
            assert_eq!(happening.to_string().parse(), Ok(Scheduled { happening, at: Duration::ZERO }));
        }
        let at = |time| Ok(Scheduled { happening: Happening::Input(3, Level::Low), at: Duration::from_millis(time) });
        assert_eq!(" input  3 low   at  2s ".parse(), at(2000));
        assert_eq!("input 3 low at 250ms".parse(), at(250));
    }

    #[test]
    fn an_error_says_what_there_is() {
        let cases = [
            (
                " crash ",
                "`crash`: expected one of `collide`, `press-emergency-stop`, `release-emergency-stop`, `cut-power`, `input 3 high`, \
                 `tool-input 0 low`, `analog-input 3 2.5`, `tool-analog-input 0 2.5`, `link status to-client hold`",
            ),
            ("", "``: expected what can happen next"),
            ("collide at", "`at`: expected a time such as 200ms or 1.5s next"),
            ("collide at 2", "`2`: expected a time such as 200ms or 1.5s"),
            ("collide 2s", "`2s`: a time may follow, as in `collide at 2s`"),
            ("collide at 2s 3s", "`3s`: expected the end of the line"),
            ("input 3", "`3`: expected `high` or `low` next"),
            ("input 3 on", "`on`: expected `high` or `low`"),
            ("input -1 high", "`-1`: expected the number of an input, from 0"),
            ("analog-input 3 x", "`x`: expected a number"),
            ("link", "`link`: expected `command`, `status` or `both` next"),
            ("link arm", "`arm`: expected `command`, `status` or `both`"),
            ("link both up", "`up`: expected `to-controller`, `to-client` or `both`"),
            ("link both both drop", "`drop`: unknown fault of a link"),
            ("link both both slow x", "`x`: expected a number of bytes a second"),
        ];
        for (text, message) in cases {
            let error = text.parse::<Scheduled>().expect_err(text);
            assert_eq!(error.to_string(), message);
        }
    }
}
