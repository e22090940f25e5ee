/// # Power, enabling and the controller's state
///
/// With the messages of [`power`](crate::power).
impl Client {
    /// Switches the arm's power on.
    pub fn power_on(&mut self) -> Result<self::power::PowerOnReply, Error> {}
    /// Switches the arm's power off.
    pub fn power_off(&mut self) -> Result<(), Error> {}
    /// Enables the arm, so that it can move.
    pub fn enable_robot(&mut self) -> Result<self::power::EnableRobotReply, Error> {}
    /// Disables the arm.
    pub fn disable_robot(&mut self) -> Result<(), Error> {}
    /// Shuts down the arm and the controller.
    pub fn shutdown(&mut self) -> Result<(), Error> {}
    /// Reads whether the arm has power and is enabled.
    pub fn get_robot_state(&mut self) -> Result<self::power::GetRobotStateReply, Error> {}
    /// Reads the version of the controller's software.
    pub fn get_version(&mut self) -> Result<self::power::GetVersionReply, Error> {}
}
/// # Jog and planned motion
///
/// With the messages of [`motion`](crate::motion).
impl Client {
    /// Moves one joint, or one Cartesian coordinate of the tool centre point, continuously, by an increment or to a position.
    pub fn jog(&mut self, request: &self::motion::Jog) -> Result<(), Error> {}
    /// Moves all joints to a position, or by an offset, at a joint speed (MoveJ).
    pub fn joint_move(
        &mut self,
        request: &self::motion::JointMove,
    ) -> Result<(), Error> {}
    /// Moves all joints so that the tool centre point reaches a pose.
    pub fn end_move(&mut self, request: &self::motion::EndMove) -> Result<(), Error> {}
    /// Moves the tool centre point along a straight line to a pose, or by an offset (MoveL).
    pub fn move_l(&mut self, request: &self::motion::MoveL) -> Result<(), Error> {}
    /// Moves the tool centre point along an arc, through one pose to another (MoveC).
    pub fn move_c(&mut self, request: &self::motion::MoveC) -> Result<(), Error> {}
    /// Waits until the motion that is running has ended.
    #[deprecated(note = "watch the status of port 10000 until the robot is in position")]
    pub fn wait_complete(&mut self) -> Result<(), Error> {}
}
/// # Servo mode
///
/// With the messages of [`servo`](crate::servo).
impl Client {
    /// Reads whether the robot is in servo mode.
    pub fn is_in_servomove(&mut self) -> Result<self::servo::IsInServomoveReply, Error> {}
    /// Enters or leaves servo mode.
    pub fn set_servo_mode(
        &mut self,
        servo_mode: self::types::Switch,
    ) -> Result<(), Error> {}
    /// Moves all joints to a set-point, or by an offset, within one servo period.
    pub fn servo_j(&mut self, request: &self::servo::ServoJ) -> Result<(), Error> {}
    /// Moves the tool centre point to a set-point, or by an offset, within one servo period.
    pub fn servo_p(&mut self, request: &self::servo::ServoP) -> Result<(), Error> {}
    /// Sets the filter that smooths the set-points of servo mode.
    pub fn set_servo_move_filter(
        &mut self,
        request: &self::servo::SetServoMoveFilter,
    ) -> Result<(), Error> {}
}
/// # Programs and the speed rate
///
/// With the messages of [`program`](crate::program).
impl Client {
    /// Sets the rate by which the controller scales the speed of motion.
    pub fn set_rapid_rate(&mut self, rate: f64) -> Result<(), Error> {}
    /// Loads a program that is stored on the controller.
    pub fn load_program(
        &mut self,
        program_name: impl Into<String>,
    ) -> Result<(), Error> {}
    /// Reads the name of the loaded program.
    pub fn get_loaded_program(
        &mut self,
    ) -> Result<self::program::GetLoadedProgramReply, Error> {}
    /// Starts the loaded program.
    pub fn play_program(&mut self) -> Result<(), Error> {}
    /// Pauses the program that is running.
    pub fn pause_program(&mut self) -> Result<(), Error> {}
    /// Resumes the program that is paused.
    pub fn resume_program(&mut self) -> Result<(), Error> {}
    /// Stops the program, or the motion, that is running.
    pub fn stop_program(&mut self) -> Result<(), Error> {}
    /// Reads the state of the program.
    pub fn get_program_state(
        &mut self,
    ) -> Result<self::program::GetProgramStateReply, Error> {}
}
/// # Inputs and outputs
///
/// With the messages of [`io`](crate::io).
impl Client {
    /// Sets one digital output.
    pub fn set_digital_output(
        &mut self,
        request: &self::io::SetDigitalOutput,
    ) -> Result<(), Error> {}
    /// Reads the states of all digital inputs.
    pub fn get_digital_input_status(
        &mut self,
    ) -> Result<self::io::GetDigitalInputStatusReply, Error> {}
    /// Sets one analog output.
    pub fn set_analog_output(
        &mut self,
        request: &self::io::SetAnalogOutput,
    ) -> Result<(), Error> {}
    /// Reads the configuration and state of the extension I/O modules.
    pub fn get_extio_status(&mut self) -> Result<self::io::GetExtioStatusReply, Error> {}
    /// Reads which inputs serve as function inputs.
    pub fn get_funcdi_status(
        &mut self,
    ) -> Result<self::io::GetFuncdiStatusReply, Error> {}
    /// Sets the voltage output of a version 3 tool I/O board.
    pub fn set_tio_vout_param(
        &mut self,
        request: &self::io::SetTioVoutParam,
    ) -> Result<(), Error> {}
    /// Reads the settings of the voltage output of a version 3 tool I/O board.
    pub fn get_tio_vout_param(
        &mut self,
    ) -> Result<self::io::GetTioVoutParamReply, Error> {}
}
/// # Tool frames and user frames
///
/// With the messages of [`frames`](crate::frames).
impl Client {
    /// Sets the offset and the name of one tool frame.
    pub fn set_tool_offsets(
        &mut self,
        request: &self::frames::SetToolOffsets,
    ) -> Result<(), Error> {}
    /// Selects the tool frame in which the robot moves.
    pub fn set_tool_id(&mut self, tool_id: i64) -> Result<(), Error> {}
    /// Reads the offsets of all tool frames.
    pub fn get_tool_offsets(
        &mut self,
    ) -> Result<self::frames::GetToolOffsetsReply, Error> {}
    /// Sets the offset and the name of one user frame.
    pub fn set_user_offsets(
        &mut self,
        request: &self::frames::SetUserOffsets,
    ) -> Result<(), Error> {}
    /// Selects the user frame in which the robot moves.
    pub fn set_user_id(&mut self, user_frame_id: i64) -> Result<(), Error> {}
    /// Reads the offsets of all user frames.
    pub fn get_user_offsets(
        &mut self,
    ) -> Result<self::frames::GetUserOffsetsReply, Error> {}
}
/// # User-defined system variables
///
/// With the messages of [`variables`](crate::variables).
impl Client {
    /// Reads all user-defined system variables.
    pub fn query_user_defined_variable(
        &mut self,
    ) -> Result<self::variables::QueryUserDefinedVariableReply, Error> {}
    /// Sets the name and the value of a user-defined system variable.
    pub fn modify_user_defined_variable(
        &mut self,
        request: &self::variables::ModifyUserDefinedVariable,
    ) -> Result<(), Error> {}
}
/// # Payload
///
/// With the messages of [`payload`](crate::payload).
impl Client {
    /// Sets the mass and the centroid of the payload.
    pub fn set_payload(
        &mut self,
        request: &self::payload::SetPayload,
    ) -> Result<(), Error> {}
    /// Reads the mass and the centroid of the payload.
    pub fn get_payload(&mut self) -> Result<self::payload::GetPayloadReply, Error> {}
}
/// # Collision detection and protective stop
///
/// With the messages of [`collision`](crate::collision).
impl Client {
    /// Reads whether the robot is in a protective stop.
    pub fn protective_stop_status(
        &mut self,
    ) -> Result<self::collision::ProtectiveStopStatusReply, Error> {}
    /// Sets the collision level, which says how hard a contact must be for the arm to stop.
    pub fn set_clsn_sensitivity(&mut self, level: i64) -> Result<(), Error> {}
    /// Reads the collision level.
    pub fn get_clsn_sensitivity(
        &mut self,
    ) -> Result<self::collision::GetClsnSensitivityReply, Error> {}
    /// Leaves the collision protection that the robot enters after a collision.
    pub fn clear_error(&mut self) -> Result<(), Error> {}
}
/// # Kinematics and present position
///
/// With the messages of [`kinematics`](crate::kinematics).
impl Client {
    /// Computes the pose of the robot's end at a joint position (forward kinematics).
    pub fn kine_forward(
        &mut self,
        joint_position: impl Into<self::types::JointPosition>,
    ) -> Result<self::kinematics::KineForwardReply, Error> {}
    /// Computes a joint position at which the robot's end has a pose (inverse kinematics).
    pub fn kine_inverse(
        &mut self,
        request: &self::kinematics::KineInverse,
    ) -> Result<self::kinematics::KineInverseReply, Error> {}
    /// Reads the positions of the six joints.
    pub fn get_joint_pos(
        &mut self,
    ) -> Result<self::kinematics::GetJointPosReply, Error> {}
    /// Reads the pose of the robot's end, which the selected tool frame defines.
    pub fn get_tcp_pos(&mut self) -> Result<self::kinematics::GetTcpPosReply, Error> {}
    /// Reads the Denavit-Hartenberg (DH) parameters of the robot.
    pub fn get_dh_param(&mut self) -> Result<self::kinematics::GetDhParamReply, Error> {}
}
/// # Trajectory recording
///
/// With the messages of [`trajectory`](crate::trajectory).
impl Client {
    /// Sets how finely a trajectory is recorded, and how fast it is run later.
    pub fn set_traj_config(
        &mut self,
        request: &self::trajectory::SetTrajConfig,
    ) -> Result<(), Error> {}
    /// Reads how finely a trajectory is recorded, and how fast it is run later.
    pub fn get_traj_config(
        &mut self,
    ) -> Result<self::trajectory::GetTrajConfigReply, Error> {}
    /// Starts or stops the recording of a trajectory to a file.
    pub fn set_traj_sample_mode(
        &mut self,
        request: &self::trajectory::SetTrajSampleMode,
    ) -> Result<(), Error> {}
    /// Reads whether a trajectory is being recorded.
    pub fn get_traj_sample_status(
        &mut self,
    ) -> Result<self::trajectory::GetTrajSampleStatusReply, Error> {}
    /// Reads the names of the trajectory files on the controller.
    pub fn get_exist_traj_file_name(
        &mut self,
    ) -> Result<self::trajectory::GetExistTrajFileNameReply, Error> {}
    /// Renames a trajectory file.
    pub fn rename_traj_file_name(
        &mut self,
        request: &self::trajectory::RenameTrajFileName,
    ) -> Result<(), Error> {}
    /// Deletes a trajectory file.
    pub fn remove_traj_file(
        &mut self,
        file_name: impl Into<String>,
    ) -> Result<(), Error> {}
    /// Writes a program for the controller from a trajectory file.
    pub fn generate_traj_exe_file(
        &mut self,
        file_name: impl Into<String>,
    ) -> Result<(), Error> {}
}
/// # Force control and drag mode
///
/// With the messages of [`force`](crate::force).
impl Client {
    /// Switches drag mode on or off.
    pub fn set_torque_control(
        &mut self,
        enable_flag: self::types::Switch,
    ) -> Result<(), Error> {}
    /// Reads whether the robot is in drag mode.
    pub fn drag_status(&mut self) -> Result<self::force::DragStatusReply, Error> {}
    /// Sets the brand of the torque sensor.
    pub fn set_torque_sensor_brand(
        &mut self,
        brand: self::force::TorqueSensorBrand,
    ) -> Result<(), Error> {}
    /// Reads the brand of the torque sensor.
    pub fn get_torque_sensor_brand(
        &mut self,
    ) -> Result<self::force::GetTorqueSensorBrandReply, Error> {}
    /// Sets the parameters of admittance control for one axis.
    pub fn set_admit_ctrl_config(
        &mut self,
        request: &self::force::SetAdmitCtrlConfig,
    ) -> Result<(), Error> {}
    /// Reads the parameters of admittance control for all axes.
    pub fn get_admit_ctrl_config(
        &mut self,
    ) -> Result<self::force::GetAdmitCtrlConfigReply, Error> {}
    /// Switches the torque sensor on or off.
    pub fn set_torque_sensor_mode(&mut self, mode: i64) -> Result<(), Error> {}
    /// Moves the arm to a joint position to identify the payload at the end of the tool.
    pub fn start_torq_sensor_payload_identify(
        &mut self,
        joint_position: impl Into<self::types::JointPosition>,
    ) -> Result<(), Error> {}
    /// Reads how far the identification of the payload is.
    pub fn get_torq_sensor_identify_status(
        &mut self,
    ) -> Result<self::force::GetTorqSensorIdentifyStatusReply, Error> {}
    /// Reads the payload that the identification found.
    pub fn get_torq_sensor_payload_identify_result(
        &mut self,
    ) -> Result<self::force::GetTorqSensorPayloadIdentifyResultReply, Error> {}
    /// Sets the mass and the centroid of the payload at the torque sensor.
    pub fn set_tool_payload(
        &mut self,
        request: &self::force::SetToolPayload,
    ) -> Result<(), Error> {}
    /// Reads the mass and the centroid of the payload at the torque sensor.
    pub fn get_tool_payload(
        &mut self,
    ) -> Result<self::force::GetToolPayloadReply, Error> {}
    /// Sets the forces and torques that are the condition for compliant control.
    pub fn set_compliance_condition(
        &mut self,
        request: &self::force::SetComplianceCondition,
    ) -> Result<(), Error> {}
    /// Switches admittance control on or off.
    pub fn enable_admittance_ctrl(
        &mut self,
        enable_flag: self::types::Switch,
    ) -> Result<(), Error> {}
    /// Reads the type of force control, and whether the sensor is compensated.
    pub fn get_compliant_type(
        &mut self,
    ) -> Result<self::force::GetCompliantTypeReply, Error> {}
    /// Sets the type of force control, and whether the sensor is compensated.
    pub fn set_compliant_type(
        &mut self,
        request: &self::force::SetCompliantType,
    ) -> Result<(), Error> {}
    /// Sets how the controller reaches the torque sensor.
    pub fn set_torque_sensor_comm(
        &mut self,
        request: &self::force::SetTorqueSensorComm,
    ) -> Result<(), Error> {}
    /// Reads how the controller reaches the torque sensor.
    pub fn get_torque_sensor_comm(
        &mut self,
    ) -> Result<self::force::GetTorqueSensorCommReply, Error> {}
    /// Switches force control off.
    pub fn disable_force_control(&mut self) -> Result<(), Error> {}
    /// Sets the parameters of compliance in velocity.
    pub fn set_vel_compliant_ctrl(
        &mut self,
        compliance: self::force::VelocityCompliance,
    ) -> Result<(), Error> {}
}
/// # Lost network
///
/// With the messages of [`network`](crate::network).
impl Client {
    /// Sets what the arm does when the network fails, and how long after the failure.
    pub fn set_network_exception_handle(
        &mut self,
        request: &self::network::SetNetworkExceptionHandle,
    ) -> Result<(), Error> {}
}
/// # The connection
///
/// With the messages of [`session`](crate::session).
impl Client {
    /// Ends the connection.
    pub fn quit(&mut self) -> Result<(), Error> {}
}
/// # State and positions, beyond the document
///
/// With the messages of [`beyond_state`](crate::beyond_state).
impl Client {
    /// Reads one status packet on the command port.
    pub fn get_data(&mut self) -> Result<self::status::RobotStatus, Error> {}
    /// Reads how the motions stand that were sent.
    pub fn get_motion_state(
        &mut self,
    ) -> Result<self::beyond_state::GetMotionStateReply, Error> {}
    /// Reads whether the robot is in an emergency stop.
    pub fn emergency_stop_status(
        &mut self,
    ) -> Result<self::beyond_state::EmergencyStopStatusReply, Error> {}
    /// Reads whether a soft limit was hit.
    pub fn is_on_limit(&mut self) -> Result<self::beyond_state::IsOnLimitReply, Error> {}
    /// Reads whether the robot is in drag mode, by the name.
    pub fn get_drag_status(
        &mut self,
    ) -> Result<self::beyond_state::GetDragStatusReply, Error> {}
    /// Reads the speed rate, by the name.
    pub fn get_rapid_rate(
        &mut self,
    ) -> Result<self::beyond_state::GetRapidRateReply, Error> {}
    /// Reads the id of the selected tool frame.
    pub fn get_curr_tool_id(
        &mut self,
    ) -> Result<self::beyond_state::GetCurrToolIdReply, Error> {}
    /// Reads the id of the selected user frame.
    pub fn get_curr_user_id(
        &mut self,
    ) -> Result<self::beyond_state::GetCurrUserIdReply, Error> {}
    /// Reads the actual positions of the six joints.
    pub fn get_actual_joint_pos(
        &mut self,
    ) -> Result<self::beyond_state::GetActualJointPosReply, Error> {}
    /// Reads the actual pose of the tool centre point.
    pub fn get_actual_tcp_pos(
        &mut self,
    ) -> Result<self::beyond_state::GetActualTcpPosReply, Error> {}
}
/// # Inputs, outputs and the tool's serial channels, beyond the document
///
/// With the messages of [`beyond_io`](crate::beyond_io).
impl Client {
    /// Reads one digital output.
    pub fn get_digital_output(
        &mut self,
        request: &self::beyond_io::GetDigitalOutput,
    ) -> Result<self::beyond_io::GetDigitalOutputReply, Error> {}
    /// Reads one digital input.
    pub fn get_digital_input(
        &mut self,
        request: &self::beyond_io::GetDigitalInput,
    ) -> Result<self::beyond_io::GetDigitalInputReply, Error> {}
    /// Reads one analog output.
    pub fn get_analog_output(
        &mut self,
        request: &self::beyond_io::GetAnalogOutput,
    ) -> Result<self::beyond_io::GetAnalogOutputReply, Error> {}
    /// Reads one analog input.
    pub fn get_analog_input(
        &mut self,
        request: &self::beyond_io::GetAnalogInput,
    ) -> Result<self::beyond_io::GetAnalogInputReply, Error> {}
    /// Sends bytes on a serial channel of the tool.
    pub fn send_tio_rs_command(
        &mut self,
        request: &self::beyond_io::SendTioRsCommand,
    ) -> Result<(), Error> {}
    /// Reads the use of the tool's pins.
    pub fn get_tio_pin_mode(
        &mut self,
        pin_type: self::beyond_io::ToolPinType,
    ) -> Result<self::beyond_io::GetTioPinModeReply, Error> {}
    /// Sets the use of the tool's pins.
    pub fn set_tio_pin_mode(
        &mut self,
        request: &self::beyond_io::SetTioPinMode,
    ) -> Result<(), Error> {}
    /// Reads the mode of a serial channel of the tool.
    pub fn get_rs485_chn_mode(
        &mut self,
        channel: self::beyond_io::SerialChannel,
    ) -> Result<self::beyond_io::GetRs485ChnModeReply, Error> {}
    /// Sets the mode of a serial channel of the tool.
    pub fn set_rs485_chn_mode(
        &mut self,
        request: &self::beyond_io::SetRs485ChnMode,
    ) -> Result<(), Error> {}
    /// Reads the line settings of a serial channel of the tool.
    pub fn get_rs485_chn_comm(
        &mut self,
        channel: self::beyond_io::SerialChannel,
    ) -> Result<self::beyond_io::GetRs485ChnCommReply, Error> {}
    /// Sets the line of a serial channel of the tool.
    pub fn set_rs485_chn_comm(
        &mut self,
        request: &self::beyond_io::SetRs485ChnComm,
    ) -> Result<(), Error> {}
    /// Reads the signals that are defined on the tool's serial channels.
    pub fn get_rs485_signal_list(&mut self) -> Result<::jaka_proto::wire::Value, Error> {}
    /// Reads the signals that are defined on the tool's serial channels, with their values.
    pub fn get_tio_signals(
        &mut self,
    ) -> Result<self::beyond_io::GetTioSignalsReply, Error> {}
    /// Defines a signal on a serial channel of the tool; there are at most 8.
    pub fn add_tio_rs_signal(
        &mut self,
        request: &self::beyond_io::AddTioRsSignal,
    ) -> Result<(), Error> {}
    /// Removes a signal from a serial channel of the tool.
    pub fn delete_tio_rs_signal(
        &mut self,
        name: impl Into<String>,
    ) -> Result<(), Error> {}
}
/// # Motion, mounting and packets, beyond the document
///
/// With the messages of [`beyond_settings`](crate::beyond_settings).
impl Client {
    /// Sets a feed-forward of the joints' torques, as currents by its name. It belongs to the torque control mode.
    pub fn torque_feedforward(
        &mut self,
        request: &self::beyond_settings::TorqueFeedforward,
    ) -> Result<(), Error> {}
    /// Sets the kind of planner that drives motions.
    pub fn set_motion_planner(
        &mut self,
        planner: self::beyond_settings::MotionPlanner,
    ) -> Result<(), Error> {}
    /// Sets how far from singularities and joint limits the controller warns.
    pub fn set_motion_limit_warning_range(&mut self, level: i64) -> Result<(), Error> {}
    /// Reads how far from singularities and joint limits the controller warns.
    pub fn get_motion_limit_warning_range(
        &mut self,
    ) -> Result<self::beyond_settings::GetMotionLimitWarningRangeReply, Error> {}
    /// Sets how the arm is mounted.
    pub fn set_installation_angle(
        &mut self,
        request: &self::beyond_settings::SetInstallationAngle,
    ) -> Result<(), Error> {}
    /// Reads how the arm is mounted.
    pub fn get_installation_angle(
        &mut self,
    ) -> Result<::jaka_proto::wire::Value, Error> {}
    /// Sets the filter of the torque sensor.
    pub fn set_torque_sensor_filter(&mut self, filter: f64) -> Result<(), Error> {}
    /// Sets the frame of force control.
    pub fn set_ft_ctrl_frame(&mut self, frame: i64) -> Result<(), Error> {}
    /// Takes the present reading of the torque sensor as its zero, by the name.
    pub fn zero_end_sensor(&mut self) -> Result<(), Error> {}
    /// Sets the time between two packets of port 10000.
    pub fn set_port10000_delay_ms(&mut self, delay: i64) -> Result<(), Error> {}
    /// Reads the time between two packets of port 10000.
    pub fn get_port10000_delay_ms(
        &mut self,
    ) -> Result<self::beyond_settings::GetPort10000DelayMsReply, Error> {}
    /// Sets an entry of the controller's configuration of port 10000.
    pub fn set_optional_info_config(
        &mut self,
        request: &self::beyond_settings::SetOptionalInfoConfig,
    ) -> Result<(), Error> {}
    /// Reads an entry of the controller's configuration of port 10000: see [`set_optional_info_config`](crate::Client::set_optional_info_config).
    pub fn get_optional_info_config(
        &mut self,
        request: &self::beyond_settings::GetOptionalInfoConfig,
    ) -> Result<self::beyond_settings::GetOptionalInfoConfigReply, Error> {}
}
