//! Tool frames and user frames.

use jaka_proto::Request;
use jaka_proto::messages::types::Pose;

use super::{Draft, Outcome, accept, reply};
use crate::state::Frame;
use crate::world::World;

pub(super) fn answer(request: &Request, world: &mut World, out: &mut Draft<'_>) -> Outcome {
    let state = &mut world.state;
    match request {
        Request::SetToolOffsets(command) => {
            set(&mut state.tool_frames, command.id, command.offset, &command.name, || accept(command, out))
        }
        Request::SetToolId(command) if has(&state.tool_frames, command.tool_id) => {
            state.tool_frame_id = command.tool_id;
            accept(command, out)
        }
        Request::GetToolOffsets(command) => reply(command, out, |reply| reply.offsets = offsets(&state.tool_frames)),
        Request::SetUserOffsets(command) => {
            set(&mut state.user_frames, command.id, command.offset, &command.name, || accept(command, out))
        }
        Request::SetUserId(command) if has(&state.user_frames, command.user_frame_id) => {
            state.user_frame_id = command.user_frame_id;
            accept(command, out)
        }
        Request::GetUserOffsets(command) => reply(command, out, |reply| reply.offsets = offsets(&state.user_frames)),
        Request::SetToolId(_) | Request::SetUserId(_) => Outcome::Refused,
        _ => Outcome::Unhandled,
    }
}

fn has(frames: &[Frame], id: i64) -> bool {
    usize::try_from(id).is_ok_and(|id| id < frames.len())
}

/// Sets a frame; the first is fixed, and frames that the controller does not have are refused.
fn set(frames: &mut [Frame], id: i64, offset: Pose, name: &str, accept: impl FnOnce() -> Outcome) -> Outcome {
    match usize::try_from(id).ok().filter(|id| *id > 0).and_then(|id| frames.get_mut(id)) {
        Some(frame) => {
            *frame = Frame { offset, name: name.to_owned() };
            accept()
        }
        None => Outcome::Refused,
    }
}

fn offsets(frames: &[Frame]) -> Vec<Pose> {
    frames.iter().map(|frame| frame.offset).collect()
}
