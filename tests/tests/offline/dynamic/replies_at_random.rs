//! Random replies, read by the model and by the generated code.

use jaka_dynamic::{Node, Reading};
use jaka_proto::messages::status::RobotStatus;
use jaka_proto::{Envelope, ErrorCode, Request, Visit, read_payload};
use jaka_spec::Command;
use jaka_tests::any_object;
use proptest::prelude::*;
use serde_json::Value;

use super::{SPEC, damaged, success};

/// A command of the spec, and a random reply to it.
fn any_reply() -> impl Strategy<Value = (&'static Command, Value)> {
    let commands: Vec<_> = SPEC.commands().filter(|command| !SPEC.reply_fields(command).is_empty()).collect();
    proptest::sample::select(commands).prop_flat_map(|command| {
        any_object(&SPEC, SPEC.reply_fields(command))
            .prop_map(move |reply| (command, success(&command.wire, reply.into())))
    })
}

/// True if the payload of a reply to the command decodes.
fn decodes(command: &Command, reply: &str) -> bool {
    struct Decodes<'t>(&'t str);

    impl Visit for Decodes<'_> {
        type Output = bool;

        fn visit<C: jaka_proto::Command>(self, _command: &C) -> bool {
            read_payload::<C::Reply>(C::INFO, self.0).is_ok()
        }
    }

    let mut examples = SPEC.command(&command.wire).into_iter().flat_map(|command| &command.examples);
    let request = examples.find_map(|example| example.request.as_deref());
    let request = Request::read(request.expect("each command has an example")).expect("the examples decode");
    request.visit(Decodes(reply))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(6000))]

    #[test]
    fn replies_are_unreadable_where_they_do_not_decode((command, reply) in any_reply().prop_flat_map(|(command, reply)| {
        damaged(reply).prop_map(move |reply| (command, reply))
    })) {
        let text = reply.to_string();
        let is_success = Envelope::read(&text).expect("JSON").code.is_ok_and(ErrorCode::is_success);
        let departures = Node::reply(&SPEC, command, reply).departures();
        let is_readable = departures.iter().all(|departure| departure.reading == Reading::Lenient);
        if is_success {
            prop_assert_eq!(is_readable, decodes(command, &text), "{:?} {}", departures, text);
        }
    }
}

proptest! {
    #[test]
    fn packets_are_unreadable_where_they_do_not_decode(packet in any_packet().prop_flat_map(damaged)) {
        let departures = Node::status(&SPEC, packet.clone()).departures();
        let is_readable = departures.iter().all(|departure| departure.reading == Reading::Lenient);
        let decoded = serde_json::from_value::<RobotStatus>(packet);
        prop_assert_eq!(is_readable, decoded.is_ok(), "{:?} {:?}", departures, decoded);
    }
}

/// A random status packet.
fn any_packet() -> impl Strategy<Value = Value> {
    any_object(&SPEC, SPEC.status_fields()).prop_map(Value::Object)
}

#[test]
fn samples_are_replies_without_departures() {
    for command in SPEC.commands() {
        let mut bare = command.clone();
        bare.examples.clear();
        for command in [command, &bare] {
            let reply = success(&command.wire, jaka_dynamic::sample_reply(&SPEC, command).into());
            assert_eq!(Node::reply(&SPEC, command, reply.clone()).departures(), []);
            assert!(decodes(command, &reply.to_string()), "{reply}");
        }
    }
}
