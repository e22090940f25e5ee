//! The prose pages of the protocol's reference: their session, their program and their packet are true of a controller.

use std::io::{BufReader, ErrorKind, Write};
use std::net::{SocketAddr, TcpStream};
use std::process::{Command, Output};
use std::time::Duration;

use jaka_proto::messages::status::RobotStatus;
use jaka_proto::wire::{Decode, Reader};
use jaka_proto::{Envelope, ErrorCode};
use jaka_sim::{Controller, Firmware};
use jaka_tests::{Arm, ArmBuilder, LONG, skipped, spec};
use serde_json::de::IoRead;
use serde_json::{Map, StreamDeserializer, Value};

const SESSION: &str = include_str!("../../../spec/reference/session.md");
const PROGRAMS: &str = include_str!("../../../spec/reference/programs.md");
const PACKET: &str = include_str!("../../../spec/reference/packet.md");
const EVENTS: &str = include_str!("../../../spec/reference/events.md");
const REFUSALS: &str = include_str!("../../../spec/reference/refusals.md");

/// Period of packets.
const PERIOD: Duration = Duration::from_millis(50);

#[test]
fn a_controller_answers_as_in_the_session() {
    let controller = controller(Arm::stepped());
    let mut status = messages(controller.status_addr()).1;
    controller.wait_until_accepted();
    let (mut commands, mut replies) = messages(controller.command_addr());
    let mut time = 0.0;
    let mut count = 0;
    for line in block(SESSION, "text").lines() {
        let step = Step::of(line);
        assert!(step.time >= time, "{line}");
        (time, count) = (step.time, count + 1);
        match (step.port, step.direction) {
            ("10001", ">") => commands.write_all(step.message.as_bytes()).expect("it is connected"),
            ("10001", _) => assert_same_reply(&step.object(), &next(&mut replies)),
            _ => wait_for_packet(&controller, &mut status, &step.object()),
        }
    }
    assert!(count > 25, "the page has a session");
}

/// A line of the session.
struct Step<'l> {
    time: f64,
    port: &'l str,
    direction: &'l str,
    message: &'l str,
}

impl<'l> Step<'l> {
    fn of(line: &'l str) -> Self {
        let (head, message) = line.split_at(line.find('{').expect("each line has a message"));
        let [time, port, direction] = head.split_whitespace().collect::<Vec<_>>()[..] else { panic!("{line}") };
        assert!(matches!((port, direction), ("10000", "<") | ("10001", "<" | ">")), "{line}");
        Self { time: time.parse().expect("a time in seconds"), port, direction, message }
    }

    fn object(&self) -> Map<String, Value> {
        serde_json::from_str(self.message).expect("the page's messages are JSON")
    }
}

/// Asserts equal keys, error code and refusal; numbers differ from arm to arm.
fn assert_same_reply(expected: &Map<String, Value>, found: &Map<String, Value>) {
    let keys = |reply: &Map<String, Value>| {
        let mut keys: Vec<_> = reply.keys().cloned().collect();
        keys.sort_unstable();
        keys
    };
    assert_eq!(keys(found), keys(expected), "{found:?}");
    for key in ["errorCode", "errorMsg", "cmdName"] {
        assert_eq!(found.get(key), expected.get(key), "{found:?}");
    }
}

/// Lets time pass until a packet has the values given.
fn wait_for_packet(controller: &Arm, status: &mut Messages, expected: &Map<String, Value>) {
    let end = controller.elapsed() + LONG;
    while !expected.iter().all({
        controller.advance(PERIOD);
        let packet = next(status);
        move |(key, value)| packet.get(key) == Some(value)
    }) {
        assert!(controller.elapsed() < end, "no packet has {expected:?}");
    }
}

#[test]
fn the_python_program_moves_the_arm() {
    let controller = controller(Arm::real_time());
    let Some(output) = python(&controller) else { return };
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).replace("\r\n", "\n");
    let (out, errors) = (text(&output.stdout), text(&output.stderr));
    assert!(output.status.success() && errors.is_empty(), "{out}{errors}");
    assert_eq!(out, "firmware 1.5.14_13_X64\njoint 6 from 0.0 to 5.0 deg\n");
    let names: Vec<_> = controller.requests().iter().map(|request| name(request)).collect();
    let expected = ["get_version", "power_on", "enable_robot", "get_joint_pos", "joint_move", "get_joint_pos", "quit"];
    assert_eq!(names, expected);
}

#[test]
fn the_python_program_ends_if_a_command_is_refused_or_the_arm_is_stopped() {
    let refusing = controller(Arm::real_time());
    refusing.set_state(|state| state.joint_position = [0.0, 90.0, 90.0, 90.0, -90.0, 100_000.0].into());
    let stopped = controller(Arm::real_time());
    stopped.collide();
    let moving = ["get_version", "power_on", "enable_robot", "get_joint_pos", "joint_move", "stop_program"];
    for (controller, told, sent) in [(refusing, "joint_move", &moving[..]), (stopped, "stopped", &moving[..2])] {
        let Some(output) = python(&controller) else { return };
        let errors = String::from_utf8_lossy(&output.stderr);
        assert!(!output.status.success() && errors.contains("RuntimeError") && errors.contains(told), "{errors}");
        assert!(controller.wait_for_requests(sent.len(), LONG));
        assert_eq!(controller.requests().iter().map(|request| name(request)).collect::<Vec<_>>(), sent);
    }
}

