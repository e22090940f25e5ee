pub mod kinematics {
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Query
    pub struct KineForward {
        pub joint_position: super::types::JointPosition,
    }
    impl KineForward {
        pub fn new(joint_position: impl Into<super::types::JointPosition>) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct KineForwardReply {
        pub pose: super::types::Pose,
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Query
    pub struct KineInverse {
        pub reference_joint_position: super::types::JointPosition,
        pub pose: super::types::Pose,
    }
    impl KineInverse {
        pub fn new(
            reference_joint_position: impl Into<super::types::JointPosition>,
            pose: impl Into<super::types::Pose>,
        ) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct KineInverseReply {
        pub joint_position: super::types::JointPosition,
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query, role: Some(Role::State)
    pub struct GetJointPos {}
    impl GetJointPos {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetJointPosReply {
        pub joint_position: super::types::JointPosition,
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query, role: Some(Role::State)
    pub struct GetTcpPos {}
    impl GetTcpPos {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetTcpPosReply {
        pub pose: super::types::Pose,
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query
    pub struct GetDhParam {}
    impl GetDhParam {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetDhParamReply {
        pub alpha: [f64; 6],
        pub a: [f64; 6],
        pub d: [f64; 6],
        pub joint_home_offset: [f64; 6],
    }
}
