//! Status keys of a pack, in every command that shows or judges status packets.

#![allow(clippy::needless_raw_string_hashes, reason = "expect-test writes them")]

use std::fs::{self, File};
use std::io::Write as _;
use std::path::PathBuf;

use expect_test::expect;
use jaka_sync::proto::wire::Writer;
use jaka_tests::{Arm, ArmBuilder, recorded};
use serde_json::json;

use crate::common::{ended, wait_until};
use crate::program::{address_of, jaka, result, scratch, started_at};
use crate::pseudo;

const PACK: &str = r#"
title = "Brakes"

[[type]]
name = "Mood"
kind = "enum"
doc = "Mood."
value = [{ wire = 3, name = "Calm", doc = "Calm." }]

[[extend]]
target = "RobotStatus"

[[extend.field]]
wire = "demo_brakes"
name = "brakes"
type = "bool"
written = ["open", "closed"]
optional = true
doc = "State of the brakes."

[[extend.field]]
wire = "demo_heat"
name = "temperatures"
type = "float[]"
unit = "°C"
optional = true
doc = "Temperatures."

[[extend.field]]
wire = "demo_mood"
name = "mood"
type = "Mood"
optional = true
doc = "Mood."

[[extend.field]]
wire = "demo_note"
name = "note"
type = "text"
optional = true
doc = "Note."
"#;

const FIELDS: &str = "brakes,temperatures,mood,demo_note";

/// File with the pack.
fn pack() -> PathBuf {
    let file = scratch("brakes.toml");
    fs::write(&file, PACK).expect("the folder is there");
    file
}

/// Builder of an arm whose controller knows the pack.
fn packed(arm: ArmBuilder) -> ArmBuilder {
    arm.without_power().controller(|controller| controller.pack(pack()))
}

/// Sets what packets show: truth values and numbers in forms that controllers use, too.
fn show(arm: &Arm, brakes: &str, heat: f64) {
    let keys = [
        ("demo_brakes", json!(brakes)),
        ("demo_heat", json!([heat.to_string(), 20])),
        ("demo_mood", json!("3")),
        ("demo_note", json!(format!("brakes {brakes}"))),
    ];
    arm.set_status(keys.map(|(key, value)| (key.to_owned(), value)));
}

fn run(words: &str, arm: &Arm) -> String {
    let pack = pack().display().to_string();
    let words = words.split(' ').map(str::to_owned).chain(["--pack".to_owned(), pack]);
    jaka(words.chain(address_of(arm))).text()
}

