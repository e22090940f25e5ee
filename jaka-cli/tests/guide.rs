//! The guide to newer firmware: its commands are run against a simulated controller that has the firmware, and its pack
//! is used.

use std::fs;
use std::path::{Path, PathBuf};

use jaka_robot::motion::JointMove;
use jaka_robot::{ErrorKind, Monitor, Robot};
use jaka_sim::{Controller, Firmware};
use jaka_spec::{BUILTIN, NEEDED_FIELDS, Source, load, load_pack};
use jaka_tests::{Arm, ArmBuilder, LONG};
use serde_json::json;

use crate::program::{Run, address_of, command, run, scratch, words};

jaka_robot::pack!("tests/guide/newer.toml");

use newer::NewerCommands as _;

const GUIDE: &str = include_str!("../../jaka-sync/docs/newer-firmware.md");
const PACK: &str = include_str!("guide/newer.toml");

/// A controller with the guide's firmware.
fn controller(arm: ArmBuilder) -> Arm {
    let pack = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/guide/newer.toml");
    let arm = arm.without_power().controller(|controller| controller.firmware(Firmware::Document).pack(pack));
    let controller = arm.start();
    controller.set_state(|state| "1.7.2_02_X64".clone_into(&mut state.version));
    controller.set_reply("get_payload", [("demo_identified_at".to_owned(), json!(1_795_254_000))]);
    let keys = [("demo_brakes", json!(1)), ("protective_stop", json!("free"))];
    let keys = keys.map(|(key, value)| (key.to_owned(), value));
    controller.set_reply("get_data", keys.clone());
    controller.set_status(keys);
    controller
}

/// The texts of the guide's blocks of a language, in order.
fn blocks(language: &str) -> Vec<&'static str> {
    let begin = format!("```{language}\n");
    let rest = GUIDE.split(begin.as_str()).skip(1);
    rest.map(|rest| rest.split_once("```").expect("the block ends").0).collect()
}

/// A command line of the guide, and what follows it.
struct Step {
    words: Vec<String>,
    shown: Vec<&'static str>,
}

fn steps() -> Vec<Step> {
    let mut steps: Vec<Step> = Vec::new();
    for line in blocks("text").into_iter().flat_map(str::lines) {
        match line.strip_prefix("$ jaka ") {
            Some(command) => {
                steps.push(Step { words: words(command).into_iter().map(str::to_owned).collect(), shown: Vec::new() });
            }
            None => steps.last_mut().expect("a command comes first").shown.push(line),
        }
    }
    steps
}

/// Runs a step in a folder, with the controller in place of the guide's.
fn take(step: &Step, folder: &Path, controller: &Controller) -> Run {
    let mut words = step.words.clone();
    if let Some(at) = words.iter().position(|word| word == "--robot") {
        words.splice(at..at + 2, address_of(controller));
    }
    if words[0] == "probe" {
        // It asks the user.
        words.push("--yes".to_owned());
    }
    let mut command = command(words);
    command.current_dir(folder);
    run(command, "")
}

/// Compares lines with those of the guide, in which `…` stands for any.
fn assert_shown(step: &Step, run: &Run) {
    let (mut lines, mut is_open) = (run.out.lines(), false);
    for shown in &step.shown {
        if *shown == "…" {
            is_open = true;
            continue;
        }
        let found = if is_open { lines.find(|line| line == shown) } else { lines.next().filter(|line| line == shown) };
        assert!(found.is_some(), "{:?} does not print `{shown}`, but\n{}", step.words, run.text());
        is_open = false;
    }
    assert!(is_open || lines.next().is_none(), "{:?} prints more:\n{}", step.words, run.text());
}

#[test]
fn the_guide_s_commands_print_what_it_shows() {
    let folder = scratch("guide");
    fs::remove_dir_all(&folder).ok();
    fs::create_dir_all(&folder).expect("it can be made");
    upstream(&folder.join("upstream"));
    let controller = controller(Arm::real_time());
    let [draft, pack, moved, forms] = blocks("toml")[..] else { panic!("the guide shows the draft and three packs") };
    let built_in = jaka_spec::builtin().expect("the built-in spec is correct");
    load_pack(&built_in, Source { path: "forms.toml", text: forms }).expect("the pack with forms is correct");
    assert_eq!(moved, include_str!("guide/moved.toml"), "and so is this one");
    assert_eq!(pack, PACK, "the guide's pack is the one that is compiled here");
    let file = folder.join("newer.toml");
    let mut codes = Vec::new();
    for step in steps() {
        let run = take(&step, &folder, &controller);
        assert_shown(&step, &run);
        codes.push(run.code.expect("it ends by itself"));
        if step.words.contains(&"--draft".to_owned()) {
            assert_eq!(fs::read_to_string(&file).expect("the draft is written"), draft);
            // The user completes it.
            fs::write(&file, pack).expect("it can be written");
        }
    }
    // Only the first probe finds something.
    assert_eq!(codes, [7, 0, 0, 0, 0, 0, 0, 0, 0]);
}

