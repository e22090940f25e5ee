use jaka_proto::messages::{
    Request, power::*, motion::*, servo::*, program::*, io::*, frames::*, variables::*,
    payload::*, collision::*, kinematics::*, trajectory::*, force::*, network::*,
    session::*, beyond_state::*, beyond_io::*, beyond_settings::*, status::*, types::*,
};
/// Requests of the calls in the docs of jaka-sync, each after its message.
pub(super) fn calls() -> Vec<(&'static str, Request)> {
    Vec::from([
        (
            r#"{"cmdName": "jog", "jog_mode": 0, "coord_map": 1, "jnum": 1}"#,
            Jog::stop(JogFrame::Joint, 1).into(),
        ),
        (
            r#"{"cmdName": "jog", "jog_mode": 1, "coord_map": 1, "jnum": 1, "jogvel": 30}"#,
            Jog::continuous(JogFrame::Joint, 1, 30.0).into(),
        ),
        (
            r#"{"cmdName": "jog", "jog_mode": 2, "coord_map": 1, "jnum": 3, "jogvel": 30, "poscmd": 20}"#,
            Jog::increment(JogFrame::Joint, 3, 30.0, 20.0).into(),
        ),
        (
            r#"{"cmdName": "jog", "jog_mode": 3, "coord_map": 1, "jnum": 3, "jogvel": 30, "poscmd": 20}"#,
            Jog::absolute(JogFrame::Joint, 3, 30.0, 20.0).into(),
        ),
        (
            r#"{"cmdName": "joint_move", "relFlag": 0, "jointPosition": [0, 90.5, 90.5, 0, 90.5, 0], "speed": 20.5, "accel": 20.5}"#,
            JointMove::absolute([0.0, 90.5, 90.5, 0.0, 90.5, 0.0], 20.5)
                .acceleration(20.5)
                .into(),
        ),
        (
            r#"{"cmdName": "end_move", "endPosition": [100, 200.1, 200.5, 0, 0, 0], "speed": 21.5, "accel": 31.5}"#,
            EndMove::new([100.0, 200.1, 200.5, 0.0, 0.0, 0.0], 21.5)
                .acceleration(31.5)
                .into(),
        ),
        (
            r#"{"cmdName": "moveL", "relFlag": 1, "cartPosition": [0, 0, 50, 0, 0, 0], "speed": 20, "accel": 50, "tol": 0.5}"#,
            MoveL::relative([0.0, 0.0, 50.0, 0.0, 0.0, 0.0], 20.0)
                .acceleration(50.0)
                .tolerance(0.5)
                .into(),
        ),
        (
            r#"{"cmdName": "movc", "relFlag": 0, "pos_mid": [-450,60,440,180,0,90], "pos_end": [-430,110,440,180,0,90], "speed": 100, "accel": 500, "tol": 0.5}"#,
            MoveC::absolute(
                    [-450.0, 60.0, 440.0, 180.0, 0.0, 90.0],
                    [-430.0, 110.0, 440.0, 180.0, 0.0, 90.0],
                    100.0,
                    500.0,
                    0.5,
                )
                .into(),
        ),
        (
            r#"{"cmdName":"servo_move","relFlag":0}"#,
            SetServoMode::new(Switch::Off).into(),
        ),
        (
            r#"{"cmdName":"servo_j","relFlag":1,"jointPosition":[0.1,0,0,0,0,0],"stepNum":1}"#,
            ServoJ::relative([0.1, 0.0, 0.0, 0.0, 0.0, 0.0]).step_count(1).into(),
        ),
        (
            r#"{"cmdName": "servo_p", "catPosition": [-458.6,13.9,443.8,179.4,1.2,96.8], "relFlag": 0, "stepNum": 1}"#,
            ServoP::absolute([-458.6, 13.9, 443.8, 179.4, 1.2, 96.8])
                .step_count(1)
                .into(),
        ),
        (
            r#"{"cmdName":"set_servo_move_filter","filter_type":0}"#,
            SetServoMoveFilter::disabled().into(),
        ),
        (
            r#"{"cmdName":"set_servo_move_filter","filter_type":1,"lpf_cf":0.5}"#,
            SetServoMoveFilter::joint_low_pass(0.5).into(),
        ),
        (
            r#"{"cmdName":"set_servo_move_filter","filter_type":2,"nlf_max_vr":2,"nlf_max_ar":2,"nlf_max_jr":4}"#,
            SetServoMoveFilter::joint_nonlinear(2.0, 2.0, 4.0).into(),
        ),
        (
            r#"{"cmdName":"set_servo_move_filter","filter_type":3,"mmf_max_buf":20,"mmf_kp":0.1,"mmf_kv":0.2,"mmf_ka":0.6}"#,
            SetServoMoveFilter::joint_mean(20, 0.1, 0.2, 0.6).into(),
        ),
        (
            r#"{"cmdName":"set_servo_move_filter","filter_type":4,"nlf_max_vr":2,"nlf_max_ar":2,"nlf_max_jr":4,"nlf_max_vp":10,"nlf_max_ap":100,"nlf_max_jp":200}"#,
            SetServoMoveFilter::cartesian_nonlinear(2.0, 2.0, 4.0, 10.0, 100.0, 200.0)
                .into(),
        ),
        (
            r#"{"cmdName":"set_servo_move_filter","filter_type":5,"mmf_max_buf":20,"mmf_kp":0.1}"#,
            SetServoMoveFilter::speed_lookahead(20, 0.1).into(),
        ),
        (
            r#"{"cmdName": "rapid_rate", "rate_value": 0.2}"#,
            SetRapidRate::new(0.2).into(),
        ),
        (
            r#"{"cmdName": "load_program", "programName": "track/test.jks"}"#,
            LoadProgram::new("track/test.jks").into(),
        ),
        (
            r#"{"cmdName": "set_digital_output", "type": 0, "index": 1, "value": 1}"#,
            SetDigitalOutput::cabinet(1, Switch::On).into(),
        ),
        (
            r#"{"cmdName":"set_analog_output","type":0,"index":7,"value":4.32}"#,
            SetAnalogOutput::cabinet(7, 4.32).into(),
        ),
        (
            r#"{"cmdName": "set_tio_vout_param", "tio_vout_ena": 0, "tio_vout_vol": 0}"#,
            SetTioVoutParam::new(0, 0).into(),
        ),
        (
            r#"{"cmdName":"set_tool_offsets","tooloffset":[10,10,10,10,10,10],"id":2,"name":"tcp_new"}"#,
            SetToolOffsets::new([10.0, 10.0, 10.0, 10.0, 10.0, 10.0], 2, "tcp_new")
                .into(),
        ),
        (r#"{"cmdName":"set_tool_id","tool_id":2}"#, SetToolId::new(2).into()),
        (
            r#"{"cmdName":"set_user_offsets","userffset":[10,10,10,10,10,10],"id":2,"name":"user_new"}"#,
            SetUserOffsets::new([10.0, 10.0, 10.0, 10.0, 10.0, 10.0], 2, "user_new")
                .into(),
        ),
        (r#"{"cmdName": "set_user_id", "user_frame_id": 2}"#, SetUserId::new(2).into()),
        (
            r#"{"cmdName": "modify_user_defined_variable", "id_new": 5500, "alias_new": "s_new", "value_new": 14}"#,
            ModifyUserDefinedVariable::new(5500, "s_new", 14.0).into(),
        ),
        (
            r#"{"cmdName":"set_payload","mass":1,"centroid":[10,10,10]}"#,
            SetPayload::new(1.0, [10.0, 10.0, 10.0]).into(),
        ),
        (
            r#"{"cmdName":"set_clsn_sensitivity","sensitivityVal":3}"#,
            SetClsnSensitivity::new(3).into(),
        ),
        (
            r#"{"cmdName":"kine_forward","jointPosition":[12.35,85.2,94.31,91,-88.75,5.5]}"#,
            KineForward::new([12.35, 85.2, 94.31, 91.0, -88.75, 5.5]).into(),
        ),
        (
            r#"{"cmdName": "kine_inverse", "jointPosition": [12.35,85.2,94.31,91,-88.75,5.5], "cartPosition": [-458.62,13.97,443.79,179.37,1.19,96.84]}"#,
            KineInverse::new(
                    [12.35, 85.2, 94.31, 91.0, -88.75, 5.5],
                    [-458.62, 13.97, 443.79, 179.37, 1.19, 96.84],
                )
                .into(),
        ),
        (
            r#"{"cmdName": "set_traj_config", "acc": 100, "vel": 20, "xyz_interval": 0.1, "rpy_interval": 0.1}"#,
            SetTrajConfig::new(100.0, 20.0, 0.1, 0.1).into(),
        ),
        (
            r#"{"cmdName": "set_traj_sample_mode", "mode": 1, "filename": "test"}"#,
            SetTrajSampleMode::new(Switch::On, "test").into(),
        ),
        (
            r#"{"cmdName": "rename_traj_file_name", "src": "test", "dest": "test_rename"}"#,
            RenameTrajFileName::new("test", "test_rename").into(),
        ),
        (
            r#"{"cmdName":"remove_traj_file","fileName":"test"}"#,
            RemoveTrajFile::new("test").into(),
        ),
        (
            r#"{"cmdName":"generate_traj_exe_file","fileName":"test_rename"}"#,
            GenerateTrajExeFile::new("test_rename").into(),
        ),
        (
            r#"{"cmdName": "torque_control_enable", "enable_flag": 0}"#,
            SetTorqueControl::new(Switch::Off).into(),
        ),
        (
            r#"{"cmdName":"set_torsenosr_brand","sensor_brand":1}"#,
            SetTorqueSensorBrand::new(TorqueSensorBrand::Sony).into(),
        ),
        (
            r#"{"cmdName":"set_admit_ctrl_config","axis":2,"opt":1,"ftUser":25,"ftConstant":5,"ftNnormalTrack":0,"ftReboundFK":0}"#,
            SetAdmitCtrlConfig::new(CartesianAxis::Z, Switch::On, 25.0, 5.0, 0, 0.0)
                .into(),
        ),
        (
            r#"{"cmdName":"set_torque_sensor_mode","sensor_mode":0}"#,
            SetTorqueSensorMode::new(0).into(),
        ),
        (
            r#"{"cmdName":"start_torq_sensor_payload_identify","jointPosition":[12.35,85.2,94.31,1,1.25,95.5]}"#,
            StartTorqSensorPayloadIdentify::new([12.35, 85.2, 94.31, 1.0, 1.25, 95.5])
                .into(),
        ),
        (
            r#"{"cmdName": "set_tool_payload", "mass": 1, "centroid": [10, 10, 10]}"#,
            SetToolPayload::new(1.0, [10.0, 10.0, 10.0]).into(),
        ),
        (
            r#"{"cmdName": "set_compliance_condition", "compliant_condition": [0, 0, 0, 0, 0, 0]}"#,
            SetComplianceCondition::new([0.0, 0.0, 0.0, 0.0, 0.0, 0.0]).into(),
        ),
        (
            r#"{"cmdName": "enable_admittance_ctrl", "enable_flag": 1}"#,
            EnableAdmittanceCtrl::new(Switch::On).into(),
        ),
        (
            r#"{"cmdName": "set_compliant_type", "sensor_compensation": 1, "compliance_type": 1}"#,
            SetCompliantType::new(Switch::On, ComplianceType::ConstantForce).into(),
        ),
        (
            r#"{"cmdName": "set_torque_sensor_comm", "type": 0, "ip_addr": "172.30.1.110", "port": 55555}"#,
            SetTorqueSensorComm::new(
                    TorqueSensorCommunication::TcpIp,
                    "172.30.1.110",
                    55555,
                )
                .into(),
        ),
        (
            r#"{"cmdName": "set_vel_compliant_ctrl", "compliant_ctrl": [1, 0.5, 0.2, 0, 0]}"#,
            SetVelCompliantCtrl::new(VelocityCompliance::new(1, 0.5, 0.2, 0.0, 0.0))
                .into(),
        ),
        (
            r#"{"cmdName": "set_network_exception_handle", "timeLimit": 100, "motType": 0}"#,
            SetNetworkExceptionHandle::new(100, NetworkExceptionAction::Keep).into(),
        ),
        (
            r#"{"cmdName":"get_digital_output","type":0,"index":1}"#,
            GetDigitalOutput::cabinet(1).into(),
        ),
        (
            r#"{"cmdName":"get_digital_input","type":0,"index":1}"#,
            GetDigitalInput::new(0, 1).into(),
        ),
        (
            r#"{"cmdName":"get_analog_output","type":0,"index":1}"#,
            GetAnalogOutput::cabinet(1).into(),
        ),
        (
            r#"{"cmdName":"get_analog_input","type":0,"index":1}"#,
            GetAnalogInput::new(0, 1).into(),
        ),
        (
            r#"{"cmdName":"send_tio_rs_command","chn_id":1,"cmdBuf":[1,3,0,0,0,1]}"#,
            SendTioRsCommand::new(SerialChannel::Rs485L, vec![1, 3, 0, 0, 0, 1]).into(),
        ),
        (
            r#"{"cmdName":"get_tio_pin_mode","pinType":0}"#,
            GetTioPinMode::new(ToolPinType::DigitalInputs).into(),
        ),
        (
            r#"{"cmdName":"set_tio_pin_mode","pinType":0,"pinMode":0}"#,
            SetTioPinMode::new(ToolPinType::DigitalInputs, 0).into(),
        ),
        (
            r#"{"cmdName":"get_rs485_chn_mode","chnId":1}"#,
            GetRs485ChnMode::new(SerialChannel::Rs485L).into(),
        ),
        (
            r#"{"cmdName":"set_rs485_chn_mode","chnId":1,"chnMode":0}"#,
            SetRs485ChnMode::new(SerialChannel::Rs485L, SerialChannelMode::ModbusRtu)
                .into(),
        ),
        (
            r#"{"cmdName":"get_rs485_chn_comm","chn_id":1}"#,
            GetRs485ChnComm::new(SerialChannel::Rs485L).into(),
        ),
        (
            r#"{"cmdName":"set_rs485_chn_comm","chn_id":1,"slaveId":1,"baudrate":115200,"databit":8,"stopbit":1,"parity":78}"#,
            SetRs485ChnComm::new(
                    SerialChannel::Rs485L,
                    1,
                    115200,
                    8,
                    1,
                    SerialParity::None,
                )
                .into(),
        ),
        (
            r#"{"cmdName":"add_tio_rs_signal","tio_signal_name":"force","tio_signal_chnId":1,"tio_signal_sigType":0,"tio_signal_sigAddr":1,"frequency":10}"#,
            AddTioRsSignal::new("force", SerialChannel::Rs485L, 0, 1, 10.0).into(),
        ),
        (
            r#"{"cmdName":"del_tio_rs_signal","tio_signal_name":"force"}"#,
            DeleteTioRsSignal::new("force").into(),
        ),
        (
            r#"{"cmdName":"torque_feedforward","grvCurrent":[0,0,0,0,0,0],"includeGrvFlag":0}"#,
            TorqueFeedforward::new(
                    [0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
                    TorqueFeedforwardMode::Controller,
                )
                .into(),
        ),
        (
            r#"{"cmdName":"set_motion_planner","type":1}"#,
            SetMotionPlanner::new(MotionPlanner::S).into(),
        ),
        (
            r#"{"cmdName":"set_motion_limit_warning_range","range_level":3}"#,
            SetMotionLimitWarningRange::new(3).into(),
        ),
        (
            r#"{"cmdName":"set_installation_angle","angleX":0,"angleZ":0}"#,
            SetInstallationAngle::new(0.0, 0.0).into(),
        ),
        (
            r#"{"cmdName":"set_torque_sensor_filter","torqueSensorFilter":10}"#,
            SetTorqueSensorFilter::new(10.0).into(),
        ),
        (
            r#"{"cmdName":"set_ft_ctrl_frame","ftFrame":0}"#,
            SetFtCtrlFrame::new(0).into(),
        ),
        (
            r#"{"cmdName":"set_port10000_delay_ms","port10000_delay_ms":50}"#,
            SetPort10000DelayMs::new(50).into(),
        ),
        (
            r#"{"cmdName":"getOptionalInfoConfig","section":"PORTCONFIG","key":"port10000_delay_ms"}"#,
            GetOptionalInfoConfig::new("PORTCONFIG", "port10000_delay_ms").into(),
        ),
    ])
}
