//! `jaka probe`: its requests, reports and drafts.

use std::collections::BTreeSet;
use std::fs;

use expect_test::{expect, expect_file};
use jaka_sim::{Fault, Firmware};
use jaka_spec::{Effect, Source, Spec, load_pack};
use jaka_tests::{Arm, LONG, spec};
use serde_json::{Value, json};

use super::{Run, interrupted, jaka, scratch, without_robot};

fn arm(firmware: Firmware) -> Arm {
    Arm::simulated().without_power().controller(|controller| controller.firmware(firmware)).start()
}

fn probe(arm: &Arm, options: &[&str]) -> Run {
    jaka(arm, ["probe", "--yes"].iter().chain(options))
}

/// Returns the report with the release's version replaced.
fn report(run: &Run) -> String {
    run.text().replace(env!("CARGO_PKG_VERSION"), "VERSION")
}

fn effect_of(spec: &Spec, request: &str) -> Effect {
    let request: Value = serde_json::from_str(request).expect("requests are JSON");
    spec.command(request["cmdName"].as_str().expect("they name their command")).expect("the spec has it").effect
}

#[test]
fn a_controller_that_fits_the_document() {
    let controller = arm(Firmware::Document);
    let run = probe(&controller, &["--packets", "2"]);
    expect_file!["../../tests/snapshots/probe_document.txt"].assert_eq(&report(&run));
    let spec = spec();
    let requests = controller.requests();
    assert!(requests.iter().all(|request| effect_of(&spec, request) == Effect::Query), "{requests:?}");
    assert_eq!(requests.len(), requests.iter().collect::<BTreeSet<_>>().len(), "each is asked once");
}

#[test]
fn an_old_controller() {
    let run = probe(&arm(Firmware::V1_5_14), &[]);
    expect_file!["../../tests/snapshots/probe_1_5_14.txt"].assert_eq(&report(&run));
}

#[test]
fn a_newer_controller() {
    let run = probe(&arm(Firmware::Newer), &[]);
    expect_file!["../../tests/snapshots/probe_newer.txt"].assert_eq(&report(&run));
}

