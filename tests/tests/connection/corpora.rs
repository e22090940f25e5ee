//! The fuzz targets, on the inputs with which fuzzing begins and on those that are kept.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use jaka_fuzz_targets::TARGETS;
use jaka_tests::seeds;

/// A folder of the project.
fn folder(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(path)
}

/// The names in a folder, without what follows a point.
fn names(path: &str) -> BTreeSet<String> {
    let entries = fs::read_dir(folder(path)).unwrap_or_else(|error| panic!("{path}: {error}"));
    let name = |entry: std::io::Result<fs::DirEntry>| entry.expect("the folder can be read").path();
    entries.map(name).filter_map(|path| Some(path.file_stem()?.to_str()?.to_owned())).collect()
}

#[test]
fn each_target_has_a_binary_and_a_corpus() {
    let targets: BTreeSet<_> = TARGETS.iter().map(|target| target.name.to_owned()).collect();
    assert_eq!(names("fuzz/fuzz_targets"), targets);
    assert_eq!(names("tests/corpora"), targets);
    let manifest = fs::read_to_string(folder("fuzz/Cargo.toml")).expect("it is there");
    for target in targets {
        assert!(manifest.contains(&format!("path = \"fuzz_targets/{target}.rs\"")), "fuzz/Cargo.toml has no {target}");
    }
}

#[test]
fn seeds_pass() {
    for target in TARGETS {
        let seeds = seeds(target.name);
        assert!(!seeds.is_empty(), "{} has no seeds", target.name);
        for seed in seeds {
            (target.check)(&seed);
        }
    }
}

#[test]
fn corpora_pass() {
    for target in TARGETS {
        for name in names(&format!("tests/corpora/{}", target.name)) {
            let path = folder("tests/corpora").join(target.name).join(&name);
            let input = fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
            eprintln!("{}", path.display());
            (target.check)(&input);
        }
    }
}
