//! The pages that a reader begins with: their links lead somewhere, and the Chinese README has the code of the English
//! one.

mod examples;
mod features;
mod hosted;
mod numbers;
mod rustdoc;

use std::fs;
use std::path::{Path, PathBuf};

use crate::reference::anchors;

/// The project's folder.
fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
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
    let folders = ["docs", "docs/zh"].map(|folder| fs::read_dir(root().join(folder)).expect("it is there"));
    let docs = folders.into_iter().flatten().map(|entry| entry.expect("it can be read").path());
    let docs = docs.filter(|path| path.extension().is_some_and(|extension| extension == "md"));
    let pages: Vec<PathBuf> = names.map(|name| root().join(name)).into_iter().chain(docs).collect();
    assert!(pages.len() > names.len());
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
        let rows = |page: &str| read(&root().join(page)).lines().filter(|line| line.starts_with('|')).count();
        assert_eq!(rows(&chinese), rows(&english), "{page}");
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
