//! Extension I/O modules in the shape of port 10000, which is not that of their query.

use jaka_proto::messages::io::{ExtioModule, ExtioPinMap, ExtioPins, ExtioSetup, ExtioStatus};
use jaka_proto::messages::status::{
    ExtioPinStates, ExtioReport, ExtioReportPinMap, ExtioReportPins, ExtioReportSetup, literal,
};

/// The modules as a status packet shows them.
pub(super) fn report(status: &ExtioStatus) -> ExtioReport {
    let state = &status.state;
    ExtioReport::from(literal::ExtioReport {
        pin_states: ExtioPinStates::from(literal::ExtioPinStates {
            digital_inputs: state.digital_inputs.clone().unwrap_or_default(),
            digital_outputs: state.digital_outputs.clone().unwrap_or_default(),
            analog_inputs: state.analog_inputs.clone().unwrap_or_default(),
            analog_outputs: state.analog_outputs.clone().unwrap_or_default(),
        }),
        setup: status.modules.iter().filter_map(setup).collect(),
        count: status.count,
        pin_maps: status.modules.iter().map(|module| pin_map(module.pin_map)).collect(),
        // By the document's words on this key.
        mode: i64::from(!state.running),
    })
}

/// `None` for a kind that this crate does not know.
fn setup(module: &ExtioModule) -> Option<ExtioReportSetup> {
    Some(match module.setup.clone() {
        ExtioSetup::Rtu { name, connection, pins, .. } => {
            ExtioReportSetup::from(literal::ExtioReportSetup::Rtu { name, connection, pins: pins_of(pins) })
        }
        ExtioSetup::Tcp { name, connection, pins, .. } => {
            ExtioReportSetup::from(literal::ExtioReportSetup::Tcp { name, connection, pins: pins_of(pins) })
        }
        ExtioSetup::Other(raw) => ExtioReportSetup::Other(raw),
        _ => return None,
    })
}

fn pins_of(pins: ExtioPins) -> ExtioReportPins {
    let ExtioPins { analog_inputs, digital_outputs, analog_outputs, digital_inputs, .. } = pins;
    ExtioReportPins::from(literal::ExtioReportPins { digital_inputs, digital_outputs, analog_inputs, analog_outputs })
}

fn pin_map(map: ExtioPinMap) -> ExtioReportPinMap {
    let ExtioPinMap { analog_inputs, digital_outputs, analog_outputs, digital_inputs, .. } = map;
    ExtioReportPinMap::from(literal::ExtioReportPinMap {
        digital_inputs,
        digital_outputs,
        analog_inputs,
        analog_outputs,
    })
}
