pub mod beyond_settings {
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Motion, role: Some(Role::Start)
    pub struct TorqueFeedforward {
        pub currents: [f64; 6],
        pub mode: TorqueFeedforwardMode,
    }
    impl TorqueFeedforward {
        pub const fn new(currents: [f64; 6], mode: TorqueFeedforwardMode) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Setting, firmware: since([1, 5, 15])
    pub struct SetMotionPlanner {
        pub planner: MotionPlanner,
    }
    impl SetMotionPlanner {
        pub const fn new(planner: MotionPlanner) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Setting, firmware: since([1, 5, 15])
    pub struct SetMotionLimitWarningRange {
        // min 1, max 5
        pub level: i64,
    }
    impl SetMotionLimitWarningRange {
        pub const fn new(level: i64) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query, firmware: since([1, 5, 15])
    pub struct GetMotionLimitWarningRange {}
    impl GetMotionLimitWarningRange {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetMotionLimitWarningRangeReply {
        pub level: i64,
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Setting, changes:[Change::Frames], firmware: since([1, 5, 15])
    pub struct SetInstallationAngle {
        // min 0, max 180, unit "deg"
        pub angle_x: f64,
        // min 0, max 360, unit "deg"
        pub angle_z: f64,
    }
    impl SetInstallationAngle {
        pub const fn new(angle_x: f64, angle_z: f64) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query, firmware: since([1, 5, 15])
    pub struct GetInstallationAngle {}
    impl GetInstallationAngle {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Setting, firmware: since([1, 5, 15])
    pub struct SetTorqueSensorFilter {
        // min 0
        pub filter: f64,
    }
    impl SetTorqueSensorFilter {
        pub const fn new(filter: f64) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Setting, firmware: since([1, 5, 15])
    pub struct SetFtCtrlFrame {
        // min 0
        pub frame: i64,
    }
    impl SetFtCtrlFrame {
        pub const fn new(frame: i64) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Setting, firmware: since([1, 5, 15])
    pub struct ZeroEndSensor {}
    impl ZeroEndSensor {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Setting, firmware: since([1, 5, 15])
    pub struct SetPort10000DelayMs {
        // min 0, unit "ms"
        pub delay: i64,
    }
    impl SetPort10000DelayMs {
        pub const fn new(delay: i64) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query, firmware: since([1, 5, 15])
    pub struct GetPort10000DelayMs {}
    impl GetPort10000DelayMs {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetPort10000DelayMsReply {
        pub delay: i64,
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    // Setting, firmware: since([1, 5, 15])
    pub struct SetOptionalInfoConfig {
        pub section: String,
        pub entry: String,
        pub value: wire::Value,
    }
    impl SetOptionalInfoConfig {
        pub fn new(
            section: impl Into<String>,
            entry: impl Into<String>,
            value: wire::Value,
        ) -> Self {}
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    // Query, firmware: since([1, 5, 15])
    pub struct GetOptionalInfoConfig {
        pub section: String,
        pub entry: String,
    }
    impl GetOptionalInfoConfig {
        pub fn new(section: impl Into<String>, entry: impl Into<String>) -> Self {}
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetOptionalInfoConfigReply {
        pub value: wire::Typed<String>,
    }
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum TorqueFeedforwardMode {
        Controller,
        Offset,
        User,
        Other(i64),
    }
    impl From<i64> for TorqueFeedforwardMode {}
    impl From<TorqueFeedforwardMode> for i64 {}
    impl ::core::fmt::Display for TorqueFeedforwardMode {}
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum MotionPlanner {
        Off,
        T,
        S,
        Other(i64),
    }
    impl From<i64> for MotionPlanner {}
    impl From<MotionPlanner> for i64 {}
    impl ::core::fmt::Display for MotionPlanner {}
}
