//! Packs: what they add and change. What users read when one is wrong is in `reports`.

use expect_test::{Expect, expect};
use jaka_spec::{Pack, Request, Severity, Source, Spec, TypeKind, builtin, load_pack};

fn spec() -> Spec {
    builtin().expect("the built-in spec is correct")
}

fn pack(text: &str) -> Pack {
    let text = format!("title = \"Test\"\n{text}");
    load_pack(&spec(), Source { path: "newer.toml", text: &text }).unwrap_or_else(|errors| panic!("{errors}"))
}

/// Loads a pack and compares its notes.
fn notes(text: &str, expected: &Expect) {
    let lines: Vec<_> = pack(text).notes.iter().map(|note| format!("{note}\n")).collect();
    expected.assert_eq(&lines.concat());
}

/// Content of the pack's module: its commands with their methods, and its types.
fn module(text: &str) -> String {
    let module = pack(text).module();
    let commands = module.topic.commands.iter().map(|command| module.method(command));
    let types = module.spec.types_of(&module.topic).map(|(_, def)| def.name.clone());
    commands.chain(types).collect::<Vec<_>>().join(" ")
}

fn event_codes(spec: &Spec) -> usize {
    spec.events().map(|event| event.codes().count()).sum()
}

const MOTION_STATE: &str = r#"
[[command]]
wire = "demo_motion_state"
effect = "query"
doc = "Reads how the motion stands."

[[command.reply]]
wire = "queue"
type = "int"
doc = "How many motions are queued."
"#;

/// A command whose reply has the keys of a named type.
const WHOLE_STATE: &str = r#"
[[command]]
wire = "read_whole_state"
effect = "query"
reply = "RobotStatus"
doc = "Reads what a status packet says."
"#;

#[test]
fn a_reply_changes_with_the_type_that_it_is() {
    let spec = pack(WHOLE_STATE).spec;
    let text = r#"
title = "Later"
[[extend]]
target = "RobotStatus"
[[extend.field]]
wire = "brake_state"
type = "int"
optional = true
doc = "State of the brakes."
"#;
    let module = load_pack(&spec, Source { path: "later.toml", text }).expect("the pack is correct").module();
    let methods: Vec<_> = module.topic.commands.iter().map(|command| module.method(command)).collect();
    assert_eq!(methods, ["get_data_later", "read_whole_state_later"]);
    let text = text.replace("\"RobotStatus\"", "\"read_whole_state\"").replace("extend.field", "extend.reply");
    let errors = load_pack(&spec, Source { path: "later.toml", text: &text }).expect_err("it has no fields of its own");
    expect!["later.toml:3:1: extension of `read_whole_state`: the reply is a `RobotStatus`; change that type"]
        .assert_eq(&errors.to_string());
}

#[test]
fn what_is_made_of_a_changed_type_changes_with_it() {
    let text = r#"
[[extend]]
target = "MoveMode"

[[extend.value]]
wire = 7
name = "Tool"
doc = "The target counts from the tool."
"#;
    assert_eq!(module(text), "joint_move_newer move_c_newer servo_j_newer servo_p_newer MoveMode");
}

#[test]
fn a_range_is_widened() {
    let pack = pack(
        r#"
[[override]]
target = "jog"
variant = "Continuous"
request = "jnum"
max = 6
"#,
    );
    let Some(Request::Choice(choice)) = pack.spec.command("jog").map(|command| &command.request) else {
        panic!("jog has variants")
    };
    let axis = |name: &str| {
        let variant = choice.variants.iter().find(|variant| variant.name == name).expect("jog has the variant");
        variant.fields.iter().find(|field| field.wire == "jnum").expect("it has an axis").range
    };
    assert_eq!((axis("Continuous").min, axis("Continuous").max), (Some(0.0), Some(6.0)));
    assert_eq!(axis("Stop").max, Some(5.0));
}

#[test]
fn a_limit_is_taken_away_by_infinity() {
    let pack = pack("[[override]]\ntarget = \"rapid_rate\"\nrequest = \"rate_value\"\nmax = inf\n");
    let Some(Request::Fields(fields)) = pack.spec.command("rapid_rate").map(|command| &command.request) else {
        panic!("rapid_rate has fields")
    };
    assert_eq!((fields[0].range.min, fields[0].range.max), (Some(0.0), None));
}

