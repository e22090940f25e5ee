//! `cargo-semver-checks` as a second witness.

use std::path::Path;
use std::process::Command;

/// Names of the lints by which the interface of a crate breaks, from the descriptions of both versions.
///
/// # Panics
/// The program is not installed, or fails for another reason than a break.
pub(crate) fn breaks(old: &Path, new: &Path) -> Vec<String> {
    let mut command = Command::new("cargo-semver-checks");
    command.args(["semver-checks", "--color=never", "--release-type=minor", "--baseline-rustdoc"]);
    let output = command.arg(old).arg("--current-rustdoc").arg(new).output();
    let output = output.unwrap_or_else(|error| panic!("cargo-semver-checks, which has to be installed: {error}"));
    let said = String::from_utf8_lossy(&[output.stdout, output.stderr].concat()).into_owned();
    let failed = said.lines().filter_map(|line| line.trim().strip_prefix("--- failure "));
    let lints: Vec<_> = failed.filter_map(|line| line.split(':').next()).map(str::to_owned).collect();
    assert!(output.status.success() || !lints.is_empty(), "{said}");
    lints
}
