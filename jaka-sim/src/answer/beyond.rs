//! What newer firmware tells, beyond the document.

use jaka_proto::messages::beyond_state::GetData;
use jaka_proto::wire::Writer;
use jaka_proto::{Command, ErrorCode, Request, write_refusal};
use serde_json::Map;

use super::{Draft, Outcome, reply};
use crate::spec_index::SpecIndex;
use crate::status_packet;
use crate::world::World;

/// A status packet with the keys of a reply.
pub(super) fn whole_status(world: &World, spec_index: &SpecIndex, out: &mut Writer) -> Outcome {
    let packet = status_packet::packet(&world.state, world.firmware, spec_index, &Map::new());
    write_refusal(Some(GetData::INFO.name), ErrorCode::SUCCESS, "", out);
    let envelope = out.as_str().trim_end_matches('}').to_owned();
    out.clear();
    out.raw(&envelope);
    out.raw(",");
    out.raw(String::from_utf8_lossy(&packet).trim_start_matches('{'));
    Outcome::Replied
}

pub(super) fn answer(request: &Request, world: &mut World, out: &mut Draft<'_>) -> Outcome {
    let state = &world.state;
    match request {
        Request::GetCurrToolId(command) => reply(command, out, |reply| reply.id = state.tool_frame_id),
        Request::GetCurrUserId(command) => reply(command, out, |reply| reply.id = state.user_frame_id),
        Request::GetActualJointPos(command) => reply(command, out, |reply| reply.joint_position = state.joint_position),
        Request::GetActualTcpPos(command) => reply(command, out, |reply| reply.pose = state.tcp_pose),
        Request::GetDigitalOutput(command) => reply(command, out, |reply| {
            reply.value = state.digital_outputs.get(&(command.kind, command.index)).copied().unwrap_or_default();
        }),
        Request::GetAnalogOutput(command) => reply(command, out, |reply| {
            reply.value = state.analog_outputs.get(&(command.kind, command.index)).copied().unwrap_or_default();
        }),
        _ => Outcome::Unhandled,
    }
}