#[test]
fn a_disputed_field_is_settled() {
    let text = r#"
[[type]]
name = "ToolVoltage"
kind = "enum"
doc = "Voltage of the tool's output."

[[type.value]]
wire = 0
name = "V24"
doc = "24 V."

[[type.value]]
wire = 1
name = "V12"
doc = "12 V."

[[override]]
target = "set_tio_vout_param"
request = "tio_vout_vol"
type = "ToolVoltage"
doc = "Voltage of the tool's output."
settled = "Measured at the tool's connector, firmware 1.7.2."
"#;
    let pack = pack(text);
    let command = pack.spec.command("set_tio_vout_param").expect("the spec has it");
    let field = command.fields().find(|field| field.wire == "tio_vout_vol").expect("it has a voltage");
    assert_eq!(pack.spec.notation(&field.ty), "ToolVoltage");
    assert!(field.disputed.is_empty());
    assert_eq!(
        field.doc,
        "Voltage of the tool's output.\n\nSettled: Measured at the tool's connector, firmware 1.7.2."
    );
    assert_eq!(module(text), "set_tio_vout_param_newer ToolVoltage");
}

#[test]
fn packs_add_to_packs() {
    let first = pack(MOTION_STATE);
    let text = "title = \"More\"\n[[override]]\ntarget = \"demo_motion_state\"\ndeadline_ms = 9000\n";
    let second = load_pack(&first.spec, Source { path: "more.toml", text }).expect("the pack is correct");
    let command = second.spec.command("demo_motion_state").expect("the first pack has it");
    assert_eq!(command.deadline.map(|deadline| deadline.as_secs()), Some(9));
}

#[test]
fn a_pack_loads_when_the_spec_has_taken_it_over() {
    let text = r#"
title = "Test"

[[override]]
target = "set_tio_vout_param"
request = "tio_vout_vol"
type = "bool"
written = [0, 1]
doc = "Whether the tool has 12 V rather than 24 V."
settled = "Measured at the tool's connector, firmware 1.7.2."
"#;
    let source = Source { path: "newer.toml", text };
    let first = load_pack(&spec(), source).expect("the pack is correct");
    let second = load_pack(&first.spec, source).unwrap_or_else(|errors| panic!("{errors}"));
    assert_eq!(second.notes.len(), 2, "{:?}", second.notes);
}

#[test]
fn events_are_added() {
    let pack = pack(
        r#"
[[event]]
severity = "warning"
codes = ["0x1-0x2F", "0xFFFFFFFF"]
meaning = "the arm is tired"
"#,
    );
    let event = pack.spec.event(u32::MAX).expect("the pack has it");
    assert_eq!((event.severity, event.texts.meaning.as_deref()), (Severity::Warning, Some("the arm is tired")));
    assert_eq!(event_codes(&pack.spec), event_codes(&spec()) + 48);
    assert_eq!(pack.notes, &[]);
}

