//! The arrows of ARCHITECTURE.md: which crate stands on which, and that modules beside each other do not import one
//! another in a circle.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// The crates from the bottom up, and what each may depend on.
const CRATES: &[(&str, &[&str])] = &[
    ("spec", &[]),
    ("jaka-proto-derive", &["jaka-spec"]),
    ("jaka-proto", &["jaka-proto-derive"]),
    ("jaka-dynamic", &["jaka-proto", "jaka-spec"]),
    ("jaka-motion", &["jaka-proto"]),
    ("jaka-clock", &[]),
    ("jaka-sync", &["jaka-clock", "jaka-proto", "jaka-proto-derive"]),
    ("jaka-robot", &["jaka-clock", "jaka-motion", "jaka-proto", "jaka-sync"]),
    ("jaka-sim", &["jaka-clock", "jaka-dynamic", "jaka-motion", "jaka-proto", "jaka-spec"]),
    ("jaka-cli", &["jaka-dynamic", "jaka-motion", "jaka-robot", "jaka-sim", "jaka-spec", "jaka-sync"]),
];

/// The folders of a crate and of all that it depends on.
pub(crate) fn with_dependencies(folder: &str) -> BTreeSet<&'static str> {
    let (folder, allowed) = CRATES.iter().find(|(crate_folder, _)| *crate_folder == folder).expect("a crate");
    let below = allowed.iter().flat_map(|name| with_dependencies(if *name == "jaka-spec" { "spec" } else { name }));
    below.chain([*folder]).collect()
}

/// Modules, and for each the modules beside it that it or a module below it uses.
type Graph = BTreeMap<String, BTreeSet<String>>;

/// The project's folder.
pub(crate) fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the crate is in a workspace")
}

pub(crate) fn read(path: &Path) -> String {
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
        let manifest = read(&root().join(folder).join("Cargo.toml"));
        let found = dependencies(&manifest);
        assert_eq!(found, allowed.iter().copied().collect(), "{folder}");
        let below =
            |name: &str| CRATES[..place].iter().any(|(folder, _)| *folder == name || format!("jaka-{folder}") == name);
        assert!(found.iter().all(|name| below(name)), "{folder} depends on what does not stand below it: {found:?}");
    }
}

/// The source files below a folder, without what is built.
pub(crate) fn all_sources(folder: &Path) -> Vec<PathBuf> {
    all_files(folder, "rs")
}

/// The files with this extension below a folder.
pub(crate) fn all_files(folder: &Path, extension: &str) -> Vec<PathBuf> {
    let mut files = Vec::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("the folder is there") {
            let path = entry.expect("it can be read").path();
            match path.is_dir() {
                true if path.ends_with("target") && path.with_file_name("Cargo.toml").exists() => {}
                true => folders.push(path),
                false if path.extension().is_some_and(|own| own == extension) => files.push(path),
                false => {}
            }
        }
    }
    files
}

/// The source files of a crate, without its tests.
pub(crate) fn sources(folder: &Path) -> Vec<PathBuf> {
    let is_test = |file: &PathBuf| {
        file.strip_prefix(folder).expect("it is below").iter().any(|part| part == "tests" || part == "tests.rs")
    };
    all_sources(folder).into_iter().filter(|file| !is_test(file)).collect()
}

#[test]
fn libraries_that_are_not_compiled_for_tests_have_none() {
    for folder in ["jaka-clock", "tests/pack-user", "tests/fuzz-targets"] {
        let folder = root().join(folder);
        assert!(read(&folder.join("Cargo.toml")).contains("[lib]\ntest = false\n"), "{}", folder.display());
        let with_tests = sources(&folder.join("src")).into_iter().find(|path| read(path).contains("#[test]"));
        assert_eq!(with_tests, None);
    }
}

/// Code without its comments, and without the module of tests at its end.
pub(crate) fn code(text: &str) -> String {
    let end = text.find("#[cfg(test)]\nmod tests {").unwrap_or(text.len());
    text[..end].lines().map(|line| line.split("//").next().unwrap_or_default()).collect::<Vec<_>>().join("\n")
}

