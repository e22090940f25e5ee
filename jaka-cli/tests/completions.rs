//! Completions: what the scripts of shells do, where the shell is installed.

#![cfg(unix)]

use std::process::{Command, Stdio};
use std::{env, fs, iter};

use jaka_tests::{left_out, skipped};

use crate::program::{Run, command, jaka, pack, result, scratch};

/// A recording whose packets have three fields.
const SESSION: &str = r#"{"jaka_recording":1,"started":1763726000.5,"software":"a test"}
{"time":0.001,"port":"status","connection":1,"event":"received","text":"{\"enabled\":true,\"joint_actual_position\":[1,2,3,4,5,6],\"errcode\":\"0x0\"}"}
{"time":0.002,"port":"status","connection":1,"#;

const CONFIG: &str = "[robots.cell1]\naddress = '10.5.5.100'\n[robots.'cell 2']\naddress = 'arm.example'\n";

/// Script of bash that completes the words of a line, of which the last is the one at the cursor. Prints a line for
/// each word that it can become.
const ASK: &str = r#"
source "$1"; shift
COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1))
_jaka jaka
printf '%s\n' "${COMPREPLY[@]}"
"#;

/// The program with its folder in the path.
fn shell(name: &str) -> Command {
    let folder = std::path::Path::new(env!("CARGO_BIN_EXE_jaka")).parent().expect("it is in a folder").to_owned();
    let paths = env::var_os("PATH").expect("there is one");
    let mut shell = Command::new(name);
    let path = env::join_paths(iter::once(folder).chain(env::split_paths(&paths))).expect("it has no colon");
    let config = scratch("config.toml");
    fs::write(&config, CONFIG).expect("it can be written");
    shell.env("PATH", path).env("JAKA_CONFIG", config).env_remove("JAKA_PACK").current_dir(folder_of_files());
    shell.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    shell
}

fn folder_of_files() -> std::path::PathBuf {
    let session = scratch("files/session.jsonl");
    let folder = session.parent().expect("it is in one").to_owned();
    fs::create_dir_all(&folder).and_then(|()| fs::write(&session, SESSION)).expect("it can be written");
    folder
}

/// Script of zsh that completes the words of a line. Functions in place of those of its completion system print their
/// arguments.
const ASK_ZSH: &str = r#"
compdef() { :; }
compset() { print -r -- "before: ${PREFIX%%=*}="; }
_files() { print -r -- files; }
_describe() { local word; for word in "${(@P)2}"; do print -r -- "${${word//\\:/$'\0'}%%:*}"; done; }
source "$1"; shift
words=("$@"); CURRENT=$#; PREFIX=${words[-1]}
_jaka
"#;

/// Script of fish that completes a line.
const ASK_FISH: &str = "source $argv[1]; complete -C $argv[2]";

/// Runs a script of this shell with these words, which sources the completions of `jaka` for it. Returns the lines that
/// it prints.
fn asked(name: &str, options: &[&str], ask: &str, words: &[&str]) -> Vec<String> {
    let script = scratch(&format!("jaka.{name}"));
    fs::write(&script, jaka(["completions", name]).out).expect("it can be written");
    let mut shell = shell(name);
    shell.args(options).args(["-c", ask]);
    if name != "fish" {
        shell.arg(name);
    }
    shell.arg(script).args(words);
    let Run { code, out, err } = result(shell.spawn().expect("the shell is installed"));
    assert_eq!((code, err.as_str()), (Some(0), ""), "{words:?}");
    out.lines().filter(|line| !line.is_empty()).map(str::to_owned).collect()
}

/// Completions of the words in bash, which has `=` as a word of its own.
fn in_bash(words: &[&str]) -> Vec<String> {
    asked("bash", &[], ASK, &[&["jaka"], words].concat())
}

fn is_installed(shell: &str) -> bool {
    let found = Command::new(shell).arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
    found.is_ok_and(|status| status.success())
}

