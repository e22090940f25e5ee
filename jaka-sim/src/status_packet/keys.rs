//! The keys of status packets.

use crate::firmware::{Keys, Shape};

/// All keys by their names in the spec, in the order in which controllers send them. Firmware leaves some out; none that is known
/// has another order.
const ORDER: &[(Keys, &[&str])] = &[
    (Keys::Common, &["length", "drag_status"]),
    (Keys::Extio, &["extio"]),
    (Keys::Common, &["error_code", "error_message", "monitor_data", "torque_sensor"]),
    (Keys::Newer, &["joint_velocities"]),
    (Keys::Common, &["joint_actual_position"]),
    (Keys::Newer, &["joint_commanded_position"]),
    (Keys::Common, &["actual_position"]),
    (Keys::Newer, &["commanded_position"]),
    (Keys::Common, &["digital_inputs", "digital_outputs", "analog_inputs", "analog_outputs"]),
    (Keys::Newer, &["tool_keys"]),
    (Keys::Common, &["tool_digital_inputs", "tool_digital_outputs", "tool_analog_inputs"]),
    (
        Keys::Newer,
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
    (
        Keys::Common,
        &[
            "task_state",
            "homed",
            "task_mode",
            "interpreter_state",
            "enabled",
            "paused",
            "rapid_rate",
            "current_tool_id",
            "current_user_frame_id",
            "on_soft_limit",
            "emergency_stop",
            "drag_near_limit",
            "function_inputs",
            "powered_on",
            "in_position",
            "motion_mode",
            "tcp_speed",
            "protective_stop",
            "point_key",
        ],
    ),
    (Keys::Newer, &["motion_line", "error_add_line", "tool_rs_signals"]),
    (Keys::Common, &["network_state"]),
];

/// The keys of a firmware's packets, by their names in the spec.
pub(super) fn keys(shape: &Shape) -> impl Iterator<Item = &str> {
    ORDER.iter().filter(|(keys, _)| shape.keys.contains(keys)).flat_map(|(_, names)| *names).map(|name| &**name)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn all_keys_of_the_spec_have_a_place() {
        let spec = jaka_spec::builtin().expect("the spec is correct");
        let named: BTreeSet<_> = spec.status_fields().iter().map(|field| &*field.name).collect();
        let placed: Vec<_> = ORDER.iter().flat_map(|(_, names)| *names).copied().collect();
        assert_eq!(placed.iter().copied().collect::<BTreeSet<_>>(), named);
        assert_eq!(placed.len(), named.len());
    }
}
