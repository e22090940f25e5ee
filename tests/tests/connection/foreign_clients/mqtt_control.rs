//! `nkawa/JAKA_Zu5s_MQTT_Control`, a Python client of a Zu 5s with firmware 1.5.14.
//!
//! It builds requests by concatenation, most of them with a blank behind the colon, and reads a reply by one `recv` of
//! 1024 bytes. Most replies go through `json.loads`; those of its control loop are searched for `"errorCode": "`, with
//! the blank. The repository has transcripts of four runs, and one status packet.

use std::fmt::Write as _;
use std::net::TcpStream;

use jaka_proto::framing::Framer;
use jaka_sim::Firmware;
use jaka_tests::{Arm, CYCLE, LONG};
use serde_json::{Map, Value};

use super::{Wire, next_frame, object};

/// Size of the client's one read of a reply.
const READ: usize = 1024;

/// What the client reads in a reply.
#[derive(Debug, Clone, Copy)]
enum Reads {
    /// The code alone, from the parsed reply.
    Code,
    /// The code alone, from the text.
    FastCode,
    /// `enable` and `power`, each compared with one word.
    State,
    /// A key of the parsed reply, as Python prints it.
    Key(&'static str),
    /// Six numbers behind a key and its bracket, from the text.
    Numbers(&'static str),
}

use Reads::{Code, FastCode, Key, Numbers, State};

/// A request, what the client reads in its reply, and the tuple that it prints.
type Row = (&'static str, Reads, &'static str);

const STATE: &str = r#"{"cmdName": "get_robot_state"}"#;
const IN_SERVO: &str = r#"{"cmdName":"is_in_servomove"}"#;
const SERVO_J: &str = r#"{"cmdName": "servo_j", "jointPosition": [0,0,0,0,0,0], "relFlag": 1, "stepNum": 1}"#;
const SERVO_ON: &str = r#"{"cmdName": "servo_move", "relFlag": 1}"#;
const TURN: &str =
    r#"{"cmdName": "joint_move", "relFlag": 1, "jointPosition": [0,0,0,0,0,10], "speed": 10, "accel": 10}"#;
const STAY: &str =
    r#"{"cmdName": "joint_move", "relFlag": 1, "jointPosition": [0,0,0,0,0,0], "speed": 10, "accel": 10}"#;
const TURN_BACK: &str =
    r#"{"cmdName": "joint_move", "relFlag": 0, "jointPosition": [JOINTS], "speed": 10, "accel": 10}"#;
const LINE: &str =
    r#"{"cmdName": "moveL", "relFlag": 1, "cartPosition": [10,0,0,0,0,0], "speed": 10, "accel": 10, "tol": 1}"#;
const NO_LINE: &str =
    r#"{"cmdName": "moveL", "relFlag": 1, "cartPosition": [0,0,0,0,0,0], "speed": 10, "accel": 10, "tol": 1}"#;
const LINE_BACK: &str =
    r#"{"cmdName": "moveL", "relFlag": 0, "cartPosition": [POSE], "speed": 10, "accel": 10, "tol": 1}"#;
const BACK: &str = r#"{"cmdName": "end_move", "endPosition": [POSE], "speed": 10, "accel": 10}"#;

const NO_SERVO: &str = r#"(-1, '{"errorCode": "-1", "errorMsg": "servoj command can only be excuted in servo move mode", "cmdName": "servo_j"}')"#;
const NO_TURN: &str = r#"(2, '{"errorCode": "2", "errorMsg": "call joint_move failed", "cmdName": "joint_move"}')"#;
const NO_END_MOVE: &str = r#"(2, '{"errorCode": "2", "errorMsg": "call end_move failed", "cmdName": "end_move"}')"#;
const NO_MOVE_L: &str = r#"(2, '{"errorCode": "2", "errorMsg": "call moveL failed", "cmdName": "moveL"}')"#;

/// The calls with which each run begins, of an arm without power.
const BEGIN: &[Row] = &[
    (STATE, State, "(0, 0, 0)"),
    (r#"{"cmdName": "get_version"}"#, Key("version"), "(0, '1.5.14_13_X64')"),
    (
        r#"{"cmdName": "emergency_stop_status"}"#,
        Key("emergency_stop"),
        r#"(1, '{"errorCode": "1", "errorMsg": "Exception:function call failed"}')"#,
    ),
    (r#"{"cmdName": "power_on"}"#, Code, "(0,)"),
    (STATE, State, "(0, 1, 0)"),
    (r#"{"cmdName": "enable_robot"}"#, Code, "(0,)"),
    (STATE, State, "(0, 1, 1)"),
    (r#"{"cmdName":"clear_error"}"#, Code, "(0,)"),
    (STATE, State, "(0, 1, 1)"),
    (r#"{"cmdName":"get_joint_pos"}"#, Numbers("joint_pos"), "(0, six numbers)"),
    (r#"{"cmdName":"get_tcp_pos"}"#, Numbers("tcp_pos"), "(0, six numbers)"),
];

/// The calls with which each run ends, whatever has failed.
const END: &[Row] = &[
    (r#"{"cmdName": "servo_move", "relFlag": 0}"#, Code, "(0,)"),
    (r#"{"cmdName": "disable_robot"}"#, Code, "(0,)"),
    (r#"{"cmdName": "power_off"}"#, Code, "(0,)"),
];

/// Servo mode of an arm that stands.
const SERVO_AT_REST: &[Row] = &[
    (IN_SERVO, Key("in_servomove"), "(0, False)"),
    (SERVO_J, FastCode, NO_SERVO),
    (SERVO_ON, Code, "(0,)"),
    (IN_SERVO, Key("in_servomove"), "(0, True)"),
    (SERVO_J, FastCode, "(0,)"),
];

/// Servo mode of an arm that moves: it is acknowledged, and not entered.
const SERVO_IN_MOTION: &[Row] = &[
    (IN_SERVO, Key("in_servomove"), "(0, False)"),
    (SERVO_J, FastCode, NO_SERVO),
    (SERVO_ON, Code, "(0,)"),
    (IN_SERVO, Key("in_servomove"), "(0, False)"),
    (SERVO_J, FastCode, NO_SERVO),
];

/// The client, and what it remembers.
struct Client<'a> {
    wire: Wire<'a>,
    /// The positions that were read last, as Python joins them with commas.
    joints: String,
    pose: String,
    /// The parameters of a run whose author passed the whole tuple in place of its list.
    with_tuples: bool,
}

impl<'a> Client<'a> {
    fn login(arm: &'a Arm) -> Self {
        let (joints, pose) = (String::new(), String::new());
        Self { wire: Wire::connect(arm), joints, pose, with_tuples: false }
    }

    /// Makes these calls one after the other, and compares what the client prints.
    #[track_caller]
    fn run(&mut self, rows: &[Row]) {
        for (bytes, reads, expected) in rows {
            assert_eq!(self.call(bytes, *reads), *expected, "{bytes}");
        }
    }

    fn call(&mut self, bytes: &str, reads: Reads) -> String {
        let bytes = bytes.replace("JOINTS", &self.joints).replace("POSE", &self.pose);
        let reply = self.wire.ask(&bytes, READ);
        // The way there and back takes longer on any network.
        self.wire.arm.advance(CYCLE);
        let parsed = object(&reply);
        let code = match reads {
            FastCode | Numbers(_) => fast_code(&reply),
            _ => code(parsed.as_ref().expect("`json.loads` takes the reply")),
        };
        if code != 0 {
            return format!("({code}, '{reply}')");
        }
        let member = |key: &str| parsed.as_ref().and_then(|parsed| parsed.get(key)).expect("it has the key");
        match reads {
            Code | FastCode => "(0,)".to_owned(),
            State => {
                let is = |key: &str, word: &str| u8::from(member(key) == word);
                format!("(0, {}, {})", is("power", "powered_on"), is("enable", "robot_enabled"))
            }
            Key(key) => format!("(0, {})", python(member(key))),
            Numbers(key) => self.numbers(&reply, key),
        }
    }

    fn numbers(&mut self, reply: &str, key: &str) -> String {
        let numbers = numbers(reply, key).map(|numbers| numbers.iter().map(|number| format!("{number:?}")).collect());
        let Some(numbers): Option<Vec<String>> = numbers else { return format!("(0, '{reply}')") };
        assert_eq!(numbers.len(), 6, "{reply}");
        let joined = if self.with_tuples { format!("0,[{}]", numbers.join(", ")) } else { numbers.join(",") };
        *(if key == "joint_pos" { &mut self.joints } else { &mut self.pose }) = joined;
        "(0, six numbers)".to_owned()
    }
}

/// The code of a parsed reply, by Python's `int`.
fn code(reply: &Map<String, Value>) -> i64 {
    let code = reply.get("errorCode").expect("it has a code");
    code.as_str().map_or_else(|| code.as_i64(), |code| code.trim().parse().ok()).expect("`int` takes it")
}

/// The code after `"errorCode": "` in a reply; -1 in another form.
fn fast_code(reply: &str) -> i64 {
    let found = reply.split_once(r#""errorCode": ""#).and_then(|(_, rest)| rest.split_once('"'));
    found.map_or(-1, |(code, _)| code.parse().expect("`int` takes it"))
}

/// The numbers that stand in a reply behind a key, a blank and a bracket.
fn numbers(reply: &str, key: &str) -> Option<Vec<f64>> {
    let (_, rest) = reply.split_once(&format!("\"{key}\": ["))?;
    let (list, _) = rest.split_once(']')?;
    list.split(',').map(|number| number.trim().parse().ok()).collect()
}

/// A value as Python prints it.
fn python(value: &Value) -> String {
    match value {
        Value::Bool(true) => "True".to_owned(),
        Value::Bool(false) => "False".to_owned(),
        Value::String(text) => format!("'{text}'"),
        other => other.to_string(),
    }
}

/// The client's arm at positions that a transcript has. Its first joint is further than half a turn from zero.
fn arm(firmware: Firmware) -> Arm {
    let at = [-261.539_269, 107.261_397, 76.208_493, 89.979_374, -93.315_612, -1.542_663];
    let arm = Arm::stepped().without_power().no_packets().at(at);
    arm.controller(|controller| controller.firmware(firmware)).start()
}

/// `nkawa/JAKA_Zu5s_MQTT_Control`, `src/check_jkrc.py` and `src/jaka_control/jkrc.py`: the run without motion, by its
/// first transcript.
#[test]
fn a_run_without_motion_prints_what_its_transcript_has() {
    let arm = arm(Firmware::V1_5_14);
    let mut client = Client::login(&arm);
    client.run(BEGIN);
    client.run(&[
        (IN_SERVO, Key("in_servomove"), "(0, False)"),
        (SERVO_ON, Code, "(0,)"),
        (IN_SERVO, Key("in_servomove"), "(0, True)"),
    ]);
    client.run(END);
    assert!(!arm.state().powered && !arm.state().enabled);
}

/// `nkawa/JAKA_Zu5s_MQTT_Control`, `src/check_jkrc.py` and `src/jaka_control/jkrc.py`: a run with motions of length 0,
/// by its transcript. Servo mode is entered at once, since nothing moves.
///
/// The three motions that were refused had a tuple in place of a list: `[0,[-263.4, 106.9, …]]` by the transcript's
/// remark that the joints were wrong. It shows no bytes.
#[test]
fn a_run_of_motions_without_length_prints_what_its_transcript_has() {
    let arm = arm(Firmware::V1_5_14);
    let mut client = Client { with_tuples: true, ..Client::login(&arm) };
    client.run(BEGIN);
    assert!(client.joints.starts_with("0,[-261.539269, 107.261397, "), "{}", client.joints);
    client.run(&[
        (TURN_BACK, Code, NO_TURN),
        (STAY, Code, "(0,)"),
        (BACK, Code, NO_END_MOVE),
        (LINE_BACK, Code, NO_MOVE_L),
        (NO_LINE, Code, "(0,)"),
    ]);
    client.run(SERVO_AT_REST);
    client.run(END);
}

/// `nkawa/JAKA_Zu5s_MQTT_Control`, `src/check_jkrc.py` and `src/jaka_control/jkrc.py`: a run by the transcript that its
/// author numbered 2. A motion is accepted after one that was refused, without `clear_error`; servo mode is not
/// entered, since the arm moves; and `disable_robot` is acknowledged although it does.
#[test]
fn a_run_with_refused_motions_prints_what_its_transcript_has() {
    let arm = arm(Firmware::V1_5_14);
    let mut client = Client { with_tuples: true, ..Client::login(&arm) };
    client.run(BEGIN);
    client.run(&[
        (TURN, Code, "(0,)"),
        (TURN_BACK, Code, NO_TURN),
        (LINE, Code, "(0,)"),
        (BACK, Code, NO_END_MOVE),
        (LINE, Code, "(0,)"),
        (LINE_BACK, Code, NO_MOVE_L),
    ]);
    client.run(SERVO_IN_MOTION);
    assert!(!arm.state().at_rest);
    client.run(END);
    assert!(arm.state().at_rest && !arm.state().enabled);
}

/// `nkawa/JAKA_Zu5s_MQTT_Control`, `src/check_jkrc.py` and `src/jaka_control/jkrc.py`: all 25 calls of the program in
/// its order, by the transcript that its author numbered 3, in which the arm has power from the start. The program
/// reads both positions twice, and prints them once.
///
/// The transcript does not show when its replies came, so the arm may have stood for a while: here each call takes one
/// cycle. As in the transcript it still moves when servo mode is asked for.
#[test]
fn the_25_calls_print_what_their_transcript_has() {
    let arm = arm(Firmware::V1_5_14);
    arm.set_state(|state| (state.powered, state.enabled) = (true, true));
    let mut client = Client::login(&arm);
    for (bytes, reads, expected) in BEGIN {
        let expected = if matches!(reads, State) { "(0, 1, 1)" } else { expected };
        assert_eq!(client.call(bytes, *reads), expected, "{bytes}");
    }
    let joints = (r#"{"cmdName":"get_joint_pos"}"#, Numbers("joint_pos"), "(0, six numbers)");
    let pose = (r#"{"cmdName":"get_tcp_pos"}"#, Numbers("tcp_pos"), "(0, six numbers)");
    client.run(&[joints, (TURN, Code, "(0,)"), (TURN_BACK, Code, "(0,)"), pose]);
    assert_eq!(client.joints, "-261.539269,107.261397,76.208493,89.979374,-93.315612,-1.542663");
    client.run(&[(LINE, Code, "(0,)"), (BACK, Code, "(0,)"), (LINE, Code, "(0,)"), (LINE_BACK, Code, "(0,)")]);
    client.run(SERVO_IN_MOTION);
    client.run(END);
    // Two of the calls are not printed.
    assert_eq!(arm.requests().len(), 25 + 2);
    assert!(arm.state().at_rest && !arm.state().powered);
}

/// `nkawa/JAKA_Zu5s_MQTT_Control`, `src/jaka_control/jkrc.py`: newer firmware says `"True"` where the client looks for
/// `robot_enabled` and `powered_on`, so that it takes an arm that is enabled for one without power.
#[test]
fn newer_firmware_is_taken_for_an_arm_without_power() {
    let arm = arm(Firmware::Newer);
    arm.set_state(|state| (state.powered, state.enabled) = (true, true));
    let mut client = Client::login(&arm);
    client.run(&[(STATE, State, "(0, 0, 0)"), (SERVO_ON, Code, "(0,)"), (SERVO_J, FastCode, "(0,)")]);
}

/// `nkawa/JAKA_Zu5s_MQTT_Control`, `src/jaka_control/jkrc.py`: the search of the control loop needs the blank behind
/// the colon, so that without blanks each success is a failure to it.
#[test]
fn a_reply_without_blanks_is_taken_for_a_failure() {
    let arm = arm(Firmware::Document);
    arm.set_state(|state| (state.powered, state.enabled) = (true, true));
    let mut client = Client::login(&arm);
    client.run(&[(STATE, State, "(0, 1, 1)"), (SERVO_ON, Code, "(0,)")]);
    client.run(&[(SERVO_J, FastCode, r#"(-1, '{"errorCode":"0","errorMsg":"","cmdName":"servo_j"}')"#)]);
    let printed = client.call(r#"{"cmdName":"get_joint_pos"}"#, Numbers("joint_pos"));
    assert!(printed.starts_with(r#"(-1, '{"errorCode":"0","#), "{printed}");
}

/// Keys of the recorded packet in their order, each with the shape of its value, where `[135 int]` is an array of 135
/// whole numbers, and the length of its text. Python's `json.dumps` of the record has 3208 bytes, as `len` says, so
/// that these are the lengths on the wire.
const RECORDED: &[(&str, &str, usize)] = &[
    ("len", "int", 4),
    ("drag_status", "bool", 5),
    ("errcode", "text", 5),
    ("errmsg", "text", 2),
    ("monitor_data", "[2 int, 3 float, [6 [11 float]]]", 649),
    ("torqsensor", "[[int, [text, int], [float, [3 float]]], [2 int, 2 [6 float]]]", 129),
    ("joint_actual_position", "[6 float]", 65),
    ("actual_position", "[6 float]", 67),
    ("din", "[135 int]", 405),
    ("dout", "[135 int]", 405),
    ("ain", "[64 float]", 320),
    ("aout", "[64 float]", 320),
    ("tio_din", "[8 int]", 24),
    ("tio_dout", "[8 int]", 24),
    ("tio_ain", "[2 float]", 14),
    ("task_state", "int", 1),
    ("homed", "[9 int]", 27),
    ("task_mode", "int", 1),
    ("interp_state", "int", 1),
    ("enabled", "bool", 5),
    ("paused", "bool", 5),
    ("rapidrate", "float", 3),
    ("current_tool_id", "int", 1),
    ("current_user_id", "int", 1),
    ("on_soft_limit", "int", 1),
    ("emergency_stop", "int", 1),
    ("drag_near_limit", "[6 int]", 18),
    ("funcdi", "[15 [2 int]]", 150),
    ("powered_on", "int", 1),
    ("inpos", "bool", 4),
    ("motion_mode", "int", 1),
    ("curr_tcp_trans_vel", "float", 3),
    ("protective_stop", "int", 1),
    ("point_key", "int", 1),
    ("netState", "int", 1),
];

/// The keys of that packet whose text is that of the recorded one.
const UNCHANGED: &[(&str, &str)] = &[
    ("drag_status", "false"),
    ("errcode", r#""0x0""#),
    ("errmsg", r#""""#),
    (
        "torqsensor",
        r#"[[0, ["192.168.2.100", 8080], [0.449, [0.0, 0.0, 20.0]]], [0, 0, [0.0, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0, 0.0, 0.0]]]"#,
    ),
    ("joint_actual_position", "[-263.40236, 106.90883, 75.54514, 89.82753, -93.42602, -13.40708]"),
    ("tio_ain", "[474.0, 474.0]"),
    ("task_state", "1"),
    ("homed", "[1, 1, 1, 1, 1, 1, 0, 0, 0]"),
    ("task_mode", "1"),
    ("interp_state", "0"),
    ("enabled", "false"),
    ("paused", "false"),
    ("rapidrate", "1.0"),
    ("current_tool_id", "0"),
    ("current_user_id", "1"),
    ("on_soft_limit", "0"),
    ("drag_near_limit", "[0, 0, 0, 0, 0, 0]"),
    ("powered_on", "0"),
    ("inpos", "true"),
    ("motion_mode", "1"),
    ("curr_tcp_trans_vel", "0.0"),
    ("point_key", "0"),
    ("netState", "1"),
];

/// `nkawa/JAKA_Zu5s_MQTT_Control`, `src/check_jkrc_feedback.py`: keys, order, lengths, nesting, number formats and
/// blanks of its packet, of an arm in the same state.
///
/// Numbers that the simulator takes from elsewhere have other lengths: measurements, which it has the same for each
/// joint, the pose, which follows from a tool and a user frame that the record does not show, and functions with an
/// input, which are those of the document.
#[test]
fn the_packet_is_as_the_recorded_one() {
    let arm = feedback_arm();
    let mut stream = TcpStream::connect(arm.status_addr()).expect("the controller listens");
    stream.set_read_timeout(Some(LONG)).expect("a timeout can be set");
    let packet = next_frame(&mut stream, &mut Framer::default());
    let packet = String::from_utf8(packet).expect("the controller sends UTF-8");
    let values = object(&packet).expect("`json.loads` takes it");
    assert_eq!(values.len(), RECORDED.len(), "{packet}");
    let mut rest = packet.as_str();
    let mut differs = Vec::new();
    for (index, (key, shape_of, length)) in RECORDED.iter().enumerate() {
        let begin = if index == 0 { "{" } else { ", " };
        rest = rest.strip_prefix(&format!("{begin}\"{key}\": ")).unwrap_or_else(|| panic!("`{key}` before {rest:.40}"));
        let text = spaced(&values[*key], &mut rest);
        assert_eq!(shape(&values[*key]), *shape_of, "{key}");
        if text.len() != *length {
            differs.push(*key);
        }
        let recorded = UNCHANGED.iter().find(|(unchanged, _)| unchanged == key);
        assert_eq!(text, recorded.map_or(text, |(_, text)| *text), "{key}");
    }
    assert_eq!(rest, "}");
    assert_eq!(values["len"], packet.len());
    assert_eq!(differs, ["monitor_data", "actual_position"]);
}

/// `nkawa/JAKA_Zu5s_MQTT_Control`, `src/jaka_control/jkrc_feedback.py`: packets end for it where the next one begins
/// with `{"len":`, so that it is one packet behind, and shows nothing before the second. It ignores `len`.
#[test]
fn packets_are_found_by_the_beginning_of_the_next_one() {
    let arm = feedback_arm();
    let mut stream = TcpStream::connect(arm.status_addr()).expect("the controller listens");
    stream.set_read_timeout(Some(LONG)).expect("a timeout can be set");
    let (mut framer, mut buffer) = (Framer::default(), Vec::new());
    let mut shown = Vec::new();
    for first_joint in [-263.0, -264.5, -266.0] {
        arm.set_state(|state| state.joint_position.0[0] = first_joint);
        arm.wait_until_accepted();
        arm.publish();
        // The packet that a reader gets on connecting comes before.
        loop {
            let packet = next_frame(&mut stream, &mut framer);
            buffer.extend_from_slice(&packet);
            let text = String::from_utf8_lossy(&packet);
            let values = object(&text).expect("it is JSON");
            if values["joint_actual_position"][0] == first_joint {
                break;
            }
        }
        // The client cuts off what comes before the second beginning.
        let mut text = String::from_utf8(std::mem::take(&mut buffer)).expect("the controller sends UTF-8");
        while let Some(end) = text[1..].find(r#"{"len":"#).map(|end| end + 1) {
            let unit = object(&text[..end]).expect("`json.loads` takes it");
            shown.push(unit["joint_actual_position"][0].as_f64().expect("it is a number"));
            text.drain(..end);
        }
        buffer = text.into_bytes();
        assert!(!shown.contains(&first_joint), "{shown:?}");
    }
    shown.dedup();
    assert!(shown.ends_with(&[-263.0, -264.5]), "{shown:?}");
}

/// An arm in the state of the recorded packet.
fn feedback_arm() -> Arm {
    let at = [-263.40236, 106.90883, 75.54514, 89.82753, -93.42602, -13.40708];
    let arm = Arm::stepped().without_power().no_packets().at(at);
    let arm = arm.controller(|controller| controller.firmware(Firmware::V1_5_14)).start();
    arm.set_state(|state| {
        state.user_frame_id = 1;
        state.torque_sensor.address = "192.168.2.100".into();
        state.torque_sensor.port = 8080;
        state.torque_sensor.payload.mass = 0.449;
        state.torque_sensor.payload.centroid = [0.0, 0.0, 20.0].into();
    });
    arm
}

/// The text of a value at the beginning of a message, with one blank behind each comma and colon.
fn spaced<'m>(value: &Value, rest: &mut &'m str) -> &'m str {
    let mut dumped = String::new();
    let mut in_text = false;
    for c in value.to_string().chars() {
        in_text ^= c == '"';
        dumped.push(c);
        if !in_text && matches!(c, ',' | ':') {
            dumped.push(' ');
        }
    }
    let (text, after) = rest.split_at_checked(dumped.len()).unwrap_or((rest, ""));
    assert_eq!(text, dumped);
    *rest = after;
    text
}

/// The shape of a value: scalars by their kind, where elements that follow one another alike are counted.
fn shape(value: &Value) -> String {
    let Value::Array(elements) = value else {
        return match value {
            Value::Bool(_) => "bool",
            Value::Number(number) if number.is_f64() => "float",
            Value::Number(_) => "int",
            Value::String(_) => "text",
            _ => panic!("no packet of this firmware has {value}"),
        }
        .to_owned();
    };
    let mut text = String::new();
    let shapes: Vec<_> = elements.iter().map(shape).collect();
    for run in shapes.chunk_by(|a, b| a == b) {
        let begin = if text.is_empty() { "" } else { ", " };
        let count = if run.len() == 1 { String::new() } else { format!("{} ", run.len()) };
        write!(text, "{begin}{count}{}", run[0]).expect("a text has room");
    }
    format!("[{text}]")
}
