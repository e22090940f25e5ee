//! Which of a controller's ports something came from, by what it is: addresses are mixed up.

use jaka_proto::Envelope;
use jaka_proto::messages::status::RobotStatus;
use jaka_proto::wire::{Decode, Reader};

/// True for the reply to a command.
pub(crate) fn is_reply(text: &str) -> bool {
    Envelope::read(text).is_ok_and(|envelope| envelope.command.is_some() && envelope.code.is_ok())
}

/// True for a status packet, which has no key that it must have.
pub(crate) fn is_status(text: &str) -> bool {
    let names_a_command = Envelope::read(text).is_ok_and(|envelope| envelope.command.is_some());
    let status = RobotStatus::decode(&mut Reader::new(text));
    let shows_the_arm = |status: RobotStatus| {
        status.joint_actual_position.is_some() || status.in_position.is_some() || status.enabled.is_some()
    };
    !names_a_command && status.is_ok_and(shows_the_arm)
}
