//! The commands that pages show: each line of `jaka` runs as it stands, and each line of cargo names what there is.
//!
//! Robots of the pages are names in a config file that leads to a simulated controller. A person answers yes where a
//! command asks; here `--yes` does. What listens at the ports of a real controller listens at free ones, `jaka jitter`
//! takes a moment in place of minutes, and `jaka monitor` gets a terminal of its own, on which `q` is typed.

#![cfg(unix)]

mod named;

use std::collections::BTreeMap;
use std::fs;
#[cfg(target_os = "linux")]
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::Mutex;
use std::thread;

use jaka_sim::Controller;
use jaka_tests::Arm;

use crate::common::{end, interrupt, wait_until};
use crate::program::{jaka, scratch};
#[cfg(target_os = "linux")]
use crate::pseudo;

/// Lines that may end otherwise than with 0, and how.
const OTHER_CODES: [(&str, &[i32]); 5] = [
    // The controller does not know it.
    ("jaka call new_command --raw", &[1]),
    // There may be something to look at: an arm without power, a machine that is slow.
    ("jaka check", &[0, 8]),
    // A machine that holds up the program or the controller ends it otherwise.
    ("jaka follow weld.csv --model zu5 --sim", &[0, 4, 28, 30]),
    ("jaka follow weld.csv -r", &[0, 4, 28, 30]),
    ("jaka follow seam.csv -r", &[0, 4, 28, 30]),
];

const PACK: &str = include_str!("guide/newer.toml");

/// A recording that can be replayed, with status packets.
const SESSION: &str = r#"{"jaka_recording":1,"started":1763726000.5,"software":"a test"}
{"time":0.001,"port":"command","connection":1,"event":"connected","address":"10.5.5.100:10001"}
{"time":0.002,"port":"command","connection":1,"event":"sent","text":"{\"cmdName\":\"get_version\"}"}
{"time":0.004,"port":"command","connection":1,"event":"received","text":"{\"errorCode\":\"0\",\"errorMsg\":\"\",\"cmdName\":\"get_version\",\"version\":\"1.7\"}"}
{"time":0.005,"port":"command","connection":1,"event":"closed","by":"client","why":"the program has closed it"}
{"time":0.006,"port":"status","connection":2,"event":"connected","address":"10.5.5.100:10000"}
{"time":0.007,"port":"status","connection":2,"event":"received","text":"{\"enabled\":true,\"joint_actual_position\":[0,90,90,90,-90,0]}"}
{"time":0.107,"port":"status","connection":2,"event":"received","text":"{\"enabled\":true,\"joint_actual_position\":[1,90,90,90,-90,0]}"}
"#;

const README: &str = include_str!("../README.md");

fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
}

/// The pages, and the text of each.
fn pages() -> Vec<(String, String)> {
    let docs =
        fs::read_dir(root().join("docs")).expect("it is there").map(|entry| entry.expect("it can be read").path());
    let docs = docs.filter(|path| path.extension().is_some_and(|extension| extension == "md"));
    let readmes = ["README.md", "README.zh.md", "CONTRIBUTING.md", "jaka-cli/README.md", "jaka-sim/README.md"]
        .map(|page| root().join(page));
    let mut pages: Vec<_> = docs.chain(readmes).collect();
    pages.sort();
    let named = |path: &PathBuf| path.strip_prefix(root()).expect("it is below").display().to_string();
    pages.iter().map(|path| (named(path), fs::read_to_string(path).expect("it is text"))).collect()
}

/// The lines of a page's blocks of shell commands, without comments; those of scripts have tests of their own.
fn lines(page: &str) -> Vec<&str> {
    let blocks = page.split("\n```sh\n").skip(1).filter_map(|rest| rest.split("\n```").next());
    let lines = blocks.filter(|block| !block.starts_with("#!")).flat_map(str::lines);
    let indented = page.lines().filter_map(|line| line.strip_prefix("    ")).filter(|line| line.starts_with("cargo "));
    lines.chain(indented).map(without_comment).filter(|line| !line.is_empty()).collect()
}

/// The line up to a `#` that follows a blank.
fn without_comment(line: &str) -> &str {
    line.split_once(" #").map_or(line, |(line, _)| line).trim()
}

/// A folder with the files that the pages name.
fn folder() -> PathBuf {
    let folder = scratch("pages");
    fs::remove_dir_all(&folder).ok();
    fs::create_dir_all(folder.join("spec")).expect("it can be made");
    let write = |name: &str, text: &str| fs::write(folder.join(name), text).expect("it can be written");
    for source in jaka_spec::BUILTIN {
        let name = Path::new(source.path).file_name().expect("it is a file");
        fs::write(folder.join("spec").join(name), source.text).expect("it can be written");
    }
    let limits = include_str!("../../jaka-robot/examples/limits.toml");
    let mut blocks = README.split("\n```csv\n").skip(1).filter_map(|rest| Some(rest.split_once("```")?.0));
    let mut block = || blocks.next().expect("the README has two trajectories");
    let (way, seam) = (block(), block());
    let files =
        [("limits.toml", limits), ("cell1.toml", limits), ("weld.csv", way), ("way.csv", way), ("seam.csv", seam)];
    for (name, text) in files {
        write(name, text);
    }
    let line = r#"{"cmdName":"moveL","relFlag":1,"cartPosition":[0,0,1,0,0,0],"speed":20,"accel":100,"tol":0}"#;
    write("request.json", line);
    folder
}

