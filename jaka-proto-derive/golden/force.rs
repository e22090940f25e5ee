pub mod force {
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Setting, requires:[Requirement::Powered, Requirement::Enabled]
    pub struct SetTorqueControl {
        pub enable_flag: super::types::Switch,
    }
    impl SetTorqueControl {
        pub const fn new(enable_flag: super::types::Switch) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query
    pub struct DragStatus {}
    impl DragStatus {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct DragStatusReply {
        pub drag_status: bool,
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Setting
    pub struct SetTorqueSensorBrand {
        pub brand: TorqueSensorBrand,
    }
    impl SetTorqueSensorBrand {
        pub const fn new(brand: TorqueSensorBrand) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query
    pub struct GetTorqueSensorBrand {}
    impl GetTorqueSensorBrand {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetTorqueSensorBrandReply {
        pub brand: TorqueSensorBrand,
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Setting
    pub struct SetAdmitCtrlConfig {
        pub axis: CartesianAxis,
        pub enabled: super::types::Switch,
        pub user_force: f64,
        pub constant_force: f64,
        pub normal_track: i64,
        pub rebound: f64,
    }
    impl SetAdmitCtrlConfig {
        pub const fn new(
            axis: CartesianAxis,
            enabled: super::types::Switch,
            user_force: f64,
            constant_force: f64,
            normal_track: i64,
            rebound: f64,
        ) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query
    pub struct GetAdmitCtrlConfig {}
    impl GetAdmitCtrlConfig {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetAdmitCtrlConfigReply {
        pub axes: wire::Typed<Vec<Vec<AdmittanceAxis>>>,
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Setting
    pub struct SetTorqueSensorMode {
        // min 0, max 1
        pub mode: i64,
    }
    impl SetTorqueSensorMode {
        pub const fn new(mode: i64) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Motion, role: Some(Role::Start), is_motion: true, requires:[Requirement::Powered, Requirement::Enabled, Requirement::NotServoMode], deadline: Some(Duration::from_millis(60000u64))
    pub struct StartTorqSensorPayloadIdentify {
        // advised Advised::to([Advice{max: 360, nonzero: false, unit: ""}])
        pub joint_position: super::types::JointPosition,
    }
    impl StartTorqSensorPayloadIdentify {
        pub fn new(joint_position: impl Into<super::types::JointPosition>) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query
    pub struct GetTorqSensorIdentifyStatus {}
    impl GetTorqSensorIdentifyStatus {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetTorqSensorIdentifyStatusReply {
        pub status: IdentifyStatus,
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query
    pub struct GetTorqSensorPayloadIdentifyResult {}
    impl GetTorqSensorPayloadIdentifyResult {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetTorqSensorPayloadIdentifyResultReply {
        pub centroid: super::payload::Centroid,
        pub mass: f64,
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Setting, changes:[Change::Payload]
    pub struct SetToolPayload {
        // min 0, unit "kg"
        pub mass: f64,
        pub centroid: super::payload::Centroid,
    }
    impl SetToolPayload {
        pub fn new(mass: f64, centroid: impl Into<super::payload::Centroid>) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query
    pub struct GetToolPayload {}
    impl GetToolPayload {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetToolPayloadReply {
        pub centroid: super::payload::Centroid,
        pub mass: f64,
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Setting
    pub struct SetComplianceCondition {
        // min 0, unit "N for the forces, Nm for the torques"
        pub condition: [f64; 6],
    }
    impl SetComplianceCondition {
        pub const fn new(condition: [f64; 6]) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Setting
    pub struct EnableAdmittanceCtrl {
        pub enable_flag: super::types::Switch,
    }
    impl EnableAdmittanceCtrl {
        pub const fn new(enable_flag: super::types::Switch) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query
    pub struct GetCompliantType {}
    impl GetCompliantType {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetCompliantTypeReply {
        pub compliance_type: ComplianceType,
        pub sensor_compensation: bool,
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Setting
    pub struct SetCompliantType {
        pub sensor_compensation: super::types::Switch,
        pub compliance_type: ComplianceType,
    }
    impl SetCompliantType {
        pub const fn new(
            sensor_compensation: super::types::Switch,
            compliance_type: ComplianceType,
        ) -> Self {}
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    // Setting
    pub struct SetTorqueSensorComm {
        pub communication: TorqueSensorCommunication,
        pub address: String,
        // min 0, max 65535
        pub port: i64,
    }
    impl SetTorqueSensorComm {
        pub fn new(
            communication: TorqueSensorCommunication,
            address: impl Into<String>,
            port: i64,
        ) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query
    pub struct GetTorqueSensorComm {}
    impl GetTorqueSensorComm {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetTorqueSensorCommReply {
        pub address: String,
        pub communication: TorqueSensorCommunication,
        pub port: i64,
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Setting
    pub struct DisableForceControl {}
    impl DisableForceControl {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Setting
    pub struct SetVelCompliantCtrl {
        pub compliance: VelocityCompliance,
    }
    impl SetVelCompliantCtrl {
        pub const fn new(compliance: VelocityCompliance) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum TorqueSensorBrand {
        Sony,
        BoschSensortec,
        StMicroelectronics,
        Brand4,
        Brand5,
        Brand6,
        Brand10,
        Other(i64),
    }
    impl From<i64> for TorqueSensorBrand {}
    impl From<TorqueSensorBrand> for i64 {}
    impl ::core::fmt::Display for TorqueSensorBrand {}
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum CartesianAxis {
        X,
        Y,
        Z,
        Rx,
        Ry,
        Rz,
        Other(i64),
    }
    impl From<i64> for CartesianAxis {}
    impl From<CartesianAxis> for i64 {}
    impl ::core::fmt::Display for CartesianAxis {}
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct AdmittanceAxis {
        pub enabled: bool,
        pub user_force: f64,
        pub rebound: f64,
        pub constant_force: f64,
        pub normal_track: i64,
    }
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum IdentifyStatus {
        Done,
        NotDone,
        Failed,
        Other(i64),
    }
    impl From<i64> for IdentifyStatus {}
    impl From<IdentifyStatus> for i64 {}
    impl ::core::fmt::Display for IdentifyStatus {}
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum ComplianceType {
        Off,
        ConstantForce,
        Velocity,
        Other(i64),
    }
    impl From<i64> for ComplianceType {}
    impl From<ComplianceType> for i64 {}
    impl ::core::fmt::Display for ComplianceType {}
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum TorqueSensorCommunication {
        TcpIp,
        Rs485,
        Other(i64),
    }
    impl From<i64> for TorqueSensorCommunication {}
    impl From<TorqueSensorCommunication> for i64 {}
    impl ::core::fmt::Display for TorqueSensorCommunication {}
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct VelocityCompliance {
        // min 1, max 3
        pub level: i64,
        // min 0, max 1
        pub rate1: f64,
        // min 0, max 1
        pub rate2: f64,
        // min 0, max 1
        pub rate3: f64,
        // min 0, max 1
        pub rate4: f64,
    }
    impl VelocityCompliance {
        pub const fn new(
            level: i64,
            rate1: f64,
            rate2: f64,
            rate3: f64,
            rate4: f64,
        ) -> Self {}
    }
}
