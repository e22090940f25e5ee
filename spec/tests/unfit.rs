//! Packs of which no code could be made that compiles and works: each is an error at its place.

use expect_test::{Expect, expect};
use jaka_spec::{Pack, Source, builtin, load_pack};

fn load(path: &str, text: &str) -> Result<Pack, String> {
    let spec = builtin().expect("the built-in spec is correct");
    let text = format!("title = \"Test\"{text}");
    load_pack(&spec, Source { path, text: &text }).map_err(|errors| errors.to_string() + "\n")
}

/// Loads a wrong pack and compares the errors. A line for the title is put before `text`.
fn wrong(text: &str, expected: &Expect) {
    expected.assert_eq(&load("newer.toml", text).err().unwrap_or_default());
}

/// The errors of a pack with one command, `go`, which has this field.
fn field(field: &str, expected: &Expect) {
    let text = format!(
        "\n[[command]]\nwire = 'go'\neffect = 'query'\ndoc = 'Goes.'\nrequest = [{{ wire = 'a', doc = 'A.', {field} }}]\n"
    );
    wrong(&text, expected);
}

#[test]
fn names_of_rust_of_the_generated_code_and_of_clients() {
    wrong(
        r#"
[[command]]
wire = "result"
effect = "query"
doc = "Its request would be `Result`."

[[command]]
wire = "last_reply"
effect = "query"
doc = "A client has such a method."

[[command]]
wire = "a_b_c"
effect = "query"
doc = "Its request is `ABC`."

[[type]]
name = "NewerCommands"
kind = "wrapper"
type = "int"
doc = "Named as the trait."

[[type]]
name = "DisableRobotReply"
kind = "wrapper"
type = "int"
doc = "Named as a reply would be that a pack gives a field."

[[type]]
name = "Pick"
kind = "choice"
doc = "A choice."
variant = [{ wire = 0, name = "Other", doc = "Named as the variant for the rest." }]

[[error]]
wire = 99
name = "Abc"
doc = "Its constant would be `ABC`."
"#,
        &expect![[r"
            newer.toml:3:8: command `result`: `Result` is a name of Rust or of the generated code; take another `name`
            newer.toml:8:8: command `last_reply`: clients and robots have a method `last_reply`; give another as `name`
            newer.toml:18:8: type `NewerCommands`: `NewerCommands` is a name of Rust or of the generated code; take another `name`
            newer.toml:24:8: type `DisableRobotReply`: the type name `DisableRobotReply` is taken already, by the spec that this adds to
            newer.toml:33:12: type `Pick`, variant `Other`: `Other` is the variant for values that the spec does not list
            newer.toml:37:8: error code `Abc`: the constant `ABC` is taken already, at newer.toml:13:8
        "]],
    );
}

#[test]
fn names_that_are_none() {
    wrong(
        r#"
[[command]]
wire = "go"
effect = "query"
doc = "Goes."
request = [{ wire = "a", name = "", type = "int", doc = "A." }]

[[type]]
name = "Row"
kind = "array"
doc = "A row."
field = [{ type = "int", doc = "Without a name." }, { name = 3, type = "int", doc = "Three." }]

[[override]]
target = "rapid_rate"
request = "rate_value"
name = ""

[[override]]
target = "rapid_rate"
doc = ""
"#,
        &expect![[r"
            newer.toml:6:33: command `go`, field ``: `name` is empty
            newer.toml:12:10: type `Row`, field: `name` is missing
            newer.toml:12:53: type `Row`, field `3`: the name `` is taken already, at newer.toml:12:10
            newer.toml:12:62: type `Row`, field `3`: `name` must be a string
            newer.toml:17:8: override of `rapid_rate`: `name` is empty
            newer.toml:21:7: override of `rapid_rate`: `doc` is empty
        "]],
    );
}

#[test]
fn a_file_with_a_name_of_rust() {
    let text = "\n[[error]]\nwire = 99\nname = \"Overload\"\ndoc = \"Too heavy.\"\n";
    let pack = load("packs/bool.toml", text).unwrap_or_else(|errors| panic!("{errors}"));
    let errors: Vec<_> = pack.module_errors.iter().map(ToString::to_string).collect();
    expect!["packs/bool.toml:1:1: the file's name is that of a module, and `bool` is a name of Rust"]
        .assert_eq(&errors.concat());
}

#[test]
fn a_file_whose_name_makes_a_method_of_the_spec() {
    let text = "\n[[override]]\ntarget = \"get_payload\"\ndeadline_ms = 10\n\n[[override]]\ntarget = \"set_payload\"\nsince = \"1.7\"\n";
    assert!(load("newer.toml", text).is_ok());
    let text = "\n[[override]]\ntarget = \"quit\"\ndeadline_ms = 10\n[[command]]\nwire = \"quit_newer\"\neffect = \"query\"\ndoc = \"Quits.\"\n";
    let pack = load("newer.toml", text).unwrap_or_else(|errors| panic!("{errors}"));
    let errors: Vec<_> = pack.module_errors.iter().map(ToString::to_string).collect();
    expect!["newer.toml:1:1: the method name `quit_newer` is that of a changed command in this pack, and of another; rename the file"].assert_eq(&errors.concat());
}

#[test]
fn keys_that_each_message_has_and_the_tag() {
    wrong(
        r#"
[[command]]
wire = " go "
name = "go"
effect = "query"
doc = "Goes."
request = [{ wire = "cmdName", name = "name", type = "text", doc = "Name." }]
reply = [{ wire = "errorCode", name = "code", type = "int", doc = "Code." }]

[[command]]
wire = "choose"
effect = "query"
doc = "Chooses."

[command.choice]
tag = "kind"
variant = [{ wire = 0, name = "A", doc = "A.", field = [{ wire = "kind", type = "int", doc = "Kind." }] }]

[[command]]
wire = "pick"
effect = "query"
doc = "Picks."

[command.choice]
tag = "cmdName"
variant = [{ wire = 0, name = "A", doc = "A." }]

[[extend]]
target = "jog"
variant = "Stop"
request = [{ wire = "jog_mode", type = "int", doc = "Mode." }]

[[extend]]
target = "power_on"
reply = [{ wire = "errorMsg", name = "message", type = "text", doc = "Message." }]
"#,
        &expect![[r"
            newer.toml:3:8: command `go`: blanks around a command's name are lost in replies, which are read without them
            newer.toml:7:21: command `go`, field `name`: the key `cmdName` is that of the tag, or of what each message has
            newer.toml:8:19: command `go`, reply field `code`: the key `errorCode` is that of the tag, or of what each message has
            newer.toml:17:66: command `choose`, choice `kind`, variant `A`, field `kind`: the key `kind` is that of the tag, or of what each message has
            newer.toml:25:7: command `pick`, choice `cmdName`: each message has this key, for its command's name
            newer.toml:31:21: extension of `jog`, field `jog_mode`: the key `jog_mode` is that of the tag, or of what each message has
            newer.toml:35:19: extension of `power_on`, field `message`: the key `errorMsg` is that of the tag, or of what each message has
        "]],
    );
}

#[test]
fn truth_values_that_cannot_be_distinguished() {
    wrong(
        r#"
[[command]]
wire = "go"
effect = "query"
doc = "Goes."
request = [
    { wire = "a", type = "bool", written = ["ON", "on"], doc = "A." },
    { wire = "b", type = "bool", written = [1, "1"], doc = "B." },
    { wire = "c", type = "bool", written = ["1", "01"], doc = "C." },
    { wire = "d", type = "bool", written = [true, false], doc = "D." },
    { wire = "e", type = "bool", written = ["True", 0], doc = "E." },
    { wire = "f", type = "bool", written = [" no", "yes"], doc = "F." },
    { wire = "g", type = "bool", written = ["a\nb", "yes"], doc = "G." },
    { wire = "h", type = "bool", written = [1, 0], doc = "These can." },
]
"#,
        &expect![[r"
            newer.toml:7:44: command `go`, field `a`: `written` gives a bool's two forms, which are read in any case: how false is written, then true
            newer.toml:8:44: command `go`, field `b`: `written` gives a bool's two forms, which are read in any case: how false is written, then true
            newer.toml:9:44: command `go`, field `c`: `written` gives a bool's two forms, which are read in any case: how false is written, then true
            newer.toml:10:44: command `go`, field `d`: `written` gives a bool's two forms, which are read in any case: how false is written, then true
            newer.toml:11:44: command `go`, field `e`: `written` gives a bool's two forms, which are read in any case: how false is written, then true
            newer.toml:12:44: command `go`, field `f`: `written` gives a bool's two forms, which are read in any case: how false is written, then true
            newer.toml:13:44: command `go`, field `g`: `written` gives a bool's two forms, which are read in any case: how false is written, then true
        "]],
    );
}

#[test]
fn forms_that_are_read_only_under_a_key() {
    wrong(
        r#"
[[command]]
wire = "go"
effect = "query"
doc = "Goes."
request = [
    { wire = "a", type = "bool[]", written = [1, 0], doc = "A." },
    { wire = "b", type = "bool", written = ["no", "yes"], or_raw = true, doc = "B." },
    { wire = "c", type = "python(int)[]", doc = "C." },
    { wire = "d", type = "python(python(int))", doc = "D." },
    { wire = "e", type = "python(int)", or_raw = true, doc = "E." },
    { wire = "f", type = "python(bool)", written = ["no", "yes"], doc = "F." },
]

[[type]]
name = "Row"
kind = "array"
doc = "A row."
field = [{ name = "a", type = "python(int)", doc = "A." }]

[[type]]
name = "Literal"
kind = "wrapper"
type = "python(int)"
doc = "A literal."

[[type]]
name = "Flag"
kind = "wrapper"
type = "bool"
written = ["no", "yes"]
doc = "A flag."
"#,
        &expect![[r"
            newer.toml:7:5: command `go`, field `a`: words for false and true, and python(…), are read only as the whole of a field that has a key and no `or_raw`
            newer.toml:8:5: command `go`, field `b`: words for false and true, and python(…), are read only as the whole of a field that has a key and no `or_raw`
            newer.toml:9:5: command `go`, field `c`: words for false and true, and python(…), are read only as the whole of a field that has a key and no `or_raw`
            newer.toml:10:5: command `go`, field `d`: words for false and true, and python(…), are read only as the whole of a field that has a key and no `or_raw`
            newer.toml:11:5: command `go`, field `e`: words for false and true, and python(…), are read only as the whole of a field that has a key and no `or_raw`
            newer.toml:12:5: command `go`, field `f`: words for false and true, and python(…), are read only as the whole of a field that has a key and no `or_raw`
            newer.toml:19:10: type `Row`, field `a`: words for false and true, and python(…), are read only as the whole of a field that has a key and no `or_raw`
            newer.toml:21:1: type `Literal`: words for false and true, and python(…), are read only as the whole of a field that has a key and no `or_raw`
            newer.toml:27:1: type `Flag`: words for false and true, and python(…), are read only as the whole of a field that has a key and no `or_raw`
        "]],
    );
}

#[test]
fn what_may_be_absent_before_what_may_not() {
    wrong(
        r#"
[[override]]
target = "Pose"
field = "x"
optional = true

[[override]]
target = "shutdown"
reply_certain = false

[[command]]
wire = "go"
effect = "power"
reply_certain = false
doc = "Goes."
reply = [{ wire = "a", type = "int", doc = "A." }]

[[extend]]
target = "shutdown"
reply = [{ wire = "a", type = "int", doc = "A." }]
"#,
        &expect![[r"
            newer.toml:2:1: override of `Pose`: an element after an optional one must be optional too
            newer.toml:9:1: override of `shutdown`: unknown key `reply_certain`; the keys are deadline_ms, doc, reply, request, requires, since, target, until, value, variant
            newer.toml:11:1: command `go`: a reply that may never come can have optional fields only
            newer.toml:18:1: extension of `shutdown`: a reply that may never come can have optional fields only
        "]],
    );
}

#[test]
fn elements_become_optional_in_any_order() {
    let entry = |field: &str| format!("\n[[override]]\ntarget = \"Pose\"\nfield = \"{field}\"\noptional = true\n");
    assert!(load("newer.toml", &(entry("ry") + &entry("rz"))).is_ok());
}

#[test]
fn types_that_are_too_large_or_too_deep() {
    field(
        "type = 'float[64][64][2]'",
        &expect![[r"
        newer.toml:6:45: command `go`, field `a`: the type `float[64][64][2]` holds more than 4096 values, or more than 32 types in each other
    "]],
    );
    field(
        "type = 'RobotStatus[64]'",
        &expect![[r"
        newer.toml:6:45: command `go`, field `a`: the type `RobotStatus[64]` holds more than 4096 values, or more than 32 types in each other
    "]],
    );
    field(
        &format!("type = 'int{}'", "[]".repeat(100_000)),
        &expect![[r"
        newer.toml:6:45: command `go`, field `a`: a type has at most 4 brackets
    "]],
    );
    field(
        &format!("type = '{}int'", "python(".repeat(9)),
        &expect![[r"
        newer.toml:6:45: command `go`, field `a`: a type has at most 4 brackets
    "]],
    );
    let twice = |n: u32| {
        format!(
            "[[type]]\nname = 'T{n}'\nkind = 'object'\ndoc = 'T.'\nfield = [{{ wire = 'a', type = 'T{next}', doc = 'A.' }}, {{ wire = 'b', type = 'T{next}', doc = 'B.' }}]\n",
            next = n + 1
        )
    };
    let chain: String = (0..40).map(twice).collect();
    let last = "[[type]]\nname = 'T40'\nkind = 'wrapper'\ntype = 'int'\ndoc = 'T.'\n";
    let errors = load("newer.toml", &format!("\n{chain}{last}")).expect_err("it holds 2 to the 40th values");
    expect!["newer.toml:6:31: type `T0`, field `a`: the type `T1` holds more than 4096 values, or more than 32 types in each other"].assert_eq(errors.lines().next().unwrap_or_default());
}

#[test]
fn what_is_repeated_and_changed_is_changed() {
    let text = "\n[[command]]\nwire = \"get_loaded_program\"\neffect = \"query\"\ndoc = \"Reads.\"\nreply = [{ wire = \"programName\", name = \"program_name\", type = \"text\", doc = \"Name.\" }]\n\n[[override]]\ntarget = \"get_loaded_program\"\ndeadline_ms = 10\n";
    let module = load("newer.toml", text).expect("the pack is correct").module();
    assert!(module.changed.contains("get_loaded_program"));
    assert!(module.covered_commands.is_empty());
}

#[test]
fn a_bare_reply_follows_its_field_s_name() {
    let text = "\n[[override]]\ntarget = \"get_extio_status\"\nreply = \"extio_status\"\nname = \"modules\"\n";
    let spec = load("newer.toml", text).expect("the pack is correct").spec;
    let command = spec.command("get_extio_status").expect("the spec has it");
    assert_eq!(command.bare_reply.as_deref(), Some("modules"));
}
