//! Styles of replies.

use crate::common::{Peer, assert_unknown, json, request};
use jaka_proto::messages::power::{GetRobotState, GetRobotStateReply};
use jaka_proto::wire::{Value, Writer};
use jaka_proto::{Command, Envelope, ErrorCode, Request, Visit, read_payload, write_reply};
use jaka_sim::{
    CodeStyle, Controller, Delays, EventStyle, Firmware, KeyOrder, NumberStyle, ReplyStyle, Separators, TruthStyle,
};
use jaka_spec::{Effect, Requirement, Spec};

/// A controller whose time stands still, so that replies do not depend on how far a motion is.
fn start(firmware: Firmware) -> Controller {
    let builder = Controller::builder().delays(Delays::NONE).stepped_clock();
    builder.firmware(firmware).start().expect("loopback has ports")
}

fn styled(style: ReplyStyle) -> Controller {
    let builder = Controller::builder().delays(Delays::NONE).stepped_clock();
    builder.firmware(Firmware::Document).reply_style(style).start().expect("loopback has ports")
}

fn spec() -> Spec {
    jaka_spec::builtin().expect("the spec is correct")
}

/// One style for each choice, and some in which choices meet.
fn styles() -> Vec<ReplyStyle> {
    let document = ReplyStyle::of(Firmware::Document);
    let mut styles: Vec<_> = Firmware::ALL.iter().copied().map(ReplyStyle::of).collect();
    styles.extend([CodeStyle::Number, CodeStyle::Hexadecimal].map(|codes| document.error_code(codes)));
    let truths =
        [TruthStyle::Packet, TruthStyle::Literals, TruthStyle::Numbers, TruthStyle::NumberTexts, TruthStyle::Words];
    styles.extend(truths.map(|truths| document.truth_values(truths)));
    styles.extend(
        [NumberStyle::Fractions, NumberStyle::Texts, NumberStyle::Decimals(6)].map(|numbers| document.numbers(numbers)),
    );
    styles.push(document.separators(Separators::Spaced));
    styles.push(document.key_order(KeyOrder::Reversed));
    styles.push(document.without_success_message());
    styles.extend([EventStyle::Number, EventStyle::Text].map(|event| document.event(event)));
    let odd = document.error_code(CodeStyle::Number).truth_values(TruthStyle::Words).numbers(NumberStyle::Texts);
    styles.push(odd.separators(Separators::Spaced).key_order(KeyOrder::Reversed).without_success_message());
    styles
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

/// What a reply says, in whatever style it says it: its name, code and message, and its payload if it is accepted.
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
fn replies_mean_the_same_in_every_style() {
    let requests = requests(&spec());
    let plain = replies(&styled(ReplyStyle::of(Firmware::Document)), &requests);
    let accepted = plain.iter().filter(|reply| json(reply)["errorCode"] == "0").count();
    assert!(accepted * 10 > requests.len() * 8, "{accepted} of {}", requests.len());
    for style in styles() {
        let replies = replies(&styled(style), &requests);
        for (((text, _), plain), reply) in requests.iter().zip(&plain).zip(&replies) {
            let request = Request::read(text).expect("the example is a request");
            let mut said = meaning(&request, reply);
            if let (Request::GetRobotState(_), Some(payload)) = (&request, &mut said.3) {
                *payload = without_robot_error(payload);
            }
            let mut plain = meaning(&request, plain);
            for payload in [&mut said.3, &mut plain.3].into_iter().flatten() {
                *payload = rounded(&json(payload)).to_string();
            }
            assert_eq!(said, plain, "{style:?}: {reply}");
        }
    }
}

/// The value with six decimals, which a style may have at most.
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
fn replies_decode_for_every_firmware() {
    let requests = requests(&spec());
    for firmware in Firmware::ALL {
        let replies = replies(&start(*firmware), &requests);
        for ((text, _), reply) in requests.iter().zip(&replies) {
            let request = Request::read(text).expect("the example is a request");
            let (name, ..) = meaning(&request, reply);
            assert_eq!(name.as_deref(), Some(request.info().name), "{reply}");
        }
    }
}

/// The text of a reply to a bare command, in a style.
fn reply(style: ReplyStyle, command: &str) -> String {
    let controller = styled(style);
    let mut peer = Peer::commands(&controller);
    peer.send(request(command));
    peer.receive()
}

#[test]
fn replies_look_as_chosen() {
    let style = ReplyStyle::of(Firmware::Document);
    let literals = style.truth_values(TruthStyle::Literals);
    let words = style.truth_values(TruthStyle::Words);
    let digits = style.truth_values(TruthStyle::NumberTexts).key_order(KeyOrder::Reversed);
    let spaced = style.separators(Separators::Spaced).without_success_message();
    let state = r#""cmdName":"get_robot_state","enable""#;
    let fine = r#""errorCode":"0","errorMsg":"","#;
    let cases = [
        (style, "drag_status", format!(r#"{{{fine}"cmdName":"drag_status","drag_status":"False"}}"#)),
        (literals, "drag_status", format!(r#"{{{fine}"cmdName":"drag_status","drag_status":false}}"#)),
        (literals, "get_robot_state", format!(r#"{{{fine}{state}:false,"power":false}}"#)),
        (words, "get_robot_state", format!(r#"{{{fine}{state}:"False","power":"False"}}"#)),
        (
            digits,
            "drag_status",
            r#"{"drag_status":"0","cmdName":"drag_status","errorMsg":"","errorCode":"0"}"#.to_owned(),
        ),
        (
            spaced.numbers(NumberStyle::Texts),
            "get_clsn_sensitivity",
            r#"{"errorCode": "0", "cmdName": "get_clsn_sensitivity", "sensitivityLevel": "3"}"#.to_owned(),
        ),
        (
            style.numbers(NumberStyle::Fractions).error_code(CodeStyle::Hexadecimal),
            "get_clsn_sensitivity",
            r#"{"errorCode":"0x0","errorMsg":"","cmdName":"get_clsn_sensitivity","sensitivityLevel":3.0}"#.to_owned(),
        ),
    ];
    for (style, command, expected) in cases {
        assert_eq!(reply(style, command), expected);
    }
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
    let expected = format!(r#"{expected}"enable": false, "power": 1, "errcode": 17760261, "msg": "joint 1"}}"#);
    assert_eq!(peer.receive(), expected);
    assert_eq!(peer.call("drag_status")["drag_status"], false);
    assert_eq!(peer.call("protective_stop_status")["protective_stop"], 0);
    assert_eq!(peer.call("get_traj_sample_status")["sampleStatus"], 1);
}

#[test]
fn refusals_have_the_style_too() {
    let controller = start(Firmware::V1_5_14);
    let mut peer = Peer::commands(&controller);
    peer.send(request("enable_robot"));
    let refusal = r#"{"errorCode": "2", "errorMsg": "call enable_robot failed", "cmdName": "enable_robot"}"#;
    assert_eq!(peer.receive(), refusal);
    assert_unknown(&peer.ask("{'a'}"));

    let style = ReplyStyle::of(Firmware::Document).error_code(CodeStyle::Number).without_success_message();
    let controller = styled(style);
    let mut peer = Peer::commands(&controller);
    let reply = peer.call("fly");
    assert_eq!((&reply["errorCode"], &reply["errorMsg"]), (&json("1"), &"Exception:function call failed".into()));
    let servo = r#"{"cmdName":"servo_j","relFlag":1,"jointPosition":[0.5,0,0,0,0,-0.5],"stepNum":1}"#;
    assert_eq!(peer.ask(servo)["errorCode"], -1);
    assert_eq!(styled_code(CodeStyle::Hexadecimal, servo), "-1");
    assert_eq!(styled_code(CodeStyle::Hexadecimal, &request("enable_robot")), "0x2");
}

fn styled_code(codes: CodeStyle, request: &str) -> Value {
    let controller = styled(ReplyStyle::of(Firmware::Document).error_code(codes));
    Peer::commands(&controller).ask(request)["errorCode"].clone()
}

#[test]
fn a_literal_inside_a_string_stays_as_it_is() {
    let plain = json(&reply(ReplyStyle::of(Firmware::Document), "get_extio_status"));
    for style in styles() {
        let reply = json(&reply(style, "get_extio_status"));
        assert_eq!(reply["extio_status"], plain["extio_status"], "{style:?}");
    }
}
