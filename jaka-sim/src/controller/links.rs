//! What a controller's owner has go wrong with its links.

use std::time::Duration;

use super::Controller;
use crate::link_selector::LinkSelector;
use crate::{Direction, Happening, LinkFault, Port};

/// The links between a controller's ports and its clients, of one port or both, in one direction or both.
///
/// What is set holds for the connections that are open and for those to come, until something else is set. See
/// [`LinkFault`] for what each does.
///
/// ```
/// use std::time::Duration;
///
/// use jaka_sim::{Controller, Port};
///
/// let controller = Controller::start()?;
/// controller.links().hold(); // nothing passes any more
/// controller.links().release(); // all that has waited passes at once
/// controller.link(Port::Status).to_client().delay(Duration::from_millis(800));
/// controller.link(Port::Command).to_controller().cut();
/// # Ok::<(), std::io::Error>(())
/// ```
#[derive(Debug, Clone, Copy)]
#[must_use = "links stay as they are until something is set"]
pub struct Link<'c> {
    controller: &'c Controller,
    selector: LinkSelector,
}

impl Controller {
    /// The links of a port, in both directions.
    pub fn link(&self, port: Port) -> Link<'_> {
        Link { controller: self, selector: LinkSelector { port: Some(port), direction: None } }
    }

    /// The links of both ports, in both directions.
    pub fn links(&self) -> Link<'_> {
        Link { controller: self, selector: LinkSelector::default() }
    }
}

impl Link<'_> {
    /// In one direction alone.
    pub fn direction(self, direction: Direction) -> Self {
        Self { selector: LinkSelector { direction: Some(direction), ..self.selector }, ..self }
    }

    /// In the direction of what clients receive alone: replies and status packets.
    pub fn to_client(self) -> Self {
        self.direction(Direction::ToClient)
    }

    /// In the direction of what clients send alone: requests.
    pub fn to_controller(self) -> Self {
        self.direction(Direction::ToController)
    }

    /// Sets what is wrong from now on: [`Happening::Link`].
    pub fn set(self, fault: LinkFault) {
        self.controller.shared.command_listener.wait_until_accepted();
        self.controller.shared.status_listener.wait_until_accepted();
        let LinkSelector { port, direction } = self.selector;
        self.controller.shared.world().happen(&Happening::Link { port, direction, fault });
    }

    /// Lets nothing pass: [`LinkFault::Hold`].
    pub fn hold(self) {
        self.set(LinkFault::Hold);
    }

    /// Makes each byte arrive this much later: [`LinkFault::Delay`].
    pub fn delay(self, time: Duration) {
        self.set(LinkFault::Delay(time));
    }

    /// Lets this many bytes a second pass: [`LinkFault::Slow`]. Bytes that were held pass at this rate, too.
    pub fn slow(self, bytes_per_second: u64) {
        self.set(LinkFault::Slow(bytes_per_second));
    }

    /// Lets nothing pass ever again on the connections that there are: [`LinkFault::Cut`].
    pub fn cut(self) {
        self.set(LinkFault::Cut);
    }

    /// Lets everything pass at once, also what has been held: [`LinkFault::None`].
    pub fn release(self) {
        self.set(LinkFault::None);
    }
}