/// Makes the robots of the pages lead to a controller.
fn write_config(folder: &Path, controller: &Controller) {
    let robot = |name: &str| {
        let (commands, status) = (controller.command_addr().port(), controller.status_addr().port());
        let ports = format!("command_port = {commands}\nstatus_port = {status}\n");
        let times = "timeout = 60\nconnect_timeout = 60\nstale_after = 60\n";
        format!("[robots.\"{name}\"]\naddress = '127.0.0.1'\n{ports}{times}")
    };
    let text = format!("robot = 'cell1'\n{}{}", robot("cell1"), robot("10.5.5.100"));
    fs::write(folder.join("config.toml"), text).expect("it can be written");
}

/// The line as it is run: on free ports, and with a yes if that is asked for.
fn runnable(line: &str, yes: &str) -> String {
    let (command, file) =
        line.split_once(" > ").map_or((line, String::new()), |(line, file)| (line, format!(" > {file}")));
    let serves = command.starts_with("jaka sim") || command.starts_with("jaka replay") && !command.contains("--show");
    let ports = if command.contains("--listen 127") {
        " --listen-commands 0 --listen-status 0"
    } else if serves && !command.contains("--commands 0") {
        " --commands 0 --status 0"
    } else {
        ""
    };
    let command = if command.starts_with("jaka jitter") { in_a_moment(command) } else { command.to_owned() };
    format!("exec {command}{ports}{yes}{file}")
}

/// The line with a short time in place of its own.
fn in_a_moment(line: &str) -> String {
    let (before, after) = line.split_once(" --seconds ").unwrap_or((line, ""));
    let rest = after.split_once(' ').map_or(String::new(), |(_, rest)| format!(" {rest}"));
    format!("{before}{rest} --seconds 0.4")
}

/// True if the command goes on until it is interrupted.
fn goes_on(line: &str) -> bool {
    let serves = line.starts_with("jaka sim ") || line.starts_with("jaka replay") && !line.contains("--show");
    (serves && !line.contains("--help")) || line.starts_with("jaka record ") || line.contains(" --watch")
}

/// The line at work in a shell, in this folder, with its output in files.
fn start(folder: &Path, line: &str) -> Child {
    let mut shell = Command::new("sh");
    shell.args(["-c", line]).stdin(Stdio::null());
    prepare(&mut shell, folder).spawn().expect("there is a shell")
}

/// The command in this folder, with its output in files.
fn prepare<'c>(command: &'c mut Command, folder: &Path) -> &'c mut Command {
    let file = |name: &str| fs::File::create(folder.join(name)).expect("it can be written");
    let program = Path::new(env!("CARGO_BIN_EXE_jaka")).parent().expect("it is in a folder").to_owned();
    let paths = std::env::var_os("PATH").expect("there is one");
    let path = std::env::join_paths(std::iter::once(program).chain(std::env::split_paths(&paths)));
    command.current_dir(folder).env("PATH", path.expect("it has no colon"));
    command.env("JAKA_CONFIG", folder.join("config.toml")).env_remove("JAKA_ROBOT").env_remove("JAKA_PACK");
    command.stdout(file("out")).stderr(file("err"))
}

/// A dashboard on a terminal: a picture of packets that come, and `q`. None where the machine has no such terminal.
#[cfg(target_os = "linux")]
fn run_monitor(folder: &Path, line: &str) -> Option<(Option<i32>, String)> {
    let mut terminal = pseudo::terminal(&format!("exec {line}"));
    prepare(&mut terminal, folder);
    let mut child = pseudo::started(terminal)?;
    let shown = || fs::read_to_string(folder.join("out")).unwrap_or_default();
    wait_until(line, || shown().contains("live") || has_ended(&mut child));
    let mut keys = child.stdin.take().expect("it is piped");
    keys.write_all(b"q").ok();
    Some((end(child).code(), shown()))
}

/// Terminals are other systems' in other ways.
#[cfg(not(target_os = "linux"))]
fn run_monitor(_folder: &Path, _line: &str) -> Option<(Option<i32>, String)> {
    None
}

/// Waits until a command that goes on has shown something in this file, once it handles Ctrl-C, and interrupts it.
fn interrupt_when_it_works(line: &str, shown: &Path, child: &mut Child) {
    wait_until(line, || fs::metadata(shown).is_ok_and(|file| file.len() > 0) || has_ended(child));
    if !has_ended(child) {
        interrupt(child);
    }
}

fn has_ended(child: &mut Child) -> bool {
    child.try_wait().expect("it is a child").is_some()
}

