//! Tool frames and user frames.

use jaka_proto::Request;
use jaka_proto::messages::types::Pose;

use super::{Draft, Outcome, reply};
use crate::state::{FRAMES, Frame};
use crate::world::World;

pub(super) fn answer(request: &Request, world: &mut World, out: &mut Draft<'_>) -> Outcome {
    let state = &mut world.state;
    match request {
        Request::GetToolOffsets(command) => reply(command, out, |reply| reply.offsets = offsets(&state.tool_frames)),
        Request::GetUserOffsets(command) => reply(command, out, |reply| reply.offsets = offsets(&state.user_frames)),
        Request::SetToolOffsets(command) => set(&mut state.tool_frames, command.id, command.offset, &command.name),
        Request::SetUserOffsets(command) => set(&mut state.user_frames, command.id, command.offset, &command.name),
        Request::SetToolId(command) => choose(&mut state.tool_frame_id, command.tool_id),
        Request::SetUserId(command) => choose(&mut state.user_frame_id, command.user_frame_id),
        Request::GetCurrToolId(command) => reply(command, out, |reply| reply.id = state.tool_frame_id),
        Request::GetCurrUserId(command) => reply(command, out, |reply| reply.id = state.user_frame_id),
        _ => Outcome::Unhandled,
    }
}

/// Chooses the frame in use, if there is one with this id.
fn choose(used: &mut i64, id: i64) -> Outcome {
    let exists = usize::try_from(id).is_ok_and(|id| id < FRAMES);
    *used = if exists { id } else { *used };
    Outcome::accepted_if(exists)
}

/// Sets a frame, if there is one with this id: the first is fixed.
fn set(frames: &mut [Frame], id: i64, offset: Pose, name: &str) -> Outcome {
    let frame = usize::try_from(id).ok().filter(|id| *id > 0).and_then(|id| frames.get_mut(id));
    let set = frame.map(|frame| *frame = Frame { offset, name: name.to_owned() });
    Outcome::accepted_if(set.is_some())
}

fn offsets(frames: &[Frame]) -> Vec<Pose> {
    frames.iter().map(|frame| frame.offset).collect()
}