#[test]
fn the_guide_s_pack_is_used_by_a_program() {
    let controller = controller(Arm::simulated());
    controller.set_reply("demo_motion_state", [("queue".to_owned(), 3.into())]);
    let mut client = controller.client();
    client.check_firmware().expect("the controller says its version");
    assert_eq!(client.demo_motion_state().expect("firmware 1.7.2 has it").queue, 3);
    assert_eq!(client.get_payload_newer().expect("it is answered").identified_at, Some(1_795_254_000));
    drop(client);

    let motion = JointMove::absolute([5.0, 90.0, 90.0, 90.0, -90.0, 0.0], 90.0);
    let mut robot = controller.robot();
    robot.power_up(LONG).expect("it has power at once");
    let error = robot.run(&motion, LONG).expect_err("the built-in type cannot read the protective stop");
    assert!(matches!(error.kind(), ErrorKind::StatusUnknown { .. }), "{error}");
    drop(robot);

    let monitor: Monitor<newer::RobotStatus> = controller.monitor();
    let mut robot = Robot::with_monitor(controller.client(), monitor).expect("it is the only robot");
    robot.run(&motion, LONG).expect("it is accepted").reached().expect("the arm reaches its target");
    assert_eq!(robot.demo_motion_state().expect("a robot takes it, too").queue, 3);
    controller.set_status([("protective_stop".to_owned(), json!("stopped"))]);
    let stopped = robot.monitor().wait_until(|status| status.protective_stop == Some(true), LONG);
    assert_eq!(stopped.expect("the packet comes").status.brakes, Some(1));
    let error = robot.run(&motion, LONG).expect_err("a stop is not acknowledged");
    assert!(matches!(error.kind(), ErrorKind::NotAcknowledged { .. }), "{error}");
}

/// The built-in spec with the pack's entries: new ones as they are, changes as edits of what is there.
fn upstream(folder: &PathBuf) {
    fs::create_dir_all(folder).expect("it can be made");
    let (changes, command) = PACK.split_once("[[command]]").expect("the pack has a command");
    let field = |begin: &str| {
        let (_, rest) = changes.split_once(begin).expect("the pack has the field");
        rest.split("\n\n").next().unwrap_or_default().to_owned()
    };
    for source in BUILTIN {
        let name = Path::new(source.path).file_name().expect("it is a file");
        let mut text = source.text.to_owned();
        if name == "payload.toml" {
            let (before, after) = text.split_once("wire = \"get_payload\"").expect("the topic has it");
            let (reply, rest) = after.split_once("\n[[command.example]]").expect("it has an example");
            let added = field("[[extend.reply]]\n");
            text = format!(
                "{before}wire = \"get_payload\"{reply}\n[[command.reply]]\n{added}\n\n[[command.example]]{rest}"
            );
        }
        if name == "status.toml" {
            let (before, after) = text.split_once("wire = \"protective_stop\"").expect("the packet has it");
            let after = after.replacen("written = [0, 1]", "written = [\"free\", \"stopped\"]", 1);
            let added = field("[[extend.field]]\n");
            text = format!("{before}{added}\n\n[[type.field]]\nwire = \"protective_stop\"{after}");
        }
        if name == "motion.toml" {
            text = format!("{text}\n[[command]]{command}");
        }
        fs::write(folder.join(name), text).expect("it can be written");
    }
}

#[test]
fn after_the_upgrade_the_guide_s_pack_has_all_its_names() {
    let folder = scratch("guide_upstream");
    upstream(&folder);
    let files: Vec<_> = BUILTIN.iter().map(|source| folder.join(Path::new(source.path).file_name().unwrap())).collect();
    let texts: Vec<_> = files.iter().map(|file| fs::read_to_string(file).expect("it was written")).collect();
    let sources: Vec<_> = BUILTIN.iter().zip(&texts).map(|(source, text)| Source { path: source.path, text }).collect();
    let upgraded = load(&sources).unwrap_or_else(|errors| panic!("{errors}"));
    let builtin = load(BUILTIN).expect("it is correct");
    let source = Source { path: "newer.toml", text: PACK };
    let [before, after] = [builtin, upgraded].map(|spec| {
        let module = load_pack(&spec, source).unwrap_or_else(|errors| panic!("{errors}")).module();
        let own = module.topic.commands.iter().map(|command| command.wire.clone());
        let mut names: Vec<_> = own.chain(module.covered_commands.keys().cloned()).collect();
        names.sort();
        let methods: Vec<_> =
            names.iter().filter_map(|name| module.spec.command(name)).map(|command| module.method(command)).collect();
        (methods, module.topic.types.len() + module.covered_types.len(), module.topic.is_empty())
    });
    assert_eq!((&before.0, before.1), (&after.0, after.1));
    assert_eq!((before.2, after.2), (false, true));
}

#[test]
fn the_guide_lists_what_a_robot_needs() {
    let rows = NEEDED_FIELDS.iter().map(|field| {
        let need = if field.is_required { "required" } else { "can be absent" };
        format!("| `{}` | {need} | {} |\n", field.name, field.without)
    });
    let table = rows.collect::<String>();
    assert!(GUIDE.contains(&format!("|---|---|---|\n{table}\n")), "the guide has another table than\n{table}");
}
