//! What firmware that is newer than the document adds to a packet.

use jaka_proto::messages::io::{AnalogOutputKind, DigitalOutputKind};
use jaka_proto::messages::status::RobotStatus;
use jaka_proto::wire::{Typed, Value};

use super::{analog_outputs, digital_outputs};
use crate::State;

/// Keys at the tool.
const TOOL_KEYS: usize = 3;
/// Relays.
const RELAYS: usize = 2;
/// Serial signals at the tool.
const SIGNALS: usize = 8;

/// How many inputs a fieldbus has, and as many outputs.
#[derive(Debug, Clone, Copy)]
struct Fieldbus {
    digital: usize,
    analog: usize,
}

const MODBUS: Fieldbus = Fieldbus { digital: 128, analog: 64 };
const PROFINET: Fieldbus = Fieldbus { digital: 64, analog: 64 };
const ETHERNET_IP: Fieldbus = Fieldbus { digital: 64, analog: 48 };

/// Adds the keys that the document does not have, and the eleventh value of each joint.
///
/// Nothing sets the inputs of a fieldbus, the keys at the tool and its signals: they are off.
pub(super) fn add(state: &State, status: &mut RobotStatus) {
    status.joint_commanded_position = Some(state.joint_commanded_position);
    status.commanded_position = Some(state.tcp_commanded_pose);
    status.tool_keys = Some(Typed::Known(vec![0; TOOL_KEYS]));
    status.joint_velocities = Some(Typed::Known(vec![0.0; 6]));
    status.relay_outputs = Some(Typed::Known(digital_outputs(state, DigitalOutputKind::Relay, RELAYS)));
    // Each signal is said to have a name; there are none.
    status.tool_rs_signals = Some(Value::Array(vec![Value::Array(Vec::new()); SIGNALS]));
    status.motion_line = Some(Typed::Known(0));
    status.error_add_line = Some(Typed::Known(0));
    add_fieldbuses(state, status);
    if let Some(Typed::Known(monitor)) = &mut status.monitor_data {
        monitor.joints.iter_mut().for_each(|joint| joint.eleventh = Some(0.0));
    }
}

fn add_fieldbuses(state: &State, status: &mut RobotStatus) {
    [status.modbus_slave_digital_inputs, status.modbus_slave_digital_outputs] =
        digital(state, DigitalOutputKind::ModbusSlave, MODBUS);
    [status.modbus_slave_analog_inputs, status.modbus_slave_analog_outputs] =
        analog(state, DigitalOutputKind::ModbusSlave, MODBUS);
    [status.profinet_device_digital_inputs, status.profinet_device_digital_outputs] =
        digital(state, DigitalOutputKind::Profinet, PROFINET);
    [status.profinet_device_analog_inputs, status.profinet_device_analog_outputs] =
        analog(state, DigitalOutputKind::Profinet, PROFINET);
    [status.ethernet_ip_adapter_digital_inputs, status.ethernet_ip_adapter_digital_outputs] =
        digital(state, DigitalOutputKind::EthernetIp, ETHERNET_IP);
    [status.ethernet_ip_adapter_analog_inputs, status.ethernet_ip_adapter_analog_outputs] =
        analog(state, DigitalOutputKind::EthernetIp, ETHERNET_IP);
}

/// The inputs and outputs of a fieldbus.
type Both<T> = [Option<Typed<Vec<T>>>; 2];

fn digital(state: &State, kind: DigitalOutputKind, bus: Fieldbus) -> Both<bool> {
    [vec![false; bus.digital], digital_outputs(state, kind, bus.digital)].map(|pins| Some(Typed::Known(pins)))
}

/// Analog outputs are taken to count their places as digital ones do.
fn analog(state: &State, kind: DigitalOutputKind, bus: Fieldbus) -> Both<f64> {
    let outputs = analog_outputs(state, AnalogOutputKind::from(i64::from(kind)), bus.analog);
    [vec![0.0; bus.analog], outputs].map(|pins| Some(Typed::Known(pins)))
}
