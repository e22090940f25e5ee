//! Commands that packs add and change, called against a simulated controller that knows the same packs.

use expect_test::{Expect, expect};

use crate::program::{jaka, pack, scratch};

fn check(pack_name: &str, line: &str, expected: &Expect) {
    let options = ["call".to_owned(), "--sim".to_owned(), "--pack".to_owned(), pack(pack_name)];
    expected.assert_eq(&jaka(options.into_iter().chain(line.split(' ').map(str::to_owned))).text());
}

#[test]
fn new_commands_are_called_by_either_name() {
    check(
        "newer.toml",
        "demo_motion_state",
        &expect![[r"
        in_position   true
        paused        false
        queue         3
        active_queue  1
        exit code 0
    "]],
    );
    check(
        "newer.toml",
        "demo_stop_state",
        &expect![[r"
        emergency_stop  false
        exit code 0
    "]],
    );
    check(
        "newer.toml",
        "set_demo_period --period 20",
        &expect![[r"
        accepted
        exit code 0
    "]],
    );
    check(
        "newer.toml",
        "demo_set_period --period 0",
        &expect![[r"
        error: `demo_set_period` was not sent:
          field `period` is 0; allowed is a whole number, at least 1 ms
        exit code 2
    "]],
    );
}

#[test]
fn changed_commands_take_what_the_pack_says() {
    check(
        "changed.toml",
        "rapid_rate --rate 1.4",
        &expect![[r"
        accepted
        exit code 0
    "]],
    );
    check(
        "changed.toml",
        "set_tio_vout_param --output-enable 1 --output-voltage v12 --dry-run",
        &expect![[r#"
        {"cmdName":"set_tio_vout_param","tio_vout_ena":1,"tio_vout_vol":1}
        exit code 0
    "#]],
    );
    check(
        "changed.toml",
        "joint_move --mode relative --joint-position 0,0,0,0,0,0 --speed 1 --zone 5 --sim-powered",
        &expect![[r"
            accepted
            exit code 0
        "]],
    );
}

#[test]
fn fields_give_way_to_options_of_the_same_name() {
    let file = scratch("names.toml");
    let field = |name| format!("[[command.request]]\nwire = '{name}'\ntype = 'int'\ndoc = 'D.'\n");
    let command = "title = 'T'\n[[command]]\nwire = 'new_one'\neffect = 'query'\ndoc = 'D.'\n";
    let text = command.to_owned() + &field("json") + &field("help") + &field("speed");
    std::fs::write(&file, text).expect("the folder is there");
    let line = "call new_one --field-json 1 --field-help 2 --speed 3 --dry-run --json --pack";
    let run = jaka(line.split(' ').map(str::to_owned).chain([file.display().to_string()]));
    expect![[r#"
        {"cmdName":"new_one","json":1,"help":2,"speed":3}
        exit code 0
    "#]]
    .assert_eq(&run.text());
}

/// Output of a line of a command with fields named `color` and `timeout`, which is optional.
fn run_with_names_of_options(file: &str, line: &str) -> String {
    let file = scratch(file);
    let field = |name, more| format!("[[command.request]]\nwire = '{name}'\ntype = 'text'\ndoc = 'D.'\n{more}");
    let command = "title = 'T'\n[[command]]\nwire = 'new_one'\neffect = 'query'\ndoc = 'D.'\n";
    let text = command.to_owned() + &field("color", "") + &field("timeout", "optional = true\n");
    std::fs::write(&file, text).expect("the folder is there");
    let words = line.split(' ').map(str::to_owned);
    jaka(["call".to_owned(), "--pack".to_owned(), file.display().to_string()].into_iter().chain(words)).text()
}

#[test]
fn an_option_that_is_taken_for_a_field_is_explained() {
    expect![[r"
        error: `--color <WHEN>` cannot be `red`: it is one of `auto`, `always`, `never`
        hint: `jaka call --help` lists commands and options
        hint: `--color` is an option of `jaka call`; the field `color` is given by `--field-color`, or by --params
        exit code 2
    "]]
    .assert_eq(&run_with_names_of_options("options.toml", "new_one --color red --dry-run"));
    expect![[r"
        error: `new_one` was not sent:
          field `color` is missing; allowed is text
        hint: `--color` is an option of `jaka call`; the field `color` is given by `--field-color`, or by --params
        exit code 2
    "]]
    .assert_eq(&run_with_names_of_options("options.toml", "new_one --color=never --timeout 5 --dry-run"));
    expect![[r#"
        {"cmdName":"new_one","color":"red"}
        note: `--timeout` is an option of `jaka call`; the field `timeout` is given by `--field-timeout`, or by --params
        exit code 0
    "#]]
    .assert_eq(&run_with_names_of_options(
        "options.toml",
        "new_one --color never --field-color red --timeout 5 --dry-run",
    ));
    expect![[r#"
        {"cmdName":"new_one","color":"red"}
        exit code 0
    "#]]
    .assert_eq(&run_with_names_of_options("options.toml", r#"new_one --params {"color":"red"} --dry-run"#));
}

#[test]
fn the_help_explains_fields_with_names_of_options() {
    let help = run_with_names_of_options("options_help.toml", "new_one -h");
    let fields = help.split("Fields:").nth(1).and_then(|rest| rest.split("Options").next());
    expect![[r"

              --field-color <TEXT>    D. [required] [`--color` is an option of `jaka call`]
              --field-timeout <TEXT>  D. [`--timeout` is an option of `jaka call`]
        exit code 0
    "]]
    .assert_eq(fields.unwrap_or(&help));
}
