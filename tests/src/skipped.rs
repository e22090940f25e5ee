//! Checks that a machine cannot make.

use std::io::Write;

/// Says on standard error that a check was not made, and why, also where the test harness keeps back what tests print.
///
/// # Panics
/// Where the environment has `CI`: a pass there means that every check was made.
pub fn skipped(check: &str, why: &str) {
    let text = format!("NOT CHECKED: {check}: {why}");
    // The harness captures what `eprintln!` prints, but not what is written to the stream itself. The reader may be gone.
    writeln!(std::io::stderr().lock(), "{text}").ok();
    assert!(!is_ci(), "{text}, and CI does not pass without it");
}

fn is_ci() -> bool {
    std::env::var_os("CI").is_some_and(|value| !value.is_empty() && value != "false")
}
