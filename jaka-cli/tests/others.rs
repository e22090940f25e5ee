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
    expect![[r#"
        error: `--schedule <LIST>` cannot be ` trip`: `trip`: expected one of `collide`, `press-emergency-stop`, `release-emergency-stop`, `cut-power`, `input 3 high`, `tool-input 0 low`, `analog-input 3 2.5`, `tool-analog-input 0 2.5`, `link status to-client hold`
        hint: `jaka sim --help` lists commands and options
        exit code Some(2)"#]].assert_eq(&failure(&mut jaka(&["sim", "--schedule", "collide at 2s, trip"])));
    expect![[r#"
        error: `--schedule <LIST>` cannot be `collide 2s`: `2s`: a time may follow, as in `collide at 2s`
        hint: `jaka sim --help` lists commands and options
        exit code Some(2)"#]]
    .assert_eq(&failure(&mut jaka(&["sim", "--schedule", "collide 2s"])));
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

#[test]
fn the_help_of_sim_lists_the_faults() {
    let (help, _, _) = output(&mut jaka(&["sim", "--help"]));
    let (_, list) = help.split_once("Faults, an example of each:\n").unwrap();
    expect![[r#"
          of replies:  none, drop, delay 50ms, hold, split 1 2 3, with-next, twice, nameless, renamed
          get_payload, before "{}", after "\x00", instead "nonsense", garbage 500 7, oversized 100000,
          half-open, close, close-after 10, reset, takeover
          `status …`:  none, silent, slow 80ms, split 3, garbage 300 3, cut 100, instead "{}", close-after
          100

        A reply takes the next one of the list. `for joint_move: drop` is for the replies to a command,
        `always drop` for all, and `random 7 1/20 drop, reset` for one in twenty, with a seed. The README of
        jaka-sim explains them.

        Events for `--schedule` and `--stdin`, with inputs counted from 0:
          collide, press-emergency-stop, release-emergency-stop, cut-power, input 3 high, tool-input 0 low,
          analog-input 3 2.5, tool-analog-input 0 2.5, link status to-client hold

        `link` has a port (`command`, `status` or `both`), a direction (`to-client`, `to-controller` or
        `both`), and a fault: none, hold, delay 80ms, slow 20000, cut
    "#]]
    .assert_eq(list);
}

#[test]
fn what_the_simulated_controller_does_not_know_is_named() {
    expect![[r#"
        error: `--firmware <NAME>` cannot be `9`: there are 1.5.14, newer, document
        hint: `jaka sim --help` lists commands and options
        exit code Some(2)"#]]
    .assert_eq(&failure(&mut jaka(&["sim", "--firmware", "9"])));
    expect![[r#"
        error: `--faults <TEXT>` cannot be `drip`: line 1: `drip`: unknown fault; the faults of replies are none, drop, delay, hold, split, with-next, twice, nameless, renamed, before, after, instead, garbage, oversized, half-open, close, close-after, reset, takeover; `jaka sim --help` has all
        hint: `jaka sim --help` lists commands and options
        exit code Some(2)"#]]
    .assert_eq(&failure(&mut jaka(&["sim", "--faults", "drip"])));
    expect![[r#"
        error: `--trips <LIST>` cannot be ` sped 3`: `sped`: unknown trip; the trips, each with a threshold, are `deviation 1`, `speed 1`, `speed-deviation 1`, `command-speed 1`, `command-acceleration 1`
        hint: `jaka sim --help` lists commands and options
        exit code Some(2)"#]].assert_eq(&failure(&mut jaka(&["sim", "--trips", "deviation 1, sped 3"])));
    expect![[r#"
        error: `--underrun <TEXT>` cannot be `stop`: `stop`: expected one of `hold`, `fault`, `fault 40ms` and `run-out 300`
        hint: `jaka sim --help` lists commands and options
        exit code Some(2)"#]]
    .assert_eq(&failure(&mut jaka(&["sim", "--underrun", "stop"])));
    expect![[r#"
        error: `--stop-in-servo <TEXT>` cannot be `hold`: `hold`: expected one of `discard`, `ignore`, `leave`, `fault`
        hint: `jaka sim --help` lists commands and options
        exit code Some(2)"#]]
    .assert_eq(&failure(&mut jaka(&["sim", "--stop-in-servo", "hold"])));
    expect![[r#"
        error: there is no model `zu99`; the models are Zu 5, Zu 3, Zu 7, Zu 12, Zu 18, Zu 20, Zu 30, Pro 5, Pro 7, Pro 12, Pro 16, Pro 18, S5, S7, S12, C5, C7, C12, A5, A12, MiniCobo
        exit code Some(2)"#]].assert_eq(&failure(&mut jaka(&["sim", "--model", "zu99"])));
}

#[test]
fn a_dashboard_needs_a_terminal() {
    expect![[r#"
        error: `jaka monitor` needs a terminal; `jaka status --watch` does not
        exit code Some(2)"#]]
    .assert_eq(&failure(&mut jaka(&["monitor", "--sim"])));
}

#[test]
fn the_help_explains_exit_codes() {
    let (help, _, code) = output(&mut jaka(&["--help"]));
    assert_eq!(code, Some(0));
    expect![[r#"
        Commands, status, live dashboard and simulated controller for JAKA robots

        Usage: jaka [OPTIONS] <COMMAND>

        Commands:
          status       Print the robot's state, once or repeatedly
          monitor      Show the robot's state live in the terminal
          call         Send one command of the protocol, and print the reply
          up           Power and enable the arm, each step after the previous one is done
          down         Disable the arm and switch its power off, each step after the previous one is done
          stop         Stop the running motion or program, and wait until the arm is at rest; sent without a
                       question
          clear        Leave the protective stop after a collision
          move         Move the arm to joint positions or to a pose, and wait until it is there; Ctrl-C
                       stops it
          jog          Move one joint, or the tool centre point along one axis, by an increment, and wait;
                       Ctrl-C stops it
          follow       Follow a trajectory from a file, starting where the arm is; Ctrl-C stops it on the
                       trajectory
          check        Check a robot before its use: ports, power, stops, payload, rates, model; changes
                       nothing
          explain      Explain a code or a refusal of the controller
          probe        Send a controller every query of the protocol, and report the departures of its
                       answers from the spec
          jitter       Measure the lateness of this machine's set-point cycles, and the reply times of a
                       robot; moves nothing
          sim          Run a simulated controller until it is interrupted
          record       Record a session to a new file, until it is interrupted
          replay       Serve a recording in place of a robot until it is interrupted, or show it
          report       Write a page with pictures of a recording: an HTML file, for browsers and for print
          export       Write the status packets of a recording as a table, with a line for each packet
          spec         Check specs and packs, compare them, and write documents from them
          completions  Print the completion script of a shell
          man          Write the pages of the manual, one for each command
          help         Print this message or the help of the given subcommand(s)

        Options:
          -h, --help
                  Print help (see a summary with '-h')

          -V, --version
                  Print version

        Messages:
          -v, --verbose...
                  Log connections, requests and replies on standard error; `-vv` also the actions of a
                  simulated controller

          -q, --quiet
                  Print only errors, questions and outcomes of motions on standard error

              --color <WHEN>
                  Colours: always, never, or auto: on terminals, unless `NO_COLOR` is set [default: auto]

        The robot:
          Commands that talk to a robot take its address from, in this order: --sim,
          --robot, the environment's JAKA_ROBOT, and `robot = "NAME"` in the config
          file. Each may be an address or the name of a [robots.NAME] in the config
          file, which is ~/.config/jaka/config.toml unless --config or JAKA_CONFIG say
          otherwise.

        Command packs:
          Commands that accept packs take them from, in this order: --pack, the
          environment's JAKA_PACK, and `packs = ["FILE"]` in the config file. The
          first of these that names any is used.

        Exit codes:
          0  success; also when the reader of the output closes it, and on Ctrl-C if
             the command runs until then
          1  the controller refused the command, which did not run
          2  the command line, the config file, a pack or an argument is wrong, or a
             question was not answered with yes; nothing was sent
          3  no connection could be made; nothing was sent
          4  the command may have run: no reply in time, or an unexpected one; check
             the robot's state before you go on
          5  the connection was lost or became unreadable with no command outstanding;
             also no status packet in time
          6  something on this machine: a file, a port, the terminal
          7  `jaka probe` found a departure from the spec or got no answer; clients of
             `jaka replay` deviated from the recording
          8, 9  `jaka check` found something to look at, or something wrong; also
                where no connection could be made
          10, 11, 12  `jaka spec diff --exit-code` found differences: patch, minor or
                      major at most
          20 to 30 are for what moves the arm, and 27 for whatever is waited for:
          20  the robot's state or a limit forbids it, or the state is not known;
              nothing that moves the arm was sent
          21  the arm is at rest, and it is not known whether it is where it was sent
          22  the motion ended before its target, also by Ctrl-C, after which the arm
              was seen at rest
          23  a protective stop
          24  the emergency stop
          25  the arm has no power, or is not enabled
          26  the controller reports an error
          27  what was waited for did not come in time; a motion may go on
          28  no status packets that can be read any more; the arm may still move
          29  Ctrl-C or `jaka stop`, and the arm may still move: the controller has
              not taken the stop, or it is not known whether it has, or the arm still
              moves after it, or cannot be observed
          30  `jaka follow`: set-points were too late or refused, or a joint did not
              follow; the message says whether the arm is at rest
          130  Ctrl-C before anything was sent that changes something, or before what
               was waited for
    "#]]
    .assert_eq(&help);
    assert!(output(&mut jaka(&["--version"])).0.starts_with("jaka "));
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
