//! The status packet.

mod extio;
mod newer;

use jaka_proto::messages::force::TorqueSensorCommunication;
use jaka_proto::messages::io::literal as io_literal;
use jaka_proto::messages::io::{AnalogOutputKind, DigitalOutputKind, FunctionInput, FunctionInputKind};
use jaka_proto::messages::program::ProgramState;
use jaka_proto::messages::status::literal as status_literal;
use jaka_proto::messages::status::{
    InterpreterState, JointMonitor, MonitorData, RobotStatus, TaskMode, TaskState, TorqueSensorPayload,
    TorqueSensorReport, TorqueSensorSettings, TorqueSensorState, TorqueSensorTcp,
};
use jaka_proto::wire::{Encode, Typed, Value, Writer};

use crate::firmware::{PacketKeys, Shape};
use crate::json_text::respace;
use crate::state::TorqueSensor;
use crate::{Firmware, Separators, State};

/// Elements of a withdrawn key in the document's sample.
const HOMED: usize = 9;

/// The packet that shows a state: the keys of the document's sample, in its order, as far as the firmware sends them.
pub(crate) fn packet(state: &State, firmware: Firmware) -> Vec<u8> {
    let mut status = RobotStatus::default();
    let shape = firmware.shape();
    set_head(state, &mut status);
    set_io(state, shape, &mut status);
    set_modes(state, &mut status);
    set_tail(state, shape, &mut status);
    if shape.packet_keys >= PacketKeys::Document {
        status.extio = Some(Typed::Known(extio::report(&state.extio)));
    }
    if shape.packet_keys >= PacketKeys::All {
        newer::add(state, &mut status);
    }
    with_length(status, shape.separators).into_bytes()
}

/// The packet's text, with its own length in it.
fn with_length(mut status: RobotStatus, separators: Separators) -> String {
    status.length = Some(0);
    let rest = text(&status, separators).len() - 1;
    let mut length = rest;
    // The length counts its own digits. It never shrinks here, so this ends.
    while rest + length.to_string().len() != length {
        length = rest + length.to_string().len();
    }
    status.length = i64::try_from(length).ok();
    text(&status, separators)
}

fn text(status: &RobotStatus, separators: Separators) -> String {
    let mut out = Writer::new();
    status.encode(&mut out);
    if separators == Separators::Compact { out.into_string() } else { respace(out.as_str(), separators) }
}

fn set_head(state: &State, status: &mut RobotStatus) {
    status.drag_status = Some(state.drag_mode);
    status.error_code = Some(state.error_code.clone());
    status.error_message = Some(state.error_message.clone());
    status.monitor_data = Some(Typed::Known(monitor_data()));
    status.torque_sensor = Some(Typed::Known(torque_sensor(&state.torque_sensor)));
    status.joint_actual_position = Some(state.joint_position);
    status.actual_position = Some(state.tcp_pose);
}

fn set_io(state: &State, shape: Shape, status: &mut RobotStatus) {
    status.digital_inputs = Some(state.digital_inputs.clone());
    status.digital_outputs = Some(digital_outputs(state, DigitalOutputKind::Cabinet, shape.digital));
    status.analog_inputs = Some(state.analog_inputs.clone());
    status.analog_outputs = Some(analog_outputs(state, AnalogOutputKind::Cabinet, shape.analog));
    status.tool_digital_inputs = Some(state.tool_digital_inputs.clone());
    status.tool_digital_outputs = Some(digital_outputs(state, DigitalOutputKind::Tool, shape.tool_digital));
    status.tool_analog_inputs = Some(state.tool_analog_inputs.clone());
}

/// The first outputs of a place; those that have not been set are off.
fn digital_outputs(state: &State, kind: DigitalOutputKind, count: usize) -> Vec<bool> {
    let is_on = |index| state.digital_outputs.get(&(kind, index)).copied().unwrap_or_default();
    (0..).map(is_on).take(count).collect()
}

/// The first outputs of a place; those that have not been set are 0.
fn analog_outputs(state: &State, kind: AnalogOutputKind, count: usize) -> Vec<f64> {
    let value = |index| state.analog_outputs.get(&(kind, index)).copied().unwrap_or_default();
    (0..).map(value).take(count).collect()
}

