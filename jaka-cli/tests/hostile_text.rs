//! No way out of `jaka` passes on what a terminal obeys, whatever a controller, a recording or a pack says.

use std::fs;
use std::io::{BufRead, Read, Write};
use std::net::TcpStream;
use std::path::PathBuf;
use std::thread;

use jaka_sim::{Controller, Fault, StatusFault};
use jaka_spec::{Source, load_pack};
use jaka_sync::proto::text::is_visible;
use jaka_sync::recording::Recording;
use jaka_tests::Arm;
use serde_json::{Value, json};

use crate::common::started;
use crate::program::{Run, address_of, command, jaka, run, scratch};

/// A character of each kind that a terminal or an editor acts on, and a forged line.
const HOSTILE: &str =
    "A\u{1b}[2J\u{7}\u{85}\u{9b}31m\u{7f}\u{61c}\u{200e}\u{202e}\u{2066}\u{2028}\u{feff}\r\nFORGED\tB";

/// Asserts that a terminal only shows the text.
fn assert_visible(what: &str, text: &str) {
    let hidden: Vec<_> = text.chars().filter(|&c| !is_visible(c) && c != '\n').collect();
    assert!(hidden.is_empty(), "{what}: {hidden:?} in {text:?}");
}

/// Asserts that a terminal only shows the text, and that no line of it is one of the hostile text's.
fn assert_harmless(what: &str, text: &str) {
    assert_visible(what, text);
    assert!(!text.lines().any(|line| line.trim_start().starts_with("FORGED")), "{what}: {text}");
}

fn assert_run(what: &str, run: &Run) {
    assert_harmless(&format!("{what}, standard output"), &run.out);
    assert_harmless(&format!("{what}, standard error"), &run.err);
}

/// The program with these words before the address of a controller.
fn jaka_at(controller: &Controller, words: &[&str]) -> Run {
    jaka(words.iter().map(|&word| word.to_owned()).chain(address_of(controller)))
}

/// A file of this name that does not exist yet.
fn fresh(name: &str) -> PathBuf {
    let path = scratch(name);
    fs::remove_file(&path).ok();
    path
}

