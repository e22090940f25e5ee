//! A plane that the tool touches.

use std::time::Duration;

use crate::common::{Peer, assert_accepted, json, stepped};
use jaka_sim::Contact;

/// 1 mm takes so much, in N.
const STIFFNESS: f64 = 50.0;

#[test]
fn the_sensor_shows_the_force_and_the_controller_how_deep_the_tool_was() {
    let controller = stepped();
    controller.set_state(|state| state.torque_sensor.working = true);
    let tool = controller.state().tcp_pose;
    let plane = Contact::plane([tool.x, tool.y, tool.z - 2.0], [0.0, 0.0, 3.0], STIFFNESS);
    controller.set_contact(Some(plane)).expect("it is one");
    let mut status = Peer::status(&controller);
    status.receive();
    let mut peer = Peer::commands(&controller);
    let mut move_by = |z: f64| {
        let request = format!(
            r#"{{"cmdName":"moveL","relFlag":1,"cartPosition":[0,0,{z},0,0,0],"speed":50,"accel":500,"tol":0}}"#
        );
        assert_accepted(&peer.ask(&request), "moveL");
        controller.advance(Duration::from_secs(2));
        controller.publish();
        let sensor = json(&status.receive())["torqsensor"][1].clone();
        assert_eq!((&sensor[0], &sensor[1]), (&1.into(), &0.into()), "it works, and has no error");
        assert_eq!(sensor[2], sensor[3]);
        sensor[2]
            .as_array()
            .expect("six values")
            .iter()
            .map(|value| value.as_f64().expect("a number"))
            .collect::<Vec<_>>()
    };
    assert_eq!(move_by(-1.5), [0.0; 6]);
    assert!(controller.deepest_penetration() == 0.0);
    // The tool points down, so that the plane pushes against its z axis.
    let force = move_by(-1.0);
    assert!((force[2] + 0.5 * STIFFNESS).abs() < 1e-3, "{force:?}");
    assert!(force.iter().enumerate().all(|(i, value)| i == 2 || value.abs() < 1e-3), "{force:?}");
    assert!((controller.deepest_penetration() - 0.5).abs() < 1e-6);
    // Back above it, the depth is remembered, until the plane is set again.
    assert_eq!(move_by(5.0), [0.0; 6]);
    assert!((controller.deepest_penetration() - 0.5).abs() < 1e-6);
    controller.set_contact(None).expect("that is allowed");
    assert!(controller.deepest_penetration() == 0.0);
    assert_eq!(move_by(-10.0), [0.0; 6]);
}

#[test]
fn a_sensor_that_does_not_work_shows_nothing() {
    let controller = stepped();
    let tool = controller.state().tcp_pose;
    let plane = Contact::plane([0.0, 0.0, tool.z + 1.0], [0.0, 0.0, 1.0], STIFFNESS);
    controller.set_contact(Some(plane)).expect("it is one");
    assert!((controller.deepest_penetration() - 1.0).abs() < 1e-9, "the tool is below it");
    let sensor = json(&Peer::status(&controller).receive())["torqsensor"][1].clone();
    assert_eq!(sensor, json("[0,0,[0,0,0,0,0,0],[0,0,0,0,0,0]]"));
    for odd in [
        Contact::plane([0.0; 3], [0.0; 3], 1.0),
        Contact::plane([f64::NAN, 0.0, 0.0], [0.0, 0.0, 1.0], 1.0),
        Contact::plane([0.0; 3], [0.0, 0.0, 1.0], -1.0),
    ] {
        assert!(
            controller.set_contact(Some(odd)).is_err() && jaka_sim::Controller::builder().contact(odd).start().is_err()
        );
    }
}
