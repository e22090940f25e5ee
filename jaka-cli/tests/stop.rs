//! `jaka stop` on lines that were written for another command.

use std::fs;

use jaka_sim::{Controller, Fault};
use jaka_sync::motion::JointMove;
use jaka_tests::Arm;

#[cfg(unix)]
use crate::common::{interrupt, started};
use crate::program::{Run, address_of, command, jaka, result, run, scratch};

/// An arm that turns its first joint by 90 deg, for 90 s.
fn moving() -> Arm {
    let (arm, mut client) = Arm::real_time().with_client();
    client.joint_move(&JointMove::relative([90.0, 0.0, 0.0, 0.0, 0.0, 0.0], 1.0)).expect("the arm is ready");
    arm
}

fn stops(controller: &Controller) -> usize {
    controller.requests().iter().filter(|request| request.contains("stop_program")).count()
}

fn stop(controller: &Controller, options: &str) -> Run {
    let words = format!("stop {options}").split_whitespace().map(str::to_owned).collect::<Vec<_>>();
    jaka(words.into_iter().chain(address_of(controller)))
}

#[test]
fn it_stops_the_arm_whatever_other_commands_take() {
    for options in [
        "--pack nowhere.toml",
        "--model no-such-arm",
        "--limits nowhere.toml --yes --queue",
        "--joints -90,0,0,0,0,0 --speed fast --acceleration --dry-run",
        "-y -o /nowhere/picture.svg --json=wire --wait --params @nowhere.json",
        "--mode absolute --joint-position -10,0,0,0,0,0 --check-firmware",
    ] {
        let arm = moving();
        let run = stop(&arm, options);
        assert_eq!((run.code, stops(&arm)), (Some(0), 1), "{options}: {run:?}");
    }
}

#[test]
fn it_notes_what_is_unknown_beside_the_robot() {
    let arm = moving();
    let run = stop(&arm, "6 5 --frobnicate");
    assert_eq!((run.code, stops(&arm)), (Some(0), 1), "{run:?}");
    for word in ["6", "5", "--frobnicate"] {
        assert!(
            run.err.contains(&format!("note: `{word}` means nothing to `jaka stop`, and was ignored\n")),
            "{run:?}"
        );
    }
}

#[test]
fn a_misspelt_address_stops_no_other_cell() {
    let arm = moving();
    let (commands, status) = (arm.command_addr().port(), arm.status_addr().port());
    let config = scratch("config.toml");
    let text = format!(
        "robot = 'cell1'\n[robots.cell1]\naddress = '127.0.0.1'\ncommand_port = {commands}\nstatus_port = {status}\n\
         timeout = 60\n"
    );
    fs::write(&config, text).expect("it can be written");
    let run = |line: &str| {
        let mut command = command(line.split(' '));
        command.env("JAKA_CONFIG", &config);
        run(command, "")
    };
    for line in ["stop --robbot 10.0.0.1", "stop --pack a.toml -R 10.0.0.1", "stop 10.0.0.1", "stop --frobnicate"] {
        let refused = run(line);
        assert_eq!((refused.code, refused.out.as_str()), (Some(2), ""), "{line}: {refused:?}");
    }
    let refused = run("stop --model zu5 --robbot 10.0.0.1 --yes");
    assert_eq!(
        refused.err, "error: there is no option `--robbot`\nhint: did you mean `--robot`?\n",
        "what is named is what is wrong"
    );
    assert!(stops(&arm) == 0 && !arm.state().at_rest);
    let stopped = run("stop --model zu5 --pack nowhere.toml --yes");
    assert_eq!((stopped.code, stops(&arm)), (Some(0), 1), "{stopped:?}");
}

#[test]
fn a_recording_that_cannot_begin_keeps_no_stop_back() {
    let arm = moving();
    let file = scratch("session.jsonl");
    fs::write(&file, "of the motion").expect("it can be written");
    let run = stop(&arm, &format!("--record {}", file.display()));
    assert_eq!((run.code, stops(&arm)), (Some(0), 1), "{run:?}");
    assert!(run.err.contains("warning: the stop was not recorded: ") && run.err.contains("not overwritten"), "{run:?}");
    assert_eq!(fs::read_to_string(&file).expect("it is there"), "of the motion");
}

#[cfg(unix)]
#[test]
fn an_interrupt_of_a_stop_before_rest_says_that_the_arm_may_move() {
    let arm = Arm::real_time().start();
    let refusal = r#"{"errorCode":"2","errorMsg":"busy","cmdName":"get_joint_pos"}"#;
    (0..2000).for_each(|_| arm.inject_for("get_joint_pos", Fault::Instead(refusal.into())));
    let mut command = command(["stop".to_owned()].into_iter().chain(address_of(&arm)));
    let (child, _out, line) = started(&mut command);
    assert_eq!(line, "the controller accepted the stop (`stop_program`)\n", "before the arm is asked for its rest");
    interrupt(&child);
    let run = result(child);
    assert_eq!(run.code, Some(29), "{run:?}");
    let text = "error: interrupted; the arm was not seen at rest and may still move, use the emergency stop\n";
    assert!(run.err.ends_with(text), "{run:?}");
}