pub(crate) fn is_word(text: &str) -> bool {
    text.starts_with(|first: char| first.is_alphanumeric() || first == '_')
}

/// Words, `::` and other characters of some code, without blanks.
pub(crate) fn tokens(mut code: &str) -> Vec<&str> {
    let mut found = Vec::new();
    while let Some(first) = code.chars().next() {
        let length = match first {
            ':' if code.starts_with("::") => 2,
            _ if is_word(code) => code.find(|next: char| !next.is_alphanumeric() && next != '_').unwrap_or(code.len()),
            _ => first.len_utf8(),
        };
        let (token, rest) = code.split_at(length);
        found.extend(Some(token).filter(|_| !first.is_whitespace()));
        code = rest;
    }
    found
}

/// Path in code, as its words.
type Words<'t> = Vec<&'t str>;

/// Reads a path, or all paths of a tree in braces, each with the name that it has as a `use`.
fn read_paths<'t>(tokens: &mut &[&'t str], mut path: Words<'t>, found: &mut Vec<(&'t str, Words<'t>)>) {
    while let [word, "::", rest @ ..] = *tokens {
        path.push(word);
        *tokens = rest;
    }
    let (name, rest) = match *tokens {
        ["{", ..] => {
            while let ["{" | ",", rest @ ..] = *tokens {
                *tokens = rest;
                read_paths(tokens, path.clone(), found);
            }
            *tokens = tokens.get(1..).unwrap_or_default();
            return;
        }
        // As in `use a::{self, b}`.
        ["self", rest @ ..] if !path.is_empty() => (path[path.len() - 1], rest),
        [word, rest @ ..] if is_word(word) => {
            path.push(word);
            (*word, rest)
        }
        // All names of a module, or the parameters of a type.
        rest => ("", rest),
    };
    let (name, rest) = if let ["as", name, rest @ ..] = rest { (*name, rest) } else { (name, rest) };
    *tokens = rest;
    found.push((name, path));
}

/// Paths in the code of a module, and of them the names that `use` makes.
#[derive(Default)]
struct Paths<'t> {
    all: Vec<Words<'t>>,
    names: BTreeMap<&'t str, Words<'t>>,
}

impl<'t> Paths<'t> {
    fn read(code: &'t str) -> Self {
        let (tokens, mut paths, mut before) = (tokens(code), Self::default(), "");
        let mut rest = tokens.as_slice();
        while let [first, after @ ..] = rest {
            if *first == "use" || !is_word(first) {
                (before, rest) = (first, after);
                continue;
            }
            let mut found = Vec::new();
            read_paths(&mut rest, Vec::new(), &mut found);
            paths.all.extend(found.iter().map(|(_, path)| path.clone()));
            if before == "use" {
                paths.names.extend(found);
            }
            before = "";
        }
        paths
    }
}

/// Modules of a crate by their paths from its root, the root included.
type Modules<'t> = BTreeMap<Words<'t>, Paths<'t>>;

/// Module that has what a path in the module `at` names; `at` for names that are not the crate's.
fn definer<'t>(modules: &Modules<'t>, mut at: Words<'t>, path: &[&'t str]) -> Words<'t> {
    for (place, &name) in path.iter().enumerate() {
        let child = [at.as_slice(), &[name]].concat();
        match name {
            "crate" => at.clear(),
            "self" => {}
            "super" => drop(at.pop()),
            _ if modules.contains_key(&child) => at = child,
            _ => {
                let shown = modules.get(&at).and_then(|paths| paths.names.get(name));
                return match shown.filter(|shown| shown[0] != name) {
                    Some(shown) => definer(modules, at, &[shown, &path[place + 1..]].concat()),
                    None => at,
                };
            }
        }
    }
    at
}

