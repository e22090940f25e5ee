//! Programs and the speed rate.

use jaka_proto::Request;
use jaka_proto::messages::program::ProgramState;

use super::{Draft, Outcome, reply};
use crate::world::World;

pub(super) fn answer(request: &Request, world: &mut World, out: &mut Draft<'_>) -> Outcome {
    match request {
        Request::GetLoadedProgram(command) => {
            reply(command, out, |reply| reply.program_name.clone_from(&world.state.loaded_program))
        }
        Request::GetProgramState(command) => {
            reply(command, out, |reply| reply.program_state.clone_from(&world.state.program_state))
        }
        Request::GetMotionState(command) => reply(command, out, |reply| {
            let is_paused = world.state.program_state == ProgramState::Paused;
            (reply.in_position, reply.paused) = (world.state.in_position, is_paused);
        }),
        _ => run(request, world),
    }
}

/// Starts and stops programs. Where there is nothing to pause, to resume or to stop, nothing happens.
fn run(request: &Request, world: &mut World) -> Outcome {
    match request {
        Request::SetRapidRate(command) => world.state.rapid_rate = command.rate,
        Request::LoadProgram(command) if world.programs.contains_key(&command.program_name) => {
            world.state.loaded_program.clone_from(&command.program_name);
        }
        Request::PlayProgram(_) => match world.programs.get(&world.state.loaded_program) {
            Some(program) if world.runner.is_none() => {
                world.runner = Some(program.clone().into_iter());
                world.state.program_state = ProgramState::Running;
            }
            _ => return Outcome::Refused,
        },
        Request::LoadProgram(_) => return Outcome::Refused,
        Request::PauseProgram(_) => replace(world, &ProgramState::Running, ProgramState::Paused),
        Request::ResumeProgram(_) => replace(world, &ProgramState::Paused, ProgramState::Running),
        Request::StopProgram(_) => {
            world.end_program();
            world.stop();
        }
        _ => return Outcome::Unhandled,
    }
    Outcome::Accepted
}

fn replace(world: &mut World, from: &ProgramState, to: ProgramState) {
    if world.state.program_state == *from {
        world.state.program_state = to;
    }
}
