//! Programs and the speed rate.

use jaka_proto::Request;
use jaka_proto::messages::program::{GetLoadedProgramReply, GetProgramStateReply, ProgramState};
use jaka_proto::wire::Writer;

use super::{Outcome, accept, reply};
use crate::State;

pub(super) fn answer(request: &Request, state: &mut State, out: &mut Writer) -> Outcome {
    match request {
        Request::RapidRate(command) => {
            state.rapid_rate = command.rate;
            accept(command, out)
        }
        Request::LoadProgram(command) => {
            state.loaded_program.clone_from(&command.program_name);
            accept(command, out)
        }
        Request::GetLoadedProgram(command) => {
            reply(command, GetLoadedProgramReply { program_name: state.loaded_program.clone() }, out)
        }
        Request::GetProgramState(command) => {
            reply(command, GetProgramStateReply { program_state: state.program_state.clone() }, out)
        }
        _ => run(request, state, out),
    }
}

/// Starts and stops. Where there is nothing to pause, to resume or to stop, nothing is done.
fn run(request: &Request, state: &mut State, out: &mut Writer) -> Outcome {
    match request {
        Request::PlayProgram(command) => {
            state.program_state = ProgramState::Running;
            accept(command, out)
        }
        Request::PauseProgram(command) => {
            replace(state, &ProgramState::Running, ProgramState::Paused);
            accept(command, out)
        }
        Request::ResumeProgram(command) => {
            replace(state, &ProgramState::Paused, ProgramState::Running);
            accept(command, out)
        }
        Request::StopProgram(command) => {
            state.program_state = ProgramState::Idle;
            accept(command, out)
        }
        _ => Outcome::Unhandled,
    }
}

fn replace(state: &mut State, from: &ProgramState, to: ProgramState) {
    if state.program_state == *from {
        state.program_state = to;
    }
}
