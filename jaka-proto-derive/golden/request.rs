/// Any request of the spec, told apart by its `cmdName`.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Request {
    /// `power_on`
    PowerOn(power::PowerOn),
    /// `power_off`
    PowerOff(power::PowerOff),
    /// `enable_robot`
    EnableRobot(power::EnableRobot),
    /// `disable_robot`
    DisableRobot(power::DisableRobot),
    /// `shutdown`
    Shutdown(power::Shutdown),
    /// `get_robot_state`
    GetRobotState(power::GetRobotState),
    /// `get_version`
    GetVersion(power::GetVersion),
    /// `jog`
    Jog(motion::Jog),
    /// `joint_move`
    JointMove(motion::JointMove),
    /// `end_move`
    EndMove(motion::EndMove),
    /// `moveL`
    MoveL(motion::MoveL),
    /// `movc`
    MoveC(motion::MoveC),
    /// `wait_complete`
    WaitComplete(motion::WaitComplete),
    /// `is_in_servomove`
    IsInServomove(servo::IsInServomove),
    /// `servo_move`
    ServoMove(servo::ServoMove),
    /// `servo_j`
    ServoJ(servo::ServoJ),
    /// `servo_p`
    ServoP(servo::ServoP),
    /// `set_servo_move_filter`
    SetServoMoveFilter(servo::SetServoMoveFilter),
    /// `rapid_rate`
    RapidRate(program::RapidRate),
    /// `load_program`
    LoadProgram(program::LoadProgram),
    /// `get_loaded_program`
    GetLoadedProgram(program::GetLoadedProgram),
    /// `play_program`
    PlayProgram(program::PlayProgram),
    /// `pause_program`
    PauseProgram(program::PauseProgram),
    /// `resume_program`
    ResumeProgram(program::ResumeProgram),
    /// `stop_program`
    StopProgram(program::StopProgram),
    /// `get_program_state`
    GetProgramState(program::GetProgramState),
    /// `set_digital_output`
    SetDigitalOutput(io::SetDigitalOutput),
    /// `get_digital_input_status`
    GetDigitalInputStatus(io::GetDigitalInputStatus),
    /// `set_analog_output`
    SetAnalogOutput(io::SetAnalogOutput),
    /// `get_extio_status`
    GetExtioStatus(io::GetExtioStatus),
    /// `get_funcdi_status`
    GetFuncdiStatus(io::GetFuncdiStatus),
    /// `set_tio_vout_param`
    SetTioVoutParam(io::SetTioVoutParam),
    /// `get_tio_vout_param`
    GetTioVoutParam(io::GetTioVoutParam),
    /// `set_tool_offsets`
    SetToolOffsets(frames::SetToolOffsets),
    /// `set_tool_id`
    SetToolId(frames::SetToolId),
    /// `get_tool_offsets`
    GetToolOffsets(frames::GetToolOffsets),
    /// `set_user_offsets`
    SetUserOffsets(frames::SetUserOffsets),
    /// `set_user_id`
    SetUserId(frames::SetUserId),
    /// `get_user_offsets`
    GetUserOffsets(frames::GetUserOffsets),
    /// `query_user_defined_variable`
    QueryUserDefinedVariable(variables::QueryUserDefinedVariable),
    /// `modify_user_defined_variable`
    ModifyUserDefinedVariable(variables::ModifyUserDefinedVariable),
    /// `set_payload`
    SetPayload(payload::SetPayload),
    /// `get_payload`
    GetPayload(payload::GetPayload),
    /// `protective_stop_status`
    ProtectiveStopStatus(collision::ProtectiveStopStatus),
    /// `set_clsn_sensitivity`
    SetClsnSensitivity(collision::SetClsnSensitivity),
    /// `get_clsn_sensitivity`
    GetClsnSensitivity(collision::GetClsnSensitivity),
    /// `clear_error`
    ClearError(collision::ClearError),
    /// `kine_forward`
    KineForward(kinematics::KineForward),
    /// `kine_inverse`
    KineInverse(kinematics::KineInverse),
    /// `get_joint_pos`
    GetJointPos(kinematics::GetJointPos),
    /// `get_tcp_pos`
    GetTcpPos(kinematics::GetTcpPos),
    /// `get_dh_param`
    GetDhParam(kinematics::GetDhParam),
    /// `set_traj_config`
    SetTrajConfig(trajectory::SetTrajConfig),
    /// `get_traj_config`
    GetTrajConfig(trajectory::GetTrajConfig),
    /// `set_traj_sample_mode`
    SetTrajSampleMode(trajectory::SetTrajSampleMode),
    /// `get_traj_sample_status`
    GetTrajSampleStatus(trajectory::GetTrajSampleStatus),
    /// `get_exist_traj_file_name`
    GetExistTrajFileName(trajectory::GetExistTrajFileName),
    /// `rename_traj_file_name`
    RenameTrajFileName(trajectory::RenameTrajFileName),
    /// `remove_traj_file`
    RemoveTrajFile(trajectory::RemoveTrajFile),
    /// `generate_traj_exe_file`
    GenerateTrajExeFile(trajectory::GenerateTrajExeFile),
    /// `torque_control_enable`
    TorqueControlEnable(force::TorqueControlEnable),
    /// `drag_status`
    DragStatus(force::DragStatus),
    /// `set_torsenosr_brand`
    SetTorqueSensorBrand(force::SetTorqueSensorBrand),
    /// `get_torsenosr_brand`
    GetTorqueSensorBrand(force::GetTorqueSensorBrand),
    /// `set_admit_ctrl_config`
    SetAdmitCtrlConfig(force::SetAdmitCtrlConfig),
    /// `get_admit_ctrl_config`
    GetAdmitCtrlConfig(force::GetAdmitCtrlConfig),
    /// `set_torque_sensor_mode`
    SetTorqueSensorMode(force::SetTorqueSensorMode),
    /// `start_torq_sensor_payload_identify`
    StartTorqSensorPayloadIdentify(force::StartTorqSensorPayloadIdentify),
    /// `get_torq_sensor_identify_staus`
    GetTorqSensorIdentifyStatus(force::GetTorqSensorIdentifyStatus),
    /// `get_torq_sensor_payload_identify_result`
    GetTorqSensorPayloadIdentifyResult(force::GetTorqSensorPayloadIdentifyResult),
    /// `set_tool_payload`
    SetToolPayload(force::SetToolPayload),
    /// `get_tool_payload`
    GetToolPayload(force::GetToolPayload),
    /// `set_compliance_condition`
    SetComplianceCondition(force::SetComplianceCondition),
    /// `enable_admittance_ctrl`
    EnableAdmittanceCtrl(force::EnableAdmittanceCtrl),
    /// `get_compliant_type`
    GetCompliantType(force::GetCompliantType),
    /// `set_compliant_type`
    SetCompliantType(force::SetCompliantType),
    /// `set_torque_sensor_comm`
    SetTorqueSensorComm(force::SetTorqueSensorComm),
    /// `get_torque_sensor_comm`
    GetTorqueSensorComm(force::GetTorqueSensorComm),
    /// `disable_force_control`
    DisableForceControl(force::DisableForceControl),
    /// `set_vel_compliant_ctrl`
    SetVelCompliantCtrl(force::SetVelCompliantCtrl),
    /// `set_network_exception_handle`
    SetNetworkExceptionHandle(network::SetNetworkExceptionHandle),
    /// `quit`
    Quit(session::Quit),
}
impl Request {
    /// What the spec says about each command, topic by topic.
    pub const COMMANDS: &'static [&'static ::jaka_proto::CommandInfo] = &[
        <power::PowerOn as ::jaka_proto::Command>::INFO,
        <power::PowerOff as ::jaka_proto::Command>::INFO,
        <power::EnableRobot as ::jaka_proto::Command>::INFO,
        <power::DisableRobot as ::jaka_proto::Command>::INFO,
        <power::Shutdown as ::jaka_proto::Command>::INFO,
        <power::GetRobotState as ::jaka_proto::Command>::INFO,
        <power::GetVersion as ::jaka_proto::Command>::INFO,
        <motion::Jog as ::jaka_proto::Command>::INFO,
        <motion::JointMove as ::jaka_proto::Command>::INFO,
        <motion::EndMove as ::jaka_proto::Command>::INFO,
        <motion::MoveL as ::jaka_proto::Command>::INFO,
        <motion::MoveC as ::jaka_proto::Command>::INFO,
        <motion::WaitComplete as ::jaka_proto::Command>::INFO,
        <servo::IsInServomove as ::jaka_proto::Command>::INFO,
        <servo::ServoMove as ::jaka_proto::Command>::INFO,
        <servo::ServoJ as ::jaka_proto::Command>::INFO,
        <servo::ServoP as ::jaka_proto::Command>::INFO,
        <servo::SetServoMoveFilter as ::jaka_proto::Command>::INFO,
        <program::RapidRate as ::jaka_proto::Command>::INFO,
        <program::LoadProgram as ::jaka_proto::Command>::INFO,
        <program::GetLoadedProgram as ::jaka_proto::Command>::INFO,
        <program::PlayProgram as ::jaka_proto::Command>::INFO,
        <program::PauseProgram as ::jaka_proto::Command>::INFO,
        <program::ResumeProgram as ::jaka_proto::Command>::INFO,
        <program::StopProgram as ::jaka_proto::Command>::INFO,
        <program::GetProgramState as ::jaka_proto::Command>::INFO,
        <io::SetDigitalOutput as ::jaka_proto::Command>::INFO,
        <io::GetDigitalInputStatus as ::jaka_proto::Command>::INFO,
        <io::SetAnalogOutput as ::jaka_proto::Command>::INFO,
        <io::GetExtioStatus as ::jaka_proto::Command>::INFO,
        <io::GetFuncdiStatus as ::jaka_proto::Command>::INFO,
        <io::SetTioVoutParam as ::jaka_proto::Command>::INFO,
        <io::GetTioVoutParam as ::jaka_proto::Command>::INFO,
        <frames::SetToolOffsets as ::jaka_proto::Command>::INFO,
        <frames::SetToolId as ::jaka_proto::Command>::INFO,
        <frames::GetToolOffsets as ::jaka_proto::Command>::INFO,
        <frames::SetUserOffsets as ::jaka_proto::Command>::INFO,
        <frames::SetUserId as ::jaka_proto::Command>::INFO,
        <frames::GetUserOffsets as ::jaka_proto::Command>::INFO,
        <variables::QueryUserDefinedVariable as ::jaka_proto::Command>::INFO,
        <variables::ModifyUserDefinedVariable as ::jaka_proto::Command>::INFO,
        <payload::SetPayload as ::jaka_proto::Command>::INFO,
        <payload::GetPayload as ::jaka_proto::Command>::INFO,
        <collision::ProtectiveStopStatus as ::jaka_proto::Command>::INFO,
        <collision::SetClsnSensitivity as ::jaka_proto::Command>::INFO,
        <collision::GetClsnSensitivity as ::jaka_proto::Command>::INFO,
        <collision::ClearError as ::jaka_proto::Command>::INFO,
        <kinematics::KineForward as ::jaka_proto::Command>::INFO,
        <kinematics::KineInverse as ::jaka_proto::Command>::INFO,
        <kinematics::GetJointPos as ::jaka_proto::Command>::INFO,
        <kinematics::GetTcpPos as ::jaka_proto::Command>::INFO,
        <kinematics::GetDhParam as ::jaka_proto::Command>::INFO,
        <trajectory::SetTrajConfig as ::jaka_proto::Command>::INFO,
        <trajectory::GetTrajConfig as ::jaka_proto::Command>::INFO,
        <trajectory::SetTrajSampleMode as ::jaka_proto::Command>::INFO,
        <trajectory::GetTrajSampleStatus as ::jaka_proto::Command>::INFO,
        <trajectory::GetExistTrajFileName as ::jaka_proto::Command>::INFO,
        <trajectory::RenameTrajFileName as ::jaka_proto::Command>::INFO,
        <trajectory::RemoveTrajFile as ::jaka_proto::Command>::INFO,
        <trajectory::GenerateTrajExeFile as ::jaka_proto::Command>::INFO,
        <force::TorqueControlEnable as ::jaka_proto::Command>::INFO,
        <force::DragStatus as ::jaka_proto::Command>::INFO,
        <force::SetTorqueSensorBrand as ::jaka_proto::Command>::INFO,
        <force::GetTorqueSensorBrand as ::jaka_proto::Command>::INFO,
        <force::SetAdmitCtrlConfig as ::jaka_proto::Command>::INFO,
        <force::GetAdmitCtrlConfig as ::jaka_proto::Command>::INFO,
        <force::SetTorqueSensorMode as ::jaka_proto::Command>::INFO,
        <force::StartTorqSensorPayloadIdentify as ::jaka_proto::Command>::INFO,
        <force::GetTorqSensorIdentifyStatus as ::jaka_proto::Command>::INFO,
        <force::GetTorqSensorPayloadIdentifyResult as ::jaka_proto::Command>::INFO,
        <force::SetToolPayload as ::jaka_proto::Command>::INFO,
        <force::GetToolPayload as ::jaka_proto::Command>::INFO,
        <force::SetComplianceCondition as ::jaka_proto::Command>::INFO,
        <force::EnableAdmittanceCtrl as ::jaka_proto::Command>::INFO,
        <force::GetCompliantType as ::jaka_proto::Command>::INFO,
        <force::SetCompliantType as ::jaka_proto::Command>::INFO,
        <force::SetTorqueSensorComm as ::jaka_proto::Command>::INFO,
        <force::GetTorqueSensorComm as ::jaka_proto::Command>::INFO,
        <force::DisableForceControl as ::jaka_proto::Command>::INFO,
        <force::SetVelCompliantCtrl as ::jaka_proto::Command>::INFO,
        <network::SetNetworkExceptionHandle as ::jaka_proto::Command>::INFO,
        <session::Quit as ::jaka_proto::Command>::INFO,
    ];
    /// Does something with the request, whatever its type.
    pub fn visit<V: ::jaka_proto::Visit>(&self, visitor: V) -> V::Output {
        match self {
            Self::PowerOn(request) => visitor.visit(request),
            Self::PowerOff(request) => visitor.visit(request),
            Self::EnableRobot(request) => visitor.visit(request),
            Self::DisableRobot(request) => visitor.visit(request),
            Self::Shutdown(request) => visitor.visit(request),
            Self::GetRobotState(request) => visitor.visit(request),
            Self::GetVersion(request) => visitor.visit(request),
            Self::Jog(request) => visitor.visit(request),
            Self::JointMove(request) => visitor.visit(request),
            Self::EndMove(request) => visitor.visit(request),
            Self::MoveL(request) => visitor.visit(request),
            Self::MoveC(request) => visitor.visit(request),
            Self::WaitComplete(request) => visitor.visit(request),
            Self::IsInServomove(request) => visitor.visit(request),
            Self::ServoMove(request) => visitor.visit(request),
            Self::ServoJ(request) => visitor.visit(request),
            Self::ServoP(request) => visitor.visit(request),
            Self::SetServoMoveFilter(request) => visitor.visit(request),
            Self::RapidRate(request) => visitor.visit(request),
            Self::LoadProgram(request) => visitor.visit(request),
            Self::GetLoadedProgram(request) => visitor.visit(request),
            Self::PlayProgram(request) => visitor.visit(request),
            Self::PauseProgram(request) => visitor.visit(request),
            Self::ResumeProgram(request) => visitor.visit(request),
            Self::StopProgram(request) => visitor.visit(request),
            Self::GetProgramState(request) => visitor.visit(request),
            Self::SetDigitalOutput(request) => visitor.visit(request),
            Self::GetDigitalInputStatus(request) => visitor.visit(request),
            Self::SetAnalogOutput(request) => visitor.visit(request),
            Self::GetExtioStatus(request) => visitor.visit(request),
            Self::GetFuncdiStatus(request) => visitor.visit(request),
            Self::SetTioVoutParam(request) => visitor.visit(request),
            Self::GetTioVoutParam(request) => visitor.visit(request),
            Self::SetToolOffsets(request) => visitor.visit(request),
            Self::SetToolId(request) => visitor.visit(request),
            Self::GetToolOffsets(request) => visitor.visit(request),
            Self::SetUserOffsets(request) => visitor.visit(request),
            Self::SetUserId(request) => visitor.visit(request),
            Self::GetUserOffsets(request) => visitor.visit(request),
            Self::QueryUserDefinedVariable(request) => visitor.visit(request),
            Self::ModifyUserDefinedVariable(request) => visitor.visit(request),
            Self::SetPayload(request) => visitor.visit(request),
            Self::GetPayload(request) => visitor.visit(request),
            Self::ProtectiveStopStatus(request) => visitor.visit(request),
            Self::SetClsnSensitivity(request) => visitor.visit(request),
            Self::GetClsnSensitivity(request) => visitor.visit(request),
            Self::ClearError(request) => visitor.visit(request),
            Self::KineForward(request) => visitor.visit(request),
            Self::KineInverse(request) => visitor.visit(request),
            Self::GetJointPos(request) => visitor.visit(request),
            Self::GetTcpPos(request) => visitor.visit(request),
            Self::GetDhParam(request) => visitor.visit(request),
            Self::SetTrajConfig(request) => visitor.visit(request),
            Self::GetTrajConfig(request) => visitor.visit(request),
            Self::SetTrajSampleMode(request) => visitor.visit(request),
            Self::GetTrajSampleStatus(request) => visitor.visit(request),
            Self::GetExistTrajFileName(request) => visitor.visit(request),
            Self::RenameTrajFileName(request) => visitor.visit(request),
            Self::RemoveTrajFile(request) => visitor.visit(request),
            Self::GenerateTrajExeFile(request) => visitor.visit(request),
            Self::TorqueControlEnable(request) => visitor.visit(request),
            Self::DragStatus(request) => visitor.visit(request),
            Self::SetTorqueSensorBrand(request) => visitor.visit(request),
            Self::GetTorqueSensorBrand(request) => visitor.visit(request),
            Self::SetAdmitCtrlConfig(request) => visitor.visit(request),
            Self::GetAdmitCtrlConfig(request) => visitor.visit(request),
            Self::SetTorqueSensorMode(request) => visitor.visit(request),
            Self::StartTorqSensorPayloadIdentify(request) => visitor.visit(request),
            Self::GetTorqSensorIdentifyStatus(request) => visitor.visit(request),
            Self::GetTorqSensorPayloadIdentifyResult(request) => visitor.visit(request),
            Self::SetToolPayload(request) => visitor.visit(request),
            Self::GetToolPayload(request) => visitor.visit(request),
            Self::SetComplianceCondition(request) => visitor.visit(request),
            Self::EnableAdmittanceCtrl(request) => visitor.visit(request),
            Self::GetCompliantType(request) => visitor.visit(request),
            Self::SetCompliantType(request) => visitor.visit(request),
            Self::SetTorqueSensorComm(request) => visitor.visit(request),
            Self::GetTorqueSensorComm(request) => visitor.visit(request),
            Self::DisableForceControl(request) => visitor.visit(request),
            Self::SetVelCompliantCtrl(request) => visitor.visit(request),
            Self::SetNetworkExceptionHandle(request) => visitor.visit(request),
            Self::Quit(request) => visitor.visit(request),
        }
    }
    /// Reads the request `name` from its JSON; `None` if the spec has no such command.
    pub(crate) fn read_named(
        name: &str,
        reader: &mut ::jaka_proto::wire::Reader<'_>,
    ) -> Option<Result<Self, ::jaka_proto::wire::DecodeError>> {
        Some(
            match name {
                "power_on" => {
                    ::jaka_proto::wire::Fields::read_fields(reader).map(Self::PowerOn)
                }
                "power_off" => {
                    ::jaka_proto::wire::Fields::read_fields(reader).map(Self::PowerOff)
                }
                "enable_robot" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::EnableRobot)
                }
                "disable_robot" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::DisableRobot)
                }
                "shutdown" => {
                    ::jaka_proto::wire::Fields::read_fields(reader).map(Self::Shutdown)
                }
                "get_robot_state" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::GetRobotState)
                }
                "get_version" => {
                    ::jaka_proto::wire::Fields::read_fields(reader).map(Self::GetVersion)
                }
                "jog" => ::jaka_proto::wire::Fields::read_fields(reader).map(Self::Jog),
                "joint_move" => {
                    ::jaka_proto::wire::Fields::read_fields(reader).map(Self::JointMove)
                }
                "end_move" => {
                    ::jaka_proto::wire::Fields::read_fields(reader).map(Self::EndMove)
                }
                "moveL" => {
                    ::jaka_proto::wire::Fields::read_fields(reader).map(Self::MoveL)
                }
                "movc" => {
                    ::jaka_proto::wire::Fields::read_fields(reader).map(Self::MoveC)
                }
                "wait_complete" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::WaitComplete)
                }
                "is_in_servomove" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::IsInServomove)
                }
                "servo_move" => {
                    ::jaka_proto::wire::Fields::read_fields(reader).map(Self::ServoMove)
                }
                "servo_j" => {
                    ::jaka_proto::wire::Fields::read_fields(reader).map(Self::ServoJ)
                }
                "servo_p" => {
                    ::jaka_proto::wire::Fields::read_fields(reader).map(Self::ServoP)
                }
                "set_servo_move_filter" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::SetServoMoveFilter)
                }
                "rapid_rate" => {
                    ::jaka_proto::wire::Fields::read_fields(reader).map(Self::RapidRate)
                }
                "load_program" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::LoadProgram)
                }
                "get_loaded_program" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::GetLoadedProgram)
                }
                "play_program" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::PlayProgram)
                }
                "pause_program" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::PauseProgram)
                }
                "resume_program" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::ResumeProgram)
                }
                "stop_program" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::StopProgram)
                }
                "get_program_state" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::GetProgramState)
                }
                "set_digital_output" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::SetDigitalOutput)
                }
                "get_digital_input_status" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::GetDigitalInputStatus)
                }
                "set_analog_output" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::SetAnalogOutput)
                }
                "get_extio_status" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::GetExtioStatus)
                }
                "get_funcdi_status" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::GetFuncdiStatus)
                }
                "set_tio_vout_param" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::SetTioVoutParam)
                }
                "get_tio_vout_param" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::GetTioVoutParam)
                }
                "set_tool_offsets" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::SetToolOffsets)
                }
                "set_tool_id" => {
                    ::jaka_proto::wire::Fields::read_fields(reader).map(Self::SetToolId)
                }
                "get_tool_offsets" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::GetToolOffsets)
                }
                "set_user_offsets" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::SetUserOffsets)
                }
                "set_user_id" => {
                    ::jaka_proto::wire::Fields::read_fields(reader).map(Self::SetUserId)
                }
                "get_user_offsets" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::GetUserOffsets)
                }
                "query_user_defined_variable" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::QueryUserDefinedVariable)
                }
                "modify_user_defined_variable" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::ModifyUserDefinedVariable)
                }
                "set_payload" => {
                    ::jaka_proto::wire::Fields::read_fields(reader).map(Self::SetPayload)
                }
                "get_payload" => {
                    ::jaka_proto::wire::Fields::read_fields(reader).map(Self::GetPayload)
                }
                "protective_stop_status" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::ProtectiveStopStatus)
                }
                "set_clsn_sensitivity" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::SetClsnSensitivity)
                }
                "get_clsn_sensitivity" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::GetClsnSensitivity)
                }
                "clear_error" => {
                    ::jaka_proto::wire::Fields::read_fields(reader).map(Self::ClearError)
                }
                "kine_forward" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::KineForward)
                }
                "kine_inverse" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::KineInverse)
                }
                "get_joint_pos" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::GetJointPos)
                }
                "get_tcp_pos" => {
                    ::jaka_proto::wire::Fields::read_fields(reader).map(Self::GetTcpPos)
                }
                "get_dh_param" => {
                    ::jaka_proto::wire::Fields::read_fields(reader).map(Self::GetDhParam)
                }
                "set_traj_config" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::SetTrajConfig)
                }
                "get_traj_config" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::GetTrajConfig)
                }
                "set_traj_sample_mode" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::SetTrajSampleMode)
                }
                "get_traj_sample_status" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::GetTrajSampleStatus)
                }
                "get_exist_traj_file_name" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::GetExistTrajFileName)
                }
                "rename_traj_file_name" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::RenameTrajFileName)
                }
                "remove_traj_file" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::RemoveTrajFile)
                }
                "generate_traj_exe_file" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::GenerateTrajExeFile)
                }
                "torque_control_enable" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::TorqueControlEnable)
                }
                "drag_status" => {
                    ::jaka_proto::wire::Fields::read_fields(reader).map(Self::DragStatus)
                }
                "set_torsenosr_brand" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::SetTorqueSensorBrand)
                }
                "get_torsenosr_brand" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::GetTorqueSensorBrand)
                }
                "set_admit_ctrl_config" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::SetAdmitCtrlConfig)
                }
                "get_admit_ctrl_config" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::GetAdmitCtrlConfig)
                }
                "set_torque_sensor_mode" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::SetTorqueSensorMode)
                }
                "start_torq_sensor_payload_identify" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::StartTorqSensorPayloadIdentify)
                }
                "get_torq_sensor_identify_staus" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::GetTorqSensorIdentifyStatus)
                }
                "get_torq_sensor_payload_identify_result" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::GetTorqSensorPayloadIdentifyResult)
                }
                "set_tool_payload" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::SetToolPayload)
                }
                "get_tool_payload" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::GetToolPayload)
                }
                "set_compliance_condition" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::SetComplianceCondition)
                }
                "enable_admittance_ctrl" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::EnableAdmittanceCtrl)
                }
                "get_compliant_type" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::GetCompliantType)
                }
                "set_compliant_type" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::SetCompliantType)
                }
                "set_torque_sensor_comm" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::SetTorqueSensorComm)
                }
                "get_torque_sensor_comm" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::GetTorqueSensorComm)
                }
                "disable_force_control" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::DisableForceControl)
                }
                "set_vel_compliant_ctrl" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::SetVelCompliantCtrl)
                }
                "set_network_exception_handle" => {
                    ::jaka_proto::wire::Fields::read_fields(reader)
                        .map(Self::SetNetworkExceptionHandle)
                }
                "quit" => ::jaka_proto::wire::Fields::read_fields(reader).map(Self::Quit),
                _ => return None,
            },
        )
    }
}
impl From<power::PowerOn> for Request {
    fn from(request: power::PowerOn) -> Self {
        Self::PowerOn(request)
    }
}
impl From<power::PowerOff> for Request {
    fn from(request: power::PowerOff) -> Self {
        Self::PowerOff(request)
    }
}
impl From<power::EnableRobot> for Request {
    fn from(request: power::EnableRobot) -> Self {
        Self::EnableRobot(request)
    }
}
impl From<power::DisableRobot> for Request {
    fn from(request: power::DisableRobot) -> Self {
        Self::DisableRobot(request)
    }
}
impl From<power::Shutdown> for Request {
    fn from(request: power::Shutdown) -> Self {
        Self::Shutdown(request)
    }
}
impl From<power::GetRobotState> for Request {
    fn from(request: power::GetRobotState) -> Self {
        Self::GetRobotState(request)
    }
}
impl From<power::GetVersion> for Request {
    fn from(request: power::GetVersion) -> Self {
        Self::GetVersion(request)
    }
}
impl From<motion::Jog> for Request {
    fn from(request: motion::Jog) -> Self {
        Self::Jog(request)
    }
}
impl From<motion::JointMove> for Request {
    fn from(request: motion::JointMove) -> Self {
        Self::JointMove(request)
    }
}
impl From<motion::EndMove> for Request {
    fn from(request: motion::EndMove) -> Self {
        Self::EndMove(request)
    }
}
impl From<motion::MoveL> for Request {
    fn from(request: motion::MoveL) -> Self {
        Self::MoveL(request)
    }
}
impl From<motion::MoveC> for Request {
    fn from(request: motion::MoveC) -> Self {
        Self::MoveC(request)
    }
}
impl From<motion::WaitComplete> for Request {
    fn from(request: motion::WaitComplete) -> Self {
        Self::WaitComplete(request)
    }
}
impl From<servo::IsInServomove> for Request {
    fn from(request: servo::IsInServomove) -> Self {
        Self::IsInServomove(request)
    }
}
impl From<servo::ServoMove> for Request {
    fn from(request: servo::ServoMove) -> Self {
        Self::ServoMove(request)
    }
}
impl From<servo::ServoJ> for Request {
    fn from(request: servo::ServoJ) -> Self {
        Self::ServoJ(request)
    }
}
impl From<servo::ServoP> for Request {
    fn from(request: servo::ServoP) -> Self {
        Self::ServoP(request)
    }
}
impl From<servo::SetServoMoveFilter> for Request {
    fn from(request: servo::SetServoMoveFilter) -> Self {
        Self::SetServoMoveFilter(request)
    }
}
impl From<program::RapidRate> for Request {
    fn from(request: program::RapidRate) -> Self {
        Self::RapidRate(request)
    }
}
impl From<program::LoadProgram> for Request {
    fn from(request: program::LoadProgram) -> Self {
        Self::LoadProgram(request)
    }
}
impl From<program::GetLoadedProgram> for Request {
    fn from(request: program::GetLoadedProgram) -> Self {
        Self::GetLoadedProgram(request)
    }
}
impl From<program::PlayProgram> for Request {
    fn from(request: program::PlayProgram) -> Self {
        Self::PlayProgram(request)
    }
}
impl From<program::PauseProgram> for Request {
    fn from(request: program::PauseProgram) -> Self {
        Self::PauseProgram(request)
    }
}
impl From<program::ResumeProgram> for Request {
    fn from(request: program::ResumeProgram) -> Self {
        Self::ResumeProgram(request)
    }
}
impl From<program::StopProgram> for Request {
    fn from(request: program::StopProgram) -> Self {
        Self::StopProgram(request)
    }
}
impl From<program::GetProgramState> for Request {
    fn from(request: program::GetProgramState) -> Self {
        Self::GetProgramState(request)
    }
}
impl From<io::SetDigitalOutput> for Request {
    fn from(request: io::SetDigitalOutput) -> Self {
        Self::SetDigitalOutput(request)
    }
}
impl From<io::GetDigitalInputStatus> for Request {
    fn from(request: io::GetDigitalInputStatus) -> Self {
        Self::GetDigitalInputStatus(request)
    }
}
impl From<io::SetAnalogOutput> for Request {
    fn from(request: io::SetAnalogOutput) -> Self {
        Self::SetAnalogOutput(request)
    }
}
impl From<io::GetExtioStatus> for Request {
    fn from(request: io::GetExtioStatus) -> Self {
        Self::GetExtioStatus(request)
    }
}
impl From<io::GetFuncdiStatus> for Request {
    fn from(request: io::GetFuncdiStatus) -> Self {
        Self::GetFuncdiStatus(request)
    }
}
impl From<io::SetTioVoutParam> for Request {
    fn from(request: io::SetTioVoutParam) -> Self {
        Self::SetTioVoutParam(request)
    }
}
impl From<io::GetTioVoutParam> for Request {
    fn from(request: io::GetTioVoutParam) -> Self {
        Self::GetTioVoutParam(request)
    }
}
impl From<frames::SetToolOffsets> for Request {
    fn from(request: frames::SetToolOffsets) -> Self {
        Self::SetToolOffsets(request)
    }
}
impl From<frames::SetToolId> for Request {
    fn from(request: frames::SetToolId) -> Self {
        Self::SetToolId(request)
    }
}
impl From<frames::GetToolOffsets> for Request {
    fn from(request: frames::GetToolOffsets) -> Self {
        Self::GetToolOffsets(request)
    }
}
impl From<frames::SetUserOffsets> for Request {
    fn from(request: frames::SetUserOffsets) -> Self {
        Self::SetUserOffsets(request)
    }
}
impl From<frames::SetUserId> for Request {
    fn from(request: frames::SetUserId) -> Self {
        Self::SetUserId(request)
    }
}
impl From<frames::GetUserOffsets> for Request {
    fn from(request: frames::GetUserOffsets) -> Self {
        Self::GetUserOffsets(request)
    }
}
impl From<variables::QueryUserDefinedVariable> for Request {
    fn from(request: variables::QueryUserDefinedVariable) -> Self {
        Self::QueryUserDefinedVariable(request)
    }
}
impl From<variables::ModifyUserDefinedVariable> for Request {
    fn from(request: variables::ModifyUserDefinedVariable) -> Self {
        Self::ModifyUserDefinedVariable(request)
    }
}
impl From<payload::SetPayload> for Request {
    fn from(request: payload::SetPayload) -> Self {
        Self::SetPayload(request)
    }
}
impl From<payload::GetPayload> for Request {
    fn from(request: payload::GetPayload) -> Self {
        Self::GetPayload(request)
    }
}
impl From<collision::ProtectiveStopStatus> for Request {
    fn from(request: collision::ProtectiveStopStatus) -> Self {
        Self::ProtectiveStopStatus(request)
    }
}
impl From<collision::SetClsnSensitivity> for Request {
    fn from(request: collision::SetClsnSensitivity) -> Self {
        Self::SetClsnSensitivity(request)
    }
}
impl From<collision::GetClsnSensitivity> for Request {
    fn from(request: collision::GetClsnSensitivity) -> Self {
        Self::GetClsnSensitivity(request)
    }
}
impl From<collision::ClearError> for Request {
    fn from(request: collision::ClearError) -> Self {
        Self::ClearError(request)
    }
}
impl From<kinematics::KineForward> for Request {
    fn from(request: kinematics::KineForward) -> Self {
        Self::KineForward(request)
    }
}
impl From<kinematics::KineInverse> for Request {
    fn from(request: kinematics::KineInverse) -> Self {
        Self::KineInverse(request)
    }
}
impl From<kinematics::GetJointPos> for Request {
    fn from(request: kinematics::GetJointPos) -> Self {
        Self::GetJointPos(request)
    }
}
impl From<kinematics::GetTcpPos> for Request {
    fn from(request: kinematics::GetTcpPos) -> Self {
        Self::GetTcpPos(request)
    }
}
impl From<kinematics::GetDhParam> for Request {
    fn from(request: kinematics::GetDhParam) -> Self {
        Self::GetDhParam(request)
    }
}
impl From<trajectory::SetTrajConfig> for Request {
    fn from(request: trajectory::SetTrajConfig) -> Self {
        Self::SetTrajConfig(request)
    }
}
impl From<trajectory::GetTrajConfig> for Request {
    fn from(request: trajectory::GetTrajConfig) -> Self {
        Self::GetTrajConfig(request)
    }
}
impl From<trajectory::SetTrajSampleMode> for Request {
    fn from(request: trajectory::SetTrajSampleMode) -> Self {
        Self::SetTrajSampleMode(request)
    }
}
impl From<trajectory::GetTrajSampleStatus> for Request {
    fn from(request: trajectory::GetTrajSampleStatus) -> Self {
        Self::GetTrajSampleStatus(request)
    }
}
impl From<trajectory::GetExistTrajFileName> for Request {
    fn from(request: trajectory::GetExistTrajFileName) -> Self {
        Self::GetExistTrajFileName(request)
    }
}
impl From<trajectory::RenameTrajFileName> for Request {
    fn from(request: trajectory::RenameTrajFileName) -> Self {
        Self::RenameTrajFileName(request)
    }
}
impl From<trajectory::RemoveTrajFile> for Request {
    fn from(request: trajectory::RemoveTrajFile) -> Self {
        Self::RemoveTrajFile(request)
    }
}
impl From<trajectory::GenerateTrajExeFile> for Request {
    fn from(request: trajectory::GenerateTrajExeFile) -> Self {
        Self::GenerateTrajExeFile(request)
    }
}
impl From<force::TorqueControlEnable> for Request {
    fn from(request: force::TorqueControlEnable) -> Self {
        Self::TorqueControlEnable(request)
    }
}
impl From<force::DragStatus> for Request {
    fn from(request: force::DragStatus) -> Self {
        Self::DragStatus(request)
    }
}
impl From<force::SetTorqueSensorBrand> for Request {
    fn from(request: force::SetTorqueSensorBrand) -> Self {
        Self::SetTorqueSensorBrand(request)
    }
}
impl From<force::GetTorqueSensorBrand> for Request {
    fn from(request: force::GetTorqueSensorBrand) -> Self {
        Self::GetTorqueSensorBrand(request)
    }
}
impl From<force::SetAdmitCtrlConfig> for Request {
    fn from(request: force::SetAdmitCtrlConfig) -> Self {
        Self::SetAdmitCtrlConfig(request)
    }
}
impl From<force::GetAdmitCtrlConfig> for Request {
    fn from(request: force::GetAdmitCtrlConfig) -> Self {
        Self::GetAdmitCtrlConfig(request)
    }
}
impl From<force::SetTorqueSensorMode> for Request {
    fn from(request: force::SetTorqueSensorMode) -> Self {
        Self::SetTorqueSensorMode(request)
    }
}
impl From<force::StartTorqSensorPayloadIdentify> for Request {
    fn from(request: force::StartTorqSensorPayloadIdentify) -> Self {
        Self::StartTorqSensorPayloadIdentify(request)
    }
}
impl From<force::GetTorqSensorIdentifyStatus> for Request {
    fn from(request: force::GetTorqSensorIdentifyStatus) -> Self {
        Self::GetTorqSensorIdentifyStatus(request)
    }
}
impl From<force::GetTorqSensorPayloadIdentifyResult> for Request {
    fn from(request: force::GetTorqSensorPayloadIdentifyResult) -> Self {
        Self::GetTorqSensorPayloadIdentifyResult(request)
    }
}
impl From<force::SetToolPayload> for Request {
    fn from(request: force::SetToolPayload) -> Self {
        Self::SetToolPayload(request)
    }
}
impl From<force::GetToolPayload> for Request {
    fn from(request: force::GetToolPayload) -> Self {
        Self::GetToolPayload(request)
    }
}
impl From<force::SetComplianceCondition> for Request {
    fn from(request: force::SetComplianceCondition) -> Self {
        Self::SetComplianceCondition(request)
    }
}
impl From<force::EnableAdmittanceCtrl> for Request {
    fn from(request: force::EnableAdmittanceCtrl) -> Self {
        Self::EnableAdmittanceCtrl(request)
    }
}
impl From<force::GetCompliantType> for Request {
    fn from(request: force::GetCompliantType) -> Self {
        Self::GetCompliantType(request)
    }
}
impl From<force::SetCompliantType> for Request {
    fn from(request: force::SetCompliantType) -> Self {
        Self::SetCompliantType(request)
    }
}
impl From<force::SetTorqueSensorComm> for Request {
    fn from(request: force::SetTorqueSensorComm) -> Self {
        Self::SetTorqueSensorComm(request)
    }
}
impl From<force::GetTorqueSensorComm> for Request {
    fn from(request: force::GetTorqueSensorComm) -> Self {
        Self::GetTorqueSensorComm(request)
    }
}
impl From<force::DisableForceControl> for Request {
    fn from(request: force::DisableForceControl) -> Self {
        Self::DisableForceControl(request)
    }
}
impl From<force::SetVelCompliantCtrl> for Request {
    fn from(request: force::SetVelCompliantCtrl) -> Self {
        Self::SetVelCompliantCtrl(request)
    }
}
impl From<network::SetNetworkExceptionHandle> for Request {
    fn from(request: network::SetNetworkExceptionHandle) -> Self {
        Self::SetNetworkExceptionHandle(request)
    }
}
impl From<session::Quit> for Request {
    fn from(request: session::Quit) -> Self {
        Self::Quit(request)
    }
}
