//! The JSON Schema against the messages of the document, against random messages, and against messages that are wrong.
//!
//! `cargo test --manifest-path tests/schema/Cargo.toml` is a step of `.ci/run`.

#![cfg(test)]

#[path = "../src/random_messages.rs"]
#[expect(unreachable_pub, reason = "it is public where it lives")]
mod random_messages;

use std::sync::LazyLock;

use jaka_proto::Request;
use jaka_proto::check::AdvisoryRanges;
use jaka_spec::tools::schema;
use jaka_spec::{Source, Spec, builtin, load, load_pack};
use jsonschema::Validator;
use proptest::prelude::*;
use proptest::strategy::ValueTree as _;
use serde_json::{Map, Value, json};

use self::random_messages::{any_object, any_request, any_request_of};

static SPEC: LazyLock<Spec> = LazyLock::new(|| builtin().expect("the built-in spec is correct"));
static SCHEMA: LazyLock<Value> = LazyLock::new(|| schema(&SPEC));
static MESSAGES: LazyLock<Validator> = LazyLock::new(|| validator(&SCHEMA));

fn validator(schema: &Value) -> Validator {
    jsonschema::draft202012::new(schema).unwrap_or_else(|error| panic!("the schema is not a schema: {error}"))
}

/// Validator of messages against one definition.
fn definition(name: &str) -> Validator {
    assert!(SCHEMA["$defs"][name].is_object(), "there is no definition {name}");
    validator(&json!({ "$ref": format!("#/$defs/{name}"), "$defs": SCHEMA["$defs"] }))
}

fn parse(text: &str) -> Value {
    serde_json::from_str(text).unwrap_or_else(|error| panic!("{error}: {text}"))
}

#[track_caller]
fn passes(validator: &Validator, message: &Value) {
    if let Err(error) = validator.validate(message) {
        panic!("{message}: {error}, at {}", error.instance_path());
    }
}

#[test]
fn it_is_a_schema_by_the_standard() {
    assert!(jsonschema::meta::is_valid(&SCHEMA));
}

#[test]
fn each_example_passes_as_what_it_is() {
    let (request, reply) = (definition("request"), definition("reply"));
    for example in SPEC.commands().flat_map(|command| &command.examples) {
        // The name in it allows no other command's definition to pass it.
        if let Some(message) = example.request.as_deref().map(parse) {
            passes(&request, &message);
            passes(&MESSAGES, &message);
            assert!(!reply.is_valid(&message), "a request is not a reply: {message}");
        }
        if let Some(message) = example.reply.as_deref().map(parse) {
            passes(&reply, &message);
            passes(&MESSAGES, &message);
            assert!(!request.is_valid(&message), "a reply is not a request: {message}");
        }
    }
}

#[test]
fn each_command_and_each_type_is_defined() {
    for command in SPEC.commands() {
        assert!(SCHEMA["$defs"][format!("request.{}", command.wire)].is_object(), "{}", command.wire);
        assert!(SCHEMA["$defs"][format!("reply.{}", command.wire)].is_object(), "{}", command.wire);
    }
    for (_, def) in SPEC.types() {
        assert!(SCHEMA["$defs"][format!("lenient.{}", def.name)].is_object(), "{}", def.name);
    }
}

#[test]
fn names_that_are_no_part_of_an_address_are_escaped() {
    let text = r#"
title = "Test"
[[command]]
wire = "get 50% of/it ~now?"
name = "get_half"
effect = "query"
doc = "Reads half of it."
"#;
    let spec = load(&[Source { path: "spec/test.toml", text }]).expect("the spec is correct");
    let messages = validator(&schema(&spec));
    passes(&messages, &json!({ "cmdName": "get 50% of/it ~now?" }));
    passes(&messages, &json!({ "cmdName": "get 50% of/it ~now?", "errorCode": "0" }));
    assert!(!messages.is_valid(&json!({ "cmdName": "get 50% of/it now", "errorCode": "0" })));
}

#[test]
fn nothing_is_a_message_of_an_empty_spec() {
    let spec = load(&[]).expect("it has nothing wrong");
    assert!(!validator(&schema(&spec)).is_valid(&json!({ "cmdName": "joint_move" })));
}

/// The example of `joint_move` with one key set, or removed where the value is null.
fn joint_move(key: &str, value: Value) -> Value {
    let command = SPEC.command("joint_move").expect("the spec has it");
    let mut message = parse(command.examples[0].request.as_deref().expect("the document prints it"));
    let object = message.as_object_mut().expect("it is an object");
    object.insert(key.to_owned(), value);
    object.retain(|_, value| !value.is_null());
    message
}

#[test]
fn wrong_requests_do_not_pass() {
    let wrong = [
        joint_move("cmdName", json!("joint_moves")),
        joint_move("cmdName", json!(null)),
        joint_move("speed", json!(null)),
        joint_move("speed", json!(-1)),
        joint_move("speed", json!("20")),
        joint_move("acceleration", json!(20)),
        joint_move("relFlag", json!(2)),
        joint_move("jointPosition", json!([0, 0, 0, 0, 0])),
        joint_move("jointPosition", json!([0, 0, 0, 0, 0, "0"])),
        json!({ "cmdName": "jog", "jog_mode": 4, "coord_map": 1, "jnum": 1 }),
        json!({ "cmdName": "jog", "jog_mode": 0, "coord_map": 1, "jnum": 6 }),
        json!({ "cmdName": "jog", "jog_mode": 0, "coord_map": 1, "jnum": 1, "jogvel": 30 }),
        json!({ "cmdName": "jog", "jog_mode": 1, "coord_map": 1, "jnum": 1 }),
        json!({ "cmdName": "end_move", "endPosition": [0, 0, 0, 0, 0, 0, 0], "speed": 1 }),
        json!({ "cmdName": "load_program", "programName": "程序" }),
        json!({ "cmdName": "set_digital_output", "type": 3, "index": 1, "value": 1 }),
        json!({ "cmdName": "get_joint_pos", "jointPosition": [] }),
        json!(["power_on"]),
    ];
    for message in wrong {
        assert!(!MESSAGES.is_valid(&message), "{message}");
    }
    passes(&MESSAGES, &joint_move("accel", json!(null)));
}

