pub mod power {
    //! Power, enabling and the controller's state.
    //!
    //! The arm is ready to move when it has power and is enabled, in this order.
    //!
    //! A reply to [`power_on`](type@PowerOn) or [`enable_robot`](type@EnableRobot), even with errorCode 0, is not proof of the new state: firmware 1.5.14 replies when the state is
    //! there, newer firmware at once. Poll [`get_robot_state`](type@GetRobotState) or the status of port 10000 until the state is there.
    //!
    //! Leave the states in the reverse order, from an arm at rest: powering off wants a disabled arm, a shutdown one without power (events in the
    //! vendor's table).
    /// Switches the arm's power on.
    ///
    /// This takes about 8 s. Firmware 1.5.14 replies when the arm has power (three transcripts), newer firmware at once (vendor's SDK). So an
    /// errorCode of 0 is not proof that the arm has power: poll the state.
    ///
    /// Sends `power_on` (4.1). The reply is [`PowerOnReply`].
    ///
    /// # Errata
    ///
    /// - The reply's key `power status` has a blank in it.
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct PowerOn {}
    impl PowerOn {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@PowerOn`].
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct PowerOnReply {
        /// Whether the arm has power, where the controller says so. `power status` on the wire.
        pub powered_on: Option<bool>,
    }
    /// Switches the arm's power off.
    ///
    /// It wants a disabled arm (event `0x0F0026`).
    ///
    /// Sends `power_off` (4.2).
    ///
    /// # Refusals
    ///
    /// Known causes of a refusal:
    ///
    /// - The arm is still enabled (the vendor's event `0x0F0026`).
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct PowerOff {}
    impl PowerOff {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// Enables the arm, so that it can move.
    ///
    /// This takes 3 to 4 s as a rule; 20 s is seen. Firmware 1.5.14 replies when the arm is enabled, as to [`power_on`](type@PowerOn) (transcripts), newer firmware at once
    /// (vendor's SDK). So an errorCode of 0 is not proof that the arm is enabled: poll the state.
    ///
    /// Sends `enable_robot` (4.3). The robot must be powered. The reply is [`EnableRobotReply`].
    ///
    /// # Errata
    ///
    /// - The reply's key `enabled status` has a blank in it.
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct EnableRobot {}
    impl EnableRobot {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@EnableRobot`].
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct EnableRobotReply {
        /// Whether the arm is enabled, where the controller says so. `enabled status` on the wire.
        pub enabled: Option<bool>,
    }
    /// Disables the arm.
    ///
    /// The vendor's table of events has it refused while the arm moves or a program runs (`0x0F003A` and `0x0F0027`). Firmware 1.5.14 acknowledged
    /// it while the arm moved, twice (transcripts); what the arm did is not recorded. Stop the arm first.
    ///
    /// Sends `disable_robot` (4.4).
    ///
    /// # Refusals
    ///
    /// Known causes of a refusal:
    ///
    /// - A program runs (the vendor's event `0x0F0027`).
    /// - The arm moves (the vendor's event `0x0F003A`); firmware 1.5.14 acknowledged it all the same, twice (transcripts).
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct DisableRobot {}
    impl DisableRobot {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// Shuts down the arm and the controller.
    ///
    /// It wants an arm without power (vendor's table of events). The document shows a reply, users see none. The connection is of no use
    /// afterwards.
    ///
    /// Sends `shutdown` (4.5).
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct Shutdown {}
    impl Shutdown {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// Reads whether the arm has power and is enabled.
    ///
    /// Old firmware answers with the document's words, newer firmware with true and false or with numbers, and adds the
    /// controller's error.
    ///
    /// Sends `get_robot_state` (4.12). Changes nothing on the robot. The reply is [`GetRobotStateReply`].
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetRobotState {}
    impl GetRobotState {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@GetRobotState`].
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetRobotStateReply {
        /// Whether the arm is enabled. `enable` on the wire.
        pub enabled: bool,
        /// Whether the arm has power. `power` on the wire.
        pub powered_on: bool,
        /// Code of the controller's event, which is not always an error; newer firmware adds the key, from which version on is not recorded. `errcode` on the wire.
        ///
        /// A controller was seen to write a number, 17760261 for `0x10f0005`, and the vendor's own SDK aborts on a string. One example in the field
        /// notes has a hexadecimal string, `0x0`, as on port 10000; no capture does. So it is passed on as it comes; the Rust method `event` reads both.
        pub error_code: Option<wire::Value>,
        /// The message that goes with `error_code`, which newer firmware adds. `msg` on the wire.
        pub error_message: Option<String>,
    }
    /// Reads the version of the controller's software.
    ///
    /// Sends `get_version` (4.51). Changes nothing on the robot. The reply is [`GetVersionReply`].
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetVersion {}
    impl GetVersion {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@GetVersion`].
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetVersionReply {
        /// Version, such as `1.6.5_01_X86`, or `1.5.14_13_X64` (transcript).
        pub version: String,
        /// Name of the robot.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub robot_name: Option<wire::Typed<String>>,
        /// Id of the robot.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub robot_id: Option<wire::Typed<String>>,
    }
}
