//! What status packets show of a state, key by key.

use std::iter::repeat_n;

use jaka_proto::messages::force::TorqueSensorCommunication;
use jaka_proto::messages::io::{AnalogOutputKind, DigitalOutputKind};
use jaka_proto::messages::program::ProgramState;
use jaka_proto::messages::status::{InterpreterState, TaskMode, TaskState};
use serde_json::{Value, json};

use crate::State;
use crate::firmware::Shape;
use crate::state::TorqueSensor;

/// Serial signals at the tool, of which there can be eight; none is set.
const RS_SIGNALS: usize = 8;
/// Six values of which none is measured.
const NO_READINGS: [f64; 6] = [0.0; 6];

/// The value of a key, by its name in the spec; `None` for a name that is not one.
///
/// Truth values are such here: how they are written, the spec says. What no part of the state determines has the value of a
/// captured packet.
pub(super) fn value(name: &str, state: &State, shape: &Shape) -> Option<Value> {
    modes(name, state).or_else(|| inputs_and_outputs(name, state, shape)).or_else(|| fieldbus(name, state, shape))
}

fn modes(name: &str, state: &State) -> Option<Value> {
    Some(match name {
        "drag_status" => json!(state.drag_mode),
        "error_code" => json!(state.error_code),
        "error_message" => json!(state.error_message),
        "joint_actual_position" => json!(state.joint_position.0),
        "joint_commanded_position" => json!(state.joint_commanded_position.0),
        "actual_position" => json!(<[f64; 6]>::from(state.tcp_pose)),
        "commanded_position" => json!(<[f64; 6]>::from(state.tcp_commanded_pose)),
        "joint_velocities" => json!(NO_READINGS),
        "task_state" => json!(i64::from(task_state(state))),
        "homed" => json!([true, true, true, true, true, true, false, false, false]),
        "task_mode" => json!(i64::from(if state.drag_mode { TaskMode::Drag } else { TaskMode::Manual })),
        "interpreter_state" => json!(i64::from(match state.program_state {
            ProgramState::Running => InterpreterState::Running,
            ProgramState::Paused => InterpreterState::Paused,
            _ => InterpreterState::Idle,
        })),
        "enabled" => json!(state.enabled),
        "paused" => json!(state.program_state == ProgramState::Paused),
        "rapid_rate" => json!(state.rapid_rate),
        "current_tool_id" => json!(state.tool_frame_id),
        "current_user_frame_id" => json!(state.user_frame_id),
        "on_soft_limit" => json!(state.on_soft_limit),
        "emergency_stop" => json!(state.emergency_stop),
        "drag_near_limit" => json!([0, 0, 0, 0, 0, 0]),
        "powered_on" => json!(state.powered),
        "in_position" => json!(state.in_position),
        "tcp_speed" => json!(state.tcp_speed),
        "protective_stop" => json!(state.protective_stop),
        "motion_mode" | "network_state" => json!(1),
        "point_key" | "motion_line" | "error_add_line" => json!(0),
        _ => return None,
    })
}

fn task_state(state: &State) -> TaskState {
    match (state.powered, state.enabled) {
        (false, _) => TaskState::PoweredOff,
        (true, false) => TaskState::PoweredOn,
        (true, true) => TaskState::Enabled,
    }
}

fn inputs_and_outputs(name: &str, state: &State, shape: &Shape) -> Option<Value> {
    Some(match name {
        "monitor_data" => {
            let rows = [shape.joint_row; 6].join("],[");
            let text = format!("[{},[[{rows}]]{}]", shape.monitor_head, shape.monitor_tail);
            serde_json::from_str(&text).unwrap_or_default()
        }
        "torque_sensor" => torque_sensor(&state.torque_sensor, shape.torque_readings),
        "digital_inputs" => json!(state.digital_inputs),
        "digital_outputs" => digital_outputs(state, DigitalOutputKind::Cabinet, shape.digital),
        "analog_inputs" => json!(state.analog_inputs),
        "analog_outputs" => analog_outputs(state, AnalogOutputKind::Cabinet, shape.analog),
        "tool_digital_inputs" => json!(state.tool_digital_inputs),
        "tool_digital_outputs" => digital_outputs(state, DigitalOutputKind::Tool, shape.tool_digital),
        "tool_analog_inputs" => json!(state.tool_analog_inputs),
        "tool_keys" => json!([0, 0, 0]),
        "tool_rs_signals" => repeat_n(json!(["", 0, 0, 0, 0, 0.0]), RS_SIGNALS).collect(),
        "relay_outputs" => digital_outputs(state, DigitalOutputKind::Relay, 2),
        "function_inputs" => {
            let inputs = state.function_inputs.iter().map(|input| json!([i64::from(input.kind), input.index]));
            let unassigned = shape.functions.saturating_sub(state.function_inputs.len());
            inputs.chain(repeat_n(json!([-1, -1]), unassigned)).collect()
        }
        _ => return None,
    })
}

/// The inputs and outputs of a fieldbus. Nothing sets its inputs.
fn fieldbus(name: &str, state: &State, shape: &Shape) -> Option<Value> {
    let kinds = [DigitalOutputKind::ModbusSlave, DigitalOutputKind::Profinet, DigitalOutputKind::EthernetIp];
    let mut buses = shape.fieldbuses.iter().zip(kinds);
    let (part, bus, kind) = buses.find_map(|(bus, kind)| Some((name.strip_prefix(bus.name)?, bus, kind)))?;
    Some(match part {
        "digital_inputs" => json!(vec![false; bus.digital]),
        "digital_outputs" => digital_outputs(state, kind, bus.digital),
        "analog_inputs" => json!(vec![0.0; bus.analog]),
        // Analog outputs are taken to count their places as digital ones do.
        "analog_outputs" => analog_outputs(state, AnalogOutputKind::from(i64::from(kind)), bus.analog),
        _ => return None,
    })
}

/// The first outputs of a place; those that have not been set are off.
fn digital_outputs(state: &State, kind: DigitalOutputKind, count: usize) -> Value {
    (0..).map(|index| state.digital_outputs.get(&(kind, index)).copied().unwrap_or_default()).take(count).collect()
}

/// The first outputs of a place; those that have not been set are 0.
fn analog_outputs(state: &State, kind: AnalogOutputKind, count: usize) -> Value {
    (0..).map(|index| state.analog_outputs.get(&(kind, index)).copied().unwrap_or_default()).take(count).collect()
}

/// Whether the sensor works does not follow from its mode, of which the sources disagree what is on. The raw reading is taken to be the contact force.
fn torque_sensor(sensor: &TorqueSensor, readings: usize) -> Value {
    let payload = json!([sensor.payload.mass, <[f64; 3]>::from(sensor.payload.centroid)]);
    // No command sets the parameters of a serial line, and nothing prints any.
    let connection = match sensor.communication {
        TorqueSensorCommunication::Rs485 => json!([]),
        _ => json!([sensor.address, sensor.port]),
    };
    let force = if sensor.working { sensor.contact_force } else { NO_READINGS };
    let measured =
        [json!(force), json!(force)].into_iter().chain(repeat_n(json!(NO_READINGS), readings.saturating_sub(2)));
    let state = [json!(i64::from(sensor.working)), json!(0)].into_iter().chain(measured);
    let kind = i64::from(sensor.communication == TorqueSensorCommunication::Rs485);
    json!([[kind, connection, payload], state.collect::<Value>()])
}
