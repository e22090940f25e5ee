pub mod program {
    //! Programs and the speed rate.
    //!
    //! Loads a program that is stored on the controller, starts, pauses, resumes and stops it.
    //!
    //! [`stop_program`](type@StopProgram) also ends a motion when no program is loaded.
    /// Sets the rate by which the controller scales the speed of motion.
    ///
    /// The document speaks of the rate at which programs run; whether a motion that is running follows the new rate at once
    /// is not stated.
    ///
    /// Sends `rapid_rate` (4.17).
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct SetRapidRate {
        /// Rate. 0 to 1. The default is 1. `rate_value` on the wire.
        pub rate: f64,
    }
    impl SetRapidRate {
        /// With the required fields alone.
        ///
        /// - `rate`: 0 to 1
        pub const fn new(rate: f64) -> Self {}
    }
    /// Loads a program that is stored on the controller.
    ///
    /// The name ends in `.ngc` on controllers before version 1.5 and in `.jks` from 1.5 on. A trajectory's file has `track/`
    /// before its name.
    ///
    /// Sends `load_program` (4.18).
    ///
    /// # Errata
    ///
    /// - The text writes the key `program_name`, the sample `programName`.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct LoadProgram {
        /// File name of the program, of printable ASCII characters: the document excludes Chinese ones and says no more. `programName` on the wire.
        ///
        /// Printable ASCII only.
        pub program_name: String,
    }
    impl LoadProgram {
        /// With the required fields alone.
        pub fn new(program_name: impl Into<String>) -> Self {}
    }
    /// Reads the name of the loaded program.
    ///
    /// Sends `get_loaded_program` (4.19). Changes nothing on the robot. The reply is [`GetLoadedProgramReply`].
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetLoadedProgram {}
    impl GetLoadedProgram {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@GetLoadedProgram`].
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetLoadedProgramReply {
        /// File name of the program. The document does not say what it is when no program is loaded, nor whether a trajectory's
        /// name keeps its `track/`. `programName` on the wire.
        pub program_name: String,
    }
    /// Starts the loaded program.
    ///
    /// Sends `play_program` (4.20). The robot must be powered and enabled.
    ///
    /// Reconstructed, since the document's page is lost: reply only: the document has the request, the page with the reply is lost. Field notes: certain.
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct PlayProgram {}
    impl PlayProgram {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// Pauses the program that is running.
    ///
    /// Sends `pause_program` (4.21).
    ///
    /// Reconstructed, since the document's page is lost: The document's page is lost. Field notes: request and reply likely.
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct PauseProgram {}
    impl PauseProgram {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// Resumes the program that is paused.
    ///
    /// Sends `resume_program` (4.22). The robot must be powered and enabled.
    ///
    /// Reconstructed, since the document's page is lost: The document's page is lost. Field notes: request and reply likely.
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct ResumeProgram {}
    impl ResumeProgram {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// Stops the program, or the motion, that is running.
    ///
    /// This is also the usual way to abort [`joint_move`](crate::messages::motion::JointMove), [`end_move`](crate::messages::motion::EndMove) or [`move_l`](crate::messages::motion::MoveL) with no program loaded. No source says whether
    /// it ends [`move_c`](crate::messages::motion::MoveC), a jog or servo motion too, nor what becomes of motions that wait their turn. It is not an emergency stop:
    /// the command travels over the network.
    ///
    /// Sends `stop_program` (4.23).
    ///
    /// Reconstructed, since the document's page is lost: The document's page is lost. Field notes: request and reply certain. Sections 4.7 to 4.9 name it to end a motion.
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct StopProgram {}
    impl StopProgram {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// Reads the state of the program.
    ///
    /// Sends `get_program_state` (4.24). Changes nothing on the robot. The reply is [`GetProgramStateReply`].
    ///
    /// Reconstructed, since the document's page is lost: The document's page is lost. Field notes: request and key certain; value `idle` certain, `running` and `paused` likely.
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetProgramState {}
    impl GetProgramState {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@GetProgramState`].
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetProgramStateReply {
        /// State of the program. `programState` on the wire.
        pub program_state: ProgramState,
    }
    /// State of a program, as [`get_program_state`](type@GetProgramState) answers. There may be others than these.
    #[derive(Debug, Clone, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum ProgramState {
        /// No program runs. `"idle"` on the wire.
        Idle,
        /// A program runs. `"running"` on the wire.
        Running,
        /// A program is paused. `"paused"` on the wire.
        Paused,
        /// A value that the spec does not list.
        Other(String),
    }
    impl From<&str> for ProgramState {}
    impl AsRef<str> for ProgramState {}
    /// The value as on the wire.
    impl ::core::fmt::Display for ProgramState {}
}
