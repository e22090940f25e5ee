//! A pack of all that is legal and strange: generated code, the model and the simulator see it alike.

use std::path::PathBuf;
use std::sync::LazyLock;

use expect_test::expect;
use jaka_dynamic::{Node, Reading};
use jaka_pack_user::strange::{self, StrangeCommands as _};
use jaka_proto::check::{AdvisoryRanges, NotSent};
use jaka_proto::wire::{Reader, Writer};
use jaka_proto::{Command, CommandInfo, EventNote, read_payload};
use jaka_spec::{Source, Spec};
use jaka_sync::{Client, Severity};
use jaka_tests::{Arm, any_object, any_request_of, same, spec};
use proptest::prelude::*;
use proptest::test_runner::TestRunner;
use serde_json::{Map, Value};

/// The built-in spec with the pack.
static SPEC: LazyLock<Spec> = LazyLock::new(|| {
    let source = Source { path: "strange.toml", text: include_str!("../../pack-user/strange.toml") };
    jaka_spec::load_pack(&spec(), source).unwrap_or_else(|errors| panic!("{errors}")).spec
});

/// A command of the pack's module, whatever its type.
struct Generated {
    info: &'static CommandInfo,
    /// Reads a request and writes it, if it may be sent.
    request: fn(&str) -> Result<String, NotSent>,
    /// Reads a reply and writes it; nothing if it cannot be read.
    reply: fn(&str) -> Option<String>,
    /// Sends a request to a simulated controller, and takes its reply.
    call: fn(&mut Client, &str) -> Result<(), jaka_sync::Error>,
}

fn read<C: Command>(text: &str) -> C {
    C::read_fields(&mut Reader::new(text)).unwrap_or_else(|error| panic!("{text}: {error}"))
}

fn request<C: Command>(text: &str) -> Result<String, NotSent> {
    let request = read::<C>(text);
    let mut out = Writer::new();
    request.check(AdvisoryRanges::Enforced)?;
    request.write_request(&mut out);
    Ok(out.into_string())
}

fn reply<C: Command>(text: &str) -> Option<String> {
    let reply = read_payload::<C::Reply>(C::INFO, text).ok()?;
    let mut out = Writer::new();
    jaka_proto::write_reply(C::INFO, &reply, &mut out);
    Some(out.into_string())
}

fn generated<C: Command>() -> Generated {
    let call = |client: &mut Client, text: &str| client.call(&read::<C>(text)).map(drop);
    Generated { info: C::INFO, request: request::<C>, reply: reply::<C>, call }
}

fn commands() -> Vec<Generated> {
    vec![
        generated::<strange::EveryKind>(),
        generated::<strange::Item>(),
        generated::<strange::Visitor>(),
        generated::<strange::Connect>(),
        generated::<strange::New>(),
        generated::<strange::Meaning>(),
        generated::<strange::Choose>(),
        generated::<strange::Jog>(),
        generated::<strange::PowerOn>(),
        generated::<strange::SetRapidRate>(),
        generated::<strange::JointMove>(),
        generated::<strange::ServoJ>(),
        generated::<strange::GetProgramState>(),
        generated::<strange::LoadProgram>(),
    ]
}

fn model(info: &CommandInfo) -> &'static jaka_spec::Command {
    SPEC.command(info.name).unwrap_or_else(|| panic!("{} is in the pack", info.name))
}

fn by_model(info: &CommandInfo, message: &Value) -> Result<String, Vec<jaka_dynamic::Problem>> {
    let mut fields = message.as_object().expect("a request is an object").clone();
    fields.remove("cmdName");
    jaka_dynamic::request(&SPEC, model(info), &fields, AdvisoryRanges::Enforced)
}

#[test]
fn requests_are_those_of_the_model_and_what_it_refuses_is_refused() {
    for Generated { info, request, .. } in commands() {
        let mut runner = TestRunner::new(ProptestConfig::with_cases(100));
        let same_as_model = |message: Value| {
            let sent = request(&message.to_string());
            match (sent, by_model(info, &message)) {
                (Ok(written), by_model) => {
                    let json: Value = serde_json::from_str(&written).expect("a request is JSON");
                    prop_assert!(same(&json, &message), "{json} for {message}");
                    prop_assert_eq!(by_model, Ok(written));
                }
                (Err(error), by_model) => prop_assert!(by_model.is_err(), "{error}, but {by_model:?}"),
            }
            Ok(())
        };
        runner.run(&any_request(info), same_as_model).unwrap_or_else(|error| panic!("{error}"));
    }
}