/// A later release that has a code, with or without a meaning, makes no pack wrong that had it before.
#[test]
fn events_that_the_spec_has_by_now_are_noted_or_complete_it() {
    let text = r#"
[[event]]
severity = "error"
codes = ["0x0F0034", "0x0F0004"]

[[event]]
severity = "information"
codes = ["0x10F0004-0x10F0005"]
meaning = "it is enabled or not"

[[event]]
severity = "error"
codes = ["0x0F0001", "0xFE0001", "0xFE0002"]
meaning = "something else"
"#;
    notes(
        text,
        &expect![[r"
            newer.toml:3:1: event: the spec has this by now, so the entry changes nothing; delete it once no program uses the names that it gives
            newer.toml:7:1: event: the spec has this by now, so the entry changes nothing; delete it once no program uses the names that it gives
        "]],
    );
    let spec = upgraded(text, "[[event]]\nseverity = \"error\"\ncodes = [\"0xFE0001\"]\n").spec;
    let meaning = |code| spec.event(code).and_then(|event| event.texts.meaning.as_deref());
    assert_eq!(meaning(0x000F_0034), Some("a collision was detected"));
    assert_eq!(meaning(0x010F_0005), Some("the robot is disabled"));
    assert_eq!(meaning(0x000F_0001), Some("the arm has no power"));
    assert_eq!([0x00FE_0001, 0x00FE_0002].map(meaning), [Some("something else"); 2]);
    assert_eq!(event_codes(&spec), event_codes(&self::spec()) + 2);
}

/// A pack, and the one that its spec is when the first is in it already: as after an upgrade.
fn upgraded(text: &str, upstream: &str) -> Pack {
    let spec = pack(upstream).spec;
    let text = format!("title = \"Test\"\n{text}");
    load_pack(&spec, Source { path: "newer.toml", text: &text }).unwrap_or_else(|errors| panic!("{errors}"))
}

/// The methods and types that a module has of its own, and those that are the spec's by now.
fn names(pack: &Pack) -> String {
    let module = pack.module();
    let own = module.topic.commands.iter();
    let covered = module.covered_commands.keys().filter_map(|wire| module.spec.command(wire));
    let types = module.topic.types.iter().chain(&module.covered_types).map(|id| module.spec[*id].name.clone());
    let mut names: Vec<_> = own.chain(covered).map(|command| module.method(command)).chain(types).collect();
    names.sort();
    names.join(" ")
}

const CHANGES: &str = r#"
[[extend]]
target = "MoveMode"

[[extend.value]]
wire = 7
name = "Tool"
doc = "The target counts from the tool."

[[override]]
target = "rapid_rate"
request = "rate_value"
max = 2

[[error]]
wire = 77
name = "Overload"
doc = "Too heavy."
"#;

#[test]
fn after_an_upgrade_all_names_of_the_module_are_there() {
    for text in [MOTION_STATE, WHOLE_STATE, CHANGES] {
        assert_eq!(names(&upgraded(text, text)), names(&pack(text)));
        assert_eq!(upgraded(text, text).module().codes, pack(text).module().codes);
        assert!(upgraded(text, text).module().topic.is_empty());
    }
}

#[test]
fn after_an_upgrade_what_the_spec_says_beyond_the_pack_counts() {
    let more = "\n[[command.reply]]\nwire = \"paused\"\ntype = \"bool\"\ndoc = \"Whether it is paused.\"\n";
    let pack = upgraded(MOTION_STATE, &format!("{MOTION_STATE}{more}"));
    assert_eq!((pack.module().topic.commands.len(), names(&pack).as_str()), (0, "demo_motion_state"));
    let module = upgraded(&MOTION_STATE.replace("effect", "name = \"motion_state\"\neffect"), MOTION_STATE).module();
    assert_eq!(module.covered_commands["demo_motion_state"], "motion_state");
}

#[test]
fn after_an_upgrade_what_a_program_would_notice_is_an_error() {
    let check = |upstream: &str, expected: Expect| {
        let spec = pack(upstream).spec;
        let text = format!("title = \"Test\"\n{MOTION_STATE}");
        let errors = load_pack(&spec, Source { path: "newer.toml", text: &text }).expect_err("the type is another");
        expected.assert_eq(&errors.to_string());
    };
    check(
        &MOTION_STATE.replace("\"int\"", "\"float\""),
        expect![
            "newer.toml:3:1: command `demo_motion_state`: the spec has one of this name by now, and there its field `queue` has another type, which your program would notice; delete the entry, and change the rest with `[[extend]]` and `[[override]]`"
        ],
    );
    check(
        &MOTION_STATE.replace("\"int\"", "\"int\"\nname = \"queued\""),
        expect![
            "newer.toml:3:1: command `demo_motion_state`: the spec has one of this name by now, and there it has no field `queue`, which your program would notice; delete the entry, and change the rest with `[[extend]]` and `[[override]]`"
        ],
    );
    check(
        &MOTION_STATE.replace("\"int\"", "\"int\"\noptional = true"),
        expect![
            "newer.toml:3:1: command `demo_motion_state`: the spec has one of this name by now, and there its field `queue` is optional, which your program would notice; delete the entry, and change the rest with `[[extend]]` and `[[override]]`"
        ],
    );
    let argument = "\n[[command.request]]\nwire = \"all\"\ntype = \"bool\"\ndoc = \"Whether all.\"\n";
    check(
        &format!("{MOTION_STATE}{argument}"),
        expect![
            "newer.toml:3:1: command `demo_motion_state`: the spec has one of this name by now, and there the required fields are `all`, which your program would notice; delete the entry, and change the rest with `[[extend]]` and `[[override]]`"
        ],
    );
}

#[test]
fn a_key_is_renamed() {
    let text = "\n[[override]]\ntarget = \"RobotStatus\"\nfield = \"inpos\"\nwire = \"at_target\"\n";
    let status = |pack: &Pack| {
        let field = pack.spec.status_fields().iter().find(|field| field.name == "in_position").cloned();
        field.expect("the packet has it").wire
    };
    assert_eq!(status(&pack(text)), "at_target");
    let after = upgraded(text, text);
    assert_eq!((status(&after), names(&after)), ("at_target".to_owned(), names(&pack(text))));
}

#[test]
fn a_variant_is_added() {
    let text = r#"
[[extend]]
target = "jog"

[[extend.variant]]
wire = 9
name = "Circle"
doc = "Jogs in a circle."

[[extend.variant.field]]
wire = "radius"
type = "float"
unit = "mm"
doc = "Radius of the circle."

[[extend]]
target = "ExtioSetup"

[[extend.variant]]
wire = 9
name = "Bus"
doc = "On the bus."

[[extend.variant.field]]
name = "line"
type = "int"
doc = "The line."
"#;
    let pack = pack(text);
    let Some(Request::Choice(choice)) = pack.spec.command("jog").map(|command| &command.request) else {
        panic!("jog has variants")
    };
    let last = choice.variants.last().expect("it has variants");
    assert_eq!((last.wire, &*last.name, &*last.fields[0].wire), (9, "Circle", "radius"));
    assert_eq!(names(&upgraded(text, text)), names(&pack));
}

#[test]
fn a_value_of_an_enum_is_changed() {
    let text = r#"
[[override]]
target = "MoveMode"
value = 1
advisory = true
since = "1.5"
"#;
    let spec = pack(text).spec;
    let Some(TypeKind::IntEnum(values)) = spec.type_id("MoveMode").map(|id| &spec[id].kind) else {
        panic!("it is an enum")
    };
    let value = values.iter().find(|value| value.wire == 1).expect("it has the value");
    let since = value.versions.since.as_ref().map(ToString::to_string);
    assert_eq!((value.advisory, &*value.name, since.as_deref()), (true, "Relative", Some("1.5")));
}

#[test]
fn a_pack_named_like_a_topic_is_not_that_topic() {
    let text = format!("title = \"Test\"\n{MOTION_STATE}");
    let pack = load_pack(&spec(), Source { path: "motion.toml", text: &text }).expect("it is correct");
    assert_eq!((pack.module_errors, pack.spec.topics.last().map(|topic| topic.is_pack)), (Vec::new(), Some(true)));
}

#[test]
fn what_is_advised_follows_names_and_can_be_changed() {
    let pack = pack(
        r#"
[[override]]
target = "servo_j"
request = "stepNum"
name = "cycles"

[[override]]
target = "servo_j"
request = "relFlag"
name = "how"

[[override]]
target = "joint_move"
request = "speed"
advised = [{ max = 300 }]

[[override]]
target = "joint_move"
request = "accel"
advised = []
"#,
    );
    let advised = |command: &str, key: &str| {
        let command = pack.spec.command(command).expect("the spec has it");
        let Request::Fields(fields) = &command.request else { panic!("it has fields") };
        let field = fields.iter().find(|field| field.wire == key).expect("it has the field");
        jaka_spec::words::advised(&pack.spec, fields, field, |other| other.name.clone()).unwrap_or_default()
    };
    assert_eq!(
        advised("servo_j", "jointPosition"),
        "-360 to 360, where `how` is 0 (Absolute); -2.12 to 2.12, times `cycles`, where `how` is 1 (Relative)"
    );
    assert_eq!((&*advised("joint_move", "speed"), &*advised("joint_move", "accel")), ("0 to 300", ""));
}

#[test]
fn what_is_repeated_and_changed_is_changed() {
    let text = r#"
[[command]]
wire = "get_loaded_program"
effect = "query"
doc = "Reads."
reply = [{ wire = "programName", name = "program_name", type = "text", doc = "Name." }]

[[override]]
target = "get_loaded_program"
deadline_ms = 10
"#;
    let module = pack(text).module();
    assert!(module.changed.contains("get_loaded_program"));
    assert!(module.covered_commands.is_empty());
}

#[test]
fn a_bare_reply_follows_its_field_s_name() {
    let text = "\n[[override]]\ntarget = \"get_extio_status\"\nreply = \"extio_status\"\nname = \"modules\"\n";
    let spec = pack(text).spec;
    let command = spec.command("get_extio_status").expect("the spec has it");
    assert_eq!(command.bare_reply.as_deref(), Some("modules"));
}

#[test]
fn a_motion_follows_its_fields_and_can_be_unknown() {
    let pack = pack(
        "\
         [[override]]\ntarget = 'joint_move'\nrequest = 'speed'\nname = 'velocity'\n\
         [[override]]\ntarget = 'moveL'\nrequest = 'speed'\nunit = 'm/s'\n\
         [[override]]\ntarget = 'moveL'\nmotion = 'unknown'\n",
    );
    let motion = |name: &str| pack.spec.command(name).expect("the spec has it").motion.as_ref();
    assert_eq!(motion("joint_move").and_then(|motion| motion.speed.as_deref()), Some("velocity"));
    assert_eq!(motion("moveL"), None);
}

#[test]
fn a_changed_field_that_a_packet_lacks_does_not_fit_the_pack() {
    let pack = pack("[[override]]\ntarget = 'RobotStatus'\nfield = 'protective_stop'\nwire = 'halted'");
    let changed: Vec<_> = pack.spec.robot_status().filter(|needed| needed.is_changed).collect();
    assert_eq!(changed.iter().map(|needed| needed.needed.name).collect::<Vec<_>>(), ["protective_stop"]);
}
