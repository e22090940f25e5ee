//! How many inputs and outputs a controller has.

use super::Firmware;
use crate::State;

/// Lengths of arrays.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Shape {
    /// Digital inputs, and as many outputs.
    pub(crate) digital: usize,
    /// Analog inputs, and as many outputs.
    pub(crate) analog: usize,
    /// Digital inputs of the tool, and as many outputs.
    pub(crate) tool_digital: usize,
    /// Analog inputs of the tool.
    pub(crate) tool_analog: usize,
    /// Functions that may have an input. The query has two fewer in the document.
    pub(crate) functions: usize,
}

impl Firmware {
    pub(crate) fn shape(self) -> Shape {
        match self {
            Self::V1_5_14 => Shape { digital: 136, analog: 64, tool_digital: 8, tool_analog: 1, functions: 13 },
            Self::Document => Shape { digital: 144, analog: 66, tool_digital: 8, tool_analog: 1, functions: 15 },
            Self::Newer => Shape { digital: 200, analog: 128, tool_digital: 8, tool_analog: 2, functions: 15 },
        }
    }

    /// Gives a state the inputs that this firmware has.
    pub(crate) fn fit(self, state: &mut State) {
        let shape = self.shape();
        state.digital_inputs.resize(shape.digital, false);
        state.analog_inputs.resize(shape.analog, 0.0);
        state.tool_digital_inputs.resize(shape.tool_digital, false);
        state.tool_analog_inputs.resize(shape.tool_analog, 0.0);
        state.function_inputs.truncate(shape.functions);
    }
}
