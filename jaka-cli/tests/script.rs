//! The README's script: it ends at the first motion that does not reach its target, with that one's exit code.

#![cfg(unix)]

use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::{env, fs, iter};

use jaka_sim::{Controller, Fault};
use jaka_tests::Arm;

use crate::program::{result, scratch, wait_for_motion};

const README: &str = include_str!("../README.md");

/// The README's script for a robot, with the program of this folder.
fn script(folder: &Path, robot: &str) -> Command {
    let (_, rest) = README.split_once("#!/bin/sh\n").expect("the README has the script");
    let file = scratch("two-motions.sh");
    fs::write(&file, rest.split_once("```").expect("it ends").0).expect("it can be written");
    let config = scratch("config.toml");
    fs::write(&config, format!("[robots.cell1]\naddress = '127.0.0.1'\n{robot}")).expect("it can be written");
    let paths = env::var_os("PATH").expect("there is one");
    let path = env::join_paths(iter::once(folder.to_owned()).chain(env::split_paths(&paths)));
    let mut shell = Command::new("sh");
    shell.arg(file).args(["cell1", "60"]).env("PATH", path.expect("it has no colon")).env("JAKA_CONFIG", config);
    shell.env_remove("JAKA_ROBOT").stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    shell
}

fn started_script(controller: &Controller) -> Child {
    let (commands, status) = (controller.command_addr().port(), controller.status_addr().port());
    let times = "timeout = 60\nconnect_timeout = 60\nstale_after = 60\n";
    let program = Path::new(env!("CARGO_BIN_EXE_jaka")).parent().expect("it is in a folder");
    let mut script = script(program, &format!("command_port = {commands}\nstatus_port = {status}\n{times}"));
    script.spawn().expect("there is a shell")
}

/// The changes that a script has asked for.
fn changes(controller: &Controller) -> Vec<String> {
    let name = |request: String| request.split('"').nth(3).expect("a request has a name").to_owned();
    controller.requests().into_iter().map(name).filter(|name| !name.starts_with("get_")).collect()
}

/// An arm without power whose time passes at this speed.
fn arm(time_scale: f64) -> Arm {
    Arm::real_time().without_power().controller(|controller| controller.time_scale(time_scale)).start()
}

#[test]
fn a_script_ends_at_the_first_motion_that_fails() {
    let quick = arm(5.0);
    let run = result(started_script(&quick));
    assert_eq!(run.code, Some(0), "{run:?}");
    let all = ["power_on", "enable_robot", "joint_move", "joint_move", "disable_robot", "power_off"];
    assert_eq!(changes(&quick), all);
    let slow = arm(0.2);
    let child = started_script(&slow);
    wait_for_motion(&slow);
    slow.collide();
    let run = result(child);
    assert_eq!(run.code, Some(23), "{run:?}");
    assert_eq!(changes(&slow), ["power_on", "enable_robot", "joint_move", "stop_program"]);
}

#[test]
fn a_script_ends_with_the_code_of_the_motion() {
    let (folder, noted) = (Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/script"), scratch("noted"));
    for code in [1, 4, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29] {
        fs::remove_file(&noted).ok();
        let mut script = script(&folder, "");
        let child = script.env("NOTED", &noted).env("CODE", code.to_string()).spawn().expect("there is a shell");
        let run = result(child);
        assert_eq!(run.code, Some(code), "{run:?}");
        assert_eq!(fs::read_to_string(&noted).expect("it was called"), "up\ncall\nstop\n");
    }
}

/// A refusal of this command.
fn refuse(controller: &Controller, command: &str) {
    let refusal = format!(r#"{{"errorCode":"1","errorMsg":"busy","cmdName":"{command}"}}"#);
    controller.inject_for(command, Fault::Instead(refusal.into()));
}

#[test]
fn a_script_ends_with_what_is_refused() {
    let controller = arm(1.0);
    refuse(&controller, "joint_move");
    let run = result(started_script(&controller));
    assert_eq!(run.code, Some(1), "{run:?}");
    controller.press_emergency_stop();
    let before = changes(&controller).len();
    let run = result(started_script(&controller));
    assert_eq!(run.code, Some(20), "{run:?}");
    assert_eq!(changes(&controller).len(), before, "`up` has sent nothing, and the script has ended there");
}

/// The program that a script waits for.
#[cfg(target_os = "linux")]
fn interrupt_in(script: &Child) {
    let children = format!("/proc/{0}/task/{0}/children", script.id());
    let child = fs::read_to_string(children).expect("the system lists children");
    let killed = Command::new("kill").args(["-INT", child.trim()]).status().expect("there is a kill");
    assert!(killed.success(), "{child}");
}

#[cfg(target_os = "linux")]
#[test]
fn a_script_ends_with_what_an_interrupt_has_led_to() {
    for (is_taken, code) in [(true, 22), (false, 29)] {
        let controller = arm(0.2);
        if !is_taken {
            refuse(&controller, "stop_program");
        }
        let child = started_script(&controller);
        wait_for_motion(&controller);
        interrupt_in(&child);
        let run = result(child);
        assert_eq!(run.code, Some(code), "{run:?}");
        let stops = changes(&controller).into_iter().filter(|change| change == "stop_program").count();
        assert_eq!(stops, 2, "that of Ctrl-C, and the script's own");
    }
}
