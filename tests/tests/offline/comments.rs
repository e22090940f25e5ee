//! Counts of comments, which may only fall: first words of docs, and widths. Widths of pages.

use std::fs;
use std::path::Path;

use crate::architecture::{all_files, all_sources};

/// Words with which the first sentence of a doc comment does not begin: it begins with a noun or a verb.
const OPENINGS: &[&str] =
    &["What", "How", "Whether", "Where", "Why", "When", "Who", "Which", "That", "Those", "The same"];

/// Doc comments that begin so all the same: texts of the command line's help, and strings of tests.
const LEFT: usize = 6;

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
    let workspace = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."));
    for folder in fs::read_dir(workspace).expect("it is there").map(|entry| entry.expect("it can be read").path()) {
        if !folder.is_dir() || ["target", ".git"].iter().any(|name| folder.ends_with(name)) {
            continue;
        }
        for path in all_sources(&folder) {
            let name = path.display().to_string();
            if name.contains("/golden/") || name.contains("/target/") {
                continue;
            }
            let text = fs::read_to_string(&path).expect("a source is text");
            let docs = docs(&text);
            count += docs.len();
            loose.extend(docs.iter().filter(|doc| is_loose(doc)).map(|doc| format!("{name}: {}", doc.first)));
            wide.extend(text.lines().filter(|line| is_wide(line)).map(|line| format!("{name}: {line}")));
        }
    }
    for path in
        all_files(&workspace.join("spec"), "toml").iter().filter(|path| !path.to_string_lossy().contains("/tests/"))
    {
        let text = fs::read_to_string(path).expect("a spec is text");
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
    let workspace = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."));
    for path in all_files(workspace, "md") {
        let name = path.display().to_string();
        // Pages made of tables alone, and texts that a test compares with an output.
        if ["/target/", "/.git/", "/EVENTS.", "/REFERENCE.", "/table.md"].iter().any(|part| name.contains(part)) {
            continue;
        }
        count += 1;
        let text = fs::read_to_string(&path).expect("a page is text");
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
