//! The commands that talk to no robot.

#![allow(clippy::needless_raw_string_hashes, reason = "expect-test writes them")]

use std::io::{BufRead, BufReader, Write};
use std::process::{Child, ChildStdout, Stdio};

use expect_test::expect;

use crate::common::{self, failure, jaka, output, started};

#[test]
fn a_simulated_controller_serves_other_programs() {
    let arm = [
        "--lag",
        "16",
        "--trips",
        "deviation 1.5, command-acceleration 2000",
        "--underrun",
        "run-out 300",
        "--stop-in-servo",
        "leave",
    ];
    let options = [&["sim", "--commands", "0", "--status", "0", "--model", "zu3"], &arm[..]].concat();
    let mut sim = jaka(&options).stdout(Stdio::piped()).spawn().unwrap();
    let mut line = String::new();
    BufReader::new(sim.stdout.take().unwrap()).read_line(&mut line).unwrap();
    let port = line.trim_end().rsplit(':').next().unwrap();
    let found = output(&mut jaka(&["status", "-r", "127.0.0.1", "--status-port", port, "-f", "enabled"]));
    sim.kill().unwrap();
    sim.wait().unwrap();
    assert_eq!(found, ("enabled  false\n".to_owned(), String::new(), Some(0)));
}

/// A simulated controller of these options, its first line, and the port of its status.
fn sim(options: &[&str]) -> (Child, BufReader<ChildStdout>, String) {
    let args = [&["sim", "--commands", "0", "--status", "0"], options].concat();
    let (child, out, line) = started(jaka(&args).stdin(Stdio::piped()));
    let port = line.trim_end().rsplit(':').next().unwrap().to_owned();
    (child, out, port)
}

/// Waits until the status of a simulated controller shows this.
fn wait_until(port: &str, condition: &str) {
    let args = ["status", "-r", "127.0.0.1", "--status-port", port, "--timeout", "60", "--until", condition];
    let (_, stderr, code) = output(&mut jaka(&args));
    assert_eq!((stderr.as_str(), code), ("", Some(0)), "{condition}");
}

#[test]
fn what_happens_to_the_simulated_arm_is_scheduled_or_typed() {
    let (mut child, mut out, port) =
        sim(&["--powered", "--stdin", "--schedule", "collide at 100ms, input 3 high at 150ms"]);
    wait_until(&port, "enabled && powered_on && protective_stop && !emergency_stop && digital_inputs[3]");
    let mut line = String::new();
    out.read_line(&mut line).unwrap();
    assert!(line.ends_with(" s: collide\n"), "{line}");
    let mut input = child.stdin.take().unwrap();
    input.write_all(b"crash\ninput 900 high\npress-emergency-stop\n").unwrap();
    wait_until(&port, "emergency_stop");
    input.write_all(b"release-emergency-stop\ncut-power at 0s\n").unwrap();
    wait_until(&port, "!emergency_stop && !powered_on");
    child.kill().unwrap();
    let errors: Vec<_> = BufReader::new(child.stderr.take().unwrap()).lines().map(Result::unwrap).collect();
    child.wait().unwrap();
    expect![[r#"
        error: `crash`: expected one of `collide`, `press-emergency-stop`, `release-emergency-stop`, `cut-power`, `input 3 high`, `tool-input 0 low`, `analog-input 3 2.5`, `tool-analog-input 0 2.5`, `link status to-client hold`
        error: input 900 high: the cabinet has 135 digital inputs, from 0, and not one with number 900"#]].assert_eq(&errors.join("\n"));
}

#[test]
fn a_port_in_use_is_named() {
    let other = std::net::TcpListener::bind("127.0.0.1:0").unwrap();
    let port = other.local_addr().unwrap().port().to_string();
    for options in [["--commands", &port, "--status", "0"], ["--commands", "0", "--status", &port]] {
        let failed = failure(&mut jaka(&[&["sim"][..], &options].concat()));
        let named = format!("error: cannot start the controller: port {port} of 127.0.0.1 is in use: ");
        assert!(
            failed.starts_with(&named) && failed.contains("\nhint: end the program that uses the port; "),
            "{failed}"
        );
        assert!(failed.ends_with("exit code Some(6)"), "{failed}");
    }
}

/// Descriptors that a program has open.
#[cfg(target_os = "linux")]
fn descriptors(child: &Child) -> usize {
    std::fs::read_dir(format!("/proc/{}/fd", child.id())).expect("the system lists descriptors").count()
}

#[cfg(target_os = "linux")]
#[test]
fn a_simulated_controller_closes_the_sockets_of_readers_that_have_left() {
    let (mut child, _out, port) = sim(&["--firmware", "newer"]);
    let before = descriptors(&child);
    let address = format!("127.0.0.1:{port}");
    let readers: Vec<_> = (0..50).map(|_| std::net::TcpStream::connect(&address).unwrap()).collect();
    common::wait_until("all are accepted", || descriptors(&child) >= before + 50);
    drop(readers);
    common::wait_until("their sockets are closed", || descriptors(&child) <= before);
    child.kill().unwrap();
    child.wait().unwrap();
}

/// The program reads a request from standard input, which does not end before the signal has come.
#[cfg(target_os = "linux")]
#[test]
fn a_signal_ends_the_program_by_its_exit_code_from_the_start() {
    let mut command = jaka(&["call", "get_version", "--dry-run", "--params", "-"]);
    let mut child = command.stdin(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let mut input = child.stdin.take().unwrap();
    // This is more than a pipe holds: it waits until the program reads.
    input.write_all(&vec![b' '; 1 << 20]).unwrap();
    common::interrupt(&child);
    assert_eq!(common::end(child).code(), Some(130));
    drop(input);
}
