//! Contents of status packets for a state.

use std::iter::repeat_n;

use jaka_proto::messages::force::TorqueSensorCommunication;
use jaka_proto::messages::io::{AnalogOutputKind, DigitalOutputKind};
use jaka_proto::messages::program::ProgramState;
use jaka_proto::messages::status::{ExtioReport, InterpreterState, RobotStatus, TaskMode, TaskState};
use jaka_proto::wire::Typed;
use serde_json::{Value, json};

use super::extio;
use crate::State;
use crate::firmware::{Shape, TOOL_DIGITAL};
use crate::state::TorqueSensor;

/// Number of serial signals at the tool (up to eight), none of which is set.
const RS_SIGNALS: usize = 8;
/// Number of functions with a possible input. The query has two fewer in the document.
const FUNCTIONS: usize = 15;
/// Six values without a measurement.
const NO_READINGS: [f64; 6] = [0.0; 6];

/// Returns the contents of a packet, with the keys of the firmware: the values of the state, and those of a captured
/// packet where the state does not determine them.
///
/// `extio` is a report on extension I/O modules to fill in.
pub(super) fn status(state: &State, shape: &Shape, extio: Option<&ExtioReport>) -> RobotStatus {
    let mut status = RobotStatus::default();
    status.length = Some(0);
    modes(state, shape, &mut status);
    inputs_and_outputs(state, shape, &mut status);
    let report = extio.filter(|_| shape.extio).cloned();
    let report = report.and_then(|report| extio::filled(report, &state.extio, shape.extio_module_id));
    status.extio = report.map(Typed::Known);
    if shape.newer_keys {
        newer(state, &mut status);
        fieldbuses(state, &mut status);
    }
    status
}

fn modes(state: &State, shape: &Shape, status: &mut RobotStatus) {
    let is_paused = state.program_state == ProgramState::Paused;
    status.drag_status = Some(state.drag_mode);
    status.error_code = Some(state.error_code.clone());
    status.error_message = Some(state.error_message.clone());
    status.joint_actual_position = Some(state.joint_position);
    status.actual_position = Some(state.tcp_pose);
    status.task_state = Some(match (state.powered, state.enabled) {
        (false, _) => TaskState::PoweredOff,
        (true, false) => shape.disabled,
        (true, true) => TaskState::Enabled,
    });
    status.homed = Some([vec![true; 6], vec![false; 3]].concat().into());
    status.task_mode = Some(if state.drag_mode { TaskMode::Drag } else { TaskMode::Manual });
    status.interpreter_state = Some(match state.program_state {
        ProgramState::Running => InterpreterState::Running,
        ProgramState::Paused => InterpreterState::Paused,
        _ => InterpreterState::Idle,
    });
    status.enabled = Some(state.enabled);
    status.paused = Some(is_paused);
    status.rapid_rate = Some(state.rapid_rate);
    status.current_tool_id = Some(state.tool_frame_id);
    status.current_user_frame_id = Some(state.user_frame_id);
    status.on_soft_limit = Some(state.on_soft_limit);
    status.emergency_stop = Some(state.emergency_stop);
    status.drag_near_limit = Some(vec![0; 6].into());
    status.powered_on = Some(state.powered);
    status.in_position = Some(state.in_position);
    status.tcp_speed = Some(state.tcp_speed);
    status.protective_stop = Some(state.protective_stop);
    (status.motion_mode, status.network_state, status.point_key) = (Some(1), Some(1), Some(0));
}

