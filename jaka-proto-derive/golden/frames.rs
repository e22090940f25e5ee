pub mod frames {
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    // Setting, changes:[Change::Tool]
    pub struct SetToolOffsets {
        pub offset: super::types::Pose,
        // min 1, max 10, advisory true
        pub id: i64,
        pub name: String,
    }
    impl SetToolOffsets {
        pub fn new(
            offset: impl Into<super::types::Pose>,
            id: i64,
            name: impl Into<String>,
        ) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Setting, changes:[Change::Tool]
    pub struct SetToolId {
        // min 0, max 10, advisory true
        pub tool_id: i64,
    }
    impl SetToolId {
        pub const fn new(tool_id: i64) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query
    pub struct GetToolOffsets {}
    impl GetToolOffsets {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetToolOffsetsReply {
        pub offsets: Vec<super::types::Pose>,
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    // Setting, changes:[Change::Frames]
    pub struct SetUserOffsets {
        pub offset: super::types::Pose,
        // min 1, max 10
        pub id: i64,
        pub name: String,
    }
    impl SetUserOffsets {
        pub fn new(
            offset: impl Into<super::types::Pose>,
            id: i64,
            name: impl Into<String>,
        ) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Setting, changes:[Change::Frames]
    pub struct SetUserId {
        // min 0, max 10
        pub user_frame_id: i64,
    }
    impl SetUserId {
        pub const fn new(user_frame_id: i64) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query
    pub struct GetUserOffsets {}
    impl GetUserOffsets {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetUserOffsetsReply {
        pub offsets: Vec<super::types::Pose>,
    }
}
