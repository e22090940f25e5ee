//! Values that firmware writes in different forms: the client sends and reads those of the controller's firmware. The
//! controllers here are plain sockets with bytes by hand, but for the last tests.

use std::io::{Read, Write};
use std::net::{Ipv4Addr, SocketAddr, TcpListener, TcpStream};
use std::sync::mpsc::{Receiver, channel};
use std::thread;

use jaka_dynamic::{AdvisoryRanges, Forms, Message, Translation};
use jaka_robot::jaka_sync::ErrorKind as Failure;
use jaka_robot::proto::wire::{Decode as _, Reader};
use jaka_robot::{Client, FirmwareVersion, StatusStream};
use jaka_sim::Firmware;
use jaka_spec::Source;
use jaka_tests::{Arm, LONG};
use proptest::prelude::*;
use serde_json::{Map, Value, json};

jaka_robot::pack!("data/forms.toml");

use forms::FormsCommands as _;

const OLD: FirmwareVersion = FirmwareVersion::new([1, 6, 5]);
const NEW: FirmwareVersion = FirmwareVersion::new([1, 7]);
const ANCIENT: FirmwareVersion = FirmwareVersion::new([1, 4, 2]);

/// A controller that answers each request with the next of these replies; the requests as they came.
fn answering(replies: &'static [&'static str]) -> (SocketAddr, Receiver<String>) {
    let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, 0)).expect("loopback has free ports");
    let address = listener.local_addr().expect("it is bound");
    let (sender, requests) = channel();
    thread::spawn(move || {
        let (mut stream, _) = listener.accept().expect("the client connects");
        for reply in replies {
            let _ = sender.send(message(&mut stream));
            stream.write_all(reply.as_bytes()).expect("the client reads");
        }
    });
    (address, requests)
}

/// The next object of a stream, none of whose texts has a brace.
fn message(stream: &mut TcpStream) -> String {
    let (mut text, mut open) = (Vec::new(), 0);
    while text.is_empty() || open > 0 {
        let mut byte = [0];
        stream.read_exact(&mut byte).expect("a message comes");
        open += i32::from(byte == *b"{") - i32::from(byte == *b"}");
        text.push(byte[0]);
    }
    String::from_utf8(text).expect("messages are text")
}

fn client(address: SocketAddr, firmware: Option<FirmwareVersion>) -> Client {
    let mut client = Client::connect(address).expect("it listens");
    client.set_firmware(firmware);
    client
}

fn centroid() -> forms::Centroid {
    [1.0, 2.0, 3.0].into()
}

const ACCEPTED: &str = r#"{"errorCode": "0", "errorMsg": "", "cmdName": "set_payload"}"#;

#[test]
fn a_request_with_forms_is_not_sent_before_the_firmware_is_known() {
    let (address, requests) = answering(&[ACCEPTED]);
    let mut robot = client(address, None);
    let error =
        robot.set_payload_forms(&forms::SetPayload::new(2.0, centroid())).expect_err("the firmware is not known");
    assert!(matches!(error.kind(), Failure::FirmwareUnknown { command: "set_payload" }), "{error:?}");
    assert!(!error.may_have_run());
    let text = "`set_payload` was not sent: its form depends on the firmware, which is not known; \
                call `check_firmware` first";
    assert_eq!(error.to_string(), text);
    robot.set_firmware(Some(OLD));
    robot.set_payload_forms(&forms::SetPayload::new(2.0, centroid())).expect("it is sent");
    let expected = r#"{"cmdName":"set_payload","mass":2,"centroid":[1,2,3]}"#;
    assert_eq!(requests.recv_timeout(LONG).as_deref(), Ok(expected), "the first that was sent");
}

