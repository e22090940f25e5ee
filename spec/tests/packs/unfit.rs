//! What users read when a pack is wrong.

use expect_test::{Expect, expect};
use jaka_spec::{Source, load_pack};

use super::{MOTION_STATE, spec};

/// Loads a wrong pack and compares the errors. A line for the title is put before `text`.
fn wrong(text: &str, expected: &Expect) {
    let text = format!("title = \"Test\"{text}");
    let errors = match load_pack(&spec(), Source { path: "newer.toml", text: &text }) {
        Ok(_) => String::new(),
        Err(errors) => errors.to_string() + "\n",
    };
    expected.assert_eq(&errors);
}

#[test]
fn an_empty_pack() {
    wrong(
        "\n",
        &expect![[r"
            newer.toml:1:1: a pack has `[[command]]`, `[[type]]`, `[[error]]`, `[[event]]`, `[[extend]]` or `[[override]]`
        "]],
    );
}

#[test]
fn a_pack_without_a_title() {
    let errors =
        load_pack(&spec(), Source { path: "newer.toml", text: MOTION_STATE }).expect_err("the title is missing");
    expect!["newer.toml:1:1: `title` is missing"].assert_eq(&errors.to_string());
}

#[test]
fn no_toml() {
    wrong(
        "\n[[command]\nwire = \"go\"\n",
        &expect![[r"
            newer.toml:1:1: a pack has `[[command]]`, `[[type]]`, `[[error]]`, `[[event]]`, `[[extend]]` or `[[override]]`
            newer.toml:2:11: not valid TOML: unclosed array table, expected `]`
            newer.toml:3:1: unknown key `wire`; the keys are command, doc, error, event, extend, override, title, title_zh, type
        "]],
    );
}

#[test]
fn a_target_that_is_not_there() {
    wrong(
        "\n[[extend]]\ntarget = \"joint_mov\"\n\n[[override]]\ntarget = \"Rowbotstatus\"\n\n[[override]]\ntarget = \"fly\"\n",
        &expect![[r"
            newer.toml:3:10: extension of `joint_mov`: the spec has no command and no type `joint_mov`; there is `joint_move`
            newer.toml:6:10: override of `Rowbotstatus`: the spec has no command and no type `Rowbotstatus`; there is `RobotStatus`
            newer.toml:9:10: override of `fly`: the spec has no command and no type `fly`
        "]],
    );
}

#[test]
fn an_entry_without_a_target() {
    wrong(
        "\n[[extend]]\n[[extend.request]]\nwire = \"zone\"\n",
        &expect![[r"
        newer.toml:2:1: extension of: `target` is missing
    "]],
    );
}

#[test]
fn an_extension_that_adds_nothing() {
    wrong(
        "\n[[extend]]\ntarget = \"joint_move\"\n",
        &expect![[r"
            newer.toml:2:1: extension of `joint_move`: an extension has fields, `request` or `reply` of a command or `field` of a type, or a `value` or `variant`
        "]],
    );
}

#[test]
fn an_extension_of_the_wrong_kind() {
    wrong(
        "\n[[extend]]\ntarget = \"RobotStatus\"\n[[extend.reply]]\nwire = \"mode\"\ntype = \"int\"\ndoc = \"Mode.\"\n",
        &expect![[r"
            newer.toml:2:1: extension of `RobotStatus`: an extension has fields, `request` or `reply` of a command or `field` of a type, or a `value` or `variant`
            newer.toml:4:10: extension of `RobotStatus`: unknown key `reply`; the keys are field, target, value, variant
        "]],
    );
}

#[test]
fn a_field_that_is_there_already() {
    wrong(
        "\n[[extend]]\ntarget = \"joint_move\"\n[[extend.request]]\nwire = \"speed\"\ntype = \"int\"\ndoc = \"Speed.\"\n",
        &expect![[r"
            newer.toml:4:1: extension of `joint_move`, field `speed`: the spec has it by now, and there its field `speed` has another type; delete the entry, and change the rest with `[[override]]`
        "]],
    );
}

#[test]
fn a_field_whose_name_is_taken() {
    wrong(
        "\n[[extend]]\ntarget = \"joint_move\"\n[[extend.request]]\nwire = \"v\"\nname = \"speed\"\ntype = \"int\"\ndoc = \"Speed.\"\n",
        &expect![[r"
            newer.toml:4:1: extension of `joint_move`, field `speed`: the name `speed` is that of the key `speed`; give another as `name`
        "]],
    );
}

#[test]
fn a_field_without_type_and_doc() {
    wrong(
        "\n[[extend]]\ntarget = \"joint_move\"\n[[extend.request]]\nwire = \"zone\"\n",
        &expect![[r"
        newer.toml:4:1: extension of `joint_move`, field `zone`: `doc` is missing
        newer.toml:4:1: extension of `joint_move`, field `zone`: `type` is missing
    "]],
    );
}

#[test]
fn a_field_of_a_type_that_is_not_there() {
    wrong(
        "\n[[extend]]\ntarget = \"joint_move\"\n[[extend.request]]\nwire = \"zone\"\ntype = \"Zone\"\ndoc = \"Zone.\"\n",
        &expect![[r"
            newer.toml:6:8: extension of `joint_move`, field `zone`: there is no `[[type]]` named `Zone`
        "]],
    );
}

#[test]
fn a_choice_needs_its_variant() {
    wrong(
        r#"
[[extend]]
target = "jog"
[[extend.request]]
wire = "zone"
type = "float"
doc = "Zone."

[[override]]
target = "jog"
variant = "Fly"
request = "jnum"
max = 6
"#,
        &expect![[r"
            newer.toml:2:1: extension of `jog`: `variant` says which variant is meant: one of Stop, Continuous, Increment, Absolute
            newer.toml:11:11: override of `jog`: `variant` says which variant is meant: one of Stop, Continuous, Increment, Absolute
        "]],
    );
}

#[test]
fn an_override_of_a_field_that_is_not_there() {
    wrong(
        "\n[[override]]\ntarget = \"rapid_rate\"\nrequest = \"rate\"\nmax = 2\n",
        &expect![[r"
        newer.toml:4:11: override of `rapid_rate`: there is no field `rate`; there are rate_value
    "]],
    );
}

#[test]
fn an_override_of_two_fields() {
    wrong(
        "\n[[override]]\ntarget = \"rapid_rate\"\nrequest = \"rate_value\"\nreply = \"rate_value\"\nmax = 2\n",
        &expect![[r"
            newer.toml:2:1: override of `rapid_rate`: an override is of one field: `request` or `reply`, not both
        "]],
    );
}

#[test]
fn an_override_of_a_type_names_a_field() {
    wrong(
        "\n[[override]]\ntarget = \"RobotStatus\"\ndoc = \"New.\"\n",
        &expect![[r"
            newer.toml:2:1: override of `RobotStatus`: `field` or `value` says what is overridden, and is missing
        "]],
    );
}

#[test]
fn a_range_upside_down_and_a_range_of_a_text() {
    wrong(
        r#"
[[override]]
target = "rapid_rate"
request = "rate_value"
min = 2

[[override]]
target = "load_program"
request = "programName"
max = 8
"#,
        &expect![[r"
            newer.toml:2:1: override of `rapid_rate`: `min` is greater than `max`
            newer.toml:7:1: override of `load_program`: `min`, `max` and `advisory` are for numbers
        "]],
    );
}

#[test]
fn what_is_advised_of_a_field_needs_the_one_on_which_it_depends() {
    wrong(
        "\n[[override]]\ntarget = \"servo_j\"\nrequest = \"stepNum\"\ntype = \"float\"\nadvised = []\n",
        &expect![[r"
            newer.toml:2:1: override of `servo_j`: `advised` of `joint_position`: there is no field `step_count` that is a whole number
        "]],
    );
}

#[test]
fn a_disputed_field_needs_evidence() {
    wrong(
        r#"
[[override]]
target = "set_tio_vout_param"
request = "tio_vout_vol"
type = "bool"
written = [0, 1]
"#,
        &expect![[r"
            newer.toml:2:1: override of `set_tio_vout_param`: the meaning is disputed (document 2.0.4 alone: 0 = 12 V, 1 = 24 V; vendor headers (SDK 2.2.2 and another), vendor manual, six users, one program on port 10001: 0 = 24 V, 1 = 12 V); say in `settled` how you found out
        "]],
    );
}

#[test]
fn keys_that_no_override_has() {
    wrong(
        r#"
[[override]]
target = "joint_move"
effect = "query"

[[override]]
target = "joint_move"
request = "speed"
maximum = 3
"#,
        &expect![[r"
            newer.toml:4:1: override of `joint_move`: unknown key `effect`; the keys are deadline_ms, doc, reply, request, requires, since, target, until, value, variant
            newer.toml:9:1: override of `joint_move`: unknown key `maximum`; the keys are advised, advisory, ascii, doc, max, min, name, optional, or_raw, reply, request, settled, since, target, type, unit, until, value, variant, wire, written
        "]],
    );
}

#[test]
fn a_command_that_the_spec_has_otherwise() {
    wrong(
        "\n[[command]]\nwire = \"power_on\"\neffect = \"power\"\ndoc = \"Powers.\"\n[[command.reply]]\nwire = \"volts\"\ntype = \"float\"\ndoc = \"Volts.\"\n",
        &expect![[r"
            newer.toml:2:1: command `power_on`: the spec has one of this name by now, and there it has no field `volts`, which your program would notice; delete the entry, and change the rest with `[[extend]]` and `[[override]]`
        "]],
    );
}

#[test]
fn names_that_are_taken() {
    wrong(
        r#"
[[command]]
wire = "jointMove"
name = "joint_move"
effect = "motion"
doc = "Moves."

[[type]]
name = "Pose"
kind = "wrapper"
type = "float"
doc = "Another pose."

[[error]]
wire = 2
name = "Overload"
doc = "Too heavy."
"#,
        &expect![[r"
            newer.toml:4:8: command `joint_move`: the method name `joint_move` is taken already, by the spec that this adds to
            newer.toml:4:8: command `joint_move`: the type name `JointMoveReply` is taken already, by the spec that this adds to
            newer.toml:4:8: command `joint_move`: the type name `JointMove` is taken already, by the spec that this adds to
            newer.toml:8:1: type `Pose`: the spec has one of this name by now, and there it is of another kind, which your program would notice; delete the entry, and change the rest with `[[extend]]` and `[[override]]`
        "]],
    );
}

#[test]
fn a_type_that_comes_to_contain_itself() {
    wrong(
        "\n[[extend]]\ntarget = \"RobotStatus\"\n[[extend.field]]\nwire = \"last\"\ntype = \"RobotStatus\"\noptional = true\ndoc = \"Last.\"\n",
        &expect![[r"
            newer.toml:6:8: extension of `RobotStatus`, field `last`: the type `RobotStatus` contains itself
        "]],
    );
}

#[test]
fn a_field_of_the_status_packet_that_must_be_there() {
    wrong(
        "\n[[extend]]\ntarget = \"RobotStatus\"\n[[extend.field]]\nwire = \"last\"\ntype = \"int\"\ndoc = \"Last.\"\n",
        &expect![[r"
            newer.toml:2:1: extension of `RobotStatus`: a field of the status packet must be optional: its key may not come, or not fit
        "]],
    );
}

#[test]
fn a_value_that_an_enum_has_already_and_a_value_of_no_enum() {
    wrong(
        r#"
[[extend]]
target = "MoveMode"
[[extend.value]]
wire = 0
name = "Target"
doc = "To a target."

[[extend]]
target = "RobotStatus"
[[extend.value]]
wire = 0
name = "Target"
doc = "To a target."
"#,
        &expect![[r"
            newer.toml:4:1: extension of `MoveMode`, value `Target`: the spec has a value of this name or number already
            newer.toml:11:1: extension of `RobotStatus`, value `Target`: `value` is for an enum
        "]],
    );
}

#[test]
fn versions_that_are_none() {
    wrong(
        "\n[[override]]\ntarget = \"joint_move\"\nsince = \"V1.7\"\n",
        &expect![[r"
        newer.toml:4:9: override of `joint_move`: `since` is a version such as 1.5 or 1.6.5
    "]],
    );
}

#[test]
fn the_method_of_a_changed_command_is_taken() {
    let text = r#"
title = "Test"

[[command]]
wire = "joint_move_newer"
effect = "motion"
doc = "Moves."

[[override]]
target = "joint_move"
deadline_ms = 10
"#;
    let pack = load_pack(&spec(), Source { path: "newer.toml", text }).expect("it can be used at run time");
    let errors: Vec<_> = pack.module_errors.iter().map(ToString::to_string).collect();
    expect!["newer.toml:1:1: the method name `joint_move_newer` is that of a changed command in this pack, and of another; rename the file"].assert_eq(&errors.concat());
}

#[test]
fn an_event_with_another_severity() {
    wrong(
        r#"
[[event]]
severity = "information"
codes = ["0x10F0005", "0x0F0033-0x0F0034"]

[[event]]
severity = "error"
codes = ["0x1-0x9", "0x9"]

[[event]]
severity = "error"
codes = ["0xx"]
"#,
        &expect![[r"
            newer.toml:2:1: event: the spec has the code 0x0F0033 already, with the severity `error`
            newer.toml:2:1: event: the spec has the code 0x0F0034 already, with the severity `error`
            newer.toml:8:21: event: the code 0x000009 is taken already, at newer.toml:8:10
            newer.toml:12:10: event: `0xx` is not a code such as 0x0F0034, nor a range such as 0x0F0006-0x0F0009
        "]],
    );
}

#[test]
fn a_reply_that_is_no_object_or_has_no_fields_of_its_own() {
    let command = |reply: &str| {
        format!("\n[[command]]\nwire = \"read_all\"\neffect = \"query\"\nreply = \"{reply}\"\ndoc = \"Reads.\"\n")
    };
    wrong(
        &command("Pose"),
        &expect![[r"
        newer.toml:5:9: command `read_all`: a reply is fields, or an object without the keys that every reply has
    "]],
    );
    wrong(
        &command("Nothing"),
        &expect![[r"
        newer.toml:5:9: command `read_all`: there is no `[[type]]` named `Nothing`
    "]],
    );
    let key = "[[type]]\nname = \"All\"\nkind = \"object\"\ndoc = \"All.\"\n[[type.field]]\nwire = \"errorCode\"\nname = \"code\"\ntype = \"int\"\ndoc = \"Code.\"\n";
    wrong(
        &(command("All") + key),
        &expect![[r"
        newer.toml:5:9: command `read_all`: a reply is fields, or an object without the keys that every reply has
    "]],
    );
    wrong(
        &(command("RobotStatus") + "reply_certain = false\n"),
        &expect![[r"
        newer.toml:2:1: command `read_all`: a reply that may never come can have optional fields only
    "]],
    );
}

#[test]
fn keys_values_and_variants_that_are_taken_or_not_there() {
    wrong(
        r#"
[[override]]
target = "RobotStatus"
field = "inpos"
wire = "paused"

[[override]]
target = "joint_move"
request = "speed"
wire = "cmdName"

[[override]]
target = "Pose"
field = "x"
wire = "x"

[[override]]
target = "MoveMode"
value = 12
advisory = true

[[override]]
target = "Pose"
value = 12
advisory = true

[[override]]
target = "MoveMode"
value = 1
name = "Absolute"

[[extend]]
target = "jog"
[[extend.variant]]
wire = 1
name = "Turn"
doc = "Turns."

[[extend]]
target = "joint_move"
[[extend.variant]]
wire = 1
name = "Turn"
doc = "Turns."
"#,
        &expect![[r"
            newer.toml:2:1: override of `RobotStatus`: another field has the key `paused`
            newer.toml:10:8: override of `joint_move`: the key `cmdName` is that of the tag, or of what each message has
            newer.toml:12:1: override of `Pose`: an element of an array has no key
            newer.toml:19:9: override of `MoveMode`: there is no value `12`; there are 0, 1
            newer.toml:22:1: override of `Pose`: `Pose` is not an enum
            newer.toml:27:1: override of `MoveMode`: another value has the name `Absolute`
            newer.toml:34:1: extension of `jog`, variant `Turn`: the spec has one of this name by now, and there the required fields are `frame`, `axis`, `velocity`, which your program would notice; delete the entry, and change the rest with `[[extend]]` and `[[override]]`
            newer.toml:41:1: extension of `joint_move`, variant `Turn`: `variant` is for a command or a type with variants
        "]],
    );
}
