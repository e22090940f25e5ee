pub mod status {
    //! Status packet of port 10000.
    //!
    //! Packets that the controller sends on port 10000 periodically, without a request.
    //!
    //! The packets follow each other without anything between them: about every 30 ms on firmware 1.5.14, every 50 or 100 ms
    //! elsewhere (field notes). Keys may be missing, newer firmware adds some, and lengths of arrays differ.
    //!
    //! The document explains the keys up to `current_user_id`, and prints only a value or a length of those after it: a page is probably lost in
    //! the copy at hand. The vendor's English page, which a public client has copied, explains more of them.
    //!
    //! Several clients can read at once. One that falls behind is given old packets: read on to the newest one before one counts (field notes).
    //!
    //! Controllers write a blank after each comma and colon, and `len` counts the blanks: so do all 312 packets that were captured. Numbers that
    //! may have a fraction always have one, `0.0` or `47.0`; joints have 5 decimals in
    //! packets, and replies of port 10001 at most 6 (captures).
    /// State of the robot, as one packet of port 10000 gives it.
    ///
    /// Any key may be absent. Those that newer firmware adds stand last here; a controller sends them among the others (capture). A refused
    /// command on port 10001 does not show here.
    #[derive(Debug, Clone, PartialEq, Default)]
    #[non_exhaustive]
    pub struct RobotStatus {
        /// Length of the packet, itself included. In bytes. `len` on the wire.
        ///
        /// The document says that packets are at most 5000 bytes as a rule; 9 KB have been seen, and newer firmware is said to send
        /// up to 15 KB (field notes).
        pub length: Option<i64>,
        /// Whether the robot is in drag mode.
        pub drag_status: Option<bool>,
        /// Configuration and state of the extension I/O modules. Absent on firmware 1.5.14.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub extio: Option<wire::Typed<ExtioReport>>,
        /// Code of the controller's event, which is not always an error: a hexadecimal number such as `0x0`, which says that there is none. `errcode` on the wire.
        ///
        /// `0x10f0005`, say, is the information that the robot is disabled, and may be of an event that is over. `ControllerEvent` of the
        /// Rust crates reads the code and knows the severity.
        pub error_code: Option<String>,
        /// Message of the controller for `error_code`. `errmsg` on the wire.
        pub error_message: Option<String>,
        /// Measurements in the cabinet and the joints, for diagnosis.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub monitor_data: Option<wire::Typed<MonitorData>>,
        /// Settings and state of the torque sensor. `torqsensor` on the wire.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub torque_sensor: Option<wire::Typed<TorqueSensorReport>>,
        /// Actual positions of the six joints. In deg.
        pub joint_actual_position: Option<super::types::JointPosition>,
        /// Actual pose of the tool centre point in Cartesian space.
        pub actual_position: Option<super::types::Pose>,
        /// All digital inputs. 135 on firmware 1.5.14, 199 on newer firmware (captures); 136, 144 and 200 are seen too. `din` on the wire.
        pub digital_inputs: Option<Vec<bool>>,
        /// All digital outputs of the cabinet. 135 on firmware 1.5.14, 199 on newer firmware (captures); the document prints 144. `dout` on the wire.
        pub digital_outputs: Option<Vec<bool>>,
        /// All analog inputs of the cabinet. 64, 66 or 128, depending on the firmware. Unit not stated. `ain` on the wire.
        pub analog_inputs: Option<Vec<f64>>,
        /// All analog outputs of the cabinet. The document prints 66; newer firmware sends 128 (capture). Unit not stated. `aout` on the wire.
        pub analog_outputs: Option<Vec<f64>>,
        /// All digital inputs of the tool. The document prints 8. `tio_din` on the wire.
        pub tool_digital_inputs: Option<Vec<bool>>,
        /// All digital outputs of the tool. The document prints 8. `tio_dout` on the wire.
        pub tool_digital_outputs: Option<Vec<bool>>,
        /// All analog inputs of the tool. 2 on firmware 1.5.14 and newer firmware (captures); the document prints 1. Unit not stated. `tio_ain` on the wire.
        pub tool_analog_inputs: Option<Vec<f64>>,
        /// Whether the robot has power and is enabled.
        pub task_state: Option<TaskState>,
        /// Whether each joint is homed. Withdrawn.
        ///
        /// Nine elements: six of 1 and three of 0 in the captures of firmware 1.5.14 and of newer firmware.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub homed: Option<wire::Typed<Vec<bool>>>,
        /// Task mode of the robot.
        pub task_mode: Option<TaskMode>,
        /// State of the program. `interp_state` on the wire.
        pub interpreter_state: Option<InterpreterState>,
        /// Whether the robot is enabled.
        pub enabled: Option<bool>,
        /// Whether the program is paused.
        pub paused: Option<bool>,
        /// Rate by which motions are scaled; 1 in the document's sample. `rapidrate` on the wire.
        pub rapid_rate: Option<f64>,
        /// Index of the present tool frame.
        pub current_tool_id: Option<i64>,
        /// Index of the present user frame. `current_user_id` on the wire.
        pub current_user_frame_id: Option<i64>,
        /// Whether a soft limit was hit: 1 if so (vendor's English page); passed on as it is.
        ///
        /// The captures have 0. The document does not explain it, and prints 1 in its sample, for a robot that is enabled and in position.
        pub on_soft_limit: Option<i64>,
        /// Whether the robot is in an emergency stop (vendor's English page).
        pub emergency_stop: Option<bool>,
        /// For each joint, whether it is near its limit in drag mode, by the name (vendor's English page).
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub drag_near_limit: Option<wire::Typed<Vec<i64>>>,
        /// The input of each function. `funcdi` on the wire.
        ///
        /// 15 of them in the captures, \[-1, -1] where none is assigned; 12 and 13 have been seen too. [`get_funcdi_status`](crate::messages::io::GetFuncdiStatus) names the functions.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub function_inputs: Option<wire::Typed<Vec<super::io::FunctionInput>>>,
        /// Whether the robot has power (vendor's English page).
        pub powered_on: Option<bool>,
        /// Whether the robot is in position (vendor's English page). `inpos` on the wire.
        ///
        /// It stays true for some 100 ms after a motion is accepted, and a motion of length zero may never drop it (field notes).
        pub in_position: Option<bool>,
        /// Withdrawn (vendor's English page). The document prints 1.
        pub motion_mode: Option<i64>,
        /// Speed of the tool centre point (vendor's English page). In mm/s. `curr_tcp_trans_vel` on the wire.
        pub tcp_speed: Option<f64>,
        /// Whether the robot is in a protective stop (vendor's English page).
        ///
        /// [`protective_stop_status`](crate::messages::collision::ProtectiveStopStatus) reads the key of the same name.
        pub protective_stop: Option<bool>,
        /// The button at the arm's end (vendor's English page).
        pub point_key: Option<i64>,
        /// Withdrawn (vendor's English page). The document prints 1. `netState` on the wire.
        pub network_state: Option<i64>,
        /// Commanded positions of the six joints. In deg. Sent by newer firmware. `joint_position` on the wire.
        pub joint_commanded_position: Option<super::types::JointPosition>,
        /// Commanded pose of the tool centre point. Sent by newer firmware. `position` on the wire.
        pub commanded_position: Option<super::types::Pose>,
        /// Keys at the tool: free, point and pause, in this order. Sent by newer firmware. `tio_key` on the wire.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub tool_keys: Option<wire::Typed<Vec<i64>>>,
        /// Speeds of the six joints. Sent by newer firmware. Unit not stated. `instVel` on the wire.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub joint_velocities: Option<wire::Typed<Vec<f64>>>,
        /// Relays, by the name; 2 of them. Sent by newer firmware, not explained. `relay_io` on the wire.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub relay_outputs: Option<wire::Typed<Vec<bool>>>,
        /// Digital inputs of the Modbus slave, by the name; 128 of them. Sent by newer firmware, not explained. `mb_slave_din` on the wire.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub modbus_slave_digital_inputs: Option<wire::Typed<Vec<bool>>>,
        /// Digital outputs of the Modbus slave, by the name; 128 of them. Sent by newer firmware, not explained. `mb_slave_dout` on the wire.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub modbus_slave_digital_outputs: Option<wire::Typed<Vec<bool>>>,
        /// Analog inputs of the Modbus slave, by the name; 64 of them. Sent by newer firmware, not explained. `mb_slave_ain` on the wire.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub modbus_slave_analog_inputs: Option<wire::Typed<Vec<f64>>>,
        /// Analog outputs of the Modbus slave, by the name; 64 of them. Sent by newer firmware, not explained. `mb_slave_aout` on the wire.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub modbus_slave_analog_outputs: Option<wire::Typed<Vec<f64>>>,
        /// Digital inputs of the Profinet device, by the name; 64 of them. Sent by newer firmware, not explained. `pn_dev_din` on the wire.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub profinet_device_digital_inputs: Option<wire::Typed<Vec<bool>>>,
        /// Digital outputs of the Profinet device, by the name; 64 of them. Sent by newer firmware, not explained. `pn_dev_dout` on the wire.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub profinet_device_digital_outputs: Option<wire::Typed<Vec<bool>>>,
        /// Analog inputs of the Profinet device, by the name; 64 of them. Sent by newer firmware, not explained. `pn_dev_ain` on the wire.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub profinet_device_analog_inputs: Option<wire::Typed<Vec<f64>>>,
        /// Analog outputs of the Profinet device, by the name; 64 of them. Sent by newer firmware, not explained. `pn_dev_aout` on the wire.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub profinet_device_analog_outputs: Option<wire::Typed<Vec<f64>>>,
        /// Digital inputs of the EtherNet/IP adapter, by the name; 64 of them. Sent by newer firmware, not explained. `eip_adpt_din` on the wire.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub ethernet_ip_adapter_digital_inputs: Option<wire::Typed<Vec<bool>>>,
        /// Digital outputs of the EtherNet/IP adapter, by the name; 64 of them. Sent by newer firmware, not explained. `eip_adpt_dout` on the wire.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub ethernet_ip_adapter_digital_outputs: Option<wire::Typed<Vec<bool>>>,
        /// Analog inputs of the EtherNet/IP adapter, by the name; 48 of them. Sent by newer firmware, not explained. `eip_adpt_ain` on the wire.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub ethernet_ip_adapter_analog_inputs: Option<wire::Typed<Vec<f64>>>,
        /// Analog outputs of the EtherNet/IP adapter, by the name; 48 of them. Sent by newer firmware, not explained. `eip_adpt_aout` on the wire.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub ethernet_ip_adapter_analog_outputs: Option<wire::Typed<Vec<f64>>>,
        /// Signals on the tool's serial channels; 8 of them. Sent by newer firmware. `tio_rs_signals` on the wire.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub tool_rs_signals: Option<wire::Typed<Vec<super::beyond_io::ToolSignal>>>,
        /// A line that belongs to a motion, by the name. Sent by newer firmware, not explained.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub motion_line: Option<wire::Typed<i64>>,
        /// A line that belongs to an error, by the name. Sent by newer firmware, not explained. The vendor's SDK has a key of this name that says
        /// that the previous command was dropped. `err_add_line` on the wire.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub error_add_line: Option<wire::Typed<i64>>,
    }
    /// Whether the robot has power and is enabled.
    ///
    /// The document gives 3 and 4 the same meaning, which is a misprint: five clients have 3 as disabled, 4 as enabled.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum TaskState {
        /// The robot has no power. `1` on the wire.
        PoweredOff,
        /// The robot has power.
        ///
        /// Which of 2 and 3 follows [`power_on`](crate::messages::power::PowerOn) directly is not shown. `2` on the wire.
        PoweredOn,
        /// The robot has power and is disabled. The document says enabled, as of 4. `3` on the wire.
        Disabled,
        /// The robot is enabled. The document's sample prints it next to `enabled` true. `4` on the wire.
        Enabled,
        /// A value that the spec does not list.
        Other(i64),
    }
    impl From<i64> for TaskState {}
    impl From<TaskState> for i64 {}
    /// The value in words; one that the spec does not list as its number.
    impl ::core::fmt::Display for TaskState {}
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
    impl From<i64> for TaskMode {}
    impl From<TaskMode> for i64 {}
    /// The value in words; one that the spec does not list as its number.
    impl ::core::fmt::Display for TaskMode {}
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
    impl From<i64> for InterpreterState {}
    impl From<InterpreterState> for i64 {}
    /// The value in words; one that the spec does not list as its number.
    impl ::core::fmt::Display for InterpreterState {}
    /// Configuration and state of the extension I/O modules, as port 10000 gives them.
    ///
    /// The document describes the parts and prints no sample. [`get_extio_status`](crate::messages::io::GetExtioStatus) answers the same in another shape.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct ExtioReport {
        /// State of all pins of all modules. `status` on the wire.
        pub pin_states: ExtioPinStates,
        /// Connection of each module, and its pins; 8 modules at most.
        pub setup: Vec<ExtioReportSetup>,
        /// Number of modules. `num` on the wire.
        pub count: i64,
        /// First pins of each module, in the order of `setup`. `pinmap` on the wire.
        pub pin_maps: Vec<ExtioReportPinMap>,
        /// Raw state of the modules. The document contradicts itself on which value says that they run, if this is the `state` of 4.34.
        ///
        /// Sources contradict each other on the meaning, so the value is passed on as it is:
        ///
        /// - document 2.0.4, chapter 2: 0 = on, 1 = off
        /// - document 2.0.4, section 4.34, of `state`, which may mean the same: 0 = does not run, 1 = runs
        pub mode: i64,
    }
    /// State of all pins of the extension I/O modules, by kind.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
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
    /// Connection of an extension I/O module, and its pins, as port 10000 gives them.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub enum ExtioReportSetup {
        /// Connected by Modbus RTU.
        #[non_exhaustive]
        Rtu {
            /// Name of the module.
            name: String,
            /// Serial settings of the connection. The document prints no sample of them.
            ///
            /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
            connection: wire::Typed<super::io::ExtioRtu>,
            /// The module's pins.
            pins: ExtioReportPins,
            /// A fifth value, which newer firmware sends and no source explains: a text that begins with `ext_` in a capture.
            ///
            /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
            fifth: Option<wire::Typed<String>>,
        },
        /// Connected by Modbus TCP.
        #[non_exhaustive]
        Tcp {
            /// Name of the module.
            name: String,
            /// Network address of the module.
            connection: super::io::ExtioTcp,
            /// The module's pins.
            pins: ExtioReportPins,
            /// A fifth value, which newer firmware sends and no source explains: a text that begins with `ext_` in a capture.
            ///
            /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
            fifth: Option<wire::Typed<String>>,
        },
        /// A kind that the spec does not list, as raw JSON.
        Other(wire::Value),
    }
    /// The pins of an extension I/O module, as port 10000 gives them.
    ///
    /// The order is not that of [`get_extio_status`](crate::messages::io::GetExtioStatus), which names the kinds.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
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
    /// First pins of an extension I/O module, as port 10000 gives them.
    ///
    /// The document calls each value an offset of registers here, and an index of pins in 4.34. It prints `pinmap[N][2]` for
    /// the analog inputs and again for the analog outputs; the second is read as `pinmap[N][3]`.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
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
    /// Measurements in the cabinet and the joints, for diagnosis.
    ///
    /// The document states no units.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct MonitorData {
        /// Major version number of the SCB. It can be two ASCII characters as one number, such as 12338 for `02` (vendor's English page).
        pub scb_major_version: i64,
        /// Minor version number of the SCB. It can be two ASCII characters as one number, too.
        pub scb_minor_version: i64,
        /// Temperature of the cabinet. In °C.
        pub cabinet_temperature: f64,
        /// Average power of the cabinet's bus. Unit not stated.
        pub bus_average_power: f64,
        /// Average current of the cabinet's bus. Unit not stated.
        pub bus_average_current: f64,
        /// Measurements of joints 1 to 6.
        pub joints: Vec<JointMonitor>,
        /// A seventh value, which newer firmware sends and no source explains; 0 in a capture.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub seventh: Option<wire::Typed<i64>>,
        /// An eighth value, which newer firmware sends and no source explains; 0 in a capture.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub eighth: Option<wire::Typed<i64>>,
        /// A ninth value, which newer firmware sends and no source explains; 0 in a capture.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub ninth: Option<wire::Typed<i64>>,
        /// Voltage of the bus. In V. Newer firmware sends it.
        pub bus_voltage: Option<f64>,
    }
    /// Measurements of one joint.
    ///
    /// The document states no units. It writes `monitor_data[5][0]` for the current and leaves out the joint; that each joint
    /// has a row of its own comes from captures, whose rows have 11 values, on firmware 1.5.14 and on newer firmware. Rows of 10 are seen too.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
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
        /// Running time in all. In s.
        pub total_running_time: f64,
        /// Running cycles since this start.
        ///
        /// The document has another word here than for `total_revolutions`, and does not say whether both count the same.
        pub cycles_since_start: f64,
        /// Running time since this start. In s.
        pub running_time_since_start: f64,
        /// Torque of the joint from its measured current; 0 without power. In Nm.
        pub torque: f64,
        /// Torque of the controller's model for the pose. In Nm. The measured torque minus it shows a contact.
        pub model_torque: Option<f64>,
    }
    /// Settings and state of the torque sensor.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct TorqueSensorReport {
        /// Connection of the sensor, and its payload.
        pub settings: TorqueSensorSettings,
        /// Whether the sensor works, and what it reads.
        pub state: TorqueSensorState,
    }
    /// Connection of the torque sensor, and its payload.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub enum TorqueSensorSettings {
        /// Connected by TCP/IP.
        #[non_exhaustive]
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
        #[non_exhaustive]
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
    /// Network address of a torque sensor.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct TorqueSensorTcp {
        /// IP address.
        pub address: String,
        /// TCP port.
        pub port: i64,
    }
    /// Serial settings of a torque sensor.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
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
    /// Payload at the torque sensor.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct TorqueSensorPayload {
        /// Mass of the payload. In kg.
        pub mass: f64,
        /// Centroid of the payload.
        pub centroid: super::payload::Centroid,
    }
    /// Whether the torque sensor works, and what it reads.
    ///
    /// The document states no units for what it reads, and not the order of the six values.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct TorqueSensorState {
        /// Whether the sensor works; it is off otherwise.
        pub working: bool,
        /// Error code of the sensor. The document does not say how it is written.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub error_code: wire::Typed<i64>,
        /// Actual contact force, six values, once the sensor is initialised (vendor's English page). Unit and order not stated.
        pub contact_force: [f64; 6],
        /// Raw reading of the sensor, six values. Unit and order not stated.
        pub raw_reading: [f64; 6],
        /// Contact force whatever the initialisation setting of the sensor is. `contact_force` is the force or the raw reading, by that setting.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub unconditional_contact_force: Option<wire::Typed<[f64; 6]>>,
    }
}