#[test]
fn bash_completes_what_the_parser_takes() {
    if !is_installed("bash") {
        return skipped("completions of bash", "it is not installed");
    }
    for (words, expected) in [
        (&["sta"][..], &["status"][..]),
        (&["spec", "d"], &["diff", "doc"]),
        (&["call", "set_pay"], &["set_payload"]),
        (&["call", "joint_move", "--mo"], &["--mode"]),
        (&["call", "joint_move", "--mode", ""], &["absolute", "relative"]),
        (&["call", "joint_move", "--mode", "="], &["absolute", "relative"]),
        (&["call", "joint_move", "--mode", "=", "rel"], &["relative"]),
        (&["call", "joint_move", "--mode", "=", "relative", "--spe"], &["--speed"]),
        (&["status", "--sim", "=", "zu1"], &["zu12", "zu18"]),
        (&["status", "--robot", ""], &["cell1", "cell\\ 2"]),
        (&["status", "-r", "cell1"], &["cell1"]),
        (&["export", "session.jsonl", "--fields", ""], &["enabled", "error_code", "joint_actual_position"]),
        (&["export", "session.jsonl", "--fields", "enabled,jo"], &["enabled\\,joint_actual_position"]),
        (&["replay", "ses"], &["session.jsonl"]),
        (&["nothing", "like", "that", "-"], &["--color", "--help", "--quiet", "--verbose", "--version"]),
        (&["jog", "1", "5", "--speed", "2"], &[]),
    ] {
        let mut found = in_bash(words);
        found.sort();
        assert_eq!(found, expected, "{words:?}");
    }
    let packed = in_bash(&["call", "--pack", &pack("newer.toml"), "demo_"]);
    assert_eq!(packed.len(), 3, "{packed:?}");
}

#[test]
fn fish_completes_what_the_parser_takes() {
    if !is_installed("fish") {
        return left_out("completions of fish", "it is not installed");
    }
    for (line, expected) in [
        ("jaka sta", &["status"][..]),
        ("jaka spec d", &["diff", "doc"]),
        ("jaka jog ", &["1", "2", "3", "4", "5", "6", "x", "y", "z"]),
        ("jaka jog 6 5 --sp", &["--speed"]),
        ("jaka call joint_move --mode ", &["absolute", "relative"]),
        ("jaka call joint_move --mode=rel", &["--mode=relative"]),
        ("jaka status --robot ", &["cell 2", "cell1"]),
        ("jaka export session.jsonl --fields enabled,jo", &["enabled,joint_actual_position"]),
        ("jaka status --until '!protective_s", &["'!protective_stop"]),
        ("jaka replay ses", &["session.jsonl"]),
        ("jaka status --config=ses", &["--config=session.jsonl"]),
        ("jaka jog 1 5 --speed 2", &[]),
    ] {
        let mut found = asked("fish", &["--no-config"], ASK_FISH, &[line]);
        for word in &mut found {
            // Its help follows a tabulator.
            word.truncate(word.find('\t').unwrap_or(word.len()));
        }
        found.sort();
        assert_eq!(found, expected, "{line}");
    }
}

#[test]
fn zsh_completes_what_the_parser_takes() {
    if !is_installed("zsh") {
        return left_out("completions of zsh", "it is not installed");
    }
    for (words, expected) in [
        (&["sta"][..], &["status"][..]),
        (&["spec", "d"], &["diff", "doc"]),
        (&["jog", ""], &["1", "2", "3", "4", "5", "6", "x", "y", "z"]),
        (&["call", "joint_move", "--mode=rel"], &["--mode=relative"]),
        (&["status", "--robot", "cell\\ "], &["cell 2"]),
        (&["export", "session.jsonl", "--fields", "enabled,jo"], &["enabled,joint_actual_position"]),
        (&["replay", "ses"], &["files"]),
        (&["status", "--config=ses"], &["before: --config=", "files"]),
        (&["jog", "1", "5", "--speed", "2"], &[]),
    ] {
        let mut found = asked("zsh", &["-f"], ASK_ZSH, &[&["jaka"], words].concat());
        found.sort();
        assert_eq!(found, expected, "{words:?}");
    }
}

#[test]
fn every_script_asks_the_program() {
    for name in ["bash", "zsh", "fish", "powershell"] {
        let script = jaka(["completions", name]);
        assert_eq!((script.code, script.err.as_str()), (Some(0), ""));
        assert!(script.out.contains("complete-words"), "{name}");
    }
    assert_eq!(jaka(["completions", "tcsh"]).code, Some(2));
}

#[test]
fn words_have_a_line_with_what_they_mean() {
    let mut asked = command(["complete-words", "--current=--", "--", "call", "joint_move"]);
    let run = result(asked.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the program starts"));
    let mut lines = run.out.lines();
    assert_eq!(lines.next(), Some("words"));
    assert!(lines.next().is_some_and(|line| line.starts_with("--mode\t")), "{}", run.out);
    assert!(lines.clone().all(|line| line.starts_with("--") && line.matches('\t').count() == 1), "{}", run.out);
    assert_eq!(jaka(["complete-words", "--current=", "--", "replay"]).out, "file\n");
    assert!(!jaka(["--help"]).out.contains("complete-words"));
}
