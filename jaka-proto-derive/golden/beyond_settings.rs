pub mod beyond_settings {
    //! Motion, mounting and packets, beyond the document.
    //!
    //! Commands that the document does not have. Newer firmware answers them, and public clients use them.
    //!
    //! From which firmware on a controller has them is not known. Of firmware 1.5.14 it is known that it refuses [`emergency_stop_status`](crate::messages::beyond_state::EmergencyStopStatus), and it is
    //! taken to lack all of them: `since` is the version after it. [`torque_feedforward`](type@TorqueFeedforward) is older: the program of a client that sends it follows the
    //! file names of firmware before 1.5 (4.18).
    /// Sets a feed-forward of the joints' torques, as currents by its name. It belongs to the torque control mode.
    ///
    /// **With the mode `user` the torque is wholly the program's: zeros leave an arm without compensation of its gravity, so that it falls.** No source
    /// says which state of the robot the command needs: keep clear of it.
    ///
    /// Sends `torque_feedforward`.
    ///
    /// Not in the document. Evidence: another text of the vendor (the header of SDK 1.0.19); several independent clients (two).
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct TorqueFeedforward {
        /// Value for each joint. Unit not stated. `grvCurrent` on the wire.
        pub currents: [f64; 6],
        /// Meaning of the values. The vendor's header for its SDK 1.0.19 says it; the name of the key reads as something else. `includeGrvFlag` on the wire.
        pub mode: TorqueFeedforwardMode,
    }
    impl TorqueFeedforward {
        /// With the required fields alone.
        pub const fn new(currents: [f64; 6], mode: TorqueFeedforwardMode) -> Self {}
    }
    /// Sets the kind of planner that drives motions.
    ///
    /// Sends `set_motion_planner`.
    ///
    /// Taken to be known to firmware 1.5.15 and later.
    ///
    /// Not in the document. Evidence: one client.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct SetMotionPlanner {
        /// Kind of planner. `type` on the wire.
        pub planner: MotionPlanner,
    }
    impl SetMotionPlanner {
        /// With the required fields alone.
        pub const fn new(planner: MotionPlanner) -> Self {}
    }
    /// Sets how far from singularities and joint limits the controller warns.
    ///
    /// Sends `set_motion_limit_warning_range`.
    ///
    /// Taken to be known to firmware 1.5.15 and later.
    ///
    /// Not in the document. Evidence: bytes of the vendor's client library (SDK 2.1.14 sends it); one client.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct SetMotionLimitWarningRange {
        /// Level of the warning range, from 1 to 5. 1 to 5. No source says which one is the widest. `range_level` on the wire.
        pub level: i64,
    }
    impl SetMotionLimitWarningRange {
        /// With the required fields alone.
        ///
        /// - `level`: 1 to 5
        pub const fn new(level: i64) -> Self {}
    }
    /// Reads how far from singularities and joint limits the controller warns.
    ///
    /// Sends `get_motion_limit_warning_range`. Changes nothing on the robot. The reply is [`GetMotionLimitWarningRangeReply`].
    ///
    /// Taken to be known to firmware 1.5.15 and later.
    ///
    /// Not in the document. Evidence: bytes of the vendor's client library (SDK 2.1.14 sends it); one client.
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetMotionLimitWarningRange {}
    impl GetMotionLimitWarningRange {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@GetMotionLimitWarningRange`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetMotionLimitWarningRangeReply {
        /// Level of the range, from 1 to 5. `range_level` on the wire.
        pub level: i64,
    }
    /// Sets how the arm is mounted.
    ///
    /// No source says what an arm does whose angle is wrong, when it is enabled or led by hand: keep clear of it.
    ///
    /// Sends `set_installation_angle`.
    ///
    /// Taken to be known to firmware 1.5.15 and later.
    ///
    /// Not in the document. Evidence: bytes of the vendor's client library (SDK 2.1.14 sends it, in degrees); another text of the vendor (the English page); one client.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct SetInstallationAngle {
        /// Rotation about x, by the name. In deg, 0 to 180. `angleX` on the wire.
        pub angle_x: f64,
        /// Rotation about z, by the name. In deg, 0 to 360. `angleZ` on the wire.
        pub angle_z: f64,
    }
    impl SetInstallationAngle {
        /// With the required fields alone.
        ///
        /// - `angle_x`: in deg, 0 to 180
        /// - `angle_z`: in deg, 0 to 360
        pub const fn new(angle_x: f64, angle_z: f64) -> Self {}
    }
    /// Reads how the arm is mounted.
    ///
    /// The reply's keys are not known, so they are given as they come.
    ///
    /// Sends `get_installation_angle`. Changes nothing on the robot.
    ///
    /// Taken to be known to firmware 1.5.15 and later.
    ///
    /// Not in the document. Evidence: bytes of the vendor's client library (SDK 2.1.14 sends it).
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetInstallationAngle {}
    impl GetInstallationAngle {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// Sets the filter of the torque sensor.
    ///
    /// What a force control that is on does with another filter is not stated: keep clear of the arm.
    ///
    /// Sends `set_torque_sensor_filter`.
    ///
    /// Taken to be known to firmware 1.5.15 and later.
    ///
    /// Not in the document. Evidence: bytes of the vendor's client library (SDK 2.1.14 sends it).
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct SetTorqueSensorFilter {
        /// Filter. At least 0. Its unit is not stated, nor its range. `torqueSensorFilter` on the wire.
        pub filter: f64,
    }
    impl SetTorqueSensorFilter {
        /// With the required fields alone.
        ///
        /// - `filter`: at least 0
        pub const fn new(filter: f64) -> Self {}
    }
    /// Sets the frame of force control.
    ///
    /// An arm under force control may move by it: keep clear of it. [`set_compliant_type`](crate::messages::force::SetCompliantType) and the commands of the document switch force control.
    ///
    /// Sends `set_ft_ctrl_frame`.
    ///
    /// Taken to be known to firmware 1.5.15 and later.
    ///
    /// Not in the document. Evidence: bytes of the vendor's client library (SDK 2.1.14 sends it).
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct SetFtCtrlFrame {
        /// Frame. At least 0. The values are not explained. `ftFrame` on the wire.
        pub frame: i64,
    }
    impl SetFtCtrlFrame {
        /// With the required fields alone.
        ///
        /// - `frame`: at least 0
        pub const fn new(frame: i64) -> Self {}
    }
    /// Takes the present reading of the torque sensor as its zero, by the name.
    ///
    /// An arm under force control may move by it: keep clear of it.
    ///
    /// Sends `zero_end_sensor`.
    ///
    /// Taken to be known to firmware 1.5.15 and later.
    ///
    /// Not in the document. Evidence: bytes of the vendor's client library (SDK 2.1.14 sends it).
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct ZeroEndSensor {}
    impl ZeroEndSensor {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// Sets the time between two packets of port 10000.
    ///
    /// Sends `set_port10000_delay_ms`.
    ///
    /// Taken to be known to firmware 1.5.15 and later.
    ///
    /// Not in the document. Evidence: several independent clients (two).
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct SetPort10000DelayMs {
        /// Time between two packets. In ms, at least 0. `port10000_delay_ms` on the wire.
        pub delay: i64,
    }
    impl SetPort10000DelayMs {
        /// With the required fields alone.
        ///
        /// - `delay`: in ms, at least 0
        pub const fn new(delay: i64) -> Self {}
    }
    /// Reads the time between two packets of port 10000.
    ///
    /// Sends `get_port10000_delay_ms`. Changes nothing on the robot. The reply is [`GetPort10000DelayMsReply`].
    ///
    /// Taken to be known to firmware 1.5.15 and later.
    ///
    /// Not in the document. Evidence: several independent clients (two).
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetPort10000DelayMs {}
    impl GetPort10000DelayMs {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@GetPort10000DelayMs`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetPort10000DelayMsReply {
        /// Time between two packets. In ms. `port10000_delay_ms` on the wire.
        pub delay: i64,
    }
    /// Sets an entry of the controller's configuration of port 10000.
    ///
    /// Section `ATTROPTIONALDATA` has keys such as `joint_actual_position`, `powered_on` and `inpos`, with the value 1 where status packets have
    /// that key: so packets may lack even those. In section `PORTCONFIG`, `port10000_delay_ms` is the time between two packets. Leave the
    /// entries of port 10004 alone, which the vendor's own comment warns about.
    ///
    /// Sends `setOptionalInfoConfig`.
    ///
    /// Taken to be known to firmware 1.5.15 and later.
    ///
    /// Not in the document. Evidence: another text of the vendor (the configuration file with both sections is published); several independent clients (two, one for each section).
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct SetOptionalInfoConfig {
        /// Section of the configuration, `ATTROPTIONALDATA` or `PORTCONFIG`.
        pub section: String,
        /// Key of the entry. `key` on the wire.
        pub entry: String,
        /// Value of the entry: a number such as 1 in `ATTROPTIONALDATA`, a string such as `50` in `PORTCONFIG`.
        pub value: wire::Value,
    }
    impl SetOptionalInfoConfig {
        /// With the required fields alone.
        pub fn new(
            section: impl Into<String>,
            entry: impl Into<String>,
            value: wire::Value,
        ) -> Self {}
    }
    /// Reads an entry of the controller's configuration of port 10000: see [`set_optional_info_config`](type@SetOptionalInfoConfig).
    ///
    /// Sends `getOptionalInfoConfig`. Changes nothing on the robot. The reply is [`GetOptionalInfoConfigReply`].
    ///
    /// Taken to be known to firmware 1.5.15 and later.
    ///
    /// Not in the document. Evidence: another text of the vendor (the configuration file with both sections is published); several independent clients (two, one for each section).
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetOptionalInfoConfig {
        /// Section of the configuration.
        pub section: String,
        /// Key of the entry. `key` on the wire.
        pub entry: String,
    }
    impl GetOptionalInfoConfig {
        /// With the required fields alone.
        pub fn new(section: impl Into<String>, entry: impl Into<String>) -> Self {}
    }
    /// What the controller answers to [`type@GetOptionalInfoConfig`].
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetOptionalInfoConfigReply {
        /// Value of the entry, a string also where it is a number.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub value: wire::Typed<String>,
    }
    /// Meaning of the values of [`torque_feedforward`](type@TorqueFeedforward).
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum TorqueFeedforwardMode {
        /// The controller's own feed-forward holds, whatever the values are. `0` on the wire.
        Controller,
        /// The values are added to the controller's own torque. `1` on the wire.
        Offset,
        /// The values are the whole torque, that against gravity included: zeros let the arm fall. `2` on the wire.
        User,
        /// A value that the spec does not list.
        Other(i64),
    }
    impl From<i64> for TorqueFeedforwardMode {}
    impl From<TorqueFeedforwardMode> for i64 {}
    /// The value in words; one that the spec does not list as its number.
    impl ::core::fmt::Display for TorqueFeedforwardMode {}
    /// Kind of planner that drives motions.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum MotionPlanner {
        /// Off, by the source's one word for it. `-1` on the wire.
        Off,
        /// T, the source's letter: usually a trapezoidal profile of the speed. `0` on the wire.
        T,
        /// S, the source's letter: usually a profile with limited jerk. `1` on the wire.
        S,
        /// A value that the spec does not list.
        Other(i64),
    }
    impl From<i64> for MotionPlanner {}
    impl From<MotionPlanner> for i64 {}
    /// The value in words; one that the spec does not list as its number.
    impl ::core::fmt::Display for MotionPlanner {}
}
