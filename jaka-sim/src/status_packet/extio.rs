//! Extension I/O modules in the shape of port 10000, which is not that of their query.

use jaka_proto::messages::io::{ExtioModule, ExtioPinMap, ExtioPins, ExtioSetup, ExtioState, ExtioStatus};
use jaka_spec::{Field, Shape, Spec};
use serde_json::json;

use super::json;

/// The modules as a status packet shows them, in JSON; the key's field in the spec says how the parts are called.
pub(super) fn report(spec: &Spec, field: &Field, status: &ExtioStatus, id: Option<&str>) -> String {
    let Shape::Object(parts) = spec.shape(&field.ty) else { return json!(null).to_string() };
    let ExtioStatus { modules, state, .. } = status;
    let part = |part: &Field| match &*part.name {
        "pin_states" => pin_states(state),
        "setup" => array(modules.iter().map(|module| setup(module, id))),
        "count" => json(&status.count),
        "pin_maps" => array(modules.iter().map(|module| pin_map(module.pin_map))),
        // By the document's words on this key.
        _ => json(&i64::from(!state.running)),
    };
    let members: Vec<_> = parts.iter().map(|field| format!("{}:{}", json!(field.wire), part(field))).collect();
    format!("{{{}}}", members.join(","))
}

fn array(elements: impl IntoIterator<Item = String>) -> String {
    format!("[{}]", elements.into_iter().collect::<Vec<_>>().join(","))
}

fn pin_states(state: &ExtioState) -> String {
    let digital =
        [&state.digital_inputs, &state.digital_outputs].map(|pins| json!(pins.as_deref().unwrap_or_default()));
    let analog = [&state.analog_inputs, &state.analog_outputs].map(|pins| json!(pins.as_deref().unwrap_or_default()));
    array(digital.iter().chain(&analog).map(ToString::to_string))
}

fn setup(module: &ExtioModule, id: Option<&str>) -> String {
    let (tag, name, connection, pins) = match &module.setup {
        ExtioSetup::Rtu { name, connection, pins, .. } => (0, name, json(connection), pins),
        ExtioSetup::Tcp { name, connection, pins, .. } => {
            let slave = connection.slave_id.or(id.map(|_| 1));
            let parts =
                [json!(connection.address), json!(connection.port)].into_iter().chain(slave.map(|id| json!(id)));
            (1, name, array(parts.map(|part| part.to_string())), pins)
        }
        ExtioSetup::Other(raw) => return raw.to_string(),
        _ => return array([]),
    };
    let ExtioPins { analog_inputs, digital_outputs, analog_outputs, digital_inputs, .. } = pins;
    let pins = array([digital_inputs, digital_outputs, analog_inputs, analog_outputs].map(json));
    let parts = [json!(tag).to_string(), json!(name).to_string(), connection, pins];
    array(parts.into_iter().chain(id.map(|id| json!(id).to_string())))
}

fn pin_map(map: ExtioPinMap) -> String {
    json!([map.digital_inputs, map.digital_outputs, map.analog_inputs, map.analog_outputs]).to_string()
}
