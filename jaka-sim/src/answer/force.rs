//! Drag mode and control that yields to forces.

use jaka_proto::Request;
use jaka_proto::messages::force::{AdmittanceAxis, ComplianceType, SetAdmitCtrlConfig};
use jaka_proto::wire::Typed;

use super::{Draft, Outcome, is_on, reply};
use crate::State;
use crate::world::World;

pub(super) fn answer(request: &Request, world: &mut World, out: &mut Draft<'_>) -> Outcome {
    let state = &mut world.state;
    let control = &state.admittance;
    match request {
        Request::DragStatus(command) => reply(command, out, |reply| reply.drag_status = state.drag_mode),
        // One more level than the document's text has, as in its sample.
        Request::GetAdmitCtrlConfig(command) => {
            reply(command, out, |reply| reply.axes = Typed::Known(vec![control.axes.to_vec()]))
        }
        Request::GetCompliantType(command) => reply(command, out, |reply| {
            reply.compliance_type = control.compliance_type;
            reply.sensor_compensation = control.sensor_compensation;
        }),
        _ => set(request, state),
    }
}

fn set(request: &Request, state: &mut State) -> Outcome {
    let control = &mut state.admittance;
    match request {
        Request::SetTorqueControl(command) => state.drag_mode = is_on(command.enable_flag),
        Request::EnableAdmittanceCtrl(command) => control.enabled = is_on(command.enable_flag),
        // The document does not say whether drag mode ends as well; here it does not.
        Request::DisableForceControl(_) => (control.enabled, control.compliance_type) = (false, ComplianceType::Off),
        Request::SetAdmitCtrlConfig(command) => set_axis(&mut control.axes, command),
        Request::SetCompliantType(command) => {
            control.compliance_type = command.compliance_type;
            control.sensor_compensation = is_on(command.sensor_compensation);
        }
        Request::SetComplianceCondition(command) => control.condition = command.condition,
        Request::SetVelCompliantCtrl(command) => control.velocity = command.compliance,
        _ => return Outcome::Unhandled,
    }
    Outcome::Accepted
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