/// Replies with hostile text in every place.
fn replies() -> Vec<(&'static str, Vec<u8>)> {
    let reply = |fields: Value| {
        let mut reply = json!({"errorCode": "0", "errorMsg": "", "cmdName": "get_version"});
        reply.as_object_mut().expect("it is one").extend(fields.as_object().expect("it is one").clone());
        reply.to_string().into_bytes()
    };
    let raw = format!(r#"{{"errorCode":"0","cmdName":"get_version","version":"{HOSTILE}"}}"#);
    vec![
        ("a value", reply(json!({"version": HOSTILE}))),
        ("a nested value", reply(json!({"version": {HOSTILE: [HOSTILE]}}))),
        ("an unknown key", reply(json!({"version": "1.7", HOSTILE: HOSTILE, "more": [{HOSTILE: HOSTILE}]}))),
        ("a refusal", reply(json!({"errorCode": "2", "errorMsg": HOSTILE}))),
        ("a code", reply(json!({"errorCode": HOSTILE, "errorMsg": HOSTILE}))),
        ("another command's name", reply(json!({"cmdName": HOSTILE}))),
        ("control characters in JSON, where none may be", raw.into_bytes()),
        ("not JSON", format!("{{{HOSTILE}}}").into_bytes()),
        ("no message", HOSTILE.as_bytes().to_vec()),
        ("no UTF-8", b"{\"errorCode\":\"\xff\x1b[2J\"}".to_vec()),
        ("a tuple", format!("(0, '{HOSTILE}')").into_bytes()),
    ]
}

#[test]
fn no_reply_reaches_a_terminal_raw() {
    for (kind, reply) in replies() {
        let json = [&["call", "get_version", "--json"][..], &["call", "get_version", "--json=wire"]];
        for options in [&["call", "get_version"][..], &["call", "--raw", "get_version"]].into_iter().chain(json) {
            let controller = Arm::real_time().without_power().start();
            controller.inject_for("get_version", Fault::Instead(reply.clone()));
            let run = jaka_at(&controller, &[options, &["--timeout", "0.3", "--yes"]].concat());
            assert_run(&format!("{kind}, {options:?}"), &run);
            assert!(!run.out.is_empty() || !run.err.is_empty(), "{kind}");
        }
    }
}

#[test]
fn json_of_the_controller_stays_the_same_json() {
    let controller = Arm::real_time().without_power().start();
    let reply = json!({"errorCode": "0", "cmdName": "get_version", "version": HOSTILE});
    controller.inject_for("get_version", Fault::Instead(format!("{reply:#}").into_bytes()));
    let run = jaka_at(&controller, &["call", "get_version", "--json=wire"]);
    assert_eq!(run.out.lines().count(), 1);
    assert_eq!(serde_json::from_str::<Value>(&run.out).expect("it is JSON"), reply);
}

#[test]
fn no_check_shows_a_controllers_text_raw() {
    // Each waits for answers that do not come.
    thread::scope(|scope| {
        for (kind, reply) in replies() {
            scope.spawn(move || check_shows_harmless_text(kind, reply));
        }
    });
}

fn check_shows_harmless_text(kind: &str, reply: Vec<u8>) {
    let controller = Arm::real_time().without_power().start();
    controller.set_state(|state| (state.error_message, state.error_code) = (HOSTILE.to_owned(), HOSTILE.to_owned()));
    controller.set_status([("rapidrate".to_owned(), json!(HOSTILE))]);
    controller.inject_for("get_version", Fault::Instead(reply));
    for options in [&["check", "--yes", "--timeout", "0.5"][..], &["check", "--yes", "--timeout", "0.5", "--json"]] {
        assert_run(&format!("{kind}, {options:?}"), &jaka_at(&controller, options));
    }
}

#[test]
fn no_probe_shows_a_controller_s_text_raw_and_its_draft_is_a_pack() {
    for (number, (kind, reply)) in replies().into_iter().enumerate() {
        for options in [&["probe", "--yes"][..], &["probe", "--yes", "--json"]] {
            let controller = Arm::real_time().without_power().start();
            controller.set_state(|state| state.error_message = HOSTILE.to_owned());
            controller.inject_for("get_version", Fault::Instead(reply.clone()));
            let path = fresh(&format!("hostile-{number}.toml"));
            let draft = ["--timeout", "0.3", "--draft", path.to_str().expect("it is UTF-8")];
            let run = jaka_at(&controller, &[options, &draft].concat());
            assert_run(&format!("{kind}, {options:?}"), &run);
            let Ok(text) = fs::read_to_string(&path) else { continue };
            assert_harmless(&format!("{kind}, draft"), &text);
            let spec = jaka_spec::builtin().expect("its own tests load it");
            load_pack(&spec, Source { path: "draft.toml", text: &text }).expect("the draft loads");
        }
    }
}

#[test]
fn a_draft_does_not_overwrite_a_finished_pack() {
    let path = fresh("finished.toml");
    fs::write(&path, "finished").expect("the folder is there");
    let controller = Arm::real_time().without_power().start();
    controller.set_reply("get_version", [("version".to_owned(), json!("1.7")), ("build".to_owned(), json!(1))]);
    let run = jaka_at(&controller, &["probe", "--yes", "--draft", path.to_str().expect("it is UTF-8")]);
    assert_eq!(run.code, Some(2), "{}", run.err);
    let path_text = path.display();
    let expected = format!("error: {path_text} exists already, and packs are not overwritten\n");
    assert_eq!(run.err, expected);
    assert_eq!(fs::read_to_string(&path).expect("it is there"), "finished");
}

/// Shows two packets in each way.
fn assert_status_is_harmless(packet: &[u8]) {
    for options in ["--format=table", "--format=csv", "--format=json", "--raw"] {
        let controller = Arm::real_time().without_power().start();
        controller.status_fault(StatusFault::Instead(packet.to_vec()));
        let fields = ["--fields", "error_code,error_message,enabled,torque_sensor"];
        let rest = if options == "--raw" { &[][..] } else { &fields };
        let run = jaka_at(&controller, &[&["status", "--timeout", "0.5", options, "-n", "2"], rest].concat());
        assert_run(&format!("{options}, {}", String::from_utf8_lossy(packet)), &run);
        assert!(!run.out.contains(",=") && !run.out.contains(",@"), "{}", run.out);
    }
}

#[test]
fn no_status_packet_reaches_a_terminal_raw() {
    let packet =
        json!({"errcode": HOSTILE, "errmsg": HOSTILE, HOSTILE: HOSTILE, "enabled": true, "torqsensor": [HOSTILE]});
    let packets = [
        packet.to_string().into_bytes(),
        format!("{packet:#}").into_bytes(),
        format!("{{\"errmsg\": \"{HOSTILE}\", \"enabled\": [\"{HOSTILE}\"]}}").into_bytes(),
        HOSTILE.as_bytes().to_vec(),
        br#"{"errmsg": "=cmd|' /C calc'!A0", "errcode": "@x"}"#.to_vec(),
    ];
    thread::scope(|scope| {
        for packet in &packets {
            scope.spawn(|| assert_status_is_harmless(packet));
        }
    });
}

#[test]
fn neither_a_recording_nor_its_replay_passes_on_what_a_terminal_obeys() {
    let path = fresh("hostile.jsonl");
    let file = path.to_str().expect("it is UTF-8");
    let controller = Arm::real_time().without_power().start();
    let reply = json!({"errorCode": "2", "errorMsg": HOSTILE, "cmdName": "get_version"}).to_string();
    controller.inject_for("get_version", Fault::Instead(reply.clone().into_bytes()));
    assert_run("call --record", &jaka_at(&controller, &["call", "get_version", "--record", file]));
    let text = fs::read_to_string(&path).expect("it was written");
    assert_harmless("the recording", &text);
    let recording = Recording::read(text.as_bytes()).expect("it can be read");
    let messages: Vec<_> = recording.entries.iter().filter_map(|entry| entry.event.message()?.text()).collect();
    assert!(messages.contains(&&*reply), "the text itself is kept: {messages:?}");
    assert_run("replay --show", &jaka(["replay", file, "--show"]));

    // One that somebody else has written.
    let line = |event: &str, key: &str| {
        json!({"time": 0.1, "port": "command", "connection": 1, "event": event, key: HOSTILE}).to_string()
    };
    let header = json!({"jaka_recording": 1, "started": 0, "software": HOSTILE}).to_string();
    let request = json!({"cmdName": HOSTILE}).to_string();
    let sent = json!({"time": 0.2, "port": "command", "connection": 1, "event": "sent", "text": request}).to_string();
    let lines = [
        header,
        line("connected", "address"),
        line("sent", "text"),
        line("received", "text"),
        sent,
        line("error", "text"),
    ];
    fs::write(&path, lines.join("\n") + "\n{\"\u{1b}[2J").expect("the folder is there");
    assert_run("replay --show of another's", &jaka(["replay", file, "--show"]));
    assert_run("report of another's", &jaka(["report", file]));
    let packet = json!({"errmsg": HOSTILE, "errcode": HOSTILE, "extio": {HOSTILE: HOSTILE}, "monitor_data": HOSTILE})
        .to_string();
    let packet = json!({"time": 0.3, "port": "status", "event": "received", "text": packet}).to_string();
    fs::write(&path, [&lines[0], &packet, ""].join("\n")).expect("the folder is there");
    for format in ["csv", "jsonl"] {
        assert_run("export of another's", &jaka(["export", file, "--fields", "all", "--format", format]));
    }
    fs::write(&path, "{\"\u{1b}[2J\u{202e}\": 1}\n").expect("the folder is there");
    assert_run("replay of no recording", &jaka(["replay", file, "--show"]));
    assert_run("report of no recording", &jaka(["report", file]));
}

/// Starts a program that prints its ports, sends these bytes to the first of them, and gives what it prints, with these
/// bytes' text.
fn printed_after(arguments: &[&str], bytes: &[u8]) -> String {
    let (mut child, mut out, line) = started(&mut command(arguments));
    let mut ports = line.split([':', ',', '\n']).filter_map(|word| word.parse::<u16>().ok());
    let mut client = TcpStream::connect(("127.0.0.1", ports.next().expect("there is one"))).expect("it listens");
    client.write_all(bytes).expect("it reads");
    let mut text = String::new();
    while !text.contains("FORGED") {
        assert!(out.read_line(&mut text).expect("it prints text") > 0, "it has ended: {text}");
    }
    child.kill().expect("it runs");
    child.wait().expect("it was started here");
    let mut rest = String::new();
    out.read_to_string(&mut rest).expect("it prints text");
    text + &rest
}

#[test]
fn neither_a_log_nor_a_deviation_shows_a_client_s_text_raw() {
    let request = format!("{{\"cmdName\": \"{HOSTILE}\"}}");
    let ports = ["--commands", "0", "--status", "0"];
    let log = printed_after(&[&["sim", "--log"][..], &ports].concat(), request.as_bytes());
    assert_harmless("sim --log", &log);
    let path = fresh("deviates.jsonl");
    let file = path.to_str().expect("it is UTF-8");
    assert_eq!(jaka(["call", "get_version", "--sim", "--record", file]).code, Some(0));
    let deviation = printed_after(&[&["replay", file][..], &ports].concat(), request.as_bytes());
    assert_harmless("replay", &deviation);
}

#[test]
fn no_pack_s_text_reaches_a_terminal_raw() {
    let path = fresh("hostile_pack.toml");
    let file = path.to_str().expect("it is UTF-8");
    let text = Value::from(HOSTILE).to_string().replace('\u{7f}', "\\u007f").replace('\u{85}', "\\u0085");
    let pack = format!(
        "title = {text}\ndoc = {text}\n[[command]]\nwire = \"odd\"\neffect = \"query\"\ndoc = {text}\nerrata = [{text}]\n\
         [[command.request]]\nwire = \"field\"\ntype = \"float\"\nunit = {text}\ndoc = {text}\n[[error]]\nwire = 77\nname = \
         \"Odd\"\ndoc = {text}\n"
    );
    fs::write(&path, &pack).expect("the folder is there");
    for arguments in [
        &["call", "--list"][..],
        &["call", "odd", "--help"],
        &["call", "odd", "--field", "x", "--dry-run"],
        &["spec", "check", file],
        &["spec", "doc"],
        &["spec", "schema"],
    ] {
        let rest = if arguments[..2] == ["spec", "check"] { &[][..] } else { &["--pack", file] };
        let run = jaka(arguments.iter().chain(rest));
        // Docs have lines.
        assert_visible(&format!("{arguments:?}"), &(run.out + &run.err));
    }
    fs::write(&path, pack.replace("effect = \"query\"", &format!("effect = {text}\n{text} = 1"))).expect("it is there");
    assert_run("a pack with errors", &jaka(["spec", "check", file]));
    assert_run("a pack with errors", &jaka(["call", "--list", "--pack", file]));
}

#[test]
fn the_question_before_a_command_shows_what_is_sent_and_no_more() {
    let line = ["call", "load_program", "--program-name", HOSTILE];
    assert_run("call", &run(command(line.iter().chain(&["--sim"])), "n\n"));
}
