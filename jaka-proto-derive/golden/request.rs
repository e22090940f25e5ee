/// Any request of the spec, by its `cmdName`.
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
    SetServoMode(servo::SetServoMode),
    /// `servo_j`
    ServoJ(servo::ServoJ),
    /// `servo_p`
    ServoP(servo::ServoP),
    /// `set_servo_move_filter`
    SetServoMoveFilter(servo::SetServoMoveFilter),
    /// `rapid_rate`
    SetRapidRate(program::SetRapidRate),
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
    SetTorqueControl(force::SetTorqueControl),
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
    /// `get_data`
    GetData(beyond_state::GetData),
    /// `get_motion_state`
    GetMotionState(beyond_state::GetMotionState),
    /// `emergency_stop_status`
    EmergencyStopStatus(beyond_state::EmergencyStopStatus),
    /// `is_on_limit`
    IsOnLimit(beyond_state::IsOnLimit),
    /// `get_drag_status`
    GetDragStatus(beyond_state::GetDragStatus),
    /// `get_rapid_rate`
    GetRapidRate(beyond_state::GetRapidRate),
    /// `get_curr_tool_id`
    GetCurrToolId(beyond_state::GetCurrToolId),
    /// `get_curr_user_id`
    GetCurrUserId(beyond_state::GetCurrUserId),
    /// `get_actual_joint_pos`
    GetActualJointPos(beyond_state::GetActualJointPos),
    /// `get_actual_tcp_pos`
    GetActualTcpPos(beyond_state::GetActualTcpPos),
    /// `get_digital_output`
    GetDigitalOutput(beyond_io::GetDigitalOutput),
    /// `get_digital_input`
    GetDigitalInput(beyond_io::GetDigitalInput),
    /// `get_analog_output`
    GetAnalogOutput(beyond_io::GetAnalogOutput),
    /// `get_analog_input`
    GetAnalogInput(beyond_io::GetAnalogInput),
    /// `send_tio_rs_command`
    SendTioRsCommand(beyond_io::SendTioRsCommand),
    /// `get_tio_pin_mode`
    GetTioPinMode(beyond_io::GetTioPinMode),
    /// `set_tio_pin_mode`
    SetTioPinMode(beyond_io::SetTioPinMode),
    /// `get_rs485_chn_mode`
    GetRs485ChnMode(beyond_io::GetRs485ChnMode),
    /// `set_rs485_chn_mode`
    SetRs485ChnMode(beyond_io::SetRs485ChnMode),
    /// `get_rs485_chn_comm`
    GetRs485ChnComm(beyond_io::GetRs485ChnComm),
    /// `set_rs485_chn_comm`
    SetRs485ChnComm(beyond_io::SetRs485ChnComm),
    /// `get_rs485_signal_list`
    GetRs485SignalList(beyond_io::GetRs485SignalList),
    /// `get_tio_signals`
    GetTioSignals(beyond_io::GetTioSignals),
    /// `add_tio_rs_signal`
    AddTioRsSignal(beyond_io::AddTioRsSignal),
    /// `del_tio_rs_signal`
    DeleteTioRsSignal(beyond_io::DeleteTioRsSignal),
    /// `torque_feedforward`
    TorqueFeedforward(beyond_settings::TorqueFeedforward),
    /// `set_motion_planner`
    SetMotionPlanner(beyond_settings::SetMotionPlanner),
    /// `set_motion_limit_warning_range`
    SetMotionLimitWarningRange(beyond_settings::SetMotionLimitWarningRange),
    /// `get_motion_limit_warning_range`
    GetMotionLimitWarningRange(beyond_settings::GetMotionLimitWarningRange),
    /// `set_installation_angle`
    SetInstallationAngle(beyond_settings::SetInstallationAngle),
    /// `get_installation_angle`
    GetInstallationAngle(beyond_settings::GetInstallationAngle),
    /// `set_torque_sensor_filter`
    SetTorqueSensorFilter(beyond_settings::SetTorqueSensorFilter),
    /// `set_ft_ctrl_frame`
    SetFtCtrlFrame(beyond_settings::SetFtCtrlFrame),
    /// `zero_end_sensor`
    ZeroEndSensor(beyond_settings::ZeroEndSensor),
    /// `set_port10000_delay_ms`
    SetPort10000DelayMs(beyond_settings::SetPort10000DelayMs),
    /// `get_port10000_delay_ms`
    GetPort10000DelayMs(beyond_settings::GetPort10000DelayMs),
    /// `setOptionalInfoConfig`
    SetOptionalInfoConfig(beyond_settings::SetOptionalInfoConfig),
    /// `getOptionalInfoConfig`
    GetOptionalInfoConfig(beyond_settings::GetOptionalInfoConfig),
}
impl Request {
    /// Facts of the spec about each command, topic by topic.
    pub const COMMANDS: &'static [&'static ::jaka_proto::CommandInfo] = _;
    /// Does something with the request, whatever its type.
    pub fn visit<V: ::jaka_proto::Visit>(&self, visitor: V) -> V::Output {}
}
impl From<power::PowerOn> for Request {}
impl From<power::PowerOff> for Request {}
impl From<power::EnableRobot> for Request {}
impl From<power::DisableRobot> for Request {}
impl From<power::Shutdown> for Request {}
impl From<power::GetRobotState> for Request {}
impl From<power::GetVersion> for Request {}
impl From<motion::Jog> for Request {}
impl From<motion::JointMove> for Request {}
impl From<motion::EndMove> for Request {}
impl From<motion::MoveL> for Request {}
impl From<motion::MoveC> for Request {}
impl From<motion::WaitComplete> for Request {}
impl From<servo::IsInServomove> for Request {}
impl From<servo::SetServoMode> for Request {}
impl From<servo::ServoJ> for Request {}
impl From<servo::ServoP> for Request {}
impl From<servo::SetServoMoveFilter> for Request {}
impl From<program::SetRapidRate> for Request {}
impl From<program::LoadProgram> for Request {}
impl From<program::GetLoadedProgram> for Request {}
impl From<program::PlayProgram> for Request {}
impl From<program::PauseProgram> for Request {}
impl From<program::ResumeProgram> for Request {}
impl From<program::StopProgram> for Request {}
impl From<program::GetProgramState> for Request {}
impl From<io::SetDigitalOutput> for Request {}
impl From<io::GetDigitalInputStatus> for Request {}
impl From<io::SetAnalogOutput> for Request {}
impl From<io::GetExtioStatus> for Request {}
impl From<io::GetFuncdiStatus> for Request {}
impl From<io::SetTioVoutParam> for Request {}
impl From<io::GetTioVoutParam> for Request {}
impl From<frames::SetToolOffsets> for Request {}
impl From<frames::SetToolId> for Request {}
impl From<frames::GetToolOffsets> for Request {}
impl From<frames::SetUserOffsets> for Request {}
impl From<frames::SetUserId> for Request {}
impl From<frames::GetUserOffsets> for Request {}
impl From<variables::QueryUserDefinedVariable> for Request {}
impl From<variables::ModifyUserDefinedVariable> for Request {}
impl From<payload::SetPayload> for Request {}
impl From<payload::GetPayload> for Request {}
impl From<collision::ProtectiveStopStatus> for Request {}
impl From<collision::SetClsnSensitivity> for Request {}
impl From<collision::GetClsnSensitivity> for Request {}
impl From<collision::ClearError> for Request {}
impl From<kinematics::KineForward> for Request {}
impl From<kinematics::KineInverse> for Request {}
impl From<kinematics::GetJointPos> for Request {}
impl From<kinematics::GetTcpPos> for Request {}
impl From<kinematics::GetDhParam> for Request {}
impl From<trajectory::SetTrajConfig> for Request {}
impl From<trajectory::GetTrajConfig> for Request {}
impl From<trajectory::SetTrajSampleMode> for Request {}
impl From<trajectory::GetTrajSampleStatus> for Request {}
impl From<trajectory::GetExistTrajFileName> for Request {}
impl From<trajectory::RenameTrajFileName> for Request {}
impl From<trajectory::RemoveTrajFile> for Request {}
impl From<trajectory::GenerateTrajExeFile> for Request {}
impl From<force::SetTorqueControl> for Request {}
impl From<force::DragStatus> for Request {}
impl From<force::SetTorqueSensorBrand> for Request {}
impl From<force::GetTorqueSensorBrand> for Request {}
impl From<force::SetAdmitCtrlConfig> for Request {}
impl From<force::GetAdmitCtrlConfig> for Request {}
impl From<force::SetTorqueSensorMode> for Request {}
impl From<force::StartTorqSensorPayloadIdentify> for Request {}
impl From<force::GetTorqSensorIdentifyStatus> for Request {}
impl From<force::GetTorqSensorPayloadIdentifyResult> for Request {}
impl From<force::SetToolPayload> for Request {}
impl From<force::GetToolPayload> for Request {}
impl From<force::SetComplianceCondition> for Request {}
impl From<force::EnableAdmittanceCtrl> for Request {}
impl From<force::GetCompliantType> for Request {}
impl From<force::SetCompliantType> for Request {}
impl From<force::SetTorqueSensorComm> for Request {}
impl From<force::GetTorqueSensorComm> for Request {}
impl From<force::DisableForceControl> for Request {}
impl From<force::SetVelCompliantCtrl> for Request {}
impl From<network::SetNetworkExceptionHandle> for Request {}
impl From<session::Quit> for Request {}
impl From<beyond_state::GetData> for Request {}
impl From<beyond_state::GetMotionState> for Request {}
impl From<beyond_state::EmergencyStopStatus> for Request {}
impl From<beyond_state::IsOnLimit> for Request {}
impl From<beyond_state::GetDragStatus> for Request {}
impl From<beyond_state::GetRapidRate> for Request {}
impl From<beyond_state::GetCurrToolId> for Request {}
impl From<beyond_state::GetCurrUserId> for Request {}
impl From<beyond_state::GetActualJointPos> for Request {}
impl From<beyond_state::GetActualTcpPos> for Request {}
impl From<beyond_io::GetDigitalOutput> for Request {}
impl From<beyond_io::GetDigitalInput> for Request {}
impl From<beyond_io::GetAnalogOutput> for Request {}
impl From<beyond_io::GetAnalogInput> for Request {}
impl From<beyond_io::SendTioRsCommand> for Request {}
impl From<beyond_io::GetTioPinMode> for Request {}
impl From<beyond_io::SetTioPinMode> for Request {}
impl From<beyond_io::GetRs485ChnMode> for Request {}
impl From<beyond_io::SetRs485ChnMode> for Request {}
impl From<beyond_io::GetRs485ChnComm> for Request {}
impl From<beyond_io::SetRs485ChnComm> for Request {}
impl From<beyond_io::GetRs485SignalList> for Request {}
impl From<beyond_io::GetTioSignals> for Request {}
impl From<beyond_io::AddTioRsSignal> for Request {}
impl From<beyond_io::DeleteTioRsSignal> for Request {}
impl From<beyond_settings::TorqueFeedforward> for Request {}
impl From<beyond_settings::SetMotionPlanner> for Request {}
impl From<beyond_settings::SetMotionLimitWarningRange> for Request {}
impl From<beyond_settings::GetMotionLimitWarningRange> for Request {}
impl From<beyond_settings::SetInstallationAngle> for Request {}
impl From<beyond_settings::GetInstallationAngle> for Request {}
impl From<beyond_settings::SetTorqueSensorFilter> for Request {}
impl From<beyond_settings::SetFtCtrlFrame> for Request {}
impl From<beyond_settings::ZeroEndSensor> for Request {}
impl From<beyond_settings::SetPort10000DelayMs> for Request {}
impl From<beyond_settings::GetPort10000DelayMs> for Request {}
impl From<beyond_settings::SetOptionalInfoConfig> for Request {}
impl From<beyond_settings::GetOptionalInfoConfig> for Request {}
