//! Trajectory recording.

use jaka_proto::Request;
use jaka_proto::messages::trajectory::SetTrajSampleMode;

use super::{Draft, Outcome, is_on, reply};
use crate::programs::replay;
use crate::world::World;

/// How many trajectory files a controller keeps.
const MOST_FILES: usize = 1000;

pub(super) fn answer(request: &Request, world: &mut World, out: &mut Draft<'_>) -> Outcome {
    let trajectory = &mut world.state.trajectory;
    match request {
        Request::SetTrajSampleMode(command) => Outcome::accepted_if(sample(command, world)),
        Request::GetTrajSampleStatus(command) => reply(command, out, |reply| reply.sampling = trajectory.sampling),
        Request::GetExistTrajFileName(command) => {
            reply(command, out, |reply| reply.file_names.clone_from(&trajectory.file_names))
        }
        _ => files(request, world),
    }
}

/// Starts a recording, or keeps what has been recorded; false if there are too many files.
fn sample(command: &SetTrajSampleMode, world: &mut World) -> bool {
    let trajectory = &mut world.state.trajectory;
    let now = world.state.joint_position.0;
    if is_on(command.mode) {
        if !trajectory.file_names.contains(&command.file_name) {
            if trajectory.file_names.len() >= MOST_FILES {
                return false;
            }
            trajectory.file_names.push(command.file_name.clone());
        }
        world.recorder = Some((command.file_name.clone(), vec![now]));
    } else if let Some((name, mut points)) = world.recorder.take() {
        points.push(now);
        world.recordings.insert(name, points);
    }
    trajectory.sampling = is_on(command.mode);
    true
}

/// Files that do not exist are refused.
fn files(request: &Request, world: &mut World) -> Outcome {
    match request {
        Request::RenameTrajFileName(command) => {
            return Outcome::accepted_if(rename(world, &command.source, &command.destination));
        }
        Request::RemoveTrajFile(command) if exists(world, &command.file_name) => {
            world.state.trajectory.file_names.retain(|name| *name != command.file_name);
            world.recordings.remove(&command.file_name);
        }
        Request::GenerateTrajExeFile(command) if exists(world, &command.file_name) => {
            let points = world.recordings.get(&command.file_name).map_or(&[][..], |points| points);
            world.programs.insert(program_name(&command.file_name), replay(points));
        }
        Request::RemoveTrajFile(_) | Request::GenerateTrajExeFile(_) => return Outcome::Refused,
        _ => return Outcome::Unhandled,
    }
    Outcome::Accepted
}

fn exists(world: &World, name: &String) -> bool {
    world.state.trajectory.file_names.contains(name)
}

fn rename(world: &mut World, source: &str, destination: &str) -> bool {
    let names = &mut world.state.trajectory.file_names;
    if names.iter().any(|name| name == destination) {
        return false;
    }
    let Some(name) = names.iter_mut().find(|name| *name == source) else {
        return false;
    };
    destination.clone_into(name);
    if let Some(points) = world.recordings.remove(source) {
        world.recordings.insert(destination.to_owned(), points);
    }
    true
}

/// The name of the program that is made from a trajectory, as `load_program` takes it.
fn program_name(file_name: &str) -> String {
    format!("track/{file_name}.jks")
}
