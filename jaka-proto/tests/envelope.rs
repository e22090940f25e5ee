//! What replies have in common, as it is read and written.

use jaka_proto::messages::io::{GetExtioStatus, GetExtioStatusReply};
use jaka_proto::messages::kinematics::{GetJointPos, GetJointPosReply};
use jaka_proto::wire::Writer;
use jaka_proto::{Command, Envelope, ErrorCode, Refusal, read_payload, read_reply, write_refusal, write_reply};

fn written(write: impl FnOnce(&mut Writer)) -> String {
    let mut out = Writer::new();
    write(&mut out);
    out.into_string()
}

#[test]
fn the_parts_of_an_envelope() {
    let envelope = Envelope::read(r#"{"cmdName": " jog ", "errorMsg": "no \u00b5", "errorCode": 2, "x": [{}]}"#);
    let envelope = envelope.expect("it is an object");
    assert_eq!(envelope.command.as_deref(), Some("jog"));
    assert_eq!((envelope.code, &*envelope.message), (Ok(ErrorCode(2)), "no \u{b5}"));
}

#[test]
fn a_name_or_message_that_is_no_text_is_absent() {
    let envelope = Envelope::read(r#"{"cmdName": 7, "errorMsg": ["?"], "errorCode": "0"}"#).expect("it is an object");
    assert_eq!((envelope.command, &*envelope.message), (None, ""));
    let envelope = Envelope::read("{}").expect("it is an object");
    assert_eq!((envelope.command, &*envelope.message), (None, ""));
}

#[test]
fn what_is_no_object_throughout_has_no_envelope() {
    for json in
        ["", "7", "[]", "{", r#"{"errorCode": 0"#, r#"{"errorCode": 0} x"#, r#"{"x": nope}"#, r#"{"cmdName": x}"#]
    {
        assert!(Envelope::read(json).is_err(), "{json}");
    }
}

#[test]
fn only_a_code_other_than_zero_refuses() {
    let refusal = |json| Envelope::read(json).expect("it is an object").refusal();
    assert_eq!(refusal(r#"{"errorCode": "0", "cmdName": "jog"}"#), None);
    assert_eq!(refusal(r#"{"cmdName": "jog"}"#), None);
    let refused = Refusal::new("jog", ErrorCode(-1), "not now");
    assert_eq!(refusal(r#"{"errorCode": "-1", "cmdName": "jog", "errorMsg": "not now"}"#), Some(refused));
}

#[test]
fn only_an_accepted_reply_has_a_payload() {
    let joints = r#""joint_pos" : [1, 2, 3, 4, 5, 6]"#;
    let read = |json: &str| {
        let reply = read_reply::<GetJointPosReply>(GetJointPos::INFO, json).expect("it is an object");
        assert!(reply.envelope.is_some(), "{json}");
        reply.payload
    };
    let payload = read(&format!(r#"{{"errorCode" : 0, {joints}}}"#)).expect("it is accepted").expect("it fits");
    assert_eq!(payload.joint_position, [1.0, 2.0, 3.0, 4.0, 5.0, 6.0].into());
    assert!(matches!(read(r#"{"errorCode" : "0"}"#), Some(Err(_))));
    assert_eq!(read(&format!(r#"{{"errorCode": "2", {joints}}}"#)), None);
    assert_eq!(read(&format!("{{{joints}}}")), None);
    let bare = read_reply::<GetExtioStatusReply>(GetExtioStatus::INFO, "(0, [], {'state': 0})").expect("it is a tuple");
    assert!(bare.envelope.is_none() && matches!(bare.payload, Some(Ok(_))), "{bare:?}");
}

#[test]
fn a_refusal_in_words() {
    let with = Refusal::new("jog", ErrorCode(2), "not now");
    assert_eq!(with.to_string(), "the controller refused `jog` with code 2: not now");
    let without = Refusal::new("jog", ErrorCode(2), "");
    assert_eq!(without.to_string(), "the controller refused `jog` with code 2");
}

#[test]
fn replies_are_written_as_controllers_write_them() {
    let reply = GetJointPosReply { joint_position: [1.0, 2.0, 3.0, 4.0, 5.0, 6.5].into() };
    assert_eq!(
        written(|out| write_reply(GetJointPos::INFO, &reply, out)),
        r#"{"errorCode":"0","errorMsg":"","cmdName":"get_joint_pos","joint_pos":[1,2,3,4,5,6.5]}"#
    );
    assert_eq!(
        written(|out| write_refusal(Some("jog"), ErrorCode(-1), "a \"quote\"", out)),
        r#"{"errorCode":"-1","errorMsg":"a \"quote\"","cmdName":"jog"}"#
    );
    assert_eq!(written(|out| write_refusal(None, ErrorCode(1), "?", out)), r#"{"errorCode":"1","errorMsg":"?"}"#);
}

#[test]
fn a_bare_tuple_is_read_as_the_field_it_stands_for_and_only_where_it_may_be_one() {
    let bare = "(0, [], {'state': 0})";
    let read = |reply: &str| read_payload::<GetExtioStatusReply>(GetExtioStatus::INFO, reply);
    let wrapped = format!(r#"{{"errorCode": "0", "cmdName": "get_extio_status", "extio_status": "{bare}"}}"#);
    let expected = read(&wrapped).expect("the document's form");
    assert_eq!(read(bare).expect("as firmware without modules answers"), expected);
    assert_eq!(read(&format!(" {bare}\n")).expect("blanks around it"), expected);
    assert!(read_payload::<GetJointPosReply>(GetJointPos::INFO, bare).is_err());
}
