pub mod program {
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Setting
    pub struct SetRapidRate {
        // min 0, max 1
        pub rate: f64,
    }
    impl SetRapidRate {
        pub const fn new(rate: f64) -> Self {}
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    // Setting
    pub struct LoadProgram {
        // ascii true
        pub program_name: String,
    }
    impl LoadProgram {
        pub fn new(program_name: impl Into<String>) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query
    pub struct GetLoadedProgram {}
    impl GetLoadedProgram {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetLoadedProgramReply {
        pub program_name: String,
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Motion, role: Some(Role::Start), requires:[Requirement::Powered, Requirement::Enabled]
    pub struct PlayProgram {}
    impl PlayProgram {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Motion, role: Some(Role::Pause)
    pub struct PauseProgram {}
    impl PauseProgram {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Motion, role: Some(Role::Resume), requires:[Requirement::Powered, Requirement::Enabled]
    pub struct ResumeProgram {}
    impl ResumeProgram {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Motion, role: Some(Role::Stop)
    pub struct StopProgram {}
    impl StopProgram {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query, role: Some(Role::State)
    pub struct GetProgramState {}
    impl GetProgramState {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetProgramStateReply {
        pub program_state: ProgramState,
    }
    #[derive(Debug, Clone, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum ProgramState {
        Idle,
        Running,
        Paused,
        Other(String),
    }
    impl From<&str> for ProgramState {}
    impl AsRef<str> for ProgramState {}
    impl ::core::fmt::Display for ProgramState {}
}
