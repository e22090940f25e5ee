//! Tables of features in the documentation of crates, which have the features of the manifests.

use std::collections::BTreeSet;

use super::{read, root};

/// The crates with features: the folder and the page with the table.
const CRATES: [(&str, &str); 6] = [
    ("jaka-clock", "docs/overview.md"),
    ("jaka-motion", "docs/overview.md"),
    ("jaka-proto", "docs/overview.md"),
    ("jaka-robot", "docs/overview.md"),
    ("jaka-sync", "docs/overview.md"),
    ("spec", "README.md"),
];

/// A feature: in the order of the columns, without the description.
#[derive(Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Feature {
    name: String,
    is_default: bool,
    dependencies: BTreeSet<String>,
}

/// Lines `key = value` of a table of a crate's manifest.
fn entries(folder: &str, table: &str) -> Vec<(String, String)> {
    let manifest = read(&root().join(folder).join("Cargo.toml"));
    let lines = manifest.lines().skip_while(|line| *line != format!("[{table}]")).skip(1);
    let entries = lines.take_while(|line| !line.starts_with('[')).filter_map(|line| line.split_once(" = "));
    entries.map(|(key, value)| (key.to_owned(), value.to_owned())).filter(|(key, _)| !key.starts_with('#')).collect()
}

/// Strings of a list that stands in one line.
fn strings(list: &str) -> Vec<&str> {
    assert!(list.starts_with('[') && list.ends_with(']'), "a list in one line: {list}");
    list.split('"').skip(1).step_by(2).collect()
}

/// Optional dependencies that a feature switches on, in its crate or in those below it.
fn optional(folder: &str, feature: &str) -> BTreeSet<String> {
    let features = entries(folder, "features");
    let (_, list) = features.iter().find(|(name, _)| name == feature).unwrap_or_else(|| panic!("{folder}: {feature}"));
    let parts = strings(list).into_iter().flat_map(|part| match (part.strip_prefix("dep:"), part.split_once('/')) {
        (Some(dependency), _) => BTreeSet::from([dependency.to_owned()]),
        (None, Some((below, feature))) => optional(below, feature),
        (None, None) => optional(folder, part),
    });
    parts.collect()
}

/// The features of a manifest, each with the dependencies that the crate does not have without it.
fn of_manifest(folder: &str) -> BTreeSet<Feature> {
    let features = entries(folder, "features");
    let default = features.iter().find(|(name, _)| name == "default");
    let default = default.map(|(_, list)| strings(list)).unwrap_or_default();
    let always = entries(folder, "dependencies");
    let is_always = |name: &String| {
        let key = |key: &str| key.split('.').next() == Some(name);
        always.iter().any(|(other, value)| key(other) && !value.contains("optional = true"))
    };
    let features = features.iter().filter(|(name, _)| name != "default").map(|(name, _)| Feature {
        name: name.clone(),
        is_default: default.contains(&&**name),
        dependencies: optional(folder, name).into_iter().filter(|name| !is_always(name)).collect(),
    });
    features.collect()
}

/// The features of the table on a page.
fn of_page(folder: &str, page: &str) -> BTreeSet<Feature> {
    let text = read(&root().join(folder).join(page));
    let lines = text.lines().skip_while(|line| *line != "| feature | default | adds | dependencies |").skip(2);
    let rows = lines.take_while(|line| line.starts_with('|')).map(|line| {
        let names = |cell: &str| cell.split('`').skip(1).step_by(2).map(str::to_owned).collect::<Vec<_>>();
        let cells: Vec<_> = line.split('|').map(str::trim).collect();
        let &["", feature, default, _, dependencies, ""] = cells.as_slice() else { panic!("{folder}: {line}") };
        assert!(["yes", "no"].contains(&default), "{folder}: {line}");
        let dependencies = names(dependencies).into_iter().collect();
        Feature { name: names(feature).join(" "), is_default: default == "yes", dependencies }
    });
    rows.collect()
}

#[test]
fn the_tables_of_features_are_those_of_the_manifests() {
    for (folder, page) in CRATES {
        assert_eq!(of_page(folder, page), of_manifest(folder), "{folder}");
    }
    let folders = std::fs::read_dir(root()).expect("it is there").map(|entry| entry.expect("it can be read").path());
    let crates = folders.filter(|path| path.join("src/lib.rs").exists() && path.join("Cargo.toml").exists());
    let names = crates.map(|path| path.file_name().expect("it has a name").to_string_lossy().into_owned());
    let with_features: Vec<_> = names.filter(|name| !entries(name, "features").is_empty()).collect();
    let listed: BTreeSet<_> = CRATES.iter().map(|(folder, _)| *folder).collect();
    assert_eq!(with_features.iter().map(String::as_str).collect::<BTreeSet<_>>(), listed);
}
