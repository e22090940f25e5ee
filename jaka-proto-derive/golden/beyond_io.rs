pub mod beyond_io {
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Query, firmware: since([1, 5, 15])
    pub struct GetDigitalOutput {
        pub kind: super::io::DigitalOutputKind,
        // min 0
        pub index: i64,
    }
    impl GetDigitalOutput {
        pub const fn new(kind: super::io::DigitalOutputKind, index: i64) -> Self {}
        pub const fn cabinet(index: i64) -> Self {}
        pub const fn tool(index: i64) -> Self {}
        pub const fn extension(index: i64) -> Self {}
        pub const fn relay(index: i64) -> Self {}
        pub const fn modbus_slave(index: i64) -> Self {}
        pub const fn profinet(index: i64) -> Self {}
        pub const fn ethernet_ip(index: i64) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetDigitalOutputReply {
        pub value: bool,
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Query, firmware: since([1, 5, 15])
    pub struct GetDigitalInput {
        // min 0
        pub kind: i64,
        // min 0
        pub index: i64,
    }
    impl GetDigitalInput {
        pub const fn new(kind: i64, index: i64) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetDigitalInputReply {
        pub value: bool,
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Query, firmware: since([1, 5, 15])
    pub struct GetAnalogOutput {
        pub kind: super::io::AnalogOutputKind,
        // min 0
        pub index: i64,
    }
    impl GetAnalogOutput {
        pub const fn new(kind: super::io::AnalogOutputKind, index: i64) -> Self {}
        pub const fn cabinet(index: i64) -> Self {}
        pub const fn tool(index: i64) -> Self {}
        pub const fn extension(index: i64) -> Self {}
        pub const fn reserved(index: i64) -> Self {}
        pub const fn modbus_slave(index: i64) -> Self {}
        pub const fn profinet(index: i64) -> Self {}
        pub const fn ethernet_ip(index: i64) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetAnalogOutputReply {
        pub value: f64,
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Query, firmware: since([1, 5, 15])
    pub struct GetAnalogInput {
        // min 0
        pub kind: i64,
        // min 0
        pub index: i64,
    }
    impl GetAnalogInput {
        pub const fn new(kind: i64, index: i64) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetAnalogInputReply {
        pub value: f64,
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    // Setting, firmware: since([1, 5, 15])
    pub struct SendTioRsCommand {
        pub channel: SerialChannel,
        // min 0, max 255
        pub bytes: Vec<i64>,
    }
    impl SendTioRsCommand {
        pub const fn new(channel: SerialChannel, bytes: Vec<i64>) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Query, firmware: since([1, 5, 15])
    pub struct GetTioPinMode {
        pub pin_type: ToolPinType,
    }
    impl GetTioPinMode {
        pub const fn new(pin_type: ToolPinType) -> Self {}
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetTioPinModeReply {
        pub pin_mode: wire::Typed<i64>,
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Setting, firmware: since([1, 5, 15])
    pub struct SetTioPinMode {
        pub pin_type: ToolPinType,
        // min 0, max 255
        pub pin_mode: i64,
    }
    impl SetTioPinMode {
        pub const fn new(pin_type: ToolPinType, pin_mode: i64) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Query, firmware: since([1, 5, 15])
    pub struct GetRs485ChnMode {
        pub channel: SerialChannel,
    }
    impl GetRs485ChnMode {
        pub const fn new(channel: SerialChannel) -> Self {}
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetRs485ChnModeReply {
        pub mode: wire::Typed<SerialChannelMode>,
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Setting, firmware: since([1, 5, 15])
    pub struct SetRs485ChnMode {
        pub channel: SerialChannel,
        pub mode: SerialChannelMode,
    }
    impl SetRs485ChnMode {
        pub const fn new(channel: SerialChannel, mode: SerialChannelMode) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Query, firmware: since([1, 5, 15])
    pub struct GetRs485ChnComm {
        pub channel: SerialChannel,
    }
    impl GetRs485ChnComm {
        pub const fn new(channel: SerialChannel) -> Self {}
    }
    #[derive(Debug, Clone, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetRs485ChnCommReply {
        pub slave_id: Option<wire::Typed<i64>>,
        pub baud_rate: Option<wire::Typed<i64>>,
        pub data_bits: Option<wire::Typed<i64>>,
        pub stop_bits: Option<wire::Typed<i64>>,
        pub parity: Option<wire::Typed<SerialParity>>,
    }
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    // Setting, firmware: since([1, 5, 15])
    pub struct SetRs485ChnComm {
        pub channel: SerialChannel,
        // min 0
        pub slave_id: i64,
        // min 4800, max 230400
        pub baud_rate: i64,
        // min 7, max 8
        pub data_bits: i64,
        // min 1, max 2
        pub stop_bits: i64,
        pub parity: SerialParity,
    }
    impl SetRs485ChnComm {
        pub const fn new(
            channel: SerialChannel,
            slave_id: i64,
            baud_rate: i64,
            data_bits: i64,
            stop_bits: i64,
            parity: SerialParity,
        ) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query, firmware: since([1, 5, 15])
    pub struct GetRs485SignalList {}
    impl GetRs485SignalList {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query, firmware: since([1, 5, 15])
    pub struct GetTioSignals {}
    impl GetTioSignals {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetTioSignalsReply {
        pub signals: wire::Typed<Vec<ToolSignal>>,
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    // Setting, firmware: since([1, 5, 15])
    pub struct AddTioRsSignal {
        pub name: String,
        pub channel: SerialChannel,
        // min 0
        pub signal_type: i64,
        // min 0
        pub address: i64,
        // min 0, max 10
        pub frequency: f64,
    }
    impl AddTioRsSignal {
        pub fn new(
            name: impl Into<String>,
            channel: SerialChannel,
            signal_type: i64,
            address: i64,
            frequency: f64,
        ) -> Self {}
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    // Setting, firmware: since([1, 5, 15])
    pub struct DeleteTioRsSignal {
        pub name: String,
    }
    impl DeleteTioRsSignal {
        pub fn new(name: impl Into<String>) -> Self {}
    }
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum ToolPinType {
        DigitalInputs,
        DigitalOutputs,
        AnalogInputs,
        Other(i64),
    }
    impl From<i64> for ToolPinType {}
    impl From<ToolPinType> for i64 {}
    impl ::core::fmt::Display for ToolPinType {}
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum SerialChannel {
        Rs485H,
        Rs485L,
        Other(i64),
    }
    impl From<i64> for SerialChannel {}
    impl From<SerialChannel> for i64 {}
    impl ::core::fmt::Display for SerialChannel {}
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum SerialChannelMode {
        ModbusRtu,
        Raw,
        TorqueSensor,
        Other(i64),
    }
    impl From<i64> for SerialChannelMode {}
    impl From<SerialChannelMode> for i64 {}
    impl ::core::fmt::Display for SerialChannelMode {}
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum SerialParity {
        None,
        Odd,
        Even,
        Other(i64),
    }
    impl From<i64> for SerialParity {}
    impl From<SerialParity> for i64 {}
    impl ::core::fmt::Display for SerialParity {}
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct ToolSignal {
        pub name: String,
        pub channel: i64,
        pub signal_type: i64,
        pub address: i64,
        pub value: i64,
        pub frequency: f64,
    }
}
