//! `jaka spec`, as its users run it.

#![allow(clippy::needless_raw_string_hashes, reason = "expect-test writes them")]

use std::fs;
use std::path::{Path, PathBuf};

use expect_test::expect;
use serde_json::Value;

use crate::program::{jaka, pack, scratch};

/// A file of this text, for one test.
fn file(name: &str, text: &str) -> String {
    let path = scratch(name);
    fs::write(&path, text).unwrap();
    path.display().to_string()
}

/// A folder with the built-in spec's files, and a pack of the workspace's tests as one more.
fn folder_with(name: &str, pack_name: &str) -> String {
    let folder = scratch(name);
    fs::create_dir_all(&folder).unwrap();
    for source in jaka_spec::BUILTIN {
        fs::write(folder.join(Path::new(source.path).file_name().unwrap()), source.text).unwrap();
    }
    fs::copy(pack(pack_name), folder.join(pack_name)).unwrap();
    folder.display().to_string()
}

/// Result of a run, with the paths of scratch files and of the tests' packs shortened.
fn text(arguments: &[&str]) -> String {
    let folder_of = |path: PathBuf| format!("{}/", path.parent().unwrap().display());
    let text = jaka([&["spec"], arguments].concat()).text();
    text.replace(&folder_of(scratch("x")), "").replace(&folder_of(pack("x").into()), "")
}

