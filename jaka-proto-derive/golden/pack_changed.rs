#[allow(unreachable_pub, dead_code, clippy::self_named_constructors)]
pub mod changed {
    //! What newer firmware changes.
    //!
    //! A field more for [`joint_move`](type@JointMove), a wider range, a settled dispute, a status key, the status as a reply, and an error code.
    /// Reads what a status packet says.
    ///
    /// Sends `read_whole_state`. Changes nothing on the robot. The reply is [`type@RobotStatus`]. The method is [`ChangedCommands::read_whole_state`].
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct ReadWholeState {}
    impl ReadWholeState {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// Moves all joints to a position, or by an offset, at a joint speed (MoveJ).
    ///
    /// The motion starts when the one before it has ended. To move at once, stop that one first with [`stop_program`](proto::messages::program::StopProgram).
    ///
    /// The reply says that the motion was accepted, not that it has ended.
    ///
    /// Sends `joint_move` (4.7). The robot must be powered, enabled and outside servo mode. The method is [`ChangedCommands::joint_move_changed`].
    ///
    /// # Refusals
    ///
    /// Known causes of a refusal:
    ///
    /// - Malformed arguments (transcript).
    /// - A target beyond the ranges of the joints (the vendor's event `0x0F0011`).
    ///
    /// # Errata
    ///
    /// - The text calls the motion blocking. The vendor's page for firmware 1.7 calls all commands asynchronous: a reply says that the command was received and preprocessed.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct JointMove {
        /// Whether `joint_position` is a target or an offset. `relFlag` on the wire.
        pub mode: ::jaka_sync::types::MoveMode,
        /// Target or offset of the six joints. In deg. `jointPosition` on the wire.
        ///
        /// Advised: -360 to 360, where `mode` is 0 (Absolute); -720 to 720, where `mode` is 1 (Relative). Anything else is refused unless that is left to the controller: see [`AdvisoryRanges`](check::AdvisoryRanges).
        pub joint_position: ::jaka_sync::types::JointPosition,
        /// Joint speed; the direction comes from `joint_position` alone. In deg/s, at least 0.
        ///
        /// Advised: more than 0, at most 265. Anything else is refused unless that is left to the controller: see [`AdvisoryRanges`](check::AdvisoryRanges).
        pub speed: f64,
        /// Joint acceleration. In deg/s², at least 0. The document advises 720 at most. Controllers take the command without it (field notes). `accel` on the wire.
        ///
        /// Advised: more than 0, at most 720. Anything else is refused unless that is left to the controller: see [`AdvisoryRanges`](check::AdvisoryRanges).
        pub acceleration: Option<f64>,
        /// Distance from its end at which the motion may blend into the next one: 0 reaches the end. At least 0. `tol` on the wire.
        ///
        /// Its unit is not stated, so a robot with limits refuses a motion that has it.
        ///
        /// Known to firmware 1.5.15 and later.
        pub tolerance: Option<f64>,
        /// Id of the line that the motion belongs to, by the name. [`get_motion_state`](proto::messages::beyond_state::GetMotionState) may show it as `motion_line`.
        ///
        /// Known to firmware 1.5.15 and later.
        pub executing_line_id: Option<i64>,
        /// Distance from the target at which the next motion may begin. In mm, at least 0.
        ///
        /// Known to firmware 1.7.1 and later.
        pub zone: Option<f64>,
    }
    impl JointMove {
        /// With the required fields alone.
        ///
        /// - `joint_position`: in deg
        /// - `speed`: in deg/s, at least 0
        pub fn new(
            mode: ::jaka_sync::types::MoveMode,
            joint_position: impl Into<::jaka_sync::types::JointPosition>,
            speed: f64,
        ) -> Self {}
        /// The coordinates are the target.
        ///
        /// - `joint_position`: in deg
        /// - `speed`: in deg/s, at least 0
        pub fn absolute(
            joint_position: impl Into<::jaka_sync::types::JointPosition>,
            speed: f64,
        ) -> Self {}
        /// The coordinates are an offset.
        ///
        /// - `joint_position`: in deg
        /// - `speed`: in deg/s, at least 0
        pub fn relative(
            joint_position: impl Into<::jaka_sync::types::JointPosition>,
            speed: f64,
        ) -> Self {}
        /// Joint acceleration. In deg/s², at least 0. `accel` on the wire.
        pub fn acceleration(mut self, acceleration: f64) -> Self {}
        /// Distance from its end at which the motion may blend into the next one: 0 reaches the end. At least 0. `tol` on the wire.
        pub fn tolerance(mut self, tolerance: f64) -> Self {}
        /// Id of the line that the motion belongs to, by the name.
        pub fn executing_line_id(mut self, executing_line_id: i64) -> Self {}
        /// Distance from the target at which the next motion may begin. In mm, at least 0.
        pub fn zone(mut self, zone: f64) -> Self {}
    }
    /// Sets the rate by which the controller scales the speed of motion.
    ///
    /// The document speaks of the rate at which programs run; whether a motion that is running follows the new rate at once
    /// is not stated.
    ///
    /// Sends `rapid_rate` (4.17). The method is [`ChangedCommands::set_rapid_rate_changed`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct SetRapidRate {
        /// Rate. 0 to 1.5. The default is 1. `rate_value` on the wire.
        pub rate: f64,
    }
    impl SetRapidRate {
        /// With the required fields alone.
        ///
        /// - `rate`: 0 to 1.5
        pub const fn new(rate: f64) -> Self {}
    }
    /// Sets the voltage output of a version 3 tool I/O board.
    ///
    /// The sources contradict each other on both values, and a tool meant for 12 V can be destroyed by 24 V. So both values stay raw. The bytes of the
    /// vendor's own client library (SDK 2.1.14) support the reading 1 = on and 0 = 24 V: it sends its own values untranslated. So do its headers,
    /// the manual, six users, and one program on port 10001 itself. The TCP document stands alone; no measurement is known. Who sends 0 for 12 V may
    /// put 24 V on the tool: with no tool connected, measure first which value gives which voltage.
    ///
    /// The setting wants a disabled arm (one client).
    ///
    /// Sends `set_tio_vout_param` (4.80). The method is [`ChangedCommands::set_tio_vout_param_changed`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct SetTioVoutParam {
        /// Raw switch of the voltage output. 0 to 1. The sources contradict each other on which of them is on. `tio_vout_ena` on the wire.
        ///
        /// Sources contradict each other on the meaning, so the value is passed on as it is:
        ///
        /// - document 2.0.4 alone: 0 = enabled, 1 = not enabled
        /// - bytes of the vendor's SDK 2.1.14, its headers (SDK 2.2.2 and another), its manual, six users, one program on port 10001: 0 = off, 1 = on
        pub output_enable: i64,
        /// Voltage of the tool's output. `tio_vout_vol` on the wire.
        ///
        /// Settled: Measured at the tool's connector.
        pub output_voltage: ToolVoltage,
    }
    impl SetTioVoutParam {
        /// With the required fields alone.
        ///
        /// - `output_enable`: 0 to 1
        pub const fn new(output_enable: i64, output_voltage: ToolVoltage) -> Self {}
    }
    /// Reads one status packet on the command port.
    ///
    /// The reply has the keys of the packets of port 10000 next to its own, 1.5 to 9 KB of them, and arrives in pieces. Clients use it for what
    /// no query of the document tells, such as the tool's inputs and the selected frames. Some controllers add `executing_line`, which is skipped.
    ///
    /// Sends `get_data`. Changes nothing on the robot. The reply is [`type@RobotStatus`]. The method is [`ChangedCommands::get_data_changed`].
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
    /// Voltage of the tool's output.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum ToolVoltage {
        /// 24 V. `0` on the wire.
        V24,
        /// 12 V. `1` on the wire.
        V12,
        /// A value that the spec does not list.
        Other(i64),
    }
    impl From<i64> for ToolVoltage {}
    impl From<ToolVoltage> for i64 {}
    /// The value in words; one that the spec does not list as its number.
    impl ::core::fmt::Display for ToolVoltage {}
    /// State of the robot, as one packet of port 10000 gives it.
    ///
    /// Any key may be absent. Those that newer firmware adds stand last here; a controller sends them among the others (capture). A refused
    /// command on port 10001 does not show here.
    #[derive(Debug, Clone, PartialEq, Default)]
    #[non_exhaustive]
    pub struct RobotStatus {
        /// State of the brakes.
        pub brake_state: Option<i64>,
    }
    impl ::jaka_sync::MotionStatus for RobotStatus {}
    /// The commands of [`changed`](self) as methods: of a client, of a robot, and of all else that takes commands.
    pub trait ChangedCommands: ::jaka_sync::Call {
        /// Reads what a status packet says.
        ///
        /// Sends [`read_whole_state`](type@ReadWholeState). Changes nothing on the robot.
        ///
        /// # Errors
        /// As `Call::call`.
        fn read_whole_state(&mut self) -> Result<RobotStatus, ::jaka_sync::Error>;
        /// Moves all joints to a position, or by an offset, at a joint speed (MoveJ).
        ///
        /// The motion starts when the one before it has ended. To move at once, stop that one first with [`stop_program`](proto::messages::program::StopProgram).
        ///
        /// The reply says that the motion was accepted, not that it has ended.
        ///
        /// Sends [`joint_move`](type@JointMove) (4.7). The robot must be powered, enabled and outside servo mode.
        ///
        /// # Refusals
        ///
        /// Known causes of a refusal:
        ///
        /// - Malformed arguments (transcript).
        /// - A target beyond the ranges of the joints (the vendor's event `0x0F0011`).
        ///
        /// # Errata
        ///
        /// - The text calls the motion blocking. The vendor's page for firmware 1.7 calls all commands asynchronous: a reply says that the command was received and preprocessed.
        ///
        /// # Examples
        ///
        /// Request:
        ///
        /// ```json
        /// {"cmdName": "joint_move", "relFlag": 0, "jointPosition": [0, 90.5, 90.5, 0, 90.5, 0], "speed": 20.5, "accel": 20.5}
        /// ```
        ///
        /// Reply:
        ///
        /// ```json
        /// {"errorCode": "0", "errorMsg": "", "cmdName": "joint_move"}
        /// ```
        ///
        /// # Errors
        /// As `Call::call`. In another state than the one it needs, expect a refusal.
        fn joint_move_changed(
            &mut self,
            request: &JointMove,
        ) -> Result<(), ::jaka_sync::Error>;
        /// Sets the rate by which the controller scales the speed of motion.
        ///
        /// The document speaks of the rate at which programs run; whether a motion that is running follows the new rate at once
        /// is not stated.
        ///
        /// Sends [`rapid_rate`](type@SetRapidRate) (4.17).
        ///
        /// # Examples
        ///
        /// Request:
        ///
        /// ```json
        /// {"cmdName": "rapid_rate", "rate_value": 0.2}
        /// ```
        ///
        /// Reply:
        ///
        /// ```json
        /// {"errorCode": "0", "errorMsg": "", "cmdName": "rapid_rate"}
        /// ```
        ///
        /// # Errors
        /// As `Call::call`.
        fn set_rapid_rate_changed(
            &mut self,
            rate: f64,
        ) -> Result<(), ::jaka_sync::Error>;
        /// Sets the voltage output of a version 3 tool I/O board.
        ///
        /// The sources contradict each other on both values, and a tool meant for 12 V can be destroyed by 24 V. So both values stay raw. The bytes of the
        /// vendor's own client library (SDK 2.1.14) support the reading 1 = on and 0 = 24 V: it sends its own values untranslated. So do its headers,
        /// the manual, six users, and one program on port 10001 itself. The TCP document stands alone; no measurement is known. Who sends 0 for 12 V may
        /// put 24 V on the tool: with no tool connected, measure first which value gives which voltage.
        ///
        /// The setting wants a disabled arm (one client).
        ///
        /// Sends [`set_tio_vout_param`](type@SetTioVoutParam) (4.80).
        ///
        /// # Examples
        ///
        /// Request:
        ///
        /// ```json
        /// {"cmdName": "set_tio_vout_param", "tio_vout_ena": 0, "tio_vout_vol": 0}
        /// ```
        ///
        /// Reply:
        ///
        /// ```json
        /// {"errorCode": "0", "errorMsg": "", "cmdName": "set_tio_vout_param"}
        /// ```
        ///
        /// # Errors
        /// As `Call::call`.
        fn set_tio_vout_param_changed(
            &mut self,
            request: &SetTioVoutParam,
        ) -> Result<(), ::jaka_sync::Error>;
        /// Reads one status packet on the command port.
        ///
        /// The reply has the keys of the packets of port 10000 next to its own, 1.5 to 9 KB of them, and arrives in pieces. Clients use it for what
        /// no query of the document tells, such as the tool's inputs and the selected frames. Some controllers add `executing_line`, which is skipped.
        ///
        /// Sends [`get_data`](type@GetData). Changes nothing on the robot.
        ///
        /// Taken to be known to firmware 1.4 and later.
        ///
        /// Not in the document. Evidence: bytes of the vendor's client library (SDK 1.0.19 sends it); several independent clients (seven programs, on controllers from 1.4 on).
        ///
        /// # Examples
        ///
        /// Request:
        ///
        /// ```json
        /// {"cmdName":"get_data"}
        /// ```
        ///
        /// Reply:
        ///
        /// ```json
        /// {"errorCode": "0", "errorMsg": "", "cmdName": "get_data", "tio_din": [0, 0, 0, 0, 0, 0, 0, 0], "current_tool_id": 0, "current_user_id": 0, "inpos": true}
        /// ```
        ///
        /// # Errors
        /// As `Call::call`.
        fn get_data_changed(&mut self) -> Result<RobotStatus, ::jaka_sync::Error>;
    }
    impl<T: ::jaka_sync::Call + ?Sized> ChangedCommands for T {}
    /// The payload is too heavy for the motion.
    pub const OVERLOAD: proto::ErrorCode = proto::ErrorCode(5i64);
    /// Meaning of a code in a sentence, from sources; `None` for a code that neither they nor this module name.
    pub fn meaning(code: proto::ErrorCode) -> Option<&'static str> {}
}
