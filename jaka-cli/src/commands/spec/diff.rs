//! `jaka spec diff`: differences between two specs.

use std::path::PathBuf;

use clap::Args;
use jaka_spec::tools::{self, Difference};
use serde_json::{Value, json};

use super::files;
use crate::failure::Failure;
use crate::target::packs;
use crate::terminal::{exit, output};

/// Compare two specs, and print the impact of each change on Rust programs.
///
/// A spec is `builtin`, a folder of TOML files, or a pack, which means the built-in spec with that pack. A change is
/// major, minor or patch, as for the version number of a crate.
#[derive(Debug, Args)]
pub(super) struct Diff {
    /// Old spec: `builtin`, a folder or a pack
    old: PathBuf,
    /// New spec: `builtin`, a folder or a pack
    new: PathBuf,
    /// Pack on top of NEW; repeat it for more
    #[arg(long = "pack", value_name = "FILE")]
    packs: Vec<PathBuf>,
    /// Print the changes as JSON
    #[arg(long)]
    json: bool,
    /// Report the highest impact by the exit code: 10 for patch, 11 for minor, 12 for major, 0 for no differences
    #[arg(long)]
    exit_code: bool,
}

impl Diff {
    pub(super) fn run(&self) -> Result<(), Failure> {
        let old = files::spec(&self.old)?;
        let new = files::spec(&self.new)?;
        let new = self.packs.iter().try_fold(new, |spec, pack| packs::add(&spec, pack))?;
        let changes = tools::diff(&old, &new);
        let text = if self.json { json(&changes) } else { text(&changes) };
        if self.json { output::json(&text) } else { output::lines(&text) }?;
        match tools::impact(&changes) {
            Some(impact) if self.exit_code => Err(Failure::Printed(exit::difference(impact))),
            _ => Ok(()),
        }
    }
}

/// Returns the changes, a line each, and their summary.
fn text(changes: &[Difference]) -> String {
    let lines: String = changes.iter().map(|change| change.to_string() + "\n").collect();
    lines + &tools::summary(changes) + "\n"
}

fn json(changes: &[Difference]) -> String {
    let change =
        |change: &Difference| json!({"impact": change.impact.to_string(), "place": change.place, "what": change.what});
    let all = json!({
        "impact": tools::impact(changes).map_or(Value::Null, |impact| impact.to_string().into()),
        "changes": changes.iter().map(change).collect::<Vec<_>>(),
    });
    format!("{all:#}\n")
}