/// Random requests. Of those with many fields, one or two are random: a request is seldom right throughout by chance.
fn any_request(info: &'static CommandInfo) -> BoxedStrategy<Value> {
    let random = any_request_of(&SPEC, model(info));
    if info != strange::EveryKind::INFO {
        return random;
    }
    let right: Map<String, Value> = serde_json::from_str(EVERY_KIND).expect("it is JSON");
    let keys = proptest::collection::vec(any::<prop::sample::Index>(), 1..3);
    let with_random = move |(random, keys): (Value, Vec<prop::sample::Index>)| {
        let mut message = right.clone();
        for key in keys {
            let (key, value) = message.iter_mut().nth(key.index(right.len())).expect("the index is below");
            // The model passes Python on unread.
            if key != "python" {
                *value = random[key].clone();
            }
        }
        message.into()
    };
    (random, keys).prop_map(with_random).boxed()
}

/// A reply to an accepted command.
fn success(info: &CommandInfo, mut fields: Map<String, Value>) -> Value {
    fields.insert("errorCode".to_owned(), "0".into());
    fields.insert("errorMsg".to_owned(), "".into());
    fields.insert("cmdName".to_owned(), info.name.into());
    fields.into()
}

#[test]
fn replies_are_read_and_written_again() {
    for Generated { info, reply, .. } in commands() {
        let mut runner = TestRunner::new(ProptestConfig::with_cases(100));
        let round_trip = |fields: Map<String, Value>| {
            let message = success(info, fields);
            let departures = Node::reply(&SPEC, model(info), message.clone()).departures();
            let is_readable = departures.iter().all(|departure| departure.reading == Reading::Lenient);
            prop_assert!(is_readable, "{departures:?}");
            let written = reply(&message.to_string());
            let again: Option<Value> = written.as_deref().map(|text| serde_json::from_str(text).expect("it is JSON"));
            prop_assert!(again.as_ref().is_some_and(|again| same(again, &message)), "{message} became {again:?}");
            Ok(())
        };
        let replies = any_object(&SPEC, SPEC.reply_fields(model(info)));
        runner.run(&replies, round_trip).unwrap_or_else(|error| panic!("{error}"));
    }
}

fn arm() -> Arm {
    let pack = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("pack-user/strange.toml");
    Arm::simulated().without_power().controller(|controller| controller.pack(pack)).start()
}

#[test]
fn the_simulator_takes_what_may_be_sent_and_its_replies_are_read() {
    let arm = arm();
    let is_new = |info: &CommandInfo| spec().command(info.name).is_none();
    for Generated { info, request, call, .. } in commands() {
        let mut client = arm.client();
        client.power_on().expect("it has power at once");
        client.enable_robot().expect("it is enabled at once");
        let mut runner = TestRunner::deterministic();
        for _ in 0..30 {
            let message = any_request(info).new_tree(&mut runner).expect("there are requests").current();
            let Ok(written) = request(&message.to_string()) else { continue };
            match call(&mut client, &message.to_string()) {
                Ok(()) => {}
                Err(error) if error.is_refused() && !is_new(info) => {}
                Err(error) => panic!("{written}: {error}"),
            }
            assert_eq!(arm.requests().last(), Some(&written));
            if info.ends_session {
                break;
            }
        }
    }
}

