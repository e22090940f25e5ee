//! Arrival of replies and status packets on a faulty link: all in time, at the release of the link, or never.

use jaka_sim::{Direction, LinkFault, Port};

use super::status::Packets;
use super::{Found, Replies, When};
use crate::link::LinkTrouble;

pub(super) fn comes(trouble: &LinkTrouble) -> (Replies, Packets) {
    // A reply needs its request; a packet needs none.
    let is_asked = Direction::ALL.into_iter().any(|direction| trouble.is_on(Port::Command, direction));
    let is_told = trouble.is_on(Port::Status, Direction::ToClient);
    let when = if is_asked { when(trouble) } else { When::InTime };
    let packets = match when_told(trouble, is_told) {
        When::InTime => Packets::Good,
        When::Never => Packets::Gone,
        _ => Packets::None,
    };
    (Replies { when, found: vec![Found::Own] }, packets)
}

fn when_told(trouble: &LinkTrouble, is_told: bool) -> When {
    if is_told { when(trouble) } else { When::InTime }
}

fn when(trouble: &LinkTrouble) -> When {
    match trouble.fault {
        LinkFault::Cut => When::Never,
        _ if trouble.is_in_time() => When::InTime,
        _ => When::Released,
    }
}
