//! `RobotControlAndMachineVisionLaboratory/jaka_controller_tcp_ros`, a ROS node in C++: it reads a reply by one `recv`
//! of 8192 bytes, and looks into the reply to `get_data` alone.

use jaka_sim::{Firmware, Model};
use jaka_tests::{Arm, CYCLE};
use serde_json::{Map, Value};

use super::{Wire, object, six};

/// Size of the client's buffer, and of its one read of a reply.
const READ: usize = 8192;

const GET_DATA: &str = r#"{"cmdName":"get_data"}"#;

/// An arm of the repository's kind, a Zu 7.
fn arm(firmware: Firmware) -> Arm {
    let model = Model::named("zu7").expect("it is published").clone();
    let arm = Arm::stepped().without_power().no_packets();
    arm.controller(|controller| controller.model(model).firmware(firmware)).start()
}

/// The positions that the client takes from a reply to `get_data`, of which it needs six each.
fn positions(reply: &str) -> Option<([f64; 6], [f64; 6])> {
    let reply: Map<String, Value> = object(reply)?;
    Some((six(&reply, "joint_actual_position")?, six(&reply, "actual_position")?))
}

/// `RobotControlAndMachineVisionLaboratory/jaka_controller_tcp_ros`, `src/libs/robot_client_tcp.cpp`: the reply to
/// `get_data` of newer firmware fills the client's buffer, so that its terminating zero goes behind it. What is left
/// comes before the next reply: the client asks again and again, and never has a pose.
#[test]
fn the_packet_of_newer_firmware_does_not_fit_into_its_buffer() {
    let arm = arm(Firmware::Newer);
    let mut wire = Wire::connect(&arm);
    let first = wire.ask(GET_DATA, READ);
    assert_eq!(first.len(), READ);
    assert!(first.starts_with(r#"{"errorCode": "0", "#) && positions(&first).is_none());
    let mut left = wire.arrived.len();
    assert!(left > 0);
    for _ in 0..20 {
        let reply = wire.ask(GET_DATA, READ);
        assert!(positions(&reply).is_none() && !reply.starts_with(r#"{"errorCode""#), "{reply:.80}");
        assert!(wire.arrived.len() > left, "what is left grows");
        left = wire.arrived.len();
        arm.advance(CYCLE);
    }
}
