//! Table of the examples in the documentation of jaka-robot, which has all programs of the workspace.

use std::fs;

use super::{read, root};

/// The packages with examples, each with its folder and its argument of `cargo run`.
const PACKAGES: [(&str, &str); 3] = [("jaka-robot", ""), ("jaka-sim", "-p jaka-sim "), ("tests", "-p jaka-tests ")];

/// Names of the examples in a folder.
fn names(folder: &str) -> impl Iterator<Item = String> {
    let files = fs::read_dir(root().join(folder).join("examples")).expect("it is there");
    let paths = files.map(|entry| entry.expect("it can be read").path());
    let sources = paths.filter(|path| path.extension().is_some_and(|extension| extension == "rs"));
    sources.map(|path| path.file_stem().expect("it has a name").to_string_lossy().into_owned())
}

#[test]
fn the_table_of_examples_has_each_with_its_command() {
    let page = read(&root().join("jaka-robot/docs/overview.md"));
    let lines = page.lines().skip_while(|line| *line != "| example | subject | command |").skip(2);
    let rows: Vec<_> = lines.take_while(|line| line.starts_with('|')).collect();
    let mut count = 0;
    for (folder, package) in PACKAGES {
        for name in names(folder) {
            let row = rows.iter().find(|row| row.starts_with(&format!("| `{name}` | ")));
            let row = row.unwrap_or_else(|| panic!("{folder}: {name} has no row"));
            let command = row.trim_end_matches(" |").rsplit(" | ").next().unwrap_or_default();
            let command = command.trim_matches('`').replace("--release ", "");
            let arguments = command.strip_prefix(&format!("cargo run {package}--example {name}"));
            let arguments = arguments.unwrap_or_else(|| panic!("another command: {row}"));
            assert!(arguments.is_empty() || arguments.starts_with(" --"), "{row}");
            // Without its feature, Cargo does not know the example.
            let manifest = read(&root().join(folder).join("Cargo.toml"));
            let feature = manifest
                .split_once(&format!("name = \"{name}\"\nrequired-features = [\""))
                .and_then(|(_, rest)| rest.split_once('"'))
                .map(|(feature, _)| feature);
            let needs = feature.filter(|feature| !manifest.contains(&format!("default = [\"{feature}\"]")));
            assert_eq!(arguments.strip_prefix(" --features jaka-robot/"), needs, "{row}");
            count += 1;
        }
    }
    assert_eq!(rows.len(), count, "an example is gone: {rows:#?}");
}
