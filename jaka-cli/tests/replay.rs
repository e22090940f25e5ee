//! `jaka replay`: recordings that are shown, and that are served in place of a robot.

#![allow(clippy::needless_raw_string_hashes, reason = "expect-test writes them")]

use std::fs;

use expect_test::expect;

use crate::program::{Run, jaka, scratch};

/// All that a recording can have in it.
const SESSION: &str = r#"{"jaka_recording":1,"started":1763726000.5,"software":"a test"}
{"time":0.001,"port":"command","connection":1,"event":"connected","address":"10.5.5.100:10001"}
{"time":0.002,"port":"command","connection":1,"event":"sent","text":"{\"cmdName\":\"get_version\"}"}
{"time":0.0045,"port":"command","connection":1,"event":"received","text":"{\"errorCode\":\"0\",\n\"cmdName\":\"get_version\",\"version\":\"1.7\"}"}
{"time":0.005,"port":"status","connection":2,"event":"connected","address":"10.5.5.100:10000"}
{"time":0.006,"port":"status","connection":2,"event":"received","text":"{\"inpos\":true}"}
{"time":0.01,"port":"command","connection":1,"event":"sent","text":"{\"cmdName\":\"enable_robot\"}"}
{"time":0.02,"port":"command","connection":1,"event":"received","text":"{\"errorCode\":\"2\",\"errorMsg\":\"no power\"}"}
{"time":0.056,"port":"status","connection":2,"event":"received","text":"{\"inpos\":true}"}
{"time":0.06,"port":"command","connection":1,"event":"sent","text":"{\"cmdName\":\"get_joint_pos\"}"}
{"time":0.2,"port":"status","connection":2,"event":"received","hex":"7bff7d"}
{"time":0.21,"port":"status","connection":2,"event":"dropped","count":3}
{"time":5.06,"port":"command","connection":1,"event":"error","text":"no reply to `get_joint_pos` within 5s"}
{"time":5.07,"port":"command","connection":1,"event":"closed","by":"client","why":"the program has closed it"}
{"time":5.08,"port":"status","connection":2,"event":"closed","by":"failure","why":"the connection was reset"}
"#;

/// A recording of this text.
fn recording(name: &str, text: &str) -> String {
    let path = scratch(name);
    fs::write(&path, text).unwrap();
    path.display().to_string()
}

fn show(name: &str, text: &str, options: &[&str]) -> String {
    let path = recording(name, text);
    let run: Run = jaka(["replay", &path, "--show"].iter().chain(options));
    run.text().replace(&path, "session.jsonl")
}