/// Graph of the modules of a crate on all levels, from the code of each by its path (`a::b`). Names that come by a glob
/// or from a macro are not followed.
fn graph(files: &BTreeMap<String, String>) -> Graph {
    let words = files.keys().map(|path| path.split("::").filter(|word| !word.is_empty()).collect());
    let modules: Modules = words.zip(files.values().map(|code| Paths::read(code))).collect();
    let mut graph = Graph::new();
    for (from, paths) in &modules {
        for path in &paths.all {
            let to = definer(&modules, from.clone(), path);
            let common = from.iter().zip(&to).take_while(|(one, other)| one == other).count();
            if from.len() > common && to.len() > common {
                graph.entry(from[..=common].join("::")).or_default().insert(to[..=common].join("::"));
            }
        }
    }
    graph
}

/// Code of the modules in a folder.
fn modules(folder: &Path) -> BTreeMap<String, String> {
    let path = |file: &Path| {
        let name = file.strip_prefix(folder).ok()?.with_extension("");
        let name = name.to_str()?.replace('/', "::");
        Some(if name == "lib" || name == "main" { String::new() } else { name })
    };
    sources(folder).iter().map(|file| (path(file).expect("it is in the folder"), code(&read(file)))).collect()
}

/// Modules that are reachable from a module, by any number of arrows.
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
    let folders = CRATES.iter().map(|(folder, _)| format!("{folder}/src"));
    for folder in folders.chain(["benches/src".to_owned()]) {
        let graph = graph(&modules(&root().join(&folder)));
        assert!(!graph.is_empty(), "{folder} was read");
        assert_eq!(circles(&graph), BTreeSet::new(), "{folder}");
    }
}

/// Calls that read the system's clock, or wait by it.
const SYSTEM_TIME: &[&str] =
    &["Instant::now", ".elapsed()", "thread::sleep", ".wait_timeout", "recv_timeout", "park_timeout"];

/// Files in which they are allowed: jaka-clock has the clock, and these have nothing to do with a controller.
const BY_THE_SYSTEM: &[&str] = &[
    "jaka-sync/src/sync.rs",
    "interleavings.rs",
    "recorder/queue.rs",
    // A write that its thread is about to return from: no clock knows of it.
    "jaka-sim/src/link/wire.rs",
];

#[test]
fn time_goes_through_one_clock() {
    for folder in ["jaka-sync", "jaka-robot", "jaka-sim"] {
        for file in sources(&root().join(folder).join("src")) {
            let code = code(&read(&file));
            let found = SYSTEM_TIME.iter().find(|reads| code.contains(**reads));
            let allowed = BY_THE_SYSTEM.iter().any(|name| file.ends_with(name));
            assert!(found.is_none() || allowed, "{}: {found:?} in place of the clock", file.display());
        }
    }
}

/// The fields of `Config`: a getter keeps the compiler from telling of one that nothing applies.
fn options() -> Vec<String> {
    let config = read(&root().join("jaka-sync/src/config.rs"));
    let (_, fields) = config.split_once("pub struct Config {").expect("it is there");
    let (fields, _) = fields.split_once("\n}").expect("it ends");
    let fields = fields.lines().filter(|line| !line.trim_start().starts_with('#'));
    fields.filter_map(|line| line.split_once(':')?.0.split_whitespace().last()).map(str::to_owned).collect()
}

#[test]
fn every_option_of_the_config_is_applied() {
    let files = sources(&root().join("jaka-sync/src"));
    let others: Vec<_> = files.iter().filter(|file| !file.ends_with("config.rs")).collect();
    let codes: Vec<_> = others.iter().map(|file| code(&read(file))).collect();
    let options = options();
    assert!(options.len() >= 10, "{options:?}");
    for option in options {
        let reads = format!("config.{option}");
        assert!(codes.iter().any(|code| code.contains(&reads)), "nothing applies `Config::{option}`");
    }
}

