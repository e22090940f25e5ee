//! What users read when a spec is wrong: every error at once, each at its place.

use expect_test::{Expect, expect};
use jaka_spec::{Source, load, load_pack};

/// Loads `text` as `spec/test.toml` and compares the errors.
fn check(text: &str, expected: &Expect) {
    let errors = match load(&[Source { path: "spec/test.toml", text }]) {
        Ok(_) => String::new(),
        Err(errors) => errors.to_string() + "\n",
    };
    expected.assert_eq(&errors);
}

#[test]
fn a_correct_file_has_no_errors() {
    check(
        r#"
title = "Test"

[[command]]
wire = "demo_motion_state"
effect = "query"
doc = "Reads how the motion stands."

[[command.reply]]
wire = "inpos"
name = "in_position"
type = "bool"
doc = "Whether the arm is in position."
"#,
        &expect![[""]],
    );
}

#[test]
fn syntax_errors_stand_at_their_place_and_do_not_hide_each_other() {
    check(
        "title = \"Test\nother = 1\nthird = = 2\n",
        &expect![[r#"
            spec/test.toml:1:14: not valid TOML: invalid basic string, expected `"`
            spec/test.toml:2:1: unknown key `other`; the keys are command, doc, error, event, title, title_zh, type
            spec/test.toml:3:1: unknown key `third`; the keys are command, doc, error, event, title, title_zh, type
            spec/test.toml:3:9: not valid TOML: extra `=`, expected nothing
            spec/test.toml:3:11: not valid TOML: unexpected key or value, expected newline, `#`
        "#]],
    );
}

#[test]
fn keys_that_are_missing_unknown_or_of_the_wrong_type() {
    check(
        r#"
title = 7

[[command]]
wire = "move"
efect = "motion"
deadline_ms = "soon"
requires = ["powered", "awake"]
doc = ""

[[command.request]]
wire = "speed"
type = "float"
min = "zero"
units = "mm/s"
doc = "Speed."
"#,
        &expect![[r"
            spec/test.toml:2:9: `title` must be a string
            spec/test.toml:4:1: command `move`: `effect` is missing
            spec/test.toml:5:8: command `move`: `move` is not a snake_case Rust name; give one as `name`
            spec/test.toml:6:1: command `move`: unknown key `efect`; is it `effect`?
            spec/test.toml:7:15: command `move`: `deadline_ms` must be a whole number
            spec/test.toml:8:24: command `move`: `requires` is one of powered, enabled, servo_mode, not_servo_mode, not `awake`
            spec/test.toml:9:7: command `move`: `doc` is empty
            spec/test.toml:14:7: command `move`, field `speed`: `min` must be a finite number
            spec/test.toml:15:1: command `move`, field `speed`: unknown key `units`; is it `unit`?
        "]],
    );
}

#[test]
fn types_that_do_not_exist_or_contain_themselves() {
    check(
        r#"
title = "Test"

[[command]]
wire = "go"
effect = "motion"
doc = "Goes."

[[command.request]]
wire = "a"
type = "Poise"
doc = "A."

[[command.request]]
wire = "b"
type = "flaot[6]"
doc = "B."

[[command.request]]
wire = "c"
type = "float[0]"
doc = "C."

[[command.request]]
wire = "d"
type = "Node"
advised = [{ max = 1 }]
doc = "D."

[[type]]
name = "Node"
kind = "object"
doc = "A node."

[[type.field]]
wire = "next"
type = "Node[]"
doc = "The next ones."
"#,
        &expect![[r"
            spec/test.toml:11:8: command `go`, field `a`: there is no `[[type]]` named `Poise`
            spec/test.toml:16:8: command `go`, field `b`: `flaot` is not a type; a type is bool, int, float, text, json, the name of a `[[type]]`, one of these with `[]` or `[6]` after it, or python(…) around one
            spec/test.toml:21:8: command `go`, field `c`: `0` is not an array length from 1 to 64
            spec/test.toml:26:8: command `go`, field `d`: the type `Node` contains itself
            spec/test.toml:37:8: type `Node`, field `next`: the type `Node` contains itself
        "]],
    );
}

#[test]
fn types_nest_a_few_levels_deep() {
    let field = |ty: &str| format!("title = 'T'\n[[type]]\nname = 'A'\nkind = 'wrapper'\ntype = '{ty}'\ndoc = 'A.'\n");
    check(
        &field("python(float[6][][2])"),
        &expect![[r"
            spec/test.toml:2:1: type `A`: words for false and true, and python(…), are read only as the whole of a field that has a key and no `or_raw`
        "]],
    );
    let expected = expect![[r"
        spec/test.toml:5:8: type `A`: a type has at most 4 brackets
    "]];
    check(&field(&format!("float{}", "[]".repeat(5))), &expected);
    check(&field(&format!("float{}", "[]".repeat(100_000))), &expected);
    check(&field(&"python(".repeat(100_000)), &expected);
}

#[test]
fn names_that_are_taken() {
    check(
        r#"
title = "Test"

[[command]]
wire = "go"
section = "4.1"
effect = "motion"
doc = "Goes."

[[command.request]]
wire = "speed"
type = "float"
doc = "Speed."

[[command.request]]
wire = "speed"
type = "float"
doc = "Speed again."

[[command]]
wire = "go"
section = "4.1"
effect = "motion"
doc = "Goes again."

[[type]]
name = "Go"
kind = "enum"
doc = "The name of the command's struct."

[[type.value]]
wire = 0
name = "Other"
doc = "Taken by the generator."

[[type]]
name = "Result"
kind = "wrapper"
type = "int"
doc = "The name of Rust's own."

[[error]]
wire = 1
name = "A"
doc = "A."

[[error]]
wire = 1
name = "A"
doc = "A again."
"#,
        &expect![[r"
            spec/test.toml:16:8: command `go`, field `speed`: the key `speed` is taken already, at spec/test.toml:11:8
            spec/test.toml:16:8: command `go`, field `speed`: the name `speed` is taken already, at spec/test.toml:11:8
            spec/test.toml:21:8: command `go`: the cmdName `go` is taken already, at spec/test.toml:5:8
            spec/test.toml:21:8: command `go`: the method name `go` is taken already, at spec/test.toml:5:8
            spec/test.toml:21:8: command `go`: the type name `GoReply` is taken already, at spec/test.toml:5:8
            spec/test.toml:21:8: command `go`: the type name `Go` is taken already, at spec/test.toml:5:8
            spec/test.toml:22:11: command `go`: the section `4.1` is taken already, at spec/test.toml:6:11
            spec/test.toml:27:8: type `Go`: the type name `Go` is taken already, at spec/test.toml:5:8
            spec/test.toml:33:8: type `Go`, value `Other`: `Other` is the variant for values that the spec does not list
            spec/test.toml:37:8: type `Result`: `Result` is a name of Rust or of the generated code; take another `name`
            spec/test.toml:48:8: error code `A`: the code `1` is taken already, at spec/test.toml:43:8
            spec/test.toml:49:8: error code `A`: the name `A` is taken already, at spec/test.toml:44:8
        "]],
    );
}

#[test]
fn ranges_forms_and_readings_that_make_no_sense() {
    check(
        r#"
title = "Test"

[[command]]
wire = "go"
effect = "motion"
doc = "Goes."

[[command.request]]
wire = "a"
type = "int"
min = 2
max = 1
doc = "A."

[[command.request]]
wire = "b"
type = "text"
max = 1
doc = "B."

[[command.request]]
wire = "c"
type = "bool"
written = [1, 1]
doc = "C."

[[command.request]]
wire = "d"
type = "int"
disputed = ["only one"]
ascii = true
doc = "D."

[[command.request]]
wire = "key"
type = "int"
advisory = true
doc = "E."

[[type]]
name = "Row"
kind = "array"
doc = "A row."

[[type.field]]
name = "first"
type = "int"
optional = true
doc = "First."

[[type.field]]
name = "second"
type = "int"
doc = "Second."
"#,
        &expect![[r"
            spec/test.toml:9:1: command `go`, field `a`: `min` is greater than `max`
            spec/test.toml:16:1: command `go`, field `b`: `min`, `max` and `advisory` are for numbers
            spec/test.toml:25:11: command `go`, field `c`: `written` gives a bool's two forms, which are read in any case: how false is written, then true
            spec/test.toml:28:1: command `go`, field `d`: `ascii` is for text
            spec/test.toml:28:1: command `go`, field `d`: `disputed` lists the readings of at least two sources
            spec/test.toml:35:1: command `go`, field `key`: `advisory` is for a range: give `min` or `max`
            spec/test.toml:36:8: command `go`, field `key`: `key` is a name of the generated code; give another as `name`
            spec/test.toml:52:1: type `Row`, field `second`: an element after an optional one must be optional too
        "]],
    );
}

#[test]
fn what_is_advised_makes_no_sense() {
    check(
        r#"
title = "Test"

[[type]]
name = "Way"
kind = "enum"
doc = "A way."
value = [{ wire = 0, name = "Here", doc = "Here." }, { wire = 1, name = "There", doc = "There." }]

[[type]]
name = "Place"
kind = "array"
doc = "A place."
field = [
    { name = "x", type = "float", unit = "mm", advised = [{ max = 1 }], doc = "X." },
    { name = "y", type = "float", unit = "mm", doc = "Y." },
]

[[command]]
wire = "zero"
effect = "motion"
doc = "The row itself."
request = [{ wire = "a", type = "int", advised = [{ max = 0, is = 1 }, { nonzero = true, min = 0 }], doc = "A." }]

[[command]]
wire = "text"
effect = "motion"
doc = "Not a number."
request = [{ wire = "a", type = "text", advised = [{ max = 1 }], doc = "A." }]

[[command]]
wire = "unit"
effect = "motion"
doc = "No number of the unit."
request = [{ wire = "a", type = "Place", advised = [{ max = 1, unit = "deg" }], doc = "A." }]

[[command]]
wire = "twice"
effect = "motion"
doc = "Two rows at the same time."
request = [{ wire = "a", type = "int", advised = [{ max = 1 }, { max = 2 }], doc = "A." }]

[[command]]
wire = "when"
effect = "motion"
doc = "Rows with and without a condition."
request = [
    { wire = "way", type = "Way", doc = "The way." },
    { wire = "a", type = "int", advised = [{ max = 1 }, { when = "way", is = 0, max = 2 }], doc = "A." },
]

[[command]]
wire = "value"
effect = "motion"
doc = "A value that is not listed."
request = [
    { wire = "way", type = "Way", doc = "The way." },
    { wire = "a", type = "int", advised = [{ when = "way", is = 2, max = 2 }], doc = "A." },
]

[[command]]
wire = "absent"
effect = "motion"
doc = "A field that may be left out."
request = [
    { wire = "way", type = "Way", optional = true, doc = "The way." },
    { wire = "a", type = "int", advised = [{ when = "way", is = 1, max = 2 }], doc = "A." },
]

[[command]]
wire = "count"
effect = "motion"
doc = "A count that is not one."
request = [{ wire = "a", type = "int", advised = [{ per = "b", max = 2 }], doc = "A." }, { wire = "b", type = "float", doc = "B." }]
"#,
        &expect![[r"
            spec/test.toml:10:1: type `Place`: `advised` of `x`: it is for fields that have a key
            spec/test.toml:19:1: command `zero`: `advised` of `a`: rows that hold at the same time have each a `unit` of their own
            spec/test.toml:23:51: command `zero`, field `a`, `advised`: `max` is the greatest magnitude, a number over 0
            spec/test.toml:23:51: command `zero`, field `a`, `advised`: `when` names a field and `is` its value: give both or neither
            spec/test.toml:23:72: command `zero`, field `a`, `advised`: `max` is the greatest magnitude, a number over 0
            spec/test.toml:23:90: command `zero`, field `a`, `advised`: unknown key `min`; the keys are is, max, nonzero, per, unit, when
            spec/test.toml:25:1: command `text`: `advised` of `a`: the field has no number
            spec/test.toml:31:1: command `unit`: `advised` of `a`: the field has no number in deg
            spec/test.toml:37:1: command `twice`: `advised` of `a`: rows that hold at the same time have each a `unit` of their own
            spec/test.toml:43:1: command `when`: `advised` of `a`: all rows have a `when`, or none
            spec/test.toml:52:1: command `value`: `advised` of `a`: there is no field `way` that is always there and an enum with the value 2
            spec/test.toml:61:1: command `absent`: `advised` of `a`: there is no field `way` that is always there and an enum with the value 1
            spec/test.toml:70:1: command `count`: `advised` of `a`: there is no field `b` that is a whole number
        "]],
    );
}

#[test]
fn choices_and_enums_that_are_empty_or_ambiguous() {
    check(
        r#"
title = "Test"

[[command]]
wire = "go"
effect = "motion"
since = "new"
doc = "Goes."

[command.choice]
tag = "mode"

[[command.choice.variant]]
wire = 0
name = "Stop"
doc = "Stops."

[[command.choice.variant]]
wire = 0
name = "Stop"
doc = "Stops again."

[[command.example]]

[[type]]
name = "Empty"
kind = "enum"
doc = "An enum without values."

[[type]]
name = "Odd"
kind = "struct"
doc = "A kind that does not exist."
"#,
        &expect![[r"
            spec/test.toml:7:9: command `go`: `since` is a version such as 1.5 or 1.6.5
            spec/test.toml:19:8: command `go`, choice `mode`, variant `Stop`: the tag value `0` is taken already, at spec/test.toml:14:8
            spec/test.toml:20:8: command `go`, choice `mode`, variant `Stop`: the name `Stop` is taken already, at spec/test.toml:15:8
            spec/test.toml:23:1: command `go`, example: an example has a `request`, a `reply` or both
            spec/test.toml:25:1: type `Empty`: an enum needs at least one `value`
            spec/test.toml:32:8: type `Odd`: `kind` is one of object, array, enum, choice, wrapper, not `struct`
        "]],
    );
}

#[test]
fn versions_that_are_none_or_in_the_wrong_order() {
    let command = |wire: &str, versions: &str| {
        format!("[[command]]\nwire = \"{wire}\"\neffect = \"query\"\ndoc = \"Reads.\"\n{versions}\n")
    };
    let text = [
        "title = \"Test\"\n".to_owned(),
        command("signed", "since = \"1.+5\""),
        command("five_numbers", "until = \"1.7.1.46.2\""),
        command("too_great", "since = \"1.4294967296\""),
        command("later", "since = \"1.7\"\nuntil = \"1.6.5\""),
        command("within", "since = \"1.6.5\"\nuntil = \"1.6\""),
        command("at_once", "since = \"1.6\"\nuntil = \"1.6\""),
        command("ten_is_after_nine", "since = \"1.5.9\"\nuntil = \"1.5.10\""),
    ];
    check(
        &text.concat(),
        &expect![[r"
            spec/test.toml:6:9: command `signed`: `since` is a version such as 1.5 or 1.6.5
            spec/test.toml:11:9: command `five_numbers`: `until` is a version such as 1.5 or 1.6.5
            spec/test.toml:16:9: command `too_great`: `since` is a version such as 1.5 or 1.6.5
            spec/test.toml:17:1: command `later`: `since` is later than `until`
        "]],
    );
}

#[test]
fn the_versions_of_an_override_are_checked_with_those_that_it_keeps() {
    let text = r#"
title = "Test"

[[command]]
wire = "go"
effect = "motion"
since = "1.7"
doc = "Goes."
"#;
    let base = load(&[Source { path: "spec/test.toml", text }]).expect("the spec is correct");
    let pack = "title = \"Pack\"\n\n[[override]]\ntarget = \"go\"\nuntil = \"1.6\"\n";
    let errors = load_pack(&base, Source { path: "pack.toml", text: pack }).expect_err("no version is left");
    expect!["pack.toml:3:1: override of `go`: `since` is later than `until`"].assert_eq(&errors.to_string());
}

#[test]
fn errors_of_several_files_come_together() {
    let sources =
        [Source { path: "spec/b.toml", text: "titel = 1" }, Source { path: "spec/a.toml", text: "title = \"\"" }];
    let errors = load(&sources).expect_err("both files are wrong");
    expect![[r"
        spec/a.toml:1:9: `title` is empty
        spec/b.toml:1:1: `title` is missing
        spec/b.toml:1:1: unknown key `titel`; is it `title`?"]]
    .assert_eq(&errors.to_string());
}

#[test]
fn columns_count_characters() {
    check(
        "title = \"中文\" \u{e9} = 1\n",
        &expect![[r"
        spec/test.toml:1:14: not valid TOML: unexpected key or value, expected newline, `#`
    "]],
    );
}

#[test]
fn the_built_in_spec_is_correct() {
    if let Err(errors) = jaka_spec::builtin() {
        panic!("{errors}");
    }
}
