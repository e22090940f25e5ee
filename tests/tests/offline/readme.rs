//! Pages and comments: their links lead somewhere, tables and numbers are those of the sources, READMEs of crates are
//! made from their documentation, the Chinese pages have the figures and the code of the English ones, and prose keeps
//! to its rules.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use expect_test::expect_file;
use jaka_tests::spec;

use crate::architecture::{all_files, all_sources, read, root};
use crate::reference::anchors;

/// The folders and files in the project's folder.
fn entries_of_root() -> impl Iterator<Item = PathBuf> {
    fs::read_dir(root()).expect("it is there").map(|entry| entry.expect("it can be read").path())
}

/// The name of a file from the project's folder on, which may itself be in one of these names.
fn below_root(path: &Path) -> String {
    format!("/{}", path.strip_prefix(root()).expect("it is below").display())
}

/// The rows of a table below this header.
fn rows<'p>(page: &'p str, header: &str) -> Vec<&'p str> {
    let lines = page.lines().skip_while(|line| *line != header).skip(2);
    lines.take_while(|line| line.starts_with('|')).collect()
}

/// The blocks of code of a page, each with its language.
fn blocks(page: &str) -> Vec<String> {
    read(&root().join(page)).split("```").skip(1).step_by(2).map(str::to_owned).collect()
}

#[test]
fn the_chinese_readme_has_the_same_code() {
    let english = blocks("README.md");
    assert!(english.len() > 3);
    assert_eq!(blocks("README.zh.md"), english);
}

