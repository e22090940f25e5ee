pub mod collision {
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query, role: Some(Role::State)
    pub struct ProtectiveStopStatus {}
    impl ProtectiveStopStatus {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct ProtectiveStopStatusReply {
        pub protective_stop: bool,
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Setting
    pub struct SetClsnSensitivity {
        // min 0, max 5, advisory true
        pub level: i64,
    }
    impl SetClsnSensitivity {
        pub const fn new(level: i64) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query
    pub struct GetClsnSensitivity {}
    impl GetClsnSensitivity {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetClsnSensitivityReply {
        pub level: i64,
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Power, deadline: Some(Duration::from_millis(15000u64))
    pub struct ClearError {}
    impl ClearError {
        pub const fn new() -> Self {}
    }
}
