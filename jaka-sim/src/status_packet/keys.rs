//! Keys of status packets.

use std::iter::once;

use jaka_spec::{Field, Spec};

/// Additional keys of newer firmware, by their names in the spec, after the key that precedes them.
const NEWER: &[(&str, &[&str])] = &[
    ("torque_sensor", &["joint_velocities"]),
    ("joint_actual_position", &["joint_commanded_position"]),
    ("actual_position", &["commanded_position"]),
    ("analog_outputs", &["tool_keys"]),
    (
        "tool_analog_inputs",
        &[
            "relay_outputs",
            "modbus_slave_digital_inputs",
            "modbus_slave_digital_outputs",
            "modbus_slave_analog_inputs",
            "modbus_slave_analog_outputs",
            "profinet_device_digital_inputs",
            "profinet_device_digital_outputs",
            "profinet_device_analog_inputs",
            "profinet_device_analog_outputs",
            "ethernet_ip_adapter_digital_inputs",
            "ethernet_ip_adapter_digital_outputs",
            "ethernet_ip_adapter_analog_inputs",
            "ethernet_ip_adapter_analog_outputs",
        ],
    ),
    ("point_key", &["motion_line", "error_add_line", "tool_rs_signals"]),
];

/// Returns all keys in the order in which controllers send them. Some firmware omits keys; none is known with another
/// order.
pub(super) fn in_order(spec: &Spec) -> impl Iterator<Item = &Field> {
    let fields = spec.status_fields();
    let is_newer = |field: &Field| NEWER.iter().any(|(_, names)| names.contains(&&*field.name));
    fields.iter().filter(move |field| !is_newer(field)).flat_map(|field| {
        let more = NEWER.iter().filter(|(before, _)| *before == field.name);
        let named = |name: &&str| fields.iter().find(|field| field.name == *name);
        once(field).chain(more.flat_map(|(_, names)| *names).filter_map(named))
    })
}