#[test]
fn every_link_of_a_page_leads_somewhere() {
    let names = ["README.md", "README.zh.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "CHANGELOG.md", "SECURITY.md"];
    let names = names.into_iter().chain(["tests/promises.md"]);
    let folders = ["docs", "docs/zh"].map(|folder| fs::read_dir(root().join(folder)).expect("it is there"));
    let docs = folders.into_iter().flatten().map(|entry| entry.expect("it can be read").path());
    let docs = docs.filter(|path| path.extension().is_some_and(|extension| extension == "md"));
    let pages: Vec<PathBuf> = names.map(|name| root().join(name)).chain(docs).collect();
    assert!(pages.len() > 10, "{pages:?}");
    let mut count = 0;
    for page in pages {
        let text = read(&page);
        let prose = text.split("```").step_by(2);
        for link in prose.flat_map(|prose| prose.split("](").skip(1)).filter_map(|rest| rest.split(')').next()) {
            if link.starts_with("https://") {
                continue;
            }
            let (file, anchor) = link.split_once('#').unwrap_or((link, ""));
            let target = if file.is_empty() { page.clone() } else { page.with_file_name(file) };
            assert!(target.exists(), "{}: {link}", page.display());
            // Sources of rustdoc, which a forge shows with hidden lines and without links.
            assert!(
                !file.contains("jaka-sync/docs/") && !file.contains("jaka-robot/docs/"),
                "{}: {link}",
                page.display()
            );
            assert!(anchor.is_empty() || anchors(&read(&target)).contains(anchor), "{}: {link}", page.display());
            count += 1;
        }
    }
    assert!(count > 50, "the pages have links: {count}");
}

/// Numbers of the prose and of the tables, in the order of their digits.
fn figures(page: &str) -> Vec<String> {
    let text = read(&root().join(page));
    let prose: String = text.split("```").step_by(2).collect();
    // Targets of links and spans of code are not the page's figures.
    let prose: String = prose.split('`').step_by(2).collect();
    let prose: String = prose
        .split("](")
        .enumerate()
        .map(|(at, part)| match (at, part.split_once(')')) {
            (0, _) | (_, None) => part,
            (_, Some((_, rest))) => rest,
        })
        .collect();
    let is_part = |c: char| c.is_ascii_digit() || c == '.';
    let numbers = prose.split(|c| !is_part(c)).map(|number| number.trim_matches('.').to_owned());
    let mut numbers: Vec<_> = numbers.filter(|number| !number.is_empty()).collect();
    numbers.sort();
    numbers
}

#[test]
fn the_chinese_pages_have_the_figures_and_the_code_of_the_english_ones() {
    for page in ["safety.md", "first-robot.md", "troubleshooting.md"] {
        let (english, chinese) = (format!("docs/{page}"), format!("docs/zh/{page}"));
        assert!(figures(&english).len() > 3, "{page}");
        assert_eq!(figures(&chinese), figures(&english), "{page}");
        assert_eq!(blocks(&chinese), blocks(&english), "{page}");
        let count = |page: &str| read(&root().join(page)).lines().filter(|line| line.starts_with('|')).count();
        assert_eq!(count(&chinese), count(&english), "{page}");
    }
}

#[test]
fn the_readmes_link_to_each_other_and_to_what_a_reader_must_know() {
    for (page, other) in [("README.md", "README.zh.md"), ("README.zh.md", "README.md")] {
        let text = read(&root().join(page));
        let safety = if page == "README.md" { "docs/safety.md" } else { "docs/zh/safety.md" };
        for link in [other, safety, "jaka-cli/README.md", "spec/REFERENCE.md", "CONTRIBUTING.md"] {
            assert!(text.contains(&format!("]({link})")), "{page}: {link}");
        }
    }
}

/// The packages with examples, each with its folder and its argument of `cargo run`.
const PACKAGES: [(&str, &str); 3] = [("jaka-robot", ""), ("jaka-sim", "-p jaka-sim "), ("tests", "-p jaka-tests ")];

/// Names of the examples in a folder.
fn example_names(folder: &str) -> impl Iterator<Item = String> {
    let files = fs::read_dir(root().join(folder).join("examples")).expect("it is there");
    let paths = files.map(|entry| entry.expect("it can be read").path());
    let sources = paths.filter(|path| path.extension().is_some_and(|extension| extension == "rs"));
    sources.map(|path| path.file_stem().expect("it has a name").to_string_lossy().into_owned())
}

#[test]
fn the_table_of_examples_has_each_with_its_command() {
    let page = read(&root().join("jaka-robot/docs/overview.md"));
    let rows = rows(&page, "| example | subject | command |");
    let mut count = 0;
    for (folder, package) in PACKAGES {
        for name in example_names(folder) {
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

/// The crates with features: the folder and the page with the table.
const WITH_FEATURES: [(&str, &str); 6] = [
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
    let rows = rows(&text, "| feature | default | adds | dependencies |").into_iter().map(|line| {
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
    for (folder, page) in WITH_FEATURES {
        assert_eq!(of_page(folder, page), of_manifest(folder), "{folder}");
    }
    let crates = entries_of_root().filter(|path| path.join("src/lib.rs").exists() && path.join("Cargo.toml").exists());
    let names = crates.map(|path| path.file_name().expect("it has a name").to_string_lossy().into_owned());
    let with_features: Vec<_> = names.filter(|name| !entries(name, "features").is_empty()).collect();
    let listed: BTreeSet<_> = WITH_FEATURES.iter().map(|(folder, _)| *folder).collect();
    assert_eq!(with_features.iter().map(String::as_str).collect::<BTreeSet<_>>(), listed);
}

/// Phrases with numbers of commands: `{document}` for those of the vendor's document, `{beyond}` for the others.
const PHRASES: [(&str, &str); 5] = [
    (
        "README.md",
        "**All {document} commands** of the vendor's TCP protocol 2.0.4, sections 4.1 to 4.{document}, and \
         {beyond} that newer firmware has",
    ),
    (
        "README.zh.md",
        "**全部 {document} 条命令**（厂家 TCP 协议 2.0.4，4.1 至 4.{document} 节）以及较新固件的 {beyond} 条命令",
    ),
    ("jaka-sim/docs/overview.md", "All {document} commands of the document"),
    ("jaka-sync/docs/overview.md", "All {document} commands of the vendor's TCP protocol"),
    ("jaka-sync/Cargo.toml", "all {document} commands of the TCP protocol"),
];

/// Numbers of commands, by their names in phrases.
fn numbers() -> [(&'static str, usize); 2] {
    let spec = spec();
    let of_document = spec.commands().filter(|command| command.section.is_some()).count();
    [("document", of_document), ("beyond", spec.commands().count() - of_document)]
}

/// The text with these numbers in the place where the phrase stands with any; `None` if it does not stand.
fn with_numbers(text: &str, phrase: &str, numbers: &[(&str, usize)]) -> Option<String> {
    let begin = phrase.split('{').next().unwrap_or_default();
    text.match_indices(begin).find_map(|(at, _)| {
        let (mut rest, mut out) = (&text[at..], text[..at].to_owned());
        for (index, part) in phrase.split(['{', '}']).enumerate() {
            if index % 2 == 0 {
                rest = rest.strip_prefix(part)?;
                out += part;
                continue;
            }
            let after = rest.trim_start_matches(|c: char| c.is_ascii_digit());
            if after.len() == rest.len() {
                return None;
            }
            let (_, number) = numbers.iter().find(|(name, _)| *name == part)?;
            out += &number.to_string();
            rest = after;
        }
        Some(out + rest)
    })
}

#[test]
fn numbers_of_commands_are_those_of_the_spec() {
    for (page, phrase) in PHRASES {
        let path = root().join(page);
        let text = with_numbers(&read(&path), phrase, &numbers());
        let text =
            text.unwrap_or_else(|| panic!("{page} does not have the phrase `{phrase}`: it is listed in PHRASES"));
        expect_file![path].assert_eq(&text);
    }
}

/// A number that no phrase has would not be kept up to date.
#[test]
fn no_other_number_of_commands_stands_in_the_pages() {
    let files = entries_of_root().flat_map(|folder| ["Cargo.toml", "docs/overview.md"].map(|name| folder.join(name)));
    let pages = ["README.md", "README.zh.md", "spec/README.md", "jaka-cli/README.md", "jaka-proto-derive/README.md"];
    let mut files: Vec<_> = files.filter(|path| path.exists()).collect();
    files.extend(pages.map(|page| root().join(page)));
    let mut count = 0;
    for path in files {
        let own = PHRASES.iter().filter(|(page, _)| root().join(page) == path).map(|(_, phrase)| *phrase);
        let own: usize = own.map(counted).sum();
        assert_eq!(counted(&read(&path)), own, "{}: numbers of commands in phrases of PHRASES", path.display());
        count += own;
    }
    assert!(count >= PHRASES.len(), "{count}");
}

/// Number of places in a text that state a number of commands.
fn counted(text: &str) -> usize {
    let is_number = |before: &str| before.trim_end().ends_with(|c: char| c.is_ascii_digit() || c == '}');
    let words = [" commands", " 条命令"];
    words.iter().flat_map(|word| text.match_indices(word)).filter(|(at, _)| is_number(&text[..*at])).count()
}

#[test]
fn a_phrase_takes_numbers_where_it_stands() {
    let put = |text| with_numbers(text, "all {a} of 4.{a} and {b}", &[("a", 9), ("b", 12)]);
    assert_eq!(put("It: all 82 of 4.8 and 3.").as_deref(), Some("It: all 9 of 4.9 and 12."));
    assert_eq!(put("all of, all 1 of 4.2 and 3").as_deref(), Some("all of, all 9 of 4.9 and 12"));
    assert_eq!(put("all 82 of 4. and 3"), None);
}

/// The crates whose documentation has links of rustdoc, or lines that rustdoc hides.
const WITH_OVERVIEW: [&str; 7] =
    ["jaka-clock", "jaka-dynamic", "jaka-motion", "jaka-proto", "jaka-robot", "jaka-sim", "jaka-sync"];

/// The page without lines that rustdoc hides, and without links that it alone follows.
fn hosted(overview: &str) -> String {
    let shown = |(at, part): (usize, &str)| if at % 2 == 1 { without_hidden_lines(part) } else { without_links(part) };
    overview.split("```").enumerate().map(shown).collect::<Vec<_>>().join("```")
}

fn without_hidden_lines(code: &str) -> String {
    // In other languages `#` begins a comment.
    let info = code.lines().next().unwrap_or_default();
    if !["", "rust", "no_run", "ignore", "should_panic"].iter().any(|word| info.split(',').next() == Some(word)) {
        return code.to_owned();
    }
    let is_hidden = |line: &&str| *line == "#" || line.starts_with("# ");
    code.split('\n').filter(|line| !is_hidden(line)).collect::<Vec<_>>().join("\n")
}

/// Links to items become their text; those to other sites and within the page stay.
fn without_links(prose: &str) -> String {
    let mut parts = prose.split('[');
    let mut out = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let Some((text, after)) = part.split_once(']') else {
            out.extend(["[", part]);
            continue;
        };
        let target = after.strip_prefix('(').and_then(|rest| rest.split_once(')'));
        match target {
            Some((target, _)) if target.starts_with("https://") || target.starts_with('#') => out.extend(["[", part]),
            Some((_, after)) => out.extend([text, after]),
            None if text.starts_with('`') && text.ends_with('`') => out.extend([text, after]),
            None => out.extend(["[", part]),
        }
    }
    out
}

#[test]
fn the_readmes_of_crates_are_their_overviews() {
    for name in WITH_OVERVIEW {
        let folder = root().join(name);
        let library = read(&folder.join("src/lib.rs"));
        assert!(library.starts_with("#![doc = include_str!(\"../docs/overview.md\")]"), "{name}");
        expect_file![folder.join("README.md")].assert_eq(&hosted(&read(&folder.join("docs/overview.md"))));
    }
}

/// Pages that rustdoc shows as modules, and that a forge shows in `docs/`.
const PAGES: [(&str, &str); 2] = [("jaka-robot", "cookbook.md"), ("jaka-sync", "newer-firmware.md")];

/// The page of a forge: as a README, and each block of code has its language.
fn of_forge(page: &str) -> String {
    let shown = hosted(page);
    let parts = shown.split("```").enumerate().map(|(at, part)| {
        let (info, code) = part.split_once('\n').unwrap_or((part, ""));
        match info {
            _ if at % 2 == 0 => part.to_owned(),
            "" | "no_run" | "ignore" | "should_panic" => format!("rust\n{code}"),
            _ => part.to_owned(),
        }
    });
    parts.collect::<Vec<_>>().join("```")
}

#[test]
fn pages_of_rustdoc_are_shown_by_a_forge_too() {
    for (name, page) in PAGES {
        let source = read(&root().join(name).join("docs").join(page));
        expect_file![root().join("docs").join(page)].assert_eq(&of_forge(&source));
    }
}

#[test]
fn no_readme_has_what_only_rustdoc_understands() {
    let readmes: Vec<_> =
        entries_of_root().map(|folder| folder.join("README.md")).filter(|path| path.exists()).collect();
    assert!(readmes.len() >= 8, "{readmes:?}");
    for path in readmes {
        let text = read(&path);
        for (at, part) in text.split("```").enumerate() {
            let is_fine = if at % 2 == 1 {
                !part.starts_with("rust") || without_hidden_lines(part) == part
            } else {
                !part.contains("](crate::") && part.split("`]").skip(1).all(|after| after.starts_with('('))
            };
            assert!(is_fine, "{}: {part}", path.display());
        }
    }
}

#[test]
fn what_rustdoc_alone_understands_is_left_out() {
    let page = "A [`B`], [`c`](B::c), [d](#d), [\"e\"](crate::e), [f](https://f), g[0].\n```rust\nlet h = 1;\n# i()\n#\n```\n```toml\n# j\n```\n";
    let expected = "A `B`, `c`, [d](#d), \"e\", [f](https://f), g[0].\n```rust\nlet h = 1;\n```\n```toml\n# j\n```\n";
    assert_eq!(hosted(page), expected);
}

/// The published libraries.
const LIBRARIES: [&str; 9] = [
    "jaka-clock",
    "jaka-dynamic",
    "jaka-motion",
    "jaka-proto",
    "jaka-proto-derive",
    "jaka-robot",
    "jaka-sim",
    "jaka-sync",
    "spec",
];

#[test]
fn each_library_has_the_logo() {
    let logo = read(&root().join("docs/logo.svg")).trim_end().replace('"', "'").replace('#', "%23");
    assert!(logo.len() < 1024, "{}", logo.len());
    let attribute = format!("#![doc(\n    html_logo_url = \"data:image/svg+xml,{logo}\"\n)]\n");
    for library in LIBRARIES {
        assert!(read(&root().join(library).join("src/lib.rs")).contains(&attribute), "{library} needs {attribute}");
    }
}

#[test]
fn pages_show_the_examples_of_their_package() {
    for library in LIBRARIES {
        let folder = root().join(library);
        let manifest = read(&folder.join("Cargo.toml"));
        assert!(manifest.contains("[package.metadata.docs.rs]\nall-features = true\n"), "{library}");
        // Cargo takes both: the argument, and its consent to examples that need dev-dependencies.
        for setting in ["-Zrustdoc-scrape-examples", "doc-scrape-examples = true"] {
            assert_eq!(manifest.contains(setting), folder.join("examples").exists(), "{library}: {setting}");
        }
    }
}

/// Words with which the first sentence of a doc comment does not begin: it begins with a noun or a verb.
const OPENINGS: &[&str] =
    &["What", "How", "Whether", "Where", "Why", "When", "Who", "Which", "That", "Those", "The same"];

/// Doc comments that begin so all the same: texts of the command line's help, and strings of tests.
const LEFT: usize = 5;

/// Greatest width of a line with a comment or prose, in characters. Lines with an address and rows of tables may be
/// wider.
const WIDTH: usize = 120;

/// A doc comment: its first line, and the line of the item below it.
struct Doc<'t> {
    first: &'t str,
    item: &'t str,
}

fn docs(text: &str) -> Vec<Doc<'_>> {
    let lines: Vec<_> = text.lines().map(str::trim).collect();
    let doc = |line: &str| line.starts_with("///") || line.starts_with("//!");
    let begins = (0..lines.len()).filter(|&at| doc(lines[at]) && (at == 0 || !doc(lines[at - 1])));
    let found = begins.map(|at| {
        let item = lines[at..].iter().find(|line| !line.starts_with("//") && !line.starts_with("#["));
        Doc { first: lines[at][3..].trim(), item: item.unwrap_or(&"") }
    });
    found.collect()
}

/// True if the text begins with this word.
fn begins_with(text: &str, word: &str) -> bool {
    text.strip_prefix(word).is_some_and(|rest| !rest.starts_with(|c: char| c.is_alphanumeric()))
}

/// The docs in a file of the spec, without the quotation marks of those on one line.
fn spec_docs(toml: &str) -> impl Iterator<Item = &str> {
    let texts = toml.split("\ndoc = \"").skip(1);
    texts.map(|text| text.strip_prefix("\"\"").unwrap_or(text).trim_start())
}

/// True for an opening that is none of a noun or a verb. `Whether` is one of a truth value.
fn is_loose(doc: &Doc<'_>) -> bool {
    let opening = OPENINGS.iter().find(|opening| begins_with(doc.first, opening));
    opening.is_some_and(|opening| *opening != "Whether" || !doc.item.contains("bool"))
}

fn is_wide(line: &str) -> bool {
    let text = line.trim_start();
    let is_exempt = text.contains("http") || text.starts_with("/// |") || text.starts_with("//! |");
    text.starts_with("//") && line.chars().count() > WIDTH && !is_exempt
}

#[test]
fn docs_begin_with_a_noun_or_a_verb_and_comments_keep_to_their_width() {
    let (mut count, mut loose, mut wide) = (0, Vec::new(), Vec::new());
    for folder in entries_of_root() {
        if !folder.is_dir() || ["target", ".git"].iter().any(|name| folder.ends_with(name)) {
            continue;
        }
        for path in all_sources(&folder) {
            let name = below_root(&path);
            if name.contains("/golden/") || name.contains("/target/") {
                continue;
            }
            let text = read(&path);
            let docs = docs(&text);
            count += docs.len();
            loose.extend(docs.iter().filter(|doc| is_loose(doc)).map(|doc| format!("{name}: {}", doc.first)));
            wide.extend(text.lines().filter(|line| is_wide(line)).map(|line| format!("{name}: {line}")));
        }
    }
    for path in
        all_files(&root().join("spec"), "toml").iter().filter(|path| !path.to_string_lossy().contains("/tests/"))
    {
        let text = read(path);
        for doc in spec_docs(&text) {
            count += 1;
            // A field of the spec has its type next to its docs: `Whether` is checked by eye.
            if OPENINGS.iter().any(|opening| *opening != "Whether" && begins_with(doc, opening)) {
                loose.push(format!("{}: {doc}", path.display()));
            }
        }
    }
    assert!(count > 10_000, "{count} doc comments");
    assert_eq!(wide, [""; 0]);
    assert!(loose.len() == LEFT, "{} of {count} docs, of {LEFT}: {loose:#?}", loose.len());
}

#[test]
fn pages_keep_to_their_width() {
    let (mut count, mut wide) = (0, Vec::new());
    for path in all_files(root(), "md") {
        let name = below_root(&path);
        // Pages made of tables alone, and texts that a test compares with an output.
        if ["/target/", "/.git/", "/EVENTS.", "/REFERENCE.", "/table.md"].iter().any(|part| name.contains(part)) {
            continue;
        }
        count += 1;
        let text = read(&path);
        for line in text.split("```").step_by(2).flat_map(str::lines) {
            let is_exempt = line.trim_start().starts_with('|') || line.contains("http") || line.starts_with("    ");
            if line.chars().count() > WIDTH && !is_exempt {
                wide.push(format!("{name}: {line}"));
            }
        }
    }
    assert!(count > 50, "{count} pages");
    assert_eq!(wide, [""; 0]);
}
