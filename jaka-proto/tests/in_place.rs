//! What is read over an earlier value is what is read afresh, and a reply read in one pass is what two passes read.

use jaka_proto::messages::collision::ProtectiveStopStatusReply;
use jaka_proto::messages::kinematics::{GetJointPos, GetJointPosReply};
use jaka_proto::messages::status::RobotStatus;
use jaka_proto::wire::{Decode, DecodeError, Reader, Typed, Value};
use jaka_proto::{Command, Envelope, read_payload, read_reply};

/// Packets that differ in everything that can be used again.
const PACKETS: [&str; 15] = [
    "{}",
    r#"{"len": 1, "errmsg": "a long message", "din": [0, 1, 0], "ain": [1.5, 2], "tio_rs_signals": [1, "two", {"x": 3}]}"#,
    r#"{"errmsg": "", "din": [1], "ain": ["0.25", 1e3, -7], "tio_rs_signals": ["one", [2]], "homed": [0, 1]}"#,
    r#"{"homed": "?", "tio_rs_signals": "text", "din": null, "torqsensor": 7}"#,
    r#"{"homed": [1], "tio_rs_signals": "longer text", "din": [], "enabled" : "True", "inp\u006fs": 1}"#,
    r#"{"monitor_data": [1, 2, 3, 4, 5, [[1,2,3,4,5,6,7,8,9,10], [1,2,3,4,5,6,7,8,9,10,11]]]}"#,
    r#"{"monitor_data": [1, 2, 3, 4, 5, [[1,2,3,4,5,6,7,8,9,10]], "more"]}"#,
    r#"{"torqsensor": [[0, ["10.5.5.1", 1], [1, [2, 3, 4]]], [1, 0, [1,2,3,4,5,6], [1,2,3,4,5,6]]]}"#,
    r#"{"torqsensor": [[1, [9600, 8, 1, "N"], "?"], [0, "none", [1,2,3,4,5,6], [6,5,4,3,2,1]]]}"#,
    r#"{"torqsensor": [[2, "new"], [0, 1, [1,2,3,4,5,6], [6,5,4,3,2,1]]]}"#,
    r#"{"extio": {"status": [[1],[0],[1.5],[]], "setup": [[1,"a",["10.5.5.2",502],[[0,1],[0,1],[0,1],[0,1]]], [0,"b",[9600,8,1,8,0,1],[[0,1],[0,1],[0,1],[0,1]]]], "num": 2, "pinmap": [[0,0,0,0]], "mode": 0}}"#,
    r#"{"extio": {"mode": 1, "status": [[],[],[],[]], "setup": [[0,"b",[9600,8,1,8,"N",1],[[0,1],[0,1],[0,1],[0,1]]]], "num": 0, "pinmap": []}}"#,
    // A key that must be there is absent, null, or there twice: nothing of the packet before may stand in for it.
    r#"{"extio": {"status": [[],[],[],[]], "setup": [], "num": 0, "pinmap": []}}"#,
    r#"{"extio": {"mode": 1, "status": [[],[],[],[]], "setup": [], "num": null, "pinmap": []}}"#,
    r#"{"extio": {"mode": 1, "status": [[],[],[],[]], "setup": [], "num": 0, "pinmap": [], "mode": 2}}"#,
];

fn afresh(packet: &str) -> Result<RobotStatus, DecodeError> {
    RobotStatus::decode(&mut Reader::new(packet))
}

#[test]
fn a_packet_over_any_other_is_the_packet() {
    for before in PACKETS {
        for packet in PACKETS {
            let mut status = afresh(before).expect(before);
            status.decode_into(&mut Reader::new(packet)).expect(packet);
            assert_eq!(Ok(status), afresh(packet), "{packet} over {before}");
        }
    }
}

#[test]
fn what_lacks_a_key_is_kept_raw() {
    for packet in &PACKETS[12..] {
        assert!(matches!(afresh(packet).expect(packet).extio, Some(Typed::Raw(_))), "{packet}");
    }
}

