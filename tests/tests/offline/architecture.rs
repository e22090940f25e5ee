//! The arrows of ARCHITECTURE.md: which crate stands on which, and that no modules of a crate stand on one another in a circle.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// The crates from the bottom up, and what each may depend on.
const CRATES: &[(&str, &[&str])] = &[
    ("spec", &[]),
    ("jaka-proto-derive", &["jaka-spec"]),
    ("jaka-proto", &["jaka-proto-derive"]),
    ("jaka-dynamic", &["jaka-proto", "jaka-spec"]),
    ("jaka-motion", &["jaka-proto", "jaka-spec"]),
    ("jaka-clock", &[]),
    ("jaka-sync", &["jaka-clock", "jaka-motion", "jaka-proto", "jaka-proto-derive"]),
    ("jaka-sim", &["jaka-clock", "jaka-dynamic", "jaka-motion", "jaka-proto", "jaka-spec"]),
    ("jaka-cli", &["jaka-dynamic", "jaka-motion", "jaka-sim", "jaka-spec", "jaka-sync"]),
];

/// What stands in a circle nevertheless.
const CIRCLES: &[(&str, &[&str])] = &[];

type Graph = BTreeMap<String, BTreeSet<String>>;

fn workspace() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
}

fn text(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The crates of this workspace that a manifest names as dependencies of what it builds.
fn dependencies(manifest: &str) -> BTreeSet<&str> {
    let mut part = "";
    let mut found = BTreeSet::new();
    for line in manifest.lines() {
        if line.starts_with('[') {
            part = line;
        } else if part == "[dependencies]" && line.starts_with("jaka-") {
            found.insert(line.split(['.', ' ', '=']).next().unwrap_or_default());
        }
    }
    found
}

#[test]
fn no_crate_depends_upward() {
    for (place, (folder, allowed)) in CRATES.iter().enumerate() {
        let manifest = text(&workspace().join(folder).join("Cargo.toml"));
        let found = dependencies(&manifest);
        assert_eq!(found, allowed.iter().copied().collect(), "{folder}");
        let below =
            |name: &str| CRATES[..place].iter().any(|(folder, _)| *folder == name || format!("jaka-{folder}") == name);
        assert!(found.iter().all(|name| below(name)), "{folder} depends on what does not stand below it: {found:?}");
    }
}

/// The source files of a crate, without its tests.
fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).expect("the folder is there") {
            let path = entry.expect("it can be read").path();
            let stem = path.file_stem().unwrap_or_default();
            match path.is_dir() {
                _ if stem == "tests" => {}
                true => folders.push(path),
                false if path.extension().is_some_and(|extension| extension == "rs") => files.push(path),
                false => {}
            }
        }
    }
    files
}

#[test]
fn libraries_that_are_not_compiled_for_tests_have_none() {
    for folder in ["jaka-clock", "tests/pack-user", "tests/fuzz-targets"] {
        let folder = workspace().join(folder);
        assert!(text(&folder.join("Cargo.toml")).contains("[lib]\ntest = false\n"), "{}", folder.display());
        let with_tests = sources(&folder.join("src")).into_iter().find(|path| text(path).contains("#[test]"));
        assert_eq!(with_tests, None);
    }
}

/// Code without its comments, and without the module of tests at its end.
fn code(text: &str) -> String {
    let end = text.find("#[cfg(test)]\nmod tests {").unwrap_or(text.len());
    text[..end].lines().map(|line| line.split("//").next().unwrap_or_default()).collect::<Vec<_>>().join("\n")
}

/// The first names of the paths that begin with `crate::`, also in braces.
fn names(code: &str) -> BTreeSet<&str> {
    let mut names = BTreeSet::new();
    for (at, _) in code.match_indices("crate::") {
        if code[..at].ends_with('$') {
            continue;
        }
        let rest = &code[at + "crate::".len()..];
        let (mut depth, mut start) = (0_usize, true);
        for (at, character) in rest.char_indices() {
            let is_word = |character: char| character.is_alphanumeric() || character == '_';
            if start && depth <= 1 && is_word(character) {
                names.insert(rest[at..].split(|character| !is_word(character)).next().unwrap_or_default());
                start = false;
            }
            match character {
                '{' => depth += 1,
                '}' => depth = depth.saturating_sub(1),
                ',' if depth == 1 => start = true,
                _ => {}
            }
            if depth == 0 && !start {
                break;
            }
        }
    }
    names
}

/// What `lib.rs` shows of its modules under other paths: the name, and the module.
fn shown(lib: &str) -> BTreeMap<&str, &str> {
    let uses = lib.split("use ").skip(1).filter_map(|part| part.split(';').next());
    let pairs = uses.filter_map(|path| path.split_once("::"));
    pairs
        .flat_map(|(module, rest)| {
            let words = rest.split(|character: char| !(character.is_alphanumeric() || character == '_'));
            words.filter(|word| !word.is_empty()).map(move |word| (word, module))
        })
        .collect()
}

