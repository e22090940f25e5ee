pub mod power {
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Power, deadline: Some(Duration::from_millis(30000u64))
    pub struct PowerOn {}
    impl PowerOn {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct PowerOnReply {
        pub powered_on: Option<bool>,
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Power, deadline: Some(Duration::from_millis(15000u64))
    pub struct PowerOff {}
    impl PowerOff {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Power, requires:[Requirement::Powered], deadline: Some(Duration::from_millis(30000u64))
    pub struct EnableRobot {}
    impl EnableRobot {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct EnableRobotReply {
        pub enabled: Option<bool>,
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Power, deadline: Some(Duration::from_millis(15000u64))
    pub struct DisableRobot {}
    impl DisableRobot {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Power, deadline: Some(Duration::from_millis(5000u64)), reply_certain: false, ends_session: true
    pub struct Shutdown {}
    impl Shutdown {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query, role: Some(Role::State)
    pub struct GetRobotState {}
    impl GetRobotState {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetRobotStateReply {
        pub enabled: bool,
        pub powered_on: bool,
        pub error_code: Option<wire::Value>,
        pub error_message: Option<String>,
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query
    pub struct GetVersion {}
    impl GetVersion {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetVersionReply {
        pub version: String,
        pub robot_name: Option<wire::Typed<String>>,
        pub robot_id: Option<wire::Typed<String>>,
    }
}
