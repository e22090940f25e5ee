//! System calls that the client makes, counted by strace: a program that does a thing N times and one that does it 2 N
//! times differ by what N times take. The beginning of a thread is a call, too.

#[path = "../../tests/src/skipped.rs"]
#[allow(unreachable_pub, reason = "it is public where it lives")]
mod skipped;

use std::collections::BTreeMap;
use std::net::TcpListener;
use std::process::Command;
use std::thread;

use jaka_benches::system::canned;

use self::skipped::skipped;

/// Number of repetitions of a count that a busy machine may raise. The lowest count is decisive.
const ROUNDS: usize = 5;

/// Number of system calls by name.
type Counts = BTreeMap<String, i64>;

/// A server with printed answers, in this process, which is not counted.
fn server() -> [String; 2] {
    let commands = TcpListener::bind("127.0.0.1:0").expect("loopback has free ports");
    let status = TcpListener::bind("127.0.0.1:0").expect("loopback has free ports");
    let addresses = [&commands, &status].map(|port| port.local_addr().expect("it is bound").to_string());
    thread::spawn(move || canned::serve(&commands));
    thread::spawn(move || canned::keep_silent(&status));
    addresses
}

/// Counts the system calls of a program that does a thing so often; none if strace is missing or must not trace.
fn of(what: &str, count: i64) -> Option<Counts> {
    let [commands, status] = server();
    let program = [env!("CARGO_BIN_EXE_calls"), what, &commands, &status, &count.to_string()];
    let output = Command::new("strace").args(["-f", "-c"]).args(program).output().ok();
    let traced = output.map(|output| (output.status.success(), String::from_utf8_lossy(&output.stderr).into_owned()));
    let Some((is_success, summary)) = traced.filter(|(success, summary)| *success || !summary.contains("ptrace"))
    else {
        skipped("the system calls of the client", "strace is missing, or must not trace");
        return None;
    };
    assert!(is_success, "{summary}");
    Some(counts(&summary))
}

/// Counts the system calls that `count` more runs take.
fn each(what: &str, count: i64) -> Option<Counts> {
    let (once, twice) = (of(what, count)?, of(what, 2 * count)?);
    let difference = |(name, two): (String, i64)| {
        let more = two - once.get(&name).copied().unwrap_or_default();
        (more != 0).then_some((name, more))
    };
    Some(twice.into_iter().filter_map(difference).collect())
}

/// Reads the table of `strace -c`: share, seconds, microseconds each, calls, errors where there are any, name.
fn counts(summary: &str) -> Counts {
    let row = |line: &str| {
        let fields: Vec<_> = line.split_whitespace().collect();
        let share = fields.first()?.parse::<f64>();
        let (calls, name) = (fields.get(3)?.parse().ok()?, fields.last()?);
        (share.is_ok() && *name != "total").then(|| ((*name).to_owned(), calls))
    };
    summary.lines().filter_map(row).collect()
}

/// Finds a problem in the system calls of this many set-points; none if they are correct.
fn problem_of_set_points(counts: &Counts, set_points: i64) -> Option<&'static str> {
    let of = |name: &str| counts.get(name).copied().unwrap_or_default();
    if of("sendto") != set_points {
        return Some("a set-point is not one write");
    }
    // Fewer are well: two answers may come in one read. At the end the last answers are asked for until they have come,
    // and the monitor looks up about each second.
    if of("recvfrom") > set_points + set_points / 2 {
        return Some("a set-point is more than one read");
    }
    let settings = ["ioctl", "fcntl", "setsockopt"].map(of);
    settings.iter().any(|&count| count > 0).then_some("the socket's mode or timeout changes")
}

#[test]
fn a_call_is_one_write_and_one_read() {
    let Some(counts) = each("call", 1000) else { return };
    // Each call waits for its reply, so that no two can come in one read.
    assert_eq!(counts, Counts::from([("sendto".to_owned(), 1000), ("recvfrom".to_owned(), 1000)]));
}

#[test]
fn a_set_point_is_one_write_and_one_read() {
    let mut problems = Vec::new();
    for _ in 0..ROUNDS {
        let Some(counts) = each("servo", 50) else { return };
        let Some(problem) = problem_of_set_points(&counts, 50) else { return };
        problems.push((problem, counts));
    }
    panic!("{problems:#?}");
}

#[test]
fn a_client_has_no_thread_and_a_monitor_has_one() {
    for (what, threads) in [("call", 0), ("servo", 1)] {
        let Some(counts) = of(what, 1) else { return };
        // Each thread makes this call once, the main thread too.
        assert_eq!(counts.get("set_robust_list"), Some(&(1 + threads)), "{what}: {counts:?}");
    }
}

/// Runs a test of this file where there is no strace: what it writes to standard error past the harness, and whether it
/// passes.
fn without_strace(ci: Option<&str>) -> (String, bool) {
    let this = std::env::current_exe().expect("the test has a file");
    let mut command = Command::new(this);
    command.args(["--exact", "a_call_is_one_write_and_one_read"]).env("PATH", "").env_remove("CI");
    let output = command.envs(ci.map(|value| ("CI", value))).output().expect("it starts");
    (String::from_utf8_lossy(&output.stderr).into_owned(), output.status.success())
}

#[test]
fn a_check_that_is_skipped_says_so_and_does_not_pass_in_ci() {
    let (told, passes) = without_strace(None);
    assert!(passes && told.starts_with("NOT CHECKED: the system calls of the client: strace is missing"), "{told}");
    let (told, passes) = without_strace(Some("true"));
    assert!(!passes && told.contains("NOT CHECKED"), "{told}");
}
