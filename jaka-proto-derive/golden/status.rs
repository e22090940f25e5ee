pub mod status {
    #[derive(Debug, Clone, PartialEq, Default)]
    #[non_exhaustive]
    pub struct RobotStatus {
        // unit "bytes"
        pub length: Option<i64>,
        pub drag_status: Option<bool>,
        pub extio: Option<wire::Typed<ExtioReport>>,
        pub error_code: Option<String>,
        pub error_message: Option<String>,
        pub monitor_data: Option<wire::Typed<MonitorData>>,
        pub torque_sensor: Option<wire::Typed<TorqueSensorReport>>,
        pub joint_actual_position: Option<super::types::JointPosition>,
        pub actual_position: Option<super::types::Pose>,
        pub digital_inputs: Option<Vec<bool>>,
        pub digital_outputs: Option<Vec<bool>>,
        pub analog_inputs: Option<Vec<f64>>,
        pub analog_outputs: Option<Vec<f64>>,
        pub tool_digital_inputs: Option<Vec<bool>>,
        pub tool_digital_outputs: Option<Vec<bool>>,
        pub tool_analog_inputs: Option<Vec<f64>>,
        pub task_state: Option<TaskState>,
        pub homed: Option<wire::Typed<Vec<bool>>>,
        pub task_mode: Option<TaskMode>,
        pub interpreter_state: Option<InterpreterState>,
        pub enabled: Option<bool>,
        pub paused: Option<bool>,
        pub rapid_rate: Option<f64>,
        pub current_tool_id: Option<i64>,
        pub current_user_frame_id: Option<i64>,
        pub on_soft_limit: Option<i64>,
        pub emergency_stop: Option<bool>,
        pub drag_near_limit: Option<wire::Typed<Vec<i64>>>,
        pub function_inputs: Option<wire::Typed<Vec<super::io::FunctionInput>>>,
        pub powered_on: Option<bool>,
        pub in_position: Option<bool>,
        pub motion_mode: Option<i64>,
        // unit "mm/s"
        pub tcp_speed: Option<f64>,
        pub protective_stop: Option<bool>,
        pub point_key: Option<i64>,
        pub network_state: Option<i64>,
        pub joint_commanded_position: Option<super::types::JointPosition>,
        pub commanded_position: Option<super::types::Pose>,
        pub tool_keys: Option<wire::Typed<Vec<i64>>>,
        pub joint_velocities: Option<wire::Typed<Vec<f64>>>,
        pub relay_outputs: Option<wire::Typed<Vec<bool>>>,
        pub modbus_slave_digital_inputs: Option<wire::Typed<Vec<bool>>>,
        pub modbus_slave_digital_outputs: Option<wire::Typed<Vec<bool>>>,
        pub modbus_slave_analog_inputs: Option<wire::Typed<Vec<f64>>>,
        pub modbus_slave_analog_outputs: Option<wire::Typed<Vec<f64>>>,
        pub profinet_device_digital_inputs: Option<wire::Typed<Vec<bool>>>,
        pub profinet_device_digital_outputs: Option<wire::Typed<Vec<bool>>>,
        pub profinet_device_analog_inputs: Option<wire::Typed<Vec<f64>>>,
        pub profinet_device_analog_outputs: Option<wire::Typed<Vec<f64>>>,
        pub ethernet_ip_adapter_digital_inputs: Option<wire::Typed<Vec<bool>>>,
        pub ethernet_ip_adapter_digital_outputs: Option<wire::Typed<Vec<bool>>>,
        pub ethernet_ip_adapter_analog_inputs: Option<wire::Typed<Vec<f64>>>,
        pub ethernet_ip_adapter_analog_outputs: Option<wire::Typed<Vec<f64>>>,
        pub tool_rs_signals: Option<wire::Typed<Vec<super::beyond_io::ToolSignal>>>,
        pub motion_line: Option<wire::Typed<i64>>,
        pub error_add_line: Option<wire::Typed<i64>>,
    }
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum TaskState {
        PoweredOff,
        PoweredOn,
        Disabled,
        Enabled,
        Other(i64),
    }
    impl From<i64> for TaskState {}
    impl From<TaskState> for i64 {}
    impl ::core::fmt::Display for TaskState {}
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum TaskMode {
        Manual,
        Automatic,
        Reserved,
        Drag,
        Other(i64),
    }
    impl From<i64> for TaskMode {}
    impl From<TaskMode> for i64 {}
    impl ::core::fmt::Display for TaskMode {}
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum InterpreterState {
        Idle,
        Loading,
        Paused,
        Running,
        Other(i64),
    }
    impl From<i64> for InterpreterState {}
    impl From<InterpreterState> for i64 {}
    impl ::core::fmt::Display for InterpreterState {}
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct ExtioReport {
        pub pin_states: ExtioPinStates,
        pub setup: Vec<ExtioReportSetup>,
        pub count: i64,
        pub pin_maps: Vec<ExtioReportPinMap>,
        pub mode: i64,
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct ExtioPinStates {
        pub digital_inputs: Vec<bool>,
        pub digital_outputs: Vec<bool>,
        pub analog_inputs: Vec<f64>,
        pub analog_outputs: Vec<f64>,
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub enum ExtioReportSetup {
        #[non_exhaustive]
        Rtu {
            name: String,
            connection: wire::Typed<super::io::ExtioRtu>,
            pins: ExtioReportPins,
            fifth: Option<wire::Typed<String>>,
        },
        #[non_exhaustive]
        Tcp {
            name: String,
            connection: super::io::ExtioTcp,
            pins: ExtioReportPins,
            fifth: Option<wire::Typed<String>>,
        },
        Other(wire::Value),
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct ExtioReportPins {
        pub digital_inputs: super::io::ExtioPinRange,
        pub digital_outputs: super::io::ExtioPinRange,
        pub analog_inputs: super::io::ExtioPinRange,
        pub analog_outputs: super::io::ExtioPinRange,
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct ExtioReportPinMap {
        pub digital_inputs: i64,
        pub digital_outputs: i64,
        pub analog_inputs: i64,
        pub analog_outputs: i64,
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct MonitorData {
        pub scb_major_version: i64,
        pub scb_minor_version: i64,
        // unit "°C"
        pub cabinet_temperature: f64,
        pub bus_average_power: f64,
        pub bus_average_current: f64,
        pub joints: Vec<JointMonitor>,
        pub seventh: Option<wire::Typed<i64>>,
        pub eighth: Option<wire::Typed<i64>>,
        pub ninth: Option<wire::Typed<i64>>,
        // unit "V"
        pub bus_voltage: Option<f64>,
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct JointMonitor {
        pub current: f64,
        pub voltage: f64,
        pub temperature: f64,
        pub average_power: f64,
        pub current_fluctuation: f64,
        pub total_revolutions: f64,
        // unit "s"
        pub total_running_time: f64,
        pub cycles_since_start: f64,
        // unit "s"
        pub running_time_since_start: f64,
        // unit "Nm"
        pub torque: f64,
        // unit "Nm"
        pub model_torque: Option<f64>,
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct TorqueSensorReport {
        pub settings: TorqueSensorSettings,
        pub state: TorqueSensorState,
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub enum TorqueSensorSettings {
        #[non_exhaustive]
        Tcp {
            connection: TorqueSensorTcp,
            payload: wire::Typed<TorqueSensorPayload>,
        },
        #[non_exhaustive]
        Serial {
            connection: wire::Typed<TorqueSensorSerial>,
            payload: wire::Typed<TorqueSensorPayload>,
        },
        Other(wire::Value),
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct TorqueSensorTcp {
        pub address: String,
        pub port: i64,
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct TorqueSensorSerial {
        pub baud_rate: i64,
        pub data_bits: i64,
        pub stop_bits: i64,
        pub parity: wire::Value,
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct TorqueSensorPayload {
        // unit "kg"
        pub mass: f64,
        pub centroid: super::payload::Centroid,
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct TorqueSensorState {
        pub working: bool,
        pub error_code: wire::Typed<i64>,
        pub contact_force: [f64; 6],
        pub raw_reading: [f64; 6],
        pub unconditional_contact_force: Option<wire::Typed<[f64; 6]>>,
    }
}
