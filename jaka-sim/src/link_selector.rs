//! Selection of links: of one port or both, in one direction or both.

use crate::Port;

jaka_proto::worded! {
    /// Direction of the bytes between a port and its clients, displayed as in the text of a
    /// [`Happening`](crate::Happening).
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[expect(clippy::exhaustive_enums, reason = "a connection has these two")]
    pub enum Direction {
        /// From clients to the controller, for requests. Clients of the status port can only send the end of their
        /// connection.
        ToController => "to-controller",
        /// From the controller to clients, for replies and status packets.
        ToClient => "to-client",
    }
}

impl Direction {
    /// Both directions.
    pub const ALL: [Self; 2] = [Self::ToController, Self::ToClient];
}

/// Word in a text for both ports, and for both directions.
pub(crate) const BOTH: &str = "both";

/// Selected links; `None` means both.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct LinkSelector {
    pub(crate) port: Option<Port>,
    pub(crate) direction: Option<Direction>,
}

impl LinkSelector {
    /// Returns an iterator over the selected links.
    pub(crate) fn each(self) -> impl Iterator<Item = (Port, Direction)> {
        let ports = Port::ALL.into_iter().filter(move |port| self.port.is_none_or(|chosen| chosen == *port));
        let chosen = move |direction: &Direction| self.direction.is_none_or(|chosen| chosen == *direction);
        ports.flat_map(move |port| Direction::ALL.into_iter().filter(chosen).map(move |direction| (port, direction)))
    }
}