#[test]
fn values_are_what_they_say() {
    let arm = arm();
    let mut robot = arm.client();
    arm.set_reply(r#"every "kind"\of é"#, [("flag".to_owned(), 1.into())]);
    robot.power_on_strange().expect("it has power at once");
    robot.enable_robot().expect("it is enabled at once");
    let mut every = read::<strange::EveryKind>(EVERY_KIND);
    assert!(!robot.every_kind(&every).expect("it is accepted").flag, "1 means false");
    every.row.start = None;
    let error = robot.every_kind(&every).expect_err("the texts would stand in the level's place");
    expect![[r#"`every "kind"\of é` was not sent: field `row.start` is left out, allowed is a value, since a later one is given"#]]
        .assert_eq(&error.to_string());
    assert_eq!(strange::meaning(strange::OTHER), Some("The least."));
    assert_eq!(strange::meaning(strange::A1), Some("The greatest."));
}

#[test]
fn events_of_a_pack_are_known_in_addition_to_all_others() {
    let event = |code| jaka_sync::ControllerEvent::new(code).expect("the code is not zero");
    let found = |code| (strange::event_severity(event(code)), strange::event_meaning(event(code)));
    let strange = Some(r#"the "least" and the \greatest {codes}"#);
    for code in [1, 0x2F, u32::MAX - 1, u32::MAX] {
        assert_eq!(found(code), (Severity::Warning, strange), "{code:#x}");
        assert_eq!(event(code).severity(), Severity::Unknown, "{code:#x}");
    }
    let notes = |code| (strange::event_cause(event(code)), strange::event_remedy(event(code)));
    let (cause, remedy) = notes(0x2F);
    assert_eq!(cause, Some(EventNote::OfCode(r#"a "cause" \of {them}"#)));
    assert!(matches!(remedy, Some(EventNote::OfFamily(text)) if text.contains("look at the arm")), "{remedy:?}");
    let known = event(0x000F_0034);
    assert_eq!(notes(known.code()), (known.cause(), known.remedy()));
    assert!(known.cause().is_some() && known.remedy().is_some());
    assert_eq!(found(0x010F_0005), (Severity::Information, Some("the robot is disabled")));
    assert_eq!(found(u32::MAX - 2), (Severity::Unknown, None));
}

/// A request as the document would print it.
const EVERY_KIND: &str = r#"{"cmdName": "every \"kind\"\\of é", "cmd": true, "flag": 0, "word": "oui", "mixed": 2,
    "flags": [[1], []], "int": -9223372036854775808, "float": 5e-324, "text": "a", "json": [null], "{": {"a\"b\\c d.e é": 1},
    "[": {}, ":": [], ",": [1, 2], "'": [1, [[0, 0, 0], [1, 1, 1]], 0, ["a"]], "\n\u0001.": 0, "\\n": "say \"so\" \\ é",
    "é": [9223372036854775807, "say \"so\" \\ é", {"a\"b\\c d.e é": 1}], "bits": [0, 1, 0], "length": 2, "lengths": [[1, 2]],
    "raw": "a", "wrapped": [-1], "python": "((0, ((0, 0, 0), (1, 1, 1))),)", "python bool": "1", "lists": [[]],
    "pair": ["say \"so\" \\ é", "say \"so\" \\ é"], "pairs": [[{"a\"b\\c d.e é": 1}, {"a\"b\\c d.e é": 1}],
    [{"a\"b\\c d.e é": 1}, {"a\"b\\c d.e é": 1}]], "texts": [[], ["b"]], "picks": [[-1]]}"#;

#[test]
fn no_method_of_a_pack_is_hidden_by_one_of_a_client_or_a_robot() {
    let files = [include_str!("../../../jaka-sync/src/client.rs"), include_str!("../../../jaka-robot/src/robot.rs")];
    let methods = files.iter().flat_map(|file| file.lines()).filter(|line| line.contains("self"));
    let names = methods.filter_map(|line| line.trim().strip_prefix("pub fn ")?.split(['(', '<']).next());
    let names: Vec<_> = names.chain(["into", "try_into"]).collect();
    let expected = ["last_reply", "run", "explain", "power_up"];
    assert!(expected.iter().all(|name| names.contains(name)), "{names:?}");
    for name in names {
        let text = format!("title = 'T'\n[[command]]\nwire = {name:?}\neffect = 'query'\ndoc = 'D.'\n");
        let errors = jaka_spec::load_pack(&spec(), Source { path: "t.toml", text: &text }).expect_err(name);
        assert!(errors.to_string().contains("clients and robots have a method"), "{errors}");
    }
}
