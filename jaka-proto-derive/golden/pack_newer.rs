#[allow(unreachable_pub, dead_code, clippy::self_named_constructors)]
pub mod newer {
    //! What newer firmware adds.
    //!
    //! Three commands that the built-in spec does not have.
    /// Reads how the motion stands.
    ///
    /// Sends `get_motion_state`. Changes nothing on the robot. The reply is [`GetMotionStateReply`]. The method is [`NewerCommands::get_motion_state`].
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetMotionState {}
    impl GetMotionState {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@GetMotionState`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetMotionStateReply {
        /// Whether the arm is in position. `inpos` on the wire.
        pub in_position: bool,
        /// Whether the motion is paused.
        pub paused: bool,
        /// How many motions are queued.
        pub queue: i64,
        /// How many of the queued motions are being carried out.
        pub active_queue: i64,
    }
    /// Reads whether the emergency stop is pressed.
    ///
    /// Sends `emergency_stop_status`. Changes nothing on the robot. The reply is [`EmergencyStopStatusReply`]. The method is [`NewerCommands::emergency_stop_status`].
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
        /// Whether the emergency stop is pressed.
        pub emergency_stop: bool,
    }
    /// Sets the time between two status packets.
    ///
    /// Sends `set_port10000_delay_ms`. The method is [`NewerCommands::set_status_period`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct SetStatusPeriod {
        /// Time between two packets. In ms, at least 1. `port10000_delay_ms` on the wire.
        pub period: i64,
    }
    impl SetStatusPeriod {
        /// With the required fields alone.
        ///
        /// - `period`: in ms, at least 1
        pub const fn new(period: i64) -> Self {}
    }
    /// The commands of [`newer`](self) as methods: of a client, of a robot, and of all else that takes commands.
    pub trait NewerCommands: ::jaka_sync::Call {
        /// Reads how the motion stands.
        ///
        /// Sends [`get_motion_state`](type@GetMotionState). Changes nothing on the robot.
        ///
        /// # Example
        /// ```text
        /// <- {"errorCode": "0", "errorMsg": "", "cmdName": "get_motion_state", "inpos": true, "paused": false, "queue": 3, "active_queue": 1}
        /// ```
        ///
        /// # Errors
        /// As `Call::call`.
        fn get_motion_state(
            &mut self,
        ) -> Result<GetMotionStateReply, ::jaka_sync::Error>;
        /// Reads whether the emergency stop is pressed.
        ///
        /// Sends [`emergency_stop_status`](type@EmergencyStopStatus). Changes nothing on the robot.
        ///
        /// # Errors
        /// As `Call::call`.
        fn emergency_stop_status(
            &mut self,
        ) -> Result<EmergencyStopStatusReply, ::jaka_sync::Error>;
        /// Sets the time between two status packets.
        ///
        /// Sends [`set_port10000_delay_ms`](type@SetStatusPeriod).
        ///
        /// # Errors
        /// As `Call::call`.
        fn set_status_period(&mut self, period: i64) -> Result<(), ::jaka_sync::Error>;
    }
    impl<T: ::jaka_sync::Call + ?Sized> NewerCommands for T {}
}
