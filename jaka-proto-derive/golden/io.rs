pub mod io {
    //! Inputs and outputs.
    //!
    //! Digital and analog inputs and outputs of the cabinet, the tool and extension modules.
    /// Sets one digital output.
    ///
    /// Controllers do not agree on the first output's number: some firmware counts `index` from 0, other firmware from 1. For one and the same call
    /// (output 1 of its own count, which begins with 0) the vendor's SDK 1.0.19 and 2.1.9.7 send 1, SDK 2.1.14 sends 2, whatever the version of the
    /// controller, for digital and analog inputs and outputs of the cabinet and the tool (bytes). Clients of version 1.7 count from 1, clients of
    /// Lexium V3 from 0. Check on the controller at hand which output switches before anything is wired to it.
    ///
    /// Sends `set_digital_output` (4.25).
    ///
    /// Reconstructed, since the document's page is lost: The document's page is lost. Field notes: request and reply certain; output types 0 to 6 certain, 3 to 6 on newer firmware only.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct SetDigitalOutput {
        /// Place of the output. `type` on the wire.
        pub kind: DigitalOutputKind,
        /// Number of the output, sent as given: counted from 0 on some firmware, from 1 on other. At least 0.
        pub index: i64,
        /// State to set.
        pub value: super::types::Switch,
    }
    impl SetDigitalOutput {
        /// With the required fields alone.
        ///
        /// - `index`: at least 0
        pub const fn new(
            kind: DigitalOutputKind,
            index: i64,
            value: super::types::Switch,
        ) -> Self {}
        /// In the control cabinet.
        ///
        /// - `index`: at least 0
        pub const fn cabinet(index: i64, value: super::types::Switch) -> Self {}
        /// At the tool end of the arm.
        ///
        /// - `index`: at least 0
        pub const fn tool(index: i64, value: super::types::Switch) -> Self {}
        /// On an extension I/O module.
        ///
        /// - `index`: at least 0
        pub const fn extension(index: i64, value: super::types::Switch) -> Self {}
        /// A relay output.
        ///
        /// - `index`: at least 0
        pub const fn relay(index: i64, value: super::types::Switch) -> Self {}
        /// An output of the Modbus slave.
        ///
        /// - `index`: at least 0
        pub const fn modbus_slave(index: i64, value: super::types::Switch) -> Self {}
        /// A Profinet output.
        ///
        /// - `index`: at least 0
        pub const fn profinet(index: i64, value: super::types::Switch) -> Self {}
        /// An EtherNet/IP output.
        ///
        /// - `index`: at least 0
        pub const fn ethernet_ip(index: i64, value: super::types::Switch) -> Self {}
    }
    /// Reads the states of all digital inputs.
    ///
    /// The first eight are the cabinet's own inputs. The controller occupies the first of them, so it is not for use. The
    /// document calls the others Modbus inputs.
    ///
    /// Sends `get_digital_input_status` (4.26). Changes nothing on the robot. The reply is [`GetDigitalInputStatusReply`].
    ///
    /// Reconstructed, since the document's page is lost: The document's page is lost, except for one sentence about `din_status`. Field notes: request, key and type certain; 64 and 136 entries seen.
    ///
    /// # Errata
    ///
    /// - The sentence that is left of the document counts 136 inputs. Controllers send other numbers too; 64 is seen.
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetDigitalInputStatus {}
    impl GetDigitalInputStatus {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@GetDigitalInputStatus`].
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetDigitalInputStatusReply {
        /// State of each input. The number of inputs depends on the controller. `din_status` on the wire.
        pub digital_inputs: Vec<bool>,
    }
    /// Sets one analog output.
    ///
    /// The document names no unit for the value and no range.
    ///
    /// Sends `set_analog_output` (4.27).
    ///
    /// # Errata
    ///
    /// - The document numbers the cabinet's outputs from 0 to 7 and says to send 7 for the seventh, which would be the eighth when counted from 0.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct SetAnalogOutput {
        /// Place of the output. `type` on the wire.
        pub kind: AnalogOutputKind,
        /// Number of the output, sent as given. At least 0. The document numbers the cabinet's outputs from 0 to 7. Whether a controller counts from 0 or from 1
        /// depends on it, as of digital outputs: see [`set_digital_output`](type@SetDigitalOutput).
        pub index: i64,
        /// Value to set. The document states neither unit nor range.
        pub value: f64,
    }
    impl SetAnalogOutput {
        /// With the required fields alone.
        ///
        /// - `index`: at least 0
        pub const fn new(kind: AnalogOutputKind, index: i64, value: f64) -> Self {}
        /// In the control cabinet.
        ///
        /// - `index`: at least 0
        pub const fn cabinet(index: i64, value: f64) -> Self {}
        /// At the tool end of the arm.
        ///
        /// - `index`: at least 0
        pub const fn tool(index: i64, value: f64) -> Self {}
        /// On an extension I/O module.
        ///
        /// - `index`: at least 0
        pub const fn extension(index: i64, value: f64) -> Self {}
        /// Reserved; a relay where the output is digital.
        ///
        /// - `index`: at least 0
        pub const fn reserved(index: i64, value: f64) -> Self {}
        /// An output of the Modbus slave.
        ///
        /// - `index`: at least 0
        pub const fn modbus_slave(index: i64, value: f64) -> Self {}
        /// A Profinet output.
        ///
        /// - `index`: at least 0
        pub const fn profinet(index: i64, value: f64) -> Self {}
        /// An EtherNet/IP output.
        ///
        /// - `index`: at least 0
        pub const fn ethernet_ip(index: i64, value: f64) -> Self {}
    }
    /// Reads the configuration and state of the extension I/O modules.
    ///
    /// Sends `get_extio_status` (4.34). Changes nothing on the robot. The reply is [`GetExtioStatusReply`].
    ///
    /// # Errata
    ///
    /// - The document prints the reply of a controller without modules as a bare tuple, `(0, [], {'state': 0})`, without JSON around it. Both that and the same text inside the JSON string are read.
    /// - The sample configures eight digital inputs and reports the states of nine.
    /// - Here `state` 0 means that the modules do not run and 1 that they do. Chapter 2 describes `mode` of `extio` on port 10000, also called the modules' state, as 0 for on and 1 for off; that both are the same is not said.
    /// - Chapter 2 describes the same settings with the pins as an array in the order di, do, ai, ao. Here they are a dictionary.
    /// - No RTU module is shown here. Its settings follow chapter 2, which lists the data bits twice: as data bit length before the slave number, and as data bits after it.
    /// - Chapter 2 lists a slave number after a TCP module's port. The sample here has none.
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetExtioStatus {}
    impl GetExtioStatus {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@GetExtioStatus`].
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetExtioStatusReply {
        /// All modules. On the wire a Python literal inside a string.
        pub extio_status: ExtioStatus,
    }
    /// Reads which inputs serve as function inputs.
    ///
    /// The entries stand for these functions, in this order:
    ///
    /// 1. start the program
    /// 2. pause the program
    /// 3. resume the program
    /// 4. stop the program
    /// 5. switch power on
    /// 6. switch power off
    /// 7. enable the robot
    /// 8. disable the robot
    /// 9. reduced mode, level 1
    /// 10. protective stop
    /// 11. return to the initial position
    /// 12. reduced mode, level 2
    /// 13. clear the error (likely)
    /// 14. enter drag mode (likely)
    /// 15. leave drag mode (likely)
    ///
    /// The document has the first twelve.
    ///
    /// Sends `get_funcdi_status` (4.35). Changes nothing on the robot. The reply is [`GetFuncdiStatusReply`].
    ///
    /// # Errata
    ///
    /// - The document counts 12 functions, its sample has 13 entries, and port 10000 sends 12, 13 or 15 of them.
    /// - The text calls the sample's `[0, 2]` the entry of reduced mode, level 1, the ninth function. In the sample it is the tenth entry, which the list gives to the protective stop.
    /// - The text writes the key `funci_status`, the sample `funcdi_status`.
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetFuncdiStatus {}
    impl GetFuncdiStatus {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@GetFuncdiStatus`].
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct GetFuncdiStatusReply {
        /// The input of each function, in the order of the functions. `funcdi_status` on the wire.
        pub function_inputs: Vec<FunctionInput>,
    }
    /// Sets the voltage output of a version 3 tool I/O board.
    ///
    /// The sources contradict each other on both values, and a tool meant for 12 V can be destroyed by 24 V. So both values stay raw. The bytes of the
    /// vendor's own client library (SDK 2.1.14) support the reading 1 = on and 0 = 24 V: it sends its own values untranslated. So do its headers,
    /// the manual, six users, and one program on port 10001 itself. The TCP document stands alone; no measurement is known. Who sends 0 for 12 V may
    /// put 24 V on the tool: with no tool connected, measure first which value gives which voltage.
    ///
    /// The setting wants a disabled arm (one client).
    ///
    /// Sends `set_tio_vout_param` (4.80).
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct SetTioVoutParam {
        /// Raw switch of the voltage output. 0 to 1. The sources contradict each other on which of them is on. `tio_vout_ena` on the wire.
        ///
        /// Sources contradict each other on the meaning, so the value is passed on as it is:
        ///
        /// - document 2.0.4 alone: 0 = enabled, 1 = not enabled
        /// - bytes of the vendor's SDK 2.1.14, its headers (SDK 2.2.2 and another), its manual, six users, one program on port 10001: 0 = off, 1 = on
        pub output_enable: i64,
        /// Raw choice of the voltage. 0 to 1. The sources contradict each other on which of them is 12 V and which 24 V. `tio_vout_vol` on the wire.
        ///
        /// Sources contradict each other on the meaning, so the value is passed on as it is:
        ///
        /// - document 2.0.4 alone: 0 = 12 V, 1 = 24 V
        /// - bytes of the vendor's SDK 2.1.14, its headers (SDK 2.2.2 and another), its manual, six users, one program on port 10001: 0 = 24 V, 1 = 12 V
        pub output_voltage: i64,
    }
    impl SetTioVoutParam {
        /// With the required fields alone.
        ///
        /// - `output_enable`: 0 to 1
        /// - `output_voltage`: 0 to 1
        pub const fn new(output_enable: i64, output_voltage: i64) -> Self {}
    }
    /// Reads the settings of the voltage output of a version 3 tool I/O board.
    ///
    /// The sources contradict each other on the meaning of both values, so both stay raw. [`set_tio_vout_param`](type@SetTioVoutParam) has the readings.
    ///
    /// Sends `get_tio_vout_param` (4.81). Changes nothing on the robot. The reply is [`GetTioVoutParamReply`].
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct GetTioVoutParam {}
    impl GetTioVoutParam {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@GetTioVoutParam`].
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct GetTioVoutParamReply {
        /// Raw switch of the voltage output. 0 to 1. The sources contradict each other on which of them is on. `tio_vout_ena` on the wire.
        ///
        /// Sources contradict each other on the meaning, so the value is passed on as it is:
        ///
        /// - document 2.0.4 alone: 0 = enabled, 1 = not enabled
        /// - vendor headers (SDK 2.2.2 and another), vendor manual, six users, one program on port 10001: 0 = off, 1 = on
        pub output_enable: i64,
        /// Raw choice of the voltage. 0 to 1. The sources contradict each other on which of them is 12 V and which 24 V. `tio_vout_vol` on the wire.
        ///
        /// Sources contradict each other on the meaning, so the value is passed on as it is:
        ///
        /// - document 2.0.4 alone: 0 = 12 V, 1 = 24 V
        /// - vendor headers (SDK 2.2.2 and another), vendor manual, six users, one program on port 10001: 0 = 24 V, 1 = 12 V
        pub output_voltage: i64,
    }
    /// Place of a digital output.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum DigitalOutputKind {
        /// In the control cabinet. `0` on the wire.
        Cabinet,
        /// At the tool end of the arm. `1` on the wire.
        Tool,
        /// On an extension I/O module. `2` on the wire.
        Extension,
        /// A relay output. Taken by newer firmware only. `3` on the wire.
        Relay,
        /// An output of the Modbus slave. Taken by newer firmware only. `4` on the wire.
        ModbusSlave,
        /// A Profinet output. Taken by newer firmware only. `5` on the wire.
        Profinet,
        /// An EtherNet/IP output. Taken by newer firmware only. `6` on the wire.
        EthernetIp,
        /// A value that the spec does not list.
        Other(i64),
    }
    impl From<i64> for DigitalOutputKind {}
    impl From<DigitalOutputKind> for i64 {}
    /// The value in words; one that the spec does not list as its number.
    impl ::core::fmt::Display for DigitalOutputKind {}
    /// Place of an analog output.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum AnalogOutputKind {
        /// In the control cabinet. `0` on the wire.
        Cabinet,
        /// At the tool end of the arm. Taken by newer firmware only. `1` on the wire.
        Tool,
        /// On an extension I/O module. `2` on the wire.
        Extension,
        /// Reserved; a relay where the output is digital. Taken by newer firmware only. `3` on the wire.
        Reserved,
        /// An output of the Modbus slave. Taken by newer firmware only. `4` on the wire.
        ModbusSlave,
        /// A Profinet output. Taken by newer firmware only. `5` on the wire.
        Profinet,
        /// An EtherNet/IP output. Taken by newer firmware only. `6` on the wire.
        EthernetIp,
        /// A value that the spec does not list.
        Other(i64),
    }
    impl From<i64> for AnalogOutputKind {}
    impl From<AnalogOutputKind> for i64 {}
    /// The value in words; one that the spec does not list as its number.
    impl ::core::fmt::Display for AnalogOutputKind {}
    /// The extension I/O modules and their state, as [`get_extio_status`](type@GetExtioStatus) answers.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct ExtioStatus {
        /// Number of modules.
        pub count: i64,
        /// One entry for each module.
        pub modules: Vec<ExtioModule>,
        /// Whether the modules run, and the state of their pins.
        pub state: ExtioState,
    }
    /// One extension I/O module.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct ExtioModule {
        /// Connection of the module, and its pins.
        pub setup: ExtioSetup,
        /// First pins of the module; of interest with several modules. `pinmap` on the wire.
        pub pin_map: ExtioPinMap,
    }
    /// Connection of an extension I/O module, and its pins.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub enum ExtioSetup {
        /// Connected by Modbus RTU.
        #[non_exhaustive]
        Rtu {
            /// Name of the module.
            name: String,
            /// Serial settings of the connection. The document prints no sample of them.
            ///
            /// The sources leave doubt about the shape: a value of another shape is kept as raw JSON.
            connection: wire::Typed<ExtioRtu>,
            /// The module's pins.
            pins: ExtioPins,
        },
        /// Connected by Modbus TCP.
        #[non_exhaustive]
        Tcp {
            /// Name of the module.
            name: String,
            /// Network address of the module.
            connection: ExtioTcp,
            /// The module's pins.
            pins: ExtioPins,
        },
        /// A kind that the spec does not list, as raw JSON.
        Other(wire::Value),
    }
    /// Serial settings of an extension I/O module.
    ///
    /// The elements and their order are those of chapter 2. The document prints no sample.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct ExtioRtu {
        /// Baud rate.
        pub baud_rate: i64,
        /// Length of the data bits.
        pub data_bit_length: i64,
        /// Number of the Modbus slave.
        pub slave_id: i64,
        /// Data bits. The document lists them a second time and does not say how they differ from `data_bit_length`.
        pub data_bits: i64,
        /// Parity. The document does not say how it is written, and whether as number or text.
        pub parity: wire::Value,
        /// Length of the stop bits.
        pub stop_bit_length: i64,
    }
    /// Network address of an extension I/O module.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct ExtioTcp {
        /// IP address.
        pub address: String,
        /// TCP port.
        pub port: i64,
        /// Number of the Modbus slave. Chapter 2 lists it, and a newer controller's packet has it (capture: 1); the sample of 4.34 has none.
        pub slave_id: Option<i64>,
    }
    /// The pins of an extension I/O module, by kind.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct ExtioPins {
        /// Analog inputs. `ai` on the wire.
        pub analog_inputs: ExtioPinRange,
        /// Digital outputs. `do` on the wire.
        pub digital_outputs: ExtioPinRange,
        /// Analog outputs. `ao` on the wire.
        pub analog_outputs: ExtioPinRange,
        /// Digital inputs. `di` on the wire.
        pub digital_inputs: ExtioPinRange,
    }
    /// First register of some pins, and their number.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct ExtioPinRange {
        /// Address of the first register.
        pub start: i64,
        /// Number of pins.
        pub count: i64,
    }
    /// Index at which the pins of an extension I/O module start, by kind.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct ExtioPinMap {
        /// Index of the first analog input. `ai` on the wire.
        pub analog_inputs: i64,
        /// Index of the first digital output. `do` on the wire.
        pub digital_outputs: i64,
        /// Index of the first analog output. `ao` on the wire.
        pub analog_outputs: i64,
        /// Index of the first digital input. `di` on the wire.
        pub digital_inputs: i64,
    }
    /// Whether the extension I/O modules run, and the state of their pins.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct ExtioState {
        /// Whether the modules run. `state` on the wire.
        pub running: bool,
        /// State of the digital inputs, where there are modules. `di` on the wire.
        pub digital_inputs: Option<Vec<bool>>,
        /// State of the digital outputs, where the controller sends them. `do` on the wire.
        pub digital_outputs: Option<Vec<bool>>,
        /// Values of the analog inputs, where the controller sends them. `ai` on the wire.
        pub analog_inputs: Option<Vec<f64>>,
        /// Values of the analog outputs, where the controller sends them. `ao` on the wire.
        pub analog_outputs: Option<Vec<f64>>,
    }
    /// The input that triggers a function of the controller, or -1 and -1 where there is none.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub struct FunctionInput {
        /// Place of the input.
        pub kind: FunctionInputKind,
        /// Number of the input, counted from 0, or -1 where there is none.
        pub index: i64,
    }
    /// Place of a function input.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum FunctionInputKind {
        /// No input is assigned to the function. `-1` on the wire.
        Unassigned,
        /// An input of the control cabinet. `0` on the wire.
        Cabinet,
        /// An input at the tool end of the arm. `1` on the wire.
        Tool,
        /// A Modbus input. `2` on the wire.
        Modbus,
        /// A value that the spec does not list.
        Other(i64),
    }
    impl From<i64> for FunctionInputKind {}
    impl From<FunctionInputKind> for i64 {}
    /// The value in words; one that the spec does not list as its number.
    impl ::core::fmt::Display for FunctionInputKind {}
}
