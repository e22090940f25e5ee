//! Extension I/O modules in their form on port 10000, which differs from the form in their query.

use jaka_proto::messages::io::{ExtioModule, ExtioPins, ExtioSetup, ExtioStatus};
use jaka_proto::messages::status::ExtioReport;
use jaka_proto::wire::{Decode, Reader};
use serde_json::json;

use super::json;

/// Returns the modules for a status packet; `report` is a report to fill in. `None` if a value does not fit.
pub(super) fn filled(mut report: ExtioReport, status: &ExtioStatus, id: Option<&str>) -> Option<ExtioReport> {
    let ExtioStatus { modules, state, .. } = status;
    report.pin_states.digital_inputs = state.digital_inputs.clone().unwrap_or_default();
    report.pin_states.digital_outputs = state.digital_outputs.clone().unwrap_or_default();
    report.pin_states.analog_inputs = state.analog_inputs.clone().unwrap_or_default();
    report.pin_states.analog_outputs = state.analog_outputs.clone().unwrap_or_default();
    // With newer firmware a module has the states of all of its pins, also without any set.
    if id.is_some() {
        let (counts, pins) = (pin_counts(modules), &mut report.pin_states);
        pins.digital_inputs.resize(counts[0].max(pins.digital_inputs.len()), false);
        pins.digital_outputs.resize(counts[1].max(pins.digital_outputs.len()), false);
        pins.analog_inputs.resize(counts[2].max(pins.analog_inputs.len()), 0.0);
        pins.analog_outputs.resize(counts[3].max(pins.analog_outputs.len()), 0.0);
    }
    report.setup = modules.iter().map(|module| decoded(&setup(module, id))).collect::<Option<_>>()?;
    report.count = status.count;
    report.pin_maps = modules.iter().map(|module| decoded(&pin_map(module))).collect::<Option<_>>()?;
    // Follows the document's description of this key.
    report.mode = i64::from(!state.running);
    Some(report)
}

/// Greatest number of shown pins of a module, of each kind.
const MOST_PINS: usize = 256;

/// Returns the numbers of digital inputs, digital outputs, analog inputs and analog outputs of all modules.
fn pin_counts(modules: &[ExtioModule]) -> [usize; 4] {
    let mut counts = [0; 4];
    for module in modules {
        let (ExtioSetup::Rtu { pins, .. } | ExtioSetup::Tcp { pins, .. }) = &module.setup else { continue };
        let ranges = [&pins.digital_inputs, &pins.digital_outputs, &pins.analog_inputs, &pins.analog_outputs];
        for (count, range) in counts.iter_mut().zip(ranges) {
            *count += usize::try_from(range.count).unwrap_or_default().min(MOST_PINS);
        }
    }
    counts
}

/// Decodes a value of a type without a public constructor.
fn decoded<T: Decode>(json: &str) -> Option<T> {
    T::decode(&mut Reader::new(json)).ok()
}

fn setup(module: &ExtioModule, id: Option<&str>) -> String {
    let (tag, name, connection, pins) = match &module.setup {
        ExtioSetup::Rtu { name, connection, pins, .. } => (0, name, json(connection), pins),
        ExtioSetup::Tcp { name, connection, pins, .. } => {
            let mut connection = connection.clone();
            connection.slave_id = connection.slave_id.or(id.map(|_| 1));
            (1, name, json(&connection), pins)
        }
        ExtioSetup::Other(raw) => return raw.to_string(),
        _ => return "[]".to_owned(),
    };
    let ExtioPins { analog_inputs, digital_outputs, analog_outputs, digital_inputs, .. } = pins;
    let pins = [digital_inputs, digital_outputs, analog_inputs, analog_outputs].map(json).join(",");
    let id = id.map_or_else(String::new, |id| format!(",{}", json!(id)));
    format!("[{tag},{},{connection},[{pins}]{id}]", json!(name))
}

fn pin_map(module: &ExtioModule) -> String {
    let map = module.pin_map;
    json!([map.digital_inputs, map.digital_outputs, map.analog_inputs, map.analog_outputs]).to_string()
}