#[test]
fn replies_pass_in_every_form_that_is_read() {
    let state = definition("reply.get_robot_state");
    for message in [
        json!({ "errorCode": 0, "cmdName": " get_robot_state ", "enable": true, "power": "1" }),
        json!({ "errorCode": "0x0", "cmdName": "get_robot_state", "enable": " Robot_Enabled", "power": 0, "msg": null }),
        json!({ "errorCode": "0", "cmdName": "get_robot_state", "enable": "False", "power": "1.0", "errcode": [7], "new": {} }),
        json!({ "errorCode": "2", "errorMsg": "call get_robot_state failed", "cmdName": "get_robot_state" }),
        json!({ "errorCode": "-1" }),
        json!({ "errorCode": "0x10" }),
    ] {
        passes(&state, &message);
    }
    for message in [
        json!({ "errorCode": "0", "cmdName": "get_robot_state", "enable": true }),
        json!({ "errorCode": "0", "cmdName": "get_robot_state", "enable": true, "power": null }),
        json!({ "errorCode": "0", "cmdName": "get_robot_state", "enable": "on", "power": 1 }),
        json!({ "errorCode": "0", "cmdName": "get_version", "enable": true, "power": true }),
        json!({ "errorCode": "none" }),
        json!({ "cmdName": "get_robot_state", "enable": true, "power": true }),
    ] {
        assert!(!state.is_valid(&message), "{message}");
    }
}

#[test]
fn status_packets_pass_with_what_they_have() {
    let status = definition("status");
    passes(&status, &json!({}));
    passes(&status, &json!({ "len": "15", "inpos": "True", "rapidrate": "0.5", "task_state": 99, "unknown": [] }));
    for message in [json!([]), json!({ "len": "long" }), json!({ "joint_actual_position": [0, 0, 0] })] {
        assert!(!status.is_valid(&message), "{message}");
    }
}

/// True if the client, as it is configured by default, sends the request.
fn is_sent(message: &Value) -> bool {
    let request = Request::read(&message.to_string()).expect("it is made from the spec");
    request.check(AdvisoryRanges::Enforced).is_ok()
}

fn any_reply() -> impl Strategy<Value = (String, Map<String, Value>)> {
    let commands: Vec<_> = SPEC.commands().collect();
    proptest::sample::select(commands).prop_flat_map(|command| {
        any_object(&SPEC, SPEC.reply_fields(command)).prop_map(move |reply| (command.wire.clone(), reply))
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn a_request_passes_where_the_client_sends_it(message in any_request(&SPEC)) {
        prop_assert_eq!(MESSAGES.is_valid(&message), is_sent(&message), "{}", message);
    }

    #[test]
    fn random_replies_pass((command, mut reply) in any_reply()) {
        reply.insert("errorCode".to_owned(), "0".into());
        reply.insert("cmdName".to_owned(), command.into());
        let reply = Value::Object(reply);
        prop_assert!(MESSAGES.is_valid(&reply), "{}", reply);
    }
}

/// The built-in spec with a pack of all that is legal and strange.
static STRANGE: LazyLock<Spec> = LazyLock::new(|| {
    let source = Source { path: "strange.toml", text: include_str!("../pack-user/strange.toml") };
    load_pack(&SPEC, source).unwrap_or_else(|errors| panic!("{errors}")).spec
});

#[test]
fn what_may_be_sent_with_a_strange_pack_and_its_replies_pass() {
    let messages = validator(&schema(&STRANGE));
    let is_new = |command: &&jaka_spec::Command| SPEC.command(&command.name).is_none();
    let (mut commands, mut sent) = (0, 0);
    for command in STRANGE.commands().filter(is_new) {
        commands += 1;
        let mut runner = proptest::test_runner::TestRunner::deterministic();
        let requests = any_request_of(&STRANGE, command);
        let replies = any_object(&STRANGE, STRANGE.reply_fields(command));
        for _ in 0..100 {
            let request = requests.new_tree(&mut runner).expect("no value is left out").current();
            let mut fields = request.as_object().expect("a request is an object").clone();
            fields.remove("cmdName");
            if jaka_dynamic::request(&STRANGE, command, &fields, AdvisoryRanges::Enforced).is_ok() {
                sent += 1;
                passes(&messages, &request);
            }
            let mut reply = replies.new_tree(&mut runner).expect("no value is left out").current();
            for (key, value) in [("errorCode", "0"), ("errorMsg", ""), ("cmdName", command.wire.as_str())] {
                reply.insert(key.to_owned(), value.into());
            }
            passes(&messages, &reply.into());
        }
    }
    assert!(commands > 5 && sent > 100, "{commands} commands, of which {sent} requests may be sent");
}
