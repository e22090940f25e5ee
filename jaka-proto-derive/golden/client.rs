impl Client {
    pub fn power_on(&mut self) -> Result<self::power::PowerOnReply, Error> {}
    pub fn power_off(&mut self) -> Result<(), Error> {}
    pub fn enable_robot(&mut self) -> Result<self::power::EnableRobotReply, Error> {}
    pub fn disable_robot(&mut self) -> Result<(), Error> {}
    pub fn shutdown(&mut self) -> Result<(), Error> {}
    pub fn get_robot_state(&mut self) -> Result<self::power::GetRobotStateReply, Error> {}
    pub fn get_version(&mut self) -> Result<self::power::GetVersionReply, Error> {}
}
impl Client {
    pub fn jog(&mut self, request: &self::motion::Jog) -> Result<(), Error> {}
    pub fn joint_move(
        &mut self,
        request: &self::motion::JointMove,
    ) -> Result<(), Error> {}
    pub fn end_move(&mut self, request: &self::motion::EndMove) -> Result<(), Error> {}
    pub fn move_l(&mut self, request: &self::motion::MoveL) -> Result<(), Error> {}
    pub fn move_c(&mut self, request: &self::motion::MoveC) -> Result<(), Error> {}
    #[deprecated(note = "watch the status of port 10000 until the robot is in position")]
    pub fn wait_complete(&mut self) -> Result<(), Error> {}
}
impl Client {
    pub fn is_in_servomove(&mut self) -> Result<self::servo::IsInServomoveReply, Error> {}
    pub fn set_servo_mode(
        &mut self,
        servo_mode: self::types::Switch,
    ) -> Result<(), Error> {}
    pub fn servo_j(&mut self, request: &self::servo::ServoJ) -> Result<(), Error> {}
    pub fn servo_p(&mut self, request: &self::servo::ServoP) -> Result<(), Error> {}
    pub fn set_servo_move_filter(
        &mut self,
        request: &self::servo::SetServoMoveFilter,
    ) -> Result<(), Error> {}
}
impl Client {
    pub fn set_rapid_rate(&mut self, rate: f64) -> Result<(), Error> {}
    pub fn load_program(
        &mut self,
        program_name: impl Into<String>,
    ) -> Result<(), Error> {}
    pub fn get_loaded_program(
        &mut self,
    ) -> Result<self::program::GetLoadedProgramReply, Error> {}
    pub fn play_program(&mut self) -> Result<(), Error> {}
    pub fn pause_program(&mut self) -> Result<(), Error> {}
    pub fn resume_program(&mut self) -> Result<(), Error> {}
    pub fn stop_program(&mut self) -> Result<(), Error> {}
    pub fn get_program_state(
        &mut self,
    ) -> Result<self::program::GetProgramStateReply, Error> {}
}
impl Client {
    pub fn set_digital_output(
        &mut self,
        request: &self::io::SetDigitalOutput,
    ) -> Result<(), Error> {}
    pub fn get_digital_input_status(
        &mut self,
    ) -> Result<self::io::GetDigitalInputStatusReply, Error> {}
    pub fn set_analog_output(
        &mut self,
        request: &self::io::SetAnalogOutput,
    ) -> Result<(), Error> {}
    pub fn get_extio_status(&mut self) -> Result<self::io::GetExtioStatusReply, Error> {}
    pub fn get_funcdi_status(
        &mut self,
    ) -> Result<self::io::GetFuncdiStatusReply, Error> {}
    pub fn set_tio_vout_param(
        &mut self,
        request: &self::io::SetTioVoutParam,
    ) -> Result<(), Error> {}
    pub fn get_tio_vout_param(
        &mut self,
    ) -> Result<self::io::GetTioVoutParamReply, Error> {}
}
impl Client {
    pub fn set_tool_offsets(
        &mut self,
        request: &self::frames::SetToolOffsets,
    ) -> Result<(), Error> {}
    pub fn set_tool_id(&mut self, tool_id: i64) -> Result<(), Error> {}
    pub fn get_tool_offsets(
        &mut self,
    ) -> Result<self::frames::GetToolOffsetsReply, Error> {}
    pub fn set_user_offsets(
        &mut self,
        request: &self::frames::SetUserOffsets,
    ) -> Result<(), Error> {}
    pub fn set_user_id(&mut self, user_frame_id: i64) -> Result<(), Error> {}
    pub fn get_user_offsets(
        &mut self,
    ) -> Result<self::frames::GetUserOffsetsReply, Error> {}
}
impl Client {
    pub fn query_user_defined_variable(
        &mut self,
    ) -> Result<self::variables::QueryUserDefinedVariableReply, Error> {}
    pub fn modify_user_defined_variable(
        &mut self,
        request: &self::variables::ModifyUserDefinedVariable,
    ) -> Result<(), Error> {}
}
impl Client {
    pub fn set_payload(
        &mut self,
        request: &self::payload::SetPayload,
    ) -> Result<(), Error> {}
    pub fn get_payload(&mut self) -> Result<self::payload::GetPayloadReply, Error> {}
}
impl Client {
    pub fn protective_stop_status(
        &mut self,
    ) -> Result<self::collision::ProtectiveStopStatusReply, Error> {}
    pub fn set_clsn_sensitivity(&mut self, level: i64) -> Result<(), Error> {}
    pub fn get_clsn_sensitivity(
        &mut self,
    ) -> Result<self::collision::GetClsnSensitivityReply, Error> {}
    pub fn clear_error(&mut self) -> Result<(), Error> {}
}
impl Client {
    pub fn kine_forward(
        &mut self,
        joint_position: impl Into<self::types::JointPosition>,
    ) -> Result<self::kinematics::KineForwardReply, Error> {}
    pub fn kine_inverse(
        &mut self,
        request: &self::kinematics::KineInverse,
    ) -> Result<self::kinematics::KineInverseReply, Error> {}
    pub fn get_joint_pos(
        &mut self,
    ) -> Result<self::kinematics::GetJointPosReply, Error> {}
    pub fn get_tcp_pos(&mut self) -> Result<self::kinematics::GetTcpPosReply, Error> {}
    pub fn get_dh_param(&mut self) -> Result<self::kinematics::GetDhParamReply, Error> {}
}
impl Client {
    pub fn set_traj_config(
        &mut self,
        request: &self::trajectory::SetTrajConfig,
    ) -> Result<(), Error> {}
    pub fn get_traj_config(
        &mut self,
    ) -> Result<self::trajectory::GetTrajConfigReply, Error> {}
    pub fn set_traj_sample_mode(
        &mut self,
        request: &self::trajectory::SetTrajSampleMode,
    ) -> Result<(), Error> {}
    pub fn get_traj_sample_status(
        &mut self,
    ) -> Result<self::trajectory::GetTrajSampleStatusReply, Error> {}
    pub fn get_exist_traj_file_name(
        &mut self,
    ) -> Result<self::trajectory::GetExistTrajFileNameReply, Error> {}
    pub fn rename_traj_file_name(
        &mut self,
        request: &self::trajectory::RenameTrajFileName,
    ) -> Result<(), Error> {}
    pub fn remove_traj_file(
        &mut self,
        file_name: impl Into<String>,
    ) -> Result<(), Error> {}
    pub fn generate_traj_exe_file(
        &mut self,
        file_name: impl Into<String>,
    ) -> Result<(), Error> {}
}
impl Client {
    pub fn set_torque_control(
        &mut self,
        enable_flag: self::types::Switch,
    ) -> Result<(), Error> {}
    pub fn drag_status(&mut self) -> Result<self::force::DragStatusReply, Error> {}
    pub fn set_torque_sensor_brand(
        &mut self,
        brand: self::force::TorqueSensorBrand,
    ) -> Result<(), Error> {}
    pub fn get_torque_sensor_brand(
        &mut self,
    ) -> Result<self::force::GetTorqueSensorBrandReply, Error> {}
    pub fn set_admit_ctrl_config(
        &mut self,
        request: &self::force::SetAdmitCtrlConfig,
    ) -> Result<(), Error> {}
    pub fn get_admit_ctrl_config(
        &mut self,
    ) -> Result<self::force::GetAdmitCtrlConfigReply, Error> {}
    pub fn set_torque_sensor_mode(&mut self, mode: i64) -> Result<(), Error> {}
    pub fn start_torq_sensor_payload_identify(
        &mut self,
        joint_position: impl Into<self::types::JointPosition>,
    ) -> Result<(), Error> {}
    pub fn get_torq_sensor_identify_status(
        &mut self,
    ) -> Result<self::force::GetTorqSensorIdentifyStatusReply, Error> {}
    pub fn get_torq_sensor_payload_identify_result(
        &mut self,
    ) -> Result<self::force::GetTorqSensorPayloadIdentifyResultReply, Error> {}
    pub fn set_tool_payload(
        &mut self,
        request: &self::force::SetToolPayload,
    ) -> Result<(), Error> {}
    pub fn get_tool_payload(
        &mut self,
    ) -> Result<self::force::GetToolPayloadReply, Error> {}
    pub fn set_compliance_condition(
        &mut self,
        request: &self::force::SetComplianceCondition,
    ) -> Result<(), Error> {}
    pub fn enable_admittance_ctrl(
        &mut self,
        enable_flag: self::types::Switch,
    ) -> Result<(), Error> {}
    pub fn get_compliant_type(
        &mut self,
    ) -> Result<self::force::GetCompliantTypeReply, Error> {}
    pub fn set_compliant_type(
        &mut self,
        request: &self::force::SetCompliantType,
    ) -> Result<(), Error> {}
    pub fn set_torque_sensor_comm(
        &mut self,
        request: &self::force::SetTorqueSensorComm,
    ) -> Result<(), Error> {}
    pub fn get_torque_sensor_comm(
        &mut self,
    ) -> Result<self::force::GetTorqueSensorCommReply, Error> {}
    pub fn disable_force_control(&mut self) -> Result<(), Error> {}
    pub fn set_vel_compliant_ctrl(
        &mut self,
        compliance: self::force::VelocityCompliance,
    ) -> Result<(), Error> {}
}
impl Client {
    pub fn set_network_exception_handle(
        &mut self,
        request: &self::network::SetNetworkExceptionHandle,
    ) -> Result<(), Error> {}
}
impl Client {
    pub fn quit(&mut self) -> Result<(), Error> {}
}
impl Client {
    pub fn get_data(&mut self) -> Result<self::status::RobotStatus, Error> {}
    pub fn get_motion_state(
        &mut self,
    ) -> Result<self::beyond_state::GetMotionStateReply, Error> {}
    pub fn emergency_stop_status(
        &mut self,
    ) -> Result<self::beyond_state::EmergencyStopStatusReply, Error> {}
    pub fn is_on_limit(&mut self) -> Result<self::beyond_state::IsOnLimitReply, Error> {}
    pub fn get_drag_status(
        &mut self,
    ) -> Result<self::beyond_state::GetDragStatusReply, Error> {}
    pub fn get_rapid_rate(
        &mut self,
    ) -> Result<self::beyond_state::GetRapidRateReply, Error> {}
    pub fn get_curr_tool_id(
        &mut self,
    ) -> Result<self::beyond_state::GetCurrToolIdReply, Error> {}
    pub fn get_curr_user_id(
        &mut self,
    ) -> Result<self::beyond_state::GetCurrUserIdReply, Error> {}
    pub fn get_actual_joint_pos(
        &mut self,
    ) -> Result<self::beyond_state::GetActualJointPosReply, Error> {}
    pub fn get_actual_tcp_pos(
        &mut self,
    ) -> Result<self::beyond_state::GetActualTcpPosReply, Error> {}
}
impl Client {
    pub fn get_digital_output(
        &mut self,
        request: &self::beyond_io::GetDigitalOutput,
    ) -> Result<self::beyond_io::GetDigitalOutputReply, Error> {}
    pub fn get_digital_input(
        &mut self,
        request: &self::beyond_io::GetDigitalInput,
    ) -> Result<self::beyond_io::GetDigitalInputReply, Error> {}
    pub fn get_analog_output(
        &mut self,
        request: &self::beyond_io::GetAnalogOutput,
    ) -> Result<self::beyond_io::GetAnalogOutputReply, Error> {}
    pub fn get_analog_input(
        &mut self,
        request: &self::beyond_io::GetAnalogInput,
    ) -> Result<self::beyond_io::GetAnalogInputReply, Error> {}
    pub fn send_tio_rs_command(
        &mut self,
        request: &self::beyond_io::SendTioRsCommand,
    ) -> Result<(), Error> {}
    pub fn get_tio_pin_mode(
        &mut self,
        pin_type: self::beyond_io::ToolPinType,
    ) -> Result<self::beyond_io::GetTioPinModeReply, Error> {}
    pub fn set_tio_pin_mode(
        &mut self,
        request: &self::beyond_io::SetTioPinMode,
    ) -> Result<(), Error> {}
    pub fn get_rs485_chn_mode(
        &mut self,
        channel: self::beyond_io::SerialChannel,
    ) -> Result<self::beyond_io::GetRs485ChnModeReply, Error> {}
    pub fn set_rs485_chn_mode(
        &mut self,
        request: &self::beyond_io::SetRs485ChnMode,
    ) -> Result<(), Error> {}
    pub fn get_rs485_chn_comm(
        &mut self,
        channel: self::beyond_io::SerialChannel,
    ) -> Result<self::beyond_io::GetRs485ChnCommReply, Error> {}
    pub fn set_rs485_chn_comm(
        &mut self,
        request: &self::beyond_io::SetRs485ChnComm,
    ) -> Result<(), Error> {}
    pub fn get_rs485_signal_list(&mut self) -> Result<::jaka_proto::wire::Value, Error> {}
    pub fn get_tio_signals(
        &mut self,
    ) -> Result<self::beyond_io::GetTioSignalsReply, Error> {}
    pub fn add_tio_rs_signal(
        &mut self,
        request: &self::beyond_io::AddTioRsSignal,
    ) -> Result<(), Error> {}
    pub fn delete_tio_rs_signal(
        &mut self,
        name: impl Into<String>,
    ) -> Result<(), Error> {}
}
impl Client {
    pub fn torque_feedforward(
        &mut self,
        request: &self::beyond_settings::TorqueFeedforward,
    ) -> Result<(), Error> {}
    pub fn set_motion_planner(
        &mut self,
        planner: self::beyond_settings::MotionPlanner,
    ) -> Result<(), Error> {}
    pub fn set_motion_limit_warning_range(&mut self, level: i64) -> Result<(), Error> {}
    pub fn get_motion_limit_warning_range(
        &mut self,
    ) -> Result<self::beyond_settings::GetMotionLimitWarningRangeReply, Error> {}
    pub fn set_installation_angle(
        &mut self,
        request: &self::beyond_settings::SetInstallationAngle,
    ) -> Result<(), Error> {}
    pub fn get_installation_angle(
        &mut self,
    ) -> Result<::jaka_proto::wire::Value, Error> {}
    pub fn set_torque_sensor_filter(&mut self, filter: f64) -> Result<(), Error> {}
    pub fn set_ft_ctrl_frame(&mut self, frame: i64) -> Result<(), Error> {}
    pub fn zero_end_sensor(&mut self) -> Result<(), Error> {}
    pub fn set_port10000_delay_ms(&mut self, delay: i64) -> Result<(), Error> {}
    pub fn get_port10000_delay_ms(
        &mut self,
    ) -> Result<self::beyond_settings::GetPort10000DelayMsReply, Error> {}
    pub fn set_optional_info_config(
        &mut self,
        request: &self::beyond_settings::SetOptionalInfoConfig,
    ) -> Result<(), Error> {}
    pub fn get_optional_info_config(
        &mut self,
        request: &self::beyond_settings::GetOptionalInfoConfig,
    ) -> Result<self::beyond_settings::GetOptionalInfoConfigReply, Error> {}
}
