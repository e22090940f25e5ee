pub mod motion {
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Motion, role: Some(Role::Start), requires:[Requirement::Powered, Requirement::Enabled, Requirement::NotServoMode], deadline: Some(Duration::from_millis(60000u64))
    pub enum Jog {
        #[non_exhaustive]
        Stop {
            frame: JogFrame,
            // min 0, max 5
            axis: i64,
        },
        #[non_exhaustive]
        Continuous {
            frame: JogFrame,
            // min 0, max 5
            axis: i64,
            // advised match frame{JogFrame::World=>Advised::to([Advice{max: 10000, nonzero: true, unit: ""}]), JogFrame::Joint=>Advised::to([Advice{max: 265, nonzero: true, unit: ""}]), JogFrame::Tool=>Advised::to([Advice{max: 10000, nonzero: true, unit: ""}]),_=>Advised::NONE,}, unit "deg/s for a joint or a rotation, mm/s for a translation"
            velocity: f64,
        },
        #[non_exhaustive]
        Increment {
            frame: JogFrame,
            // min 0, max 5
            axis: i64,
            // advised match frame{JogFrame::World=>Advised::to([Advice{max: 10000, nonzero: true, unit: ""}]), JogFrame::Joint=>Advised::to([Advice{max: 265, nonzero: true, unit: ""}]), JogFrame::Tool=>Advised::to([Advice{max: 10000, nonzero: true, unit: ""}]),_=>Advised::NONE,}, unit "deg/s for a joint or a rotation, mm/s for a translation"
            velocity: f64,
            // advised match frame{JogFrame::Joint=>Advised::to([Advice{max: 720, nonzero: false, unit: ""}]),_=>Advised::NONE,}, unit "deg for a joint or a rotation, mm for a translation"
            distance: f64,
        },
        #[non_exhaustive]
        Absolute {
            frame: JogFrame,
            // min 0, max 5
            axis: i64,
            // advised match frame{JogFrame::World=>Advised::to([Advice{max: 10000, nonzero: true, unit: ""}]), JogFrame::Joint=>Advised::to([Advice{max: 265, nonzero: true, unit: ""}]), JogFrame::Tool=>Advised::to([Advice{max: 10000, nonzero: true, unit: ""}]),_=>Advised::NONE,}, unit "deg/s for a joint or a rotation, mm/s for a translation"
            velocity: f64,
            // advised match frame{JogFrame::Joint=>Advised::to([Advice{max: 360, nonzero: false, unit: ""}]),_=>Advised::NONE,}, unit "deg for a joint or a rotation, mm for a translation"
            position: f64,
        },
    }
    impl Jog {
        pub const fn stop(frame: JogFrame, axis: i64) -> Self {}
        pub const fn continuous(frame: JogFrame, axis: i64, velocity: f64) -> Self {}
        pub const fn increment(
            frame: JogFrame,
            axis: i64,
            velocity: f64,
            distance: f64,
        ) -> Self {}
        pub const fn absolute(
            frame: JogFrame,
            axis: i64,
            velocity: f64,
            position: f64,
        ) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Motion, role: Some(Role::Start), is_motion: true, requires:[Requirement::Powered, Requirement::Enabled, Requirement::NotServoMode], deadline: Some(Duration::from_millis(60000u64))
    pub struct JointMove {
        pub mode: super::types::MoveMode,
        // advised match self.mode{super::types::MoveMode::Absolute=>Advised::to([Advice{max: 360, nonzero: false, unit: ""}]), super::types::MoveMode::Relative=>Advised::to([Advice{max: 720, nonzero: false, unit: ""}]),_=>Advised::NONE,}
        pub joint_position: super::types::JointPosition,
        // min 0, advised Advised::to([Advice{max: 265, nonzero: true, unit: ""}]), unit "deg/s"
        pub speed: f64,
        // min 0, advised Advised::to([Advice{max: 720, nonzero: true, unit: ""}]), unit "deg/s²"
        pub acceleration: Option<f64>,
        // min 0, firmware since([1, 5, 15])
        pub tolerance: Option<f64>,
        // firmware since([1, 5, 15])
        pub executing_line_id: Option<i64>,
    }
    impl JointMove {
        pub fn new(
            mode: super::types::MoveMode,
            joint_position: impl Into<super::types::JointPosition>,
            speed: f64,
        ) -> Self {}
        pub fn absolute(
            joint_position: impl Into<super::types::JointPosition>,
            speed: f64,
        ) -> Self {}
        pub fn relative(
            joint_position: impl Into<super::types::JointPosition>,
            speed: f64,
        ) -> Self {}
        pub fn acceleration(mut self, acceleration: f64) -> Self {}
        pub fn tolerance(mut self, tolerance: f64) -> Self {}
        pub fn executing_line_id(mut self, executing_line_id: i64) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Motion, role: Some(Role::Start), is_motion: true, requires:[Requirement::Powered, Requirement::Enabled, Requirement::NotServoMode], deadline: Some(Duration::from_millis(60000u64))
    pub struct EndMove {
        pub pose: super::types::Pose,
        // min 0, advised Advised::to([Advice{max: 265, nonzero: true, unit: ""}]), unit "deg/s"
        pub speed: f64,
        // min 0, advised Advised::to([Advice{max: 720, nonzero: true, unit: ""}]), unit "deg/s²"
        pub acceleration: Option<f64>,
    }
    impl EndMove {
        pub fn new(pose: impl Into<super::types::Pose>, speed: f64) -> Self {}
        pub fn acceleration(mut self, acceleration: f64) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Motion, role: Some(Role::Start), is_motion: true, requires:[Requirement::Powered, Requirement::Enabled, Requirement::NotServoMode], deadline: Some(Duration::from_millis(60000u64))
    pub struct MoveL {
        pub mode: LineMode,
        pub pose: super::types::Pose,
        // min 0, advised Advised::to([Advice{max: 10000, nonzero: true, unit: ""}]), unit "mm/s"
        pub speed: f64,
        // min 0, advised Advised::to([Advice{max: 8000, nonzero: true, unit: ""}]), unit "mm/s²"
        pub acceleration: Option<f64>,
        // min 0, unit "mm"
        pub tolerance: Option<f64>,
        // min 0, unit "deg/s", firmware since([1, 5, 15])
        pub orientation_speed: Option<f64>,
        // min 0, unit "deg/s²", firmware since([1, 5, 15])
        pub orientation_acceleration: Option<f64>,
    }
    impl MoveL {
        pub fn new(
            mode: LineMode,
            pose: impl Into<super::types::Pose>,
            speed: f64,
        ) -> Self {}
        pub fn absolute(pose: impl Into<super::types::Pose>, speed: f64) -> Self {}
        pub fn relative(pose: impl Into<super::types::Pose>, speed: f64) -> Self {}
        pub fn relative_to_tool(
            pose: impl Into<super::types::Pose>,
            speed: f64,
        ) -> Self {}
        pub fn acceleration(mut self, acceleration: f64) -> Self {}
        pub fn tolerance(mut self, tolerance: f64) -> Self {}
        pub fn orientation_speed(mut self, orientation_speed: f64) -> Self {}
        pub fn orientation_acceleration(
            mut self,
            orientation_acceleration: f64,
        ) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Motion, role: Some(Role::Start), is_motion: true, requires:[Requirement::Powered, Requirement::Enabled, Requirement::NotServoMode], deadline: Some(Duration::from_millis(60000u64))
    pub struct MoveC {
        pub mode: super::types::MoveMode,
        pub mid_pose: super::types::Pose,
        pub end_pose: super::types::Pose,
        // min 0, advised Advised::to([Advice{max: 10000, nonzero: true, unit: ""}]), unit "mm/s"
        pub speed: f64,
        // min 0, advised Advised::to([Advice{max: 8000, nonzero: true, unit: ""}]), unit "mm/s²"
        pub acceleration: f64,
        // min 0, unit "mm"
        pub tolerance: f64,
        // min 0, firmware since([1, 5, 15])
        pub circle_count: Option<i64>,
        // firmware since([1, 5, 15])
        pub circle_mode: Option<i64>,
    }
    impl MoveC {
        pub fn new(
            mode: super::types::MoveMode,
            mid_pose: impl Into<super::types::Pose>,
            end_pose: impl Into<super::types::Pose>,
            speed: f64,
            acceleration: f64,
            tolerance: f64,
        ) -> Self {}
        pub fn absolute(
            mid_pose: impl Into<super::types::Pose>,
            end_pose: impl Into<super::types::Pose>,
            speed: f64,
            acceleration: f64,
            tolerance: f64,
        ) -> Self {}
        pub fn relative(
            mid_pose: impl Into<super::types::Pose>,
            end_pose: impl Into<super::types::Pose>,
            speed: f64,
            acceleration: f64,
            tolerance: f64,
        ) -> Self {}
        pub fn circle_count(mut self, circle_count: i64) -> Self {}
        pub fn circle_mode(mut self, circle_mode: i64) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Session, deadline: Some(Duration::from_millis(60000u64))
    pub struct WaitComplete {}
    impl WaitComplete {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum JogFrame {
        World,
        Joint,
        Tool,
        Other(i64),
    }
    impl From<i64> for JogFrame {}
    impl From<JogFrame> for i64 {}
    impl ::core::fmt::Display for JogFrame {}
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum LineMode {
        Absolute,
        Relative,
        RelativeToTool,
        Other(i64),
    }
    impl From<i64> for LineMode {}
    impl From<LineMode> for i64 {}
    impl ::core::fmt::Display for LineMode {}
}
