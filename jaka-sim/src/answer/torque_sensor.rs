//! The torque sensor and its payload.

use jaka_proto::Request;
use jaka_proto::messages::force::{IdentifyStatus, StartTorqSensorPayloadIdentify};

use super::{Draft, Outcome, reply};
use crate::state::TorqueSensor;
use crate::world::World;

pub(super) fn answer(request: &Request, world: &mut World, out: &mut Draft<'_>) -> Outcome {
    if let Request::StartTorqSensorPayloadIdentify(command) = request {
        return Outcome::accepted_if(identify(command, world));
    }
    match get(request, &world.state.torque_sensor, out) {
        Outcome::Unhandled => set(request, &mut world.state.torque_sensor),
        outcome => outcome,
    }
}

/// Starts the motion after which the payload is known: what the arm carries, as set by `set_payload`.
fn identify(command: &StartTorqSensorPayloadIdentify, world: &mut World) -> bool {
    const SPEED: f64 = 30.0;
    const ACCELERATION: f64 = 60.0;
    let is_planned = world.enqueue(world.plan_joints(command.joint_position.0, SPEED, ACCELERATION));
    if is_planned {
        world.identifying = true;
        world.state.torque_sensor.identify_status = IdentifyStatus::NotDone;
    }
    is_planned
}

fn set(request: &Request, sensor: &mut TorqueSensor) -> Outcome {
    match request {
        Request::SetTorqueSensorMode(command) => sensor.mode = command.mode,
        Request::SetTorqueSensorComm(command) => {
            sensor.communication = command.communication;
            sensor.address.clone_from(&command.address);
            sensor.port = command.port;
        }
        Request::SetToolPayload(command) => {
            (sensor.payload.mass, sensor.payload.centroid) = (command.mass, command.centroid);
        }
        _ => return Outcome::Unhandled,
    }
    Outcome::Accepted
}

fn get(request: &Request, sensor: &TorqueSensor, out: &mut Draft<'_>) -> Outcome {
    match request {
        Request::GetTorqueSensorComm(command) => reply(command, out, |reply| {
            reply.address.clone_from(&sensor.address);
            (reply.communication, reply.port) = (sensor.communication, sensor.port);
        }),
        Request::GetToolPayload(command) => reply(command, out, |reply| *reply = sensor.payload),
        Request::GetTorqSensorIdentifyStatus(command) => {
            reply(command, out, |reply| reply.status = sensor.identify_status)
        }
        Request::GetTorqSensorPayloadIdentifyResult(command) => reply(command, out, |reply| *reply = sensor.identified),
        _ => Outcome::Unhandled,
    }
}