#[test]
fn status_shows_them_in_the_forms_of_the_spec() {
    let arm = packed(Arm::real_time()).start();
    show(&arm, "closed", 41.5);
    expect![[r#"
        brakes        true
        temperatures  41.500  20.000 °C
        mood          Calm (3)
        note          brakes closed
        exit code 0
    "#]]
    .assert_eq(&run(&format!("status --fields {FIELDS}"), &arm));
    for (format, expected) in [
        (
            "csv",
            expect![[r#"
        brakes,temperatures[0],temperatures[1],mood,note
        true,41.5,20,3,brakes closed
        exit code 0
    "#]],
        ),
        (
            "json",
            expect![[r#"
        "brakes":true,"temperatures":[41.5,20],"mood":3,"note":"brakes closed"}
        exit code 0
    "#]],
        ),
    ] {
        let text = run(&format!("status --fields {FIELDS} --format {format}"), &arm);
        // The time comes first.
        let lines = text.lines().map(|line| line.split_once(',').map_or(line, |(_time, rest)| rest).to_owned() + "\n");
        expected.assert_eq(&lines.collect::<String>());
    }
}

#[test]
fn conditions_judge_them() {
    let arm = packed(Arm::real_time()).start();
    show(&arm, "open", 20.5);
    let line = |condition: &str| format!("status --fields brakes --pack {} --until {condition}", pack().display());
    let waiting = started_at(&arm, &line("brakes&&temperatures[0]>40&&mood==3"));
    show(&arm, "closed", 40.5);
    expect![[r#"
        brakes  true
        exit code 0
    "#]]
    .assert_eq(&result(waiting).text());
    expect![[r#"
        error: `--until`, column 1: the status field `note` is neither a truth value nor a number
          note
          ^
        exit code 2
    "#]]
    .assert_eq(&run("status --until note", &arm));
}

#[test]
fn a_key_that_is_that_of_another_field_is_not_read_as_that() {
    let changed =
        |field: &str, wire: &str| format!("[[override]]\ntarget = 'RobotStatus'\nfield = '{field}'\nwire = '{wire}'\n");
    let text = changed("protective_stop", "demo_stop") + &changed("drag_status", "protective_stop");
    fs::write(scratch("brakes.toml"), "title = 'T'\n".to_owned() + &text).expect("the folder is there");
    let pack = scratch("brakes.toml");
    let arm = Arm::real_time().without_power().controller(|controller| controller.pack(&pack)).start();
    let keys = [("demo_stop", json!(1)), ("protective_stop", json!("perhaps"))];
    arm.set_status(keys.map(|(key, value)| (key.to_owned(), value)));
    let words = ["status", "--fields", "protective_stop,drag_status", "--pack"].map(str::to_owned);
    let words = words.into_iter().chain([pack.display().to_string()]).chain(address_of(&arm));
    expect![[r#"
        protective_stop  true
        drag_status      –
        warning: field `drag_status`: expected false or true, found `"perhaps"`; it is left out
        exit code 0
    "#]]
    .assert_eq(&jaka(words).text());
}

/// Recording of a session in which the brakes close.
fn recording() -> PathBuf {
    let ((), recording) = recorded(packed(Arm::simulated().no_packets()), |arm| {
        let mut packets = arm.stream();
        packets.next_packet().expect("one comes on connecting");
        for (brakes, heat) in [("open", 20.5), ("closed", 41.5)] {
            show(arm, brakes, heat);
            arm.publish();
            packets.next_packet().expect("a packet comes");
        }
    });
    let mut text = Writer::new();
    recording.write(&mut text);
    let file = scratch("session.jsonl");
    fs::write(&file, text.as_str()).expect("the folder is there");
    file
}

#[test]
fn export_has_columns_for_them() {
    let (file, pack) = (recording().display().to_string(), pack().display().to_string());
    let table = jaka(["export", &file, "--pack", &pack, "--fields", FIELDS]);
    let cells = |line: &str| line.splitn(4, ',').nth(3).unwrap_or_default().to_owned() + "\n";
    expect![[r#"
        brakes,temperatures[0] (°C),temperatures[1] (°C),mood,note
        false,,,3,
        false,20.5,20,3,brakes open
        true,41.5,20,3,brakes closed
    "#]]
    .assert_eq(&table.out.lines().map(cells).collect::<String>());
    assert_eq!((table.err.as_str(), table.code), ("", Some(0)));
}

#[test]
fn a_report_draws_numbers_and_truth_values_and_tells_the_rest() {
    let (file, pack) = (recording().display().to_string(), pack().display().to_string());
    let run = jaka(["report", &file, "--pack", &pack]);
    assert_eq!((run.err.as_str(), run.code), ("", Some(0)));
    let part = |id: &str| run.out.split_once(&format!("<section id=\"{id}\">")).expect("it is there").1;
    let packs = part("packs").split_once("</section>").expect("it ends").0.to_owned();
    for title in ["brakes", "mood", "temperatures[0] (°C)", "temperatures[1] (°C)"] {
        assert!(packs.contains(title), "{title} in {packs}");
    }
    assert!(part("list").contains("note brakes closed"), "{}", part("list"));
    let plain = jaka(["report", &file]);
    assert!(!plain.out.contains("<section id=\"packs\">"), "without the pack the page has no such part");
}

#[cfg(target_os = "linux")]
#[test]
fn the_monitor_shows_them() {
    let arm = packed(Arm::real_time()).start();
    show(&arm, "closed", 41.5);
    let pack = pack().display().to_string();
    let shown = scratch("shown");
    let line = format!("exec '{}' monitor --pack '{pack}' {}", pseudo::JAKA, address_of(&arm).join(" "));
    let mut terminal = pseudo::terminal(&line);
    terminal.stdout(File::create(&shown).expect("the folder is there"));
    let Some(mut child) = pseudo::started(terminal) else { return };
    let has_shown = |word: &str| String::from_utf8_lossy(&fs::read(&shown).unwrap_or_default()).contains(word);
    let mut keys = child.stdin.take().expect("it is piped");
    wait_until("a packet is shown", || has_shown("live"));
    keys.write_all(b"\t\t").expect("it reads keys");
    for word in ["packs", "brakes", "true", "41.500", "Calm", "note"] {
        wait_until(word, || has_shown(word));
    }
    keys.write_all(b"q").expect("it reads keys");
    assert_eq!(ended(child).2, Some(0));
}
