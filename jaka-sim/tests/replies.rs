//! Replies and packets as each firmware writes them.

use crate::common::{Peer, assert_unknown, json, request};
use jaka_proto::messages::power::{GetRobotState, GetRobotStateReply};
use jaka_proto::wire::{Value, Writer};
use jaka_proto::{Command, Envelope, ErrorCode, Request, Visit, read_payload, write_reply};
use jaka_sim::{Controller, Delays, Firmware};
use jaka_spec::{Effect, Requirement, Spec};

/// A controller with a clock that stands still, so that replies do not depend on the progress of a motion.
fn start(firmware: Firmware) -> Controller {
    let builder = Controller::builder().delays(Delays::NONE).stepped_clock();
    builder.firmware(firmware).start().expect("loopback has ports")
}

fn spec() -> Spec {
    jaka_spec::builtin().expect("the spec is correct")
}

/// The payload of a reply, in the form in which jaka-proto writes it.
struct Payload<'r>(&'r str);

impl Visit for Payload<'_> {
    type Output = String;

    fn visit<C: Command>(self, _command: &C) -> String {
        let reply = read_payload::<C::Reply>(C::INFO, self.0).unwrap_or_else(|error| panic!("{error}: {}", self.0));
        let mut out = Writer::new();
        write_reply(C::INFO, &reply, &mut out);
        out.into_string()
    }
}

/// Contents of a reply, in whatever form: its name, code and message, and its payload if it is accepted.
fn meaning(request: &Request, reply: &str) -> (Option<String>, ErrorCode, String, Option<String>) {
    let envelope = Envelope::read(reply).unwrap_or_else(|error| panic!("{error}: {reply}"));
    let code = envelope.code.unwrap_or_else(|error| panic!("{error}: {reply}"));
    let payload = code.is_success().then(|| request.visit(Payload(reply)));
    (envelope.command.map(std::borrow::Cow::into_owned), code, envelope.message.into_owned(), payload)
}

/// Each example of the spec with what its command needs; queries first, so that no motion is under way then.
fn requests(spec: &Spec) -> Vec<(String, bool)> {
    let of = |query: bool| {
        let commands = spec.commands().filter(move |command| (command.effect == Effect::Query) == query);
        commands.flat_map(|command| {
            let servo_mode = command.requires.contains(&Requirement::ServoMode);
            command.examples.iter().filter_map(|e| e.request.clone()).map(move |text| (text, servo_mode))
        })
    };
    of(true).chain(of(false)).collect()
}

/// All replies of a controller to the spec's examples.
fn replies(controller: &Controller, requests: &[(String, bool)]) -> Vec<String> {
    let mut peer = Peer::commands(controller);
    let ask = |(text, servo_mode): &(String, bool)| {
        // No motion is left over, whose end `wait_complete` would wait for.
        controller.set_state(|state| state.powered = false);
        controller.set_state(|state| {
            state.powered = true;
            state.enabled = true;
            state.servo_mode = *servo_mode;
            // That of a firmware that knows all of them.
            "1.7.2".clone_into(&mut state.version);
        });
        peer.send(text);
        let reply = peer.receive();
        if Request::read(text).is_ok_and(|request| request.info().ends_session) {
            peer = Peer::commands(controller);
        }
        reply
    };
    requests.iter().map(ask).collect()
}

#[test]
fn replies_mean_the_same_for_every_firmware() {
    let requests = requests(&spec());
    let plain = replies(&start(Firmware::Document), &requests);
    let refused: Vec<_> = plain.iter().map(|reply| json(reply)).filter(|reply| reply["errorCode"] != "0").collect();
    // A file that has been renamed before.
    assert_eq!(refused.iter().map(|reply| reply["cmdName"].clone()).collect::<Vec<_>>(), ["remove_traj_file"]);
    for firmware in Firmware::ALL {
        let replies = replies(&start(*firmware), &requests);
        for (((text, _), plain), reply) in requests.iter().zip(&plain).zip(&replies) {
            let request = Request::read(text).expect("the example is a request");
            let mut said = meaning(&request, reply);
            assert_eq!(said.0.as_deref(), Some(request.info().name), "{reply}");
            // What is read of inputs differs in its length.
            if matches!(request, Request::GetDigitalInputStatus(_) | Request::GetFuncdiStatus(_) | Request::GetData(_))
            {
                continue;
            }
            if let (Request::GetRobotState(_), Some(payload)) = (&request, &mut said.3) {
                *payload = without_robot_error(payload);
            }
            let mut plain = meaning(&request, plain);
            for payload in [&mut said.3, &mut plain.3].into_iter().flatten() {
                *payload = rounded(&json(payload)).to_string();
            }
            assert_eq!(said, plain, "{firmware}: {reply}");
        }
    }
}

/// The value with six decimals, which firmware may have at most.
fn rounded(value: &Value) -> Value {
    match value {
        Value::Array(elements) => elements.iter().map(rounded).collect(),
        Value::Object(members) => members.iter().map(|(key, value)| (key.clone(), rounded(value))).collect(),
        Value::Number(number) => {
            number.as_f64().map_or_else(|| value.clone(), |number| ((number * 1e6).round() / 1e6).into())
        }
        _ => value.clone(),
    }
}

fn without_robot_error(payload: &str) -> String {
    let mut reply: GetRobotStateReply = read_payload(GetRobotState::INFO, payload).expect("the payload fits");
    (reply.error_code, reply.error_message) = (None, None);
    let mut out = Writer::new();
    write_reply(GetRobotState::INFO, &reply, &mut out);
    out.into_string()
}

#[test]
fn newer_firmware_answers_as_its_packets_do() {
    let controller = start(Firmware::Newer);
    controller.set_state(|state| {
        state.powered = true;
        state.error_code = "0x10f0005".to_owned();
        state.error_message = "joint 1".to_owned();
    });
    let mut peer = Peer::commands(&controller);
    peer.send(request("get_robot_state"));
    let expected = r#"{"errorCode": "0", "errorMsg": "", "cmdName": "get_robot_state", "#;
    let expected = format!(r#"{expected}"enable": "False", "power": "True", "errcode": 17760261, "msg": "joint 1"}}"#);
    assert_eq!(peer.receive(), expected);
    assert_eq!(peer.call("drag_status")["drag_status"], false);
    assert_eq!(peer.call("protective_stop_status")["protective_stop"], 0);
    assert_eq!(peer.call("get_traj_sample_status")["sampleStatus"], 1);
}

#[test]
fn refusals_are_written_so_too() {
    let controller = start(Firmware::V1_5_14);
    let mut peer = Peer::commands(&controller);
    peer.send(request("enable_robot"));
    let refusal = r#"{"errorCode": "2", "errorMsg": "call enable_robot failed", "cmdName": "enable_robot"}"#;
    assert_eq!(peer.receive(), refusal);
    assert_unknown(&peer.ask("{'a'}"));
}