#[test]
fn everything_is_shown_and_summed_up() {
    expect![[r#"
        recorded by a test, from 2025-11-21 11:53:20 UTC
            0.001000  command  1  connected to 10.5.5.100:10001
            0.002000  command  1  -> {"cmdName":"get_version"}
            0.004500  command  1  <- {"errorCode":"0", "cmdName":"get_version","version":"1.7"}
            0.005000  status   2  connected to 10.5.5.100:10000
            0.006000  status   2  <- {"inpos":true}
            0.010000  command  1  -> {"cmdName":"enable_robot"}
            0.020000  command  1  <- {"errorCode":"2","errorMsg":"no power"}
            0.056000  status   2  <- {"inpos":true}
            0.060000  command  1  -> {"cmdName":"get_joint_pos"}
            0.200000  status   2  <- {\xff}
            0.210000  status   2  3 entries are missing here
            5.060000  command  1  error: no reply to `get_joint_pos` within 5s
            5.070000  command  1  closed by client: the program has closed it
            5.080000  status   2  closed by failure: the connection was reset

        3 requests: 1 carried out, 1 refused, 1 without reply
        slowest replies:
            0.010000  enable_robot after 0.010000 s
            0.002000  get_version after 0.002500 s
        without reply:
            0.060000  get_joint_pos
        3 status packets, the longest gap 0.144000 s before 0.200000
        3 entries are missing, because the file could not be written fast enough
        exit code 0
    "#]]
    .assert_eq(&show("all.jsonl", SESSION, &[]));
}

#[test]
fn a_command_is_shown_alone() {
    // Also the reply that does not name its command.
    expect![[r#"
        recorded by a test, from 2025-11-21 11:53:20 UTC
            0.010000  command  1  -> {"cmdName":"enable_robot"}
            0.020000  command  1  <- {"errorCode":"2","errorMsg":"no power"}

        1 request: 0 carried out, 1 refused, 0 without reply
        slowest replies:
            0.010000  enable_robot after 0.010000 s
        exit code 0
    "#]]
    .assert_eq(&show("command.jsonl", SESSION, &["--command", "enable_robot"]));
    let nothing = show("nothing.jsonl", SESSION, &["--command", "no_such_command"]);
    expect![[r"
        recorded by a test, from 2025-11-21 11:53:20 UTC

        warning: the recording has no request of `no_such_command`; it has `enable_robot`, `get_joint_pos`, `get_version`
        exit code 0
    "]]
    .assert_eq(&nothing);
}

#[test]
fn long_messages_are_shortened_and_long_lists_too() {
    let mut text = SESSION.lines().next().unwrap().to_owned() + "\n";
    let request = SESSION.lines().nth(2).unwrap();
    for time in 1..=7 {
        text += &request.replace("0.002", &time.to_string());
        text += "\n";
    }
    text += &SESSION.lines().nth(5).unwrap().replace("true", &format!("[{}]", "1,".repeat(200)));
    text += "\n";
    expect![[r#"
        recorded by a test, from 2025-11-21 11:53:20 UTC
            1.000000  command  1  -> {"cmdName":"get_version"}
            2.000000  command  1  -> {"cmdName":"get_version"}
            3.000000  command  1  -> {"cmdName":"get_version"}
            4.000000  command  1  -> {"cmdName":"get_version"}
            5.000000  command  1  -> {"cmdName":"get_version"}
            6.000000  command  1  -> {"cmdName":"get_version"}
            7.000000  command  1  -> {"cmdName":"get_version"}
            0.006000  status   2  <- {"inpos":[1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,… (412 bytes)

        7 requests: 0 carried out, 0 refused, 7 without reply
        without reply:
            1.000000  get_version
            2.000000  get_version
            3.000000  get_version
            4.000000  get_version
            5.000000  get_version
                      and 2 more
        1 status packet
        exit code 0
    "#]].assert_eq(&show("long.jsonl", &text, &[]));
}

#[test]
fn a_recording_that_is_cut_off_is_used_and_a_damaged_one_is_not() {
    let first: String = SESSION.lines().take(2).map(|line| line.to_owned() + "\n").collect();
    expect![[r"
        recorded by a test, from 2025-11-21 11:53:20 UTC
            0.001000  command  1  connected to 10.5.5.100:10001

        warning: session.jsonl: the file ends in the middle of a line: line 3 of the recording cannot be read: not JSON: expected `,` or `}` at byte 11, where the text ends
        exit code 0
    "]].assert_eq(&show("cut.jsonl", &(first.clone() + "{\"time\":0.0"), &[]));
    expect![[r"
        error: session.jsonl: line 3 of the recording cannot be read: field `port`: the key `port` is missing
        exit code 2
    "]]
    .assert_eq(&show("damaged.jsonl", &(first + "{\"time\":0.0}\n"), &[]));
    expect![[r"
        error: session.jsonl: line 1 of the recording cannot be read: field `jaka_recording`: the key `jaka_recording` is missing
        exit code 2
    "]].assert_eq(&show("other.jsonl", "{\"a\":1}\n", &[]));
    assert_eq!(jaka(["replay", "nowhere.jsonl"]).code, Some(2));
}

/// Recordings that are served until Ctrl-C.
#[cfg(unix)]
mod served {
    use std::io::{BufRead, BufReader, Read, Write};
    use std::net::TcpStream;
    use std::process::{Child, ChildStdout};
    use std::thread;
    use std::time::Duration;

    use super::*;
    use crate::common::{end, interrupt, started};
    use crate::program::command;

    /// A replay at work, and the options that name it.
    fn serve(path: &str, options: &[&str]) -> (Child, BufReader<ChildStdout>, [String; 6]) {
        let ports = ["--commands", "0", "--status", "0"];
        let (child, out, line) = started(&mut command(["replay", path].iter().chain(&ports).chain(options)));
        let mut ports = line.split([':', ',', '\n']).filter_map(|word| word.parse::<u16>().ok());
        let mut port = || ports.next().expect("there are two").to_string();
        let robot = ["-r", "127.0.0.1", "--command-port", &port(), "--status-port", &port()].map(str::to_owned);
        (child, out, robot)
    }

    fn call<'a>(name: &'a str, robot: &'a [String]) -> Run {
        jaka(["call", name].into_iter().chain(robot.iter().map(String::as_str)))
    }

    /// A recording of one `jaka call get_version`.
    fn version(name: &str) -> String {
        let path = scratch(name);
        fs::remove_file(&path).ok();
        let path = path.display().to_string();
        assert_eq!(jaka(["call", "get_version", "--sim", "--record", &path]).code, Some(0));
        path
    }

    /// Interrupts a replay, and returns its output after the addresses.
    fn finish(child: Child, out: BufReader<ChildStdout>) -> String {
        interrupt(&child);
        rest(child, out)
    }

    /// Output until its end, errors and exit code.
    fn rest(mut child: Child, mut out: BufReader<ChildStdout>) -> String {
        let (mut text, mut errors) = (String::new(), String::new());
        out.read_to_string(&mut text).unwrap();
        child.stderr.take().unwrap().read_to_string(&mut errors).unwrap();
        format!("{text}{errors}exit code {:?}\n", end(child).code())
    }

    #[test]
    fn the_recorded_session_is_served() {
        let (child, out, robot) = serve(&version("serve.jsonl"), &[]);
        assert_eq!(call("get_version", &robot).text(), "version  1.5.14_13_X64\nexit code 0\n");
        assert_eq!(finish(child, out), "exit code Some(0)\n");
    }

    #[test]
    fn another_request_than_the_recorded_one_is_reported() {
        let (child, mut out, robot) = serve(&version("deviates.jsonl"), &["--timing", "immediate"]);
        assert_eq!(call("get_joint_pos", &robot).code, Some(4));
        let mut line = String::new();
        out.read_line(&mut line).unwrap();
        expect![[r#"
            deviation: expected the recorded request `{"cmdName":"get_version"}`, but received `{"cmdName":"get_joint_pos"}`
            error: 1 deviation from the recording
            exit code Some(7)
        "#]]
        .assert_eq(&(line + &finish(child, out)));
    }

    #[test]
    fn all_deviations_are_written_however_slow_the_reader_is() {
        let (child, out, robot) = serve(&version("slow.jsonl"), &["--mode", "matching"]);
        let mut client = TcpStream::connect(format!("127.0.0.1:{}", robot[3])).unwrap();
        // More than a pipe has room for.
        let name = "x".repeat(2000);
        for _ in 0..100 {
            write!(client, "{{\"cmdName\":\"{name}\"}}").unwrap();
            assert!(client.read(&mut [0; 1000]).unwrap() > 0, "it is answered");
        }
        interrupt(&child);
        // Before a short wait the program has no reason to give up. This makes the test slower, and never wrong.
        thread::sleep(Duration::from_millis(1500));
        let found = rest(child, out);
        assert_eq!(found.matches("deviation: ").count(), 100);
        assert!(found.ends_with("error: 100 deviations from the recording\nexit code Some(7)\n"), "{found}");
    }

    #[test]
    fn matching_answers_in_any_order() {
        let path = recording("matching.jsonl", SESSION);
        let (child, out, robot) = serve(&path, &["--mode", "matching", "--timing", "immediate"]);
        assert_eq!(call("enable_robot", &robot).code, Some(2), "it is asked about");
        let yes: Vec<_> = robot.iter().cloned().chain(["--yes".to_owned()]).collect();
        assert_eq!(call("enable_robot", &yes).code, Some(1));
        assert_eq!(call("get_version", &robot).text(), "version  1.7\nexit code 0\n");
        assert_eq!(call("get_version", &robot).code, Some(1), "there is one reply");
        let found = finish(child, out);
        expect![[r#"
            deviation: the recording has no unused reply to `{"cmdName":"get_version"}`
            error: 1 deviation from the recording
            exit code Some(7)
        "#]]
        .assert_eq(&found);
    }
}