/// Runs a line to its end: its exit code, and what it said.
fn run(folder: &Path, line: &str, yes: &str) -> (Option<i32>, String) {
    let line = runnable(line, yes);
    fs::write(folder.join("out"), "").and_then(|()| fs::write(folder.join("err"), "")).expect("they can be written");
    let shown = folder.join(line.split_once(" > ").map_or("out", |(_, file)| file));
    let mut child = start(folder, &line);
    if goes_on(line.trim_start_matches("exec ")) {
        interrupt_when_it_works(&line, &shown, &mut child);
    }
    let code = end(child).code();
    let text = |name: &str| fs::read_to_string(folder.join(name)).unwrap_or_default();
    (code, text("out") + &text("err"))
}

/// Folder in which lines run, and arms that are as lines need them.
struct Place {
    folder: PathBuf,
    quick: Arm,
    /// For set-points, which come in real time.
    steady: Arm,
}

impl Place {
    fn new() -> Self {
        let arm = |time_scale| Arm::real_time().controller(|controller| controller.time_scale(time_scale)).start();
        Self { folder: folder(), quick: arm(5.0), steady: arm(1.0) }
    }

    /// Runs a line of a page on an arm that is powered and enabled.
    fn assert_runs(&self, page: &str, line: &str) {
        let controller = if line.starts_with("jaka follow") { &self.steady } else { &self.quick };
        write_config(&self.folder, controller);
        controller.set_state(|state| (state.powered, state.enabled) = (true, true));
        // What a line reads is there, whatever the lines before have written in its place; what it writes is not.
        for (name, text) in [("session.jsonl", SESSION), ("newer.toml", PACK)] {
            fs::write(self.folder.join(name), text).expect("it can be written");
        }
        for name in named::written(line) {
            fs::remove_file(self.folder.join(name)).ok();
        }
        let is_monitor = line.starts_with("jaka monitor");
        let ended = if is_monitor { run_monitor(&self.folder, line) } else { Some(run(&self.folder, line, "")) };
        let Some(mut ended) = ended else { return };
        if ended.0 == Some(2) && ended.1.contains("--yes") {
            ended = run(&self.folder, line, " --yes");
        }
        let other = OTHER_CODES.iter().find(|(begin, _)| line.starts_with(begin));
        let codes = other.map_or(&[0][..], |(_, codes)| *codes);
        assert!(ended.0.is_some_and(|code| codes.contains(&code)), "{page}: {line}\n{ended:?}");
    }
}

#[test]
fn every_line_of_jaka_runs_as_it_stands() {
    let pages = pages();
    let all = pages.iter().flat_map(|(page, text)| lines(text).into_iter().map(move |line| (line, &**page)));
    let all: Vec<_> = all.filter(|(line, _)| line.starts_with("jaka ")).collect();
    assert!(all.len() > 50, "{all:?}");
    // One that several pages have runs once. Lines wait for arms most of the time.
    let left = Mutex::new(all.into_iter().collect::<BTreeMap<_, _>>().into_iter());
    thread::scope(|scope| {
        for number in 0..8 {
            // Each has a folder of its own, by the thread's name.
            let worker = thread::Builder::new().name(format!("pages-{number}"));
            let next = || left.lock().expect("no other has panicked with it").next();
            let work = move || {
                let place = Place::new();
                std::iter::from_fn(next).for_each(|(line, page)| place.assert_runs(page, line));
            };
            worker.spawn_scoped(scope, work).expect("a thread starts");
        }
    });
}

#[test]
fn every_line_of_cargo_and_of_scripts_names_what_there_is() {
    let mut count = 0;
    for (page, text) in pages() {
        for line in lines(&text) {
            count += 1;
            assert_eq!(named::missing(root(), line), None, "{page}: {line}");
        }
    }
    assert!(count > 60, "{count}");
    for wrong in [
        "cargo run --example second_motion",
        "cargo bench --manifest-path benches/Cargo.toml --bench none",
        "fuzz/campain 60",
        "jaka-sync",
    ] {
        assert!(named::missing(root(), wrong).is_some(), "{wrong}");
    }
}

#[test]
fn what_jaka_says_is_quoted_as_it_is() {
    let page = fs::read_to_string(root().join("docs/troubleshooting.md")).expect("it is there");
    let (_, part) = page.split_once("\n# From `jaka` alone\n").expect("the page has the part");
    let rows: Vec<_> = part.lines().filter_map(|line| line.strip_prefix("| `jaka ")?.strip_suffix(" |")).collect();
    assert_eq!(rows.len(), 4);
    for row in rows {
        let (typed, rest) = row.split_once("` | ").expect("a row has cells");
        let quoted = rest.split("``").nth(1).expect("it is quoted").trim();
        // Without a robot at the address: none of these connects to one.
        let run = jaka(typed.trim_end_matches(" < /dev/null").split(' '));
        assert_eq!((run.code, run.err), (Some(2), format!("error: {quoted}\n")), "jaka {typed}");
    }
}