fn inputs_and_outputs(state: &State, shape: &Shape, status: &mut RobotStatus) {
    let rows = [shape.joint_row; 6].join("],[");
    let monitor_data = format!("[{},[[{rows}]]{}]", shape.monitor_head, shape.monitor_tail);
    status.monitor_data = serde_json::from_str(&monitor_data).ok().map(Typed::Raw);
    status.torque_sensor = Some(Typed::Raw(torque_sensor(&state.torque_sensor, shape.torque_readings)));
    status.digital_inputs = Some(state.digital_inputs.clone());
    status.digital_outputs = Some(digital_outputs(state, DigitalOutputKind::Cabinet, shape.digital));
    status.analog_inputs = Some(state.analog_inputs.clone());
    status.analog_outputs = Some(analog_outputs(state, AnalogOutputKind::Cabinet, shape.analog));
    status.tool_digital_inputs = Some(state.tool_digital_inputs.clone());
    status.tool_digital_outputs = Some(digital_outputs(state, DigitalOutputKind::Tool, TOOL_DIGITAL));
    status.tool_analog_inputs = Some(state.tool_analog_inputs.clone());
    let functions = state.function_inputs.iter().map(|input| json!([i64::from(input.kind), input.index]));
    let unassigned = FUNCTIONS.saturating_sub(state.function_inputs.len());
    status.function_inputs = Some(Typed::Raw(functions.chain(repeat_n(json!([-1, -1]), unassigned)).collect()));
}

/// Sets the keys of newer firmware, except those of fieldbuses.
fn newer(state: &State, status: &mut RobotStatus) {
    status.joint_velocities = Some(NO_READINGS.to_vec().into());
    status.joint_commanded_position = Some(state.joint_commanded_position);
    status.commanded_position = Some(state.tcp_commanded_pose);
    status.tool_keys = Some(vec![0; 3].into());
    status.tool_rs_signals = Some(Typed::Raw(repeat_n(json!(["", 0, 0, 0, 0, 0.0]), RS_SIGNALS).collect()));
    status.relay_outputs = Some(digital_outputs(state, DigitalOutputKind::Relay, 2).into());
    (status.motion_line, status.error_add_line) = (Some(0.into()), Some(0.into()));
}

/// Sets the inputs and outputs of fieldbuses, with the lengths of a captured packet. The simulator never sets the
/// inputs. It assumes that analog outputs count their places as digital ones do.
fn fieldbuses(state: &State, status: &mut RobotStatus) {
    let inputs = |count| Some(vec![false; count].into());
    let values = |count| Some(vec![0.0; count].into());
    let outputs = |kind, count| Some(digital_outputs(state, kind, count).into());
    let analog = |kind: DigitalOutputKind, count| {
        Some(analog_outputs(state, AnalogOutputKind::from(i64::from(kind)), count).into())
    };
    status.modbus_slave_digital_inputs = inputs(128);
    status.modbus_slave_digital_outputs = outputs(DigitalOutputKind::ModbusSlave, 128);
    status.modbus_slave_analog_inputs = values(64);
    status.modbus_slave_analog_outputs = analog(DigitalOutputKind::ModbusSlave, 64);
    status.profinet_device_digital_inputs = inputs(64);
    status.profinet_device_digital_outputs = outputs(DigitalOutputKind::Profinet, 64);
    status.profinet_device_analog_inputs = values(64);
    status.profinet_device_analog_outputs = analog(DigitalOutputKind::Profinet, 64);
    status.ethernet_ip_adapter_digital_inputs = inputs(64);
    status.ethernet_ip_adapter_digital_outputs = outputs(DigitalOutputKind::EthernetIp, 64);
    status.ethernet_ip_adapter_analog_inputs = values(48);
    status.ethernet_ip_adapter_analog_outputs = analog(DigitalOutputKind::EthernetIp, 48);
}

/// Returns the first outputs of a place; outputs not set are off.
fn digital_outputs(state: &State, kind: DigitalOutputKind, count: usize) -> Vec<bool> {
    (0..).map(|index| state.digital_outputs.get(&(kind, index)).copied().unwrap_or_default()).take(count).collect()
}

/// Returns the first outputs of a place; outputs not set are 0.
fn analog_outputs(state: &State, kind: AnalogOutputKind, count: usize) -> Vec<f64> {
    (0..).map(|index| state.analog_outputs.get(&(kind, index)).copied().unwrap_or_default()).take(count).collect()
}

/// Returns the value of the torque sensor. The raw reading is assumed to be the contact force. The sensor's mode does
/// not show whether it works, since sources disagree on the mode that is on.
fn torque_sensor(sensor: &TorqueSensor, readings: usize) -> Value {
    let payload = json!([sensor.payload.mass, <[f64; 3]>::from(sensor.payload.centroid)]);
    // No command sets the parameters of a serial line, and no source shows any.
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
