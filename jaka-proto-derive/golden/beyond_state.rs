pub mod beyond_state {
    //! State and positions, beyond the document.
    //!
    //! Queries that the document does not have. Newer firmware answers them, and public clients use them.
    //!
    //! [`get_data`](type@GetData) works from firmware 1.4 on. From which firmware on a controller has the others is not known. Of firmware 1.5.14 it is known that
    //! it refuses [`emergency_stop_status`](type@EmergencyStopStatus), and it is taken to lack all of the others: `since` is the version after it.
    /// Reads one status packet on the command port.
    ///
    /// The reply has the keys of the packets of port 10000 next to its own, 1.5 to 9 KB of them, and arrives in pieces. Clients use it for what
    /// no query of the document tells, such as the tool's inputs and the selected frames. Some controllers add `executing_line`, which is skipped.
    ///
    /// Sends `get_data`. Changes nothing on the robot. The reply is [`RobotStatus`](crate::messages::status::RobotStatus).
    ///
    /// Taken to be known to firmware 1.4 and later.
    ///
    /// Not in the document. Evidence: bytes of the vendor's client library (SDK 1.0.19 sends it); several independent clients (seven programs, on controllers from 1.4 on).
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetData {}
    impl GetData {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// Reads how the motions stand that were sent.
    ///
    /// Sends `get_motion_state`. Changes nothing on the robot. The reply is [`GetMotionStateReply`].
    ///
    /// Taken to be known to firmware 1.5.15 and later.
    ///
    /// Not in the document. Evidence: bytes of the vendor's client library (SDK 2.1.14 sends it); one client.
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetMotionState {}
    impl GetMotionState {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@GetMotionState`].
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetMotionStateReply {
        /// Whether the previous motion has ended. `inpos` on the wire.
        ///
        /// Further ones may wait: see `queue`.
        pub in_position: bool,
        /// Whether motion is paused.
        pub paused: Option<bool>,
        /// Number of commands in the motion queue.
        pub queue: i64,
        /// Number of motions in the buffer for blending.
        pub active_queue: i64,
        /// A line that belongs to the motion, by the name. Not explained.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub motion_line: Option<wire::Typed<i64>>,
        /// A line that belongs to the motion, for the vendor's SDK, by the name. Not explained.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub motion_line_sdk: Option<wire::Typed<i64>>,
        /// Says that the previous command was dropped, for instance since the arm was at its target already (meaning in the vendor's SDK). `err_add_line` on the wire.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub error_add_line: Option<wire::Typed<i64>>,
        /// Whether the queue is full, so that further motions are dropped (meaning in the vendor's SDK).
        pub queue_full: Option<bool>,
        /// Whether a limit was hit, by the name.
        pub on_limit: Option<bool>,
        /// Whether the robot is in an emergency stop, by the name. `in_estop` on the wire.
        pub in_emergency_stop: Option<bool>,
        /// Whether a collision was detected, by the name.
        pub in_collision: Option<bool>,
    }
    /// Reads whether the robot is in an emergency stop.
    ///
    /// Firmware 1.5.14 refuses it. The vendor's library takes 1, `"1"` and true for an emergency stop.
    ///
    /// Sends `emergency_stop_status`. Changes nothing on the robot. The reply is [`EmergencyStopStatusReply`].
    ///
    /// Taken to be known to firmware 1.5.15 and later.
    ///
    /// Not in the document. Evidence: another text of the vendor (the TCP document V2.0.6 of January 2024); bytes of the vendor's client library (SDK 2.1.14 sends it); one client.
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct EmergencyStopStatus {}
    impl EmergencyStopStatus {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@EmergencyStopStatus`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct EmergencyStopStatusReply {
        /// Whether the robot is in an emergency stop.
        pub emergency_stop: bool,
    }
    /// Reads whether a soft limit was hit.
    ///
    /// The status packet has it as `on_soft_limit`.
    ///
    /// Sends `is_on_limit`. Changes nothing on the robot. The reply is [`IsOnLimitReply`].
    ///
    /// Taken to be known to firmware 1.5.15 and later.
    ///
    /// Not in the document. Evidence: bytes of the vendor's client library (SDK 2.1.14 sends it).
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct IsOnLimit {}
    impl IsOnLimit {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@IsOnLimit`].
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct IsOnLimitReply {
        /// Whether a soft limit was hit.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub on_limit: wire::Typed<bool>,
    }
    /// Reads whether the robot is in drag mode, by the name.
    ///
    /// [`drag_status`](crate::messages::force::DragStatus) of the document reads the same under another key.
    ///
    /// Sends `get_drag_status`. Changes nothing on the robot. The reply is [`GetDragStatusReply`].
    ///
    /// Taken to be known to firmware 1.5.15 and later.
    ///
    /// Not in the document. Evidence: bytes of the vendor's client library (SDK 2.1.14 sends it); another text of the vendor (the list of commands has the name); one client.
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetDragStatus {}
    impl GetDragStatus {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@GetDragStatus`].
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetDragStatusReply {
        /// Whether the robot is in drag mode. `status` on the wire.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub drag_mode: wire::Typed<bool>,
    }
    /// Reads the speed rate, by the name.
    ///
    /// The status packet has the rate as `rapidrate`.
    ///
    /// Sends `get_rapid_rate`. Changes nothing on the robot. The reply is [`GetRapidRateReply`].
    ///
    /// Taken to be known to firmware 1.5.15 and later.
    ///
    /// Not in the document. Evidence: bytes of the vendor's client library (SDK 2.1.14 sends it); another text of the vendor (the list of commands has the name); one client.
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetRapidRate {}
    impl GetRapidRate {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@GetRapidRate`].
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetRapidRateReply {
        /// Speed rate, from 0 to 1 as in status packets; no source shows a value. `value` on the wire.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub rapid_rate: wire::Typed<f64>,
    }
    /// Reads the id of the selected tool frame.
    ///
    /// Sends `get_curr_tool_id`. Changes nothing on the robot. The reply is [`GetCurrToolIdReply`].
    ///
    /// Taken to be known to firmware 1.5.15 and later.
    ///
    /// Not in the document. Evidence: bytes of the vendor's client library (SDK 2.1.14 sends it); one client.
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetCurrToolId {}
    impl GetCurrToolId {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@GetCurrToolId`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetCurrToolIdReply {
        /// Id of the tool frame.
        pub id: i64,
    }
    /// Reads the id of the selected user frame.
    ///
    /// Sends `get_curr_user_id`. Changes nothing on the robot. The reply is [`GetCurrUserIdReply`].
    ///
    /// Taken to be known to firmware 1.5.15 and later.
    ///
    /// Not in the document. Evidence: bytes of the vendor's client library (SDK 2.1.14 sends it); one client.
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetCurrUserId {}
    impl GetCurrUserId {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@GetCurrUserId`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetCurrUserIdReply {
        /// Id of the user frame.
        pub id: i64,
    }
    /// Reads the actual positions of the six joints.
    ///
    /// [`get_joint_pos`](crate::messages::kinematics::GetJointPos) may answer commanded ones.
    ///
    /// Sends `get_actual_joint_pos`. Changes nothing on the robot. The reply is [`GetActualJointPosReply`].
    ///
    /// Taken to be known to firmware 1.5.15 and later.
    ///
    /// Not in the document. Evidence: one client (asks every 20 ms on version 1.7.2).
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetActualJointPos {}
    impl GetActualJointPos {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@GetActualJointPos`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetActualJointPosReply {
        /// Actual positions of the six joints. In deg. `position` on the wire.
        pub joint_position: super::types::JointPosition,
    }
    /// Reads the actual pose of the tool centre point.
    ///
    /// [`get_tcp_pos`](crate::messages::kinematics::GetTcpPos) may answer the commanded one.
    ///
    /// Sends `get_actual_tcp_pos`. Changes nothing on the robot. The reply is [`GetActualTcpPosReply`].
    ///
    /// Taken to be known to firmware 1.5.15 and later.
    ///
    /// Not in the document. Evidence: one client.
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetActualTcpPos {}
    impl GetActualTcpPos {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@GetActualTcpPos`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetActualTcpPosReply {
        /// Actual pose of the tool centre point. `position` on the wire.
        pub pose: super::types::Pose,
    }
}
