//! Values read over earlier ones equal values read afresh; a reply read in one pass equals one read in two passes.

use jaka_proto::messages::collision::ProtectiveStopStatusReply;
use jaka_proto::messages::kinematics::{GetJointPos, GetJointPosReply};
use jaka_proto::messages::status::RobotStatus;
use jaka_proto::wire::{Decode, DecodeError, Reader, Typed, Value};
use jaka_proto::{Command, Envelope, read_payload, read_reply};

/// Packets each with a field that does not fit, and perhaps `len`, which is 7 or does not fit.
const UNFIT: [(&str, &str); 21] = [
    (r#"{"len": 7, "din": [0, 2]}"#, "field `digital_inputs[1]`: expected a truth value, found `2`"),
    (r#"{"din": [0,], "len": 7}"#, "field `digital_inputs`: not JSON: expected a value after the comma at byte 11"),
    (r#"{"len": 7, "din": [0 1]}"#, "field `digital_inputs`: not JSON: expected `,` or `]` at byte 21"),
    (r#"{"len": 1, "len": 2}"#, "field `length`: the key appears twice"),
    (r#"{"len": 1, "len": null}"#, "field `length`: the key appears twice"),
    (r#"{"len": "?", "len": 7}"#, "field `length`: expected a whole number, found `\"?\"`"),
    (r#"{"len": 7, "len": 7, "len": 7}"#, "field `length`: the key appears twice"),
    (r#"{"errmsg": 7, "len": 7}"#, "field `error_message`: expected a string, found `7`"),
    (r#"{"errmsg": "once", "errmsg": "twice", "len": 7}"#, "field `error_message`: the key appears twice"),
    (r#"{"errmsg": "\ud83d", "len": 7}"#, "field `error_message`: not JSON: expected valid escapes in a string"),
    (
        r#"{"actual_position": [1, 2, 3, 4, 5, 6, 7], "len": 7}"#,
        "field `actual_position`: expected the end of the array",
    ),
    (
        r#"{"actual_position": [1, 2, 3, NaN, 5, 6], "len": 7}"#,
        "field `actual_position.rx`: not JSON: expected a value",
    ),
    (r#"{"ain": [1, 2, "three"], "len": 7}"#, "field `analog_inputs[2]`: expected a number, found `\"three\"`"),
    (r#"{"len": 7, "rapidrate": "100%"}"#, "field `rapid_rate`: expected a number, found `\"100%\"`"),
    (r#"{"len": 7, "drag_status": 2}"#, "field `drag_status`: expected a truth value, found `2`"),
    (
        r#"{"len": 7, "drag_status": {"new": [{}, "}"]}}"#,
        "field `drag_status`: expected a truth value, found `{\"new\"",
    ),
    (r#"{"protective_stop": 0x1, "len": 7}"#, "field `protective_stop`: not JSON: expected `,` or `}`"),
    (r#"{"protective_stop": 1x, "len": 7}"#, "field `protective_stop`: not JSON: expected `,` or `}`"),
    (r#"{"protective_stop": True , "len": 7}"#, "field `protective_stop`: not JSON: expected a value"),
    (r#"{"protective_stop": nullx, "len": 7}"#, "field `protective_stop`: expected a truth value, found `null`"),
    (r#"{"rapidrate": Infinity, "len": 7}"#, "field `rapid_rate`: not JSON: expected a value"),
];

/// Packets that differ in everything that can be used again.
const PACKETS: [&str; 19] = [
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
    // Tails of arrays that newer firmware sends.
    r#"{"monitor_data": [1, 2, 3, 4, 5, [[1,2,3,4,5,6,7,8,9,10]], 0, 0, 0, 23.39]}"#,
    r#"{"monitor_data": [1, 2, 3, 4, 5, [[1,2,3,4,5,6,7,8,9,10]], 0, 0]}"#,
    r#"{"tio_rs_signals": [["", 0, 0, 0, 0, 0.0], ["force", 1, 0, 1, 7, 10.0]]}"#,
    r#"{"tio_rs_signals": [[]]}"#,
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
    for packet in &PACKETS[12..14] {
        assert!(matches!(afresh(packet).expect(packet).extio, Some(Typed::Raw(_))), "{packet}");
    }
    assert_eq!(afresh(PACKETS[14]).expect("the packet stays").extio, None);
}

#[test]
fn errors_over_a_packet_are_the_same() {
    for packet in [r#"{"din": [0}"#, r#"{"extio": {"num": 1, "num": 1"#, "[]", "{\"len\": 1"] {
        let mut status = afresh(PACKETS[1]).expect("it is one");
        let error = status.decode_into(&mut Reader::new(packet)).expect_err(packet);
        assert_eq!(Err(error), afresh(packet));
    }
    assert!(afresh(r#"{"len": null, "len": 2}"#).is_ok_and(|status| status.length == Some(2)));
}

#[test]
fn a_field_that_does_not_fit_is_absent_and_reported_and_the_packet_stays() {
    let full = RobotStatus::decode(&mut Reader::new(FULL)).expect("it is one");
    for (packet, expected) in UNFIT {
        for before in [RobotStatus::default(), full.clone()] {
            let (mut status, mut reader) = (before, Reader::new(packet));
            status.decode_into(&mut reader).expect(packet);
            reader.end().expect(packet);
            let [unfit] = &reader.take_unfit()[..] else { panic!("{packet}: one is told") };
            assert!(unfit.to_string().starts_with(expected), "{packet}: {unfit}");
            let length = if unfit.is_in("length") { None } else { Some(7) };
            assert_eq!(
                status,
                RobotStatus::with_length(length),
                "{packet}: nothing else is there, also not from before"
            );
            assert_eq!(reader.take_unfit(), [], "it is told once");
        }
    }
}

/// A packet that has each field of [`UNFIT`].
const FULL: &str = r#"{"len": 1, "din": [1], "errmsg": "text", "actual_position": [1, 2, 3, 4, 5, 6], "ain": [1, 2],
    "rapidrate": 1, "drag_status": 1, "protective_stop": 0, "extio": {"mode": 1}}"#;

/// Type of packets that tests make with a given length.
trait WithLength {
    fn with_length(length: Option<i64>) -> Self;
}

impl WithLength for RobotStatus {
    fn with_length(length: Option<i64>) -> Self {
        let mut status = Self::default();
        status.length = length;
        status
    }
}

#[test]
fn several_fields_that_do_not_fit_are_each_reported_once() {
    let packet = r#"{"rapidrate": "100%", "protective_stop": 1, "drag_status": 2, "unknown": NaN, "drag_status": 1}"#;
    let mut reader = Reader::new(packet);
    let status = RobotStatus::decode(&mut reader).expect("it is an object");
    assert_eq!((status.protective_stop, status.rapid_rate, status.drag_status), (Some(true), None, None));
    let unfit = reader.take_unfit();
    assert_eq!(unfit.iter().map(DecodeError::field).collect::<Vec<_>>(), ["rapid_rate", "drag_status"]);
}

#[test]
fn values_of_unknown_keys_make_no_packet_unreadable() {
    let deep = format!("{}1{}", "[".repeat(10_000), "]".repeat(10_000));
    for value in ["NaN", "-Infinity", "0x10", r#""\ud83d""#, r#"{"a": NaN, "b": [}"#, &deep, "None", "1.2.3"] {
        let packet = format!(r#"{{"unknown": {value}, "protective_stop": 1}}"#);
        let status = afresh(&packet);
        let is_whole = !value.contains("[}");
        assert_eq!(status.is_ok_and(|status| status.protective_stop == Some(true)), is_whole, "{value}");
    }
}

#[test]
fn a_status_packet_inside_another_message_is_read_strictly() {
    assert!(Vec::<RobotStatus>::decode(&mut Reader::new(r#"[{"len": 1}]"#)).is_ok());
    assert!(Vec::<RobotStatus>::decode(&mut Reader::new(r#"[{"len": "?"}]"#)).is_err());
    assert!(serde_json::from_str::<RobotStatus>(r#"{"len": "?"}"#).is_err());
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

/// Depth to which arrays nest.
fn depth(mut value: &Value) -> usize {
    let mut depth = 0;
    while let Value::Array(list) = value {
        depth += 1;
        let Some(first) = list.first() else { break };
        value = first;
    }
    depth
}

/// `depth` arrays, one inside the other.
fn nested(depth: usize) -> String {
    format!("{}{}", "[".repeat(depth), "]".repeat(depth))
}

#[test]
fn nesting_does_not_grow_from_packet_to_packet() {
    // A stack on which thousands of levels do not fit: where they are accepted, it is the process that ends.
    let run = || {
        let mut value = Value::Null;
        let mut status = RobotStatus::default();
        for deepest in (1..5000).step_by(50) {
            let text = nested(deepest);
            let (fits, read) = (deepest <= 65, value.decode_into(&mut Reader::new(&text)));
            assert_eq!((read.is_ok(), Value::decode(&mut Reader::new(&text)).is_ok()), (fits, fits), "{deepest}");
            assert!(depth(&value) <= 65, "{} levels", depth(&value));
            let packet = format!(r#"{{"tio_rs_signals": {text}, "homed": {text}, "protective_stop": 1}}"#);
            let mut reader = Reader::new(&packet);
            status.decode_into(&mut reader).expect("the packet stays");
            assert_eq!((status.tool_rs_signals.is_some(), status.homed.is_some()), (fits, fits), "{deepest}");
            assert_eq!((status.protective_stop, reader.take_unfit().len()), (Some(true), if fits { 0 } else { 2 }));
        }
    };
    std::thread::Builder::new().stack_size(512 << 10).spawn(run).expect("there are threads").join().expect("it ends");
}

#[test]
fn a_key_that_comes_twice_in_a_value_of_any_shape_is_an_error() {
    for text in [r#"{"a": 1, "a": 2}"#, r#"[{"b": {"a": 1, "\u0061": 1}}]"#] {
        let mut value = Value::from("before");
        for read in [Value::decode(&mut Reader::new(text)).map(drop), value.decode_into(&mut Reader::new(text))] {
            assert!(read.is_err_and(|error| error.to_string().ends_with("the key appears twice")), "{text}");
        }
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
        format!(r#"{{"errorCode": "0", "new": NaN, "errorMsg": "\ud83d", {joints}}}"#),
        format!(r#"{{"errorCode": "0", "errorCode": 0, "errorMsg": "a", "errorMsg": "a", {joints}}}"#),
        format!(r#"{{"errorCode": 0, "errorCode": "2", {joints}}}"#),
        format!(r#"{{"errorCode": 0x10f0005, {joints}}}"#),
        r#"{"errorCode": "0", "joint_pos": [1, 2, 3, 4, 5, NaN]}"#.to_owned(),
        r#"{"errorCode": "0", "joint_pos": [1, 2, 3, 4, 5, 6}"#.to_owned(),
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
    let envelope = Envelope::read_odd(text);
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
