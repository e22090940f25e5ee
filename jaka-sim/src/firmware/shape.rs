//! Form of a firmware's messages, and its behaviour.

use std::time::Duration;

use jaka_proto::messages::io::FunctionInputKind;
use jaka_proto::messages::status::TaskState;

use super::{Firmware, Writing};
use crate::{Habit, State};

/// Form of a firmware's messages, and its behaviour: one row of the table of [`Firmware`].
#[derive(Debug)]
pub(crate) struct Shape {
    pub(crate) name: &'static str,
    /// Version that `get_version` answers.
    pub(crate) version: &'static str,
    pub(crate) status_period: Duration,
    pub(crate) writing: Writing,
    pub(crate) habits: &'static [Habit],
    /// Whether status packets show the extension I/O modules.
    pub(crate) extio: bool,
    /// Whether status packets have the keys that the document does not have.
    pub(crate) newer_keys: bool,
    /// Digital inputs, and as many outputs.
    pub(crate) digital: usize,
    /// Analog inputs, and as many outputs.
    pub(crate) analog: usize,
    /// Digital inputs of the tool, and as many outputs.
    pub(crate) tool_digital: usize,
    /// Analog inputs of the tool, to begin with.
    pub(crate) tool_analog: &'static [f64],
    /// Functions that may have an input. The query has two fewer in the document.
    pub(crate) functions: usize,
    /// True where no function has an input to begin with.
    pub(crate) no_function_input: bool,
    /// `task_state` of an arm that has power and is disabled.
    pub(crate) disabled: TaskState,
    /// Decimals of poses in packets: 13 give the 13 to 17 digits of 311 packets of a newer controller.
    pub(crate) pose_decimals: usize,
    /// The monitor data before the joints, as JSON. Nothing is measured here: these are values of a capture, where
    /// there is one.
    pub(crate) monitor_head: &'static str,
    /// The monitor data of each joint.
    pub(crate) joint_row: &'static str,
    /// The monitor data after the joints.
    pub(crate) monitor_tail: &'static str,
    /// Lists of readings that the torque sensor has.
    pub(crate) torque_readings: usize,
    /// Module id at the end of the setup of an extension I/O module, where the firmware sends one; the connection then
    /// has the Modbus slave's id.
    pub(crate) extio_module_id: Option<&'static str>,
}

impl Firmware {
    /// Gives a state the version and the inputs of this firmware.
    pub(crate) fn fit(self, state: &mut State) {
        let shape = self.shape();
        shape.version.clone_into(&mut state.version);
        state.digital_inputs.resize(shape.digital, false);
        state.analog_inputs.resize(shape.analog, 0.0);
        state.tool_digital_inputs.resize(shape.tool_digital, false);
        state.tool_analog_inputs = shape.tool_analog.to_vec();
        state.function_inputs.truncate(shape.functions);
        if shape.no_function_input {
            for input in &mut state.function_inputs {
                (input.kind, input.index) = (FunctionInputKind::Unassigned, -1);
            }
        }
    }
}
