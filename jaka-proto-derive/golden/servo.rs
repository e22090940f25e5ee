pub mod servo {
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query
    pub struct IsInServomove {}
    impl IsInServomove {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct IsInServomoveReply {
        pub in_servo_mode: bool,
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Motion, role: Some(Role::ServoMode), requires:[Requirement::Powered, Requirement::Enabled]
    pub struct SetServoMode {
        pub servo_mode: super::types::Switch,
    }
    impl SetServoMode {
        pub const fn new(servo_mode: super::types::Switch) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Motion, role: Some(Role::SetPoint), requires:[Requirement::Powered, Requirement::Enabled, Requirement::ServoMode]
    pub struct ServoJ {
        pub mode: super::types::MoveMode,
        // advised match self.mode{super::types::MoveMode::Absolute=>Advised::to([Advice{max: 360, nonzero: false, unit: ""}]), super::types::MoveMode::Relative=>Advised::to([Advice{max: 2.12, nonzero: false, unit: ""}]).times(Clone::clone(self.step_count)),_=>Advised::NONE,}
        pub joint_position: super::types::JointPosition,
        // min 1, advised Advised::to([Advice{max: 12, nonzero: false, unit: ""}])
        pub step_count: Option<i64>,
    }
    impl ServoJ {
        pub fn new(
            mode: super::types::MoveMode,
            joint_position: impl Into<super::types::JointPosition>,
        ) -> Self {}
        pub fn absolute(joint_position: impl Into<super::types::JointPosition>) -> Self {}
        pub fn relative(joint_position: impl Into<super::types::JointPosition>) -> Self {}
        pub fn step_count(mut self, step_count: i64) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Motion, role: Some(Role::SetPoint), requires:[Requirement::Powered, Requirement::Enabled, Requirement::ServoMode]
    pub struct ServoP {
        // advised match self.mode{super::types::MoveMode::Relative=>Advised::to([Advice{max: 80, nonzero: false, unit: "mm"}, Advice{max: 9, nonzero: false, unit: "deg"}]).times(Clone::clone(self.step_count)),_=>Advised::NONE,}
        pub pose: super::types::Pose,
        pub mode: super::types::MoveMode,
        // min 1, advised Advised::to([Advice{max: 12, nonzero: false, unit: ""}])
        pub step_count: Option<i64>,
    }
    impl ServoP {
        pub fn new(
            pose: impl Into<super::types::Pose>,
            mode: super::types::MoveMode,
        ) -> Self {}
        pub fn absolute(pose: impl Into<super::types::Pose>) -> Self {}
        pub fn relative(pose: impl Into<super::types::Pose>) -> Self {}
        pub fn step_count(mut self, step_count: i64) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Setting, requires:[Requirement::NotServoMode]
    pub enum SetServoMoveFilter {
        #[non_exhaustive]
        Disabled,
        #[non_exhaustive]
        JointLowPass {
            // min 0, unit "Hz"
            cutoff_frequency: f64,
        },
        #[non_exhaustive]
        JointNonlinear {
            // min 0, unit "deg/s"
            max_joint_speed: f64,
            // min 0, unit "deg/s²"
            max_joint_acceleration: f64,
            // min 0, unit "deg/s³"
            max_joint_jerk: f64,
        },
        #[non_exhaustive]
        JointMean {
            // min 0
            window_width: i64,
            position_coefficient: f64,
            speed_coefficient: f64,
            acceleration_coefficient: f64,
        },
        #[non_exhaustive]
        CartesianNonlinear {
            // min 0, unit "deg/s(printed as%/s)"
            max_rotation_speed: f64,
            // min 0, unit "deg/s²(printed as%/s²)"
            max_rotation_acceleration: f64,
            // min 0, unit "deg/s³(printed as%/s³)"
            max_rotation_jerk: f64,
            // min 0, unit "mm/s"
            max_translation_speed: f64,
            // min 0, unit "mm/s²"
            max_translation_acceleration: f64,
            // min 0, unit "mm/s³"
            max_translation_jerk: f64,
        },
        #[non_exhaustive]
        SpeedLookahead {
            // min 0
            buffer_size: i64,
            position_coefficient: f64,
        },
    }
    impl SetServoMoveFilter {
        pub const fn disabled() -> Self {}
        pub const fn joint_low_pass(cutoff_frequency: f64) -> Self {}
        pub const fn joint_nonlinear(
            max_joint_speed: f64,
            max_joint_acceleration: f64,
            max_joint_jerk: f64,
        ) -> Self {}
        pub const fn joint_mean(
            window_width: i64,
            position_coefficient: f64,
            speed_coefficient: f64,
            acceleration_coefficient: f64,
        ) -> Self {}
        pub const fn cartesian_nonlinear(
            max_rotation_speed: f64,
            max_rotation_acceleration: f64,
            max_rotation_jerk: f64,
            max_translation_speed: f64,
            max_translation_acceleration: f64,
            max_translation_jerk: f64,
        ) -> Self {}
        pub const fn speed_lookahead(
            buffer_size: i64,
            position_coefficient: f64,
        ) -> Self {}
    }
}
