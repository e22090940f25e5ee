//! Reports on specs and packs as users read them: every error at once, each at its place.
//!
//! Each file in `reports/specs` is loaded as a spec, each in `reports/packs` as a pack for the built-in spec, and what
//! is said about it stands
//! beside it in a file with the extension `stderr`. `UPDATE_EXPECT=1 cargo test -p jaka-spec` writes those.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use expect_test::{expect, expect_file};
use jaka_spec::{Source, builtin, load, load_pack};

/// Compares the report on each file of a folder with the one beside it.
fn check(folder: &str, least: usize, report: impl Fn(Source<'_>) -> String) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/reports").join(folder);
    let files = |extension: &str| -> Vec<PathBuf> {
        let entries =
            fs::read_dir(&folder).expect("the folder is there").map(|entry| entry.expect("it can be read").path());
        let mut files: Vec<_> =
            entries.filter(|path| path.extension().is_some_and(|other| other == extension)).collect();
        files.sort();
        files
    };
    let specs = files("toml");
    assert!(specs.len() >= least, "{} files", specs.len());
    for path in &specs {
        let text = fs::read_to_string(path).expect("it is text");
        let name = path.file_name().and_then(|name| name.to_str()).expect("the name is ASCII");
        expect_file![path.with_extension("stderr")].assert_eq(&report(Source { path: name, text: &text }));
    }
    let reports: Vec<_> = specs.iter().map(|path| path.with_extension("stderr")).collect();
    assert_eq!(files("stderr"), reports, "each spec has a report, and each report a spec");
}

#[test]
fn each_spec_has_the_errors_that_stand_beside_it() {
    check("specs", 15, |source| load(&[source]).err().map(|errors| format!("{errors}\n")).unwrap_or_default());
}

/// A pack that loads may have notes, and errors that only a program that is compiled with it would see.
#[test]
fn each_pack_has_the_errors_and_notes_that_stand_beside_it() {
    let spec = builtin().expect("the built-in spec is correct");
    check("packs", 40, |source| {
        let pack = match load_pack(&spec, source) {
            Ok(pack) => pack,
            Err(errors) => return format!("{errors}\n"),
        };
        let mut report = String::new();
        for error in &pack.module_errors {
            let _ = writeln!(report, "as a module: {error}");
        }
        for note in &pack.notes {
            let _ = writeln!(report, "note: {note}");
        }
        report
    });
}

#[test]
fn the_built_in_spec_is_correct() {
    if let Err(errors) = builtin() {
        panic!("{errors}");
    }
}

#[test]
fn errors_of_several_files_come_together() {
    let sources =
        [Source { path: "spec/b.toml", text: "titel = 1" }, Source { path: "spec/a.toml", text: "title = \"\"" }];
    let errors = load(&sources).expect_err("both files are wrong");
    expect![[r"
        spec/a.toml:1:9: `title` is empty
        spec/b.toml:1:1: `title` is missing
        spec/b.toml:1:1: unknown key `titel`; is it `title`?"]]
    .assert_eq(&errors.to_string());
}

#[test]
fn the_versions_of_an_override_are_checked_with_those_that_it_keeps() {
    let text = r#"
title = "Test"

[[command]]
wire = "go"
effect = "motion"
since = "1.7"
doc = "Goes."
"#;
    let base = load(&[Source { path: "spec/test.toml", text }]).expect("the spec is correct");
    let pack = "title = \"Pack\"\n\n[[override]]\ntarget = \"go\"\nuntil = \"1.6\"\n";
    let errors = load_pack(&base, Source { path: "pack.toml", text: pack }).expect_err("no version is left");
    expect!["pack.toml:3:1: override of `go`: `since` is later than `until`"].assert_eq(&errors.to_string());
}

/// A type is refused by its brackets, however many there are, before it is taken apart.
#[test]
fn types_nest_a_few_levels_deep() {
    for ty in [
        format!("float{}", "[]".repeat(5)),
        format!("float{}", "[]".repeat(100_000)),
        "python(".repeat(100_000),
        format!("{}int", "python(".repeat(9)),
    ] {
        let text = format!("title = 'T'\n[[type]]\nname = 'A'\nkind = 'wrapper'\ntype = '{ty}'\ndoc = 'A.'\n");
        let errors = load(&[Source { path: "spec/test.toml", text: &text }]).expect_err("the type is too deep");
        assert_eq!(errors.to_string(), "spec/test.toml:5:8: type `A`: a type has at most 4 brackets");
        let text = format!(
            "title = 'T'\n[[command]]\nwire = 'go'\neffect = 'query'\ndoc = 'Goes.'\nrequest = [{{ wire = 'a', type = '{ty}', doc = 'A.' }}]\n"
        );
        let spec = builtin().expect("the built-in spec is correct");
        let errors = load_pack(&spec, Source { path: "newer.toml", text: &text }).expect_err("the type is too deep");
        assert_eq!(errors.to_string(), "newer.toml:6:33: command `go`, field `a`: a type has at most 4 brackets");
    }
}

#[test]
fn types_that_hold_each_other_do_not_grow_without_end() {
    let twice = |n: u32| {
        format!(
            "[[type]]\nname = 'T{n}'\nkind = 'object'\ndoc = 'T.'\nfield = [{{ wire = 'a', type = 'T{next}', doc = 'A.' }}, {{ wire = 'b', type = 'T{next}', doc = 'B.' }}]\n",
            next = n + 1
        )
    };
    let chain: String = (0..40).map(twice).collect();
    let text = format!("title = 'T'\n{chain}[[type]]\nname = 'T40'\nkind = 'wrapper'\ntype = 'int'\ndoc = 'T.'\n");
    let spec = builtin().expect("the built-in spec is correct");
    let errors =
        load_pack(&spec, Source { path: "newer.toml", text: &text }).expect_err("it holds 2 to the 40th values");
    expect!["newer.toml:6:31: type `T0`, field `a`: the type `T1` holds more than 4096 values, or more than 32 types in each other"]
        .assert_eq(errors.to_string().lines().next().unwrap_or_default());
}

#[test]
fn of_many_errors_the_first_hundred_are_said_and_the_others_counted() {
    let text = format!("title = 'T'\n{}", "[[command]]\nwire = 'Odd name'\neffect = 'query'\n".repeat(1000));
    let errors = load(&[Source { path: "many.toml", text: &text }]).expect_err("each has errors");
    assert_eq!(errors.iter().count(), 100);
    assert!(errors.more() >= 900, "{}", errors.more());
    assert!(errors.to_string().ends_with(&format!("\nand {} more errors", errors.more())));
}
