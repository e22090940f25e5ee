//! Trajectory recording.

use jaka_proto::messages::trajectory::SetTrajSampleMode;

use super::is_on;
use crate::programs::replay;
use crate::world::World;

/// Greatest number of trajectory files of a controller.
const MOST_FILES: usize = 1000;

/// Starts a recording, or ends and stores it; returns false if there are too many files.
pub(super) fn sample(command: &SetTrajSampleMode, world: &mut World) -> bool {
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

/// Removes a file; returns false if there is none.
pub(super) fn remove(world: &mut World, name: &str) -> bool {
    world.recordings.remove(name);
    let names = &mut world.state.trajectory.file_names;
    let before = names.len();
    names.retain(|own| own != name);
    names.len() < before
}

/// Creates a program from a file; returns false if there is none.
pub(super) fn generate(world: &mut World, name: &str) -> bool {
    let points = world.recordings.get(name).map_or(&[][..], |points| points);
    let exists = world.state.trajectory.file_names.iter().any(|own| own == name);
    if exists {
        // Name for `load_program`.
        world.programs.insert(format!("track/{name}.jks"), replay(points));
    }
    exists
}

/// Renames a file; returns false if there is none, or the new name is taken.
pub(super) fn rename(world: &mut World, source: &str, destination: &str) -> bool {
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