/// Output of the page's program for a controller's addresses; `None` if there is no Python.
fn python(controller: &Controller) -> Option<Output> {
    // A machine that is held up gets more than the half minute that the page's program waits.
    let program = block(PROGRAMS, "python").replace("timeout=30", "timeout=600").replace("() + 30", "() + 600");
    assert_eq!(program.matches("600").count(), 2, "{program}");
    let (commands, status) = (controller.command_addr(), controller.status_addr());
    let [host, commands, status] = [commands.ip().to_string(), commands.port().to_string(), status.port().to_string()];
    match Command::new("python3").args(["-c", &program, &host, &commands, &status]).output() {
        Ok(output) => Some(output),
        Err(error) if error.kind() == ErrorKind::NotFound => {
            skipped("the Python program of the reference", "there is no python3");
            None
        }
        Err(error) => panic!("python3: {error}"),
    }
}

#[test]
fn the_packet_is_as_long_as_it_says_and_every_key_of_it_is_understood() {
    let packet = block(PACKET, "json").lines().collect::<Vec<_>>().join(" ");
    let object: Map<String, Value> = serde_json::from_str(&packet).expect("it is JSON");
    assert_eq!(object["len"], packet.len());

    let mut reader = Reader::new(&packet);
    let status = RobotStatus::decode(&mut reader).expect("it can be read");
    assert!(reader.take_unfit().is_empty());
    assert_eq!((status.powered_on, status.enabled), (Some(true), Some(true)));
    let spec = spec();
    for key in object.keys() {
        assert!(spec.status_fields().iter().any(|field| field.wire == *key), "{key}");
    }

    let length = |key: &str| object[key].as_array().map(Vec::len);
    let lengths = ["din", "dout", "tio_ain", "funcdi", "monitor_data", "homed"].map(length);
    assert_eq!(lengths, [135, 135, 2, 15, 6, 9].map(Some));
    assert_eq!(object["monitor_data"][5].as_array().map(Vec::len), Some(6));
    for row in object["monitor_data"][5].as_array().into_iter().flatten() {
        assert_eq!(row.as_array().map(Vec::len), Some(11));
    }
}

#[test]
fn the_events_have_the_severity_of_the_spec() {
    let spec = spec();
    let mut count = 0;
    for line in EVENTS.lines().filter(|line| line.starts_with("| `0x") && !line.contains("....")) {
        let cells: Vec<_> = line.split('|').map(str::trim).collect();
        for code in cells[1].split('`').skip(1).step_by(2) {
            let number = u32::from_str_radix(&code[2..], 16).expect("a hexadecimal code");
            assert_eq!(spec.event(number).map(|event| event.severity.word()), Some(cells[2]), "{code}");
            count += 1;
        }
    }
    assert!(count > 25, "the page has a table");
}

#[test]
fn the_refusals_are_read_as_refusals() {
    let replies = REFUSALS.split('`').filter(|code| code.starts_with("{\"errorCode\""));
    let codes: Vec<_> = replies.map(|reply| Envelope::read(reply).expect("it is a reply").code).collect();
    let codes: Vec<_> = codes.into_iter().map(|code| code.expect("it has a code")).collect();
    assert_eq!(codes, [1, 2, 2, -1, 0].map(ErrorCode));
}

type Messages = StreamDeserializer<'static, IoRead<BufReader<TcpStream>>, Map<String, Value>>;

/// A connection to write to, and what comes from it.
fn messages(address: SocketAddr) -> (TcpStream, Messages) {
    let stream = TcpStream::connect(address).expect("the controller listens");
    stream.set_read_timeout(Some(LONG)).expect("a timeout can be set");
    let incoming = BufReader::new(stream.try_clone().expect("the system has handles"));
    (stream, serde_json::Deserializer::from_reader(incoming).into_iter())
}

fn next(messages: &mut Messages) -> Map<String, Value> {
    messages.next().expect("the connection is open").expect("objects come")
}

/// A controller of the firmware that the pages show, without power.
fn controller(arm: ArmBuilder) -> Arm {
    arm.without_power().status_period(PERIOD).controller(|controller| controller.firmware(Firmware::V1_5_14)).start()
}

/// The first block of code of a language.
fn block(page: &str, language: &str) -> String {
    let (_, rest) = page.split_once(&format!("```{language}\n")).expect("the page has such a block");
    rest.split("```").next().unwrap_or_default().to_owned()
}

fn name(request: &str) -> String {
    let request: Map<String, Value> = serde_json::from_str(request).expect("requests are JSON");
    request["cmdName"].as_str().expect("a name").to_owned()
}
