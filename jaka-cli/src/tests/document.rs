//! Every request printed in the vendor's document, as arguments and as a whole.

use std::collections::BTreeSet;

use jaka_dynamic::{Argument, arguments};
use jaka_spec::COMMAND_NAME;
use jaka_spec::Spec;
use jaka_tests::{compact, printed, spec};
use serde_json::{Map, Value};

use super::without_robot;

/// Calls `check` with each command that has a request in the document, the request's text, and its JSON.
fn each_request(check: impl Fn(&str, &str, &Map<String, Value>)) {
    let requests: Vec<_> = printed().into_iter().filter(|message| message.is_request).collect();
    assert_eq!(requests.len(), 84);
    for request in requests {
        let message: Map<String, Value> = serde_json::from_str(&request.text).expect("the document prints JSON");
        let command = message[COMMAND_NAME].as_str().expect("a request names its command").trim().to_owned();
        check(&command, &request.text, &message);
    }
}

/// Returns the arguments for the request's fields, each written by `text`.
fn line(
    spec: &Spec,
    command: &str,
    message: &Map<String, Value>,
    text: fn(&Argument, &Value) -> String,
) -> Vec<String> {
    let command_spec = spec.command(command).expect("the spec has the document's commands");
    let arguments = arguments(spec, command_spec);
    let variant = arguments.first().and_then(|tag| {
        let value = tag.values.iter().find(|value| Some(&value.wire) == message.get(&tag.wire));
        value.map(|value| value.name.clone())
    });
    let is_meant = |argument: &&Argument| {
        argument.variants.is_empty() || variant.as_ref().is_some_and(|variant| argument.variants.contains(variant))
    };
    let mut line = vec!["call".to_owned(), command.to_owned(), "--dry-run".to_owned()];
    for argument in arguments.iter().filter(is_meant) {
        if let Some(value) = message.get(&argument.wire) {
            line.extend([format!("--{}", argument.name), text(argument, value)]);
        }
    }
    line
}

fn as_json(_argument: &Argument, value: &Value) -> String {
    value.as_str().map_or_else(|| value.to_string(), str::to_owned)
}

/// Returns a value as typed by people: names of values, on and off, and lists without brackets.
fn as_typed(argument: &Argument, value: &Value) -> String {
    if let Some(listed) = argument.values.iter().find(|listed| listed.wire == *value) {
        return listed.name.clone();
    }
    match value {
        _ if argument.hint == "on|off" => if *value == 1 || *value == true { "on" } else { "off" }.to_owned(),
        Value::Array(items) if items.iter().all(Value::is_number) => {
            items.iter().map(Value::to_string).collect::<Vec<_>>().join(",")
        }
        _ => as_json(argument, value),
    }
}

fn check(line: &[String], expected: &str) {
    let run = without_robot(line);
    assert_eq!(run.out, format!("{}\n", compact(expected)), "{line:?}: {}", run.err);
    assert_eq!((run.code, run.err.as_str()), (0, ""), "{line:?}");
}

#[test]
fn each_comes_out_of_fields_in_json() {
    let spec = spec();
    each_request(|command, text, message| check(&line(&spec, command, message, as_json), text));
}

#[test]
fn each_comes_out_of_fields_as_they_are_typed() {
    let spec = spec();
    each_request(|command, text, message| check(&line(&spec, command, message, as_typed), text));
}

#[test]
fn each_comes_out_of_the_whole() {
    each_request(|_, text, _| check(&["call", "--dry-run", "--params", text].map(str::to_owned), text));
}

#[test]
fn each_command_is_found_by_either_name_and_has_help() {
    for command in spec().commands() {
        for name in BTreeSet::from([&command.wire, &command.name]) {
            let run = without_robot(["call", name, "-h"]);
            assert_eq!(run.code, 0, "{name}: {}", run.err);
            assert!(run.out.contains(&format!("Usage: jaka call {}", command.wire)), "{name}: {}", run.out);
        }
    }
}