/// Returns an arm with drifted replies: unknown keys, other forms, another type, and no reply at all.
fn drifted() -> Arm {
    let controller = arm(Firmware::Document);
    controller.set_reply("get_version", [("build".to_owned(), json!(17)), ("type".to_owned(), json!("x"))]);
    controller
        .set_reply("get_payload", [("mass".to_owned(), json!("1.5")), ("inertia moment".to_owned(), json!([0.5, 1]))]);
    controller.set_reply("get_joint_pos", [("joint_pos".to_owned(), json!("none"))]);
    controller.inject_for(
        "drag_status",
        Fault::Instead(br#"{"errorCode":"2","errorMsg":"no sensor","cmdName":"drag_status"}"#.to_vec()),
    );
    controller.inject_for("get_dh_param", Fault::Drop);
    controller.inject_for("get_traj_config", Fault::Close);
    controller.inject_for("get_tool_payload", Fault::Garbage { bytes: 40, seed: 7 });
    controller
}

#[test]
fn a_controller_that_drifts() {
    let draft = scratch("drifted.toml");
    let run = probe(&drifted(), &["--timeout", "0.3", "--draft", &draft.display().to_string()]);
    assert_eq!(run.code, 7, "{}", run.text());
    expect_file!["../../tests/snapshots/probe_drifted.txt"].assert_eq(&report(&run));
    let text = fs::read_to_string(&draft).expect("the draft is written");
    expect_file!["../../tests/snapshots/draft.toml"].assert_eq(&text);
    let pack = load_pack(&spec(), Source { path: "drifted.toml", text: &text }).expect("the draft loads");
    assert!(pack.notes.is_empty(), "{:?}", pack.notes);
}

#[test]
fn with_its_draft_a_controller_departs_no_more() {
    let controller = arm(Firmware::Document);
    controller.set_reply("get_version", [("build".to_owned(), json!(17))]);
    let draft = scratch("build.toml").display().to_string();
    assert_eq!(probe(&controller, &["--draft", &draft]).code, 7);
    let again = probe(&controller, &["--pack", &draft]);
    assert_eq!(again.code, 0, "{}", again.text());
    assert!(again.out.contains("packs       build.toml\n"), "{}", again.out);
}

#[test]
fn nothing_to_draft_is_said() {
    let draft = scratch("none.toml");
    let run = probe(&arm(Firmware::Document), &["--draft", &draft.display().to_string()]);
    assert_eq!(run.code, 0);
    expect![[r"
        note: no draft is written: no message has a key that is not in the spec, or a value that cannot be read
    "]]
    .assert_eq(&run.err);
    assert!(!draft.exists());
}

#[test]
fn the_report_as_json_has_the_same() {
    let run = probe(&drifted(), &["--timeout", "0.3", "--json"]);
    assert_eq!(run.code, 7, "{}", run.text());
    let report: Value = serde_json::from_str(&run.out).expect("it is JSON");
    let version = report["commands"].as_array().expect("all are there").iter().find(|it| it["name"] == "get_version");
    expect![[r#"
        {
          "code": null,
          "departures": [
            {
              "advisory": false,
              "expected": "int",
              "field": "build",
              "found": "17",
              "kind": "unknown",
              "more": 0,
              "readable": true
            },
            {
              "advisory": false,
              "expected": "text",
              "field": "type",
              "found": "\"x\"",
              "kind": "unknown",
              "more": 0,
              "readable": true
            }
          ],
          "name": "get_version",
          "outcome": "answered",
          "raw": "{\"build\":17,\"cmdName\":\"get_version\",\"errorCode\":\"0\",\"errorMsg\":\"\",\"type\":\"x\",\"version\":\"1.6.5_01_X86\"}",
          "text": null
        }"#]].assert_eq(&format!("{:#}", version.expect("it was asked")));
    assert_eq!((&report["controller"], &report["packs"]), (&json!("1.6.5_01_X86"), &json!([])));
    assert_eq!(report["status"]["outcome"], "answered");
}

#[test]
fn a_connection_that_always_breaks_is_given_up() {
    let controller = arm(Firmware::Document);
    controller.inject_always(Fault::Close);
    let run = probe(&controller, &[]);
    assert_eq!((run.code, run.out.as_str(), controller.requests().len()), (4, "", 1));
    assert!(
        run.err.contains("another client, such as the vendor's app, may have taken the command port"),
        "{}",
        run.err
    );

    let controller = arm(Firmware::Document);
    controller.inject(Fault::None);
    controller.inject_always(Fault::Close);
    let run = probe(&controller, &[]);
    assert_eq!(run.code, 7);
    let given_up = run.out.lines().filter(|line| line.contains("not probed: the connection broke 4 times")).count();
    assert_eq!(controller.requests().len(), 5, "{}", run.out);
    let spec = jaka_spec::builtin().expect("the built-in spec is correct");
    let queries = spec.commands().filter(|command| command.effect == Effect::Query && command.is_bare());
    assert_eq!(given_up, queries.count() - 5, "{}", run.out);
}

/// Tests changes of types only; numbers in arrays are whole by chance, and one is too large.
#[test]
fn a_draft_has_what_changed_and_loads_whatever_its_file_is_called() {
    let controller = arm(Firmware::Document);
    controller.set_reply("get_joint_pos", [("joint_pos".to_owned(), json!([1, 2, 3]))]);
    controller.set_reply("get_version", [("version".to_owned(), json!(17))]);
    let draft = scratch("fw-1.7.2 (new).toml").display().to_string();
    let run = probe(&controller, &["--draft", &draft]);
    assert_eq!(run.code, 7, "{}", run.text());
    expect![[r#"
        # A draft by `jaka probe`: answer each TODO, and correct guessed names and types.
        title = "Messages of a controller of unknown version beyond the spec"

        # TODO: check this change. get_version: unreadable: `version` is 17; expected is text
        [[override]]
        target = "get_version"
        reply = "version"
        type = "int"

        # TODO: check this change. get_joint_pos: unreadable: `joint_pos` has another length; expected is an array of 6, each a number (in deg): [1,2,3]
        [[override]]
        target = "get_joint_pos"
        reply = "joint_pos"
        type = "float[]"
    "#]].assert_eq(&fs::read_to_string(&draft).expect("the draft is written"));
    let again = probe(&controller, &["--pack", &draft]);
    assert_eq!(again.code, 0, "{}", again.text());
    let checked = without_robot(["spec", "check", &draft]);
    assert!(checked.out.contains(": note: it cannot be given to `pack!`: the file's name"), "{}", checked.out);

    controller.set_reply(
        "get_payload",
        [("demo_serial".to_owned(), json!(u64::MAX)), ("demo_list".to_owned(), json!([1, 2]))],
    );
    let draft = scratch("numbers.toml").display().to_string();
    probe(&controller, &["--draft", &draft]);
    let text = fs::read_to_string(&draft).expect("the draft is written");
    let types: Vec<_> = text.lines().filter(|line| line.starts_with("wire") || line.starts_with("type")).collect();
    expect![[r#"
        type = "int"
        wire = "demo_list"
        type = "float[]"
        wire = "demo_serial"
        type = "json"
        type = "float[]""#]]
    .assert_eq(&types.join("\n"));
}

/// Returns the draft of a probe with these replies, by command, in place of some; and a second probe with the draft.
fn drafted(name: &str, replies: &[(&str, Value)]) -> (String, Run) {
    let controller = arm(Firmware::Document);
    let change = || {
        for (command, fields) in replies {
            let mut reply = json!({ "errorCode": "0", "errorMsg": "", "cmdName": command });
            let fields = fields.as_object().expect("a reply has fields").clone();
            reply.as_object_mut().expect("a reply is an object").extend(fields);
            controller.inject_for(*command, Fault::Instead(reply.to_string().into_bytes()));
        }
    };
    let draft = scratch(name).display().to_string();
    change();
    assert_eq!(probe(&controller, &["--draft", &draft]).code, 7);
    change();
    let again = probe(&controller, &["--pack", &draft]);
    (fs::read_to_string(&draft).expect("the draft is written"), again)
}

/// Returns the entries of a draft, without its head.
fn entries(draft: &str) -> &str {
    draft.split_once("\n\n").map_or("", |(_, entries)| entries)
}

#[test]
fn a_key_that_took_the_place_of_another_is_proposed_as_its_new_name() {
    let (text, again) = drafted("renamed.toml", &[("get_version", json!({ "sw_version": "1.7.2" }))]);
    expect![[r#"
        # TODO: check this proposal. get_version: `version` is missing, and `sw_version` is new and looks like it: "1.7.2"
        [[override]]
        target = "get_version"
        reply = "version"
        wire = "sw_version"
    "#]].assert_eq(entries(&text));
    assert_eq!(again.code, 0, "{}", again.text());
}

#[test]
fn no_name_is_proposed_where_two_could_be_meant_or_the_type_differs() {
    let (text, _) = drafted(
        "unclear.toml",
        &[
            ("get_version", json!({ "sw_version": "1.7.2", "hw_version": "3" })),
            ("get_traj_config", json!({ "xyz_interval": 0.1, "rpy_interval": 0.1, "acceleration": 1.5 })),
            ("get_joint_pos", json!({ "joints": [1, 2, 3] })),
        ],
    );
    assert!(!entries(&text).contains("a proposal"), "{text}");
    let of_other_types = json!({ "sw_version": "1.7.2", "build": 3 });
    let (text, _) = drafted("clear.toml", &[("get_version", of_other_types)]);
    assert!(entries(&text).contains("wire = \"sw_version\"") && text.contains("name = \"build\""), "{text}");
}

#[test]
fn a_list_has_a_fixed_length_where_samples_or_the_spec_show_it() {
    let lists = json!({
        "mass": 1.5,
        "centroid": [1, 2, 3],
        "demo_rows": [[1, 2, 3], [4, 5.5, 6]],
        "demo_ragged": [[1], [2, 3]],
        "demo_once": [1, 2, 3],
        "demo_joints": [1, 2, 3, 4, 5, 6],
    });
    let (text, again) = drafted("lengths.toml", &[("get_payload", lists)]);
    let types: Vec<_> = text.lines().filter(|line| line.starts_with("wire") || line.starts_with("type")).collect();
    expect![[r#"
        wire = "demo_joints"
        type = "float[6]"
        wire = "demo_once"
        type = "float[]"
        wire = "demo_ragged"
        type = "float[][]"
        wire = "demo_rows"
        type = "float[3][]""#]]
    .assert_eq(&types.join("\n"));
    assert_eq!(again.code, 0, "{}", again.text());
}

#[test]
fn an_interrupt_leaves_a_report_of_what_was_found() {
    let controller = arm(Firmware::Document);
    controller.inject(Fault::None);
    controller.inject(Fault::Drop);
    let run = interrupted(&controller, ["probe", "--yes", "--timeout", "2"], || {
        assert!(controller.wait_for_requests(2, LONG), "two are asked");
    });
    assert_eq!((run.code, run.err.as_str()), (130, "error: interrupted\n"), "{run:?}");
    let row = |name: &str| {
        let begin = format!("{name} ");
        let line = run.out.lines().find(|line| line.starts_with(&begin)).unwrap_or_else(|| panic!("{name}: {run:?}"));
        line[begin.len()..].trim().to_owned()
    };
    let asked = controller.requests();
    let asked: Vec<Value> = asked.iter().map(|text| serde_json::from_str(text).expect("it is JSON")).collect();
    let asked: Vec<_> = asked.iter().map(|request| request["cmdName"].as_str().expect("it is a text")).collect();
    assert_eq!((row(asked[0]), row(asked[1])), ("ok".to_owned(), "no reply: none within 2s".to_owned()));
    let spec = spec();
    let queries = spec.commands().filter(|command| command.effect == Effect::Query).map(|command| &*command.wire);
    assert!(queries.filter(|name| !asked.contains(name)).all(|name| row(name).starts_with("not probed: ")));
    assert_eq!((row("status packet"), asked.len()), ("not probed: interrupted".to_owned(), 2));
}
