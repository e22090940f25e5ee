#[allow(unreachable_pub, dead_code, clippy::self_named_constructors)]
pub mod changed {
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query
    pub struct ReadWholeState {}
    impl ReadWholeState {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Motion, role: Some(Role::Start), is_motion: true, requires:[Requirement::Powered, Requirement::Enabled, Requirement::NotServoMode], deadline: Some(Duration::from_millis(60000u64))
    pub struct JointMove {
        pub mode: ::jaka_sync::types::MoveMode,
        // advised match self.mode{::jaka_sync::types::MoveMode::Absolute=>Advised::to([Advice{max: 360, nonzero: false, unit: ""}]),::jaka_sync::types::MoveMode::Relative=>Advised::to([Advice{max: 720, nonzero: false, unit: ""}]),_=>Advised::NONE,}
        pub joint_position: ::jaka_sync::types::JointPosition,
        // min 0, advised Advised::to([Advice{max: 265, nonzero: true, unit: ""}]), unit "deg/s"
        pub speed: f64,
        // min 0, advised Advised::to([Advice{max: 720, nonzero: true, unit: ""}]), unit "deg/s²"
        pub acceleration: Option<f64>,
        // min 0, firmware since([1, 5, 15])
        pub tolerance: Option<f64>,
        // firmware since([1, 5, 15])
        pub executing_line_id: Option<i64>,
        // min 0, unit "mm", firmware since([1, 7, 1])
        pub zone: Option<f64>,
    }
    impl JointMove {
        pub fn new(
            mode: ::jaka_sync::types::MoveMode,
            joint_position: impl Into<::jaka_sync::types::JointPosition>,
            speed: f64,
        ) -> Self {}
        pub fn absolute(
            joint_position: impl Into<::jaka_sync::types::JointPosition>,
            speed: f64,
        ) -> Self {}
        pub fn relative(
            joint_position: impl Into<::jaka_sync::types::JointPosition>,
            speed: f64,
        ) -> Self {}
        pub fn acceleration(mut self, acceleration: f64) -> Self {}
        pub fn tolerance(mut self, tolerance: f64) -> Self {}
        pub fn executing_line_id(mut self, executing_line_id: i64) -> Self {}
        pub fn zone(mut self, zone: f64) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Setting
    pub struct SetRapidRate {
        // min 0, max 1.5
        pub rate: f64,
    }
    impl SetRapidRate {
        pub const fn new(rate: f64) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Setting
    pub struct SetTioVoutParam {
        // min 0, max 1
        pub output_enable: i64,
        pub output_voltage: ToolVoltage,
    }
    impl SetTioVoutParam {
        pub const fn new(output_enable: i64, output_voltage: ToolVoltage) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query, firmware: since([1, 4])
    pub struct GetData {}
    impl GetData {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum ToolVoltage {
        V24,
        V12,
        Other(i64),
    }
    impl From<i64> for ToolVoltage {}
    impl From<ToolVoltage> for i64 {}
    impl ::core::fmt::Display for ToolVoltage {}
    #[derive(Debug, Clone, PartialEq, Default)]
    #[non_exhaustive]
    pub struct RobotStatus {
        pub brake_state: Option<i64>,
    }
    impl ::jaka_sync::MotionStatus for RobotStatus {}
    pub trait ChangedCommands: ::jaka_sync::Call {
        fn read_whole_state(&mut self) -> Result<RobotStatus, ::jaka_sync::Error>;
        fn joint_move_changed(
            &mut self,
            request: &JointMove,
        ) -> Result<(), ::jaka_sync::Error>;
        fn set_rapid_rate_changed(
            &mut self,
            rate: f64,
        ) -> Result<(), ::jaka_sync::Error>;
        fn set_tio_vout_param_changed(
            &mut self,
            request: &SetTioVoutParam,
        ) -> Result<(), ::jaka_sync::Error>;
        fn get_data_changed(&mut self) -> Result<RobotStatus, ::jaka_sync::Error>;
    }
    impl<T: ::jaka_sync::Call + ?Sized> ChangedCommands for T {}
    pub const OVERLOAD: proto::ErrorCode = proto::ErrorCode(5i64);
    pub fn meaning(code: proto::ErrorCode) -> Option<&'static str> {}
}
