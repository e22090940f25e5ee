//! Bytes of commands on the wire: those of each example of the spec, and those sent by public clients.

use jaka_dynamic::arguments;
use jaka_spec::{Command, Spec};
use jaka_tests::{compact, same, spec};
use serde_json::Value;

use super::without_robot;
use crate::commands::call;

/// Lines for `jaka call`, and the requests as sent by public clients, byte for byte.
///
/// Written by hand, apart from the spec, to find a key that is wrong in the spec and in its example. A new command
/// needs no row.
const TABLE: &str = include_str!("requests.jsonl");

#[test]
fn the_bytes_are_those_that_clients_send() {
    for row in TABLE.lines() {
        let row: Value = serde_json::from_str(row).expect("a row is JSON");
        let line = row["line"].as_array().into_iter().flatten().filter_map(Value::as_str);
        let run = without_robot(["call"].into_iter().chain(line).chain(["--dry-run"]));
        assert_eq!((run.out.trim_end(), run.code), (row["request"].as_str().unwrap_or_default(), 0), "{}", run.err);
    }
}

/// Returns the line for `jaka call` with the fields of a request, each by its option in the help.
fn line(spec: &Spec, command: &Command, described: &clap::Command, request: &Value) -> Vec<String> {
    let mut line = vec!["call".to_owned(), command.wire.clone(), "--dry-run".to_owned()];
    let arguments = arguments(spec, command);
    // The tag of a request with variants comes first.
    let variant = arguments.first().and_then(|tag| {
        let listed = tag.values.iter().find(|listed| request.get(&tag.wire) == Some(&listed.wire));
        listed.map(|listed| listed.name.clone())
    });
    let is_in_variant =
        |variants: &[String]| variants.is_empty() || variant.as_ref().is_some_and(|name| variants.contains(name));
    for argument in arguments.iter().filter(|argument| is_in_variant(&argument.variants)) {
        let Some(value) = request.get(&argument.wire) else { continue };
        let json = value.to_string();
        let texts = [value.as_str().unwrap_or(&json), &json];
        let Some(text) = texts.iter().find(|text| argument.value(spec, text).is_ok_and(|read| same(&read, value)))
        else {
            continue;
        };
        let id = format!("field {}", argument.name);
        let option = described.get_arguments().find(|arg| *arg.get_id() == id).and_then(clap::Arg::get_long);
        line.push(format!("--{}={text}", option.expect("each field has an option")));
    }
    line
}

#[test]
fn each_request_of_the_spec_can_be_given_by_options() {
    let spec = spec();
    let all = call::all(&spec);
    let mut count = 0;
    for command in spec.commands() {
        let described = all.find_subcommand(&command.wire).expect("each is described");
        for example in command.examples.iter().filter_map(|example| example.request.as_deref()) {
            let request: Value = serde_json::from_str(example).expect("examples are JSON");
            let line = line(&spec, command, described, &request);
            let run = without_robot(&line);
            assert_eq!(run.out.trim_end(), compact(example), "{line:?}: {}", run.err);
            count += 1;
        }
    }
    assert!(count >= spec.commands().count(), "{count}");
}
