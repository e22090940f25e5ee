pub mod force {
    //! Force control and drag mode.
    //!
    //! Leading the arm by hand, the torque sensor at its end, and control that yields to forces.
    //!
    //! While such control is on, the arm may move with the forces that act on it. The document gives no units for forces and
    //! torques here.
    /// Switches drag mode on or off.
    ///
    /// In drag mode the arm gives way to the hand and can be led. [`drag_status`](type@DragStatus) reads the mode back.
    ///
    /// Sends `torque_control_enable` (4.36). The robot must be powered and enabled.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct SetTorqueControl {
        /// Whether drag mode is on.
        pub enable_flag: super::types::Switch,
    }
    impl SetTorqueControl {
        /// With the required fields alone.
        pub const fn new(enable_flag: super::types::Switch) -> Self {}
    }
    /// Reads whether the robot is in drag mode.
    ///
    /// Sends `drag_status` (4.37). Changes nothing on the robot. The reply is [`DragStatusReply`].
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct DragStatus {}
    impl DragStatus {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@DragStatus`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct DragStatusReply {
        /// Whether the robot is in drag mode.
        pub drag_status: bool,
    }
    /// Sets the brand of the torque sensor.
    ///
    /// Sends `set_torsenosr_brand` (4.61).
    ///
    /// # Errata
    ///
    /// - The wire spells the name `torsenosr`.
    /// - The document's text calls the key `sensor_band`; its sample sends `sensor_brand`.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct SetTorqueSensorBrand {
        /// Brand of the sensor. `sensor_brand` on the wire.
        pub brand: TorqueSensorBrand,
    }
    impl SetTorqueSensorBrand {
        /// With the required fields alone.
        pub const fn new(brand: TorqueSensorBrand) -> Self {}
    }
    /// Reads the brand of the torque sensor.
    ///
    /// Sends `get_torsenosr_brand` (4.62). Changes nothing on the robot. The reply is [`GetTorqueSensorBrandReply`].
    ///
    /// # Errata
    ///
    /// - The wire spells the name `torsenosr`.
    /// - The document's text calls the key `sensor_band`; its sample answers `sensor_brand`.
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetTorqueSensorBrand {}
    impl GetTorqueSensorBrand {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@GetTorqueSensorBrand`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetTorqueSensorBrandReply {
        /// Brand of the sensor. `sensor_brand` on the wire.
        pub brand: TorqueSensorBrand,
    }
    /// Sets the parameters of admittance control for one axis.
    ///
    /// For moving the arm by hand, the document wants the constant force and the normal tracking of all axes to be zero.
    ///
    /// Sends `set_admit_ctrl_config` (4.63).
    ///
    /// # Errata
    ///
    /// - The wire spells `ftNnormalTrack` with a double N.
    /// - The sample sends `ftReboundFK` last; the text, and the rows of 4.64, have it right after `ftUser`.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct SetAdmitCtrlConfig {
        /// Axis to set.
        pub axis: CartesianAxis,
        /// Whether the axis is on. `opt` on the wire.
        pub enabled: super::types::Switch,
        /// Damping: the force with which a user moves the arm along the axis at its greatest speed. `ftUser` on the wire.
        ///
        /// Unit not stated.
        pub user_force: f64,
        /// Constant force. Unit not stated. Zero for moving the arm by hand. `ftConstant` on the wire.
        pub constant_force: f64,
        /// Normal tracking. Zero for moving the arm by hand. `ftNnormalTrack` on the wire.
        ///
        /// The document does not say which other values there are.
        pub normal_track: i64,
        /// Rebound: how strongly the arm returns to its initial state. Unit not stated. `ftReboundFK` on the wire.
        pub rebound: f64,
    }
    impl SetAdmitCtrlConfig {
        /// With the required fields alone.
        pub const fn new(
            axis: CartesianAxis,
            enabled: super::types::Switch,
            user_force: f64,
            constant_force: f64,
            normal_track: i64,
            rebound: f64,
        ) -> Self {}
    }
    /// Reads the parameters of admittance control for all axes.
    ///
    /// Sends `get_admit_ctrl_config` (4.64). Changes nothing on the robot. The reply is [`GetAdmitCtrlConfigReply`].
    ///
    /// # Errata
    ///
    /// - The document's text describes six rows of five values; its sample has one more array around the six rows.
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetAdmitCtrlConfig {}
    impl GetAdmitCtrlConfig {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@GetAdmitCtrlConfig`].
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetAdmitCtrlConfigReply {
        /// Parameters of the axes x, y, z, rx, ry, rz. `admitConfig` on the wire.
        ///
        /// In the document's sample the outer array holds one array, and that one holds the six rows. The document's text describes
        /// one level less.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub axes: wire::Typed<Vec<Vec<AdmittanceAxis>>>,
    }
    /// Switches the torque sensor on or off.
    ///
    /// Sources contradict each other on which value is on, so the value is sent as given: the TCP documents say 0, all other texts 1. The bytes of
    /// the vendor's own client library (SDK 2.1.14) support 1; no capture shows it. Try it with the arm clear of people.
    ///
    /// Sends `set_torque_sensor_mode` (4.65).
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct SetTorqueSensorMode {
        /// Mode, 0 or 1, sent raw because the sources do not agree on the meaning. 0 to 1. `sensor_mode` on the wire.
        ///
        /// Sources contradict each other on the meaning, so the value is passed on as it is:
        ///
        /// - the TCP documents alone, 2.0.4 among them: 0 = on, 1 = off
        /// - bytes of the vendor's SDK 2.1.14, its header (SDK 2.2.2), and all others: 1 = on, 0 = off
        pub mode: i64,
    }
    impl SetTorqueSensorMode {
        /// With the required fields alone.
        ///
        /// - `mode`: 0 to 1
        pub const fn new(mode: i64) -> Self {}
    }
    /// Moves the arm to a joint position to identify the payload at the end of the tool.
    ///
    /// This is a motion, and the document does not say how fast it is. [`get_torq_sensor_identify_status`](type@GetTorqSensorIdentifyStatus) says when the
    /// identification is done, and [`get_torq_sensor_payload_identify_result`](type@GetTorqSensorPayloadIdentifyResult) reads what was found.
    ///
    /// Sends `start_torq_sensor_payload_identify` (4.66). The robot must be powered, enabled and outside servo mode.
    ///
    /// # Errata
    ///
    /// - The document's text also spells the key `jointposition`; its sample sends `jointPosition`.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct StartTorqSensorPayloadIdentify {
        /// Joint position at which the identification ends. In deg. `jointPosition` on the wire.
        ///
        /// The document recommends turning joints 4, 5 and 6 by 90 degrees each, for an accurate result.
        ///
        /// Advised: -360 to 360. Anything else is refused unless that is left to the controller: see [`AdvisoryRanges`](check::AdvisoryRanges).
        pub joint_position: super::types::JointPosition,
    }
    impl StartTorqSensorPayloadIdentify {
        /// With the required fields alone.
        ///
        /// - `joint_position`: in deg
        pub fn new(joint_position: impl Into<super::types::JointPosition>) -> Self {}
    }
    /// Reads how far the identification of the payload is.
    ///
    /// Sends `get_torq_sensor_identify_staus` (4.67). Changes nothing on the robot. The reply is [`GetTorqSensorIdentifyStatusReply`].
    ///
    /// # Errata
    ///
    /// - The wire spells the name `staus`.
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetTorqSensorIdentifyStatus {}
    impl GetTorqSensorIdentifyStatus {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@GetTorqSensorIdentifyStatus`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetTorqSensorIdentifyStatusReply {
        /// Progress of the identification. `identify_status` on the wire.
        pub status: IdentifyStatus,
    }
    /// Reads the payload that the identification found.
    ///
    /// Of use only once [`get_torq_sensor_identify_status`](type@GetTorqSensorIdentifyStatus) says that the identification is done.
    ///
    /// Sends `get_torq_sensor_payload_identify_result` (4.68). Changes nothing on the robot. The reply is [`GetTorqSensorPayloadIdentifyResultReply`].
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetTorqSensorPayloadIdentifyResult {}
    impl GetTorqSensorPayloadIdentifyResult {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@GetTorqSensorPayloadIdentifyResult`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetTorqSensorPayloadIdentifyResultReply {
        /// Centroid of the payload.
        pub centroid: super::payload::Centroid,
        /// Mass of the payload. In kg.
        pub mass: f64,
    }
    /// Sets the mass and the centroid of the payload at the torque sensor.
    ///
    /// This is not the payload of the arm: that is [`set_payload`](crate::messages::payload::SetPayload).
    ///
    /// Sends `set_tool_payload` (4.69).
    ///
    /// # Errata
    ///
    /// - The document's worked example prints the `cmdName` [`set_payload`](crate::messages::payload::SetPayload), which is another command (4.42).
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct SetToolPayload {
        /// Mass of the payload. In kg, at least 0.
        pub mass: f64,
        /// Centroid of the payload.
        pub centroid: super::payload::Centroid,
    }
    impl SetToolPayload {
        /// With the required fields alone.
        ///
        /// - `mass`: in kg, at least 0
        pub fn new(mass: f64, centroid: impl Into<super::payload::Centroid>) -> Self {}
    }
    /// Reads the mass and the centroid of the payload at the torque sensor.
    ///
    /// This is not the payload of the arm: that is [`get_payload`](crate::messages::payload::GetPayload).
    ///
    /// Sends `get_tool_payload` (4.70). Changes nothing on the robot. The reply is [`GetToolPayloadReply`].
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetToolPayload {}
    impl GetToolPayload {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@GetToolPayload`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetToolPayloadReply {
        /// Centroid of the payload.
        pub centroid: super::payload::Centroid,
        /// Mass of the payload. In kg.
        pub mass: f64,
    }
    /// Sets the forces and torques that are the condition for compliant control.
    ///
    /// The document does not say what happens when they are reached.
    ///
    /// Sends `set_compliance_condition` (4.71).
    ///
    /// # Errata
    ///
    /// - The heading speaks of a torque condition, the text of force components and torque components.
    /// - The text names only `fx` and `tx` of the six values, and prints no order and no unit.
    /// - The sample sends zeros, while the values are to be greater than 0 (vendor's texts).
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct SetComplianceCondition {
        /// Force along, and torque about, each of the axes x, y and z, at the force sensor. In N for the forces, Nm for the torques, at least 0. `compliant_condition` on the wire.
        ///
        /// The order is fx, fy, fz, tx, ty, tz, and each is greater than 0 (vendor's texts).
        pub condition: [f64; 6],
    }
    impl SetComplianceCondition {
        /// With the required fields alone.
        ///
        /// - `condition`: in N for the forces, Nm for the torques, at least 0
        pub const fn new(condition: [f64; 6]) -> Self {}
    }
    /// Switches admittance control on or off.
    ///
    /// While it is on, the arm may move with the forces that its sensor reads. [`set_admit_ctrl_config`](type@SetAdmitCtrlConfig) sets the axes.
    ///
    /// Sends `enable_admittance_ctrl` (4.72).
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct EnableAdmittanceCtrl {
        /// Whether admittance control is on.
        pub enable_flag: super::types::Switch,
    }
    impl EnableAdmittanceCtrl {
        /// With the required fields alone.
        pub const fn new(enable_flag: super::types::Switch) -> Self {}
    }
    /// Reads the type of force control, and whether the sensor is compensated.
    ///
    /// Sends `get_compliant_type` (4.73). Changes nothing on the robot. The reply is [`GetCompliantTypeReply`].
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetCompliantType {}
    impl GetCompliantType {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@GetCompliantType`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetCompliantTypeReply {
        /// Type of force control.
        pub compliance_type: ComplianceType,
        /// Whether sensor compensation is on, which initialises the sensor.
        pub sensor_compensation: bool,
    }
    /// Sets the type of force control, and whether the sensor is compensated.
    ///
    /// Sends `set_compliant_type` (4.74).
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct SetCompliantType {
        /// Whether sensor compensation is on, which initialises the sensor.
        pub sensor_compensation: super::types::Switch,
        /// Type of force control.
        pub compliance_type: ComplianceType,
    }
    impl SetCompliantType {
        /// With the required fields alone.
        pub const fn new(
            sensor_compensation: super::types::Switch,
            compliance_type: ComplianceType,
        ) -> Self {}
    }
    /// Sets how the controller reaches the torque sensor.
    ///
    /// The document does not say what to send as address and port for RS485.
    ///
    /// Sends `set_torque_sensor_comm` (4.76).
    ///
    /// # Errata
    ///
    /// - The document's heading speaks of the IP address alone; the command sets the type and the port too.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct SetTorqueSensorComm {
        /// Protocol to reach the sensor by. `type` on the wire.
        pub communication: TorqueSensorCommunication,
        /// IP address of the sensor. `ip_addr` on the wire.
        pub address: String,
        /// Port of the sensor, for TCP/IP. 0 to 65535.
        pub port: i64,
    }
    impl SetTorqueSensorComm {
        /// With the required fields alone.
        ///
        /// - `port`: 0 to 65535
        pub fn new(
            communication: TorqueSensorCommunication,
            address: impl Into<String>,
            port: i64,
        ) -> Self {}
    }
    /// Reads how the controller reaches the torque sensor.
    ///
    /// Sends `get_torque_sensor_comm` (4.77). Changes nothing on the robot. The reply is [`GetTorqueSensorCommReply`].
    ///
    /// # Errata
    ///
    /// - The document's heading speaks of the IP address alone; the reply holds the type and the port too.
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetTorqueSensorComm {}
    impl GetTorqueSensorComm {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@GetTorqueSensorComm`].
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetTorqueSensorCommReply {
        /// IP address of the sensor. `ip_addr` on the wire.
        pub address: String,
        /// Protocol by which the sensor is reached. `type` on the wire.
        pub communication: TorqueSensorCommunication,
        /// Port of the sensor, for TCP/IP.
        pub port: i64,
    }
    /// Switches force control off.
    ///
    /// The document's heading calls it torque control. It does not say whether drag mode ends too.
    ///
    /// Sends `disable_force_control` (4.78).
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct DisableForceControl {}
    impl DisableForceControl {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// Sets the parameters of compliance in velocity.
    ///
    /// Sends `set_vel_compliant_ctrl` (4.79).
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct SetVelCompliantCtrl {
        /// Level and ratios. `compliant_ctrl` on the wire.
        pub compliance: VelocityCompliance,
    }
    impl SetVelCompliantCtrl {
        /// With the required fields alone.
        pub const fn new(compliance: VelocityCompliance) -> Self {}
    }
    /// Brand of a torque sensor. The document names three; newer firmware has 4 to 6 and 10 as well (field notes).
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum TorqueSensorBrand {
        /// Sony. `1` on the wire.
        Sony,
        /// Bosch Sensortec. `2` on the wire.
        BoschSensortec,
        /// STMicroelectronics. `3` on the wire.
        StMicroelectronics,
        /// A brand that no source names. Taken by newer firmware only. `4` on the wire.
        Brand4,
        /// A brand that no source names. Taken by newer firmware only. `5` on the wire.
        Brand5,
        /// A brand that no source names. Taken by newer firmware only. `6` on the wire.
        Brand6,
        /// A brand that no source names. Taken by newer firmware only. `10` on the wire.
        Brand10,
        /// A value that the spec does not list.
        Other(i64),
    }
    impl From<i64> for TorqueSensorBrand {}
    impl From<TorqueSensorBrand> for i64 {}
    /// The value in words; one that the spec does not list as its number.
    impl ::core::fmt::Display for TorqueSensorBrand {}
    /// An axis to move along or about.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum CartesianAxis {
        /// Along x. `0` on the wire.
        X,
        /// Along y. `1` on the wire.
        Y,
        /// Along z. `2` on the wire.
        Z,
        /// About x. `3` on the wire.
        Rx,
        /// About y. `4` on the wire.
        Ry,
        /// About z. `5` on the wire.
        Rz,
        /// A value that the spec does not list.
        Other(i64),
    }
    impl From<i64> for CartesianAxis {}
    impl From<CartesianAxis> for i64 {}
    /// The value in words; one that the spec does not list as its number.
    impl ::core::fmt::Display for CartesianAxis {}
    /// Parameters of admittance control for one axis.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct AdmittanceAxis {
        /// Whether the axis is on.
        pub enabled: bool,
        /// Damping: the force with which a user moves the arm along the axis at its greatest speed. Unit not stated.
        pub user_force: f64,
        /// Rebound: how strongly the arm returns to its initial state. Unit not stated.
        pub rebound: f64,
        /// Constant force. Unit not stated.
        pub constant_force: f64,
        /// Normal tracking. The document does not say which values there are.
        pub normal_track: i64,
    }
    /// Progress of the identification of a payload.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum IdentifyStatus {
        /// The identification is done. `0` on the wire.
        Done,
        /// The identification is not done. `1` on the wire.
        NotDone,
        /// The identification failed. `2` on the wire.
        Failed,
        /// A value that the spec does not list.
        Other(i64),
    }
    impl From<i64> for IdentifyStatus {}
    impl From<IdentifyStatus> for i64 {}
    /// The value in words; one that the spec does not list as its number.
    impl ::core::fmt::Display for IdentifyStatus {}
    /// Type of force control.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum ComplianceType {
        /// No compliant control. `0` on the wire.
        Off,
        /// Compliance at constant force. `1` on the wire.
        ConstantForce,
        /// Compliance in velocity. `2` on the wire.
        Velocity,
        /// A value that the spec does not list.
        Other(i64),
    }
    impl From<i64> for ComplianceType {}
    impl From<ComplianceType> for i64 {}
    /// The value in words; one that the spec does not list as its number.
    impl ::core::fmt::Display for ComplianceType {}
    /// Connection of the controller to the torque sensor.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum TorqueSensorCommunication {
        /// By TCP/IP. `0` on the wire.
        TcpIp,
        /// By RS485. `1` on the wire.
        Rs485,
        /// A value that the spec does not list.
        Other(i64),
    }
    impl From<i64> for TorqueSensorCommunication {}
    impl From<TorqueSensorCommunication> for i64 {}
    /// The value in words; one that the spec does not list as its number.
    impl ::core::fmt::Display for TorqueSensorCommunication {}
    /// Parameters of compliance in velocity.
    ///
    /// The level says how often the arm slows down, and the ratios belong to these steps; what a ratio scales is not said. Level 1 uses two ratios, level 2 three, level 3 four, and the
    /// rest are 0. Those in use become smaller: 1 > rate1 > rate2 > rate3 > rate4 > 0 (vendor's texts). The document gives neither ranges nor
    /// rules.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct VelocityCompliance {
        /// Level of the compliance, `vc_level` in the document. 1 to 3.
        pub level: i64,
        /// First ratio. 0 to 1.
        pub rate1: f64,
        /// Second ratio. 0 to 1.
        pub rate2: f64,
        /// Third ratio, or 0 with level 1. 0 to 1.
        pub rate3: f64,
        /// Fourth ratio, or 0 with levels 1 and 2. 0 to 1.
        pub rate4: f64,
    }
    impl VelocityCompliance {
        /// With the required fields alone.
        ///
        /// - `level`: 1 to 3
        /// - `rate1`: 0 to 1
        /// - `rate2`: 0 to 1
        /// - `rate3`: 0 to 1
        /// - `rate4`: 0 to 1
        pub const fn new(
            level: i64,
            rate1: f64,
            rate2: f64,
            rate3: f64,
            rate4: f64,
        ) -> Self {}
    }
}
