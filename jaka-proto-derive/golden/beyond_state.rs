pub mod beyond_state {
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query, firmware: since([1, 4])
    pub struct GetData {}
    impl GetData {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query, firmware: since([1, 5, 15])
    pub struct GetMotionState {}
    impl GetMotionState {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetMotionStateReply {
        pub in_position: bool,
        pub paused: Option<bool>,
        pub queue: i64,
        pub active_queue: i64,
        pub motion_line: Option<wire::Typed<i64>>,
        pub motion_line_sdk: Option<wire::Typed<i64>>,
        pub error_add_line: Option<wire::Typed<i64>>,
        pub queue_full: Option<bool>,
        pub on_limit: Option<bool>,
        pub in_emergency_stop: Option<bool>,
        pub in_collision: Option<bool>,
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query, firmware: since([1, 5, 15])
    pub struct EmergencyStopStatus {}
    impl EmergencyStopStatus {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct EmergencyStopStatusReply {
        pub emergency_stop: bool,
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query, firmware: since([1, 5, 15])
    pub struct IsOnLimit {}
    impl IsOnLimit {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct IsOnLimitReply {
        pub on_limit: wire::Typed<bool>,
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query, firmware: since([1, 5, 15])
    pub struct GetDragStatus {}
    impl GetDragStatus {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetDragStatusReply {
        pub drag_mode: wire::Typed<bool>,
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query, firmware: since([1, 5, 15])
    pub struct GetRapidRate {}
    impl GetRapidRate {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetRapidRateReply {
        pub rapid_rate: wire::Typed<f64>,
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query, firmware: since([1, 5, 15])
    pub struct GetCurrToolId {}
    impl GetCurrToolId {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetCurrToolIdReply {
        pub id: i64,
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query, firmware: since([1, 5, 15])
    pub struct GetCurrUserId {}
    impl GetCurrUserId {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetCurrUserIdReply {
        pub id: i64,
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query, firmware: since([1, 5, 15])
    pub struct GetActualJointPos {}
    impl GetActualJointPos {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetActualJointPosReply {
        pub joint_position: super::types::JointPosition,
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query, firmware: since([1, 5, 15])
    pub struct GetActualTcpPos {}
    impl GetActualTcpPos {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetActualTcpPosReply {
        pub pose: super::types::Pose,
    }
}
