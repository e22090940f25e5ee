#[allow(unreachable_pub, dead_code, clippy::self_named_constructors)]
pub mod newer {
    //! What newer firmware adds.
    //!
    //! Three commands that the built-in spec does not have.
    /// Reads how the motion stands.
    ///
    /// Sends `demo_motion_state`. Changes nothing on the robot. The reply is [`DemoMotionStateReply`]. The method is [`NewerCommands::demo_motion_state`].
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct DemoMotionState {}
    impl DemoMotionState {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@DemoMotionState`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct DemoMotionStateReply {
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
    /// Sends `demo_stop_state`. Changes nothing on the robot. The reply is [`DemoStopStateReply`]. The method is [`NewerCommands::demo_stop_state`].
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct DemoStopState {}
    impl DemoStopState {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@DemoStopState`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct DemoStopStateReply {
        /// Whether the emergency stop is pressed.
        pub emergency_stop: bool,
    }
    /// Sets the time between two status packets.
    ///
    /// Sends `demo_set_period`. The method is [`NewerCommands::set_demo_period`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct SetDemoPeriod {
        /// Time between two packets. In ms, at least 1. `demo_period` on the wire.
        pub period: i64,
    }
    impl SetDemoPeriod {
        /// With the required fields alone.
        ///
        /// - `period`: in ms, at least 1
        pub const fn new(period: i64) -> Self {}
    }
    /// The commands of [`newer`](self) as methods: of a client, of a robot, and of all else that takes commands.
    pub trait NewerCommands: ::jaka_sync::Call {
        /// Reads how the motion stands.
        ///
        /// Sends [`demo_motion_state`](type@DemoMotionState). Changes nothing on the robot.
        ///
        /// # Examples
        ///
        /// Reply:
        ///
        /// ```json
        /// {"errorCode": "0", "errorMsg": "", "cmdName": "demo_motion_state", "inpos": true, "paused": false, "queue": 3, "active_queue": 1}
        /// ```
        ///
        /// # Errors
        /// As `Call::call`.
        fn demo_motion_state(
            &mut self,
        ) -> Result<DemoMotionStateReply, ::jaka_sync::Error>;
        /// Reads whether the emergency stop is pressed.
        ///
        /// Sends [`demo_stop_state`](type@DemoStopState). Changes nothing on the robot.
        ///
        /// # Errors
        /// As `Call::call`.
        fn demo_stop_state(&mut self) -> Result<DemoStopStateReply, ::jaka_sync::Error>;
        /// Sets the time between two status packets.
        ///
        /// Sends [`demo_set_period`](type@SetDemoPeriod).
        ///
        /// # Errors
        /// As `Call::call`.
        fn set_demo_period(&mut self, period: i64) -> Result<(), ::jaka_sync::Error>;
    }
    impl<T: ::jaka_sync::Call + ?Sized> NewerCommands for T {}
}
