//! Properties of random messages, made from the spec.

use std::sync::LazyLock;

use jaka_proto::wire::Writer;
use jaka_proto::{Command, Envelope, Request, Visit, read_payload, write_reply};
use jaka_spec::Spec;
use jaka_tests::{any_object, any_request, drifted_number, same};
use proptest::prelude::*;
use serde_json::{Map, Value};

static SPEC: LazyLock<Spec> = LazyLock::new(jaka_tests::spec);

fn written(request: &Request) -> String {
    let mut out = Writer::new();
    request.write(&mut out);
    out.into_string()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn any_request_decodes_to_itself(json in any_request(&SPEC)) {
        let request = Request::read(&json.to_string()).map_err(|error| TestCaseError::fail(format!("{error:?}")))?;
        let text = written(&request);
        let again: Value = serde_json::from_str(&text).expect("a request is JSON");
        prop_assert!(same(&json, &again), "{json} became {again}");
        prop_assert_eq!(Request::read(&text).expect("it decoded before"), request);
    }

    #[test]
    fn replies_decode_the_same_however_they_drift(
        (command, reply) in any_reply(),
        forms in proptest::collection::vec(any::<u8>(), 64),
        seed in any::<u64>(),
    ) {
        let request = request_for(&command);
        let plain = Value::Object(reply.clone()).to_string();
        let drifted = drift(&command, &reply, &forms, seed);
        let (plain, drifted) = (request.visit(Normal(&plain)), request.visit(Normal(&drifted)));
        prop_assert_eq!(plain, drifted);
    }
}

/// A message of the document with some bytes replaced, removed or doubled, as text.
fn damaged() -> impl Strategy<Value = String> {
    let texts: Vec<_> = jaka_tests::printed().into_iter().map(|message| message.text).collect();
    let damage = proptest::collection::vec((any::<prop::sample::Index>(), 0..3, any::<u8>()), 0..8);
    (proptest::sample::select(texts), damage).prop_map(|(text, damage)| {
        let mut bytes = text.into_bytes();
        for (place, kind, byte) in damage {
            let place = place.index(bytes.len());
            match kind {
                0 => bytes[place] = byte,
                1 if bytes.len() > 1 => drop(bytes.remove(place)),
                _ => bytes.insert(place, bytes[place]),
            }
        }
        String::from_utf8_lossy(&bytes).into_owned()
    })
}

/// Reads a reply as that of any command, to see that nothing panics.
struct Anything<'t>(&'t str);

impl Visit for Anything<'_> {
    type Output = bool;

    fn visit<C: Command>(self, _command: &C) -> bool {
        read_payload::<C::Reply>(C::INFO, self.0).is_ok()
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4000))]

    #[test]
    fn damaged_messages_are_read_or_refused_but_nothing_panics(text in damaged(), command in any::<prop::sample::Index>()) {
        let commands: Vec<_> = SPEC.commands().collect();
        let request = request_for(&commands[command.index(commands.len())].wire);
        request.visit(Anything(&text));
        let is_json = serde_json::from_str::<Value>(&text).is_ok_and(|value| value.is_object());
        if is_json {
            prop_assert!(Envelope::read(&text).is_ok(), "JSON is refused: {text}");
        }
        if let Ok(request) = Request::read(&text) {
            prop_assert_eq!(Request::read(&written(&request)).expect("it was written just now"), request);
        }
    }
}

/// A command of the spec, and a random successful reply to it.
fn any_reply() -> impl Strategy<Value = (String, Map<String, Value>)> {
    let with_payload: Vec<_> = SPEC.commands().filter(|command| !SPEC.reply_fields(command).is_empty()).collect();
    proptest::sample::select(with_payload).prop_flat_map(|command| {
        let name = command.wire.clone();
        any_object(&SPEC, SPEC.reply_fields(command)).prop_map(move |mut reply| {
            reply.insert("errorCode".to_owned(), "0".into());
            reply.insert("errorMsg".to_owned(), "".into());
            reply.insert("cmdName".to_owned(), name.clone().into());
            (name.clone(), reply)
        })
    })
}

fn request_for(command: &str) -> Request {
    let command = SPEC.command(command).expect("the name is from the spec");
    let example = command.examples.iter().find_map(|example| example.request.as_ref());
    Request::read(example.expect("each command has an example")).expect("the examples decode")
}

/// Reads a reply and writes it in the document's form.
struct Normal<'t>(&'t str);

impl Visit for Normal<'_> {
    type Output = String;

    fn visit<C: Command>(self, _command: &C) -> String {
        let envelope = Envelope::read(self.0).expect("the reply is JSON");
        assert_eq!(envelope.command.as_deref(), Some(C::INFO.name));
        let reply: C::Reply = read_payload(C::INFO, self.0).unwrap_or_else(|error| panic!("{error}: {}", self.0));
        let mut out = Writer::new();
        write_reply(C::INFO, &reply, &mut out);
        out.into_string()
    }
}

/// Returns the reply as another firmware would send it: other forms of numbers and truth values, another order of the
/// keys, unknown keys, blanks in `cmdName`, no `errorMsg`, another form of success.
fn drift(command: &str, reply: &Map<String, Value>, forms: &[u8], seed: u64) -> String {
    let command = SPEC.command(command).expect("the name is from the spec");
    let mut keys: Vec<_> = reply.keys().collect();
    let len = keys.len();
    keys.rotate_left(usize::try_from(seed % 16).expect("it is small") % len);
    let mut parts = vec!["\"unknown key\": {\"a\": [1, null, \"}\"]}".to_owned()];
    for (key, form) in keys.into_iter().zip(forms) {
        let value = match key.as_str() {
            "errorCode" => ["\"0\"", "0", "\"0x0\"", "0.0"][usize::from(form % 4)].to_owned(),
            "errorMsg" => continue,
            "cmdName" => format!("\" {} \"", command.wire),
            key => {
                let field = SPEC
                    .reply_fields(command)
                    .iter()
                    .find(|field| field.wire == key)
                    .expect("the reply is from the spec");
                drifted(&field.ty, &reply[key], *form).to_string()
            }
        };
        parts.push(format!("{}: {value}", Value::from(key.as_str())));
    }
    format!("{{{}}}", parts.join(", "))
}

fn drifted(ty: &jaka_spec::Type, value: &Value, form: u8) -> Value {
    use jaka_spec::{Scalar, Type};
    match (ty, value) {
        (Type::Scalar(Scalar::Bool { on, .. }), value) => {
            let is_on = serde_json::from_str::<Value>(on).is_ok_and(|on| on == *value);
            let (off, on) =
                [("false", "true"), ("0", "1"), ("\"0\"", "\"1\""), ("\"False\"", "\"True\"")][usize::from(form % 4)];
            serde_json::from_str(if is_on { on } else { off }).expect("the forms are JSON")
        }
        (Type::Scalar(Scalar::Int | Scalar::Float), Value::Number(number)) => drifted_number(number, form),
        (Type::List(element) | Type::Array(element, _), Value::Array(values)) => {
            values.iter().map(|value| drifted(element, value, form)).collect()
        }
        (_, value) => value.clone(),
    }
}
