//! Extension I/O modules in the shape of port 10000, which is not that of their query.

use jaka_proto::messages::io::{ExtioModule, ExtioPins, ExtioSetup, ExtioStatus};
use jaka_proto::messages::status::ExtioReport;
use jaka_proto::wire::{Decode, Reader};
use serde_json::json;

use super::json;

/// The modules as a status packet shows them; `report` is one to fill in. None where a value does not fit.
pub(super) fn filled(mut report: ExtioReport, status: &ExtioStatus, id: Option<&str>) -> Option<ExtioReport> {
    let ExtioStatus { modules, state, .. } = status;
    report.pin_states.digital_inputs = state.digital_inputs.clone().unwrap_or_default();
    report.pin_states.digital_outputs = state.digital_outputs.clone().unwrap_or_default();
    report.pin_states.analog_inputs = state.analog_inputs.clone().unwrap_or_default();
    report.pin_states.analog_outputs = state.analog_outputs.clone().unwrap_or_default();
    report.setup = modules.iter().map(|module| decoded(&setup(module, id))).collect::<Option<_>>()?;
    report.count = status.count;
    report.pin_maps = modules.iter().map(|module| decoded(&pin_map(module))).collect::<Option<_>>()?;
    // By the document's words on this key.
    report.mode = i64::from(!state.running);
    Some(report)
}

/// A value of a type that only its codec makes.
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