#[test]
fn the_firmware_that_the_controller_names_decides_what_is_sent() {
    let (address, requests) = answering(&[
        r#"{"errorCode": "0", "errorMsg": "", "version": "1.7.3_01_X64", "cmdName": "get_version"}"#,
        ACCEPTED,
    ]);
    let mut robot = client(address, None);
    robot.check_firmware().expect("it names a version");
    robot.set_payload_forms(&forms::SetPayload::new(2.0, centroid())).expect("it is sent");
    assert_eq!(requests.recv_timeout(LONG).as_deref(), Ok(r#"{"cmdName":"get_version"}"#));
    let expected = r#"{"cmdName":"set_payload","weight":2,"centroid":{"x":1,"y":2,"z":3}}"#;
    assert_eq!(requests.recv_timeout(LONG).as_deref(), Ok(expected));
}

#[test]
fn a_reply_whose_forms_differ_in_json_is_read_by_what_comes() {
    let (address, _requests) = answering(&[
        r#"{"errorCode": "0", "centroid": [1, 2, 3], "mass": 4, "cmdName": "get_payload", "errorMsg": ""}"#,
        r#"{"errorCode": "0", "centroid": {"x": 1, "y": 2, "z": 3}, "weight": 4, "cmdName": "get_payload", "errorMsg": ""}"#,
        r#"{"errorCode": "0", "centroid": [1, 2, 3], "mass": 4, "weight": 5, "cmdName": "get_payload", "errorMsg": ""}"#,
        r#"{"errorCode": "0", "centroid": {"x": 1, "y": 2}, "mass": 4, "cmdName": "get_payload", "errorMsg": ""}"#,
    ]);
    let mut robot = client(address, None);
    for _ in 0..2 {
        let payload = robot.get_payload_forms().expect("it is read");
        assert_eq!((payload.mass, payload.centroid), (4.0, centroid()));
    }
    let error = robot.get_payload_forms().expect_err("which of the two keys counts is not known");
    assert!(source(&error).contains("field `mass`: the key appears twice"), "{error}");
    let error = robot.get_payload_forms().expect_err("a coordinate is missing");
    assert!(source(&error).contains("`centroid.z`"), "{error}");
}

#[test]
fn a_reply_whose_forms_are_alike_is_asked_for_only_once_the_firmware_is_known() {
    let (address, requests) = answering(&[
        r#"{"errorCode": "0", "joints": [90, 0, 0, 0, 0, 45], "cmdName": "demo_joints", "errorMsg": ""}"#,
        r#"{"errorCode": "0", "joints": [0.5, 0, 0, 0, 0, -1], "cmdName": "demo_joints", "errorMsg": ""}"#,
        r#"{"errorCode": "0", "hold": 1, "cmdName": "demo_tilt", "errorMsg": ""}"#,
        r#"{"errorCode": "0", "hold": 1, "cmdName": "demo_tilt", "errorMsg": ""}"#,
    ]);
    let mut robot = client(address, None);
    let error = robot.demo_joints().expect_err("the unit is not known");
    assert!(matches!(error.kind(), Failure::FirmwareUnknown { command: "demo_joints" }), "{error:?}");
    robot.set_firmware(Some(OLD));
    assert_eq!(robot.demo_joints().expect("it is read").joints, [90.0, 0.0, 0.0, 0.0, 0.0, 45.0].into());
    robot.set_firmware(Some(NEW));
    let joints = robot.demo_joints().expect("it is read").joints.0;
    assert!((joints[0] - 0.5_f64.to_degrees()).abs() < 1e-12 && (joints[5] + 1_f64.to_degrees()).abs() < 1e-12);
    let tilt = forms::DemoTilt::new(90.0).distances([1000.0, 2.5]);
    assert!(!robot.call(&tilt).expect("it is read").hold, "0 means held there");
    robot.set_firmware(Some(OLD));
    assert!(robot.call(&tilt).expect("it is read").hold);
    let sent: Vec<_> = requests.iter().skip(2).collect();
    assert_eq!(
        sent,
        [
            r#"{"cmdName":"demo_tilt","angle":1.5707963267948966,"bounds":"(1, 0.0025)"}"#,
            r#"{"cmdName":"demo_tilt","angle":90,"distances":[1000,2.5]}"#,
        ]
    );
}

#[test]
fn the_first_and_the_last_firmware_of_a_form_have_it() {
    let read = |text: &str| forms::Tilt::decode(&mut Reader::new(text)).expect("it is read");
    assert_eq!(read(r#"{"angle": 1, "turns": 2}"#), read("[1, 2]"));
    let written = |firmware| {
        let mut out = jaka_robot::proto::wire::Writer::for_firmware(Some(firmware));
        jaka_robot::proto::wire::Encode::encode(&read("[1, 2]"), &mut out);
        out.into_string()
    };
    for (firmware, expected) in [
        (ANCIENT, "[1,2]"),
        (FirmwareVersion::new([1, 4]), "[1,2]"),
        (FirmwareVersion::new([1, 5]), r#"{"angle":1,"turns":2}"#),
        (NEW, r#"{"angle":1,"turns":2}"#),
    ] {
        assert_eq!(written(firmware), expected, "{firmware}");
    }
}

fn source(error: &jaka_sync::Error) -> String {
    std::error::Error::source(error).map(ToString::to_string).unwrap_or_default()
}

/// A status port that sends these packets.
fn sending(packets: &'static [&'static str]) -> SocketAddr {
    let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, 0)).expect("loopback has free ports");
    let address = listener.local_addr().expect("it is bound");
    thread::spawn(move || {
        let (mut stream, _) = listener.accept().expect("the client connects");
        packets.iter().try_for_each(|packet| stream.write_all(packet.as_bytes())).expect("the client reads");
        let _ = stream.read(&mut [0]);
    });
    address
}

const PACKETS: &[&str] = &[
    r#"{"len": 1, "powered_on": 1, "curr_tcp_trans_vel": 2}"#,
    r#"{"len": 1, "power_state": "on", "curr_tcp_trans_vel": 2}"#,
    r#"{"len": 1, "power_state": "perhaps", "curr_tcp_trans_vel": 2}"#,
    r#"{"len": 1, "power_state": "on", "powered_on": 1}"#,
];

#[test]
fn keys_of_status_packets_are_read_by_what_comes_and_units_by_the_firmware() {
    let read = |firmware: Option<FirmwareVersion>| {
        let mut stream = StatusStream::connect(sending(PACKETS)).expect("it listens");
        stream.set_firmware(firmware);
        let next = |_| {
            let packet: forms::RobotStatus = stream.next_packet_as().expect("it is a packet");
            (packet.powered_on, packet.tcp_speed, stream.unfit().len())
        };
        (0..PACKETS.len()).map(next).collect::<Vec<_>>()
    };
    let (on, speed) = (Some(true), Some(2.0));
    assert_eq!(read(Some(OLD)), [(on, speed, 0), (on, speed, 0), (None, speed, 1), (None, None, 1)]);
    assert_eq!(read(Some(NEW))[0], (on, Some(2000.0), 0));
    // The unit of the speed is not known, and is not guessed.
    assert_eq!(read(None), [(on, None, 1), (on, None, 1), (None, None, 2), (None, None, 1)]);
}

fn spec() -> jaka_spec::Spec {
    let text = include_str!("../../data/forms.toml");
    let built_in = jaka_spec::builtin().expect("the built-in spec is correct");
    jaka_spec::load_pack(&built_in, Source { path: "forms.toml", text }).expect("the pack is correct").spec
}

proptest! {
    /// The generated code and the model at run time were written apart.
    #[test]
    fn generated_and_dynamic_code_write_and_read_the_same(
        angle in -90.0..90.0,
        distances in proptest::option::of(proptest::array::uniform2(-1e6..1e6)),
        mass in 0.0..100.0,
        at in proptest::array::uniform3(-1e4..1e4),
        firmware in prop_oneof![Just(OLD), Just(NEW), Just(ANCIENT)],
    ) {
        let (spec, mut out) = (spec(), jaka_robot::proto::wire::Writer::for_firmware(Some(firmware)));
        let forms = Forms::of(&spec, Some(firmware)).expect("it has some");
        let mut tilt = forms::DemoTilt::new(angle);
        tilt.distances = distances;
        jaka_robot::Command::write_request(&tilt, &mut out);
        let own = |name: &str, fields: Value| {
            let fields: Map<_, _> = fields.as_object().cloned().unwrap_or_default();
            let command = spec.command(name).expect("the spec has it");
            jaka_dynamic::request(&spec, command, &fields, AdvisoryRanges::Enforced).expect("it is allowed")
        };
        let fields = json!({"angle": angle, "distances": distances});
        let written = forms.request("demo_tilt", &own("demo_tilt", fields));
        prop_assert_eq!(written.as_deref(), Some(out.as_str()));
        let text = out.as_str().to_owned();
        let mut reader = Reader::of_firmware(&text, Some(firmware));
        let again: forms::DemoTilt = jaka_robot::proto::wire::Fields::read_fields(&mut reader).expect("it is read");
        prop_assert!((again.angle - angle).abs() < 1e-9);

        out.clear();
        jaka_robot::Command::write_request(&forms::SetPayload::new(mass, at), &mut out);
        let fields = json!({"mass": mass, "centroid": at});
        let written = forms.request("set_payload", &own("set_payload", fields));
        prop_assert_eq!(written.as_deref(), Some(out.as_str()));
    }
}

fn simulated(firmware: Firmware) -> Arm {
    let pack = concat!(env!("CARGO_MANIFEST_DIR"), "/data/forms.toml");
    Arm::real_time().controller(|controller| controller.firmware(firmware).pack(pack)).start()
}

/// Bytes of the simulator, seen by a plain socket, and read by the client.
#[test]
fn the_simulator_reads_and_writes_the_forms_of_its_firmware() {
    let old =
        [r#"{"cmdName":"set_payload","mass":2,"centroid":[1,2,3]}"#, r#""centroid":[1.0,2.0,3.0]"#, r#""mass":2"#];
    let new = [
        r#"{"cmdName":"set_payload","weight":2,"centroid":{"x":1,"y":2,"z":3}}"#,
        r#""centroid":{"x":1.0,"y":2.0,"z":3.0}"#,
        r#""weight":2"#,
    ];
    for (firmware, [set, at, mass], powered) in
        [(Firmware::V1_5_14, old, r#""powered_on":1"#), (Firmware::Newer, new, r#""power_state":"on""#)]
    {
        let arm = simulated(firmware);
        let mut plain = TcpStream::connect(arm.command_addr()).expect("it listens");
        plain.set_read_timeout(Some(LONG)).expect("the socket is open");
        let mut ask = |request: &str| {
            plain.write_all(request.as_bytes()).expect("it reads");
            message(&mut plain).replace(' ', "")
        };
        assert!(ask(set).contains(r#""errorCode":"0""#), "{firmware}");
        let other = if firmware == Firmware::Newer { old[0] } else { new[0] };
        assert!(!ask(other).contains(r#""errorCode":"0""#), "{firmware} has no such form");
        let reply = ask(r#"{"cmdName":"get_payload"}"#);
        assert!(reply.contains(at) && reply.contains(mass), "{firmware}: {reply}");
        let mut status = TcpStream::connect(arm.status_addr()).expect("it listens");
        status.set_read_timeout(Some(LONG)).expect("the socket is open");
        let packet = message(&mut status).replace(' ', "");
        assert!(packet.contains(powered), "{firmware}: {packet}");
        drop(plain);

        let mut robot = arm.client();
        robot.check_firmware().expect("it names its version");
        robot.set_payload_forms(&forms::SetPayload::new(3.5, [4.0, 5.0, 6.0])).expect("it is accepted");
        let payload = robot.get_payload_forms().expect("it is answered");
        assert_eq!((payload.mass, payload.centroid), (3.5, [4.0, 5.0, 6.0].into()));
        assert!((arm.state().payload.mass - 3.5).abs() < 1e-12);
    }
}

/// Another handle may say meanwhile that the firmware is not known: nothing goes out in a form of no firmware.
#[test]
fn a_request_and_its_check_go_by_one_look_at_the_firmware() {
    const ROUNDS: usize = 2000;
    let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, 0)).expect("loopback has free ports");
    let address = listener.local_addr().expect("it is bound");
    let server = thread::spawn(move || {
        let (mut stream, _) = listener.accept().expect("the client connects");
        let mut odd = Vec::new();
        // To the end of the connection.
        while stream.peek(&mut [0]).is_ok_and(|count| count > 0) {
            let request = message(&mut stream);
            odd.extend((!request.contains("weight")).then_some(request));
            stream.write_all(ACCEPTED.as_bytes()).expect("the client reads");
        }
        odd
    });
    let mut robot = client(address, Some(NEW));
    let mut other = robot.try_clone().expect("it is connected");
    let payload = forms::SetPayload::new(2.0, centroid());
    thread::scope(|scope| {
        let toggling = scope.spawn(move || {
            for round in 0..ROUNDS {
                other.set_firmware(Some(NEW).filter(|_| round % 2 == 1));
                thread::yield_now();
            }
        });
        while !toggling.is_finished() {
            match robot.set_payload_forms(&payload) {
                Ok(()) => {}
                Err(error) => assert!(matches!(error.kind(), Failure::FirmwareUnknown { .. }), "{error:?}"),
            }
        }
    });
    drop(robot);
    assert_eq!(server.join().expect("it does not panic"), Vec::<String>::new());
}

#[test]
fn of_an_unknown_firmware_nothing_is_guessed_from_other_keys() {
    let read = |packet: &Value, firmware| {
        let forms = Forms::of(&spec(), firmware).expect("it has some");
        forms.read(Message::Status, packet.as_object().expect("it is an object"))
    };
    // The key of the power shows firmware 1.7; the unit of the speed follows from the version alone.
    let packet = json!({"power_state": "on", "curr_tcp_trans_vel": 2.0});
    let unknown = read(&packet, None);
    assert_eq!(unknown.members.get("powered_on"), Some(&json!(1)));
    assert_eq!(unknown.members.get("curr_tcp_trans_vel"), None);
    assert_eq!(unknown.lost.iter().map(|lost| &*lost.name).collect::<Vec<_>>(), ["tcp_speed"]);
    let known = read(&packet, Some(NEW));
    assert_eq!(known.members.get("curr_tcp_trans_vel"), Some(&json!(2000.0)));
    // One field under two keys is none.
    let twice = read(&json!({"power_state": "on", "powered_on": 1}), Some(NEW));
    assert_eq!((twice.members.get("powered_on"), twice.lost.len()), (None, 1));
}

#[test]
fn a_reply_that_is_odd_or_in_another_form_is_not_shown_in_the_unit_of_the_spec() {
    let forms = Forms::of(&spec(), Some(NEW)).expect("it has some");
    let own = |text: &str| forms.own_text(Message::Reply("demo_joints"), text);
    assert!(own(r#"{"errorCode": "0", "joints": [0.5, 0, 0, 0, 0, 0]}"#).is_ok_and(|text| text.contains("28.6")));
    for odd in [
        "{\"errorCode\": \"0\", \"errorMsg\": \"a\tb\", \"joints\": [0.5, 0, 0, 0, 0, 0]} x",
        r#"{"errorCode": "0", "joints": [0.5, 0, 0, 0, 0, 0], "joints": [0.5, 0, 0, 0, 0, 0]}"#,
        r#"{"errorCode": "0", "joints": "none"}"#,
    ] {
        assert!(own(odd).is_err(), "{odd}");
    }
    // A tab in a text is odd, and does not hide what comes after it.
    let odd = "{\"errorMsg\": \"a\tb\", \"joints\": [0.5, 0, 0, 0, 0, 0]}";
    assert!(own(odd).is_ok_and(|text| text.contains("28.6")), "{odd}");
}

/// A pack gives enums other names; what is written alike stays, and a number stands for itself.
#[test]
fn enums_are_translated_by_name_and_else_as_they_are_written() {
    let pack = "title = 'T'\n[[override]]\ntarget = 'TaskState'\nvalue = 4\nname = 'Ready'\n\
                [[type]]\nname = 'Link'\nkind = 'enum'\ndoc = 'D.'\n\
                [[type.value]]\nwire = 0\nname = 'Down'\ndoc = 'D.'\n\
                [[override]]\ntarget = 'RobotStatus'\nfield = 'netState'\ntype = 'Link'\n";
    let built_in = jaka_spec::builtin().expect("the built-in spec is correct");
    let pack =
        jaka_spec::load_pack(&built_in, Source { path: "t.toml", text: pack }).expect("the pack is correct").spec;
    let packet = json!({"task_state": 4, "netState": 1});
    let translated =
        Translation::new(&built_in, &pack).message(Message::Status, packet.as_object().expect("it is one"));
    assert_eq!(Value::from(translated.members), packet);
    assert_eq!(Translation::new(&built_in, &pack).lost(Message::Status), Vec::<String>::new());
}
