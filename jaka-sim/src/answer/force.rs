//! Drag mode and control that yields to forces.

use jaka_proto::Request;
use jaka_proto::messages::force::{AdmittanceAxis, ComplianceType, SetAdmitCtrlConfig};
use jaka_proto::wire::Typed;

use super::{Draft, Outcome, accept, is_on, reply};
use crate::state::AdmittanceControl;
use crate::world::World;

pub(super) fn answer(request: &Request, world: &mut World, out: &mut Draft<'_>) -> Outcome {
    let state = &mut world.state;
    match request {
        Request::SetTorqueControl(command) => {
            state.drag_mode = is_on(command.enable_flag);
            accept(command, out)
        }
        Request::DragStatus(command) => reply(command, out, |reply| reply.drag_status = state.drag_mode),
        Request::EnableAdmittanceCtrl(command) => {
            state.admittance.enabled = is_on(command.enable_flag);
            accept(command, out)
        }
        // The document does not say whether drag mode ends as well; here it does not.
        Request::DisableForceControl(command) => {
            state.admittance.enabled = false;
            state.admittance.compliance_type = ComplianceType::Off;
            accept(command, out)
        }
        _ => settings(request, &mut state.admittance, out),
    }
}

fn settings(request: &Request, control: &mut AdmittanceControl, out: &mut Draft<'_>) -> Outcome {
    match request {
        Request::SetAdmitCtrlConfig(command) => {
            set_axis(&mut control.axes, command);
            accept(command, out)
        }
        Request::GetAdmitCtrlConfig(command) => {
            // One more level than the document's text has, as in its sample.
            let axes = Typed::Known(vec![control.axes.to_vec()]);
            reply(command, out, |reply| reply.axes = axes)
        }
        Request::SetCompliantType(command) => {
            control.compliance_type = command.compliance_type;
            control.sensor_compensation = is_on(command.sensor_compensation);
            accept(command, out)
        }
        Request::GetCompliantType(command) => {
            let AdmittanceControl { compliance_type, sensor_compensation, .. } = *control;
            reply(command, out, |reply| {
                (reply.compliance_type, reply.sensor_compensation) = (compliance_type, sensor_compensation);
            })
        }
        Request::SetComplianceCondition(command) => {
            control.condition = command.condition;
            accept(command, out)
        }
        Request::SetVelCompliantCtrl(command) => {
            control.velocity = command.compliance;
            accept(command, out)
        }
        _ => Outcome::Unhandled,
    }
}

/// The axes that do not exist have been refused before.
fn set_axis(axes: &mut [AdmittanceAxis], command: &SetAdmitCtrlConfig) {
    let index = usize::try_from(i64::from(command.axis)).ok();
    if let Some(axis) = index.and_then(|index| axes.get_mut(index)) {
        axis.enabled = is_on(command.enabled);
        axis.user_force = command.user_force;
        axis.rebound = command.rebound;
        axis.constant_force = command.constant_force;
        axis.normal_track = command.normal_track;
    }
}
