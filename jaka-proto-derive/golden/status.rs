/// Status packet of port 10000.
///
/// What the controller sends on port 10000, again and again, without being asked.
///
/// The packets follow each other without anything between them: about every 30 ms on firmware 1.5.14, every 50 or 100 ms
/// elsewhere (field notes). Keys may be missing, newer firmware adds some, and lengths of arrays differ.
///
/// The document explains the keys up to `current_user_id`, and prints only a value or a length of those behind it.
pub mod status {
    #[allow(unused_imports)]
    use ::jaka_proto::{self as proto, check, wire};
    /// State of the robot, as one packet of port 10000 gives it.
    ///
    /// Any key may be absent. A refused command on port 10001 does not show here.
    #[derive(Debug, Clone, PartialEq, Default)]
    #[non_exhaustive]
    pub struct RobotStatus {
        /// Length of the packet, itself included. In bytes.
        ///
        /// The document says that packets are at most 5000 bytes as a rule; 9 KB have been seen, and newer firmware is said to send
        /// up to 15 KB (field notes).
        ///
        /// `len` on the wire.
        #[doc(alias = "len")]
        pub length: Option<i64>,
        /// Whether the robot is in drag mode.
        pub drag_status: Option<bool>,
        /// Configuration and state of the extension I/O modules. Absent on firmware 1.5.14.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub extio: Option<wire::Typed<ExtioReport>>,
        /// Code of the controller's event, which is not always an error: a hexadecimal number such as `0x0`, which says that there is none.
        ///
        /// `0x10f0005`, say, is the information that the robot is disabled, and may be of an event that is over. `ControllerEvent` of the
        /// Rust crates reads the code and knows the severity.
        ///
        /// `errcode` on the wire.
        #[doc(alias = "errcode")]
        pub error_code: Option<String>,
        /// Message of the controller for `error_code`.
        ///
        /// `errmsg` on the wire.
        #[doc(alias = "errmsg")]
        pub error_message: Option<String>,
        /// Measurements in the cabinet and the joints, for diagnosis.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub monitor_data: Option<wire::Typed<MonitorData>>,
        /// Settings and state of the torque sensor.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        ///
        /// `torqsensor` on the wire.
        #[doc(alias = "torqsensor")]
        pub torque_sensor: Option<wire::Typed<TorqueSensorReport>>,
        /// Actual positions of the six joints.
        pub joint_actual_position: Option<super::types::JointPosition>,
        /// Actual pose of the tool centre point in Cartesian space.
        pub actual_position: Option<super::types::Pose>,
        /// All digital inputs. 135, 136, 144 or 200, depending on the firmware.
        ///
        /// `din` on the wire.
        #[doc(alias = "din")]
        pub digital_inputs: Option<Vec<bool>>,
        /// All digital outputs of the cabinet. The document prints 144.
        ///
        /// `dout` on the wire.
        #[doc(alias = "dout")]
        pub digital_outputs: Option<Vec<bool>>,
        /// All analog inputs of the cabinet. 64, 66 or 128, depending on the firmware. Unit not stated.
        ///
        /// `ain` on the wire.
        #[doc(alias = "ain")]
        pub analog_inputs: Option<Vec<f64>>,
        /// All analog outputs of the cabinet. The document prints 66. Unit not stated.
        ///
        /// `aout` on the wire.
        #[doc(alias = "aout")]
        pub analog_outputs: Option<Vec<f64>>,
        /// All digital inputs of the tool. The document prints 8.
        ///
        /// `tio_din` on the wire.
        #[doc(alias = "tio_din")]
        pub tool_digital_inputs: Option<Vec<bool>>,
        /// All digital outputs of the tool. The document prints 8.
        ///
        /// `tio_dout` on the wire.
        #[doc(alias = "tio_dout")]
        pub tool_digital_outputs: Option<Vec<bool>>,
        /// All analog inputs of the tool. 1 or 2, depending on the firmware. Unit not stated.
        ///
        /// `tio_ain` on the wire.
        #[doc(alias = "tio_ain")]
        pub tool_analog_inputs: Option<Vec<f64>>,
        /// Whether the robot has power and is enabled.
        pub task_state: Option<TaskState>,
        /// Whether each joint is homed. Withdrawn.
        ///
        /// The document prints the length 9 and no element.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub homed: Option<wire::Typed<Vec<bool>>>,
        /// Task mode of the robot.
        pub task_mode: Option<TaskMode>,
        /// State of the program.
        ///
        /// `interp_state` on the wire.
        #[doc(alias = "interp_state")]
        pub interpreter_state: Option<InterpreterState>,
        /// Whether the robot is enabled.
        pub enabled: Option<bool>,
        /// Whether the program is paused.
        pub paused: Option<bool>,
        /// Rate by which motions are scaled; 1 in the document's sample.
        ///
        /// `rapidrate` on the wire.
        #[doc(alias = "rapidrate")]
        pub rapid_rate: Option<f64>,
        /// Index of the present tool frame.
        pub current_tool_id: Option<i64>,
        /// Index of the present user frame.
        ///
        /// `current_user_id` on the wire.
        #[doc(alias = "current_user_id")]
        pub current_user_frame_id: Option<i64>,
        /// Whether a soft limit is reached, by the key's name; passed on as it is.
        ///
        /// The document does not explain it, and prints 1 in its sample, for a robot that is enabled and in position.
        pub on_soft_limit: Option<i64>,
        /// Whether the robot is in an emergency stop, by the key's name. The document does not explain it.
        pub emergency_stop: Option<bool>,
        /// Not explained. The document prints the length 6 and no element.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub drag_near_limit: Option<wire::Typed<Vec<i64>>>,
        /// The input of each function.
        ///
        /// The document prints only the length, 15; 12 and 13 have been seen too. `get_funcdi_status` names the
        /// functions, and the shape of an entry is taken from there.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        ///
        /// `funcdi` on the wire.
        #[doc(alias = "funcdi")]
        pub function_inputs: Option<wire::Typed<Vec<super::io::FunctionInput>>>,
        /// Whether the robot has power, by the key's name. The document does not explain it.
        pub powered_on: Option<bool>,
        /// Whether the robot is in position, by the key's name. The document does not explain it.
        ///
        /// It stays true for some 100 ms after a motion is accepted, and a motion of length zero may never drop it (field notes).
        ///
        /// `inpos` on the wire.
        #[doc(alias = "inpos")]
        pub in_position: Option<bool>,
        /// Not explained. The document prints 1.
        pub motion_mode: Option<i64>,
        /// Speed of the tool centre point's translation, by the key's name. In mm/s. The document does not explain it.
        ///
        /// `curr_tcp_trans_vel` on the wire.
        #[doc(alias = "curr_tcp_trans_vel")]
        pub tcp_speed: Option<f64>,
        /// Whether the robot is in a protective stop, by the key's name. The document does not explain it here.
        ///
        /// `protective_stop_status` reads the key of the same name.
        pub protective_stop: Option<bool>,
        /// Not explained. The document prints 0.
        pub point_key: Option<i64>,
        /// Not explained. The document prints 1.
        ///
        /// `netState` on the wire.
        #[doc(alias = "netState")]
        pub network_state: Option<i64>,
        /// Commanded positions of the six joints. Sent by newer firmware.
        ///
        /// `joint_position` on the wire.
        #[doc(alias = "joint_position")]
        pub joint_commanded_position: Option<super::types::JointPosition>,
        /// Commanded pose of the tool centre point. Sent by newer firmware.
        ///
        /// `position` on the wire.
        #[doc(alias = "position")]
        pub commanded_position: Option<super::types::Pose>,
        /// Keys at the tool, by the name; 3 of them. Sent by newer firmware, not explained.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        ///
        /// `tio_key` on the wire.
        #[doc(alias = "tio_key")]
        pub tool_keys: Option<wire::Typed<Vec<i64>>>,
        /// Instantaneous velocities, by the name; 6 of them. Sent by newer firmware, not explained. Unit not stated.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        ///
        /// `instVel` on the wire.
        #[doc(alias = "instVel")]
        pub instantaneous_velocities: Option<wire::Typed<Vec<f64>>>,
        /// Relays, by the name; 2 of them. Sent by newer firmware, not explained.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        ///
        /// `relay_io` on the wire.
        #[doc(alias = "relay_io")]
        pub relay_outputs: Option<wire::Typed<Vec<bool>>>,
        /// Digital inputs of the Modbus slave, by the name. Sent by newer firmware, not explained.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        ///
        /// `mb_slave_din` on the wire.
        #[doc(alias = "mb_slave_din")]
        pub modbus_slave_digital_inputs: Option<wire::Typed<Vec<bool>>>,
        /// Digital outputs of the Modbus slave, by the name. Sent by newer firmware, not explained.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        ///
        /// `mb_slave_dout` on the wire.
        #[doc(alias = "mb_slave_dout")]
        pub modbus_slave_digital_outputs: Option<wire::Typed<Vec<bool>>>,
        /// Analog inputs of the Modbus slave, by the name. Sent by newer firmware, not explained.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        ///
        /// `mb_slave_ain` on the wire.
        #[doc(alias = "mb_slave_ain")]
        pub modbus_slave_analog_inputs: Option<wire::Typed<Vec<f64>>>,
        /// Analog outputs of the Modbus slave, by the name. Sent by newer firmware, not explained.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        ///
        /// `mb_slave_aout` on the wire.
        #[doc(alias = "mb_slave_aout")]
        pub modbus_slave_analog_outputs: Option<wire::Typed<Vec<f64>>>,
        /// Digital inputs of the Profinet device, by the name. Sent by newer firmware, not explained.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        ///
        /// `pn_dev_din` on the wire.
        #[doc(alias = "pn_dev_din")]
        pub profinet_device_digital_inputs: Option<wire::Typed<Vec<bool>>>,
        /// Digital outputs of the Profinet device, by the name. Sent by newer firmware, not explained.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        ///
        /// `pn_dev_dout` on the wire.
        #[doc(alias = "pn_dev_dout")]
        pub profinet_device_digital_outputs: Option<wire::Typed<Vec<bool>>>,
        /// Analog inputs of the Profinet device, by the name. Sent by newer firmware, not explained.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        ///
        /// `pn_dev_ain` on the wire.
        #[doc(alias = "pn_dev_ain")]
        pub profinet_device_analog_inputs: Option<wire::Typed<Vec<f64>>>,
        /// Analog outputs of the Profinet device, by the name. Sent by newer firmware, not explained.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        ///
        /// `pn_dev_aout` on the wire.
        #[doc(alias = "pn_dev_aout")]
        pub profinet_device_analog_outputs: Option<wire::Typed<Vec<f64>>>,
        /// Digital inputs of the EtherNet/IP adapter, by the name. Sent by newer firmware, not explained.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        ///
        /// `eip_adpt_din` on the wire.
        #[doc(alias = "eip_adpt_din")]
        pub ethernet_ip_adapter_digital_inputs: Option<wire::Typed<Vec<bool>>>,
        /// Digital outputs of the EtherNet/IP adapter, by the name. Sent by newer firmware, not explained.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        ///
        /// `eip_adpt_dout` on the wire.
        #[doc(alias = "eip_adpt_dout")]
        pub ethernet_ip_adapter_digital_outputs: Option<wire::Typed<Vec<bool>>>,
        /// Analog inputs of the EtherNet/IP adapter, by the name. Sent by newer firmware, not explained.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        ///
        /// `eip_adpt_ain` on the wire.
        #[doc(alias = "eip_adpt_ain")]
        pub ethernet_ip_adapter_analog_inputs: Option<wire::Typed<Vec<f64>>>,
        /// Analog outputs of the EtherNet/IP adapter, by the name. Sent by newer firmware, not explained.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        ///
        /// `eip_adpt_aout` on the wire.
        #[doc(alias = "eip_adpt_aout")]
        pub ethernet_ip_adapter_analog_outputs: Option<wire::Typed<Vec<f64>>>,
        /// Serial signals at the tool, by the name; 8 of them. Sent by newer firmware; shape not known.
        ///
        /// `tio_rs_signals` on the wire.
        #[doc(alias = "tio_rs_signals")]
        pub tool_rs_signals: Option<wire::Value>,
        /// A line that belongs to a motion, by the name. Sent by newer firmware, not explained.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub motion_line: Option<wire::Typed<i64>>,
        /// A line that belongs to an error, by the name. Sent by newer firmware, not explained.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        ///
        /// `err_add_line` on the wire.
        #[doc(alias = "err_add_line")]
        pub error_add_line: Option<wire::Typed<i64>>,
    }
    impl wire::Fields for RobotStatus {
        fn write_fields(&self, out: &mut wire::Writer) {
            if let Some(value) = &self.length {
                out.key("\"len\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.drag_status {
                out.key("\"drag_status\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.extio {
                out.key("\"extio\":");
                match value {
                    wire::Typed::Known(value) => {
                        wire::Encode::encode(value, out);
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.error_code {
                out.key("\"errcode\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.error_message {
                out.key("\"errmsg\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.monitor_data {
                out.key("\"monitor_data\":");
                match value {
                    wire::Typed::Known(value) => {
                        wire::Encode::encode(value, out);
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.torque_sensor {
                out.key("\"torqsensor\":");
                match value {
                    wire::Typed::Known(value) => {
                        wire::Encode::encode(value, out);
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.joint_actual_position {
                out.key("\"joint_actual_position\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.actual_position {
                out.key("\"actual_position\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.digital_inputs {
                out.key("\"din\":");
                out.array(
                    value,
                    |out, item| {
                        out.choose(*item, "0", "1");
                    },
                );
            }
            if let Some(value) = &self.digital_outputs {
                out.key("\"dout\":");
                out.array(
                    value,
                    |out, item| {
                        out.choose(*item, "0", "1");
                    },
                );
            }
            if let Some(value) = &self.analog_inputs {
                out.key("\"ain\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.analog_outputs {
                out.key("\"aout\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.tool_digital_inputs {
                out.key("\"tio_din\":");
                out.array(
                    value,
                    |out, item| {
                        out.choose(*item, "0", "1");
                    },
                );
            }
            if let Some(value) = &self.tool_digital_outputs {
                out.key("\"tio_dout\":");
                out.array(
                    value,
                    |out, item| {
                        out.choose(*item, "0", "1");
                    },
                );
            }
            if let Some(value) = &self.tool_analog_inputs {
                out.key("\"tio_ain\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.task_state {
                out.key("\"task_state\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.homed {
                out.key("\"homed\":");
                match value {
                    wire::Typed::Known(value) => {
                        out.array(
                            value,
                            |out, item| {
                                out.choose(*item, "0", "1");
                            },
                        );
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.task_mode {
                out.key("\"task_mode\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.interpreter_state {
                out.key("\"interp_state\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.enabled {
                out.key("\"enabled\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.paused {
                out.key("\"paused\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.rapid_rate {
                out.key("\"rapidrate\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.current_tool_id {
                out.key("\"current_tool_id\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.current_user_frame_id {
                out.key("\"current_user_id\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.on_soft_limit {
                out.key("\"on_soft_limit\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.emergency_stop {
                out.key("\"emergency_stop\":");
                out.choose(*value, "0", "1");
            }
            if let Some(value) = &self.drag_near_limit {
                out.key("\"drag_near_limit\":");
                match value {
                    wire::Typed::Known(value) => {
                        wire::Encode::encode(value, out);
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.function_inputs {
                out.key("\"funcdi\":");
                match value {
                    wire::Typed::Known(value) => {
                        wire::Encode::encode(value, out);
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.powered_on {
                out.key("\"powered_on\":");
                out.choose(*value, "0", "1");
            }
            if let Some(value) = &self.in_position {
                out.key("\"inpos\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.motion_mode {
                out.key("\"motion_mode\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.tcp_speed {
                out.key("\"curr_tcp_trans_vel\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.protective_stop {
                out.key("\"protective_stop\":");
                out.choose(*value, "0", "1");
            }
            if let Some(value) = &self.point_key {
                out.key("\"point_key\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.network_state {
                out.key("\"netState\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.joint_commanded_position {
                out.key("\"joint_position\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.commanded_position {
                out.key("\"position\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.tool_keys {
                out.key("\"tio_key\":");
                match value {
                    wire::Typed::Known(value) => {
                        wire::Encode::encode(value, out);
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.instantaneous_velocities {
                out.key("\"instVel\":");
                match value {
                    wire::Typed::Known(value) => {
                        wire::Encode::encode(value, out);
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.relay_outputs {
                out.key("\"relay_io\":");
                match value {
                    wire::Typed::Known(value) => {
                        out.array(
                            value,
                            |out, item| {
                                out.choose(*item, "0", "1");
                            },
                        );
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.modbus_slave_digital_inputs {
                out.key("\"mb_slave_din\":");
                match value {
                    wire::Typed::Known(value) => {
                        out.array(
                            value,
                            |out, item| {
                                out.choose(*item, "0", "1");
                            },
                        );
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.modbus_slave_digital_outputs {
                out.key("\"mb_slave_dout\":");
                match value {
                    wire::Typed::Known(value) => {
                        out.array(
                            value,
                            |out, item| {
                                out.choose(*item, "0", "1");
                            },
                        );
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.modbus_slave_analog_inputs {
                out.key("\"mb_slave_ain\":");
                match value {
                    wire::Typed::Known(value) => {
                        wire::Encode::encode(value, out);
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.modbus_slave_analog_outputs {
                out.key("\"mb_slave_aout\":");
                match value {
                    wire::Typed::Known(value) => {
                        wire::Encode::encode(value, out);
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.profinet_device_digital_inputs {
                out.key("\"pn_dev_din\":");
                match value {
                    wire::Typed::Known(value) => {
                        out.array(
                            value,
                            |out, item| {
                                out.choose(*item, "0", "1");
                            },
                        );
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.profinet_device_digital_outputs {
                out.key("\"pn_dev_dout\":");
                match value {
                    wire::Typed::Known(value) => {
                        out.array(
                            value,
                            |out, item| {
                                out.choose(*item, "0", "1");
                            },
                        );
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.profinet_device_analog_inputs {
                out.key("\"pn_dev_ain\":");
                match value {
                    wire::Typed::Known(value) => {
                        wire::Encode::encode(value, out);
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.profinet_device_analog_outputs {
                out.key("\"pn_dev_aout\":");
                match value {
                    wire::Typed::Known(value) => {
                        wire::Encode::encode(value, out);
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.ethernet_ip_adapter_digital_inputs {
                out.key("\"eip_adpt_din\":");
                match value {
                    wire::Typed::Known(value) => {
                        out.array(
                            value,
                            |out, item| {
                                out.choose(*item, "0", "1");
                            },
                        );
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.ethernet_ip_adapter_digital_outputs {
                out.key("\"eip_adpt_dout\":");
                match value {
                    wire::Typed::Known(value) => {
                        out.array(
                            value,
                            |out, item| {
                                out.choose(*item, "0", "1");
                            },
                        );
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.ethernet_ip_adapter_analog_inputs {
                out.key("\"eip_adpt_ain\":");
                match value {
                    wire::Typed::Known(value) => {
                        wire::Encode::encode(value, out);
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.ethernet_ip_adapter_analog_outputs {
                out.key("\"eip_adpt_aout\":");
                match value {
                    wire::Typed::Known(value) => {
                        wire::Encode::encode(value, out);
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.tool_rs_signals {
                out.key("\"tio_rs_signals\":");
                wire::Encode::encode(value, out);
            }
            if let Some(value) = &self.motion_line {
                out.key("\"motion_line\":");
                match value {
                    wire::Typed::Known(value) => {
                        wire::Encode::encode(value, out);
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
            if let Some(value) = &self.error_add_line {
                out.key("\"err_add_line\":");
                match value {
                    wire::Typed::Known(value) => {
                        wire::Encode::encode(value, out);
                    }
                    wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                }
            }
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut this = Self::default();
            this.read_fields_into(reader)?;
            Ok(this)
        }
        fn read_fields_into(
            &mut self,
            reader: &mut wire::Reader<'_>,
        ) -> Result<(), wire::DecodeError> {
            let mut keys = reader
                .begin_status(
                    &[
                        "\"len\":",
                        "\"drag_status\":",
                        "\"extio\":",
                        "\"errcode\":",
                        "\"errmsg\":",
                        "\"monitor_data\":",
                        "\"torqsensor\":",
                        "\"joint_actual_position\":",
                        "\"actual_position\":",
                        "\"din\":",
                        "\"dout\":",
                        "\"ain\":",
                        "\"aout\":",
                        "\"tio_din\":",
                        "\"tio_dout\":",
                        "\"tio_ain\":",
                        "\"task_state\":",
                        "\"homed\":",
                        "\"task_mode\":",
                        "\"interp_state\":",
                        "\"enabled\":",
                        "\"paused\":",
                        "\"rapidrate\":",
                        "\"current_tool_id\":",
                        "\"current_user_id\":",
                        "\"on_soft_limit\":",
                        "\"emergency_stop\":",
                        "\"drag_near_limit\":",
                        "\"funcdi\":",
                        "\"powered_on\":",
                        "\"inpos\":",
                        "\"motion_mode\":",
                        "\"curr_tcp_trans_vel\":",
                        "\"protective_stop\":",
                        "\"point_key\":",
                        "\"netState\":",
                        "\"joint_position\":",
                        "\"position\":",
                        "\"tio_key\":",
                        "\"instVel\":",
                        "\"relay_io\":",
                        "\"mb_slave_din\":",
                        "\"mb_slave_dout\":",
                        "\"mb_slave_ain\":",
                        "\"mb_slave_aout\":",
                        "\"pn_dev_din\":",
                        "\"pn_dev_dout\":",
                        "\"pn_dev_ain\":",
                        "\"pn_dev_aout\":",
                        "\"eip_adpt_din\":",
                        "\"eip_adpt_dout\":",
                        "\"eip_adpt_ain\":",
                        "\"eip_adpt_aout\":",
                        "\"tio_rs_signals\":",
                        "\"motion_line\":",
                        "\"err_add_line\":",
                    ],
                )?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.status_field_into("length", &mut self.length, &mut keys)?,
                    1 => {
                        reader
                            .status_field_into(
                                "drag_status",
                                &mut self.drag_status,
                                &mut keys,
                            )?
                    }
                    2 => reader.status_field_into("extio", &mut self.extio, &mut keys)?,
                    3 => {
                        reader
                            .status_field_into(
                                "error_code",
                                &mut self.error_code,
                                &mut keys,
                            )?
                    }
                    4 => {
                        reader
                            .status_field_into(
                                "error_message",
                                &mut self.error_message,
                                &mut keys,
                            )?
                    }
                    5 => {
                        reader
                            .status_field_into(
                                "monitor_data",
                                &mut self.monitor_data,
                                &mut keys,
                            )?
                    }
                    6 => {
                        reader
                            .status_field_into(
                                "torque_sensor",
                                &mut self.torque_sensor,
                                &mut keys,
                            )?
                    }
                    7 => {
                        reader
                            .status_field_into(
                                "joint_actual_position",
                                &mut self.joint_actual_position,
                                &mut keys,
                            )?
                    }
                    8 => {
                        reader
                            .status_field_into(
                                "actual_position",
                                &mut self.actual_position,
                                &mut keys,
                            )?
                    }
                    9 => {
                        reader
                            .status_field_into(
                                "digital_inputs",
                                &mut self.digital_inputs,
                                &mut keys,
                            )?
                    }
                    10 => {
                        reader
                            .status_field_into(
                                "digital_outputs",
                                &mut self.digital_outputs,
                                &mut keys,
                            )?
                    }
                    11 => {
                        reader
                            .status_field_into(
                                "analog_inputs",
                                &mut self.analog_inputs,
                                &mut keys,
                            )?
                    }
                    12 => {
                        reader
                            .status_field_into(
                                "analog_outputs",
                                &mut self.analog_outputs,
                                &mut keys,
                            )?
                    }
                    13 => {
                        reader
                            .status_field_into(
                                "tool_digital_inputs",
                                &mut self.tool_digital_inputs,
                                &mut keys,
                            )?
                    }
                    14 => {
                        reader
                            .status_field_into(
                                "tool_digital_outputs",
                                &mut self.tool_digital_outputs,
                                &mut keys,
                            )?
                    }
                    15 => {
                        reader
                            .status_field_into(
                                "tool_analog_inputs",
                                &mut self.tool_analog_inputs,
                                &mut keys,
                            )?
                    }
                    16 => {
                        reader
                            .status_field_into(
                                "task_state",
                                &mut self.task_state,
                                &mut keys,
                            )?
                    }
                    17 => reader.status_field_into("homed", &mut self.homed, &mut keys)?,
                    18 => {
                        reader
                            .status_field_into(
                                "task_mode",
                                &mut self.task_mode,
                                &mut keys,
                            )?
                    }
                    19 => {
                        reader
                            .status_field_into(
                                "interpreter_state",
                                &mut self.interpreter_state,
                                &mut keys,
                            )?
                    }
                    20 => {
                        reader
                            .status_field_into("enabled", &mut self.enabled, &mut keys)?
                    }
                    21 => {
                        reader.status_field_into("paused", &mut self.paused, &mut keys)?
                    }
                    22 => {
                        reader
                            .status_field_into(
                                "rapid_rate",
                                &mut self.rapid_rate,
                                &mut keys,
                            )?
                    }
                    23 => {
                        reader
                            .status_field_into(
                                "current_tool_id",
                                &mut self.current_tool_id,
                                &mut keys,
                            )?
                    }
                    24 => {
                        reader
                            .status_field_into(
                                "current_user_frame_id",
                                &mut self.current_user_frame_id,
                                &mut keys,
                            )?
                    }
                    25 => {
                        reader
                            .status_field_into(
                                "on_soft_limit",
                                &mut self.on_soft_limit,
                                &mut keys,
                            )?
                    }
                    26 => {
                        reader
                            .status_field_into(
                                "emergency_stop",
                                &mut self.emergency_stop,
                                &mut keys,
                            )?
                    }
                    27 => {
                        reader
                            .status_field_into(
                                "drag_near_limit",
                                &mut self.drag_near_limit,
                                &mut keys,
                            )?
                    }
                    28 => {
                        reader
                            .status_field_into(
                                "function_inputs",
                                &mut self.function_inputs,
                                &mut keys,
                            )?
                    }
                    29 => {
                        reader
                            .status_field_into(
                                "powered_on",
                                &mut self.powered_on,
                                &mut keys,
                            )?
                    }
                    30 => {
                        reader
                            .status_field_into(
                                "in_position",
                                &mut self.in_position,
                                &mut keys,
                            )?
                    }
                    31 => {
                        reader
                            .status_field_into(
                                "motion_mode",
                                &mut self.motion_mode,
                                &mut keys,
                            )?
                    }
                    32 => {
                        reader
                            .status_field_into(
                                "tcp_speed",
                                &mut self.tcp_speed,
                                &mut keys,
                            )?
                    }
                    33 => {
                        reader
                            .status_field_into(
                                "protective_stop",
                                &mut self.protective_stop,
                                &mut keys,
                            )?
                    }
                    34 => {
                        reader
                            .status_field_into(
                                "point_key",
                                &mut self.point_key,
                                &mut keys,
                            )?
                    }
                    35 => {
                        reader
                            .status_field_into(
                                "network_state",
                                &mut self.network_state,
                                &mut keys,
                            )?
                    }
                    36 => {
                        reader
                            .status_field_into(
                                "joint_commanded_position",
                                &mut self.joint_commanded_position,
                                &mut keys,
                            )?
                    }
                    37 => {
                        reader
                            .status_field_into(
                                "commanded_position",
                                &mut self.commanded_position,
                                &mut keys,
                            )?
                    }
                    38 => {
                        reader
                            .status_field_into(
                                "tool_keys",
                                &mut self.tool_keys,
                                &mut keys,
                            )?
                    }
                    39 => {
                        reader
                            .status_field_into(
                                "instantaneous_velocities",
                                &mut self.instantaneous_velocities,
                                &mut keys,
                            )?
                    }
                    40 => {
                        reader
                            .status_field_into(
                                "relay_outputs",
                                &mut self.relay_outputs,
                                &mut keys,
                            )?
                    }
                    41 => {
                        reader
                            .status_field_into(
                                "modbus_slave_digital_inputs",
                                &mut self.modbus_slave_digital_inputs,
                                &mut keys,
                            )?
                    }
                    42 => {
                        reader
                            .status_field_into(
                                "modbus_slave_digital_outputs",
                                &mut self.modbus_slave_digital_outputs,
                                &mut keys,
                            )?
                    }
                    43 => {
                        reader
                            .status_field_into(
                                "modbus_slave_analog_inputs",
                                &mut self.modbus_slave_analog_inputs,
                                &mut keys,
                            )?
                    }
                    44 => {
                        reader
                            .status_field_into(
                                "modbus_slave_analog_outputs",
                                &mut self.modbus_slave_analog_outputs,
                                &mut keys,
                            )?
                    }
                    45 => {
                        reader
                            .status_field_into(
                                "profinet_device_digital_inputs",
                                &mut self.profinet_device_digital_inputs,
                                &mut keys,
                            )?
                    }
                    46 => {
                        reader
                            .status_field_into(
                                "profinet_device_digital_outputs",
                                &mut self.profinet_device_digital_outputs,
                                &mut keys,
                            )?
                    }
                    47 => {
                        reader
                            .status_field_into(
                                "profinet_device_analog_inputs",
                                &mut self.profinet_device_analog_inputs,
                                &mut keys,
                            )?
                    }
                    48 => {
                        reader
                            .status_field_into(
                                "profinet_device_analog_outputs",
                                &mut self.profinet_device_analog_outputs,
                                &mut keys,
                            )?
                    }
                    49 => {
                        reader
                            .status_field_into(
                                "ethernet_ip_adapter_digital_inputs",
                                &mut self.ethernet_ip_adapter_digital_inputs,
                                &mut keys,
                            )?
                    }
                    50 => {
                        reader
                            .status_field_into(
                                "ethernet_ip_adapter_digital_outputs",
                                &mut self.ethernet_ip_adapter_digital_outputs,
                                &mut keys,
                            )?
                    }
                    51 => {
                        reader
                            .status_field_into(
                                "ethernet_ip_adapter_analog_inputs",
                                &mut self.ethernet_ip_adapter_analog_inputs,
                                &mut keys,
                            )?
                    }
                    52 => {
                        reader
                            .status_field_into(
                                "ethernet_ip_adapter_analog_outputs",
                                &mut self.ethernet_ip_adapter_analog_outputs,
                                &mut keys,
                            )?
                    }
                    53 => {
                        reader
                            .status_field_into(
                                "tool_rs_signals",
                                &mut self.tool_rs_signals,
                                &mut keys,
                            )?
                    }
                    54 => {
                        reader
                            .status_field_into(
                                "motion_line",
                                &mut self.motion_line,
                                &mut keys,
                            )?
                    }
                    55 => {
                        reader
                            .status_field_into(
                                "error_add_line",
                                &mut self.error_add_line,
                                &mut keys,
                            )?
                    }
                    _ => reader.skip_unknown(&keys)?,
                }
            }
            keys.absent(0, &mut self.length);
            keys.absent(1, &mut self.drag_status);
            keys.absent(2, &mut self.extio);
            keys.absent(3, &mut self.error_code);
            keys.absent(4, &mut self.error_message);
            keys.absent(5, &mut self.monitor_data);
            keys.absent(6, &mut self.torque_sensor);
            keys.absent(7, &mut self.joint_actual_position);
            keys.absent(8, &mut self.actual_position);
            keys.absent(9, &mut self.digital_inputs);
            keys.absent(10, &mut self.digital_outputs);
            keys.absent(11, &mut self.analog_inputs);
            keys.absent(12, &mut self.analog_outputs);
            keys.absent(13, &mut self.tool_digital_inputs);
            keys.absent(14, &mut self.tool_digital_outputs);
            keys.absent(15, &mut self.tool_analog_inputs);
            keys.absent(16, &mut self.task_state);
            keys.absent(17, &mut self.homed);
            keys.absent(18, &mut self.task_mode);
            keys.absent(19, &mut self.interpreter_state);
            keys.absent(20, &mut self.enabled);
            keys.absent(21, &mut self.paused);
            keys.absent(22, &mut self.rapid_rate);
            keys.absent(23, &mut self.current_tool_id);
            keys.absent(24, &mut self.current_user_frame_id);
            keys.absent(25, &mut self.on_soft_limit);
            keys.absent(26, &mut self.emergency_stop);
            keys.absent(27, &mut self.drag_near_limit);
            keys.absent(28, &mut self.function_inputs);
            keys.absent(29, &mut self.powered_on);
            keys.absent(30, &mut self.in_position);
            keys.absent(31, &mut self.motion_mode);
            keys.absent(32, &mut self.tcp_speed);
            keys.absent(33, &mut self.protective_stop);
            keys.absent(34, &mut self.point_key);
            keys.absent(35, &mut self.network_state);
            keys.absent(36, &mut self.joint_commanded_position);
            keys.absent(37, &mut self.commanded_position);
            keys.absent(38, &mut self.tool_keys);
            keys.absent(39, &mut self.instantaneous_velocities);
            keys.absent(40, &mut self.relay_outputs);
            keys.absent(41, &mut self.modbus_slave_digital_inputs);
            keys.absent(42, &mut self.modbus_slave_digital_outputs);
            keys.absent(43, &mut self.modbus_slave_analog_inputs);
            keys.absent(44, &mut self.modbus_slave_analog_outputs);
            keys.absent(45, &mut self.profinet_device_digital_inputs);
            keys.absent(46, &mut self.profinet_device_digital_outputs);
            keys.absent(47, &mut self.profinet_device_analog_inputs);
            keys.absent(48, &mut self.profinet_device_analog_outputs);
            keys.absent(49, &mut self.ethernet_ip_adapter_digital_inputs);
            keys.absent(50, &mut self.ethernet_ip_adapter_digital_outputs);
            keys.absent(51, &mut self.ethernet_ip_adapter_analog_inputs);
            keys.absent(52, &mut self.ethernet_ip_adapter_analog_outputs);
            keys.absent(53, &mut self.tool_rs_signals);
            keys.absent(54, &mut self.motion_line);
            keys.absent(55, &mut self.error_add_line);
            Ok(())
        }
    }
    proto::__object_impls!(RobotStatus, in_place);
    impl check::Validate for RobotStatus {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place
                .check(
                    "length",
                    &self.length,
                    &check::Limits {
                        unit: "bytes",
                        ..check::Limits::NONE
                    },
                )?;
            place.check("drag_status", &self.drag_status, &check::Limits::NONE)?;
            place.check("extio", &self.extio, &check::Limits::NONE)?;
            place.check("error_code", &self.error_code, &check::Limits::NONE)?;
            place.check("error_message", &self.error_message, &check::Limits::NONE)?;
            place.check("monitor_data", &self.monitor_data, &check::Limits::NONE)?;
            place.check("torque_sensor", &self.torque_sensor, &check::Limits::NONE)?;
            place
                .check(
                    "joint_actual_position",
                    &self.joint_actual_position,
                    &check::Limits::NONE,
                )?;
            place.check("actual_position", &self.actual_position, &check::Limits::NONE)?;
            place.check("digital_inputs", &self.digital_inputs, &check::Limits::NONE)?;
            place.check("digital_outputs", &self.digital_outputs, &check::Limits::NONE)?;
            place.check("analog_inputs", &self.analog_inputs, &check::Limits::NONE)?;
            place.check("analog_outputs", &self.analog_outputs, &check::Limits::NONE)?;
            place
                .check(
                    "tool_digital_inputs",
                    &self.tool_digital_inputs,
                    &check::Limits::NONE,
                )?;
            place
                .check(
                    "tool_digital_outputs",
                    &self.tool_digital_outputs,
                    &check::Limits::NONE,
                )?;
            place
                .check(
                    "tool_analog_inputs",
                    &self.tool_analog_inputs,
                    &check::Limits::NONE,
                )?;
            place.check("task_state", &self.task_state, &check::Limits::NONE)?;
            place.check("homed", &self.homed, &check::Limits::NONE)?;
            place.check("task_mode", &self.task_mode, &check::Limits::NONE)?;
            place
                .check(
                    "interpreter_state",
                    &self.interpreter_state,
                    &check::Limits::NONE,
                )?;
            place.check("enabled", &self.enabled, &check::Limits::NONE)?;
            place.check("paused", &self.paused, &check::Limits::NONE)?;
            place.check("rapid_rate", &self.rapid_rate, &check::Limits::NONE)?;
            place.check("current_tool_id", &self.current_tool_id, &check::Limits::NONE)?;
            place
                .check(
                    "current_user_frame_id",
                    &self.current_user_frame_id,
                    &check::Limits::NONE,
                )?;
            place.check("on_soft_limit", &self.on_soft_limit, &check::Limits::NONE)?;
            place.check("emergency_stop", &self.emergency_stop, &check::Limits::NONE)?;
            place.check("drag_near_limit", &self.drag_near_limit, &check::Limits::NONE)?;
            place.check("function_inputs", &self.function_inputs, &check::Limits::NONE)?;
            place.check("powered_on", &self.powered_on, &check::Limits::NONE)?;
            place.check("in_position", &self.in_position, &check::Limits::NONE)?;
            place.check("motion_mode", &self.motion_mode, &check::Limits::NONE)?;
            place
                .check(
                    "tcp_speed",
                    &self.tcp_speed,
                    &check::Limits {
                        unit: "mm/s",
                        ..check::Limits::NONE
                    },
                )?;
            place.check("protective_stop", &self.protective_stop, &check::Limits::NONE)?;
            place.check("point_key", &self.point_key, &check::Limits::NONE)?;
            place.check("network_state", &self.network_state, &check::Limits::NONE)?;
            place
                .check(
                    "joint_commanded_position",
                    &self.joint_commanded_position,
                    &check::Limits::NONE,
                )?;
            place
                .check(
                    "commanded_position",
                    &self.commanded_position,
                    &check::Limits::NONE,
                )?;
            place.check("tool_keys", &self.tool_keys, &check::Limits::NONE)?;
            place
                .check(
                    "instantaneous_velocities",
                    &self.instantaneous_velocities,
                    &check::Limits::NONE,
                )?;
            place.check("relay_outputs", &self.relay_outputs, &check::Limits::NONE)?;
            place
                .check(
                    "modbus_slave_digital_inputs",
                    &self.modbus_slave_digital_inputs,
                    &check::Limits::NONE,
                )?;
            place
                .check(
                    "modbus_slave_digital_outputs",
                    &self.modbus_slave_digital_outputs,
                    &check::Limits::NONE,
                )?;
            place
                .check(
                    "modbus_slave_analog_inputs",
                    &self.modbus_slave_analog_inputs,
                    &check::Limits::NONE,
                )?;
            place
                .check(
                    "modbus_slave_analog_outputs",
                    &self.modbus_slave_analog_outputs,
                    &check::Limits::NONE,
                )?;
            place
                .check(
                    "profinet_device_digital_inputs",
                    &self.profinet_device_digital_inputs,
                    &check::Limits::NONE,
                )?;
            place
                .check(
                    "profinet_device_digital_outputs",
                    &self.profinet_device_digital_outputs,
                    &check::Limits::NONE,
                )?;
            place
                .check(
                    "profinet_device_analog_inputs",
                    &self.profinet_device_analog_inputs,
                    &check::Limits::NONE,
                )?;
            place
                .check(
                    "profinet_device_analog_outputs",
                    &self.profinet_device_analog_outputs,
                    &check::Limits::NONE,
                )?;
            place
                .check(
                    "ethernet_ip_adapter_digital_inputs",
                    &self.ethernet_ip_adapter_digital_inputs,
                    &check::Limits::NONE,
                )?;
            place
                .check(
                    "ethernet_ip_adapter_digital_outputs",
                    &self.ethernet_ip_adapter_digital_outputs,
                    &check::Limits::NONE,
                )?;
            place
                .check(
                    "ethernet_ip_adapter_analog_inputs",
                    &self.ethernet_ip_adapter_analog_inputs,
                    &check::Limits::NONE,
                )?;
            place
                .check(
                    "ethernet_ip_adapter_analog_outputs",
                    &self.ethernet_ip_adapter_analog_outputs,
                    &check::Limits::NONE,
                )?;
            place.check("tool_rs_signals", &self.tool_rs_signals, &check::Limits::NONE)?;
            place.check("motion_line", &self.motion_line, &check::Limits::NONE)?;
            place.check("error_add_line", &self.error_add_line, &check::Limits::NONE)?;
            Ok(())
        }
    }
    /// Whether the robot has power and is enabled.
    ///
    /// The document gives 3 and 4 the same meaning.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum TaskState {
        /// The robot has no power. `1` on the wire.
        PoweredOff,
        /// The robot has power. `2` on the wire.
        PoweredOn,
        /// The robot is enabled.
        ///
        /// The document says the same of 4, and its sample prints 4 beside `enabled` true. What sets 3 apart is not known. `3` on the wire.
        Enabled3,
        /// The robot is enabled.
        ///
        /// The document says the same of 3. Its sample prints 4 beside `enabled` true. `4` on the wire.
        Enabled4,
        /// A value that the spec does not list.
        Other(i64),
    }
    impl From<i64> for TaskState {
        fn from(value: i64) -> Self {
            match value {
                1 => Self::PoweredOff,
                2 => Self::PoweredOn,
                3 => Self::Enabled3,
                4 => Self::Enabled4,
                other => Self::Other(other),
            }
        }
    }
    impl From<TaskState> for i64 {
        fn from(value: TaskState) -> Self {
            match value {
                TaskState::PoweredOff => 1,
                TaskState::PoweredOn => 2,
                TaskState::Enabled3 => 3,
                TaskState::Enabled4 => 4,
                TaskState::Other(other) => other,
            }
        }
    }
    proto::__int_enum_impls!(TaskState);
    impl check::Validate for TaskState {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            let standing = match self {
                Self::PoweredOff | Self::PoweredOn | Self::Enabled3 | Self::Enabled4 => {
                    check::Standing::Listed
                }
                Self::Other(_) => check::Standing::Unknown,
            };
            place
                .listed(
                    &i64::from(*self),
                    standing,
                    "1 (PoweredOff), 2 (PoweredOn), 3 (Enabled3) or 4 (Enabled4)",
                )
        }
    }
    /// Task mode of the robot.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum TaskMode {
        /// Manual mode. `1` on the wire.
        Manual,
        /// Automatic mode. `2` on the wire.
        Automatic,
        /// Reserved mode. `3` on the wire.
        Reserved,
        /// Drag mode. `4` on the wire.
        Drag,
        /// A value that the spec does not list.
        Other(i64),
    }
    impl From<i64> for TaskMode {
        fn from(value: i64) -> Self {
            match value {
                1 => Self::Manual,
                2 => Self::Automatic,
                3 => Self::Reserved,
                4 => Self::Drag,
                other => Self::Other(other),
            }
        }
    }
    impl From<TaskMode> for i64 {
        fn from(value: TaskMode) -> Self {
            match value {
                TaskMode::Manual => 1,
                TaskMode::Automatic => 2,
                TaskMode::Reserved => 3,
                TaskMode::Drag => 4,
                TaskMode::Other(other) => other,
            }
        }
    }
    proto::__int_enum_impls!(TaskMode);
    impl check::Validate for TaskMode {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            let standing = match self {
                Self::Manual | Self::Automatic | Self::Reserved | Self::Drag => {
                    check::Standing::Listed
                }
                Self::Other(_) => check::Standing::Unknown,
            };
            place
                .listed(
                    &i64::from(*self),
                    standing,
                    "1 (Manual), 2 (Automatic), 3 (Reserved) or 4 (Drag)",
                )
        }
    }
    /// State of the program.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum InterpreterState {
        /// No program runs. `0` on the wire.
        Idle,
        /// A program is being loaded. `1` on the wire.
        Loading,
        /// The program is paused. `2` on the wire.
        Paused,
        /// The program runs. `3` on the wire.
        Running,
        /// A value that the spec does not list.
        Other(i64),
    }
    impl From<i64> for InterpreterState {
        fn from(value: i64) -> Self {
            match value {
                0 => Self::Idle,
                1 => Self::Loading,
                2 => Self::Paused,
                3 => Self::Running,
                other => Self::Other(other),
            }
        }
    }
    impl From<InterpreterState> for i64 {
        fn from(value: InterpreterState) -> Self {
            match value {
                InterpreterState::Idle => 0,
                InterpreterState::Loading => 1,
                InterpreterState::Paused => 2,
                InterpreterState::Running => 3,
                InterpreterState::Other(other) => other,
            }
        }
    }
    proto::__int_enum_impls!(InterpreterState);
    impl check::Validate for InterpreterState {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            let standing = match self {
                Self::Idle | Self::Loading | Self::Paused | Self::Running => {
                    check::Standing::Listed
                }
                Self::Other(_) => check::Standing::Unknown,
            };
            place
                .listed(
                    &i64::from(*self),
                    standing,
                    "0 (Idle), 1 (Loading), 2 (Paused) or 3 (Running)",
                )
        }
    }
    /// Configuration and state of the extension I/O modules, as port 10000 gives them.
    ///
    /// The document describes the parts and prints no sample. `get_extio_status` answers the same in another shape.
    #[derive(Debug, Clone, PartialEq)]
    pub struct ExtioReport {
        /// State of all pins of all modules.
        ///
        /// `status` on the wire.
        #[doc(alias = "status")]
        pub pin_states: ExtioPinStates,
        /// How each module is connected, and its pins; 8 modules at most.
        pub setup: Vec<ExtioReportSetup>,
        /// Number of modules.
        ///
        /// `num` on the wire.
        #[doc(alias = "num")]
        pub count: i64,
        /// Where the pins of each module start, in the order of `setup`.
        ///
        /// `pinmap` on the wire.
        #[doc(alias = "pinmap")]
        pub pin_maps: Vec<ExtioReportPinMap>,
        /// Whether the modules run.
        ///
        /// The document counts the other way round in 4.34, where `state` 0 says that the modules do not run and 1 that they do.
        pub mode: ExtioMode,
    }
    impl wire::Fields for ExtioReport {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"status\":");
            wire::Encode::encode(&self.pin_states, out);
            out.raw(",\"setup\":");
            wire::Encode::encode(&self.setup, out);
            out.raw(",\"num\":");
            wire::Encode::encode(&self.count, out);
            out.raw(",\"pinmap\":");
            wire::Encode::encode(&self.pin_maps, out);
            out.raw(",\"mode\":");
            wire::Encode::encode(&self.mode, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut pin_states = None;
            let mut setup = None;
            let mut count = None;
            let mut pin_maps = None;
            let mut mode = None;
            let mut keys = reader
                .begin_fields(
                    &[
                        "\"status\":",
                        "\"setup\":",
                        "\"num\":",
                        "\"pinmap\":",
                        "\"mode\":",
                    ],
                )?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("pin_states", &mut pin_states)?,
                    1 => reader.field("setup", &mut setup)?,
                    2 => reader.field("count", &mut count)?,
                    3 => reader.field("pin_maps", &mut pin_maps)?,
                    4 => reader.field("mode", &mut mode)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                pin_states: pin_states
                    .ok_or_else(|| wire::DecodeError::missing("pin_states", "status"))?,
                setup: setup
                    .ok_or_else(|| wire::DecodeError::missing("setup", "setup"))?,
                count: count.ok_or_else(|| wire::DecodeError::missing("count", "num"))?,
                pin_maps: pin_maps
                    .ok_or_else(|| wire::DecodeError::missing("pin_maps", "pinmap"))?,
                mode: mode.ok_or_else(|| wire::DecodeError::missing("mode", "mode"))?,
            })
        }
        fn read_fields_into(
            &mut self,
            reader: &mut wire::Reader<'_>,
        ) -> Result<(), wire::DecodeError> {
            let mut keys = reader
                .begin_fields(
                    &[
                        "\"status\":",
                        "\"setup\":",
                        "\"num\":",
                        "\"pinmap\":",
                        "\"mode\":",
                    ],
                )?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => {
                        reader
                            .required_into(
                                "pin_states",
                                &mut self.pin_states,
                                &mut keys,
                            )?
                    }
                    1 => reader.required_into("setup", &mut self.setup, &mut keys)?,
                    2 => reader.required_into("count", &mut self.count, &mut keys)?,
                    3 => reader.required_into("pin_maps", &mut self.pin_maps, &mut keys)?,
                    4 => reader.required_into("mode", &mut self.mode, &mut keys)?,
                    _ => reader.skip()?,
                }
            }
            keys.required(0, "pin_states", "status")?;
            keys.required(1, "setup", "setup")?;
            keys.required(2, "count", "num")?;
            keys.required(3, "pin_maps", "pinmap")?;
            keys.required(4, "mode", "mode")?;
            Ok(())
        }
    }
    proto::__object_impls!(ExtioReport, in_place);
    impl check::Validate for ExtioReport {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("pin_states", &self.pin_states, &check::Limits::NONE)?;
            place.check("setup", &self.setup, &check::Limits::NONE)?;
            place.check("count", &self.count, &check::Limits::NONE)?;
            place.check("pin_maps", &self.pin_maps, &check::Limits::NONE)?;
            place.check("mode", &self.mode, &check::Limits::NONE)?;
            Ok(())
        }
    }
    /// State of all pins of the extension I/O modules, by kind.
    #[derive(Debug, Clone, PartialEq)]
    pub struct ExtioPinStates {
        /// State of the digital inputs.
        pub digital_inputs: Vec<bool>,
        /// State of the digital outputs.
        pub digital_outputs: Vec<bool>,
        /// Values of the analog inputs. Unit not stated.
        pub analog_inputs: Vec<f64>,
        /// Values of the analog outputs. Unit not stated.
        pub analog_outputs: Vec<f64>,
    }
    impl wire::Encode for ExtioPinStates {
        fn encode(&self, out: &mut wire::Writer) {
            out.raw("[");
            out.array(
                &self.digital_inputs,
                |out, item| {
                    out.choose(*item, "0", "1");
                },
            );
            out.raw(",");
            out.array(
                &self.digital_outputs,
                |out, item| {
                    out.choose(*item, "0", "1");
                },
            );
            out.raw(",");
            wire::Encode::encode(&self.analog_inputs, out);
            out.raw(",");
            wire::Encode::encode(&self.analog_outputs, out);
            out.raw("]");
        }
    }
    impl wire::Decode for ExtioPinStates {
        fn decode(reader: &mut wire::Reader<'_>) -> Result<Self, wire::DecodeError> {
            reader.begin_array()?;
            let this = Self {
                digital_inputs: reader.element("digital_inputs")?,
                digital_outputs: reader.element("digital_outputs")?,
                analog_inputs: reader.element("analog_inputs")?,
                analog_outputs: reader.element("analog_outputs")?,
            };
            reader.end_array()?;
            Ok(this)
        }
        fn decode_into(
            &mut self,
            reader: &mut wire::Reader<'_>,
        ) -> Result<(), wire::DecodeError> {
            reader.begin_array()?;
            reader.element_into("digital_inputs", &mut self.digital_inputs)?;
            reader.element_into("digital_outputs", &mut self.digital_outputs)?;
            reader.element_into("analog_inputs", &mut self.analog_inputs)?;
            reader.element_into("analog_outputs", &mut self.analog_outputs)?;
            reader.end_array()
        }
    }
    proto::__serde_impls!(ExtioPinStates);
    impl check::Validate for ExtioPinStates {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("digital_inputs", &self.digital_inputs, &check::Limits::NONE)?;
            place.check("digital_outputs", &self.digital_outputs, &check::Limits::NONE)?;
            place.check("analog_inputs", &self.analog_inputs, &check::Limits::NONE)?;
            place.check("analog_outputs", &self.analog_outputs, &check::Limits::NONE)?;
            Ok(())
        }
    }
    /// How an extension I/O module is connected, and its pins, as port 10000 gives them.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub enum ExtioReportSetup {
        /// Connected by Modbus RTU.
        Rtu {
            /// Name of the module.
            name: String,
            /// Serial settings of the connection. The document prints no sample of them.
            ///
            /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
            connection: wire::Typed<super::io::ExtioRtu>,
            /// The module's pins.
            pins: ExtioReportPins,
        },
        /// Connected by Modbus TCP.
        Tcp {
            /// Name of the module.
            name: String,
            /// Network address of the module.
            connection: super::io::ExtioTcp,
            /// The module's pins.
            pins: ExtioReportPins,
        },
        /// A kind that the spec does not list, as raw JSON.
        Other(wire::Value),
    }
    impl wire::Encode for ExtioReportSetup {
        fn encode(&self, out: &mut wire::Writer) {
            match self {
                Self::Rtu { name, connection, pins } => {
                    out.raw("[0");
                    out.raw(",");
                    wire::Encode::encode(name, out);
                    out.raw(",");
                    match connection {
                        wire::Typed::Known(value) => {
                            wire::Encode::encode(value, out);
                        }
                        wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                    }
                    out.raw(",");
                    wire::Encode::encode(pins, out);
                    out.raw("]");
                }
                Self::Tcp { name, connection, pins } => {
                    out.raw("[1");
                    out.raw(",");
                    wire::Encode::encode(name, out);
                    out.raw(",");
                    wire::Encode::encode(connection, out);
                    out.raw(",");
                    wire::Encode::encode(pins, out);
                    out.raw("]");
                }
                Self::Other(value) => wire::Encode::encode(value, out),
            }
        }
    }
    impl wire::Decode for ExtioReportSetup {
        fn decode(reader: &mut wire::Reader<'_>) -> Result<Self, wire::DecodeError> {
            let start = reader.mark();
            reader.begin_array()?;
            match reader.element::<i64>("kind")? {
                0 => {
                    let this = Self::Rtu {
                        name: reader.element("name")?,
                        connection: reader.element("connection")?,
                        pins: reader.element("pins")?,
                    };
                    reader.end_array()?;
                    Ok(this)
                }
                1 => {
                    let this = Self::Tcp {
                        name: reader.element("name")?,
                        connection: reader.element("connection")?,
                        pins: reader.element("pins")?,
                    };
                    reader.end_array()?;
                    Ok(this)
                }
                _ => {
                    reader.go_back(start);
                    wire::Decode::decode(reader).map(Self::Other)
                }
            }
        }
        fn decode_into(
            &mut self,
            reader: &mut wire::Reader<'_>,
        ) -> Result<(), wire::DecodeError> {
            let start = reader.mark();
            reader.begin_array()?;
            match (reader.element::<i64>("kind")?, &mut *self) {
                (0, Self::Rtu { name, connection, pins }) => {
                    reader.element_into("name", name)?;
                    reader.element_into("connection", connection)?;
                    reader.element_into("pins", pins)?;
                    reader.end_array()
                }
                (1, Self::Tcp { name, connection, pins }) => {
                    reader.element_into("name", name)?;
                    reader.element_into("connection", connection)?;
                    reader.element_into("pins", pins)?;
                    reader.end_array()
                }
                _ => {
                    reader.go_back(start);
                    *self = wire::Decode::decode(reader)?;
                    Ok(())
                }
            }
        }
    }
    proto::__serde_impls!(ExtioReportSetup);
    impl check::Validate for ExtioReportSetup {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            match self {
                Self::Rtu { name, connection, pins } => {
                    place.check("name", name, &check::Limits::NONE)?;
                    place.check("connection", connection, &check::Limits::NONE)?;
                    place.check("pins", pins, &check::Limits::NONE)?;
                }
                Self::Tcp { name, connection, pins } => {
                    place.check("name", name, &check::Limits::NONE)?;
                    place.check("connection", connection, &check::Limits::NONE)?;
                    place.check("pins", pins, &check::Limits::NONE)?;
                }
                Self::Other(_) => {}
            }
            Ok(())
        }
    }
    /// The pins of an extension I/O module, as port 10000 gives them.
    ///
    /// The order is not that of `get_extio_status`, which names the kinds.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct ExtioReportPins {
        /// Digital inputs.
        pub digital_inputs: super::io::ExtioPinRange,
        /// Digital outputs.
        pub digital_outputs: super::io::ExtioPinRange,
        /// Analog inputs.
        pub analog_inputs: super::io::ExtioPinRange,
        /// Analog outputs.
        pub analog_outputs: super::io::ExtioPinRange,
    }
    impl wire::Encode for ExtioReportPins {
        fn encode(&self, out: &mut wire::Writer) {
            out.raw("[");
            wire::Encode::encode(&self.digital_inputs, out);
            out.raw(",");
            wire::Encode::encode(&self.digital_outputs, out);
            out.raw(",");
            wire::Encode::encode(&self.analog_inputs, out);
            out.raw(",");
            wire::Encode::encode(&self.analog_outputs, out);
            out.raw("]");
        }
    }
    impl wire::Decode for ExtioReportPins {
        fn decode(reader: &mut wire::Reader<'_>) -> Result<Self, wire::DecodeError> {
            reader.begin_array()?;
            let this = Self {
                digital_inputs: reader.element("digital_inputs")?,
                digital_outputs: reader.element("digital_outputs")?,
                analog_inputs: reader.element("analog_inputs")?,
                analog_outputs: reader.element("analog_outputs")?,
            };
            reader.end_array()?;
            Ok(this)
        }
    }
    proto::__serde_impls!(ExtioReportPins);
    impl check::Validate for ExtioReportPins {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("digital_inputs", &self.digital_inputs, &check::Limits::NONE)?;
            place.check("digital_outputs", &self.digital_outputs, &check::Limits::NONE)?;
            place.check("analog_inputs", &self.analog_inputs, &check::Limits::NONE)?;
            place.check("analog_outputs", &self.analog_outputs, &check::Limits::NONE)?;
            Ok(())
        }
    }
    /// Where the pins of an extension I/O module start, as port 10000 gives it.
    ///
    /// The document calls each value an offset of registers here, and an index of pins in 4.34. It prints `pinmap[N][2]` for
    /// the analog inputs and again for the analog outputs; the second is read as `pinmap[N][3]`.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct ExtioReportPinMap {
        /// Start of the digital inputs.
        pub digital_inputs: i64,
        /// Start of the digital outputs.
        pub digital_outputs: i64,
        /// Start of the analog inputs.
        pub analog_inputs: i64,
        /// Start of the analog outputs.
        pub analog_outputs: i64,
    }
    impl wire::Encode for ExtioReportPinMap {
        fn encode(&self, out: &mut wire::Writer) {
            out.raw("[");
            wire::Encode::encode(&self.digital_inputs, out);
            out.raw(",");
            wire::Encode::encode(&self.digital_outputs, out);
            out.raw(",");
            wire::Encode::encode(&self.analog_inputs, out);
            out.raw(",");
            wire::Encode::encode(&self.analog_outputs, out);
            out.raw("]");
        }
    }
    impl wire::Decode for ExtioReportPinMap {
        fn decode(reader: &mut wire::Reader<'_>) -> Result<Self, wire::DecodeError> {
            reader.begin_array()?;
            let this = Self {
                digital_inputs: reader.element("digital_inputs")?,
                digital_outputs: reader.element("digital_outputs")?,
                analog_inputs: reader.element("analog_inputs")?,
                analog_outputs: reader.element("analog_outputs")?,
            };
            reader.end_array()?;
            Ok(this)
        }
    }
    proto::__serde_impls!(ExtioReportPinMap);
    impl check::Validate for ExtioReportPinMap {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("digital_inputs", &self.digital_inputs, &check::Limits::NONE)?;
            place.check("digital_outputs", &self.digital_outputs, &check::Limits::NONE)?;
            place.check("analog_inputs", &self.analog_inputs, &check::Limits::NONE)?;
            place.check("analog_outputs", &self.analog_outputs, &check::Limits::NONE)?;
            Ok(())
        }
    }
    /// Whether the extension I/O modules run, in the sense of `extio` on port 10000.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum ExtioMode {
        /// On, by the document. `0` on the wire.
        On,
        /// Off, by the document. `1` on the wire.
        Off,
        /// A value that the spec does not list.
        Other(i64),
    }
    impl From<i64> for ExtioMode {
        fn from(value: i64) -> Self {
            match value {
                0 => Self::On,
                1 => Self::Off,
                other => Self::Other(other),
            }
        }
    }
    impl From<ExtioMode> for i64 {
        fn from(value: ExtioMode) -> Self {
            match value {
                ExtioMode::On => 0,
                ExtioMode::Off => 1,
                ExtioMode::Other(other) => other,
            }
        }
    }
    proto::__int_enum_impls!(ExtioMode);
    impl check::Validate for ExtioMode {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            let standing = match self {
                Self::On | Self::Off => check::Standing::Listed,
                Self::Other(_) => check::Standing::Unknown,
            };
            place.listed(&i64::from(*self), standing, "0 (On) or 1 (Off)")
        }
    }
    /// Measurements in the cabinet and the joints, for diagnosis.
    ///
    /// The document states no units.
    #[derive(Debug, Clone, PartialEq)]
    pub struct MonitorData {
        /// Major version number of the SCB.
        pub scb_major_version: i64,
        /// Minor version number of the SCB.
        pub scb_minor_version: i64,
        /// Temperature of the cabinet. Unit not stated.
        pub cabinet_temperature: f64,
        /// Average power of the cabinet's bus. Unit not stated.
        pub bus_average_power: f64,
        /// Average current of the cabinet's bus. Unit not stated.
        pub bus_average_current: f64,
        /// Measurements of joints 1 to 6.
        pub joints: Vec<JointMonitor>,
    }
    impl wire::Encode for MonitorData {
        fn encode(&self, out: &mut wire::Writer) {
            out.raw("[");
            wire::Encode::encode(&self.scb_major_version, out);
            out.raw(",");
            wire::Encode::encode(&self.scb_minor_version, out);
            out.raw(",");
            wire::Encode::encode(&self.cabinet_temperature, out);
            out.raw(",");
            wire::Encode::encode(&self.bus_average_power, out);
            out.raw(",");
            wire::Encode::encode(&self.bus_average_current, out);
            out.raw(",");
            wire::Encode::encode(&self.joints, out);
            out.raw("]");
        }
    }
    impl wire::Decode for MonitorData {
        fn decode(reader: &mut wire::Reader<'_>) -> Result<Self, wire::DecodeError> {
            reader.begin_array()?;
            let this = Self {
                scb_major_version: reader.element("scb_major_version")?,
                scb_minor_version: reader.element("scb_minor_version")?,
                cabinet_temperature: reader.element("cabinet_temperature")?,
                bus_average_power: reader.element("bus_average_power")?,
                bus_average_current: reader.element("bus_average_current")?,
                joints: reader.element("joints")?,
            };
            reader.end_array()?;
            Ok(this)
        }
        fn decode_into(
            &mut self,
            reader: &mut wire::Reader<'_>,
        ) -> Result<(), wire::DecodeError> {
            reader.begin_array()?;
            reader.element_into("scb_major_version", &mut self.scb_major_version)?;
            reader.element_into("scb_minor_version", &mut self.scb_minor_version)?;
            reader.element_into("cabinet_temperature", &mut self.cabinet_temperature)?;
            reader.element_into("bus_average_power", &mut self.bus_average_power)?;
            reader.element_into("bus_average_current", &mut self.bus_average_current)?;
            reader.element_into("joints", &mut self.joints)?;
            reader.end_array()
        }
    }
    proto::__serde_impls!(MonitorData);
    impl check::Validate for MonitorData {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place
                .check(
                    "scb_major_version",
                    &self.scb_major_version,
                    &check::Limits::NONE,
                )?;
            place
                .check(
                    "scb_minor_version",
                    &self.scb_minor_version,
                    &check::Limits::NONE,
                )?;
            place
                .check(
                    "cabinet_temperature",
                    &self.cabinet_temperature,
                    &check::Limits::NONE,
                )?;
            place
                .check(
                    "bus_average_power",
                    &self.bus_average_power,
                    &check::Limits::NONE,
                )?;
            place
                .check(
                    "bus_average_current",
                    &self.bus_average_current,
                    &check::Limits::NONE,
                )?;
            place.check("joints", &self.joints, &check::Limits::NONE)?;
            Ok(())
        }
    }
    /// Measurements of one joint.
    ///
    /// The document states no units. It writes `monitor_data[5][0]` for the current and leaves out the joint; that each joint
    /// has a row of its own comes from the field notes, which have seen rows of 10 and of 11 values.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct JointMonitor {
        /// Instantaneous current. Unit not stated.
        pub current: f64,
        /// Instantaneous voltage. Unit not stated.
        pub voltage: f64,
        /// Instantaneous temperature. Unit not stated.
        pub temperature: f64,
        /// Average power; the document calls it instantaneous and average at once. Unit not stated.
        pub average_power: f64,
        /// Fluctuation of the current. Unit not stated.
        pub current_fluctuation: f64,
        /// Revolutions in all.
        pub total_revolutions: f64,
        /// Running time in all. Unit not stated.
        pub total_running_time: f64,
        /// Running cycles since this start.
        ///
        /// The document has another word here than for `total_revolutions`, and does not say whether both count the same.
        pub cycles_since_start: f64,
        /// Running time since this start. Unit not stated.
        pub running_time_since_start: f64,
        /// Torque of the joint. Unit not stated.
        pub torque: f64,
        /// An eleventh value that some firmware sends and nobody explains.
        pub eleventh: Option<f64>,
    }
    impl wire::Encode for JointMonitor {
        fn encode(&self, out: &mut wire::Writer) {
            out.raw("[");
            wire::Encode::encode(&self.current, out);
            out.raw(",");
            wire::Encode::encode(&self.voltage, out);
            out.raw(",");
            wire::Encode::encode(&self.temperature, out);
            out.raw(",");
            wire::Encode::encode(&self.average_power, out);
            out.raw(",");
            wire::Encode::encode(&self.current_fluctuation, out);
            out.raw(",");
            wire::Encode::encode(&self.total_revolutions, out);
            out.raw(",");
            wire::Encode::encode(&self.total_running_time, out);
            out.raw(",");
            wire::Encode::encode(&self.cycles_since_start, out);
            out.raw(",");
            wire::Encode::encode(&self.running_time_since_start, out);
            out.raw(",");
            wire::Encode::encode(&self.torque, out);
            if let Some(value) = &self.eleventh {
                out.raw(",");
                wire::Encode::encode(value, out);
            }
            out.raw("]");
        }
    }
    impl wire::Decode for JointMonitor {
        fn decode(reader: &mut wire::Reader<'_>) -> Result<Self, wire::DecodeError> {
            reader.begin_array()?;
            let this = Self {
                current: reader.element("current")?,
                voltage: reader.element("voltage")?,
                temperature: reader.element("temperature")?,
                average_power: reader.element("average_power")?,
                current_fluctuation: reader.element("current_fluctuation")?,
                total_revolutions: reader.element("total_revolutions")?,
                total_running_time: reader.element("total_running_time")?,
                cycles_since_start: reader.element("cycles_since_start")?,
                running_time_since_start: reader.element("running_time_since_start")?,
                torque: reader.element("torque")?,
                eleventh: reader.optional_element("eleventh")?,
            };
            reader.end_array()?;
            Ok(this)
        }
    }
    proto::__serde_impls!(JointMonitor);
    impl check::Validate for JointMonitor {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("current", &self.current, &check::Limits::NONE)?;
            place.check("voltage", &self.voltage, &check::Limits::NONE)?;
            place.check("temperature", &self.temperature, &check::Limits::NONE)?;
            place.check("average_power", &self.average_power, &check::Limits::NONE)?;
            place
                .check(
                    "current_fluctuation",
                    &self.current_fluctuation,
                    &check::Limits::NONE,
                )?;
            place
                .check(
                    "total_revolutions",
                    &self.total_revolutions,
                    &check::Limits::NONE,
                )?;
            place
                .check(
                    "total_running_time",
                    &self.total_running_time,
                    &check::Limits::NONE,
                )?;
            place
                .check(
                    "cycles_since_start",
                    &self.cycles_since_start,
                    &check::Limits::NONE,
                )?;
            place
                .check(
                    "running_time_since_start",
                    &self.running_time_since_start,
                    &check::Limits::NONE,
                )?;
            place.check("torque", &self.torque, &check::Limits::NONE)?;
            place.check("eleventh", &self.eleventh, &check::Limits::NONE)?;
            Ok(())
        }
    }
    /// Settings and state of the torque sensor.
    #[derive(Debug, Clone, PartialEq)]
    pub struct TorqueSensorReport {
        /// How the sensor is connected, and its payload.
        pub settings: TorqueSensorSettings,
        /// Whether the sensor works, and what it reads.
        pub state: TorqueSensorState,
    }
    impl wire::Encode for TorqueSensorReport {
        fn encode(&self, out: &mut wire::Writer) {
            out.raw("[");
            wire::Encode::encode(&self.settings, out);
            out.raw(",");
            wire::Encode::encode(&self.state, out);
            out.raw("]");
        }
    }
    impl wire::Decode for TorqueSensorReport {
        fn decode(reader: &mut wire::Reader<'_>) -> Result<Self, wire::DecodeError> {
            reader.begin_array()?;
            let this = Self {
                settings: reader.element("settings")?,
                state: reader.element("state")?,
            };
            reader.end_array()?;
            Ok(this)
        }
        fn decode_into(
            &mut self,
            reader: &mut wire::Reader<'_>,
        ) -> Result<(), wire::DecodeError> {
            reader.begin_array()?;
            reader.element_into("settings", &mut self.settings)?;
            reader.element_into("state", &mut self.state)?;
            reader.end_array()
        }
    }
    proto::__serde_impls!(TorqueSensorReport);
    impl check::Validate for TorqueSensorReport {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("settings", &self.settings, &check::Limits::NONE)?;
            place.check("state", &self.state, &check::Limits::NONE)?;
            Ok(())
        }
    }
    /// How the torque sensor is connected, and its payload.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub enum TorqueSensorSettings {
        /// Connected by TCP/IP.
        Tcp {
            /// Network address of the sensor.
            connection: TorqueSensorTcp,
            /// Payload at the sensor.
            ///
            /// The document does not print how mass and centroid are nested.
            ///
            /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
            payload: wire::Typed<TorqueSensorPayload>,
        },
        /// Connected by a serial line.
        Serial {
            /// Serial settings of the connection.
            ///
            /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
            connection: wire::Typed<TorqueSensorSerial>,
            /// Payload at the sensor.
            ///
            /// The document does not print how mass and centroid are nested.
            ///
            /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
            payload: wire::Typed<TorqueSensorPayload>,
        },
        /// A kind that the spec does not list, as raw JSON.
        Other(wire::Value),
    }
    impl wire::Encode for TorqueSensorSettings {
        fn encode(&self, out: &mut wire::Writer) {
            match self {
                Self::Tcp { connection, payload } => {
                    out.raw("[0");
                    out.raw(",");
                    wire::Encode::encode(connection, out);
                    out.raw(",");
                    match payload {
                        wire::Typed::Known(value) => {
                            wire::Encode::encode(value, out);
                        }
                        wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                    }
                    out.raw("]");
                }
                Self::Serial { connection, payload } => {
                    out.raw("[1");
                    out.raw(",");
                    match connection {
                        wire::Typed::Known(value) => {
                            wire::Encode::encode(value, out);
                        }
                        wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                    }
                    out.raw(",");
                    match payload {
                        wire::Typed::Known(value) => {
                            wire::Encode::encode(value, out);
                        }
                        wire::Typed::Raw(value) => wire::Encode::encode(value, out),
                    }
                    out.raw("]");
                }
                Self::Other(value) => wire::Encode::encode(value, out),
            }
        }
    }
    impl wire::Decode for TorqueSensorSettings {
        fn decode(reader: &mut wire::Reader<'_>) -> Result<Self, wire::DecodeError> {
            let start = reader.mark();
            reader.begin_array()?;
            match reader.element::<i64>("kind")? {
                0 => {
                    let this = Self::Tcp {
                        connection: reader.element("connection")?,
                        payload: reader.element("payload")?,
                    };
                    reader.end_array()?;
                    Ok(this)
                }
                1 => {
                    let this = Self::Serial {
                        connection: reader.element("connection")?,
                        payload: reader.element("payload")?,
                    };
                    reader.end_array()?;
                    Ok(this)
                }
                _ => {
                    reader.go_back(start);
                    wire::Decode::decode(reader).map(Self::Other)
                }
            }
        }
        fn decode_into(
            &mut self,
            reader: &mut wire::Reader<'_>,
        ) -> Result<(), wire::DecodeError> {
            let start = reader.mark();
            reader.begin_array()?;
            match (reader.element::<i64>("kind")?, &mut *self) {
                (0, Self::Tcp { connection, payload }) => {
                    reader.element_into("connection", connection)?;
                    reader.element_into("payload", payload)?;
                    reader.end_array()
                }
                (1, Self::Serial { connection, payload }) => {
                    reader.element_into("connection", connection)?;
                    reader.element_into("payload", payload)?;
                    reader.end_array()
                }
                _ => {
                    reader.go_back(start);
                    *self = wire::Decode::decode(reader)?;
                    Ok(())
                }
            }
        }
    }
    proto::__serde_impls!(TorqueSensorSettings);
    impl check::Validate for TorqueSensorSettings {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            match self {
                Self::Tcp { connection, payload } => {
                    place.check("connection", connection, &check::Limits::NONE)?;
                    place.check("payload", payload, &check::Limits::NONE)?;
                }
                Self::Serial { connection, payload } => {
                    place.check("connection", connection, &check::Limits::NONE)?;
                    place.check("payload", payload, &check::Limits::NONE)?;
                }
                Self::Other(_) => {}
            }
            Ok(())
        }
    }
    /// Network address of a torque sensor.
    #[derive(Debug, Clone, PartialEq)]
    pub struct TorqueSensorTcp {
        /// IP address.
        pub address: String,
        /// TCP port.
        pub port: i64,
    }
    impl wire::Encode for TorqueSensorTcp {
        fn encode(&self, out: &mut wire::Writer) {
            out.raw("[");
            wire::Encode::encode(&self.address, out);
            out.raw(",");
            wire::Encode::encode(&self.port, out);
            out.raw("]");
        }
    }
    impl wire::Decode for TorqueSensorTcp {
        fn decode(reader: &mut wire::Reader<'_>) -> Result<Self, wire::DecodeError> {
            reader.begin_array()?;
            let this = Self {
                address: reader.element("address")?,
                port: reader.element("port")?,
            };
            reader.end_array()?;
            Ok(this)
        }
        fn decode_into(
            &mut self,
            reader: &mut wire::Reader<'_>,
        ) -> Result<(), wire::DecodeError> {
            reader.begin_array()?;
            reader.element_into("address", &mut self.address)?;
            reader.element_into("port", &mut self.port)?;
            reader.end_array()
        }
    }
    proto::__serde_impls!(TorqueSensorTcp);
    impl check::Validate for TorqueSensorTcp {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("address", &self.address, &check::Limits::NONE)?;
            place.check("port", &self.port, &check::Limits::NONE)?;
            Ok(())
        }
    }
    /// Serial settings of a torque sensor.
    #[derive(Debug, Clone, PartialEq)]
    pub struct TorqueSensorSerial {
        /// Baud rate.
        pub baud_rate: i64,
        /// Data bits.
        pub data_bits: i64,
        /// Stop bits.
        pub stop_bits: i64,
        /// Parity. The document does not say how it is written, and whether as number or text.
        pub parity: wire::Value,
    }
    impl wire::Encode for TorqueSensorSerial {
        fn encode(&self, out: &mut wire::Writer) {
            out.raw("[");
            wire::Encode::encode(&self.baud_rate, out);
            out.raw(",");
            wire::Encode::encode(&self.data_bits, out);
            out.raw(",");
            wire::Encode::encode(&self.stop_bits, out);
            out.raw(",");
            wire::Encode::encode(&self.parity, out);
            out.raw("]");
        }
    }
    impl wire::Decode for TorqueSensorSerial {
        fn decode(reader: &mut wire::Reader<'_>) -> Result<Self, wire::DecodeError> {
            reader.begin_array()?;
            let this = Self {
                baud_rate: reader.element("baud_rate")?,
                data_bits: reader.element("data_bits")?,
                stop_bits: reader.element("stop_bits")?,
                parity: reader.element("parity")?,
            };
            reader.end_array()?;
            Ok(this)
        }
        fn decode_into(
            &mut self,
            reader: &mut wire::Reader<'_>,
        ) -> Result<(), wire::DecodeError> {
            reader.begin_array()?;
            reader.element_into("baud_rate", &mut self.baud_rate)?;
            reader.element_into("data_bits", &mut self.data_bits)?;
            reader.element_into("stop_bits", &mut self.stop_bits)?;
            reader.element_into("parity", &mut self.parity)?;
            reader.end_array()
        }
    }
    proto::__serde_impls!(TorqueSensorSerial);
    impl check::Validate for TorqueSensorSerial {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("baud_rate", &self.baud_rate, &check::Limits::NONE)?;
            place.check("data_bits", &self.data_bits, &check::Limits::NONE)?;
            place.check("stop_bits", &self.stop_bits, &check::Limits::NONE)?;
            place.check("parity", &self.parity, &check::Limits::NONE)?;
            Ok(())
        }
    }
    /// Payload at the torque sensor.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct TorqueSensorPayload {
        /// Mass of the payload. In kg.
        pub mass: f64,
        /// Centroid of the payload.
        pub centroid: super::payload::Centroid,
    }
    impl wire::Encode for TorqueSensorPayload {
        fn encode(&self, out: &mut wire::Writer) {
            out.raw("[");
            wire::Encode::encode(&self.mass, out);
            out.raw(",");
            wire::Encode::encode(&self.centroid, out);
            out.raw("]");
        }
    }
    impl wire::Decode for TorqueSensorPayload {
        fn decode(reader: &mut wire::Reader<'_>) -> Result<Self, wire::DecodeError> {
            reader.begin_array()?;
            let this = Self {
                mass: reader.element("mass")?,
                centroid: reader.element("centroid")?,
            };
            reader.end_array()?;
            Ok(this)
        }
    }
    proto::__serde_impls!(TorqueSensorPayload);
    impl check::Validate for TorqueSensorPayload {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place
                .check(
                    "mass",
                    &self.mass,
                    &check::Limits {
                        unit: "kg",
                        ..check::Limits::NONE
                    },
                )?;
            place.check("centroid", &self.centroid, &check::Limits::NONE)?;
            Ok(())
        }
    }
    /// Whether the torque sensor works, and what it reads.
    ///
    /// The document states no units for what it reads, and not the order of the six values.
    #[derive(Debug, Clone, PartialEq)]
    pub struct TorqueSensorState {
        /// Whether the sensor works; it is off otherwise.
        pub working: bool,
        /// Error code of the sensor. The document does not say how it is written.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub error_code: wire::Typed<i64>,
        /// Actual contact force, six values. Unit and order not stated.
        pub contact_force: [f64; 6],
        /// Raw reading of the sensor, six values. Unit and order not stated.
        pub raw_reading: [f64; 6],
    }
    impl wire::Encode for TorqueSensorState {
        fn encode(&self, out: &mut wire::Writer) {
            out.raw("[");
            out.choose(*&self.working, "0", "1");
            out.raw(",");
            match &self.error_code {
                wire::Typed::Known(value) => {
                    wire::Encode::encode(value, out);
                }
                wire::Typed::Raw(value) => wire::Encode::encode(value, out),
            }
            out.raw(",");
            wire::Encode::encode(&self.contact_force, out);
            out.raw(",");
            wire::Encode::encode(&self.raw_reading, out);
            out.raw("]");
        }
    }
    impl wire::Decode for TorqueSensorState {
        fn decode(reader: &mut wire::Reader<'_>) -> Result<Self, wire::DecodeError> {
            reader.begin_array()?;
            let this = Self {
                working: reader.element("working")?,
                error_code: reader.element("error_code")?,
                contact_force: reader.element("contact_force")?,
                raw_reading: reader.element("raw_reading")?,
            };
            reader.end_array()?;
            Ok(this)
        }
        fn decode_into(
            &mut self,
            reader: &mut wire::Reader<'_>,
        ) -> Result<(), wire::DecodeError> {
            reader.begin_array()?;
            reader.element_into("working", &mut self.working)?;
            reader.element_into("error_code", &mut self.error_code)?;
            reader.element_into("contact_force", &mut self.contact_force)?;
            reader.element_into("raw_reading", &mut self.raw_reading)?;
            reader.end_array()
        }
    }
    proto::__serde_impls!(TorqueSensorState);
    impl check::Validate for TorqueSensorState {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("working", &self.working, &check::Limits::NONE)?;
            place.check("error_code", &self.error_code, &check::Limits::NONE)?;
            place.check("contact_force", &self.contact_force, &check::Limits::NONE)?;
            place.check("raw_reading", &self.raw_reading, &check::Limits::NONE)?;
            Ok(())
        }
    }
}
