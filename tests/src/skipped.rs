//! Checks that a machine cannot make.

use std::io::Write;

/// Says on standard error that a check was not made, and why, also if the test harness keeps back what tests print.
///
/// # Panics
/// Where the environment has `CI`: a pass there means that every check was made.
pub fn skipped(check: &str, why: &str) {
    left_out(check, why);
    assert!(!is_ci(), "NOT CHECKED: {check}: {why}, and CI does not pass without it");
}

/// Says the same of a check that passes with CI where it cannot be made: of a program that not every machine can
/// install.
pub fn left_out(check: &str, why: &str) {
    // The harness captures what `eprintln!` prints, but not what is written to the stream itself. The reader may be
    // gone.
    writeln!(std::io::stderr().lock(), "NOT CHECKED: {check}: {why}").ok();
}

fn is_ci() -> bool {
    std::env::var_os("CI").is_some_and(|value| !value.is_empty() && value != "false")
}
