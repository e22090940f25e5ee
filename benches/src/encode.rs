//! Requests into a buffer that is used again.

use std::hint::black_box;

use jaka_proto::Command;
use jaka_proto::messages::force::{SetTorqueSensorComm, TorqueSensorCommunication};
use jaka_proto::messages::io::SetDigitalOutput;
use jaka_proto::messages::kinematics::KineInverse;
use jaka_proto::messages::motion::{Jog, JogFrame, JointMove};
use jaka_proto::messages::servo::ServoJ;
use jaka_proto::messages::types::Switch;
use jaka_proto::messages::variables::ModifyUserDefinedVariable;
use jaka_proto::wire::Writer;

use crate::measure::{Contender, Work};
use crate::peers;

/// A joint position as a control loop computes it.
const JOINTS: [f64; 6] =
    [-30.493_253_803_788_52, -50.842_380_480_615_08, 138.309_417_791_358_1, 90.0, -125.668_473_915_200_78, 0.125];

/// Requests of seven kinds.
pub fn works() -> Vec<Work<'static>> {
    let sensor = SetTorqueSensorComm::new(TorqueSensorCommunication::TcpIp, "172.30.1.110", 55_555);
    let pose = [-375.260_386_452_649_9, 12.5, 300.0, -180.0, 0.25, 89.999_999_999_999_99];
    vec![
        work("encode joint_move: enum, floats", JointMove::absolute(JOINTS, 20.5).acceleration(60.0)),
        servo_j(),
        work("encode jog: variants", Jog::increment(JogFrame::Joint, 3, 30.0, 20.5)),
        work("encode set_digital_output: whole numbers", SetDigitalOutput::cabinet(12, Switch::On)),
        work("encode set_torque_sensor_comm: a string", sensor),
        work(
            "encode modify_user_defined_variable: a string, a float",
            ModifyUserDefinedVariable::new(5500, "s_new", 14.5),
        ),
        work("encode kine_inverse: two arrays", KineInverse::new(JOINTS, pose)),
    ]
}

fn work<C: Command + 'static>(name: &'static str, request: C) -> Work<'static> {
    let mut generated = Writer::new();
    let ours = move || {
        generated.clear();
        black_box(&request).write_request(&mut generated);
        black_box(&generated);
    };
    Work { name, contenders: vec![Contender::new("ours", ours)], targets: Vec::new() }
}

/// The request of a servo loop, also by serde.
fn servo_j() -> Work<'static> {
    let mut work = work("encode servo_j: floats", ServoJ::absolute(JOINTS).step_count(1));
    let typed = peers::ServoJ { relFlag: 0, jointPosition: JOINTS, stepNum: Some(1) };
    let mut buffer = Vec::new();
    let by_serde = move || {
        buffer.clear();
        serde_json::to_writer(&mut buffer, black_box(&typed)).expect("a buffer takes everything");
        black_box(&buffer);
    };
    let by_value = || {
        let joints = black_box(JOINTS);
        let value = serde_json::json!({"cmdName": "servo_j", "relFlag": 0, "jointPosition": joints, "stepNum": 1});
        black_box(value.to_string());
    };
    work.contenders.extend([Contender::new("serde, typed", by_serde), Contender::new("Value", by_value)]);
    work
}
