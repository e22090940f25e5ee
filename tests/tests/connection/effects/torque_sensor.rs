//! The torque sensor and its payload.

use jaka_sync::Typed;
use jaka_sync::force::{IdentifyStatus, SetToolPayload, SetTorqueSensorComm, TorqueSensorCommunication};
use jaka_sync::payload::SetPayload;
use jaka_sync::status::TorqueSensorSettings;

use super::arm::{Arm, assert_close, servo_mode, turned};

effects! {
    set_torque_sensor_mode => the_mode_is_kept,
    start_torq_sensor_payload_identify => identification_moves_the_arm,
    get_torq_sensor_identify_staus => identification_is_told,
    get_torq_sensor_payload_identify_result => the_result_is_the_payload,
    set_tool_payload => the_payload_shows_on_port_10000,
    get_tool_payload => the_payload_is_read,
    set_torque_sensor_comm => the_way_to_the_sensor_shows_on_port_10000,
    get_torque_sensor_comm => the_way_to_the_sensor_is_read,
}

/// Values on port 10000 of a sensor that is reached over TCP: address, port, and mass at the sensor.
fn shown(arm: &Arm) -> (String, i64, f64) {
    let report = arm.status().torque_sensor;
    match report {
        Some(Typed::Known(report)) => match report.settings {
            TorqueSensorSettings::Tcp { connection, payload: Typed::Known(payload), .. } => {
                (connection.address, connection.port, payload.mass)
            }
            other => panic!("the sensor is not reached over TCP: {other:?}"),
        },
        other => panic!("the packet has no sensor: {other:?}"),
    }
}

fn status(arm: &mut Arm) -> IdentifyStatus {
    arm.client.get_torq_sensor_identify_status().expect("it answers").status
}

/// No command reads it back.
fn the_mode_is_kept(arm: &mut Arm) {
    for mode in [1, 0] {
        arm.client.set_torque_sensor_mode(mode).expect("it answers");
        assert_eq!(arm.controller.state().remembered["set_torque_sensor_mode"]["mode"], mode);
    }
}

fn identification_moves_the_arm(arm: &mut Arm) {
    let end = turned(arm.joints(), 20.0);
    arm.client.start_torq_sensor_payload_identify(end).expect("it is reachable");
    assert_eq!(arm.status().in_position, Some(false));
    arm.wait(10);
    assert_close(arm.joints(), end, 1e-9);
    arm.refuses(servo_mode, |client| client.start_torq_sensor_payload_identify(end));
}

fn identification_is_told(arm: &mut Arm) {
    let end = turned(arm.joints(), 20.0);
    arm.client.start_torq_sensor_payload_identify(end).expect("it is reachable");
    assert_eq!(status(arm), IdentifyStatus::NotDone);
    arm.wait(10);
    assert_eq!(status(arm), IdentifyStatus::Done);
    arm.client.start_torq_sensor_payload_identify(turned(end, 20.0)).expect("it is reachable");
    arm.controller.collide();
    assert_eq!(status(arm), IdentifyStatus::Failed);
}

fn the_result_is_the_payload(arm: &mut Arm) {
    let (mass, centroid) = (1.5, [1.0, 2.0, 30.0].into());
    arm.client.set_payload(&SetPayload::new(mass, centroid)).expect("it answers");
    let before = arm.client.get_torq_sensor_payload_identify_result().expect("it answers");
    assert_ne!(before.centroid, centroid);
    let end = turned(arm.joints(), 20.0);
    arm.client.start_torq_sensor_payload_identify(end).expect("it is reachable");
    arm.wait(10);
    let after = arm.client.get_torq_sensor_payload_identify_result().expect("it answers");
    assert_eq!((after.mass, after.centroid), (mass, centroid));
}

fn the_payload_shows_on_port_10000(arm: &mut Arm) {
    let arms = arm.client.get_payload().expect("it answers");
    let (mass, centroid) = (0.5, [7.0, 8.0, 9.0].into());
    arm.client.set_tool_payload(&SetToolPayload::new(mass, centroid)).expect("it answers");
    assert_eq!(shown(arm).2.to_bits(), mass.to_bits());
    let payload = arm.client.get_tool_payload().expect("it answers");
    assert_eq!((payload.mass, payload.centroid), (mass, centroid));
    // That of the arm is another.
    assert_eq!(arm.client.get_payload().expect("it answers"), arms);
}

fn the_payload_is_read(arm: &mut Arm) {
    let (mass, centroid) = (0.25, [3.0, 4.0, 5.0].into());
    arm.controller.set_state(|state| {
        state.torque_sensor.payload.mass = mass;
        state.torque_sensor.payload.centroid = centroid;
    });
    let payload = arm.client.get_tool_payload().expect("it answers");
    assert_eq!((payload.mass, payload.centroid), (mass, centroid));
}

fn the_way_to_the_sensor_shows_on_port_10000(arm: &mut Arm) {
    let (communication, address, port) = (TorqueSensorCommunication::TcpIp, "10.0.0.7".to_owned(), 5000);
    let request = SetTorqueSensorComm::new(communication, address.clone(), port);
    arm.client.set_torque_sensor_comm(&request).expect("it answers");
    let (shown_address, shown_port, _) = shown(arm);
    assert_eq!((shown_address, shown_port), (address.clone(), port));
    let reply = arm.client.get_torque_sensor_comm().expect("it answers");
    assert_eq!((reply.communication, reply.address, reply.port), (communication, address, port));
}

fn the_way_to_the_sensor_is_read(arm: &mut Arm) {
    arm.controller.set_state(|state| {
        state.torque_sensor.communication = TorqueSensorCommunication::Rs485;
        state.torque_sensor.port = 2;
    });
    let reply = arm.client.get_torque_sensor_comm().expect("it answers");
    assert_eq!((reply.communication, reply.port), (TorqueSensorCommunication::Rs485, 2));
}
