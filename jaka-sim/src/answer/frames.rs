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
            let is_set = set(&mut state.tool_frames, command.id, command.offset, &command.name);
            if is_set { accept(command, out) } else { Outcome::Refused }
        }
        // Newer firmware has more frames.
        Request::SetToolId(command) if at(&mut state.tool_frames, command.tool_id).is_none() => Outcome::Refused,
        Request::SetToolId(command) => {
            state.tool_frame_id = command.tool_id;
            accept(command, out)
        }
        Request::GetToolOffsets(command) => reply(command, out, |reply| reply.offsets = offsets(&state.tool_frames)),
        Request::SetUserOffsets(command) => {
            let is_set = set(&mut state.user_frames, command.id, command.offset, &command.name);
            if is_set { accept(command, out) } else { Outcome::Refused }
        }
        Request::SetUserId(command) => {
            state.user_frame_id = command.user_frame_id;
            accept(command, out)
        }
        Request::GetUserOffsets(command) => reply(command, out, |reply| reply.offsets = offsets(&state.user_frames)),
        _ => Outcome::Unhandled,
    }
}

/// Sets a frame; false if there is none of this id, or it is fixed.
fn set(frames: &mut [Frame], id: i64, offset: Pose, name: &str) -> bool {
    let frame = at(frames, id).filter(|_| id != 0);
    frame.map(|frame| *frame = Frame { offset, name: name.to_owned() }).is_some()
}

fn at(frames: &mut [Frame], id: i64) -> Option<&mut Frame> {
    usize::try_from(id).ok().and_then(|id| frames.get_mut(id))
}

fn offsets(frames: &[Frame]) -> Vec<Pose> {
    frames.iter().map(|frame| frame.offset).collect()
}
