//! The keys of status packets.

use std::iter::once;

use jaka_spec::{Field, Spec};

use crate::firmware::Shape;

/// The keys that newer firmware sends among the others, by their names in the spec, after the one that is before them.
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

/// The keys that a firmware sends, in the order in which controllers send them, and those that packs add last. Firmware leaves some out;
/// none that is known has another order.
pub(super) fn fields<'s>(spec: &'s Spec, shape: &Shape) -> impl Iterator<Item = &'s Field> {
    let fields = spec.status_fields();
    let is_newer = |field: &Field| NEWER.iter().any(|(_, names)| names.contains(&&*field.name));
    let common = fields.iter().filter(move |field| !is_newer(field) && (shape.extio || field.name != "extio"));
    common.flat_map(|field| {
        let more = NEWER.iter().filter(|(before, _)| shape.newer_keys && *before == field.name);
        let named = |name: &&str| fields.iter().find(|field| field.name == *name);
        once(field).chain(more.flat_map(|(_, names)| *names).filter_map(named))
    })
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::Firmware;

    #[test]
    fn all_keys_of_the_spec_have_a_place() {
        let spec = jaka_spec::builtin().expect("the spec is correct");
        let named: BTreeSet<_> = spec.status_fields().iter().map(|field| &*field.name).collect();
        let placed: Vec<_> = fields(&spec, Firmware::Newer.shape()).map(|field| &*field.name).collect();
        assert_eq!(placed.iter().copied().collect::<BTreeSet<_>>(), named);
        assert_eq!(placed.len(), named.len());
        assert_eq!(fields(&spec, Firmware::V1_5_14.shape()).count(), named.len() - 1 - NEWER_COUNT);
    }

    const NEWER_COUNT: usize = 20;
}