fn set_modes(state: &State, status: &mut RobotStatus) {
    status.task_state = Some(match (state.powered, state.enabled) {
        (false, _) => TaskState::PoweredOff,
        (true, false) => TaskState::PoweredOn,
        (true, true) => TaskState::Enabled,
    });
    status.homed = Some(Typed::Known(vec![false; HOMED]));
    status.task_mode = Some(if state.drag_mode { TaskMode::Drag } else { TaskMode::Manual });
    status.interpreter_state = Some(match state.program_state {
        ProgramState::Running => InterpreterState::Running,
        ProgramState::Paused => InterpreterState::Paused,
        _ => InterpreterState::Idle,
    });
    status.enabled = Some(state.enabled);
    status.paused = Some(state.program_state == ProgramState::Paused);
    status.rapid_rate = Some(state.rapid_rate);
    status.current_tool_id = Some(state.tool_frame_id);
    status.current_user_frame_id = Some(state.user_frame_id);
}

/// The keys that the document does not explain have its values if no part of the state determines them.
fn set_tail(state: &State, shape: Shape, status: &mut RobotStatus) {
    let unassigned = FunctionInput::from(io_literal::FunctionInput { kind: FunctionInputKind::Unassigned, index: -1 });
    let inputs = state.function_inputs.iter().copied().chain(std::iter::repeat(unassigned));
    let count = state.function_inputs.len().max(shape.functions);
    status.on_soft_limit = Some(state.on_soft_limit);
    status.emergency_stop = Some(state.emergency_stop);
    status.drag_near_limit = Some(Typed::Known(vec![0; 6]));
    status.function_inputs = Some(Typed::Known(inputs.take(count).collect()));
    status.powered_on = Some(state.powered);
    status.in_position = Some(state.in_position);
    status.motion_mode = Some(1);
    status.tcp_speed = Some(state.tcp_speed);
    status.protective_stop = Some(state.protective_stop);
    status.point_key = Some(0);
    status.network_state = Some(1);
}

/// Measurements, all of them 0: there are no physics yet.
fn monitor_data() -> MonitorData {
    let joint = JointMonitor::from(status_literal::JointMonitor {
        current: 0.0,
        voltage: 0.0,
        temperature: 0.0,
        average_power: 0.0,
        current_fluctuation: 0.0,
        total_revolutions: 0.0,
        total_running_time: 0.0,
        cycles_since_start: 0.0,
        running_time_since_start: 0.0,
        torque: 0.0,
        eleventh: None,
    });
    MonitorData::from(status_literal::MonitorData {
        scb_major_version: 0,
        scb_minor_version: 0,
        cabinet_temperature: 0.0,
        bus_average_power: 0.0,
        bus_average_current: 0.0,
        joints: vec![joint; 6],
    })
}

fn torque_sensor(sensor: &TorqueSensor) -> TorqueSensorReport {
    let payload = TorqueSensorPayload::from(status_literal::TorqueSensorPayload {
        mass: sensor.payload.mass,
        centroid: sensor.payload.centroid,
    });
    let payload = Typed::Known(payload);
    let settings = if sensor.communication == TorqueSensorCommunication::Rs485 {
        // No command sets the line's parameters, and nothing prints any.
        TorqueSensorSettings::from(status_literal::TorqueSensorSettings::Serial {
            connection: Typed::Raw(Value::Array(Vec::new())),
            payload,
        })
    } else {
        let connection = TorqueSensorTcp::from(status_literal::TorqueSensorTcp {
            address: sensor.address.clone(),
            port: sensor.port,
        });
        TorqueSensorSettings::from(status_literal::TorqueSensorSettings::Tcp { connection, payload })
    };
    // Whether the sensor works does not follow from its mode, of which the sources disagree what is on.
    let state = TorqueSensorState::from(status_literal::TorqueSensorState {
        working: false,
        error_code: Typed::Known(0),
        contact_force: [0.0; 6],
        raw_reading: [0.0; 6],
    });
    TorqueSensorReport::from(status_literal::TorqueSensorReport { settings, state })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_length_counts_itself() {
        // Lengths around those at which it gets another digit, and so counts one more.
        for padding in (0..120).chain(900..1020).chain(9_900..10_020) {
            let mut status = RobotStatus::default();
            status.error_message = Some("x".repeat(padding));
            let text = with_length(status.clone(), Separators::Compact);
            assert!(text.starts_with(&format!("{{\"len\":{},", text.len())), "{padding}: {text}");
            let text = with_length(status, Separators::Spaced);
            assert!(text.starts_with(&format!("{{\"len\": {}, ", text.len())), "{padding}: {text}");
        }
    }
}
