//! Form of a firmware's messages, and its behaviour.

use std::time::Duration;

use jaka_proto::messages::io::FunctionInputKind;
use jaka_proto::messages::status::TaskState;

use super::{Firmware, Writing};
use crate::{Habit, State};

/// Number of digital inputs of the tool, and of its digital outputs.
pub(crate) const TOOL_DIGITAL: usize = 8;

/// Form of a firmware's messages, and its behaviour: one row of the table of [`Firmware`].
#[derive(Debug)]
pub(crate) struct Shape {
    pub(crate) name: &'static str,
    /// Version in the reply to `get_version`.
    pub(crate) version: &'static str,
    pub(crate) status_period: Duration,
    pub(crate) writing: Writing,
    pub(crate) habits: &'static [Habit],
    /// Whether status packets have the extension I/O modules.
    pub(crate) extio: bool,
    /// Whether status packets have keys that are not in the document.
    pub(crate) newer_keys: bool,
    /// Number of digital inputs, and of digital outputs.
    pub(crate) digital: usize,
    /// Number of analog inputs, and of analog outputs.
    pub(crate) analog: usize,
    /// Initial values of the analog inputs of the tool.
    pub(crate) tool_analog: &'static [f64],
    /// Whether no function has an input initially.
    pub(crate) no_function_input: bool,
    /// `task_state` of a disabled arm with power.
    pub(crate) disabled: TaskState,
    /// Number of decimals of poses in packets: 13 give the 13 to 17 digits of 311 packets of a newer controller.
    pub(crate) pose_decimals: usize,
    /// Monitor data before the joints, as JSON. The values are not measured: they are those of a capture, if there is
    /// one.
    pub(crate) monitor_head: &'static str,
    /// Monitor data of each joint.
    pub(crate) joint_row: &'static str,
    /// Monitor data after the joints.
    pub(crate) monitor_tail: &'static str,
    /// Number of lists of readings of the torque sensor.
    pub(crate) torque_readings: usize,
    /// Module id at the end of the setup of an extension I/O module, if the firmware sends one; the connection then has
    /// the id of the Modbus slave.
    pub(crate) extio_module_id: Option<&'static str>,
}

impl Firmware {
    /// Sets the version and the inputs of a state for this firmware.
    pub(crate) fn fit(self, state: &mut State) {
        let shape = self.shape();
        shape.version.clone_into(&mut state.version);
        state.digital_inputs.resize(shape.digital, false);
        state.analog_inputs.resize(shape.analog, 0.0);
        state.tool_digital_inputs.resize(TOOL_DIGITAL, false);
        state.tool_analog_inputs = shape.tool_analog.to_vec();
        if shape.no_function_input {
            for input in &mut state.function_inputs {
                (input.kind, input.index) = (FunctionInputKind::Unassigned, -1);
            }
        }
    }
}
