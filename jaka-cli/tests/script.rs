//! The README's script: it ends at the first motion that does not reach its target, with that one's exit code.

#![cfg(unix)]

use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::{env, fs, iter};

use jaka_sim::{Controller, Delays, Fault, Port};

use crate::program::{Happening, Run, result, scratch, wait_for_motion, with_each};

/// A controller whose arm has no power.
fn controller() -> Controller {
    Controller::builder().delays(Delays::NONE).start().expect("loopback has free ports")
}

const README: &str = include_str!("../README.md");

/// Runs the README's script with this patience, and says how it ended. `meanwhile` does what it does once the arm moves.
fn script(controller: &Controller, patience: &str, meanwhile: impl FnOnce(&Controller)) -> Run {
    let child = started_script(controller, patience);
    wait_for_motion(controller);
    meanwhile(controller);
    result(child)
}

fn started_script(controller: &Controller, patience: &str) -> Child {
    let (_, rest) = README.split_once("#!/bin/sh\n").expect("the README has the script");
    let file = scratch("two-motions.sh");
    fs::write(&file, rest.split_once("```").expect("it ends").0).expect("it can be written");
    let config = scratch("config.toml");
    let (commands, status) = (controller.command_addr().port(), controller.status_addr().port());
    let text = format!("[robots.cell1]\naddress = '127.0.0.1'\ncommand_port = {commands}\nstatus_port = {status}\n");
    fs::write(&config, text).expect("it can be written");
    let program = Path::new(env!("CARGO_BIN_EXE_jaka"));
    let path = env::join_paths(
        iter::once(program.parent().expect("it is in a folder").to_owned())
            .chain(env::split_paths(&env::var_os("PATH").expect("there is one"))),
    );
    let mut shell = Command::new("sh");
    shell.arg(file).args(["cell1", patience]).env("PATH", path.expect("it has no colon")).env("JAKA_CONFIG", config);
    shell.env_remove("JAKA_ROBOT").stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    shell.spawn().expect("there is a shell")
}

#[test]
fn a_script_ends_at_the_first_motion_that_fails() {
    let count = |controller: &Controller, name: &str| {
        controller.requests().iter().filter(|request| request.contains(name)).count()
    };
    let quick = Controller::builder().delays(Delays::NONE).time_scale(5.0).start().expect("loopback has free ports");
    let run = script(&quick, "60", |_| {});
    assert_eq!(run.code, Some(0), "{run:?}");
    assert_eq!((count(&quick, "joint_move"), count(&quick, "power_off")), (2, 1));
    let ends: [(&str, Happening, i32); 7] = [
        ("60", |controller| (0..20).for_each(|_| refuse(controller, "get_joint_pos")), 21),
        ("60", Controller::collide, 23),
        ("60", Controller::press_emergency_stop, 24),
        ("60", Controller::cut_power, 25),
        ("60", |controller| controller.set_state(|state| "0x0f0030".clone_into(&mut state.error_code)), 26),
        ("2", |_| {}, 27),
        ("60", |controller| controller.link(Port::Status).cut(), 28),
    ];
    with_each(ends, |(patience, meanwhile, code)| {
        let controller = controller();
        let run = script(&controller, patience, meanwhile);
        assert_eq!(run.code, Some(code), "{run:?}");
        assert_eq!(count(&controller, "joint_move"), 1, "{run:?}");
        assert_eq!(count(&controller, "stop_program"), 1, "{run:?}");
    });
}

/// A refusal of this command.
fn refuse(controller: &Controller, command: &str) {
    let refusal = format!(r#"{{"errorCode":"1","errorMsg":"busy","cmdName":"{command}"}}"#);
    controller.inject_for(command, Fault::Instead(refusal.into()));
}

#[test]
fn a_script_ends_with_what_is_refused() {
    let controller = controller();
    refuse(&controller, "joint_move");
    let run = script(&controller, "60", |_| {});
    assert_eq!(run.code, Some(1), "{run:?}");
    controller.press_emergency_stop();
    let changes = || controller.requests().iter().filter(|request| !request.contains("\"get_")).count();
    let before = changes();
    let run = result(started_script(&controller, "60"));
    assert_eq!(run.code, Some(20), "{run:?}");
    assert_eq!(changes(), before, "`up` has sent nothing, and the script has ended there");
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
        let controller = controller();
        if !is_taken {
            refuse(&controller, "stop_program");
        }
        let child = started_script(&controller, "60");
        wait_for_motion(&controller);
        interrupt_in(&child);
        let run = result(child);
        assert_eq!(run.code, Some(code), "{run:?}");
        let stops = controller.requests().iter().filter(|request| request.contains("stop_program")).count();
        assert_eq!(stops, 2, "that of Ctrl-C, and the script's own");
    }
}
