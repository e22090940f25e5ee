pub mod beyond_io {
    //! Inputs, outputs and the tool's serial channels, beyond the document.
    //!
    //! Commands that the document does not have. Newer firmware answers them, and public clients use them.
    //!
    //! From which firmware on a controller has them is not known. Of firmware 1.5.14 it is known that it refuses [`emergency_stop_status`](crate::messages::beyond_state::EmergencyStopStatus), and it is
    //! taken to lack all of them: `since` is the version after it. The tool's serial channels and their signals come from one client, on port 10001
    //! of a newer MiniCobo, but for [`send_tio_rs_command`](type@SendTioRsCommand), which two clients send.
    /// Reads one digital output.
    ///
    /// Sends `get_digital_output`. Changes nothing on the robot. The reply is [`GetDigitalOutputReply`].
    ///
    /// Taken to be known to firmware 1.5.15 and later.
    ///
    /// Not in the document. Evidence: bytes of the vendor's client library (SDK 2.1.14 sends it); several independent clients (two, one of them on version 1.7.2).
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetDigitalOutput {
        /// Place of the output. `type` on the wire.
        pub kind: super::io::DigitalOutputKind,
        /// Number of the output, sent as given. At least 0. Whether it counts from 0 or from 1 depends on the controller: see [`set_digital_output`](crate::messages::io::SetDigitalOutput).
        pub index: i64,
    }
    impl GetDigitalOutput {
        /// With the required fields alone.
        ///
        /// - `index`: at least 0
        pub const fn new(kind: super::io::DigitalOutputKind, index: i64) -> Self {}
        /// In the control cabinet.
        ///
        /// - `index`: at least 0
        pub const fn cabinet(index: i64) -> Self {}
        /// At the tool end of the arm.
        ///
        /// - `index`: at least 0
        pub const fn tool(index: i64) -> Self {}
        /// On an extension I/O module.
        ///
        /// - `index`: at least 0
        pub const fn extension(index: i64) -> Self {}
        /// A relay output.
        ///
        /// - `index`: at least 0
        pub const fn relay(index: i64) -> Self {}
        /// An output of the Modbus slave.
        ///
        /// - `index`: at least 0
        pub const fn modbus_slave(index: i64) -> Self {}
        /// A Profinet output.
        ///
        /// - `index`: at least 0
        pub const fn profinet(index: i64) -> Self {}
        /// An EtherNet/IP output.
        ///
        /// - `index`: at least 0
        pub const fn ethernet_ip(index: i64) -> Self {}
    }
    /// What the controller answers to [`type@GetDigitalOutput`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetDigitalOutputReply {
        /// State of the output.
        pub value: bool,
    }
    /// Reads one digital input.
    ///
    /// Sends `get_digital_input`. Changes nothing on the robot. The reply is [`GetDigitalInputReply`].
    ///
    /// Taken to be known to firmware 1.5.15 and later.
    ///
    /// Not in the document. Evidence: bytes of the vendor's client library (SDK 2.1.14 sends it); several independent clients (two).
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetDigitalInput {
        /// Place of the input. At least 0. No source lists the values; for digital outputs 0 is the cabinet. `type` on the wire.
        pub kind: i64,
        /// Number of the input, sent as given. At least 0. Whether it counts from 0 or from 1 depends on the controller, as of outputs: see [`set_digital_output`](crate::messages::io::SetDigitalOutput).
        pub index: i64,
    }
    impl GetDigitalInput {
        /// With the required fields alone.
        ///
        /// - `kind`: at least 0
        /// - `index`: at least 0
        pub const fn new(kind: i64, index: i64) -> Self {}
    }
    /// What the controller answers to [`type@GetDigitalInput`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetDigitalInputReply {
        /// State of the input.
        pub value: bool,
    }
    /// Reads one analog output.
    ///
    /// Sends `get_analog_output`. Changes nothing on the robot. The reply is [`GetAnalogOutputReply`].
    ///
    /// Taken to be known to firmware 1.5.15 and later.
    ///
    /// Not in the document. Evidence: bytes of the vendor's client library (SDK 2.1.14 sends it); one client.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetAnalogOutput {
        /// Place of the output. `type` on the wire.
        pub kind: super::io::AnalogOutputKind,
        /// Number of the output, sent as given. At least 0. Whether it counts from 0 or from 1 depends on the controller, as of digital ones: see [`set_digital_output`](crate::messages::io::SetDigitalOutput).
        pub index: i64,
    }
    impl GetAnalogOutput {
        /// With the required fields alone.
        ///
        /// - `index`: at least 0
        pub const fn new(kind: super::io::AnalogOutputKind, index: i64) -> Self {}
        /// In the control cabinet.
        ///
        /// - `index`: at least 0
        pub const fn cabinet(index: i64) -> Self {}
        /// At the tool end of the arm.
        ///
        /// - `index`: at least 0
        pub const fn tool(index: i64) -> Self {}
        /// On an extension I/O module.
        ///
        /// - `index`: at least 0
        pub const fn extension(index: i64) -> Self {}
        /// Reserved; a relay where the output is digital.
        ///
        /// - `index`: at least 0
        pub const fn reserved(index: i64) -> Self {}
        /// An output of the Modbus slave.
        ///
        /// - `index`: at least 0
        pub const fn modbus_slave(index: i64) -> Self {}
        /// A Profinet output.
        ///
        /// - `index`: at least 0
        pub const fn profinet(index: i64) -> Self {}
        /// An EtherNet/IP output.
        ///
        /// - `index`: at least 0
        pub const fn ethernet_ip(index: i64) -> Self {}
    }
    /// What the controller answers to [`type@GetAnalogOutput`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetAnalogOutputReply {
        /// Value of the output. Unit not stated.
        pub value: f64,
    }
    /// Reads one analog input.
    ///
    /// Sends `get_analog_input`. Changes nothing on the robot. The reply is [`GetAnalogInputReply`].
    ///
    /// Taken to be known to firmware 1.5.15 and later.
    ///
    /// Not in the document. Evidence: bytes of the vendor's client library (SDK 2.1.14 sends it).
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetAnalogInput {
        /// Place of the input. At least 0. No source lists the values; for analog outputs 0 is the cabinet. `type` on the wire.
        pub kind: i64,
        /// Number of the input, sent as given. At least 0. Whether it counts from 0 or from 1 depends on the controller, as of outputs: see [`set_digital_output`](crate::messages::io::SetDigitalOutput).
        pub index: i64,
    }
    impl GetAnalogInput {
        /// With the required fields alone.
        ///
        /// - `kind`: at least 0
        /// - `index`: at least 0
        pub const fn new(kind: i64, index: i64) -> Self {}
    }
    /// What the controller answers to [`type@GetAnalogInput`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetAnalogInputReply {
        /// Value of the input. Unit not stated.
        pub value: f64,
    }
    /// Sends bytes on a serial channel of the tool.
    ///
    /// What is connected there may move: a gripper, say.
    ///
    /// Sends `send_tio_rs_command`.
    ///
    /// Taken to be known to firmware 1.5.15 and later.
    ///
    /// Not in the document. Evidence: bytes of the vendor's client library (SDK 2.1.14 sends it); several independent clients (two).
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct SendTioRsCommand {
        /// Channel. `chn_id` on the wire.
        pub channel: SerialChannel,
        /// The bytes, in order. 0 to 255. `cmdBuf` on the wire.
        pub bytes: Vec<i64>,
    }
    impl SendTioRsCommand {
        /// With the required fields alone.
        ///
        /// - `bytes`: 0 to 255
        pub const fn new(channel: SerialChannel, bytes: Vec<i64>) -> Self {}
    }
    /// Reads the use of the tool's pins.
    ///
    /// Sends `get_tio_pin_mode`. Changes nothing on the robot. The reply is [`GetTioPinModeReply`].
    ///
    /// Taken to be known to firmware 1.5.15 and later.
    ///
    /// Not in the document. Evidence: bytes of the vendor's client library (SDK 2.1.14 sends it); one client (on a MiniCobo, port 10001).
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetTioPinMode {
        /// Kind of the pins. `pinType` on the wire.
        pub pin_type: ToolPinType,
    }
    impl GetTioPinMode {
        /// With the required fields alone.
        pub const fn new(pin_type: ToolPinType) -> Self {}
    }
    /// What the controller answers to [`type@GetTioPinMode`].
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetTioPinModeReply {
        /// Use of the pins, as [`set_tio_pin_mode`](type@SetTioPinMode) sets it. `pinMode` on the wire.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub pin_mode: wire::Typed<i64>,
    }
    /// Sets the use of the tool's pins.
    ///
    /// Sends `set_tio_pin_mode`.
    ///
    /// Taken to be known to firmware 1.5.15 and later.
    ///
    /// Not in the document. Evidence: bytes of the vendor's client library (SDK 2.1.14 sends it); one client (on a MiniCobo, port 10001).
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct SetTioPinMode {
        /// Kind of the pins. `pinType` on the wire.
        pub pin_type: ToolPinType,
        /// Use of the pins, by their kind. 0 to 255. `pinMode` on the wire.
        ///
        /// Inputs: one bit for each of DI1 and DI2, for NPN or PNP, 0 to 3; which value is PNP is not stated. Outputs: the low four bits are DO1,
        /// the high four DO2, each 0 for NPN, 1 for PNP, 2 for push-pull and 15 for RS485H. Analog inputs: 0 for an analog input, 1 for RS485L.
        pub pin_mode: i64,
    }
    impl SetTioPinMode {
        /// With the required fields alone.
        ///
        /// - `pin_mode`: 0 to 255
        pub const fn new(pin_type: ToolPinType, pin_mode: i64) -> Self {}
    }
    /// Reads the mode of a serial channel of the tool.
    ///
    /// Sends `get_rs485_chn_mode`. Changes nothing on the robot. The reply is [`GetRs485ChnModeReply`].
    ///
    /// Taken to be known to firmware 1.5.15 and later.
    ///
    /// Not in the document. Evidence: bytes of the vendor's client library (SDK 2.1.14 sends it); one client (on a MiniCobo, port 10001).
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetRs485ChnMode {
        /// Channel. `chnId` on the wire.
        pub channel: SerialChannel,
    }
    impl GetRs485ChnMode {
        /// With the required fields alone.
        pub const fn new(channel: SerialChannel) -> Self {}
    }
    /// What the controller answers to [`type@GetRs485ChnMode`].
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetRs485ChnModeReply {
        /// Mode of the channel. `chnMode` on the wire.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub mode: wire::Typed<SerialChannelMode>,
    }
    /// Sets the mode of a serial channel of the tool.
    ///
    /// Raw RS485 and signals share a channel: another mode drops the channel's signals (one client).
    ///
    /// Sends `set_rs485_chn_mode`.
    ///
    /// Taken to be known to firmware 1.5.15 and later.
    ///
    /// Not in the document. Evidence: bytes of the vendor's client library (SDK 2.1.14 sends it); one client (on a MiniCobo, port 10001).
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct SetRs485ChnMode {
        /// Channel. `chnId` on the wire.
        pub channel: SerialChannel,
        /// Mode of the channel. `chnMode` on the wire.
        pub mode: SerialChannelMode,
    }
    impl SetRs485ChnMode {
        /// With the required fields alone.
        pub const fn new(channel: SerialChannel, mode: SerialChannelMode) -> Self {}
    }
    /// Reads the line settings of a serial channel of the tool.
    ///
    /// The key of the channel is `chn_id` here and `chnId` in [`get_rs485_chn_mode`](type@GetRs485ChnMode).
    ///
    /// Sends `get_rs485_chn_comm`. Changes nothing on the robot. The reply is [`GetRs485ChnCommReply`].
    ///
    /// Taken to be known to firmware 1.5.15 and later.
    ///
    /// Not in the document. Evidence: bytes of the vendor's client library (SDK 2.1.14 sends it); one client (on a MiniCobo, port 10001).
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetRs485ChnComm {
        /// Channel. `chn_id` on the wire.
        pub channel: SerialChannel,
    }
    impl GetRs485ChnComm {
        /// With the required fields alone.
        pub const fn new(channel: SerialChannel) -> Self {}
    }
    /// What the controller answers to [`type@GetRs485ChnComm`].
    #[derive(Debug, Clone, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetRs485ChnCommReply {
        /// Number of the Modbus slave. `slaveId` on the wire.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub slave_id: Option<wire::Typed<i64>>,
        /// Baud rate. `baudrate` on the wire.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub baud_rate: Option<wire::Typed<i64>>,
        /// Data bits. `databit` on the wire.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub data_bits: Option<wire::Typed<i64>>,
        /// Stop bits. `stopbit` on the wire.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub stop_bits: Option<wire::Typed<i64>>,
        /// Parity.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub parity: Option<wire::Typed<SerialParity>>,
    }
    /// Sets the line of a serial channel of the tool.
    ///
    /// The key of the channel is `chn_id` here and `chnId` in [`set_rs485_chn_mode`](type@SetRs485ChnMode).
    ///
    /// Sends `set_rs485_chn_comm`.
    ///
    /// Taken to be known to firmware 1.5.15 and later.
    ///
    /// Not in the document. Evidence: bytes of the vendor's client library (SDK 2.1.14 sends it); one client (on a MiniCobo, port 10001).
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct SetRs485ChnComm {
        /// Channel. `chn_id` on the wire.
        pub channel: SerialChannel,
        /// Number of the Modbus slave. At least 0. It counts in the mode for Modbus alone. `slaveId` on the wire.
        pub slave_id: i64,
        /// Baud rate: one of eight values from 4800 to 230400. 4800 to 230400. `baudrate` on the wire.
        pub baud_rate: i64,
        /// Data bits. 7 to 8. `databit` on the wire.
        pub data_bits: i64,
        /// Stop bits. 1 to 2. `stopbit` on the wire.
        pub stop_bits: i64,
        /// Parity.
        pub parity: SerialParity,
    }
    impl SetRs485ChnComm {
        /// With the required fields alone.
        ///
        /// - `slave_id`: at least 0
        /// - `baud_rate`: 4800 to 230400
        /// - `data_bits`: 7 to 8
        /// - `stop_bits`: 1 to 2
        pub const fn new(
            channel: SerialChannel,
            slave_id: i64,
            baud_rate: i64,
            data_bits: i64,
            stop_bits: i64,
            parity: SerialParity,
        ) -> Self {}
    }
    /// Reads the signals that are defined on the tool's serial channels.
    ///
    /// The reply has a key for each signal, which is its name, with an object of `sigType`, `sigAddr`, `chnId`, `frequency` and `value`, and the
    /// number of signals as `num`.
    ///
    /// Sends `get_rs485_signal_list`. Changes nothing on the robot.
    ///
    /// Taken to be known to firmware 1.5.15 and later.
    ///
    /// Not in the document. Evidence: one client (on a MiniCobo, port 10001).
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetRs485SignalList {}
    impl GetRs485SignalList {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// Reads the signals that are defined on the tool's serial channels, with their values.
    ///
    /// Sends `get_tio_signals`. Changes nothing on the robot. The reply is [`GetTioSignalsReply`].
    ///
    /// Taken to be known to firmware 1.5.15 and later.
    ///
    /// Not in the document. Evidence: bytes of the vendor's client library (SDK 2.1.14 sends it); one client (on a MiniCobo, port 10001).
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetTioSignals {}
    impl GetTioSignals {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@GetTioSignals`].
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetTioSignalsReply {
        /// One entry for each signal.
        ///
        /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
        pub signals: wire::Typed<Vec<ToolSignal>>,
    }
    /// Defines a signal on a serial channel of the tool; there are at most 8.
    ///
    /// Sends `add_tio_rs_signal`.
    ///
    /// Taken to be known to firmware 1.5.15 and later.
    ///
    /// Not in the document. Evidence: bytes of the vendor's client library (SDK 2.1.14 sends it); one client (on a MiniCobo, port 10001).
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct AddTioRsSignal {
        /// Name of the signal, of fewer than 20 characters. `tio_signal_name` on the wire.
        pub name: String,
        /// Channel. `tio_signal_chnId` on the wire.
        pub channel: SerialChannel,
        /// Type of the signal. At least 0. The values are not explained. `tio_signal_sigType` on the wire.
        pub signal_type: i64,
        /// Address of the signal's register, by the name. At least 0. `tio_signal_sigAddr` on the wire.
        pub address: i64,
        /// Rate at which the signal is read, at most 10. 0 to 10. Unit not stated.
        pub frequency: f64,
    }
    impl AddTioRsSignal {
        /// With the required fields alone.
        ///
        /// - `signal_type`: at least 0
        /// - `address`: at least 0
        /// - `frequency`: 0 to 10
        pub fn new(
            name: impl Into<String>,
            channel: SerialChannel,
            signal_type: i64,
            address: i64,
            frequency: f64,
        ) -> Self {}
    }
    /// Removes a signal from a serial channel of the tool.
    ///
    /// Sends `del_tio_rs_signal`.
    ///
    /// Taken to be known to firmware 1.5.15 and later.
    ///
    /// Not in the document. Evidence: bytes of the vendor's client library (SDK 2.1.14 sends it); one client (on a MiniCobo, port 10001).
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct DeleteTioRsSignal {
        /// Name of the signal. `tio_signal_name` on the wire.
        pub name: String,
    }
    impl DeleteTioRsSignal {
        /// With the required fields alone.
        pub fn new(name: impl Into<String>) -> Self {}
    }
    /// Kind of the tool's pins.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum ToolPinType {
        /// Digital inputs. `0` on the wire.
        DigitalInputs,
        /// Digital outputs; they may carry RS485H, channel 1. `1` on the wire.
        DigitalOutputs,
        /// Analog inputs; they may carry RS485L, channel 2. `2` on the wire.
        AnalogInputs,
        /// A value that the spec does not list.
        Other(i64),
    }
    impl From<i64> for ToolPinType {}
    impl From<ToolPinType> for i64 {}
    /// The value in words; one that the spec does not list as its number.
    impl ::core::fmt::Display for ToolPinType {}
    /// Serial channel of the tool.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum SerialChannel {
        /// RS485H, which the vendor calls channel 1. `0` on the wire.
        Rs485H,
        /// RS485L, which the vendor calls channel 2. `1` on the wire.
        Rs485L,
        /// A value that the spec does not list.
        Other(i64),
    }
    impl From<i64> for SerialChannel {}
    impl From<SerialChannel> for i64 {}
    /// The value in words; one that the spec does not list as its number.
    impl ::core::fmt::Display for SerialChannel {}
    /// Mode of a serial channel of the tool.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum SerialChannelMode {
        /// Modbus RTU, for signals. `0` on the wire.
        ModbusRtu,
        /// Raw RS485, for [`send_tio_rs_command`](type@SendTioRsCommand). `1` on the wire.
        Raw,
        /// Torque sensor. `2` on the wire.
        TorqueSensor,
        /// A value that the spec does not list.
        Other(i64),
    }
    impl From<i64> for SerialChannelMode {}
    impl From<SerialChannelMode> for i64 {}
    /// The value in words; one that the spec does not list as its number.
    impl ::core::fmt::Display for SerialChannelMode {}
    /// Parity of a serial line: the code of a letter.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum SerialParity {
        /// No parity, N. `78` on the wire.
        None,
        /// Odd parity, O. `79` on the wire.
        Odd,
        /// Even parity, E. `69` on the wire.
        Even,
        /// A value that the spec does not list.
        Other(i64),
    }
    impl From<i64> for SerialParity {}
    impl From<SerialParity> for i64 {}
    /// The value in words; one that the spec does not list as its number.
    impl ::core::fmt::Display for SerialParity {}
    /// A signal on a serial channel of the tool.
    ///
    /// The order is that of [`get_tio_signals`](type@GetTioSignals). Packets of port 10000 have eight of the same length and the same types, where none is defined
    /// `["", 0, 0, 0, 0, 0.0]`.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct ToolSignal {
        /// Name of the signal; empty where none is defined.
        pub name: String,
        /// Number of the channel.
        pub channel: i64,
        /// Type of the signal. The values are not explained.
        pub signal_type: i64,
        /// Address of the signal's register, by the name.
        pub address: i64,
        /// Value that was read last.
        pub value: i64,
        /// Rate at which the signal is read. Unit not stated.
        pub frequency: f64,
    }
}
