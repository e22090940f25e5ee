pub mod io {
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Setting, role: Some(Role::Output)
    pub struct SetDigitalOutput {
        pub kind: DigitalOutputKind,
        // min 0
        pub index: i64,
        pub value: super::types::Switch,
    }
    impl SetDigitalOutput {
        pub const fn new(
            kind: DigitalOutputKind,
            index: i64,
            value: super::types::Switch,
        ) -> Self {}
        pub const fn cabinet(index: i64, value: super::types::Switch) -> Self {}
        pub const fn tool(index: i64, value: super::types::Switch) -> Self {}
        pub const fn extension(index: i64, value: super::types::Switch) -> Self {}
        pub const fn relay(index: i64, value: super::types::Switch) -> Self {}
        pub const fn modbus_slave(index: i64, value: super::types::Switch) -> Self {}
        pub const fn profinet(index: i64, value: super::types::Switch) -> Self {}
        pub const fn ethernet_ip(index: i64, value: super::types::Switch) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query, role: Some(Role::State)
    pub struct GetDigitalInputStatus {}
    impl GetDigitalInputStatus {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetDigitalInputStatusReply {
        pub digital_inputs: Vec<bool>,
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Setting, role: Some(Role::Output)
    pub struct SetAnalogOutput {
        pub kind: AnalogOutputKind,
        // min 0
        pub index: i64,
        pub value: f64,
    }
    impl SetAnalogOutput {
        pub const fn new(kind: AnalogOutputKind, index: i64, value: f64) -> Self {}
        pub const fn cabinet(index: i64, value: f64) -> Self {}
        pub const fn tool(index: i64, value: f64) -> Self {}
        pub const fn extension(index: i64, value: f64) -> Self {}
        pub const fn reserved(index: i64, value: f64) -> Self {}
        pub const fn modbus_slave(index: i64, value: f64) -> Self {}
        pub const fn profinet(index: i64, value: f64) -> Self {}
        pub const fn ethernet_ip(index: i64, value: f64) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query, role: Some(Role::State), bare_reply: Some("extio_status")
    pub struct GetExtioStatus {}
    impl GetExtioStatus {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetExtioStatusReply {
        pub extio_status: ExtioStatus,
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query, role: Some(Role::State)
    pub struct GetFuncdiStatus {}
    impl GetFuncdiStatus {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetFuncdiStatusReply {
        pub function_inputs: Vec<FunctionInput>,
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Setting
    pub struct SetTioVoutParam {
        // min 0, max 1
        pub output_enable: i64,
        // min 0, max 1
        pub output_voltage: i64,
    }
    impl SetTioVoutParam {
        pub const fn new(output_enable: i64, output_voltage: i64) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query
    pub struct GetTioVoutParam {}
    impl GetTioVoutParam {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetTioVoutParamReply {
        pub output_enable: i64,
        pub output_voltage: i64,
    }
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum DigitalOutputKind {
        Cabinet,
        Tool,
        Extension,
        Relay,
        ModbusSlave,
        Profinet,
        EthernetIp,
        Other(i64),
    }
    impl From<i64> for DigitalOutputKind {}
    impl From<DigitalOutputKind> for i64 {}
    impl ::core::fmt::Display for DigitalOutputKind {}
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum AnalogOutputKind {
        Cabinet,
        Tool,
        Extension,
        Reserved,
        ModbusSlave,
        Profinet,
        EthernetIp,
        Other(i64),
    }
    impl From<i64> for AnalogOutputKind {}
    impl From<AnalogOutputKind> for i64 {}
    impl ::core::fmt::Display for AnalogOutputKind {}
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct ExtioStatus {
        pub count: i64,
        pub modules: Vec<ExtioModule>,
        pub state: ExtioState,
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct ExtioModule {
        pub setup: ExtioSetup,
        pub pin_map: ExtioPinMap,
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub enum ExtioSetup {
        #[non_exhaustive]
        Rtu {
            name: String,
            connection: wire::Typed<ExtioRtu>,
            pins: ExtioPins,
        },
        #[non_exhaustive]
        Tcp {
            name: String,
            connection: ExtioTcp,
            pins: ExtioPins,
        },
        Other(wire::Value),
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct ExtioRtu {
        pub baud_rate: i64,
        pub data_bit_length: i64,
        pub slave_id: i64,
        pub data_bits: i64,
        pub parity: wire::Value,
        pub stop_bit_length: i64,
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct ExtioTcp {
        pub address: String,
        pub port: i64,
        pub slave_id: Option<i64>,
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct ExtioPins {
        pub analog_inputs: ExtioPinRange,
        pub digital_outputs: ExtioPinRange,
        pub analog_outputs: ExtioPinRange,
        pub digital_inputs: ExtioPinRange,
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct ExtioPinRange {
        pub start: i64,
        pub count: i64,
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct ExtioPinMap {
        pub analog_inputs: i64,
        pub digital_outputs: i64,
        pub analog_outputs: i64,
        pub digital_inputs: i64,
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct ExtioState {
        pub running: bool,
        pub digital_inputs: Option<Vec<bool>>,
        pub digital_outputs: Option<Vec<bool>>,
        pub analog_inputs: Option<Vec<f64>>,
        pub analog_outputs: Option<Vec<f64>>,
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct FunctionInput {
        pub kind: FunctionInputKind,
        pub index: i64,
    }
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum FunctionInputKind {
        Unassigned,
        Cabinet,
        Tool,
        Modbus,
        Other(i64),
    }
    impl From<i64> for FunctionInputKind {}
    impl From<FunctionInputKind> for i64 {}
    impl ::core::fmt::Display for FunctionInputKind {}
}
