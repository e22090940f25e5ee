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
            set(&mut state.tool_frames, command.id, command.offset, &command.name);
            accept(command, out)
        }
        Request::SetToolId(command) => {
            state.tool_frame_id = command.tool_id;
            accept(command, out)
        }
        Request::GetToolOffsets(command) => reply(command, out, |reply| reply.offsets = offsets(&state.tool_frames)),
        Request::SetUserOffsets(command) => {
            set(&mut state.user_frames, command.id, command.offset, &command.name);
            accept(command, out)
        }
        Request::SetUserId(command) => {
            state.user_frame_id = command.user_frame_id;
            accept(command, out)
        }
        Request::GetUserOffsets(command) => reply(command, out, |reply| reply.offsets = offsets(&state.user_frames)),
        _ => Outcome::Unhandled,
    }
}

/// Ids that do not exist have been refused before.
fn set(frames: &mut [Frame], id: i64, offset: Pose, name: &str) {
    if let Some(frame) = usize::try_from(id).ok().and_then(|id| frames.get_mut(id)) {
        *frame = Frame { offset, name: name.to_owned() };
    }
}

fn offsets(frames: &[Frame]) -> Vec<Pose> {
    frames.iter().map(|frame| frame.offset).collect()
}
