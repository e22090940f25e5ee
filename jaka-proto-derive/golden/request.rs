#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Request {
    PowerOn(power::PowerOn),
    PowerOff(power::PowerOff),
    EnableRobot(power::EnableRobot),
    DisableRobot(power::DisableRobot),
    Shutdown(power::Shutdown),
    GetRobotState(power::GetRobotState),
    GetVersion(power::GetVersion),
    Jog(motion::Jog),
    JointMove(motion::JointMove),
    EndMove(motion::EndMove),
    MoveL(motion::MoveL),
    MoveC(motion::MoveC),
    WaitComplete(motion::WaitComplete),
    IsInServomove(servo::IsInServomove),
    SetServoMode(servo::SetServoMode),
    ServoJ(servo::ServoJ),
    ServoP(servo::ServoP),
    SetServoMoveFilter(servo::SetServoMoveFilter),
    SetRapidRate(program::SetRapidRate),
    LoadProgram(program::LoadProgram),
    GetLoadedProgram(program::GetLoadedProgram),
    PlayProgram(program::PlayProgram),
    PauseProgram(program::PauseProgram),
    ResumeProgram(program::ResumeProgram),
    StopProgram(program::StopProgram),
    GetProgramState(program::GetProgramState),
    SetDigitalOutput(io::SetDigitalOutput),
    GetDigitalInputStatus(io::GetDigitalInputStatus),
    SetAnalogOutput(io::SetAnalogOutput),
    GetExtioStatus(io::GetExtioStatus),
    GetFuncdiStatus(io::GetFuncdiStatus),
    SetTioVoutParam(io::SetTioVoutParam),
    GetTioVoutParam(io::GetTioVoutParam),
    SetToolOffsets(frames::SetToolOffsets),
    SetToolId(frames::SetToolId),
    GetToolOffsets(frames::GetToolOffsets),
    SetUserOffsets(frames::SetUserOffsets),
    SetUserId(frames::SetUserId),
    GetUserOffsets(frames::GetUserOffsets),
    QueryUserDefinedVariable(variables::QueryUserDefinedVariable),
    ModifyUserDefinedVariable(variables::ModifyUserDefinedVariable),
    SetPayload(payload::SetPayload),
    GetPayload(payload::GetPayload),
    ProtectiveStopStatus(collision::ProtectiveStopStatus),
    SetClsnSensitivity(collision::SetClsnSensitivity),
    GetClsnSensitivity(collision::GetClsnSensitivity),
    ClearError(collision::ClearError),
    KineForward(kinematics::KineForward),
    KineInverse(kinematics::KineInverse),
    GetJointPos(kinematics::GetJointPos),
    GetTcpPos(kinematics::GetTcpPos),
    GetDhParam(kinematics::GetDhParam),
    SetTrajConfig(trajectory::SetTrajConfig),
    GetTrajConfig(trajectory::GetTrajConfig),
    SetTrajSampleMode(trajectory::SetTrajSampleMode),
    GetTrajSampleStatus(trajectory::GetTrajSampleStatus),
    GetExistTrajFileName(trajectory::GetExistTrajFileName),
    RenameTrajFileName(trajectory::RenameTrajFileName),
    RemoveTrajFile(trajectory::RemoveTrajFile),
    GenerateTrajExeFile(trajectory::GenerateTrajExeFile),
    SetTorqueControl(force::SetTorqueControl),
    DragStatus(force::DragStatus),
    SetTorqueSensorBrand(force::SetTorqueSensorBrand),
    GetTorqueSensorBrand(force::GetTorqueSensorBrand),
    SetAdmitCtrlConfig(force::SetAdmitCtrlConfig),
    GetAdmitCtrlConfig(force::GetAdmitCtrlConfig),
    SetTorqueSensorMode(force::SetTorqueSensorMode),
    StartTorqSensorPayloadIdentify(force::StartTorqSensorPayloadIdentify),
    GetTorqSensorIdentifyStatus(force::GetTorqSensorIdentifyStatus),
    GetTorqSensorPayloadIdentifyResult(force::GetTorqSensorPayloadIdentifyResult),
    SetToolPayload(force::SetToolPayload),
    GetToolPayload(force::GetToolPayload),
    SetComplianceCondition(force::SetComplianceCondition),
    EnableAdmittanceCtrl(force::EnableAdmittanceCtrl),
    GetCompliantType(force::GetCompliantType),
    SetCompliantType(force::SetCompliantType),
    SetTorqueSensorComm(force::SetTorqueSensorComm),
    GetTorqueSensorComm(force::GetTorqueSensorComm),
    DisableForceControl(force::DisableForceControl),
    SetVelCompliantCtrl(force::SetVelCompliantCtrl),
    SetNetworkExceptionHandle(network::SetNetworkExceptionHandle),
    Quit(session::Quit),
    GetData(beyond_state::GetData),
    GetMotionState(beyond_state::GetMotionState),
    EmergencyStopStatus(beyond_state::EmergencyStopStatus),
    IsOnLimit(beyond_state::IsOnLimit),
    GetDragStatus(beyond_state::GetDragStatus),
    GetRapidRate(beyond_state::GetRapidRate),
    GetCurrToolId(beyond_state::GetCurrToolId),
    GetCurrUserId(beyond_state::GetCurrUserId),
    GetActualJointPos(beyond_state::GetActualJointPos),
    GetActualTcpPos(beyond_state::GetActualTcpPos),
    GetDigitalOutput(beyond_io::GetDigitalOutput),
    GetDigitalInput(beyond_io::GetDigitalInput),
    GetAnalogOutput(beyond_io::GetAnalogOutput),
    GetAnalogInput(beyond_io::GetAnalogInput),
    SendTioRsCommand(beyond_io::SendTioRsCommand),
    GetTioPinMode(beyond_io::GetTioPinMode),
    SetTioPinMode(beyond_io::SetTioPinMode),
    GetRs485ChnMode(beyond_io::GetRs485ChnMode),
    SetRs485ChnMode(beyond_io::SetRs485ChnMode),
    GetRs485ChnComm(beyond_io::GetRs485ChnComm),
    SetRs485ChnComm(beyond_io::SetRs485ChnComm),
    GetRs485SignalList(beyond_io::GetRs485SignalList),
    GetTioSignals(beyond_io::GetTioSignals),
    AddTioRsSignal(beyond_io::AddTioRsSignal),
    DeleteTioRsSignal(beyond_io::DeleteTioRsSignal),
    TorqueFeedforward(beyond_settings::TorqueFeedforward),
    SetMotionPlanner(beyond_settings::SetMotionPlanner),
    SetMotionLimitWarningRange(beyond_settings::SetMotionLimitWarningRange),
    GetMotionLimitWarningRange(beyond_settings::GetMotionLimitWarningRange),
    SetInstallationAngle(beyond_settings::SetInstallationAngle),
    GetInstallationAngle(beyond_settings::GetInstallationAngle),
    SetTorqueSensorFilter(beyond_settings::SetTorqueSensorFilter),
    SetFtCtrlFrame(beyond_settings::SetFtCtrlFrame),
    ZeroEndSensor(beyond_settings::ZeroEndSensor),
    SetPort10000DelayMs(beyond_settings::SetPort10000DelayMs),
    GetPort10000DelayMs(beyond_settings::GetPort10000DelayMs),
    SetOptionalInfoConfig(beyond_settings::SetOptionalInfoConfig),
    GetOptionalInfoConfig(beyond_settings::GetOptionalInfoConfig),
}
impl Request {
    pub const COMMANDS: &'static [&'static ::jaka_proto::CommandInfo] = _;
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