#[test]
fn errors_over_a_packet_are_the_same() {
    for packet in [
        r#"{"din": [0, 2]}"#,
        r#"{"din": [0,]}"#,
        r#"{"din": [0 1]}"#,
        r#"{"din": [0}"#,
        r#"{"len": 1, "len": 2}"#,
        r#"{"len": 1, "len": null}"#,
        r#"{"errmsg": 7}"#,
        r#"{"errmsg": "once", "errmsg": "twice"}"#,
        r#"{"actual_position": [1, 2, 3, 4, 5, 6, 7]}"#,
        r#"{"ain": [1, 2, "three"]}"#,
        r#"{"extio": {"num": 1, "num": 1"#,
        "[]",
        "{\"len\": 1",
    ] {
        let mut status = afresh(PACKETS[1]).expect("it is one");
        let error = status.decode_into(&mut Reader::new(packet)).expect_err(packet);
        assert_eq!(Err(error), afresh(packet));
    }
    assert!(afresh(r#"{"len": null, "len": 2}"#).is_ok_and(|status| status.length == Some(2)));
}

#[test]
fn memory_of_values_of_any_shape_is_used_again() {
    let place = |value: &Value| match value {
        Value::String(text) => text.as_ptr().addr(),
        Value::Array(list) => list.as_ptr().addr(),
        other => panic!("{other} has no memory of its own"),
    };
    for (before, after) in [(r#""a long text""#, r#""short""#), (r#"[1, "two", 3]"#, "[4, 5]")] {
        let mut value = Value::decode(&mut Reader::new(before)).expect(before);
        let memory = place(&value);
        value.decode_into(&mut Reader::new(after)).expect(after);
        assert_eq!((&value, place(&value)), (&after.parse().expect(after), memory), "{before}");
    }
}

#[test]
fn a_raw_value_can_become_known_and_raw_again() {
    let mut status = afresh(r#"{"homed": "?"}"#).expect("it is one");
    for (packet, homed) in [("[1]", Typed::Known(vec![true])), ("7", Typed::Raw(Value::from(7)))] {
        status.decode_into(&mut Reader::new(&format!("{{\"homed\": {packet}}}"))).expect(packet);
        assert_eq!(status.homed, Some(homed));
    }
}

#[test]
fn one_pass_reads_what_two_passes_read() {
    let joints = r#""joint_pos": [0, "1", 2.5, -3e1, 4, 5.123456789012345678]"#;
    for reply in [
        format!(r#"{{"errorCode": "0", "errorMsg": "", "cmdName": "get_joint_pos", {joints}}}"#),
        format!(r#"{{{joints}, "cmdName" : " get_joint_pos ", "errorCode":0}}"#),
        format!(r#"{{"errorCode": "0x0", "errorMsg": "a\"b", {joints}, "new": {{"errorCode": "7"}}}} "#),
        format!(r#"{{"errorCode": "0", "errorMsg": null, "cmdName": 7, {joints}}}"#),
        format!(r#"{{"errorCode": "0", "errorCode": "1", {joints}}}"#),
        format!(r#"{{"error\u0043ode": "0", "cmd\u004eame": "x", {joints}}}"#),
        format!(r#"{{"errorCode": "0", "cmdName": "x", {joints}}} x"#),
        format!(r#"{{"errorCode": "0", {joints}, {joints}}}"#),
        format!(r#"{{"errorCode": "fine", {joints}}}"#),
        format!("{{{joints}}}"),
        r#"{"errorCode": "2", "errorMsg": "no", "joint_pos": "?", "cmdName": "get_joint_pos"}"#.to_owned(),
        r#"{"errorCode": "0", "joint_pos": [1, 2]}"#.to_owned(),
        r#"{"errorCode": "0", "protective_stop": 1, "joint_pos": 7}"#.to_owned(),
        r#"{"errorCode": "0", "x": tru}"#.to_owned(),
        "[]".to_owned(),
        String::new(),
    ] {
        both::<GetJointPosReply>(&reply);
        both::<ProtectiveStopStatusReply>(&reply);
        both::<()>(&reply);
    }
}

fn both<R: jaka_proto::wire::Fields + PartialEq + std::fmt::Debug>(text: &str) {
    let info = GetJointPos::INFO;
    let envelope = Envelope::read(text);
    let reply = read_reply::<R>(info, text);
    assert_eq!(
        reply.as_ref().map(|reply| reply.envelope.clone()),
        envelope.as_ref().map(|e| Some(e.clone())),
        "{text}"
    );
    let Ok(envelope) = envelope else { return };
    let accepted = envelope.code.is_ok_and(jaka_proto::ErrorCode::is_success);
    let payload = accepted.then(|| read_payload::<R>(info, text));
    assert_eq!(reply.expect("it has an envelope").payload, payload, "{text}");
}

#[test]
fn a_bare_tuple_has_no_envelope() {
    let info = jaka_proto::messages::io::GetExtioStatus::INFO;
    let text = "(0, [], {'state': 0})";
    let reply = read_reply::<jaka_proto::messages::io::GetExtioStatusReply>(info, text).expect("it is one");
    assert_eq!(reply.envelope, None);
    assert_eq!(reply.payload, Some(read_payload(info, text)));
}

#[test]
fn what_is_passed_over_ends_where_it_ends() {
    for value in ["[1, [\"]\", {}], 2]", r#"{"a": {"b": "}\""}, "c": [1]}"#, "\"a\\\"b\"", "-1.5e3", "true", "null"] {
        let text = format!("[{value} , 7]");
        let mut reader = Reader::new(&text);
        reader.begin_array().expect("an array");
        assert_eq!(reader.next_element(), Ok(true));
        reader.pass().expect(value);
        assert_eq!((reader.next_element(), i64::decode(&mut reader)), (Ok(true), Ok(7)), "{value}");
    }
    for value in ["[1, 2", "{", "\"a", "\"a\\", "", "x"] {
        assert!(Reader::new(value).pass().is_err_and(|error| error.is_malformed()), "{value}");
    }
}
