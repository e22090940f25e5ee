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

use crate::limit::encode as limit;
use crate::measure::{Contender, Target, Work};
use crate::peers;

/// A joint position as a control loop computes it.
const JOINTS: [f64; 6] =
    [-30.493_253_803_788_52, -50.842_380_480_615_08, 138.309_417_791_358_1, 90.0, -125.668_473_915_200_78, 0.125];

/// At most this many times as long as hand-written code.
const AT_MOST: f64 = 1.25;

/// Requests of seven kinds.
pub fn works() -> Vec<Work<'static>> {
    let joint_move = JointMove::absolute(JOINTS, 20.5).acceleration(60.0);
    let jog = Jog::increment(JogFrame::Joint, 3, 30.0, 20.5);
    let output = SetDigitalOutput::cabinet(12, Switch::On);
    let communication = TorqueSensorCommunication::TcpIp;
    let sensor = SetTorqueSensorComm::new(communication, "172.30.1.110", 55_555);
    let variable = ModifyUserDefinedVariable::new(5500, "s_new", 14.5);
    let pose = [-375.260_386_452_649_9, 12.5, 300.0, -180.0, 0.25, 89.999_999_999_999_99];
    let inverse = KineInverse::new(JOINTS, pose);
    vec![
        work("encode joint_move: enum, floats", joint_move, limit::joint_move),
        servo_j(),
        work("encode jog: variants", jog, limit::jog),
        work("encode set_digital_output: whole numbers", output, limit::set_digital_output),
        work("encode set_torque_sensor_comm: a string", sensor, limit::set_torque_sensor_comm),
        work("encode modify_user_defined_variable: a string, a float", variable, limit::modify_variable),
        work("encode kine_inverse: two arrays", inverse, limit::kine_inverse),
    ]
}

/// The request by hand and by the generated code, which have to write the same.
fn work<C: Command + Clone + 'static>(name: &'static str, request: C, by_hand: fn(&C, &mut Vec<u8>)) -> Work<'static> {
    let (mut hand, mut generated) = (Vec::new(), Writer::new());
    by_hand(&request, &mut hand);
    request.write_request(&mut generated);
    assert_eq!(std::str::from_utf8(&hand), Ok(generated.as_str()));
    let same = request.clone();
    let limit = move || {
        hand.clear();
        by_hand(black_box(&same), &mut hand);
        black_box(&hand);
    };
    let ours = move || {
        generated.clear();
        black_box(&request).write_request(&mut generated);
        black_box(&generated);
    };
    Work {
        name,
        contenders: vec![Contender::new("limit", limit), Contender::new("ours", ours)],
        targets: vec![Target::AtMost("ours", AT_MOST, "limit")],
    }
}

/// The request of a servo loop, also by serde.
fn servo_j() -> Work<'static> {
    let request = ServoJ::absolute(JOINTS).step_count(1);
    let mut work = work("encode servo_j: floats", request, limit::servo_j);
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
