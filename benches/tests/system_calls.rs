//! System calls that the client makes, counted by strace: a program that does a thing N times and one that does it 2 N times differ
//! by what N times take.

use std::collections::BTreeMap;
use std::net::TcpListener;
use std::process::Command;
use std::thread;

use jaka_benches::system::canned;

/// The system calls by name, and how many there were.
type Counts = BTreeMap<String, i64>;

/// A server with printed answers, in this process, which is not counted.
fn server() -> [String; 2] {
    let commands = TcpListener::bind("127.0.0.1:0").expect("loopback has free ports");
    let status = TcpListener::bind("127.0.0.1:0").expect("loopback has free ports");
    let addresses = [&commands, &status].map(|port| port.local_addr().expect("it is bound").to_string());
    thread::spawn(move || canned::serve(&commands, 0));
    thread::spawn(move || canned::keep_silent(&status));
    addresses
}

/// What one of `count` times takes beyond none; nothing where there is no strace, or it may not trace.
fn each(what: &str, count: i64) -> Option<Counts> {
    let [commands, status] = server();
    let trace = |count: i64| {
        let program = [env!("CARGO_BIN_EXE_calls"), what, &commands, &status, &count.to_string()];
        let output = Command::new("strace").args(["-f", "-c"]).args(program).output().ok()?;
        let summary = String::from_utf8_lossy(&output.stderr).into_owned();
        if !output.status.success() && summary.contains("ptrace") {
            return None;
        }
        assert!(output.status.success(), "{summary}");
        Some(counts(&summary))
    };
    let Some((once, twice)) = trace(count).zip(trace(2 * count)) else {
        println!("not run: strace is missing, or must not trace");
        return None;
    };
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

#[test]
fn a_call_is_one_write_and_one_read() {
    let Some(counts) = each("call", 1000) else { return };
    assert_eq!(counts, Counts::from([("sendto".to_owned(), 1000), ("recvfrom".to_owned(), 1000)]));
}

#[test]
fn a_set_point_is_one_write_and_one_read() {
    let Some(counts) = each("servo", 50) else { return };
    let of = |name: &str| counts.get(name).copied().unwrap_or_default();
    assert_eq!(of("sendto"), 50, "{counts:?}");
    // At the end the last answers are asked for until they have come, and the monitor looks up about each second.
    assert!((50..75).contains(&of("recvfrom")), "{counts:?}");
    // The socket's mode and timeout stay as they are.
    for name in ["ioctl", "fcntl", "setsockopt"] {
        assert_eq!(of(name), 0, "{counts:?}");
    }
}
