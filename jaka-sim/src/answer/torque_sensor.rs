//! The torque sensor and its payload.

use jaka_proto::Request;
use jaka_proto::messages::force::{
    GetToolPayloadReply, GetTorqSensorIdentifyStatusReply, GetTorqSensorPayloadIdentifyResultReply,
    GetTorqueSensorBrandReply, GetTorqueSensorCommReply, IdentifyStatus,
};
use jaka_proto::messages::types::MoveMode;
use jaka_proto::wire::Writer;

use super::{Outcome, accept, reply};
use crate::state::{Payload, TorqueSensor};
use crate::{State, motion};

pub(super) fn answer(request: &Request, state: &mut State, out: &mut Writer) -> Outcome {
    match request {
        Request::StartTorqSensorPayloadIdentify(command) => {
            motion::move_joints(state, MoveMode::Absolute, command.joint_position);
            state.torque_sensor.identify_status = IdentifyStatus::Done;
            accept(command, out)
        }
        _ => match set(request, &mut state.torque_sensor, out) {
            Outcome::Unhandled => get(request, &state.torque_sensor, out),
            outcome => outcome,
        },
    }
}

fn set(request: &Request, sensor: &mut TorqueSensor, out: &mut Writer) -> Outcome {
    match request {
        Request::SetTorqueSensorBrand(command) => {
            sensor.brand = command.brand;
            accept(command, out)
        }
        Request::SetTorqueSensorMode(command) => {
            sensor.mode = command.mode;
            accept(command, out)
        }
        Request::SetTorqueSensorComm(command) => {
            sensor.communication = command.communication;
            sensor.address.clone_from(&command.address);
            sensor.port = command.port;
            accept(command, out)
        }
        Request::SetToolPayload(command) => {
            sensor.payload = Payload { mass: command.mass, centroid: command.centroid };
            accept(command, out)
        }
        _ => Outcome::Unhandled,
    }
}

fn get(request: &Request, sensor: &TorqueSensor, out: &mut Writer) -> Outcome {
    match request {
        Request::GetTorqueSensorBrand(command) => {
            reply(command, GetTorqueSensorBrandReply { brand: sensor.brand }, out)
        }
        Request::GetTorqueSensorComm(command) => {
            let (address, communication, port) = (sensor.address.clone(), sensor.communication, sensor.port);
            reply(command, GetTorqueSensorCommReply { address, communication, port }, out)
        }
        Request::GetToolPayload(command) => {
            let Payload { mass, centroid } = sensor.payload;
            reply(command, GetToolPayloadReply { centroid, mass }, out)
        }
        Request::GetTorqSensorIdentifyStatus(command) => {
            reply(command, GetTorqSensorIdentifyStatusReply { status: sensor.identify_status }, out)
        }
        Request::GetTorqSensorPayloadIdentifyResult(command) => {
            let Payload { mass, centroid } = sensor.identified;
            reply(command, GetTorqSensorPayloadIdentifyResultReply { centroid, mass }, out)
        }
        _ => Outcome::Unhandled,
    }
}