/// Which modules at the top of a crate use which others.
fn modules(folder: &str) -> Graph {
    let source = workspace().join(folder).join("src");
    let top = |path: &Path| {
        let first = path.strip_prefix(&source).ok()?.components().next()?;
        Some(first.as_os_str().to_str()?.trim_end_matches(".rs").to_owned())
    };
    let files = sources(&source);
    let all: BTreeSet<String> = files.iter().filter_map(|file| top(file)).collect();
    let lib = fs::read_to_string(source.join("lib.rs")).unwrap_or_default();
    let (lib, mut graph) = (code(&lib), Graph::new());
    let shown = shown(&lib);
    for file in &files {
        let from = top(file).expect("it is in the folder");
        if from == "lib" || from == "main" {
            continue;
        }
        for name in names(&code(&text(file))) {
            let to = if all.contains(name) { name } else { shown.get(name).copied().unwrap_or_default() };
            if all.contains(to) && to != from {
                graph.entry(from.clone()).or_default().insert(to.to_owned());
            }
        }
    }
    graph
}

/// What is reached from a module, by any number of arrows.
fn reached<'g>(graph: &'g Graph, from: &str) -> BTreeSet<&'g str> {
    let mut found = BTreeSet::new();
    let mut next: Vec<&str> = graph.get(from).into_iter().flatten().map(String::as_str).collect();
    while let Some(module) = next.pop() {
        if found.insert(module) {
            next.extend(graph.get(module).into_iter().flatten().map(String::as_str));
        }
    }
    found
}

/// The modules that reach themselves, in groups that reach one another.
fn circles(graph: &Graph) -> BTreeSet<Vec<&str>> {
    let in_circle = |module: &&str| reached(graph, module).contains(module);
    let group = |module: &str| {
        let reached_from = reached(graph, module);
        reached_from.into_iter().filter(|other| reached(graph, other).contains(module)).collect()
    };
    graph.keys().map(String::as_str).filter(in_circle).map(group).collect()
}

#[test]
fn no_modules_stand_on_one_another_in_a_circle() {
    for (folder, _) in CRATES {
        let graph = modules(folder);
        assert!(!graph.is_empty(), "{folder} was read");
        let allowed = CIRCLES.iter().filter(|(crate_, _)| crate_ == folder).map(|(_, modules)| modules.to_vec());
        assert_eq!(circles(&graph), allowed.collect(), "{folder}");
    }
}

/// What reads the system's clock, or waits by it.
const SYSTEM_TIME: &[&str] =
    &["Instant::now", ".elapsed()", "thread::sleep", ".wait_timeout", "recv_timeout", "park_timeout"];

/// Where that is allowed: the clocks themselves, and what has nothing to do with a controller.
const BY_THE_SYSTEM: &[&str] = &[
    "jaka-sync/src/clock.rs",
    "jaka-sim/src/time.rs",
    "lock.rs",
    "sync.rs",
    "interleavings.rs",
    "recorder/queue.rs",
    // A program under test that hangs.
    "run_while.rs",
];

#[test]
fn time_goes_through_one_clock() {
    for folder in ["jaka-sync", "jaka-sim"] {
        for file in sources(&workspace().join(folder).join("src")) {
            let code = code(&text(&file));
            let found = SYSTEM_TIME.iter().find(|reads| code.contains(**reads));
            let allowed = BY_THE_SYSTEM.iter().any(|name| file.ends_with(name));
            assert!(found.is_none() || allowed, "{}: {found:?} in place of the clock", file.display());
        }
    }
}

/// The fields of `Config`: its getters alone keep the compiler from telling of one that nothing applies.
fn options() -> Vec<String> {
    let config = text(&workspace().join("jaka-sync/src/config.rs"));
    let (_, fields) = config.split_once("pub struct Config {").expect("it is there");
    let (fields, _) = fields.split_once("\n}").expect("it ends");
    fields.lines().filter_map(|line| line.split("pub(crate) ").nth(1)?.split(':').next()).map(str::to_owned).collect()
}

#[test]
fn every_option_of_the_config_is_applied() {
    let files = sources(&workspace().join("jaka-sync/src"));
    let others: Vec<_> = files.iter().filter(|file| !file.ends_with("config.rs")).collect();
    let codes: Vec<_> = others.iter().map(|file| code(&text(file))).collect();
    let options = options();
    assert!(options.len() >= 10, "{options:?}");
    for option in options {
        let reads = format!("config.{option}");
        assert!(codes.iter().any(|code| code.contains(&reads)), "nothing applies `Config::{option}`");
    }
}

#[test]
fn circles_are_found() {
    let graph = |arrows: &[(&str, &str)]| {
        let mut graph = Graph::new();
        for (from, to) in arrows {
            graph.entry((*from).to_owned()).or_default().insert((*to).to_owned());
        }
        graph
    };
    assert!(circles(&graph(&[("a", "b"), ("b", "c"), ("a", "c")])).is_empty());
    let round = graph(&[("a", "b"), ("b", "c"), ("c", "a"), ("d", "a")]);
    assert_eq!(circles(&round), BTreeSet::from([vec!["a", "b", "c"]]));
    let code = code("use crate::{a, b::{c, d}};\n// crate::x\nlet e = crate::f::g; $crate::h!();");
    assert_eq!(names(&code), BTreeSet::from(["a", "b", "f"]));
    assert_eq!(shown("pub use self_::{A, B as C};\npub use m::D;").get("D"), Some(&"m"));
}
