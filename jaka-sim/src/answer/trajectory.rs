//! Trajectory recording.

use jaka_proto::Request;
use jaka_proto::messages::trajectory::{GetExistTrajFileNameReply, GetTrajConfigReply, GetTrajSampleStatusReply};
use jaka_proto::wire::Writer;

use super::{Outcome, accept, is_on, reply};
use crate::State;
use crate::state::{Trajectory, TrajectoryConfig};

pub(super) fn answer(request: &Request, state: &mut State, out: &mut Writer) -> Outcome {
    let trajectory = &mut state.trajectory;
    match request {
        Request::SetTrajConfig(command) => {
            trajectory.config = TrajectoryConfig {
                acceleration: command.acceleration,
                speed: command.speed,
                position_interval: command.position_interval,
                orientation_interval: command.orientation_interval,
            };
            accept(command, out)
        }
        Request::GetTrajConfig(command) => reply(command, config(trajectory), out),
        Request::SetTrajSampleMode(command) => {
            trajectory.sampling = is_on(command.mode);
            if trajectory.sampling && !trajectory.file_names.contains(&command.file_name) {
                trajectory.file_names.push(command.file_name.clone());
            }
            accept(command, out)
        }
        Request::GetTrajSampleStatus(command) => {
            reply(command, GetTrajSampleStatusReply { sampling: trajectory.sampling }, out)
        }
        _ => files(request, trajectory, out),
    }
}

/// Files that there are not are refused.
fn files(request: &Request, trajectory: &mut Trajectory, out: &mut Writer) -> Outcome {
    let names = &mut trajectory.file_names;
    match request {
        Request::GetExistTrajFileName(command) => {
            reply(command, GetExistTrajFileNameReply { file_names: names.clone() }, out)
        }
        Request::RenameTrajFileName(command) => match names.iter_mut().find(|name| **name == command.source) {
            Some(name) => {
                name.clone_from(&command.destination);
                accept(command, out)
            }
            None => Outcome::Refused,
        },
        Request::RemoveTrajFile(command) if names.contains(&command.file_name) => {
            names.retain(|name| *name != command.file_name);
            accept(command, out)
        }
        Request::GenerateTrajExeFile(command) if names.contains(&command.file_name) => accept(command, out),
        Request::RemoveTrajFile(_) | Request::GenerateTrajExeFile(_) => Outcome::Refused,
        _ => Outcome::Unhandled,
    }
}

fn config(trajectory: &Trajectory) -> GetTrajConfigReply {
    let TrajectoryConfig { acceleration, speed, position_interval, orientation_interval } = trajectory.config;
    GetTrajConfigReply { acceleration, position_interval, orientation_interval, speed }
}