#[test]
fn circles_are_found() {
    let found = |files: &[(&str, &str)]| {
        let files = files.iter().map(|(path, text)| ((*path).to_owned(), code(text))).collect();
        circles(&graph(&files)).into_iter().map(|circle| circle.join(" ")).collect::<Vec<_>>()
    };
    assert!(found(&[("a", "use crate::{b, c};"), ("b", "use crate::c::X;"), ("c", "// crate::a")]).is_empty());
    let longer = [("a", "use crate::{d, b::{Y, Z}};"), ("b", "crate::c::f();"), ("c", "use super::a;"), ("d", "")];
    assert_eq!(found(&longer), ["a b c"]);
    // Below the root, from modules below the two, and inline.
    let nested = [("a", ""), ("a::x", ""), ("a::x::p", "super::super::y::f();"), ("a::y", "use super::{self, x::p};")];
    assert_eq!(found(&nested), ["a::x a::y"]);
    // By names that the parent shows, that are imported, and that have another name.
    let shown = [("", "pub use a::X;"), ("a", "pub use self::x::X;"), ("a::x", "use super::y;"), ("a::y", "$crate::X")];
    assert_eq!(found(&shown), ["a::x a::y"]);
    let renamed = [("a", "use x::X as Z;"), ("a::x", "use crate::a as b; b::y::f();"), ("a::y", "use super::{Z,};")];
    assert_eq!(found(&renamed), ["a::x a::y"]);
    // Parent and child, and names of other crates.
    let none = [("a", "use x::X;"), ("a::x", "use super::Y; use b::y::c;"), ("a::y", "super::x::f();"), ("b", "")];
    assert!(found(&none).is_empty());
}

/// Enums whose `Display` matches on the variants and does not come from `worded!`: ARCHITECTURE.md, "Errors", says why.
const TEXTS_ELSEWHERE: &[&str] = &[
    "jaka-cli/src/failure.rs: Failure",
    "jaka-proto/src/worded.rs: $name",
    "jaka-proto-derive/src/enums.rs: #name",
    "jaka-proto-derive/src/word_enums.rs: #name",
    "jaka-sim/src/command_port/request_reader.rs: Incoming",
    "jaka-sim/src/fault/kinds.rs: $Kinds",
    "jaka-sim/src/underrun.rs: Underrun",
    "spec/src/tools/diff.rs: Impact",
];

#[test]
fn the_text_of_a_variant_stands_next_to_it() {
    let mut found = BTreeSet::new();
    for (folder, _) in CRATES {
        for path in sources(&root().join(folder).join("src")) {
            let (code, path) =
                (code(&read(&path)), path.strip_prefix(root()).expect("it is in it").display().to_string());
            assert!(!code.contains("thiserror"), "{path}");
            for implementation in code.split("Display for ").skip(1) {
                let (name, rest) = implementation.split_once(" {").expect("a body follows");
                let body = rest.split("\nimpl").next().unwrap_or_default();
                let body = body.split("\n}\n").next().unwrap_or_default();
                if body.contains("match self {") || body.contains("match *self {") {
                    found.insert(format!("{path}: {name}"));
                }
            }
        }
    }
    assert_eq!(found, TEXTS_ELSEWHERE.iter().map(ToString::to_string).collect());
}

/// Names of source files in backticks.
fn named_files(page: &str) -> impl Iterator<Item = &str> {
    let is_source = |name: &&str| Path::new(name).extension().is_some_and(|extension| extension == "rs");
    page.split('`').skip(1).step_by(2).filter(is_source).filter(|name| !name.contains([' ', '*', '…']))
}

#[test]
fn source_files_that_the_pages_name_exist() {
    let mut files = Vec::new();
    for folder in CRATES.iter().map(|(folder, _)| *folder).chain(["tests", "benches", "fuzz"]) {
        files.extend(all_sources(&root().join(folder)));
    }
    for page in ["ARCHITECTURE.md", "CONTRIBUTING.md"] {
        let text = read(&root().join(page));
        assert!(named_files(&text).count() > 20, "{page} names files");
        let missing: Vec<_> =
            named_files(&text).filter(|name| !files.iter().any(|file| file.ends_with(name))).collect();
        assert_eq!(missing, [""; 0], "{page}");
    }
}
