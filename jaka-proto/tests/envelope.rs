//! Envelope of a reply, as it is read and written.

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
fn a_name_or_message_that_is_not_text_is_absent() {
    let envelope = Envelope::read(r#"{"cmdName": 7, "errorMsg": ["?"], "errorCode": "0"}"#).expect("it is an object");
    assert_eq!((envelope.command, &*envelope.message), (None, ""));
    let envelope = Envelope::read("{}").expect("it is an object");
    assert_eq!((envelope.command, &*envelope.message), (None, ""));
}

#[test]
fn what_is_not_an_object_throughout_has_no_envelope() {
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

/// Objects with these keys: in the usual form, which takes one pass, and in one that takes a closer look.
fn both_ways(keys: &str) -> [String; 2] {
    [format!("{{{keys}}}"), format!("{{{keys}, \"new\" : \"\\ud83d\"}}")]
}

#[test]
fn two_codes_that_differ_are_no_success() {
    for codes in [
        r#""errorCode": 2, "errorCode": 0"#,
        r#""errorCode": "0", "errorCode": "2""#,
        r#""errorCode": "0", "errorCode": "0", "errorCode": "2""#,
        r#""errorCode": "2", "errorCode": "0", "errorCode": "0""#,
        r#""errorCode": "2", "error\u0043ode": "0""#,
        r#""errorCode": "0", "errorCode": null"#,
        r#""errorCode": "fine", "errorCode": "0""#,
        r#""errorCode": "0", "errorMsg": "", "errorMsg": "failed""#,
    ] {
        for json in both_ways(&format!(r#""cmdName": "jog", {codes}"#)) {
            let reply = read_reply::<()>(jaka_proto::messages::motion::Jog::INFO, &json).expect(&json);
            let envelope = reply.envelope.expect("it is an object");
            assert!(envelope.code.is_err_and(|error| error.to_string().ends_with("the key appears twice")), "{json}");
            assert_eq!(reply.payload, None, "{json}");
        }
    }
}

#[test]
fn keys_that_come_twice_and_say_the_same_are_believed() {
    let keys = r#""errorCode": "0", "errorCode": 0, "errorMsg": "a", "errorMsg": "\u0061", "cmdName": "jog", "cmdName": " jog ""#;
    for json in both_ways(keys) {
        let envelope = Envelope::read_odd(&json).expect("it is an object");
        assert_eq!((envelope.code, &*envelope.message), (Ok(ErrorCode(0)), "a"));
        assert_eq!(envelope.command.as_deref(), Some("jog"));
    }
}

#[test]
fn two_names_are_none_and_two_messages_are_both_reported() {
    let keys = r#""errorCode": "2", "errorMsg": "a", "errorMsg": "b", "cmdName": "jog", "cmdName": "get_joint_pos""#;
    for json in both_ways(keys) {
        let envelope = Envelope::read_odd(&json).expect("it is an object");
        assert_eq!((envelope.command.as_deref(), &*envelope.message), (None, "a / b"));
        assert!(envelope.refusal().is_some());
    }
}

#[test]
fn an_odd_reply_is_read_as_far_as_its_envelope_can_be() {
    let deep = format!("{}{}", "[".repeat(1000), "]".repeat(1000));
    let bytes = jaka_proto::framing::text(b"\"\xc4\xe3\"").into_owned();
    for odd in ["\"\\ud83d\"", "\"\\x\"", "NaN", "-Infinity", "nan", "None", "0x10", "{\"a\": [NaN]}", &deep, &bytes] {
        for code in ["\"0\"", "0", "\"2\"", "2"] {
            let json = format!(r#"{{"x": {odd}, "errorCode": {code}, "errorMsg": "no", "cmdName": "jog"}}"#);
            assert!(Envelope::read(&json).is_err(), "{json}");
            let envelope = Envelope::read_odd(&json).expect(&json);
            let number = code.trim_matches('"').parse().expect("it is one");
            assert_eq!((envelope.code, &*envelope.message), (Ok(ErrorCode(number)), "no"), "{json}");
            assert_eq!(envelope.command.as_deref(), Some("jog"), "{json}");
        }
        // A value that is odd itself is not believed.
        let json = format!(r#"{{"errorCode": {odd}, "errorMsg": {odd}, "cmdName": {odd}}}"#);
        let envelope = Envelope::read_odd(&json).expect(&json);
        assert_eq!((envelope.code.is_ok(), envelope.command), (false, None), "{json}");
        assert!(envelope.message.chars().all(|c| c == '\u{fffd}' || c == 'x'), "{json}");
    }
}

#[test]
fn a_payload_is_read_next_to_what_is_odd_and_never_out_of_it() {
    let read = |x: &str, joints: &str| {
        let json = format!(r#"{{"x": {x}, "errorCode": "0", "cmdName": "get_joint_pos", "joint_pos": {joints}}}"#);
        read_reply::<GetJointPosReply>(GetJointPos::INFO, &json).expect(&json).payload.expect("it is accepted")
    };
    for odd in ["NaN", "\"\\ud83d\"", "{\"a\": Infinity}", "[\"\\q\"]"] {
        let payload = read(odd, "[1, 2, 3, 4, 5, 6]").expect("it fits");
        assert_eq!(payload.joint_position, [1.0, 2.0, 3.0, 4.0, 5.0, 6.0].into());
    }
    for odd in
        ["[1, 2, 3, 4, 5, NaN]", "[1, 2, 3, 4, 5, \"\\ud83d\"]", "NaN", "[1, 2, 3, 4, 5, 0x6]", "[1, 2, 3, 4, 5, 6] 7"]
    {
        let json = format!(r#"{{"errorCode": "0", "cmdName": "get_joint_pos", "joint_pos": {odd}}}"#);
        let reply = read_reply::<GetJointPosReply>(GetJointPos::INFO, &json);
        assert!(reply.is_ok_and(|reply| matches!(reply.payload, Some(Err(_)))) || odd.ends_with('7'), "{odd}");
    }
}

#[test]
fn what_is_not_an_object_by_its_brackets_has_no_envelope() {
    for json in [
        "",
        "7",
        "[]",
        "{",
        r#"{"errorCode": "0""#,
        r#"{"errorCode": "0"} x"#,
        r#"{"errorCode": "0" "cmdName": "jog"}"#,
        r#"{"errorCode": , "cmdName": "jog"}"#,
        r#"{"x": [}, "errorCode": "0"]}"#,
        r#"{"x": "a"b", "errorCode": "0"}"#,
        r#"{"errorCode": "0",}"#,
        "{errorCode: 0}",
    ] {
        assert!(Envelope::read_odd(json).is_err(), "{json}");
    }
}

#[test]
fn a_code_is_a_number_in_full() {
    let code = |code: &str| Envelope::read_odd(&format!(r#"{{"errorCode": {code}}}"#)).expect(code).code;
    for odd in
        ["0x10f0005", "0x0", "\"0x\"", "\"0x-0\"", "\"0x+0\"", "1e-400", "\"1e-400\"", "0.5", "0 0", "00x", "true"]
    {
        if let Ok(found) = Envelope::read_odd(&format!(r#"{{"errorCode": {odd}}}"#)) {
            assert!(found.code.is_err(), "{odd}: {:?}", found.code);
        }
    }
    assert_eq!(code("0e5"), Ok(ErrorCode(0)));
    assert_eq!(code("-0.0"), Ok(ErrorCode(0)));
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
    let reply = read_payload::<GetJointPosReply>(GetJointPos::INFO, r#"{"joint_pos": [1, 2, 3, 4, 5, 6.5]}"#);
    let reply = reply.expect("it fits");
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
    assert_eq!((expected.extio_status.count, expected.extio_status.modules.len()), (0, 0));
    assert_eq!(read(bare).expect("as firmware without modules answers"), expected);
    assert_eq!(read("(0, [)").expect_err("no literal").field(), "extio_status");
    assert_eq!(read(&format!(" {bare}\n")).expect("blanks around it"), expected);
    assert!(read_payload::<GetJointPosReply>(GetJointPos::INFO, bare).is_err());
}
