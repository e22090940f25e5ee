//! Messages by the model at run time against the generated ones.
#![allow(clippy::needless_raw_string_hashes)] // so writes expect-test

mod arguments;
mod problems;
mod replies;
mod replies_at_random;
mod requests;
mod translation;

use std::sync::LazyLock;

use jaka_spec::{Command, Source, Spec};
use proptest::prelude::*;
use serde_json::{Map, Value, json};

static SPEC: LazyLock<Spec> = LazyLock::new(jaka_tests::spec);

fn command(wire: &str) -> &'static Command {
    SPEC.command(wire).expect("the spec has the command")
}

fn object(value: Value) -> Map<String, Value> {
    match value {
        Value::Object(object) => object,
        other => panic!("{other} is not an object"),
    }
}

/// The command that a message names.
fn command_of(message: &Value) -> &'static Command {
    command(message["cmdName"].as_str().expect("a message has its name"))
}

fn lines<T: ToString>(items: &[T]) -> String {
    items.iter().map(|item| item.to_string() + "\n").collect()
}

/// A spec with commands and types that the built-in one has none of.
fn pack() -> Spec {
    let source = Source { path: "pack.toml", text: include_str!("dynamic/pack.toml") };
    jaka_spec::load(&[source]).expect("the pack is correct")
}

/// A reply to an accepted command.
fn success(wire: &str, fields: Value) -> Value {
    let mut reply = object(fields);
    reply.insert("errorCode".to_owned(), "0".into());
    reply.insert("errorMsg".to_owned(), "".into());
    reply.insert("cmdName".to_owned(), wire.into());
    reply.into()
}

/// Values of every kind, to put in place of others.
fn any_json() -> impl Strategy<Value = Value> {
    let scalars = [
        json!(null),
        json!(true),
        json!(0),
        json!(1),
        json!(3),
        json!(-1),
        json!(1.0),
        json!(0.5),
        json!(1e300),
        json!(u64::MAX),
        json!("1"),
        json!(" 0 "),
        json!("True"),
        json!("2.0"),
        json!("inf"),
        json!("é"),
        json!(""),
        json!("0x0"),
        json!({}),
        json!([]),
        json!([0]),
        json!([[]]),
        json!({"x": 1}),
    ];
    let six = proptest::collection::vec(proptest::sample::select(scalars.to_vec()), 5..8).prop_map(Value::from);
    prop_oneof![4 => proptest::sample::select(scalars.to_vec()), 1 => six]
}

/// A message in which some values are replaced, and each key may be lost.
fn damaged(message: Value) -> impl Strategy<Value = Value> {
    let changes = proptest::collection::vec((any::<prop::sample::Index>(), proptest::option::of(any_json())), 0..3);
    changes.prop_map(move |changes| {
        let mut message = object(message.clone());
        for (key, value) in changes {
            let keys: Vec<_> = message.keys().filter(|key| *key != "cmdName").cloned().collect();
            let Some(key) = keys.get(key.index(keys.len().max(1))) else { continue };
            match value {
                Some(value) => drop(message.insert(key.clone(), value)),
                None => drop(message.remove(key)),
            }
        }
        message.into()
    })
}