#[test]
fn a_topic_more_and_a_pack_are_the_same_additions() {
    let folder = folder_with("newer_spec", "newer.toml");
    let three = expect![[r"
        minor: command `demo_motion_state`: added
        minor: command `demo_set_period`: added
        minor: command `demo_stop_state`: added
        3 additions, minor
        exit code 0
    "]];
    three.assert_eq(&text(&["diff", "builtin", &folder]));
    three.assert_eq(&text(&["diff", "builtin", &pack("newer.toml")]));
    three.assert_eq(&text(&["diff", "builtin", "builtin", "--pack", &pack("newer.toml")]));
    expect![[r"
        no differences
        exit code 0
    "]]
    .assert_eq(&text(&["diff", &folder, &pack("newer.toml")]));
}

#[test]
fn the_exit_code_tells_the_gravest_change() {
    let [newer, changed] = ["newer.toml", "changed.toml"].map(pack);
    let doc = file("doc.toml", "title = 'T'\n[[override]]\ntarget = 'power_on'\ndoc = 'Powers.'\n");
    let code = |arguments: &[&str]| jaka([&["spec", "diff", "--exit-code"], arguments].concat()).code;
    assert_eq!(code(&["builtin", "builtin"]), Some(0));
    assert_eq!(code(&["builtin", &doc]), Some(10));
    assert_eq!(code(&["builtin", &newer]), Some(11));
    assert_eq!(code(&["builtin", &changed]), Some(12));
    // What is gone is major.
    assert_eq!(code(&[&newer, "builtin"]), Some(12));
    assert_eq!(jaka(["spec", "diff", "builtin", &changed]).code, Some(0));
}

#[test]
fn programs_read_changes_as_json() {
    let run = jaka(["spec", "diff", "--json", "builtin", &pack("newer.toml")]);
    let found: Value = serde_json::from_str(&run.out).unwrap();
    assert_eq!((&found["impact"], found["changes"].as_array().map(Vec::len)), (&"minor".into(), Some(3)));
    let first = serde_json::json!({"impact": "minor", "place": "command `demo_motion_state`", "what": "added"});
    assert_eq!(found["changes"][0], first);
    let run = jaka(["spec", "diff", "--json", "builtin", "builtin"]);
    assert_eq!(serde_json::from_str::<Value>(&run.out).unwrap(), serde_json::json!({"impact": null, "changes": []}));
}

#[test]
fn a_pack_that_the_spec_has_overtaken_is_noted() {
    let folder = folder_with("overtaken", "newer.toml");
    expect![[r#"
        overtaken/motion.toml:624:10: note: command `wait_complete`, reply of an example: `cmdName` is " wait_complete"; expected is `wait_complete`
        overtaken/payload.toml:32:10: note: command `set_payload`, reply of an example: `cmdName` is " set_payload "; expected is `set_payload`
        overtaken: 123 commands, 54 types, 5 error codes, 894 events
        newer.toml:1:1: note: this pack no longer changes anything: the spec has all of it by now
        newer.toml:4:1: note: command `demo_motion_state`: the spec has this by now, so the entry changes nothing; delete it once no program uses the names that it gives
        newer.toml:33:1: note: command `demo_stop_state`: the spec has this by now, so the entry changes nothing; delete it once no program uses the names that it gives
        newer.toml:44:1: note: command `set_demo_period`: the spec has this by now, so the entry changes nothing; delete it once no program uses the names that it gives
        newer.toml: no differences
        exit code 0
    "#]].assert_eq(&text(&["check", "--spec", &folder, &pack("newer.toml")]));
}

#[test]
fn a_whole_spec_is_checked_with_its_examples() {
    let folder = folder_with("whole", "newer.toml");
    let newer = fs::read_to_string(pack("newer.toml")).unwrap();
    file("whole/newer.toml", &newer.replace("\"queue\": 3", "\"queue\": [3]"));
    expect![[r#"
        whole/motion.toml:624:10: note: command `wait_complete`, reply of an example: `cmdName` is " wait_complete"; expected is `wait_complete`
        whole/payload.toml:32:10: note: command `set_payload`, reply of an example: `cmdName` is " set_payload "; expected is `set_payload`
        whole/newer.toml:31:10: command `demo_motion_state`, reply of an example: `queue` is [3]; expected is a whole number
        whole: 123 commands, 54 types, 5 error codes, 894 events
        error: 1 error
        exit code 2
    "#]].assert_eq(&text(&["check", "--spec", &folder]));
    file("whole/newer.toml", &newer.replace("\"int\"", "\"Int\""));
    expect![[r"
        whole/newer.toml:22:8: command `demo_motion_state`, reply field `queue`: there is no `[[type]]` named `Int`
        whole/newer.toml:27:8: command `demo_motion_state`, reply field `active_queue`: there is no `[[type]]` named `Int`
        whole/newer.toml:50:1: command `set_demo_period`, field `period`: `min`, `max` and `advisory` are for numbers
        whole/newer.toml:53:8: command `set_demo_period`, field `period`: there is no `[[type]]` named `Int`
        error: the spec in whole has errors
        exit code 2
    "]].assert_eq(&text(&["check", "--spec", &folder]));
}

#[test]
fn what_is_not_a_spec_is_named() {
    let empty = scratch("empty_spec");
    fs::create_dir_all(&empty).unwrap();
    expect![[r"
        error: the folder empty_spec has no TOML files
        exit code 2
    "]]
    .assert_eq(&text(&["diff", "builtin", &empty.display().to_string()]));
    assert_eq!(jaka(["spec", "check"]).code, Some(2));
}

#[test]
fn documents_have_the_commands_of_packs() {
    let without = jaka(["spec", "doc"]);
    assert_eq!(without.out, jaka_spec::tools::reference(&jaka_spec::builtin().unwrap()));
    let with = jaka(["spec", "doc", "--pack", &pack("newer.toml")]);
    let chinese = jaka(["spec", "doc", "--lang", "zh"]);
    assert_eq!(chinese.out, jaka_spec::tools::reference_zh(&jaka_spec::builtin().unwrap()));
    assert!(!without.out.contains("demo_motion_state") && with.out.contains("`demo_motion_state`"));
    let path = scratch("schema.json");
    let run = jaka(["spec", "schema", "--pack", &pack("newer.toml"), "-o", &path.display().to_string()]);
    assert_eq!(run.text(), "exit code 0\n");
    let schema: Value = serde_json::from_str(&fs::read_to_string(path).unwrap()).unwrap();
    assert_eq!(schema["$defs"]["request.demo_set_period"]["properties"]["demo_period"]["minimum"], 1);
    assert_eq!(jaka(["spec", "doc", "-o", "nowhere/reference.md"]).code, Some(6));
}
