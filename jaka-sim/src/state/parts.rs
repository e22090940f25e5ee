//! Parts of the state.

use jaka_proto::messages::force::{
    AdmittanceAxis, ComplianceType, GetToolPayloadReply, GetTorqSensorPayloadIdentifyResultReply, IdentifyStatus,
    TorqueSensorCommunication,
};
use jaka_proto::messages::types::Pose;

/// Tool frame or user frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Frame {
    /// Offset of the frame.
    pub offset: Pose,
    /// Name of the frame.
    pub name: String,
}

/// Trajectory recording.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Trajectory {
    /// Whether recording is on.
    pub sampling: bool,
    /// Names of the trajectory files.
    pub file_names: Vec<String>,
}

/// Torque sensor at the end of the arm.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct TorqueSensor {
    /// Whether the sensor works. No command sets it, since sources contradict each other on the mode that is on.
    pub working: bool,
    /// Contact force of a working sensor, as in packets: along the axes of the tool frame in use, in N and Nm. The
    /// document does not define the axes and units. A [`Contact`](crate::Contact) sets it; without one it keeps its
    /// value.
    pub contact_force: [f64; 6],
    /// Connection to the sensor.
    pub communication: TorqueSensorCommunication,
    /// IP address of the sensor.
    pub address: String,
    /// Port of the sensor.
    pub port: i64,
    /// Payload at the sensor.
    pub payload: GetToolPayloadReply,
    /// Progress of the identification of the payload.
    pub identify_status: IdentifyStatus,
    /// Result of the identification, past or future.
    pub identified: GetTorqSensorPayloadIdentifyResultReply,
}

/// Force-compliant control.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct AdmittanceControl {
    /// Whether admittance control is on.
    pub enabled: bool,
    /// Parameters of the axes x, y, z, rx, ry, rz.
    pub axes: [AdmittanceAxis; 6],
    /// Type of force control.
    pub compliance_type: ComplianceType,
    /// Whether sensor compensation is on.
    pub sensor_compensation: bool,
}
