//! Drag mode and control that yields to forces.

use jaka_sync::Typed;
use jaka_sync::force::{
    AdmittanceAxis, CartesianAxis, ComplianceType, SetAdmitCtrlConfig, SetComplianceCondition, SetCompliantType,
    VelocityCompliance,
};
use jaka_sync::status::TaskMode;
use jaka_sync::types::Switch;

use super::arm::{Arm, disabled};

effects! {
    torque_control_enable => drag_mode_shows_on_port_10000,
    drag_status => drag_mode_is_told,
    set_admit_ctrl_config => an_axis_is_given_back,
    get_admit_ctrl_config => axes_are_read,
    set_compliance_condition => the_condition_is_kept,
    enable_admittance_ctrl => admittance_control_is_switched,
    get_compliant_type => the_type_is_read,
    set_compliant_type => the_type_is_given_back,
    disable_force_control => force_control_is_switched_off,
    set_vel_compliant_ctrl => compliance_in_velocity_is_kept,
}

fn axis(arm: &Arm) -> AdmittanceAxis {
    let mut axis = arm.controller.state().admittance.axes[0];
    (axis.enabled, axis.normal_track) = (true, 2);
    (axis.user_force, axis.rebound, axis.constant_force) = (25.0, 3.0, 5.0);
    axis
}

fn axes(arm: &mut Arm) -> Vec<AdmittanceAxis> {
    match arm.client.get_admit_ctrl_config().expect("it answers").axes {
        Typed::Known(axes) => axes.concat(),
        Typed::Raw(raw) => panic!("these are not axes: {raw:?}"),
    }
}

fn drag_mode_shows_on_port_10000(arm: &mut Arm) {
    arm.client.set_torque_control(Switch::On).expect("the arm is enabled");
    let status = arm.status();
    assert_eq!((status.drag_status, status.task_mode), (Some(true), Some(TaskMode::Drag)));
    arm.client.set_torque_control(Switch::Off).expect("the arm is enabled");
    let status = arm.status();
    assert_eq!((status.drag_status, status.task_mode), (Some(false), Some(TaskMode::Manual)));
    arm.refuses(disabled, |client| client.set_torque_control(Switch::On));
}

fn drag_mode_is_told(arm: &mut Arm) {
    arm.controller.set_state(|state| state.drag_mode = true);
    assert!(arm.client.drag_status().expect("it answers").drag_status);
    // It ends where the arm is not enabled.
    arm.controller.set_state(disabled);
    assert!(!arm.client.drag_status().expect("it answers").drag_status);
}

fn an_axis_is_given_back(arm: &mut Arm) {
    let mut expected = axes(arm);
    let AdmittanceAxis { user_force, constant_force, normal_track, rebound, .. } = axis(arm);
    expected[5] = axis(arm);
    let request =
        SetAdmitCtrlConfig::new(CartesianAxis::Rz, Switch::On, user_force, constant_force, normal_track, rebound);
    arm.client.set_admit_ctrl_config(&request).expect("it answers");
    assert_eq!(axes(arm), expected);
}

fn axes_are_read(arm: &mut Arm) {
    let axis = axis(arm);
    arm.controller.set_state(|state| state.admittance.axes[1] = axis);
    assert_eq!(axes(arm), arm.controller.state().admittance.axes);
    assert_eq!(axes(arm)[1], axis);
}

/// No command reads it back.
fn the_condition_is_kept(arm: &mut Arm) {
    let condition = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
    arm.client.set_compliance_condition(&SetComplianceCondition::new(condition)).expect("it answers");
    let kept = &arm.controller.state().remembered["set_compliance_condition"]["condition"];
    assert_eq!(kept.to_string(), "[1,2,3,4,5,6]");
}

/// No command reads it back.
fn admittance_control_is_switched(arm: &mut Arm) {
    for (flag, enabled) in [(Switch::On, true), (Switch::Off, false)] {
        arm.client.enable_admittance_ctrl(flag).expect("it answers");
        assert_eq!(arm.controller.state().admittance.enabled, enabled);
    }
}

fn the_type_is_read(arm: &mut Arm) {
    arm.controller.set_state(|state| {
        state.admittance.compliance_type = ComplianceType::Velocity;
        state.admittance.sensor_compensation = false;
    });
    let reply = arm.client.get_compliant_type().expect("it answers");
    assert_eq!((reply.compliance_type, reply.sensor_compensation), (ComplianceType::Velocity, false));
}

fn the_type_is_given_back(arm: &mut Arm) {
    for (switch, sensor_compensation) in [(Switch::On, true), (Switch::Off, false)] {
        let compliance_type = ComplianceType::ConstantForce;
        let request = SetCompliantType::new(switch, compliance_type);
        arm.client.set_compliant_type(&request).expect("it answers");
        let reply = arm.client.get_compliant_type().expect("it answers");
        assert_eq!((reply.compliance_type, reply.sensor_compensation), (compliance_type, sensor_compensation));
    }
}

fn force_control_is_switched_off(arm: &mut Arm) {
    let compliance_type = ComplianceType::ConstantForce;
    let request = SetCompliantType::new(Switch::On, compliance_type);
    arm.client.set_compliant_type(&request).expect("it answers");
    arm.client.enable_admittance_ctrl(Switch::On).expect("it answers");
    arm.client.disable_force_control().expect("it answers");
    assert_eq!(arm.client.get_compliant_type().expect("it answers").compliance_type, ComplianceType::Off);
    assert!(!arm.controller.state().admittance.enabled);
}

/// No command reads it back.
fn compliance_in_velocity_is_kept(arm: &mut Arm) {
    let compliance = VelocityCompliance::new(1, 0.1, 0.2, 0.3, 0.4);
    arm.client.set_vel_compliant_ctrl(compliance).expect("it answers");
    let kept = &arm.controller.state().remembered["set_vel_compliant_ctrl"]["compliance"];
    assert_eq!(kept.to_string(), "[1,0.1,0.2,0.3,0.4]");
}
