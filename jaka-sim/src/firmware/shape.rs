//! What messages of a firmware look like.

use std::time::Duration;

use super::{Firmware, ReplyStyle};
use crate::State;
use crate::json_text::Separators;

/// What messages of a firmware look like: one row of the table of [`Firmware`].
#[derive(Debug, Clone, Copy)]
pub(crate) struct Shape {
    pub(crate) name: &'static str,
    pub(crate) status_period: Duration,
    /// What stands between the parts of status packets.
    pub(crate) separators: Separators,
    pub(crate) reply_style: ReplyStyle,
    pub(crate) packet_keys: PacketKeys,
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

/// Which keys status packets have.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum PacketKeys {
    /// Those of the document's sample without extension I/O modules.
    WithoutExtio,
    /// Those of the document's sample.
    Document,
    /// All of the spec.
    All,
}

impl Firmware {
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
