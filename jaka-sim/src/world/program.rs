//! The program that runs.

use jaka_proto::messages::program::ProgramState;

use super::World;

impl World {
    /// Starts the next command of the program when the one before has ended.
    pub(super) fn run_program(&mut self) {
        if self.state.program_state != ProgramState::Running || self.engine.is_busy() {
            return;
        }
        let Some(runner) = &mut self.runner else {
            return;
        };
        let Some(command) = runner.next() else {
            return self.end_program();
        };
        if !self.start_motion(&command) {
            log::debug!(target: "jaka_sim", "the program ends: `{}` is refused", command.info().name);
            self.end_program();
        }
    }

    /// Ends the program.
    pub(crate) fn end_program(&mut self) {
        self.runner = None;
        self.state.program_state = ProgramState::Idle;
    }
}
