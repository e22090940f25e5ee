//! `docs/first-robot.md` against a controller that something is wrong with: the first command of the page that meets it
//! names it.

use std::io::{BufReader, Write};
use std::net::TcpStream;
use std::process::{Child, ChildStdout};

use crate::common::{jaka, started};
use crate::program::{self, Run};

/// `jaka sim`, which ends with the test.
struct Controller {
    program: Child,
    /// Standard output of the program, which ends where nobody can read it.
    _output: BufReader<ChildStdout>,
    commands: String,
    status: String,
}

impl Controller {
    fn start(arguments: &[&str]) -> Self {
        let mut command = jaka(&["sim", "--firmware", "1.5.14", "--fast", "--commands", "0", "--status", "0"]);
        let (program, output, line) = started(command.args(arguments));
        let ports: Vec<_> = line.trim().split(", ").filter_map(|part| part.rsplit_once(':')).collect();
        let [(_, commands), (_, status)] = ports[..] else { panic!("{line}") };
        Self { program, _output: output, commands: commands.to_owned(), status: status.to_owned() }
    }

    /// Runs a line of the page; `--yes` in place of the person who is asked.
    fn run(&self, line: &str) -> Run {
        let ports = ["--robot", "127.0.0.1", "--command-port", &self.commands, "--status-port", &self.status];
        program::jaka(line.split(' ').chain(ports))
    }
}

impl Drop for Controller {
    fn drop(&mut self) {
        // It may have ended already.
        self.program.kill().ok();
        self.program.wait().ok();
    }
}

/// Lines of a run on an item of `jaka check`.
fn finding<'r>(run: &'r Run, item: &str) -> &'r str {
    let at = run.out.find(&format!("\n{item}")).unwrap_or_else(|| panic!("{run:?}"));
    let found = &run.out[at + 1..];
    let end = found.lines().skip(1).position(|line| !line.starts_with(' ')).expect("more follows");
    let length: usize = found.lines().take(end + 1).map(|line| line.len() + 1).sum();
    &found[..length]
}

#[test]
fn a_pressed_emergency_stop_is_named_by_the_first_look() {
    let controller = Controller::start(&["--schedule", "press-emergency-stop at 0s"]);
    let seen = controller.run("status --until emergency_stop --timeout 60");
    assert_eq!(seen.code, Some(0), "{seen:?}");
    let check = controller.run("check --yes");
    assert_eq!(check.code, Some(9), "{check:?}");
    assert!(finding(&check, "emergency stop").contains("wrong          the emergency stop is pressed"), "{check:?}");
    for line in ["up --yes", "jog 6 5 --speed 5 --yes"] {
        let refused = controller.run(line);
        assert_eq!((refused.code, refused.out.as_str()), (Some(20), ""), "{refused:?}");
        assert!(refused.err.contains("the emergency stop is pressed"), "{refused:?}");
    }
}

#[test]
fn a_seat_that_is_taken_is_named_by_the_first_command_that_needs_it() {
    let controller = Controller::start(&["--second-client", "is-refused"]);
    let port = controller.commands.parse().expect("a port");
    let mut other = TcpStream::connect(("127.0.0.1", port)).unwrap();
    other.write_all(br#"{"cmdName":"get_version"}"#).unwrap();
    // Whoever has been answered has the seat.
    other.peek(&mut [0]).unwrap();
    assert_eq!(controller.run("status").code, Some(0), "the status port has room for all");
    let check = controller.run("check --yes");
    assert_eq!(check.code, Some(9), "{check:?}");
    let port = check.out.lines().take(2).collect::<Vec<_>>().join("\n");
    assert!(port.starts_with("command port     wrong") && port.contains("look for another program"), "{check:?}");
    // Before a step and a motion comes a query.
    for (line, code) in [("call rapid_rate --rate 0.2 --yes", 4), ("up --yes", 5), ("jog 6 5 --speed 5 --yes", 5)] {
        let broken = controller.run(line);
        assert_eq!((broken.code, broken.out.as_str()), (Some(code), ""), "{broken:?}");
        assert!(
            broken.err.contains("another client, such as the vendor's app, may have taken the command port"),
            "{broken:?}"
        );
    }
}

#[test]
fn a_payload_of_zero_is_named_by_the_check() {
    let controller = Controller::start(&[]);
    let set = controller.run("call set_payload --mass 0 --centroid 0,0,0 --yes");
    assert_eq!(set.code, Some(0), "{set:?}");
    let check = controller.run("check --yes");
    assert_eq!(check.code, Some(8), "{check:?}");
    let payload = finding(&check, "payload");
    assert!(payload.contains("look           0 kg"), "{payload}");
    assert!(payload.contains("set_payload"), "what to do: {payload}");
}

#[test]
fn remote_control_that_is_not_granted_is_named_by_the_refusal() {
    let fault_at = |command: &str| {
        // The text of a Schneider Lexium.
        let message = "permission deny, please check remote control source";
        let reply = format!(r#"{{\"errorCode\":\"3\",\"errorMsg\":\"{message}\",\"cmdName\":\"{command}\"}}"#);
        format!(r#"for {command}: instead "{reply}""#)
    };
    for (command, line) in [("rapid_rate", "call rapid_rate --rate 0.2 --yes"), ("power_on", "up --yes")] {
        let controller = Controller::start(&["--faults", &fault_at(command)]);
        let refused = controller.run(line);
        assert_eq!((refused.code, refused.out.as_str()), (Some(1), ""), "{refused:?}");
        assert!(refused.err.contains("with code 3: permission deny"), "{refused:?}");
        assert!(refused.err.contains("grant remote control on the controller's panel"), "{refused:?}");
    }
    let controller = Controller::start(&["--powered", "--faults", &fault_at("joint_move")]);
    let refused = controller.run("jog 6 5 --speed 5 --yes");
    assert_eq!((refused.code, refused.out.as_str()), (Some(1), ""), "{refused:?}");
    assert!(refused.err.contains("grant remote control on the controller's panel"), "{refused:?}");
}
