//! Every drift that the field notes list decodes; what is no such drift is an error that names the field.

use jaka_proto::messages::collision::ProtectiveStopStatusReply;
use jaka_proto::messages::kinematics::{GetJointPos, GetJointPosReply};
use jaka_proto::messages::power::{GetRobotState, GetRobotStateReply, PowerOn};
use jaka_proto::messages::program::{GetProgramStateReply, ProgramState};
use jaka_proto::messages::status::RobotStatus;
use jaka_proto::wire::{Decode, DecodeError, Fields, Reader, Typed, Value, Writer};
use jaka_proto::{Command, Envelope, ErrorCode, read_payload};

fn read<R: Fields>(json: &str) -> Result<R, DecodeError> {
    R::read_fields(&mut Reader::new(json))
}

fn decode<T: Decode>(json: &str) -> Result<T, DecodeError> {
    T::decode(&mut Reader::new(json))
}

#[test]
fn truth_values_in_all_forms() {
    for (json, expected) in [
        ("true", true),
        ("false", false),
        ("1", true),
        ("0", false),
        ("1.0", true),
        ("\"1\"", true),
        ("\"0\"", false),
        ("\"True\"", true),
        ("\"False\"", false),
        ("\"true\"", true),
        ("\" False \"", false),
    ] {
        let reply = format!("{{\"protective_stop\": {json}}}");
        let stopped = read::<ProtectiveStopStatusReply>(&reply).expect(json).protective_stop;
        assert_eq!(stopped, expected, "{json}");
    }
    assert_eq!(decode::<[bool; 4]>(r#"[1, "False", true, "0"]"#), Ok([true, false, true, false]));
    for json in ["2", "\"yes\"", "\"\"", "[]", "{}", "-1", "0.5"] {
        let reply = format!("{{\"protective_stop\": {json}}}");
        let error = read::<ProtectiveStopStatusReply>(&reply).expect_err(json);
        assert_eq!(error.field(), "protective_stop");
        assert!(error.to_string().contains("expected a truth value"), "{error}");
    }
}

#[test]
fn robot_state_of_old_and_new_firmware() {
    let state = |json| {
        let GetRobotStateReply { enabled, powered_on, .. } = read(json).expect(json);
        (enabled, powered_on)
    };
    assert_eq!(state(r#"{"enable": "robot_disabled", "power": "powered_off"}"#), (false, false));
    assert_eq!(state(r#"{"enable": "robot_enabled", "power": "powered_on"}"#), (true, true));
    assert_eq!(state(r#"{"enable": true, "power": 1, "errcode": "0x0", "msg": ""}"#), (true, true));
    assert_eq!(state(r#"{"enable": "1", "power": 0}"#), (true, false));
    assert_eq!(state(r#"{"enable": 1, "power": true}"#), (true, true));
    let error = read::<GetRobotStateReply>(r#"{"enable": "robot_confused", "power": 1}"#).expect_err("no state");
    assert_eq!(error.to_string(), "field `enabled`: expected a truth value, found `\"robot_confused\"`");
}

#[test]
fn keys_with_a_blank_and_missing_messages() {
    let reply: <PowerOn as Command>::Reply =
        read_payload(PowerOn::INFO, r#"{"errorCode": "0", "power status": "True", "cmdName": "power_on"}"#)
            .expect("a real reply");
    assert_eq!(reply.powered_on, Some(true));
    let without: <PowerOn as Command>::Reply =
        read_payload(PowerOn::INFO, r#"{"errorCode": "0", "cmdName": "power_on"}"#).expect("the key may be absent");
    assert_eq!(without.powered_on, None);
}

#[test]
fn numbers_as_strings_and_whole_numbers_as_floats() {
    let joints = |json: &str| read::<GetJointPosReply>(&format!("{{\"joint_pos\": {json}}}"));
    let expected = [0.0, -90.5, 1e-7, 3.0, 40.0, 5.123_456_789_012_345];
    let reply = joints(r#"[0, "-90.5", 1e-7, 3.0, " 4e1 ", 5.123456789012345]"#).expect("all are numbers");
    assert_eq!(reply.joint_position, expected.into());
    for (json, message) in [
        ("[1,2,3,4,5]", "field `joint_position`: expected an array of 6, found `[1,2,3,4,5]`"),
        ("[1,2,3,4,5,6,7]", "field `joint_position`: expected an array of 6, found `[1,2,3,4,5,6,7]`"),
        ("[1,2,3,4,5,\"x\"]", "field `joint_position[5]`: expected a number, found `\"x\"`"),
        ("[1,2,3,4,5,\"nan\"]", "field `joint_position[5]`: expected a number, found `\"nan\"`"),
        ("[1,2,3,4,5,1e999]", "field `joint_position[5]`: expected a number, found `1e999`"),
        ("[1,2,3,4,5,null]", "field `joint_position[5]`: expected a number, found `null`"),
        ("null", "field `joint_position`: the key `joint_pos` is missing"),
        ("7", "field `joint_position`: expected an array, found `7`"),
    ] {
        assert_eq!(joints(json).expect_err(json).to_string(), message);
    }
    assert_eq!(decode::<i64>("5.0"), Ok(5));
    assert_eq!(decode::<i64>("\"-7\""), Ok(-7));
    assert_eq!(decode::<i64>("1e3"), Ok(1000));
    for json in [
        "9007199254740993.0",
        "\"9007199254740993.0\"",
        "1e-400",
        "4503599627370497.2",
        "0.99999999999999999999",
        "5.5",
    ] {
        assert!(decode::<i64>(json).is_err(), "{json}");
        assert!(decode::<bool>(json).is_err(), "{json}");
    }
    assert_eq!(decode::<i64>("9007199254740991.0"), Ok(9_007_199_254_740_991));
    assert_eq!(decode::<i64>("9007199254740993"), Ok(9_007_199_254_740_993));
    for json in ["[1e-400]", "0.99999999999999999999", "-1e-400"] {
        assert!(decode::<Value>(json).is_err(), "{json}");
    }
    for json in ["[0.0, -0.0, 1e3, 1.50, 1e300, 12345678901234567890]", "9007199254740993.0"] {
        assert!(decode::<Value>(json).is_ok(), "{json}");
    }
    assert!(decode::<i64>("1e300").is_err());
    assert!(decode::<i64>("true").is_err());
}

#[test]
fn white_space_of_any_kind_and_length() {
    let template = r#"~{~"joint_pos"~:~[~1~,~"2"~,~3~,~4~,~5~,~6.5~]~,~"new"~:~{~"a"~:~[~]~,~"b"~:~null~}~}~"#;
    for blank in ["", " ", "  ", "\n", "\t", "\r\n  ", " \n", " \t "] {
        let text = template.replace('~', blank);
        let reply: GetJointPosReply = read_payload(GetJointPos::INFO, &text).expect("JSON allows it");
        assert_eq!(reply.joint_position, [1.0, 2.0, 3.0, 4.0, 5.0, 6.5].into(), "{blank:?}");
        assert!(Envelope::read(&text).is_ok(), "{blank:?}");
    }
    for no_blank in ["\u{1}", "\u{b}", "\u{a0}", " \u{1}"] {
        assert!(read::<GetJointPosReply>(&template.replace('~', no_blank)).is_err(), "{no_blank:?}");
    }
}

#[test]
fn floats_read_back_as_they_were_sent() {
    for value in [0.1, 1.0 / 3.0, 89.999_999_999_999_99, -179.123_456_789_012_3, f64::MIN_POSITIVE, f64::MAX, -0.0] {
        let mut out = Writer::new();
        out.float(value);
        let read: f64 = decode(out.as_str()).expect("a float is a number");
        assert_eq!(read.to_bits(), value.to_bits(), "{}", out.as_str());
    }
}

#[test]
fn success_and_refusal_in_all_forms() {
    for (json, code) in [
        ("\"0\"", 0),
        ("0", 0),
        ("\"0x0\"", 0),
        ("0.0", 0),
        ("\"-1\"", -1),
        ("-1", -1),
        ("\"2\"", 2),
        ("3", 3),
        ("\"0x10f0005\"", 0x10f_0005),
        ("\" 1 \"", 1),
    ] {
        let reply = format!("{{\"errorCode\": {json}, \"cmdName\": \"jog\"}}");
        assert_eq!(Envelope::read(&reply).expect("the reply is JSON").code, Ok(ErrorCode(code)), "{json}");
    }
    let unclear = Envelope::read(r#"{"errorCode": "fine", "cmdName": "jog"}"#).expect("the reply is JSON");
    assert!(unclear.refusal().is_none());
    assert_eq!(
        unclear.code.expect_err("no number").to_string(),
        "field `error_code`: expected a whole number, found `\"fine\"`"
    );
    let absent = Envelope::read(r#"{"cmdName": "jog"}"#).expect("the reply is JSON");
    assert_eq!(absent.code.expect_err("no code").to_string(), "field `error_code`: the key `errorCode` is missing");
}

#[test]
fn a_refusal_is_read_whatever_else_the_reply_holds() {
    let refused = r#"{"errorMsg": "call get_joint_pos failed", "joint_pos": "?", "errorCode": "2", "cmdName": " x "}"#;
    let refusal = Envelope::read(refused).expect("the reply is JSON").refusal().expect("it is a refusal");
    assert_eq!((refusal.command.as_str(), refusal.code), ("x", ErrorCode(2)));
    assert_eq!(refusal.message, "call get_joint_pos failed");
}

#[test]
fn unknown_keys_unknown_enum_values_and_any_array_length() {
    let state = read::<GetProgramStateReply>(r#"{"new": {"deep": [1, {"er": null}]}, "programState": "jogging"}"#);
    assert_eq!(state.expect("it decodes").program_state, ProgramState::Other("jogging".to_owned()));
    for len in [0, 64, 135, 136, 144, 200] {
        let packet = format!("{{\"len\": 1, \"din\": [{}]}}", vec!["0"; len].join(","));
        let status: RobotStatus = read(&packet).expect("any length decodes");
        assert_eq!(status.digital_inputs.expect("the key is there").len(), len);
    }
}

#[test]
fn nothing_is_invented_for_an_absent_key() {
    let status: RobotStatus = read("{}").expect("any key may be absent");
    assert_eq!(status, RobotStatus::default());
    assert!(status.joint_actual_position.is_none() && status.enabled.is_none() && status.digital_inputs.is_none());
}

#[test]
fn a_nested_value_of_another_shape_is_kept() {
    let status: RobotStatus = read(r#"{"torqsensor": [[0,0,0],[1]], "enabled": true}"#).expect("the packet decodes");
    assert_eq!(status.enabled, Some(true));
    let raw: Value = serde_json::from_str("[[0,0,0],[1]]").expect("it is JSON");
    assert_eq!(status.torque_sensor, Some(Typed::Raw(raw)));
}

#[test]
fn a_value_that_may_be_raw_is_written_in_its_own_form() {
    let packet = r#"{"homed":[0,1,1],"enabled":true}"#;
    let status: RobotStatus = read(packet).expect("the packet decodes");
    assert_eq!(status.homed, Some(Typed::Known(vec![false, true, true])));
    assert_eq!(serde_json::to_string(&status).expect("it serialises"), r#"{"enabled":true,"homed":[0,1,1]}"#);
}

#[test]
fn text_that_is_not_json_is_distinguished_from_json_of_another_shape() {
    for json in ["", "{", "{\"a\"}", "{\"a\":}", "{\"a\":1,}", "{\"a\":01x}", "{a:1}", "{\"a\":tru}", "{\"a\":\"\\x\"}"]
    {
        assert!(Envelope::read(json).is_err_and(|error| error.is_malformed()), "{json}");
    }
    assert!(Envelope::read("{} {}").is_err_and(|error| error.is_malformed()));
    assert!(read::<GetJointPosReply>("{}").is_err_and(|error| !error.is_malformed()));
    let deep = format!("{{\"a\":{}1{}}}", "[".repeat(100_000), "]".repeat(100_000));
    assert!(Envelope::read(&deep).is_err_and(|error| error.is_malformed()));
}

#[test]
fn a_key_that_appears_twice_is_an_error() {
    let twice = r#"{"joint_pos": [0,0,0,0,0,0], "joint_pos": [1,1,1,1,1,1]}"#;
    let error = read::<GetJointPosReply>(twice).expect_err("which one is meant?");
    assert_eq!(error.to_string(), "field `joint_position`: the key appears twice");
}

#[test]
fn strings_with_escapes_and_bare_control_characters() {
    let text = |json: &str| decode::<String>(json);
    assert_eq!(text(r#""a\"b\\c\n\u4e2d\ud83d\ude00""#).as_deref(), Ok("a\"b\\c\n中😀"));
    assert_eq!(text("\"a\nb\\t\u{1}\"").as_deref(), Ok("a\nb\t\u{1}"));
    assert!(text(r#""\ud800""#).is_err());
    assert!(text("\"abc").is_err());
    assert!(text("\"abc\\").is_err());
}

#[test]
fn serde_sees_the_json_of_the_wire() {
    let state = GetRobotState::new();
    assert_eq!(serde_json::to_string(&state).expect("it serialises"), "{}");
    let reply: GetJointPosReply = serde_json::from_str(r#"{"joint_pos": [1, 2, 3, 4, 5, 6]}"#).expect("it decodes");
    assert_eq!(serde_json::to_string(&reply).expect("it serialises"), r#"{"joint_pos":[1,2,3,4,5,6]}"#);
    let error = serde_json::from_str::<GetJointPosReply>("{}").expect_err("the field is missing");
    assert!(error.to_string().contains("`joint_pos` is missing"), "{error}");
}

#[test]
fn commas_stand_between_elements_and_nowhere_else() {
    let texts = vec!["a".to_owned(), "b".to_owned()];
    for json in [r#"["a","b"]"#, r#"["a", "b"]"#, r#"["a",  "b" ]"#, r#"["a" , "b"]"#, "[ \"a\" ,\t\"b\"\n]"] {
        assert_eq!(decode::<Vec<String>>(json), Ok(texts.clone()), "{json}");
    }
    for json in ["[,1]", "[, 1]", "[1,]", "[1, ]", "[1,,2]", "[1,\t,2]", "[1 2]", "[1", "[1,", "[1, "] {
        assert!(decode::<Vec<i64>>(json).is_err_and(|error| error.is_malformed()), "{json}");
        let json = json.replace('1', "\"1\"").replace('2', "\"2\"");
        assert!(decode::<Vec<String>>(&json).is_err_and(|error| error.is_malformed()), "{json}");
        assert!(Reader::new(&json).skip().is_err_and(|error| error.is_malformed()), "{json}");
    }
    for json in ["[1,]", "[1, ]", "[1,  ]", "[1,\n]", "[1, \n]", "[\"1\",]", "[\"1\", ]"] {
        let error = Reader::new(json).skip().expect_err(json).to_string();
        assert!(error.contains("a value after the comma"), "{json}: {error}");
    }
    for inside in [r#","a":1"#, r#", "a":1"#, r#""a":1,"#, r#""a":1, "#, r#""a":1,,"b":2"#, r#""a":1 "b":2"#] {
        let json = format!("{{{inside}}}");
        assert!(Reader::new(&json).skip().is_err_and(|error| error.is_malformed()), "{json}");
        assert!(read::<GetJointPosReply>(&json).is_err_and(|error| error.is_malformed()), "{json}");
    }
}

#[test]
fn arrays_of_any_type_have_their_length() {
    assert_eq!(decode::<[String; 2]>("[\"a\", \"b\"]"), Ok(["a".to_owned(), "b".to_owned()]));
    assert_eq!(decode::<Vec<i64>>("[7, \"-8\", 9.0]"), Ok(vec![7, -8, 9]));
    assert_eq!(decode::<[[i64; 1]; 2]>("[[1], [2]]"), Ok([[1], [2]]));
    let error = |json| decode::<[String; 2]>(json).expect_err(json).to_string();
    assert_eq!(error("[\"a\"]"), "expected an array of 2, found `[\"a\"]`");
    assert_eq!(error("[\"a\", 1]"), "field `[1]`: expected a string, found `1`");
    assert_eq!(decode::<[f64; 2]>("[1]").expect_err("too short").to_string(), "expected an array of 2, found `[1]`");
}

#[test]
fn a_truth_value_the_wrong_way_round() {
    for (json, expected) in [("0", true), ("1.0", false), ("\"1\"", false), ("\"0.0\"", true), ("true", true)] {
        let mut slot = None;
        Reader::new(json).field_word("flag", &mut slot, "1", "0").expect(json);
        assert_eq!(slot, Some(expected), "{json}");
    }
}
