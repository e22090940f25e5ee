//! Programs and the speed rate.

use jaka_proto::Request;
use jaka_proto::messages::program::ProgramState;

use super::{Draft, Outcome, accept, reply};
use crate::programs::Runner;
use crate::world::World;

pub(super) fn answer(request: &Request, world: &mut World, out: &mut Draft<'_>) -> Outcome {
    match request {
        Request::SetRapidRate(command) => {
            world.state.rapid_rate = command.rate;
            accept(command, out)
        }
        Request::LoadProgram(command) if world.programs.contains_key(&command.program_name) => {
            world.state.loaded_program.clone_from(&command.program_name);
            accept(command, out)
        }
        Request::LoadProgram(_) => Outcome::Refused,
        Request::GetLoadedProgram(command) => {
            reply(command, out, |reply| reply.program_name = world.state.loaded_program.clone())
        }
        Request::GetProgramState(command) => {
            reply(command, out, |reply| reply.program_state = world.state.program_state.clone())
        }
        _ => run(request, world, out),
    }
}

/// Starts and stops programs. Where there is nothing to pause, to resume or to stop, nothing happens.
fn run(request: &Request, world: &mut World, out: &mut Draft<'_>) -> Outcome {
    match request {
        Request::PlayProgram(command) => match world.programs.get(&world.state.loaded_program) {
            Some(program) if world.runner.is_none() => {
                world.runner = Some(Runner::new(program.clone()));
                world.state.program_state = ProgramState::Running;
                accept(command, out)
            }
            _ => Outcome::Refused,
        },
        Request::PauseProgram(command) => {
            replace(world, &ProgramState::Running, ProgramState::Paused);
            accept(command, out)
        }
        Request::ResumeProgram(command) => {
            replace(world, &ProgramState::Paused, ProgramState::Running);
            accept(command, out)
        }
        Request::StopProgram(command) => {
            world.end_program();
            world.stop();
            accept(command, out)
        }
        _ => Outcome::Unhandled,
    }
}

fn replace(world: &mut World, from: &ProgramState, to: ProgramState) {
    if world.state.program_state == *from {
        world.state.program_state = to;
    }
}
