//! A reply of fixed shape: whose it is, whether it was accepted, and its payload.

use std::hint::black_box;

use jaka_proto::messages::kinematics::{GetJointPos, GetJointPosReply};
use jaka_proto::{Command, read_reply};
use serde_json::Value;

use crate::measure::{Contender, Target, Work};
use crate::peers;

/// A reply with positions of full precision.
pub const JOINT_POS: &str = r#"{"errorCode": "0", "errorMsg": "", "cmdName": "get_joint_pos", "joint_pos": [-30.49325380378852, -50.84238048061508, 138.3094177913581, 90.0, -125.66847391520078, 0.125]}"#;

/// The reply of `get_joint_pos`.
///
/// # Panics
/// The ways of reading it do not agree.
pub fn works() -> Vec<Work<'static>> {
    let read: [f64; 6] = ours(JOINT_POS).joint_position.into();
    assert_eq!([by_serde(JOINT_POS).joint_pos, by_value(JOINT_POS).joint_pos], [read; 2]);
    vec![Work {
        name: "decode get_joint_pos's reply",
        contenders: vec![
            Contender::new("ours", || ours(black_box(JOINT_POS))),
            Contender::new("serde, typed", || by_serde(black_box(JOINT_POS))),
            Contender::new("Value, from_value", || by_value(black_box(JOINT_POS))),
        ],
        targets: vec![Target::AtLeast("Value, from_value", 3.0, "ours")],
    }]
}

/// The reply, by the generated code.
///
/// # Panics
/// It is none.
pub fn ours(text: &str) -> GetJointPosReply {
    let reply = read_reply::<GetJointPosReply>(GetJointPos::INFO, text).expect("the reply is JSON");
    assert!(reply.envelope.is_some_and(|envelope| envelope.command.as_deref() == Some("get_joint_pos")));
    reply.payload.expect("the command was accepted").expect("the reply fits")
}

fn by_serde(text: &str) -> peers::JointPosReply<'_> {
    let reply: peers::JointPosReply<'_> = serde_json::from_str(text).expect("the reply fits");
    assert!(reply.cmdName == "get_joint_pos" && reply.errorCode == "0");
    reply
}

fn by_value(text: &str) -> peers::JointPos {
    let value: Value = serde_json::from_str(text).expect("the reply is JSON");
    assert!(value["cmdName"] == "get_joint_pos" && value["errorCode"] == "0");
    serde_json::from_value(value).expect("the reply fits")
}
