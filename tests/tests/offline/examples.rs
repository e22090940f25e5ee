//! Checks that the examples of a spec fit the fields of their commands.

#![allow(clippy::needless_raw_string_hashes, reason = "expect-test writes them")]

use expect_test::expect;
use jaka_dynamic::{Misfit, misfits};
use jaka_spec::{Source, load_pack};
use jaka_tests::spec;

fn lines(misfits: impl IntoIterator<Item = Misfit>) -> String {
    let line = |misfit: Misfit| if misfit.is_lenient { format!("note: {misfit}\n") } else { format!("{misfit}\n") };
    misfits.into_iter().map(line).collect::<Vec<_>>().concat()
}

/// Misfits in a command of a pack with these examples.
fn check(examples: &str) -> String {
    let text = format!(
        "title = 'T'\n[[command]]\nwire = 'set_speed'\neffect = 'setting'\ndoc = 'D.'\n\
         [[command.request]]\nwire = 'v'\nname = 'speed'\ntype = 'float'\nmin = 0\ndoc = 'D.'\n\
         [[command.reply]]\nwire = 'n'\ntype = 'int'\ndoc = 'D.'\n{examples}"
    );
    let pack = load_pack(&spec(), Source { path: "t.toml", text: &text }).expect("the pack is correct");
    lines(misfits(&pack.spec, pack.spec.command("set_speed").expect("it is added")))
}

fn request(json: &str) -> String {
    check(&format!("[[command.example]]\nrequest = '{json}'"))
}

fn reply(json: &str) -> String {
    check(&format!("[[command.example]]\nreply = '{json}'"))
}

#[test]
fn those_of_the_document_fit() {
    let spec = spec();
    expect![[r#"
        note: command `wait_complete`, reply of an example: `cmdName` is " wait_complete"; expected is `wait_complete`
        note: command `set_payload`, reply of an example: `cmdName` is " set_payload "; expected is `set_payload`
    "#]]
    .assert_eq(&lines(spec.commands().flat_map(|command| misfits(&spec, command))));
}

#[test]
fn requests_are_those_that_the_client_sends() {
    assert_eq!(request(r#"{"cmdName": "set_speed", "v": 1.5}"#), "");
    expect![[r#"
        command `set_speed`, request of an example: field `speed` is -1; allowed is a number, at least 0
    "#]]
    .assert_eq(&request(r#"{"cmdName": "set_speed", "v": -1}"#));
    expect![[r#"
        command `set_speed`, request of an example: there is no field `w`; the fields are `speed`
        command `set_speed`, request of an example: field `speed` is missing; allowed is a number, at least 0
    "#]]
    .assert_eq(&request(r#"{"cmdName": "set_speed", "w": 1}"#));
    expect![[r#"
        command `set_speed`, request of an example: field `v` is missing; allowed is a number, at least 0
    "#]]
    .assert_eq(&request(r#"{"cmdName": "set_speed", "speed": 1}"#));
    expect![[r#"
        command `set_speed`, request of an example: its `cmdName` is not that of the command
    "#]]
    .assert_eq(&request(r#"{"cmdName": "set_sped", "v": 1}"#));
    expect![[r#"
        command `set_speed`, request of an example: it is not a JSON object: EOF while parsing an object at line 1 column 7
    "#]]
    .assert_eq(&request(r#"{"v": 1"#));
}

#[test]
fn replies_are_those_that_the_client_reads() {
    let success =
        |payload: &str| reply(&format!(r#"{{"cmdName": "set_speed", "errorCode": "0", "errorMsg": ""{payload}}}"#));
    assert_eq!(success(r#", "n": 1"#), "");
    assert_eq!(reply(r#"{"cmdName": "set_speed", "errorCode": "2", "errorMsg": "no"}"#), "");
    expect![[r#"
        note: command `set_speed`, reply of an example: `n` is "1"; expected is a whole number
    "#]]
    .assert_eq(&success(r#", "n": "1""#));
    expect![[r#"
        command `set_speed`, reply of an example: `m` is not in the spec; it looks like `int`: 1
        command `set_speed`, reply of an example: `n` is missing; expected is a whole number
    "#]]
    .assert_eq(&success(r#", "m": 1"#));
    expect![[r#"
        command `set_speed`, reply of an example: the message is "none"; expected is an object
    "#]]
    .assert_eq(&reply("none"));
}
