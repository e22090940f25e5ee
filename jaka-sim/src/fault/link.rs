//! What can be wrong with a link between a port and its clients.

use std::fmt;
use std::time::Duration;

use super::kinds::kinds;
use super::{ScriptError, TokenReader};
use crate::link_selector::{BOTH, LinkSelector};
use crate::{Direction, Port};

/// Whether bytes pass on a link.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Passage {
    /// All that waits passes now.
    Now,
    /// The first bytes that wait pass after this time.
    After(Duration),
    /// So many bytes pass in a second.
    Paced(u64),
    /// Nothing passes until the fault changes.
    Held,
    /// Nothing passes ever again.
    Lost,
}

kinds! {
    /// Something wrong with a link: what passes between a port and its clients in one direction, and when.
    ///
    /// [`Controller::link`](crate::Controller::link) sets it on a running controller, and [`FaultPlan::link`] from the start. It
    /// applies to the connections that are open and to later ones, until another fault is set. Times are real times, also with a
    /// stepped clock. A link has no message boundaries: it passes bytes, and the end of a connection after them.
    ///
    /// The system makes the connection itself, which succeeds on a link on which nothing passes.
    ///
    /// [`FaultPlan::link`]: crate::FaultPlan::link
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    #[non_exhaustive]
    pub enum LinkFault("a fault of a link", |_| "unknown fault of a link");

    /// Whether bytes pass, if the first of them has waited for `age`.
    pub(crate) fn passage(&self, age: Duration) -> Passage;

    /// Nothing: what is sent passes at once, and so does all that is held. `none` in a script.
    #[default]
    None: "none" => Passage::Now;

    /// Nothing passes until another fault is set. `hold` in a script.
    ///
    /// To the client: what the controller sends waits, and then arrives as it was sent: old status packets, replies of long ago.
    /// When 16 MiB wait, the controller ends the connection; the client gets these, and then the end.
    ///
    /// To the controller: requests are neither read nor carried out, nor is the end of the connection noticed. The systems'
    /// buffers go on taking what the client sends, some hundred kilobytes, and acknowledge it.
    Hold: "hold" => Passage::Held;

    /// Each byte arrives this much later, in order, in the same portions as without. `delay 800ms` in a script.
    ///
    /// Requests are carried out, and answered, this much later.
    Delay(time: Duration as time = Duration::from_millis(80)): "delay" => match time.saturating_sub(age) {
        Duration::ZERO => Passage::Now,
        left => Passage::After(left),
    };

    /// So many bytes pass in a second, and at least one. `slow 9600` in a script.
    ///
    /// What has been held goes on at this pace, and so does all that follows, until another fault is set.
    Slow(per_second: u64 as rate = 20_000): "slow" => Passage::Paced(*per_second);

    /// Nothing passes ever again, as with a pulled cable: no byte, no end of the connection, no reset. `cut` in a script.
    ///
    /// A connection that has been cut stays so, and so does one that is made meanwhile. When another fault is set, it is for the
    /// connections that follow.
    Cut: "cut" => Passage::Lost;
}

/// A [`LinkFault`] of a [`FaultPlan`](crate::FaultPlan): on which links, and when.
///
/// Without more it is for both ports and both directions, and from the start of the controller on.
///
/// ```
/// use std::time::Duration;
///
/// use jaka_sim::{FaultPlan, LinkEvent, LinkFault, Port};
///
/// let stall = LinkEvent::new(LinkFault::Hold).port(Port::Status).to_client();
/// let plan = FaultPlan::new().link(stall.after(Duration::from_secs(10)).lasting(Duration::from_secs(5)));
/// assert_eq!(plan.to_string(), "link status to-client hold after 10s for 5s");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[must_use = "an event does nothing without a plan"]
pub struct LinkEvent {
    pub(crate) selector: LinkSelector,
    pub(crate) fault: LinkFault,
    pub(crate) after: Duration,
    pub(crate) lasting: Option<Duration>,
}

impl LinkEvent {
    /// A fault of both ports in both directions, from the start of the controller on.
    pub fn new(fault: LinkFault) -> Self {
        Self { selector: LinkSelector::default(), fault, after: Duration::ZERO, lasting: None }
    }

    /// Is for one port alone.
    pub fn port(self, port: Port) -> Self {
        Self { selector: LinkSelector { port: Some(port), ..self.selector }, ..self }
    }

    /// Is for one direction alone.
    pub fn direction(self, direction: Direction) -> Self {
        Self { selector: LinkSelector { direction: Some(direction), ..self.selector }, ..self }
    }

    /// Is for what clients receive alone.
    pub fn to_client(self) -> Self {
        self.direction(Direction::ToClient)
    }

    /// Is for what clients send alone.
    pub fn to_controller(self) -> Self {
        self.direction(Direction::ToController)
    }

    /// Begins this long after the start of the controller, in real time.
    pub fn after(self, time: Duration) -> Self {
        Self { after: time, ..self }
    }

    /// Ends this long after it began, in real time: then the links are as they should be. Nothing else ends it if not set.
    pub fn lasting(self, time: Duration) -> Self {
        Self { lasting: Some(time), ..self }
    }

    /// Reads a link, its fault, and when it is so, as `status to-client hold after 10s for 5s`.
    pub(super) fn read(tokens: &mut TokenReader<'_, '_>) -> Result<Self, ScriptError> {
        let port = one_of(tokens, Port::ALL, "`command`, `status` or `both`")?;
        let direction = one_of(tokens, Direction::ALL, "`to-controller`, `to-client` or `both`")?;
        let mut event = Self { selector: LinkSelector { port, direction }, ..Self::new(LinkFault::read(tokens)?) };
        if tokens.is_next("after") {
            event = event.after(tokens.skip().time()?);
        }
        if tokens.is_next("for") {
            event = event.lasting(tokens.skip().time()?);
        }
        Ok(event)
    }
}

/// Reads one of these by its name; `None` for both.
fn one_of<T: ToString>(tokens: &mut TokenReader<'_, '_>, items: [T; 2], what: &str) -> Result<Option<T>, ScriptError> {
    let word = tokens.word(what)?;
    let found = items.into_iter().find(|item| item.to_string() == word.text);
    if found.is_some() || word.text == BOTH { Ok(found) } else { Err(word.error(format!("expected {what}"))) }
}

impl From<LinkFault> for LinkEvent {
    fn from(fault: LinkFault) -> Self {
        Self::new(fault)
    }
}

/// A line of a script.
impl fmt::Display for LinkEvent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "link {} {}", self.selector, self.fault)?;
        if !self.after.is_zero() {
            write!(f, " after {:?}", self.after)?;
        }
        self.lasting.map_or(Ok(()), |time| write!(f, " for {time:?}"))
    }
}
