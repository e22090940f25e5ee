//! Checks of a line, before anything is sent.

use expect_test::{Expect, expect};

use crate::program::{command, jaka, pack, run, scratch};

fn check(line: &str, expected: &Expect) {
    expected.assert_eq(&jaka(["call"].into_iter().chain(line.split(' '))).text());
}

#[test]
fn unknown_commands_suggest_the_nearest() {
    check(
        "joint_mov --speed 1",
        &expect![[r"
            error: there is no command `joint_mov`
            hint: `jaka call --list` lists the commands; --pack adds commands, and --raw sends a command that is not in the spec
            exit code 2
        "]],
    );
    check(
        "zzzzzzzz",
        &expect![[r"
            error: there is no command `zzzzzzzz`
            hint: `jaka call --list` lists the commands; --pack adds commands, and --raw sends a command that is not in the spec
            exit code 2
        "]],
    );
}

#[test]
fn every_problem_is_reported() {
    check(
        "joint_move --mode abs --speed fast --dry-run",
        &expect![[r"
        error: `--mode`: `abs` is not absolute|relative
        `--speed`: `fast` is not a number
        exit code 2
    "]],
    );
    check(
        "joint_move --mode absolute --joint-position -1,2 --speed -10",
        &expect![[r"
            error: `joint_move` was not sent:
              field `joint_position` is [-1.0,2.0]; allowed is an array of 6, each a number, -360 to 360 deg
              field `speed` is -10.0; allowed is a number, more than 0, at most 265 deg/s
            exit code 2
        "]],
    );
    check(
        "jog --jog-mode stop --frame joint --axis 0 --velocity 1 --dry-run",
        &expect![[r"
            error: `jog` was not sent:
              there is no field `velocity`; the fields are `frame`, `axis`
            exit code 2
        "]],
    );
}

#[test]
fn clap_reports_unknown_options() {
    check(
        "joint_move --sped 1",
        &expect![[r"
            error: there is no option `--sped`
            hint: did you mean `--speed`?
            exit code 2
        "]],
    );
    check(
        "joint_move --speed",
        &expect![[r"
            error: `--speed <NUMBER>` needs a value
            hint: `jaka call joint_move --help` lists commands and options
            exit code 2
        "]],
    );
    check(
        "joint_move --speed 1 --params {}",
        &expect![[r"
            error: `--speed <NUMBER>` cannot be used with `--params <JSON>`
            hint: `jaka call joint_move --help` lists commands and options
            exit code 2
        "]],
    );
}

#[test]
fn negative_numbers_are_values() {
    check(
        "jog --jog-mode continuous --frame joint --axis 0 --velocity -10 --dry-run",
        &expect![[r#"
        {"cmdName":"jog","jog_mode":1,"coord_map":1,"jnum":0,"jogvel":-10}
        exit code 0
    "#]],
    );
    check(
        "joint_move --mode 1 --joint-position -1,-2,3,4,5,6 --speed 1e1 --dry-run",
        &expect![[r#"
        {"cmdName":"joint_move","relFlag":1,"jointPosition":[-1,-2,3,4,5,6],"speed":10}
        exit code 0
    "#]],
    );
    check(
        "jog --jog-mode increment --frame tool --axis 2 --jogvel 1 --distance -0.5 --dry-run",
        &expect![[r#"
        {"cmdName":"jog","jog_mode":2,"coord_map":2,"jnum":2,"jogvel":1,"poscmd":-0.5}
        exit code 0
    "#]],
    );
}

#[test]
fn what_no_arm_does_is_refused() {
    check(
        "joint_move --mode absolute --joint-position 1000,0,0,0,0,0 --speed 20 --dry-run",
        &expect![[r"
        error: `joint_move` was not sent:
          field `joint_position[0]` is 1000.0; allowed is a number, -360 to 360 deg; this is advisory
        hint: `--advisory-ranges ignore` leaves the check to the controller
        exit code 2
    "]],
    );
    check(
        "joint_move --mode absolute --joint-position 0,0,0,0,0,0 --speed 9000 --dry-run",
        &expect![[r"
        error: `joint_move` was not sent:
          field `speed` is 9000.0; allowed is a number, more than 0, at most 265 deg/s; this is advisory
        hint: joint motions take deg/s, tool lines mm/s; 9000 may be meant in mm/s
        hint: `--advisory-ranges ignore` leaves the check to the controller
        exit code 2
    "]],
    );
    check(
        "moveL --mode relative --pose 0,0,50,0,0,0 --speed 0 --acceleration 9000 --dry-run",
        &expect![[r"
        error: `moveL` was not sent:
          field `speed` is 0.0; allowed is a number, more than 0, at most 10000 mm/s; this is advisory
          field `acceleration` is 9000.0; allowed is a number, more than 0, at most 8000 mm/s²; this is advisory
        hint: `--advisory-ranges ignore` leaves the check to the controller
        exit code 2
    "]],
    );
    check(
        "servo_p --mode relative --pose 300,0,0,0,0,10 --step-count 1 --dry-run",
        &expect![[r"
        error: `servo_p` was not sent:
          field `pose.x` is 300.0; allowed is a number, -80 to 80 mm; this is advisory
          field `pose.rz` is 10.0; allowed is a number, -9 to 9 deg; this is advisory
        hint: `--advisory-ranges ignore` leaves the check to the controller
        exit code 2
    "]],
    );
    check(
        "servo_j --mode relative --joint-position 3,0,0,0,0,0 --step-count 13 --dry-run",
        &expect![[r"
        error: `servo_j` was not sent:
          field `step_count` is 13; allowed is a whole number, 1 to 12; this is advisory
        hint: `--advisory-ranges ignore` leaves the check to the controller
        exit code 2
    "]],
    );
    check(
        "servo_p --mode relative --pose 300,0,0,0,0,10 --advisory-ranges ignore --dry-run",
        &expect![[r#"
        {"cmdName":"servo_p","catPosition":[300,0,0,0,0,10],"relFlag":1}
        exit code 0
    "#]],
    );
}

#[test]
fn advisory_ranges_may_be_left_to_the_controller() {
    check(
        "set_digital_output --kind relay --index 0 --value on --dry-run",
        &expect![[r"
            error: `set_digital_output` was not sent:
              field `kind` is 3; allowed is 0 (Cabinet), 1 (Tool) or 2 (Extension); this is advisory
            hint: `--advisory-ranges ignore` leaves the check to the controller
            exit code 2
        "]],
    );
    check(
        "set_digital_output --kind relay --index 0 --value on --dry-run --advisory-ranges ignore",
        &expect![[r#"
        {"cmdName":"set_digital_output","type":3,"index":0,"value":1}
        exit code 0
    "#]],
    );
    check(
        "rapid_rate --rate 1.2 --dry-run --advisory-ranges ignore",
        &expect![[r"
        error: `rapid_rate` was not sent:
          field `rate` is 1.2; allowed is a number, 0 to 1
        exit code 2
    "]],
    );
}

#[test]
fn whole_requests_are_checked_too() {
    check(
        r#"power_on --params {"cmdName":"power_off"} --dry-run"#,
        &expect![[r#"
            error: the request names "power_off", the command line `power_on`
            exit code 2
        "#]],
    );
    check(
        r#"rapid_rate --params {"rate_value":7} --dry-run"#,
        &expect![[r"
        error: `rapid_rate` was not sent:
          field `rate` is 7; allowed is a number, 0 to 1
        exit code 2
    "]],
    );
    check(
        r#"--params {"cmdName":"power_of"} --dry-run"#,
        &expect![[r"
            error: there is no command `power_of`
            hint: `jaka call --list` lists the commands; --pack adds commands, and --raw sends a command that is not in the spec
            exit code 2
        "]],
    );
    check(
        "--params {} --dry-run",
        &expect![[r"
            error: no command name: give it on the command line, or as `cmdName` in the request
            exit code 2
        "]],
    );
    check(
        "power_on --params [1] --dry-run",
        &expect![[r"
            error: the request is not a JSON object: invalid type: sequence, expected a map at line 1 column 0
            exit code 2
        "]],
    );
    check(
        "power_on --params @no/such/file --dry-run",
        &expect![[r"
        error: cannot read the request in no/such/file: No such file or directory (os error 2)
        exit code 2
    "]],
    );
}

#[test]
fn whole_requests_come_from_files_and_standard_input() {
    let request = r#"{"cmdName": "rapid_rate", "rate_value": 0.5}"#;
    let file = scratch("rapid_rate.json");
    std::fs::write(&file, request).expect("the folder is there");
    let expected = "{\"cmdName\":\"rapid_rate\",\"rate_value\":0.5}\n";
    assert_eq!(jaka(["call", "--dry-run", "--params", &format!("@{}", file.display())]).out, expected);
    assert_eq!(run(command(["call", "rapid_rate", "--dry-run", "--params", "-"]), request).out, expected);
}

#[test]
fn raw_requests_go_out_as_they_are() {
    check(
        r#"new_command --raw --params {"b":1,"a":[2.50]} --dry-run"#,
        &expect![[r#"
        {"cmdName":"new_command","b":1,"a":[2.50]}
        exit code 0
    "#]],
    );
    check(
        "new_command --raw --dry-run",
        &expect![[r#"
        {"cmdName":"new_command"}
        exit code 0
    "#]],
    );
    check(
        r#"--raw --params {"a":1,"cmdName":"joint_move"} --dry-run"#,
        &expect![[r#"
        {"a":1,"cmdName":"joint_move"}
        exit code 0
    "#]],
    );
    check(
        "joint_move --raw --params {} --speed 1 --dry-run",
        &expect![[r"
            error: there is no option `--speed`
            hint: `jaka call joint_move --help` lists commands and options
            exit code 2
        "]],
    );
    check(
        "--raw --dry-run",
        &expect![[r"
            error: no command name: give it on the command line, or as `cmdName` in the request
            exit code 2
        "]],
    );
}

#[test]
fn packs_with_errors_show_all_of_them() {
    let file = scratch("wrong.toml");
    let text = "title = \"Wrong\"\n[[extend]]\ntarget = \"joint_mve\"\n[[command]]\nwire = \"x\"\neffect = \"none\"\n";
    std::fs::write(&file, text).expect("the folder is there");
    let run = jaka(["call".as_ref(), "--pack".as_ref(), file.as_os_str()]);
    assert_eq!(run.code, Some(2));
    let lines: Vec<_> = run.err.lines().map(|line| line.replace(&file.display().to_string(), "wrong.toml")).collect();
    expect![[r"
        error: the pack wrong.toml has errors:
        wrong.toml:3:10: extension of `joint_mve`: the spec has no command and no type `joint_mve`; there is `joint_move`
        wrong.toml:4:1: command `x`: `doc` is missing
        wrong.toml:6:10: command `x`: `effect` is one of query, setting, motion, power, session, not `none`"]].assert_eq(&lines.join("\n"));
}

#[test]
fn packs_come_from_the_environment_and_the_config_file() {
    let line = ["call", "set_demo_period", "--period", "8", "--dry-run"];
    let expected = "{\"cmdName\":\"demo_set_period\",\"demo_period\":8}\n";
    let mut by_environment = command(line);
    by_environment.env("JAKA_PACK", pack("newer.toml"));
    assert_eq!(run(by_environment, "").out, expected);
    let config = scratch("packs.toml");
    std::fs::write(&config, format!("packs = ['{}']", pack("newer.toml"))).expect("the folder is there");
    let mut by_config = command(line);
    by_config.env("JAKA_CONFIG", &config);
    assert_eq!(run(by_config, "").out, expected);
    assert_eq!(jaka(line).code, Some(2));
}

#[test]
fn what_a_pack_repeats_is_warned_of() {
    let file = scratch("repeats.toml");
    let text = "title = \"Repeats\"\n[[override]]\ntarget = \"rapid_rate\"\nrequest = \"rate_value\"\nmin = 0\n";
    std::fs::write(&file, text).expect("the folder is there");
    let run = jaka(["call", "get_version", "--dry-run", "--pack", &file.display().to_string()]);
    assert_eq!((run.code, run.out.as_str()), (Some(0), "{\"cmdName\":\"get_version\"}\n"));
    assert!(run.err.starts_with("warning: ") && run.err.contains("repeats.toml:2:"), "{}", run.err);
}

#[test]
fn a_negative_value_is_not_an_option() {
    check(
        "set_digital_output --kind -1 --index 1 --value on --dry-run",
        &expect![[r"
        error: `set_digital_output` was not sent:
          field `kind` is -1; allowed is 0 (Cabinet), 1 (Tool) or 2 (Extension)
        exit code 2
    "]],
    );
}
