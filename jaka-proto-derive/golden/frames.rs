pub mod frames {
    //! Tool frames and user frames.
    //!
    //! The controller holds tool frames and user frames with the ids 0 to 10. Frame 0 is fixed: the centre of the flange as
    //! tool frame, the robot's base frame as user frame. Frames 1 to 10 can be set.
    //!
    //! Which frames are selected decides what Cartesian coordinates mean. Changing a frame changes where the next Cartesian
    //! motion goes.
    /// Sets the offset and the name of one tool frame.
    ///
    /// Which frame the robot moves in is selected by [`set_tool_id`](type@SetToolId).
    ///
    /// Sends `set_tool_offsets` (4.28).
    ///
    /// # Errata
    ///
    /// - The key is `tooloffset` here, while the reply of [`get_tool_offsets`](type@GetToolOffsets) has `tool_offsets`.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct SetToolOffsets {
        /// Offset of the tool frame. `tooloffset` on the wire.
        pub offset: super::types::Pose,
        /// Id of the tool frame to set. 1 to 10.
        ///
        /// Newer firmware takes more than this range, which can be switched off: see [`AdvisoryRanges`](check::AdvisoryRanges).
        pub id: i64,
        /// Name of the tool frame.
        pub name: String,
    }
    impl SetToolOffsets {
        /// With the required fields alone.
        ///
        /// - `id`: 1 to 10
        pub fn new(
            offset: impl Into<super::types::Pose>,
            id: i64,
            name: impl Into<String>,
        ) -> Self {}
    }
    /// Selects the tool frame in which the robot moves.
    ///
    /// Id 0 selects the centre of the flange.
    ///
    /// Sends `set_tool_id` (4.29).
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct SetToolId {
        /// Id of the tool frame to use. 0 to 10. One client sets frames up to 15 on newer firmware.
        ///
        /// Newer firmware takes more than this range, which can be switched off: see [`AdvisoryRanges`](check::AdvisoryRanges).
        pub tool_id: i64,
    }
    impl SetToolId {
        /// With the required fields alone.
        ///
        /// - `tool_id`: 0 to 10
        pub const fn new(tool_id: i64) -> Self {}
    }
    /// Reads the offsets of all tool frames.
    ///
    /// Sends `get_tool_offsets` (4.30). Changes nothing on the robot. The reply is [`GetToolOffsetsReply`].
    ///
    /// # Errata
    ///
    /// - The text writes the key `tool_offset`, the sample `tool_offsets`.
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetToolOffsets {}
    impl GetToolOffsets {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@GetToolOffsets`].
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetToolOffsetsReply {
        /// Offset of each tool frame, by id from 0. The document counts 11. `tool_offsets` on the wire.
        pub offsets: Vec<super::types::Pose>,
    }
    /// Sets the offset and the name of one user frame.
    ///
    /// Which frame the robot moves in is selected by [`set_user_id`](type@SetUserId).
    ///
    /// Sends `set_user_offsets` (4.31).
    ///
    /// # Errata
    ///
    /// - The key is spelled `userffset` in sample and text, without the o, and controllers expect it so.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct SetUserOffsets {
        /// Offset of the user frame. `userffset` on the wire.
        pub offset: super::types::Pose,
        /// Id of the user frame to set. 1 to 10.
        pub id: i64,
        /// Name of the user frame.
        pub name: String,
    }
    impl SetUserOffsets {
        /// With the required fields alone.
        ///
        /// - `id`: 1 to 10
        pub fn new(
            offset: impl Into<super::types::Pose>,
            id: i64,
            name: impl Into<String>,
        ) -> Self {}
    }
    /// Selects the user frame in which the robot moves.
    ///
    /// Id 0 selects the robot's base frame.
    ///
    /// Sends `set_user_id` (4.32).
    ///
    /// # Errata
    ///
    /// - The text calls the key `set_user_id`. The sample has `user_frame_id`, and controllers expect it so.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct SetUserId {
        /// Id of the user frame to use. 0 to 10.
        pub user_frame_id: i64,
    }
    impl SetUserId {
        /// With the required fields alone.
        ///
        /// - `user_frame_id`: 0 to 10
        pub const fn new(user_frame_id: i64) -> Self {}
    }
    /// Reads the offsets of all user frames.
    ///
    /// Sends `get_user_offsets` (4.33). Changes nothing on the robot. The reply is [`GetUserOffsetsReply`].
    ///
    /// # Errata
    ///
    /// - The text is copied from 4.30: it writes the key `tool_offset` and speaks of tool frames.
    /// - In the sample, frame 1 repeats its positions as angles, down to -439 degrees. It is not a measured frame.
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetUserOffsets {}
    impl GetUserOffsets {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@GetUserOffsets`].
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetUserOffsetsReply {
        /// Offset of each user frame, by id from 0. The document counts 11. `user_offsets` on the wire.
        pub offsets: Vec<super::types::Pose>,
    }
}
