//! Initial state of a controller: that of the document's example replies, if it prints them.

use std::collections::{BTreeMap, HashMap};
use std::{array, io};

use jaka_motion::Model;
use jaka_proto::messages::types::Pose;
use jaka_proto::messages::{
    collision, force, frames, io as pins, kinematics, payload, power, program, servo, trajectory, variables,
};
use jaka_proto::wire::Typed;

use super::{AdmittanceControl, FRAMES, Frame, NO_ERROR, State, TorqueSensor, Trajectory};
use crate::spec_index::SpecIndex;

/// Initial joint positions: the arm is bent, its flange points down, and no joint is near its end.
const HOME: [f64; 6] = [0.0, 90.0, 90.0, 90.0, -90.0, 0.0];

impl State {
    /// Returns the initial state of a controller.
    pub(crate) fn initial(spec_index: &SpecIndex, model: &Model) -> io::Result<Self> {
        let power = spec_index.example::<power::GetRobotState>()?;
        let program = spec_index.example::<program::GetLoadedProgram>()?;
        let tools = spec_index.example::<frames::GetToolOffsets>()?;
        let users = spec_index.example::<frames::GetUserOffsets>()?;
        let mut state = Self {
            powered: power.powered_on,
            enabled: power.enabled,
            protective_stop: spec_index.example::<collision::ProtectiveStopStatus>()?.protective_stop,
            emergency_stop: false,
            on_soft_limit: 0,
            error_code: NO_ERROR.to_owned(),
            error_message: String::new(),
            // The firmware sets the version and the inputs.
            version: String::new(),
            joint_position: HOME.into(),
            // The pose follows from the joints.
            tcp_pose: [0.0; 6].into(),
            tcp_speed: 0.0,
            in_position: true,
            at_rest: true,
            joint_commanded_position: HOME.into(),
            tcp_commanded_pose: [0.0; 6].into(),
            servo_mode: spec_index.example::<servo::IsInServomove>()?.in_servo_mode,
            servo_filter: servo::SetServoMoveFilter::disabled(),
            drag_mode: spec_index.example::<force::DragStatus>()?.drag_status,
            dh_parameters: dh_parameters(spec_index, model)?,
            rapid_rate: 1.0,
            loaded_program: program.program_name,
            program_state: spec_index.example::<program::GetProgramState>()?.program_state,
            digital_inputs: Vec::new(),
            digital_outputs: HashMap::new(),
            analog_inputs: Vec::new(),
            analog_outputs: HashMap::new(),
            tool_digital_inputs: Vec::new(),
            tool_analog_inputs: Vec::new(),
            function_inputs: spec_index.example::<pins::GetFuncdiStatus>()?.function_inputs,
            extio: spec_index.example::<pins::GetExtioStatus>()?.extio_status,
            tool_frames: frames(&tools.offsets),
            tool_frame_id: 0,
            user_frames: frames(&users.offsets),
            user_frame_id: 0,
            variables: spec_index.example::<variables::QueryUserDefinedVariable>()?.variables,
            payload: spec_index.example::<payload::GetPayload>()?,
            collision_level: spec_index.example::<collision::GetClsnSensitivity>()?.level,
            trajectory: trajectory(spec_index)?,
            torque_sensor: torque_sensor(spec_index)?,
            admittance: admittance(spec_index)?,
            remembered: BTreeMap::new(),
        };
        // The document's replies have servo mode on, and the arm without power.
        state.make_consistent();
        Ok(state)
    }
}

fn dh_parameters(spec_index: &SpecIndex, model: &Model) -> io::Result<kinematics::GetDhParamReply> {
    let mut reply = spec_index.example::<kinematics::GetDhParam>()?;
    (reply.alpha, reply.a, reply.d) = (*model.alpha(), *model.a(), *model.d());
    reply.joint_home_offset = *model.joint_home_offset();
    Ok(reply)
}

fn trajectory(spec_index: &SpecIndex) -> io::Result<Trajectory> {
    Ok(Trajectory {
        sampling: spec_index.example::<trajectory::GetTrajSampleStatus>()?.sampling,
        file_names: spec_index.example::<trajectory::GetExistTrajFileName>()?.file_names,
    })
}

fn torque_sensor(spec_index: &SpecIndex) -> io::Result<TorqueSensor> {
    let comm = spec_index.example::<force::GetTorqueSensorComm>()?;
    Ok(TorqueSensor {
        working: false,
        contact_force: [0.0; 6],
        communication: comm.communication,
        address: comm.address,
        port: comm.port,
        payload: spec_index.example::<force::GetToolPayload>()?,
        identify_status: spec_index.example::<force::GetTorqSensorIdentifyStatus>()?.status,
        identified: spec_index.example::<force::GetTorqSensorPayloadIdentifyResult>()?,
    })
}

fn admittance(spec_index: &SpecIndex) -> io::Result<AdmittanceControl> {
    let kind = spec_index.example::<force::GetCompliantType>()?;
    let axes = match spec_index.example::<force::GetAdmitCtrlConfig>()?.axes {
        Typed::Known(axes) => axes.concat(),
        Typed::Raw(_) => Vec::new(),
    };
    Ok(AdmittanceControl {
        enabled: false,
        axes: axes.try_into().map_err(|_| io::Error::other("the spec's admittance control does not have six axes"))?,
        compliance_type: kind.compliance_type,
        sensor_compensation: kind.sensor_compensation,
    })
}

fn frames(offsets: &[Pose]) -> [Frame; FRAMES] {
    array::from_fn(|id| Frame { offset: offsets.get(id).copied().unwrap_or([0.0; 6].into()), name: String::new() })
}
